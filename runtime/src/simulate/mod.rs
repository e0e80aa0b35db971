//! Simulating a [`System`]: from its start state to an end time, by steps that never straddle a
//! kink of a drive or an event.
//!
//! ```text
//! simulate(&system) ──settings──▶ walk ──steps of a method──▶ rows ──▶ a Run, or a Recorder
//!                                  ▲ │
//!                  plain steps, on lanes
//! ```
//!
//! The walk carries a run from break to break: the end, the next kink of a drive, an event
//! that a step ran into. Between breaks the right-hand side is smooth and one of two methods steps
//! over it:
//!
//! - [`Simulation::rtol`] (the default, 1e-8): Dormand and Prince's 8(5,3) with step control, and
//!   Rodas5P where stability would limit the explicit steps and stiff ones get on faster
//!   ([`Simulation::integrator`]). Each step's error is held below `rtol` times the largest
//!   excursion of each state from its start so far; see [`Simulation::rtol`] for why not times the
//!   state's own size.
//! - [`Simulation::dt`]: the classical Runge–Kutta method of order 4. The time between two breaks
//!   is divided into the fewest equal steps that are no longer than `dt`, so that a step ends
//!   exactly at each break and none is a short remainder.
//!
//! Most steps ask for nothing but the right-hand side and a look at what they came to. A system that
//! runs on lanes takes these by code that is compiled for the instructions at hand, alone as in an
//! [`ensemble`]; all others (the start, kinks, events, dead points, failures, steps with a row inside)
//! are the walk's own.
//!
//! Results depend on nothing but the system and these settings, to rounding; on lanes the walk's own
//! steps are rounded differently from plain ones, and rows decide which are its own.
//!
//! # Why these methods
//!
//! Measured on the article's actuator at 1 kHz and 20 N, to 0.1 s: thousands of evaluations of the
//! right-hand side, and the relative error of `stage.x` at the end, against a run at 1e-13 that one
//! at 1e-12 meets to 1e-11. Each entry is a tolerance, from 1e-5 to 1e-8.
//!
//! | steps | 1e-5 | 1e-6 | 1e-7 | 1e-8 |
//! |---|---|---|---|---|
//! | Dormand–Prince 8(5,3) | 194, 1.9e-5 | 259, 1.4e-6 | 348, 7.9e-7 | 463, 3.9e-8 |
//! | Verner 7(6) | 181, 1.9e-5 | 248, 6.1e-7 | 329, 3.4e-7 | 444, 3.1e-8 |
//! | Verner 6(5) | 190, 4.5e-5 | 263, 4.4e-6 | 364, 3.9e-7 | 516, 7.8e-8 |
//! | Tsitouras 5(4) | 156, 1.2e-4 | 237, 2.1e-5 | 357, 2.0e-6 | 535, 1.1e-7 |
//! | Dormand–Prince, rejected steps across v = 0 cut there | 192, 4.9e-5 | 243, 1.4e-5 | 330, 2.2e-7 | 418, 5.6e-8 |
//! | Dormand–Prince, all steps across v = 0 end there | 208, 3.0e-5 | 248, 1.3e-5 | 330, 9.0e-7 | 419, 5.1e-8 |
//! | Verner 7(6), rejected steps across v = 0 cut there | 179, 3.3e-5 | 251, 1.3e-7 | 324, 3.2e-7 | 424, 7.8e-9 |
//!
//! At equal accuracy Dormand–Prince, the two of Verner's and their variants differ by less than the
//! error at the end does by chance, and the peak of the friction about v = 0, of whose 36 passages a
//! cycle each takes some four steps, costs as much with a stop at v = 0 as without: the steps are
//! short for the peak, not for the kink. So the kink of friction is left to step control, and a pair
//! is taken whose dense output costs three evaluations rather than six. Other exponents of the
//! controller (memory 0 to 0.05), safety 0.8 and a slower growth change nothing beyond that chance
//! either. Gauss' methods of 6 to 16 stages, iterated all stages at once, need 90 000 to 110 000
//! rounds for 1e-6: they would gain only where all stages of a round together cost less than 2.5
//! single evaluations.
//!
//! A low preload is stiff: a bristle that slides decays in a fraction of a microsecond. At 0.2 N,
//! to 0.05 s at 1e-6, explicit steps take 1 665 000 evaluations for an error of 6e-7, automatic ones
//! 374 000 for 2e-5, and half of the time with their Jacobians and linear systems; at 1e-8 explicit
//! ones 1 746 000 for 2e-9, automatic ones 582 000 for 2e-7. Steps that stability limits are more
//! accurate than asked for. At 1 N and above nearly all steps of the automatic choice are explicit.

