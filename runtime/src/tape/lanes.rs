//! Tapes on lanes: one pass of the interpreter serves several parameter sets.

use std::sync::Arc;

use super::code::{Arguments, Tape};
use super::configuration::Configurations;
use super::{TapePrepared, TapeProgram};
use crate::lanes::{LaneSystem, Lanes};

/// The fixed registers of several parameter sets of one model, side by side.
#[derive(Clone, Debug)]
pub struct TapeLanes<L> {
    program: Arc<TapeProgram>,
    configurations: Configurations<L>,
    rhs: Vec<L>,
    events: Vec<L>,
    accept: Vec<L>,
    closures: Vec<L>,
}

fn in_every_lane<L: Lanes>(image: &[f64]) -> Vec<L> {
    image.iter().map(|value| L::from_f64(*value)).collect()
}

fn put<L: Lanes>(lane: usize, image: &[f64], lanes: &mut [L]) {
    for (number, value) in lanes.iter_mut().zip(image) {
        number.set_entry(lane, *value);
    }
}

impl<L: Lanes> TapeLanes<L> {
    #[inline(always)]
    fn evaluate(&self, tape: &Tape, image: &[L], arguments: Arguments<'_, L>, out: &mut [L]) {
        tape.evaluate(image, arguments, &self.program.tables, out);
    }
}

impl LaneSystem for TapePrepared {
    type InLanes<L: Lanes> = TapeLanes<L>;
    type States<L: Lanes> = Vec<L>;
    type Discretes<L: Lanes> = Vec<L>;
    type Loops<L: Lanes> = Vec<L>;
    type Events<L: Lanes> = Vec<L>;

    fn in_every_lane<L: Lanes>(&self) -> TapeLanes<L> {
        TapeLanes {
            program: Arc::clone(&self.program),
            configurations: self.configurations.in_every_lane(),
            rhs: in_every_lane(&self.rhs),
            events: in_every_lane(&self.events),
            accept: in_every_lane(&self.accept),
            closures: in_every_lane(&self.closures),
        }
    }

    fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut TapeLanes<L>) {
        self.configurations
            .put_in_lane(lane, &mut lanes.configurations);
        put(lane, &self.rhs, &mut lanes.rhs);
        put(lane, &self.events, &mut lanes.events);
        put(lane, &self.accept, &mut lanes.accept);
        put(lane, &self.closures, &mut lanes.closures);
    }

    #[inline(always)]
    fn rhs_in_lanes<L: Lanes>(lanes: &TapeLanes<L>, t: L, x: &[L], d: &[L], u: &[L], dx: &mut [L]) {
        let arguments = Arguments::new(t, x, d, u);
        lanes
            .configurations
            .with_values(&lanes.program, arguments, |tabulated| {
                let arguments = Arguments {
                    tabulated,
                    ..arguments
                };
                lanes.evaluate(&lanes.program.rhs, &lanes.rhs, arguments, dx);
            });
    }

    #[inline(always)]
    fn accept_in_lanes<L: Lanes>(lanes: &TapeLanes<L>, t: L, x: &[L], u: &[L], d: &mut [L]) {
        let tape = &lanes.program.accept;
        if tape.results.is_empty() {
            return;
        }
        let before = d.to_vec();
        let arguments = Arguments::new(t, x, &before, u);
        lanes.evaluate(tape, &lanes.accept, arguments, d);
    }

    #[inline(always)]
    fn events_in_lanes<L: Lanes>(
        lanes: &TapeLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    ) {
        let arguments = Arguments::new(t, x, d, u);
        lanes.evaluate(&lanes.program.events, &lanes.events, arguments, values);
    }

    #[inline(always)]
    fn closures_in_lanes<L: Lanes>(
        lanes: &TapeLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    ) {
        let arguments = Arguments::new(t, x, d, u);
        lanes.evaluate(&lanes.program.closures, &lanes.closures, arguments, values);
    }

    #[inline(always)]
    fn outside_tables_in_lanes<L: Lanes>(lanes: &TapeLanes<L>, x: &[L]) -> L {
        lanes.configurations.outside_in_lanes(&lanes.program, x)
    }
}
