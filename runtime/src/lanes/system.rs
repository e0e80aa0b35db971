//! A [`System`] whose smooth functions run on lanes, each lane with a parameter set of its own.

use super::Lanes;
use crate::system::System;

/// A model whose parameter sets can be laid side by side.
///
/// What happens at every step runs on lanes of `L` numbers: entry `i` of every number belongs to
/// lane `i`. What is rare (the start, kinks, events, messages) goes through [`System`], lane by
/// lane. Slices are as long as [`System`] says; entry `i` of what a function of lanes gives is what
/// the function of [`System`] gives for lane `i` alone, to the rounding of `L`'s own functions.
pub trait LaneSystem: System {
    /// What depends on params alone, for as many parameter sets as there are lanes.
    type InLanes<L: Lanes>;

    /// This parameter set in every lane.
    fn in_every_lane<L: Lanes>(&self) -> Self::InLanes<L>;

    /// This parameter set for one trajectory alone, in every lane: also with what costs more in lanes
    /// than it saves there. Results are not those of [`LaneSystem::in_every_lane`] to the last bit.
    fn alone<L: Lanes>(&self) -> Self::InLanes<L> {
        self.in_every_lane()
    }

    /// Puts this parameter set into one lane, below [`Lanes::COUNT`]; the others stay. All must be
    /// of the same model.
    fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Self::InLanes<L>);

    /// [`System::rhs`] on lanes.
    fn rhs_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        dx: &mut [L],
    );

    /// [`System::accept`] on lanes.
    fn accept_in_lanes<L: Lanes>(lanes: &Self::InLanes<L>, t: L, x: &[L], u: &[L], d: &mut [L]);

    /// [`System::events`] on lanes.
    fn events_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    );

    /// [`System::closures`] on lanes.
    fn closures_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    );
}
