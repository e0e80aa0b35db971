//! Lanes: several trajectories in one number.
//!
//! Right-hand sides are generic over [`Real`]; a type of [`Lanes`] is a number whose entries belong
//! to as many trajectories, so that one evaluation serves all of them. Entries never mix: what a
//! lane computes depends on nothing in the others, bit for bit.

mod portable;
mod system;

pub use portable::Portable;
pub use system::LaneSystem;

use crate::real::Real;

/// A number with an entry for each of several trajectories.
pub trait Lanes: Real {
    /// Number of entries.
    const COUNT: usize;

    /// The number whose entry `index` is `entry(index)`.
    fn from_entries(entry: impl FnMut(usize) -> f64) -> Self;

    /// Entry `index`, below [`Lanes::COUNT`].
    fn entry(self, index: usize) -> f64;

    /// Puts `value` into entry `index`, below [`Lanes::COUNT`].
    fn set_entry(&mut self, index: usize, value: f64);
}

impl Lanes for f64 {
    const COUNT: usize = 1;

    #[inline(always)]
    fn from_entries(mut entry: impl FnMut(usize) -> f64) -> Self {
        entry(0)
    }

    #[inline(always)]
    fn entry(self, _: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn set_entry(&mut self, _: usize, value: f64) {
        *self = value;
    }
}

/// Work that is written once for every type of lanes.
pub trait Task {
    /// What comes of it.
    type Output;

    /// Does the work on lanes of type `T`. To be marked `#[inline(always)]`, with all that it calls
    /// often, so that it is compiled for the instructions of the path that runs it.
    fn run<T: Lanes>(self) -> Self::Output;
}

/// Runs a task on the widest lanes that this machine has instructions for.
pub fn on_widest<K: Task>(task: K) -> K::Output {
    task.run::<Portable<4>>()
}
