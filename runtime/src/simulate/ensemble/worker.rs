//! A worker: takes trajectories from the queue into its lanes and follows them to their ends.
//!
//! Lanes go on together as long as their steps are plain ones. What is not plain (the start, kinks,
//! samples, events, dead points, whatever fails) is done by the trajectory's own [`Walk`], exactly
//! as [`simulate`](crate::simulate::simulate()) does it. Which of both does a step depends on that
//! trajectory alone, so that its numbers do not depend on what runs beside it.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::outcome::{Trajectory, TrajectoryFailure};
use crate::diagnostic::Diagnostic;
use crate::lanes::{LaneSystem, Lanes, Task};
use crate::simulate::accounting::Flow;
use crate::simulate::breakdown::Breakdown;
use crate::simulate::dormand_prince::DormandPrince;
use crate::simulate::method::Method;
use crate::simulate::pace::Pace;
use crate::simulate::plain::{Block, Lockstep, OwnSteps, Steps, Verdict, Way};
use crate::simulate::rows::Recording;
use crate::simulate::runge_kutta::RungeKutta;
use crate::simulate::settings::{Accuracy, Settings};
use crate::simulate::walk::{Halt, Walk};
use crate::system::Variable;

/// Rounds in a row that one lane may keep the others waiting, or go on while one waits.
const TURN: u64 = 32;
/// Rounds in a row if nobody waits.
const LONG_TURN: u64 = 1 << 20;

/// A trajectory to be computed.
pub(super) struct Job<S> {
    pub system: Result<S, Diagnostic>,
    pub until: f64,
    pub samples: Vec<f64>,
    /// How far off its start state is, state by state.
    pub offsets: Vec<f64>,
}

/// What comes of a trajectory.
pub(super) type Outcome = Result<Trajectory, TrajectoryFailure>;

/// Jobs that are handed out one by one.
pub(super) struct Queue<'q, S> {
    jobs: &'q [Job<S>],
    next: AtomicUsize,
}

impl<'q, S> Queue<'q, S> {
    pub fn new(jobs: &'q [Job<S>]) -> Self {
        Self {
            jobs,
            next: AtomicUsize::new(0),
        }
    }

    fn take(&self) -> Option<(usize, &'q Job<S>)> {
        let index = self.next.fetch_add(1, Ordering::Relaxed);
        Some((index, self.jobs.get(index)?))
    }
}

/// One thread's share of the work.
pub(super) struct Worker<'q, S> {
    pub queue: &'q Queue<'q, S>,
    pub settings: &'q Settings,
    /// No more lanes than this are used, so that all threads have some.
    pub most_lanes: usize,
}

impl<S> Clone for Worker<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Worker<'_, S> {}

impl<S: LaneSystem> Task for Worker<'_, S> {
    /// Positions in the queue, and what came of the jobs there.
    type Output = Vec<(usize, Outcome)>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        match self.settings.accuracy {
            Accuracy::Step(dt) => self.follow::<L, Lockstep<L>, _>(&|_, states| {
                Ok((RungeKutta::new(states.len()), Pace::fixed(dt)))
            }),
            Accuracy::Relative(rtol) => self.follow::<L, OwnSteps<S, L>, _>(&|settings, states| {
                let control = settings.control(rtol, states)?;
                Ok((DormandPrince::new(states.len()), Pace::Adaptive(control)))
            }),
        }
    }
}

/// Method and pace of a walk over these states, or what makes no sense about the settings.
type Start<'q, M> = &'q dyn Fn(&Settings, &[Variable]) -> Result<(M, Pace), Breakdown>;

/// A trajectory in a lane.
struct Seat<'q, S: LaneSystem, M> {
    index: usize,
    walk: Walk<'q, S, M>,
    /// Whether the lane carries it now, not the walk.
    in_lane: bool,
}

/// The lanes of a worker and who sits in them.
struct Crew<'q, 'f, S: LaneSystem, L: Lanes, P, M> {
    worker: Worker<'q, S>,
    start: Start<'f, M>,
    /// Made with the first trajectory.
    lanes: Option<(Block<S, L>, P)>,
    seats: Vec<Option<Seat<'q, S, M>>>,
    outcomes: Vec<(usize, Outcome)>,
}

impl<'q, S: LaneSystem> Worker<'q, S> {
    #[inline(always)]
    fn follow<L: Lanes, P: Steps<S, L>, M: Method>(
        self,
        start: Start<'_, M>,
    ) -> Vec<(usize, Outcome)> {
        let count = self.most_lanes.clamp(1, L::COUNT);
        let mut crew = Crew::<S, L, P, M> {
            worker: self,
            start,
            lanes: None,
            seats: (0..count).map(|_| None).collect(),
            outcomes: Vec::new(),
        };
        loop {
            let (moving, waiting) = crew.settle();
            let Some((block, steps)) = &mut crew.lanes else {
                break;
            };
            if moving > 0 {
                steps.advance(block, if waiting > 0 { TURN } else { LONG_TURN });
                crew.pick_up();
            } else if waiting == 0 {
                break;
            }
        }
        crew.outcomes
    }

