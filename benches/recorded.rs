//! What the operating system keeps count of: memory, on Linux.

/// Memory of this process when counting began, in bytes.
pub struct Peak(u64);

/// Begins to count how much memory this process takes at most; `None` where that is not known.
pub fn peak_memory() -> Option<Peak> {
    std::fs::write("/proc/self/clear_refs", "5").ok()?;
    Some(Peak(status("VmRSS:")?))
}

impl Peak {
    /// How much more it took at most since then, in bytes.
    pub fn grown(self) -> Option<u64> {
        Some(status("VmHWM:")?.saturating_sub(self.0))
    }
}

fn status(name: &str) -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kilobytes: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kilobytes * 1024)
}
