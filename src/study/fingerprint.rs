//! Fingerprints: whether two models, builds or sets of points are the same.

use std::fmt::{self, Debug, Write};
use std::fs::File;
use std::io::{self, Read};

use xxhash_rust::xxh3::Xxh3;

struct Hasher(Xxh3);

impl Write for Hasher {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text.as_bytes());
        Ok(())
    }
}

impl Hasher {
    fn finish(&self) -> String {
        format!("{:032x}", self.0.digest128())
    }
}

/// A fingerprint of all that a value holds, as [`Debug`] shows it.
pub fn fingerprint(value: &impl Debug) -> String {
    let mut hasher = Hasher(Xxh3::new());
    // Hashing does not fail, and no `Debug` of this project does.
    let _ = write!(hasher, "{value:?}");
    hasher.finish()
}

/// Version and fingerprint of the program that runs: of every byte of its file.
///
/// # Errors
///
/// If that file cannot be read.
pub fn build() -> io::Result<String> {
    let mut file = File::open(std::env::current_exe()?)?;
    let mut hasher = Hasher(Xxh3::new());
    let mut bytes = vec![0; 1 << 20];
    loop {
        match file.read(&mut bytes)? {
            0 => break,
            count => hasher.0.update(&bytes[..count]),
        }
    }
    Ok(format!(
        "flexure {} {}",
        env!("CARGO_PKG_VERSION"),
        hasher.finish()
    ))
}
