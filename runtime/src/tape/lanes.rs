//! Tapes on lanes: one pass of the interpreter serves several parameter sets.

use std::cell::RefCell;
use std::sync::Arc;

use super::code::{Arguments, Tape};
use super::configuration::{Configurations, FEW};
use super::{TapePrepared, TapeProgram};
use crate::lanes::{LaneSystem, Lanes};

/// The fixed registers of several parameter sets of one model, side by side.
#[derive(Clone, Debug)]
pub struct TapeLanes<L> {
    program: Arc<TapeProgram>,
    configurations: Configurations<L>,
    rhs: Registers<L>,
    events: Registers<L>,
    accept: Registers<L>,
    closures: Registers<L>,
}

/// All registers of a tape. The fixed ones keep their values, so that an evaluation copies nothing.
type Registers<L> = RefCell<Vec<L>>;

fn in_every_lane<L: Lanes>(image: &[f64]) -> Registers<L> {
    RefCell::new(image.iter().map(|value| L::from_f64(*value)).collect())
}

/// Puts the first `count` values, the fixed ones, into one lane.
fn put<L: Lanes>(lane: usize, image: &[f64], count: usize, lanes: &Registers<L>) {
    let mut lanes = lanes.borrow_mut();
    for (number, value) in lanes.iter_mut().zip(image).take(count) {
        number.set_entry(lane, *value);
    }
}

impl<L: Lanes> TapeLanes<L> {
    #[inline(always)]
    fn evaluate(
        &self,
        tape: &Tape,
        registers: &Registers<L>,
        arguments: Arguments<'_, L>,
        out: &mut [L],
    ) {
        let mut registers = registers.borrow_mut();
        tape.evaluate_in(&mut registers, arguments, &self.program.tables, out);
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
        let program = &self.program;
        self.configurations
            .put_in_lane(lane, &mut lanes.configurations);
        put(lane, &self.rhs, program.rhs.fixed.len(), &lanes.rhs);
        put(
            lane,
            &self.events,
            program.events.fixed.len(),
            &lanes.events,
        );
        put(
            lane,
            &self.accept,
            program.accept.fixed.len(),
            &lanes.accept,
        );
        put(
            lane,
            &self.closures,
            program.closures.fixed.len(),
            &lanes.closures,
        );
    }

    #[inline(always)]
    fn rhs_in_lanes<L: Lanes>(lanes: &TapeLanes<L>, t: L, x: &[L], d: &[L], u: &[L], dx: &mut [L]) {
        let arguments = Arguments::new(t, x, d, u);
        let (mut few, mut many) = ([L::from_f64(0.0); FEW], Vec::new());
        let values = &lanes.configurations;
        let tabulated = values.values(&lanes.program, arguments, &mut few, &mut many);
        let arguments = Arguments {
            tabulated,
            ..arguments
        };
        lanes.evaluate(&lanes.program.rhs, &lanes.rhs, arguments, dx);
    }

    #[inline(always)]
    fn accept_in_lanes<L: Lanes>(lanes: &TapeLanes<L>, t: L, x: &[L], u: &[L], d: &mut [L]) {
        let tape = &lanes.program.accept;
        if tape.results.is_empty() {
            return;
        }
        let arguments = Arguments::new(t, x, d, u);
        let mut registers = lanes.accept.borrow_mut();
        tape.update(&mut registers, arguments, &lanes.program.tables);
        tape.collect(&registers, d);
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
