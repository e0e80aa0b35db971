//! Which instructions this machine has, and how work is run with them.
//!
//! # Safety
//!
//! A function compiled for instructions is called only after [`Path::available`] has found them.
//! [`Path`] is the proof: a path that this machine lacks is lowered to one that it has before
//! anything runs, whoever asks for it.

use std::sync::OnceLock;

use super::{Portable, Task};

/// The variable of the environment by which a path is asked for: `portable`, `avx2` or `avx512`.
pub const PATH_VARIABLE: &str = "FLEXURE_PATH";

/// A set of instructions that lanes are computed with, from the least to the widest.
///
/// On one path, results are the same bit for bit, whatever the width of the lanes, and they are the
/// same on [`Path::Avx2`] and [`Path::Avx512`]. Those of [`Path::Portable`] are rounded
/// differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Path {
    /// Whatever the program was compiled for; four lanes.
    Portable,
    /// AVX2 with FMA; eight lanes in two registers.
    Avx2,
    /// AVX-512 (F and DQ), AVX2 and FMA; sixteen lanes in two registers.
    Avx512,
}

impl Path {
    /// Every path, from the least to the widest.
    pub const ALL: [Path; 3] = [Path::Portable, Path::Avx2, Path::Avx512];

    /// The widest path that this machine has instructions for.
    pub fn available() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            let avx512 =
                is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
            if avx2 && avx512 {
                return Path::Avx512;
            }
            if avx2 {
                return Path::Avx2;
            }
        }
        Path::Portable
    }

    /// The widest path of this machine or, if [`PATH_VARIABLE`] asks for a lesser one, that. The
    /// variable is read once; what it does not know it ignores.
    pub fn chosen() -> Self {
        static CHOSEN: OnceLock<Path> = OnceLock::new();
        *CHOSEN.get_or_init(|| Path::asked(std::env::var(PATH_VARIABLE).ok().as_deref()))
    }

    fn asked(name: Option<&str>) -> Self {
        let path = Path::ALL.into_iter().find(|path| Some(path.name()) == name);
        path.map_or_else(Path::available, Path::or_available)
    }

    /// This path, or the widest one of this machine if that is less.
    pub fn or_available(self) -> Self {
        self.min(Path::available())
    }

    /// Name of the path, as [`PATH_VARIABLE`] takes it.
    pub fn name(self) -> &'static str {
        match self {
            Path::Portable => "portable",
            Path::Avx2 => "avx2",
            Path::Avx512 => "avx512",
        }
    }

    /// Number of lanes that [`on_path`] runs a task with.
    pub fn lanes(self) -> usize {
        match self {
            Path::Portable => 4,
            Path::Avx2 => 8,
            Path::Avx512 => 16,
        }
    }
}

/// Runs a task on the widest lanes of [`Path::chosen`].
pub fn on_widest<K: Task>(task: K) -> K::Output {
    on_path(Path::chosen(), task)
}

/// Runs a task on the widest lanes of a path; of the widest path that this machine has, if it lacks
/// that one.
pub fn on_path<K: Task>(path: Path, task: K) -> K::Output {
    match path.or_available() {
        Path::Portable => task.run::<Portable<4>>(),
        // SAFETY: `or_available` gives a path whose instructions this machine has.
        #[cfg(target_arch = "x86_64")]
        Path::Avx2 => unsafe { x86::twice_four(task) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Path::Avx512 => unsafe { x86::twice_eight(task) },
        #[cfg(not(target_arch = "x86_64"))]
        Path::Avx2 | Path::Avx512 => task.run::<Portable<4>>(),
    }
}

/// Runs a task on lanes that fill one register of a path; its result is, bit for bit, that of each
/// lane in [`on_path`].
pub fn on_path_in_one_register<K: Task>(path: Path, task: K) -> K::Output {
    match path.or_available() {
        Path::Portable => task.run::<Portable<4>>(),
        // SAFETY: `or_available` gives a path whose instructions this machine has.
        #[cfg(target_arch = "x86_64")]
        Path::Avx2 => unsafe { x86::four(task) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Path::Avx512 => unsafe { x86::eight(task) },
        #[cfg(not(target_arch = "x86_64"))]
        Path::Avx2 | Path::Avx512 => task.run::<Portable<4>>(),
    }
}

/// Runs a task on one lane, with the instructions of a path; its result is, bit for bit, that of
/// each lane in [`on_path`].
pub fn on_path_alone<K: Task>(path: Path, task: K) -> K::Output {
    match path.or_available() {
        Path::Portable => task.run::<f64>(),
        // SAFETY: `or_available` gives a path whose instructions this machine has.
        #[cfg(target_arch = "x86_64")]
        Path::Avx2 | Path::Avx512 => unsafe { x86::one(task) },
        #[cfg(not(target_arch = "x86_64"))]
        Path::Avx2 | Path::Avx512 => task.run::<f64>(),
    }
}

/// Tasks compiled for instructions: what is inlined into these functions is compiled for them.
#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::super::{Task, avx2::F64x4, avx512::F64x8, pair::Pair, scalar::Fused};

    #[target_feature(enable = "avx2,fma")]
    pub(super) fn one<K: Task>(task: K) -> K::Output {
        task.run::<Fused>()
    }

    #[target_feature(enable = "avx2,fma")]
    pub(super) fn four<K: Task>(task: K) -> K::Output {
        task.run::<F64x4>()
    }

    #[target_feature(enable = "avx2,fma")]
    pub(super) fn twice_four<K: Task>(task: K) -> K::Output {
        task.run::<Pair<F64x4>>()
    }

    #[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
    pub(super) fn eight<K: Task>(task: K) -> K::Output {
        task.run::<F64x8>()
    }

    #[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
    pub(super) fn twice_eight<K: Task>(task: K) -> K::Output {
        task.run::<Pair<F64x8>>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::Lanes;

    struct Width;

    impl Task for Width {
        type Output = usize;

        fn run<T: Lanes>(self) -> usize {
            T::COUNT
        }
    }

    #[test]
    fn no_path_is_beyond_the_machine() {
        let available = Path::available();
        for path in Path::ALL {
            assert_eq!(path.or_available(), path.min(available));
            assert_eq!(Path::asked(Some(path.name())), path.min(available));
            assert_eq!(on_path(path, Width), path.or_available().lanes());
            assert_eq!(
                on_path(path, Width) % on_path_in_one_register(path, Width),
                0
            );
            assert_eq!(on_path_alone(path, Width), 1);
        }
        assert_eq!(Path::asked(None), available);
        assert_eq!(Path::asked(Some("sse9")), available);
        assert_eq!(on_widest(Width), Path::chosen().lanes());
    }
}
