//! Where a trajectory stands and how it goes on, whoever takes its next step: the walk or a lane.

use super::dead_point::Approach;
use super::pace::Pace;
use super::run::Statistics;

pub(super) struct Stand {
    /// Time.
    pub t: f64,
    /// State, with the energies accounted for.
    pub x: Vec<f64>,
    /// Discrete state.
    pub d: Vec<f64>,
    /// Rates of `x`.
    pub f: Vec<f64>,
    /// How steps are chosen.
    pub pace: Pace,
    /// The way to a dead point.
    pub approach: Approach,
    /// The end.
    pub until: f64,
    /// Steps tried, and how many may be.
    pub tried: u64,
    pub most_steps: u64,
    pub statistics: Statistics,
}
