//! Lanes: several trajectories in one number.
//!
//! Right-hand sides are generic over [`Real`]; a type of [`Lanes`] is a number whose entries belong
//! to as many trajectories, so that one evaluation serves all of them. Entries never mix: what a
//! lane computes depends on nothing in the others, bit for bit.
//!
//! # Paths
//!
//! A [`Task`] is written once and compiled for every [`Path`]: plain numbers, AVX2 with FMA,
//! AVX-512. Which one runs is decided when the program runs, by what the machine has
//! ([`on_widest`]), so that one program runs on any. `FLEXURE_PATH=portable` (or `avx2`, `avx512`)
//! in the environment asks for a lesser one.
//!
//! # Errors
//!
//! No function here is the platform's: all are made of operations that IEEE 754 defines to the last
//! bit, so that a result is the same on every machine, given the path. In units in the last place:
//!
//! | function | error at most |
//! |---|---|
//! | `sqrt`, `abs`, `floor`, `sign`, products, sums, quotients | 0.5 |
//! | `exp`, `sin`, `cos`, `ln`, `power` | 1 |
//! | `atan2`, `atan`, `tan`, `tanh` | 2 |
//! | `asin`, `acos` | 3 |
//!
//! Angles may be as large as numbers go. Zeros, infinities and what is not a number are treated as
//! C's functions of these names do. Where the result of `exp` is smaller than a normal number it is
//! zero: friction passes there all the time, and processors compute with subnormal numbers a hundred
//! times as long.
//!
//! # Safety
//!
//! This module holds the only `unsafe` code of the crate: calls of vector instructions in types
//! that are private to it, and calls of the functions compiled for them, after the machine has been
//! found to have them. The heads of those files say why each is sound.

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)]
mod avx2;
#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)]
mod avx512;
#[allow(unsafe_code)]
mod dispatch;
pub(crate) mod kernels;
#[cfg(target_arch = "x86_64")]
mod pair;
mod portable;
mod scalar;
mod system;

pub use dispatch::{
    PATH_VARIABLE, Path, on_path, on_path_alone, on_path_in_one_register, on_widest,
};
pub use portable::Portable;
pub use system::{LaneSystem, Row};

use crate::real::Real;

/// A number with an entry for each of several trajectories.
pub trait Lanes: Real + 'static {
    /// Number of entries.
    const COUNT: usize;

    /// The number whose entry `index` is `entry(index)`.
    fn from_entries(entry: impl FnMut(usize) -> f64) -> Self;

    /// Entry `index`, below [`Lanes::COUNT`].
    fn entry(self, index: usize) -> f64;

    /// Puts `value` into entry `index`, below [`Lanes::COUNT`].
    fn set_entry(&mut self, index: usize, value: f64);
}

/// Work that is written once for every type of lanes.
pub trait Task {
    /// What comes of it.
    type Output;

    /// Does the work on lanes of type `T`. To be marked `#[inline(always)]`, with all that it calls
    /// often, so that it is compiled for the instructions of the path that runs it.
    fn run<T: Lanes>(self) -> Self::Output;
}

/// The functions of [`Real`] that are the same for every [`kernels::Vector`].
macro_rules! real_by_kernels {
    (@one $($name:ident $kernel:path,)*) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                $kernel(self)
            }
        )*
    };
    () => {
        $crate::lanes::real_by_kernels! {
            @one
            tan $crate::lanes::kernels::trigonometry::tan,
            asin $crate::lanes::kernels::atan::asin,
            acos $crate::lanes::kernels::atan::acos,
            atan $crate::lanes::kernels::atan::atan,
            tanh $crate::lanes::kernels::tanh::tanh,
            exp $crate::lanes::kernels::exp::exp,
            ln $crate::lanes::kernels::log::ln,
            sign $crate::lanes::kernels::sign,
            floor $crate::lanes::kernels::floor,
        }
        #[inline(always)]
        fn recip(self) -> Self {
            Self::from_f64(1.0) / self
        }
        #[inline(always)]
        fn sin(self) -> Self {
            $crate::lanes::kernels::trigonometry::sin_cos(self).0
        }
        #[inline(always)]
        fn cos(self) -> Self {
            $crate::lanes::kernels::trigonometry::sin_cos(self).1
        }
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            $crate::lanes::kernels::trigonometry::sin_cos(self)
        }
        #[inline(always)]
        fn atan2(self, x: Self) -> Self {
            $crate::lanes::kernels::atan::atan2(self, x)
        }
        #[inline(always)]
        fn power(self, exponent: Self) -> Self {
            $crate::lanes::kernels::power::power(self, exponent)
        }
        #[inline(always)]
        fn unwrap_to(self, reference: Self) -> Self {
            $crate::lanes::kernels::unwrap_to(self, reference)
        }
        #[inline(always)]
        fn if_positive(self, yes: Self, no: Self) -> Self {
            use $crate::lanes::kernels::Vector;
            Self::choose(Self::from_f64(0.0).less(self), yes, no)
        }
    };
}
pub(crate) use real_by_kernels;
