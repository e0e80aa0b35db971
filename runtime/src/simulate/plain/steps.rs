//! What is asked of steps that lanes take together.

use super::block::Block;
use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::automatic::Watch;
use crate::simulate::stand::Stand;

/// Where a lane is after some rounds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::simulate) enum Verdict {
    /// Between two breaks.
    UnderWay,
    /// At its break.
    Arrived,
    /// Before a step that is not a plain one: a walk has to take it alone.
    Special,
}

/// What a lane goes on to.
pub(in crate::simulate) struct Way<'w> {
    /// The next break.
    pub to: f64,
    /// No step reaches this time, at which something is recorded.
    pub row: f64,
    /// Explicit steps may be given up for stiff ones.
    pub watch: Option<&'w mut Watch<f64>>,
}

impl Way<'_> {
    /// To a break, with nothing to be recorded or watched.
    pub fn to(to: f64) -> Self {
        Self {
            to,
            row: f64::INFINITY,
            watch: None,
        }
    }
}

/// Plain steps of several trajectories, which a walk with the same method would take alike.
pub(in crate::simulate) trait Steps<S: LaneSystem, L: Lanes> {
    /// Idle lanes of so many states.
    fn new(states: usize) -> Self;

    /// Whether the next step on the way to the break `to` may be a plain one.
    fn can_take(stand: &mut Stand, to: f64) -> bool;

    /// Takes over how steps are chosen.
    fn load(&mut self, lane: usize, stand: &mut Stand, way: &Way<'_>);

    /// Puts down what the lane has come to on its way; the lane is idle then.
    fn store(&mut self, lane: usize, stand: &mut Stand, way: Way<'_>, block: &mut Block<S, L>);

    /// Goes on in all lanes until one of them is not under way any more, or for so many rounds.
    fn advance(&mut self, block: &mut Block<S, L>, rounds: u64);

    /// Where a lane that was under way is now.
    fn verdict(&self, lane: usize) -> Verdict;
}
