//! A sweep: every design point simulated, each run reduced to its measures.

use std::fmt;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::simulate::{Ending, Trajectory, TrajectoryFailure, ensemble};

use super::window::Span;
use super::{Measure, Points, Window};
use crate::Design;

/// Design points, and what is wanted of each.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Base values of the params.
    pub design: Design,
    /// Inputs held at a value in all runs: position and value in SI.
    pub inputs: Vec<(usize, f64)>,
    /// The design points.
    pub points: Points,
    /// What is measured.
    pub measures: Vec<Measure>,
    /// When.
    pub window: Window,
    /// Samples of a cycle, or of the whole window if it is none of cycles, for measures that need
    /// more than its ends. A step ends at each, so that they change a run to its rounding.
    pub samples: usize,
    /// How runs are integrated.
    pub accuracy: Accuracy,
}

/// How runs are integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// Adaptive steps of this relative tolerance.
    Relative(f64),
    /// Fixed steps no longer than this, in s.
    Step(f64),
}

/// What came of a design point.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its position among the points.
    pub index: usize,
    /// Its columns, in SI.
    pub point: Vec<f64>,
    /// Its measures, in SI; empty unless the run came to its end.
    pub measures: Vec<f64>,
    /// How it went.
    pub status: Status,
    /// Why it went no better; empty where all is well.
    pub message: String,
}

/// How a design point went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The run came to its end.
    Done,
    /// An event ended the run early.
    Stopped,
    /// The motion could not be followed to the end.
    Failed,
    /// The design cannot be assembled, or a setting makes no sense for it.
    Refused,
}

impl Status {
    /// All of them.
    pub const ALL: [Status; 4] = [
        Status::Done,
        Status::Stopped,
        Status::Failed,
        Status::Refused,
    ];
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Status::Done => "ok",
            Status::Stopped => "stopped",
            Status::Failed => "failed",
            Status::Refused => "refused",
        })
    }
}

/// Blocks become longer while they take less than this, and shorter while they take twice as long.
const BLOCK_TIME: Duration = Duration::from_millis(500);
/// Points of a thread in the first block: what fills the widest lanes.
const FIRST_BLOCK: usize = 8;
/// Samples that a block holds at most: some 100 MB of them.
const MOST_SAMPLES: usize = 500_000;

/// A point that is about to run.
struct Job {
    index: usize,
    point: Vec<f64>,
    design: Design,
    span: Result<Span, Diagnostic>,
}

impl Job {
    fn until(&self) -> f64 {
        self.span.as_ref().map_or(0.0, |span| span.until)
    }
}

impl Sweep {
    /// One point with the values of `design`, no measures, and no time to run: to be filled in.
    pub fn new(design: Design) -> Self {
        Self {
            inputs: Vec::new(),
            points: Points::new(design.model()),
            measures: Vec::new(),
            window: Window::span(0.0, 0.0),
            samples: 200,
            accuracy: Accuracy::Relative(1e-8),
            design,
        }
    }

    /// What makes no sense about it, whatever the point.
    ///
    /// # Errors
    ///
    /// If measures within a cycle are wanted of a window without cycles, or samples are missing.
    pub fn check(&self) -> Result<(), Diagnostic> {
        let odd = self.measures.iter().find(|measure| measure.needs_cycles());
        if let Some(measure) = odd
            && !self.window.has_cycles()
        {
            return Err(Diagnostic::error(format!(
                "`{}` is a measure of cycles, and the window is a span of time",
                measure.name()
            ))
            .hint("give a number of cycles, `--cycles 20`, instead of the end of the run"));
        }
        if self.samples == 0 || self.samples > MOST_SAMPLES {
            return Err(Diagnostic::error(format!(
                "{} samples are none that measures can be taken from",
                self.samples
            ))
            .hint(format!("give a number from 1 to {MOST_SAMPLES}")));
        }
        Ok(())
    }

    /// Length of the run of a point, in s; 0 if it will not run.
    pub fn duration(&self, index: usize) -> f64 {
        self.job(index).until()
    }

