//! What a worker asks of steps that lanes take together.

use super::block::Block;
use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::breakdown::Breakdown;
use crate::simulate::method::Method;
use crate::simulate::pace::Pace;
use crate::simulate::settings::Settings;
use crate::simulate::walk::Walk;
use crate::system::Variable;

/// Where a lane is after some rounds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Between two breaks.
    UnderWay,
    /// At its break.
    Arrived,
    /// Before a step that is not a plain one: a walk has to take it alone.
    Special,
}

/// Plain steps of several trajectories, which a walk of the same method would take alike.
pub(super) trait Steps<L: Lanes> {
    /// The method of the walks.
    type Method: Method;

    /// Idle lanes of so many states.
    fn new(states: usize) -> Self;

    /// Method and pace of a walk with steps of this length or this relative tolerance.
    ///
    /// # Errors
    /// What makes no sense about the settings.
    fn of_a_walk(
        accuracy: f64,
        states: &[Variable],
        settings: &Settings,
    ) -> Result<(Self::Method, Pace), Breakdown>;

    /// Whether the next step of a quiet walk may be a plain one.
    fn can_take<S: LaneSystem>(&self, walk: &mut Walk<'_, S, Self::Method>) -> bool;

    /// Takes over how the walk chooses its steps.
    fn load<S: LaneSystem>(&mut self, lane: usize, walk: &mut Walk<'_, S, Self::Method>);

    /// Gives the walk back what the lane has come to; the lane is idle then.
    fn store<S: LaneSystem>(
        &mut self,
        lane: usize,
        walk: &mut Walk<'_, S, Self::Method>,
        block: &mut Block<S, L>,
    );

    /// Goes on in all lanes until one of them is not under way any more, or for so many rounds.
    fn advance<S: LaneSystem>(&mut self, block: &mut Block<S, L>, rounds: u64);

    /// Where a lane that was under way is now.
    fn verdict(&self, lane: usize) -> Verdict;
}
