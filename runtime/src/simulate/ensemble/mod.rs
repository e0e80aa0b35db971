//! Many trajectories: lanes side by side on every thread, refilled as trajectories end.
//!
//! ```text
//! parameter sets ──▶ queue ──▶ worker (one a thread) ──▶ outcomes in order ──▶ the caller
//!                              block of lanes: plain steps, together
//!                              walks: whatever is special, one by one
//! ```
//!
//! A trajectory's numbers depend on its parameter set, the settings and the instructions that the
//! lanes use, and on nothing else: not on threads, not on its lane, not on its neighbours.

mod outcome;
mod worker;

use std::marker::PhantomData;
use std::sync::Mutex;

use crate::diagnostic::Diagnostic;
use crate::lanes::{self, LaneSystem, Lanes, Task};
use crate::simulate::settings::{Accuracy, Settings};
pub use outcome::{Trajectory, TrajectoryFailure};
use worker::{Job, Outcome, Queue, Worker};

/// Trajectories for each thread that are in memory at once.
const AT_ONCE: usize = 256;

/// Stack of a thread in bytes. Without optimisation every number of a right-hand side in lanes, with
/// all that is inlined, has a place of its own there: more than threads have by default.
const STACK: usize = 64 << 20;

/// Starts to describe the runs of many `systems`, from their start states at t = 0;
/// [`Ensemble::run`] does them. A parameter set that was refused has its place among the results.
///
/// Each run is the one that [`simulate`](super::simulate()) gives: kinks of drives and samples at
/// the end of a step, events located, the same choice of steps. The two agree to rounding: a run
/// alone may have curves that lanes do not.
///
/// All systems must be of one model: lanes lay their parameter sets side by side.
///
/// ```
/// use flexure_runtime::lanes::LaneSystem;
/// use flexure_runtime::{diagnostic::Diagnostic, ensemble};
///
/// /// Final first states, in order, of designs of any model; `None` for those that fail.
/// fn ends<S: LaneSystem>(designs: Vec<Result<S, Diagnostic>>) -> Vec<Option<f64>> {
///     let mut ends = Vec::new();
///     ensemble(designs).until(0.02).rtol(1e-7).threads(2).run(|_, outcome| {
///         ends.push(outcome.ok().map(|done| done.summary.state[0]));
///     });
///     ends
/// }
/// ```
pub fn ensemble<'a, S, I>(systems: I) -> Ensemble<'a, I::IntoIter>
where
    S: LaneSystem,
    I: IntoIterator<Item = Result<S, Diagnostic>>,
{
    Ensemble {
        systems: systems.into_iter(),
        settings: Settings::default(),
        until: Box::new(|_| 0.0),
        samples: Box::new(|_| Vec::new()),
        offsets: Box::new(|_| Vec::new()),
        threads: 0,
    }
}

/// Runs to be done. Systems are asked for as they are needed, some hundreds ahead.
pub struct Ensemble<'a, I> {
    systems: I,
    settings: Settings,
    until: Box<dyn Fn(usize) -> f64 + 'a>,
    samples: Box<dyn Fn(usize) -> Vec<f64> + 'a>,
    offsets: Box<dyn Fn(usize) -> Vec<f64> + 'a>,
    threads: usize,
}