    /// A walk that stands at its start, or why there is none.
    fn set_out<M: Method>(
        &self,
        job: &'q Job<S>,
        start: Start<'_, M>,
    ) -> Result<Walk<'q, S, M>, TrajectoryFailure> {
        let system = job
            .system
            .as_ref()
            .map_err(|why| TrajectoryFailure::Preparation(why.clone()))?;
        let settings = Settings {
            until: job.until,
            ..self.settings.clone()
        };
        let failed = |breakdown| TrajectoryFailure::run(breakdown, Trajectory::default());
        let inputs = settings.inputs(system.inputs()).map_err(failed)?;
        check_samples(&job.samples, job.until).map_err(failed)?;
        let flow = Flow::new(system, inputs, false);
        let (method, pace) = start(&settings, system.states()).map_err(failed)?;
        let nobody = Recording {
            recorder: None,
            every: None,
        };
        Ok(
            Walk::new(flow, method, pace, job.until, nobody, settings.most_steps)
                .starting_off(&job.offsets)
                .stopping(&job.samples),
        )
    }
}

impl<S: LaneSystem, L: Lanes, P: Steps<S, L>, M: Method> Crew<'_, '_, S, L, P, M> {
    /// Brings every seat to where its lane can go on; how many can, and how many are not there yet.
    fn settle(&mut self) -> (usize, usize) {
        let (mut moving, mut waiting) = (0, 0);
        for lane in 0..self.seats.len() {
            for _ in 0..TURN {
                if self.seats[lane].is_none() && !self.fill(lane) {
                    break;
                }
                if self.is_moving(lane) {
                    break;
                }
                self.go_alone(lane);
            }
            match &self.seats[lane] {
                Some(seat) if seat.in_lane => moving += 1,
                Some(_) => waiting += 1,
                None => {}
            }
        }
        (moving, waiting)
    }

    /// Gives an empty seat the next trajectory that sets out; whether there is one.
    fn fill(&mut self, lane: usize) -> bool {
        while let Some((index, job)) = self.worker.queue.take() {
            let mut walk = match self.worker.set_out(job, self.start) {
                Ok(walk) => walk,
                Err(failure) => {
                    self.outcomes.push((index, Err(failure)));
                    continue;
                }
            };
            if let Err(halt) = walk.begin() {
                self.outcomes.push((index, outcome(walk, Err(halt))));
                continue;
            }
            let (block, _) = self.lanes.get_or_insert_with(|| {
                let system = walk.flow.system;
                let in_lanes = Box::new(system.in_every_lane());
                let block = Block::new(system, in_lanes, &walk.flow.u);
                (block, P::new(walk.stand.x.len()))
            });
            walk.flow.system.put_in_lane(lane, &mut block.system);
            self.seats[lane] = Some(Seat {
                index,
                walk,
                in_lane: false,
            });
            return true;
        }
        false
    }

    /// Whether a seat's lane carries it, now at the latest.
    fn is_moving(&mut self, lane: usize) -> bool {
        let (Some(seat), Some((block, steps))) = (&mut self.seats[lane], &mut self.lanes) else {
            return false;
        };
        let walk = &mut seat.walk;
        if !seat.in_lane && !walk.is_over() && walk.is_quiet() {
            let to = walk.next_break();
            if P::can_take(&mut walk.stand, to) {
                block.load(lane, &walk.stand);
                steps.load(lane, &mut walk.stand, &Way::to(to));
                seat.in_lane = true;
            }
        }
        seat.in_lane
    }

    /// One step by the walk itself, or its end.
    fn go_alone(&mut self, lane: usize) {
        if let Some(seat) = &mut self.seats[lane] {
            let went = if seat.walk.is_over() {
                Some(Ok(()))
            } else {
                seat.walk.round().err().map(Err)
            };
            self.leave(lane, went);
        }
    }

    /// Takes trajectories that cannot go on in their lanes out of these.
    fn pick_up(&mut self) {
        for lane in 0..self.seats.len() {
            let (Some(seat), Some((block, steps))) = (&mut self.seats[lane], &mut self.lanes)
            else {
                continue;
            };
            let verdict = steps.verdict(lane);
            if !seat.in_lane || verdict == Verdict::UnderWay {
                continue;
            }
            let to = seat.walk.next_break();
            steps.store(lane, &mut seat.walk.stand, Way::to(to), block);
            seat.walk.resume();
            seat.in_lane = false;
            let went = match verdict {
                Verdict::Arrived => seat.walk.arrive(false),
                _ => seat.walk.round(),
            };
            self.leave(lane, went.err().map(Err));
        }
    }

    /// Empties a seat whose trajectory is over.
    fn leave(&mut self, lane: usize, went: Option<Result<(), Halt>>) {
        if let Some(went) = went
            && let Some(seat) = self.seats[lane].take()
        {
            self.outcomes.push((seat.index, outcome(seat.walk, went)));
        }
    }
}

fn outcome<S: LaneSystem, M: Method>(walk: Walk<'_, S, M>, went: Result<(), Halt>) -> Outcome {
    let (summary, breakdown, samples) = walk.leave(went);
    let trajectory = Trajectory { summary, samples };
    match breakdown {
        None => Ok(trajectory),
        Some(breakdown) => Err(TrajectoryFailure::run(breakdown, trajectory)),
    }
}

fn check_samples(times: &[f64], until: f64) -> Result<(), Breakdown> {
    let mut last = 0.0;
    for &time in times {
        if !(time >= last && time <= until) {
            return Err(Breakdown::setting(
                format!("a sample cannot be taken at t = {time} s"),
                format!("give rising times from zero to the end at {until} s"),
            ));
        }
        last = time;
    }
    Ok(())
}
