//! Frequency response of an actuator: its mean speed against the frequency of its drive.
//!
//! ```text
//! frequencies, a design for each ──▶ ensemble, sampled at the starts of cycles
//!                                      ├──▶ mean speed over stated cycles
//!                                      └──▶ whether and how the motion settles ──▶ mean speed then
//! points ──▶ linear regime ──▶ sensitivity
//!        └──▶ error against an experiment
//! ```
//!
//! ```
//! use flexure::response::{Cycles, DEFINITIONS, Quantity, Speed, linear_regime, response};
//!
//! let model = flexure::Model::from_source("oscillator.flex", r#"
//! model oscillator
//! param f = 10 Hz
//! drive push = sine(1 mm, frequency = f)
//! slide mass along (1, 0) { mass = 1 kg }
//! spring k1 between ground and mass { stiffness = 4 kN/m, damping = 20 N*s/m, expansion = push }
//! "#)?;
//! let at = |frequency: f64| {
//!     let mut design = model.design();
//!     design.set("f", frequency)?;
//!     design.prepare()
//! };
//! let system = at(10.0)?;
//! let speed = Speed::of(Quantity::named("mass.v", &system)?, &system);
//! let frequencies = [5.0, 10.0, 15.0];
//! let outcomes = response(&frequencies, speed, |index| at(frequencies[index]))
//!     .over(Cycles { warmup: 20, measured: 5 })
//!     .run();
//! let curve: Vec<(f64, f64)> = frequencies.iter().zip(&outcomes)
//!     .map(|(&f, outcome)| (f, outcome.as_ref().map_or(f64::NAN, |point| point.speed)))
//!     .collect();
//! // It shakes on the spot: no speed, and no linear regime of five points.
//! assert!(curve.iter().all(|point| point.1.abs() < 1e-6));
//! assert_eq!(linear_regime(&curve, &DEFINITIONS[3]), None);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// `!(a > b)` is meant where it stands: what is not a number is then on the safe side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod experiment;
mod linear;
mod sensitivity;
mod settle;
mod settling;
mod speed;

use std::ops::Range;

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::lanes::LaneSystem;
use flexure_runtime::simulate::{
    Ending, Ensemble, Sample, Trajectory, TrajectoryFailure, ensemble,
};

pub use experiment::{Deviation, Experiment};
pub use linear::{DEFINITIONS, Definition, LinearRegime, linear_regime};
pub use sensitivity::{Effect, Step, Variation, sensitivity, share};
pub use settle::{LONGEST_PERIOD, Repetition, Settle, Strobes};
pub use speed::{Quantity, SAMPLES, Speed};

/// Cycles of the drive over which a mean speed is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cycles {
    /// Cycles before them.
    pub warmup: u32,
    /// Their number.
    pub measured: u32,
}

impl Default for Cycles {
    /// Cycles 10 to 30, as in the article.
    fn default() -> Self {
        Self {
            warmup: 10,
            measured: 20,
        }
    }
}

/// Which cycles count.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Span {
    Stated(Cycles),
    UntilSettled(Settle),
}

/// A point of a response.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Drive frequency in Hz.
    pub frequency: f64,
    /// Mean speed over `cycles`, in the speed's unit.
    pub speed: f64,
    /// The cycles over which it is the mean, counted from 0.
    pub cycles: Range<u32>,
    /// What the motion is like.
    pub motion: Motion,
}

/// What a motion is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Not asked: the cycles are stated.
    Measured,
    /// The state repeats at the start of every cycle.
    Periodic,
    /// It repeats after so many cycles.
    PeriodN(u32),
    /// It has not settled yet, but nearby starts lead to the same motion.
    Transient,
    /// It does not settle, and nearby starts drift apart. The mean speed of single cycles scatters
    /// with this standard deviation.
    Chaotic {
        /// Standard deviation, in the speed's unit.
        spread: f64,
    },
}

/// Starts to describe a response: the mean `speed` at each of `frequencies`, in Hz, of the system
/// that `prepare` makes for that position among them. All systems must be of one model.
///
/// Results do not depend on the number of threads.
pub fn response<'a, S, P>(frequencies: &'a [f64], speed: Speed, prepare: P) -> Response<'a, P>
where
    S: LaneSystem,
    P: Fn(usize) -> Result<S, Diagnostic>,
{
    Response {
        frequencies,
        speed,
        prepare,
        span: Span::Stated(Cycles::default()),
        rtol: 1e-8,
        threads: 0,
        inputs: Vec::new(),
        progress: None,
    }
}

/// A response to be computed.
pub struct Response<'a, P> {
    frequencies: &'a [f64],
    speed: Speed,
    prepare: P,
    span: Span,
    rtol: f64,
    threads: usize,
    inputs: Vec<(usize, f64)>,
    progress: Option<Box<dyn FnMut(f64) + 'a>>,
}

/// What comes of a point: the point, or why there is none.
pub type Outcome = Result<Point, Diagnostic>;

impl<'a, P> Response<'a, P> {
    /// Takes the mean over these cycles; over cycles 10 to 30 unless given.
    pub fn over(mut self, cycles: Cycles) -> Self {
        self.span = Span::Stated(cycles);
        self
    }

    /// Follows each motion until it settles, and takes the mean over the cycles from there on; over
    /// the last half of its cycles if it does not settle.
    pub fn until_settled(mut self, settle: Settle) -> Self {
        self.span = Span::UntilSettled(settle);
        self
    }