// `!(a > b)` is meant where it stands: what is not a number is then on the safe side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod accounting;
mod automatic;
mod breakdown;
mod coefficients;
mod crossing;
mod dead_point;
mod dormand_prince;
mod ensemble;
mod method;
mod pace;
mod plain;
mod recorder;
mod rosenbrock;
mod rows;
mod run;
mod runge_kutta;
mod settings;
mod stand;
mod stops;
mod tolerance;
mod walk;

pub use breakdown::{Breakdown, BreakdownKind, RunFailure};
pub use ensemble::{Ensemble, Trajectory, TrajectoryFailure, ensemble};
pub use plain::PlainSteps;
pub use recorder::{Heading, Recorder};
pub use run::{Column, Ending, EventRecord, Run, Statistics, Summary};
pub use settings::Integrator;
pub use stops::Sample;

use crate::system::System;
use accounting::Flow;
use automatic::Automatic;
use dormand_prince::DormandPrince;
use method::Method;
use pace::Pace;
use rosenbrock::Rosenbrock;
use rows::Recording;
use run::Table;
use runge_kutta::RungeKutta;
use settings::{Accuracy, Settings};
use walk::Walk;

/// Starts to describe a run of `system` from its start state at t = 0; [`Simulation::run`] does it.
pub fn simulate<S: System + ?Sized>(system: &S) -> Simulation<'_, S> {
    Simulation {
        system,
        settings: Settings::default(),
    }
}

/// A run to be done.
#[derive(Debug)]
pub struct Simulation<'s, S: System + ?Sized> {
    system: &'s S,
    settings: Settings,
}

impl<S: System + ?Sized> Clone for Simulation<'_, S> {
    fn clone(&self) -> Self {
        Self {
            system: self.system,
            settings: self.settings.clone(),
        }
    }
}