    /// Runs the points from `first` on, on this many threads (as many as the machine has cores if
    /// 0), and hands rows over in blocks, in order, until `take` breaks off. Memory does not grow
    /// with the number of points. How rows fall into blocks depends on how fast the machine is; what
    /// stands in them does not.
    pub fn run(
        &self,
        first: usize,
        threads: usize,
        mut take: impl FnMut(&[Row]) -> ControlFlow<()>,
    ) {
        let threads = match threads {
            0 => std::thread::available_parallelism().map_or(1, usize::from),
            count => count,
        };
        let least = FIRST_BLOCK * threads;
        let cycles = match self.window.of_design(&self.design) {
            Ok(span) => span.cycles,
            Err(_) => 0,
        };
        let most = (MOST_SAMPLES / self.sample_count(cycles).max(1)).max(least);
        let (mut next, mut size) = (first, least);
        while next < self.points.len() {
            let end = self.points.len().min(next + size);
            let begun = Instant::now();
            let rows = self.block(next, end, threads);
            let took = begun.elapsed();
            if take(&rows).is_break() {
                return;
            }
            next = end;
            if took < BLOCK_TIME {
                size = (2 * size).min(most);
            } else if took > 2 * BLOCK_TIME {
                size = (size / 2).max(least);
            }
        }
    }

    fn job(&self, index: usize) -> Job {
        let mut design = self.design.clone();
        let point = self.points.set(index, &mut design);
        Job {
            index,
            point,
            span: self.window.of_design(&design),
            design,
        }
    }

    /// Samples between the ends of a window of so many cycles, one end included.
    fn sample_count(&self, cycles: usize) -> usize {
        if self.measures.iter().any(Measure::needs_samples) {
            self.samples.saturating_mul(cycles.max(1))
        } else {
            1
        }
    }

    fn block(&self, from: usize, to: usize, threads: usize) -> Vec<Row> {
        let mut jobs: Vec<Job> = (from..to).map(|index| self.job(index)).collect();
        // The longest first, so that lanes are full until the end.
        jobs.sort_by(|a, b| b.until().total_cmp(&a.until()).then(a.index.cmp(&b.index)));
        let systems = jobs.iter().map(|job| match &job.span {
            Ok(_) => job.design.prepare(),
            Err(error) => Err(error.clone()),
        });
        let mut runs = ensemble(systems)
            .until_each(|k| jobs[k].until())
            .samples_each(|k| match &jobs[k].span {
                Ok(span) => span.times(self.sample_count(span.cycles)),
                Err(_) => Vec::new(),
            })
            .threads(threads);
        runs = match self.accuracy {
            Accuracy::Relative(tolerance) => runs.rtol(tolerance),
            Accuracy::Step(step) => runs.dt(step),
        };
        for &(index, value) in &self.inputs {
            runs = runs.input(index, value);
        }
        let mut rows = Vec::with_capacity(jobs.len());
        runs.run(|k, outcome| rows.push(self.row(&jobs[k], outcome)));
        rows.sort_by_key(|row| row.index);
        rows
    }

    fn row(&self, job: &Job, outcome: Result<Trajectory, TrajectoryFailure>) -> Row {
        let (status, message) = match &outcome {
            Ok(done) => match &done.summary.ending {
                Ending::Stopped(why) => {
                    let end = done.summary.end;
                    (Status::Stopped, format!("ended at t = {end} s: {why}"))
                }
                Ending::Complete | Ending::Interrupted | Ending::Failed => {
                    (Status::Done, String::new())
                }
            },
            Err(TrajectoryFailure::Preparation(error)) => (Status::Refused, error.message.clone()),
            Err(TrajectoryFailure::Run { breakdown, .. }) => {
                (Status::Failed, breakdown.message.clone())
            }
        };
        let measures = match (&outcome, &job.span, status) {
            (Ok(done), Ok(span), Status::Done) => self
                .measures
                .iter()
                .map(|measure| measure.of(&done.samples, span.cycles))
                .collect(),
            _ => Vec::new(),
        };
        Row {
            index: job.index,
            point: job.point.clone(),
            measures,
            status,
            message,
        }
    }
}