    /// Relative tolerance of the steps, as
    /// [`Ensemble::rtol`](flexure_runtime::simulate::Ensemble::rtol); 1e-8 unless given.
    pub fn rtol(mut self, tolerance: f64) -> Self {
        self.rtol = tolerance;
        self
    }

    /// Works on this many threads; on as many as the machine has cores if 0, or if never called.
    pub fn threads(mut self, count: usize) -> Self {
        self.threads = count;
        self
    }

    /// Holds an input, by its position, at this value.
    pub fn input(mut self, index: usize, value: f64) -> Self {
        self.inputs.push((index, value));
        self
    }

    /// Reports which share of the points is done.
    pub fn progress(mut self, report: impl FnMut(f64) + 'a) -> Self {
        self.progress = Some(Box::new(report));
        self
    }

    /// Computes all points, in the order of the frequencies.
    pub fn run<S>(mut self) -> Vec<Outcome>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        match self.span {
            Span::Stated(cycles) => self.measure(cycles),
            Span::UntilSettled(settle) => self.settle(settle),
        }
    }

    fn measure<S>(&mut self, cycles: Cycles) -> Vec<Outcome>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        let span = cycles.warmup..cycles.warmup.saturating_add(cycles.measured.max(1));
        let starts = match self.speed {
            Speed::RateOf(_) => vec![span.start.into(), span.end.into()],
            Speed::Sampled(_) => subdivided(span.clone(), SAMPLES),
        };
        let all: Vec<Run> = (0..self.frequencies.len()).map(Run::from_start).collect();
        let speed = self.speed;
        let frequencies = self.frequencies;
        self.follow(&all, &starts, |run, samples| {
            let speed = mean_speed(speed, samples?);
            Ok(Point {
                frequency: frequencies[run],
                speed,
                cycles: span.clone(),
                motion: Motion::Measured,
            })
        })
    }

    /// Follows runs to the last of `times`, in cycles, and hands each its samples there.
    fn follow<S, T>(
        &mut self,
        runs: &[Run],
        times: &[f64],
        mut each: impl FnMut(usize, Result<&[Sample], Diagnostic>) -> T,
    ) -> Vec<T>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        let frequency = |run: usize| self.frequencies[runs[run].point];
        let last = times.last().copied().unwrap_or(0.0);
        let prepare = &self.prepare;
        let systems = runs.iter().map(|run| {
            positive(self.frequencies[run.point])?;
            prepare(run.point)
        });
        let mut runs_to_do: Ensemble<'_, _> = ensemble(systems)
            .rtol(self.rtol)
            .threads(self.threads)
            .offsets_each(|run| vec![runs[run].offset])
            .until_each(|run| last / frequency(run))
            .samples_each(|run| times.iter().map(|cycle| cycle / frequency(run)).collect());
        for &(index, value) in &self.inputs {
            runs_to_do = runs_to_do.input(index, value);
        }
        let mut results = Vec::with_capacity(runs.len());
        let mut progress = self.progress.take();
        runs_to_do.run(|run, outcome| {
            let samples = complete(&outcome, times.len());
            results.push(each(run, samples));
            if let Some(report) = &mut progress {
                report((run + 1) as f64 / runs.len() as f64);
            }
        });
        self.progress = progress;
        results
    }
}

/// A trajectory to be followed.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// Its position among the points.
    point: usize,
    /// By how much its first state is off at the start.
    offset: f64,
}

impl Run {
    fn from_start(point: usize) -> Self {
        Self { point, offset: 0.0 }
    }
}

fn positive(frequency: f64) -> Result<(), Diagnostic> {
    if frequency > 0.0 && frequency.is_finite() {
        return Ok(());
    }
    Err(
        Diagnostic::error(format!("there are no cycles at {frequency} Hz"))
            .hint("give a drive frequency above zero"),
    )
}

/// All samples of a trajectory that came to its end.
fn complete(
    outcome: &Result<Trajectory, TrajectoryFailure>,
    count: usize,
) -> Result<&[Sample], Diagnostic> {
    let trajectory = outcome.as_ref().map_err(TrajectoryFailure::diagnostic)?;
    if let Ending::Stopped(why) = &trajectory.summary.ending {
        let end = trajectory.summary.end;
        return Err(Diagnostic::error(format!(
            "the run ended at t = {end} s: {why}"
        )));
    }
    if trajectory.samples.len() < count {
        return Err(Diagnostic::error("the run ended before its last cycle"));
    }
    Ok(&trajectory.samples)
}

/// Times in cycles, so many a cycle, both ends included.
fn subdivided(cycles: Range<u32>, parts: u32) -> Vec<f64> {
    let whole = u64::from(parts);
    let all = u64::from(cycles.start) * whole..=u64::from(cycles.end) * whole;
    all.map(|k| k as f64 / f64::from(parts)).collect()
}

/// The mean speed between the first and the last of samples.
fn mean_speed(speed: Speed, samples: &[Sample]) -> f64 {
    let [Some(from), Some(to)] = [samples.first(), samples.last()] else {
        return f64::NAN;
    };
    let span = to.time - from.time;
    match speed {
        Speed::RateOf(quantity) => (quantity.of(to) - quantity.of(from)) / span,
        Speed::Sampled(quantity) => {
            let pairs = samples.windows(2);
            let sum: f64 = pairs
                .map(|p| 0.5 * (quantity.of(&p[0]) + quantity.of(&p[1])) * (p[1].time - p[0].time))
                .sum();
            sum / span
        }
    }
}