impl<'a, S, I> Ensemble<'a, I>
where
    S: LaneSystem,
    I: Iterator<Item = Result<S, Diagnostic>>,
{
    /// Ends all runs at this time, in s.
    pub fn until(self, time: f64) -> Self {
        self.until_each(move |_| time)
    }

    /// Ends run `index`, counted from 0, at `time(index)`, in s.
    pub fn until_each(mut self, time: impl Fn(usize) -> f64 + 'a) -> Self {
        self.until = Box::new(time);
        self
    }

    /// Adaptive steps, as [`Simulation::rtol`](super::Simulation::rtol); the default, with 1e-8.
    /// Each lane has a step size of its own.
    pub fn rtol(mut self, tolerance: f64) -> Self {
        self.settings.accuracy = Accuracy::Relative(tolerance);
        self
    }

    /// The scale of one state, as [`Simulation::atol`](super::Simulation::atol).
    pub fn atol(mut self, state: &str, tolerance: f64) -> Self {
        self.settings.absolute.push((state.to_owned(), tolerance));
        self
    }

    /// Fixed steps no longer than this, in s, by the classical Runge–Kutta method of order 4, as
    /// [`Simulation::dt`](super::Simulation::dt).
    pub fn dt(mut self, step: f64) -> Self {
        self.settings.accuracy = Accuracy::Step(step);
        self
    }

    /// Adaptive steps no longer than this, in s.
    pub fn max_step(mut self, step: f64) -> Self {
        self.settings.longest_step = step;
        self
    }

    /// Gives a trajectory up after this many steps, rejected ones included; 100 million unless
    /// given.
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.settings.most_steps = steps;
        self
    }

    /// Holds an input, by its position in [`System::inputs`](crate::system::System::inputs), at
    /// this value in all runs.
    pub fn input(mut self, index: usize, value: f64) -> Self {
        self.settings.inputs.push((index, value));
        self
    }

    /// Takes samples of all runs at these times, in s, rising. A step ends exactly at each.
    pub fn samples(self, times: &[f64]) -> Self {
        let times = times.to_vec();
        self.samples_each(move |_| times.clone())
    }

    /// Takes samples of run `index`, counted from 0, at `times(index)`, in s, rising.
    pub fn samples_each(mut self, times: impl Fn(usize) -> Vec<f64> + 'a) -> Self {
        self.samples = Box::new(times);
        self
    }

    /// Starts run `index`, counted from 0, a little off: `offsets(index)` are added to the first of
    /// its states. So runs tell whether small differences grow.
    pub fn offsets_each(mut self, offsets: impl Fn(usize) -> Vec<f64> + 'a) -> Self {
        self.offsets = Box::new(offsets);
        self
    }

    /// Works on this many threads; on as many as the machine has cores if 0, or if never called.
    /// Results do not depend on it.
    pub fn threads(mut self, count: usize) -> Self {
        self.threads = count;
        self
    }

    /// Runs all, on the widest lanes that the machine has, and hands each outcome to `each`
    /// with its position, in order. Outcomes are handed over as they come: memory does not grow with
    /// their number.
    ///
    /// What a trajectory fails of ends that trajectory alone.
    pub fn run(self, each: impl FnMut(usize, Result<Trajectory, TrajectoryFailure>))
    where
        S: Sync,
    {
        self.run_by(&Widest, each);
    }

    /// [`Self::run`] on lanes of type `L` without special instructions: to compare with.
    pub fn run_on<L: Lanes>(self, each: impl FnMut(usize, Result<Trajectory, TrajectoryFailure>)) {
        self.run_by(&On::<L>(PhantomData), each);
    }

    /// [`Self::run`], all outcomes in order.
    pub fn collect(self) -> Vec<Result<Trajectory, TrajectoryFailure>> {
        let mut all = Vec::new();
        self.run(|_, outcome| all.push(outcome));
        all
    }

    fn run_by(mut self, path: &impl Path, mut each: impl FnMut(usize, Outcome)) {
        let threads = match self.threads {
            0 => std::thread::available_parallelism().map_or(1, usize::from),
            count => count,
        };
        // Where the system refuses threads, the caller's own does all the work.
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .stack_size(STACK)
            .build()
            .ok();
        let workers = if pool.is_some() { threads } else { 1 };
        let mut first = 0;
        let mut jobs = self.jobs(0, workers);
        while !jobs.is_empty() {
            let queue = Queue::new(&jobs);
            let worker = Worker {
                queue: &queue,
                settings: &self.settings.clone(),
                most_lanes: jobs.len().div_ceil(workers),
            };
            let next = first + jobs.len();
            let (outcomes, later) = match &pool {
                None => (path.send(worker), self.jobs(next, workers)),
                Some(pool) => {
                    let outcomes = Mutex::new(Vec::new());
                    let later = pool.in_place_scope(|scope| {
                        for _ in 0..workers {
                            scope.spawn(|_| {
                                let some = path.send(worker);
                                if let Ok(mut all) = outcomes.lock() {
                                    all.extend(some);
                                }
                            });
                        }
                        // The next ones are prepared meanwhile.
                        self.jobs(next, workers)
                    });
                    (outcomes.into_inner().unwrap_or_default(), later)
                }
            };
            let mut in_order = outcomes;
            in_order.sort_unstable_by_key(|(index, _)| *index);
            for (index, outcome) in in_order {
                each(first + index, outcome);
            }
            (first, jobs) = (next, later);
        }
    }

    /// The next jobs, of which the first is run `first`.
    fn jobs(&mut self, first: usize, workers: usize) -> Vec<Job<S>> {
        let systems = self.systems.by_ref().take(AT_ONCE * workers);
        systems
            .enumerate()
            .map(|(index, system)| Job {
                system,
                until: (self.until)(first + index),
                samples: (self.samples)(first + index),
                offsets: (self.offsets)(first + index),
            })
            .collect()
    }
}

/// Who runs workers.
trait Path: Sync {
    fn send<K: Task>(&self, task: K) -> K::Output;
}

struct Widest;

impl Path for Widest {
    fn send<K: Task>(&self, task: K) -> K::Output {
        lanes::on_widest(task)
    }
}

struct On<L>(PhantomData<fn() -> L>);

impl<L: Lanes> Path for On<L> {
    fn send<K: Task>(&self, task: K) -> K::Output {
        task.run::<L>()
    }
}