impl<S: System + ?Sized> Simulation<'_, S> {
    /// Ends the run at this time, in s.
    pub fn until(mut self, time: f64) -> Self {
        self.settings.until = time;
        self
    }

    /// Adaptive steps, each with an estimated error below `tolerance`, between 1e-13 and 0.1,
    /// times the scale of each state.
    ///
    /// The scale of a state is its largest excursion from its start so far, the step itself
    /// included; for angles it is never more than 1 rad. A flexure's crank stands at 1.4 rad and
    /// moves by a thousandth of that: a tolerance relative to its angle would leave nothing of its
    /// motion. Below an excursion of a millionth of the state itself, of 1 nrad, 1 pm, 1 µrad/s or
    /// 1 µm/s (1e-12 in other units), the state counts as at rest and its scale is that.
    pub fn rtol(mut self, tolerance: f64) -> Self {
        self.settings.accuracy = Accuracy::Relative(tolerance);
        self
    }

    /// Replaces the scale of one state, by name: its error per step is then held below
    /// `tolerance` (in the state's unit) plus the relative tolerance times its size.
    pub fn atol(mut self, state: &str, tolerance: f64) -> Self {
        self.settings.absolute.push((state.to_owned(), tolerance));
        self
    }

    /// Which method takes adaptive steps; [`Integrator::Automatic`] unless given.
    pub fn integrator(mut self, integrator: Integrator) -> Self {
        self.settings.integrator = integrator;
        self
    }

    /// Fixed steps no longer than this, in s, by the classical Runge–Kutta method of order 4.
    pub fn dt(mut self, step: f64) -> Self {
        self.settings.accuracy = Accuracy::Step(step);
        self
    }

    /// Adaptive steps no longer than this, in s: for excitations so short that a long step would
    /// not notice them.
    pub fn max_step(mut self, step: f64) -> Self {
        self.settings.longest_step = step;
        self
    }

    /// Gives up after this many steps, rejected ones included; 100 million unless given.
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.settings.most_steps = steps;
        self
    }

    /// Records rows at the multiples of `interval`, in s, and at the end, by the method's dense
    /// output; without it a row at the end of every step, and two at an event.
    pub fn every(mut self, interval: f64) -> Self {
        self.settings.every = Some(interval);
        self
    }

    /// Adds columns `energy.kinetic`, `energy.potential`, `energy.dissipated` and
    /// `energy.supplied` (the latter two since the start) and `energy.balance`, which is
    /// kinetic + potential − what they were at the start − supplied + dissipated: zero but for the
    /// error of the steps. All in J. A name that the model's outputs already have is not repeated.
    ///
    /// Powers are integrated by the same steps as the motion, which they do not influence. Where a
    /// drive jumps, the jump of the stored energy counts as supplied; what an event changes counts
    /// as supplied if energy rises and as dissipated if it falls.
    pub fn energy(mut self, wanted: bool) -> Self {
        self.settings.energy = wanted;
        self
    }

    /// Holds an input, by its position in [`System::inputs`], at this value instead of its start
    /// value.
    pub fn input(mut self, index: usize, value: f64) -> Self {
        self.settings.inputs.push((index, value));
        self
    }

    /// Runs and keeps all rows.
    ///
    /// # Errors
    ///
    /// If a setting makes no sense, or if the motion cannot be followed to the end; the failure
    /// keeps what was recorded until then.
    pub fn run(self) -> Result<Run, RunFailure> {
        let mut table = Table::default();
        let (summary, breakdown) = self.go(&mut table);
        let breakdown =
            breakdown.or_else(|| table.is_full().then(|| Breakdown::too_many_rows(&summary)));
        let run = Run::new(table, summary);
        match breakdown {
            None => Ok(run),
            Some(breakdown) => Err(RunFailure::new(breakdown, run)),
        }
    }

    /// Runs for so many steps at most, rejected ones included, and says how they were taken.
    pub fn probe(mut self, steps: u64) -> Summary {
        self.settings.most_steps = steps;
        self.settings.every = Some(self.settings.until);
        self.go(&mut Table::default()).0
    }

    /// Runs and hands rows and progress to `recorder`, keeping nothing.
    ///
    /// # Errors
    ///
    /// As [`Self::run`]; the recorder has the rows until then.
    pub fn run_with(self, recorder: &mut dyn Recorder) -> Result<Summary, Breakdown> {
        match self.go(recorder) {
            (summary, None) => Ok(summary),
            (_, Some(breakdown)) => Err(breakdown),
        }
    }

    fn go(&self, recorder: &mut dyn Recorder) -> (Summary, Option<Breakdown>) {
        let settings = &self.settings;
        let inputs = match settings.inputs(self.system.inputs()) {
            Ok(inputs) => inputs,
            Err(breakdown) => return (Summary::default(), Some(breakdown)),
        };
        let flow = Flow::new(self.system, inputs, settings.energy);
        let width = flow.width();
        match settings.accuracy {
            Accuracy::Step(dt) => {
                self.walk(flow, RungeKutta::new(width), Pace::fixed(dt), recorder)
            }
            Accuracy::Relative(rtol) => {
                let control = match settings.control(rtol, self.system.states()) {
                    Ok(control) => control,
                    Err(breakdown) => return (Summary::default(), Some(breakdown)),
                };
                let pace = Pace::Adaptive(control);
                match settings.integrator {
                    Integrator::Automatic => self.walk(flow, Automatic::new(width), pace, recorder),
                    Integrator::Explicit => {
                        self.walk(flow, DormandPrince::new(width), pace, recorder)
                    }
                    Integrator::Stiff => self.walk(flow, Rosenbrock::new(width), pace, recorder),
                }
            }
        }
    }

    fn walk<M: Method>(
        &self,
        flow: Flow<'_, S>,
        method: M,
        pace: Pace,
        recorder: &mut dyn Recorder,
    ) -> (Summary, Option<Breakdown>) {
        let settings = &self.settings;
        let recording = Recording {
            recorder: Some(recorder),
            every: settings.every,
        };
        Walk::new(
            flow,
            method,
            pace,
            settings.until,
            recording,
            settings.most_steps,
        )
        .run()
    }
}
