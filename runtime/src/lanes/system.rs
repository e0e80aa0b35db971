//! A [`System`] whose smooth functions run on lanes, each lane with a parameter set of its own.

use super::Lanes;
use crate::system::System;

/// Numbers in a row, as many as a model has of a kind: an array where the compiler knows how many,
/// so that they may stay in registers.
pub trait Row<L>: Clone + AsRef<[L]> + AsMut<[L]> {
    /// `count` times the same number; an array has its own count.
    fn filled(number: L, count: usize) -> Self;
}

impl<L: Copy, const N: usize> Row<L> for [L; N] {
    #[inline(always)]
    fn filled(number: L, _: usize) -> Self {
        [number; N]
    }
}

impl<L: Copy> Row<L> for Vec<L> {
    fn filled(number: L, count: usize) -> Self {
        vec![number; count]
    }
}

/// A model whose parameter sets can be laid side by side.
///
/// What happens at every step runs on lanes of `L` numbers: entry `i` of every number belongs to
/// lane `i`. What is rare (the start, kinks, events, messages) goes through [`System`], lane by
/// lane. Slices are as long as [`System`] says; entry `i` of what a function of lanes gives is what
/// the function of [`System`] gives for lane `i` alone, to the rounding of `L`'s own functions.
pub trait LaneSystem: System {
    /// What depends on params alone, for as many parameter sets as there are lanes.
    type InLanes<L: Lanes>: 'static;
    /// A continuous state.
    type States<L: Lanes>: Row<L>;
    /// A discrete state.
    type Discretes<L: Lanes>: Row<L>;
    /// A number for each loop.
    type Loops<L: Lanes>: Row<L>;
    /// A number for each event.
    type Events<L: Lanes>: Row<L>;

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

    /// Positive in lanes where [`System::is_outside_tables`].
    fn outside_tables_in_lanes<L: Lanes>(_lanes: &Self::InLanes<L>, _x: &[L]) -> L {
        L::from_f64(-1.0)
    }
}
