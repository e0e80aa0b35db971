//! Following motions until they settle, by stages: what has not settled in a number of cycles is
//! followed anew to four times as many.
//!
//! A stage begins at the start of the motion, not where the last one ended: a trajectory is then
//! the same whatever was asked before, and all stages together cost a third more than the longest.

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::lanes::LaneSystem;
use flexure_runtime::simulate::Sample;

use super::settle::{APART, Repetition, Strobes};
use super::speed::{SAMPLES, Speed, advancing};
use super::{Motion, Outcome, Point, Response, Run, Settle, mean_speed, subdivided};

/// Cycles of the first stage.
const FIRST_STAGE: u32 = 32;
/// How many times as many cycles the next stage has.
const GROWTH: u32 = 4;
/// Trajectories that are sampled at once: so many fit in memory.
const AT_ONCE: usize = 128;
/// Samples in the last cycle, for the range of each state.
const PHASES: u32 = 16;
/// By how much the first state of a twin is off at the start, in rad or m.
const OFFSET: f64 = 1e-9;
/// The same as the greatest share of that state's range within a cycle.
const OFFSET_SHARE: f64 = 1e-3;

impl<P> Response<'_, P> {
    pub(super) fn settle<S>(&mut self, settle: Settle) -> Vec<Outcome>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        let count = self.frequencies.len();
        // One model, one structure: any of its systems tells.
        let advancing = (0..count)
            .find_map(|point| (self.prepare)(point).ok())
            .map_or(Vec::new(), |system| advancing(&system));
        let mut outcomes: Vec<Option<Outcome>> = vec![None; count];
        let mut progress = self.progress.take();
        let most_cycles = settle.most_cycles.max(1);
        let mut cycles = FIRST_STAGE.min(most_cycles);
        loop {
            let is_last = cycles == most_cycles;
            let open: Vec<usize> = (0..count).filter(|&p| outcomes[p].is_none()).collect();
            for points in open.chunks(AT_ONCE) {
                let traces = self.trace(points.iter().map(|&point| Run::from_start(point)), cycles);
                let mut unsettled = Vec::new();
                for (&point, trace) in points.iter().zip(traces) {
                    let trace = match trace {
                        Ok(trace) => trace,
                        Err(why) => {
                            outcomes[point] = Some(Err(why));
                            continue;
                        }
                    };
                    match trace.strobes(&advancing).repetition(settle.tolerance) {
                        Some(repetition) => {
                            let settled = trace.settled(self.frequencies[point], repetition);
                            outcomes[point] = Some(Ok(settled));
                        }
                        None if is_last => unsettled.push((point, trace)),
                        None => {}
                    }
                }
                for (point, outcome) in self.judge(unsettled, &advancing) {
                    outcomes[point] = Some(outcome);
                }
                if let Some(report) = &mut progress {
                    report(outcomes.iter().flatten().count() as f64 / count as f64);
                }
            }
            if is_last {
                break;
            }
            cycles = cycles.saturating_mul(GROWTH).min(most_cycles);
        }
        self.progress = progress;
        outcomes.into_iter().flatten().collect()
    }

    /// Tells slow transients from chaos, by twins.
    fn judge<S>(
        &mut self,
        unsettled: Vec<(usize, Trace)>,
        advancing: &[bool],
    ) -> Vec<(usize, Outcome)>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        let Some(cycles) = unsettled.first().map(|(_, trace)| trace.cycles()) else {
            return Vec::new();
        };
        let runs = unsettled.iter().map(|(point, trace)| Run {
            point: *point,
            offset: OFFSET.min(OFFSET_SHARE * trace.ranges.first().unwrap_or(&0.0)),
        });
        let twins = self.trace(runs, cycles);
        let pairs = unsettled.iter().zip(twins);
        pairs
            .map(|((point, trace), twin)| {
                let outcome = twin.map_or_else(
                    |why| {
                        Err(why.hint(
                            "it is a trajectory that began a little beside the motion's start",
                        ))
                    },
                    |twin| {
                        let other: Vec<&[f64]> = twin.states.iter().map(Vec::as_slice).collect();
                        let distance = trace.strobes(advancing).distance(&other);
                        Ok(trace.unsettled(self.frequencies[*point], distance > APART))
                    },
                );
                (*point, outcome)
            })
            .collect()
    }

    /// Follows runs for so many cycles.
    fn trace<S>(
        &mut self,
        runs: impl Iterator<Item = Run>,
        cycles: u32,
    ) -> Vec<Result<Trace, Diagnostic>>
    where
        S: LaneSystem,
        P: Fn(usize) -> Result<S, Diagnostic>,
    {
        let runs: Vec<Run> = runs.collect();
        let speed = self.speed;
        // Speeds of the first half are of no interest, and their samples would take much memory.
        let (mut times, first) = match speed {
            Speed::RateOf(_) => (subdivided(cycles - 1..cycles, PHASES), 0),
            Speed::Sampled(_) => (subdivided(cycles / 2..cycles, SAMPLES), cycles / 2),
        };
        let finer = times.first().copied().unwrap_or(0.0) as u32;
        times.splice(0..0, (0..finer).map(f64::from));
        self.follow(&runs, &times, |_, samples| {
            samples.map(|samples| Trace::new(samples, &times, speed, first))
        })
    }
}

/// What is kept of a trajectory.
struct Trace {
    /// States at the starts of cycles 0, 1, 2, … and at the end of the last.
    states: Vec<Vec<f64>>,
    /// The range of each state within the last cycle.
    ranges: Vec<f64>,
    /// Mean speeds of single cycles, from this cycle on.
    first: u32,
    speeds: Vec<f64>,
}

impl Trace {
    fn new(samples: &[Sample], times: &[f64], speed: Speed, first: u32) -> Self {
        let starts: Vec<usize> = (0..times.len())
            .filter(|&k| times[k].fract() == 0.0)
            .collect();
        let cycles = starts.windows(2);
        let last = cycles
            .clone()
            .last()
            .map_or(&samples[..0], |c| &samples[c[0]..=c[1]]);
        let size = samples.first().map_or(0, |sample| sample.state.len());
        let range = |i: usize| {
            let values = last.iter().map(|sample| sample.state[i]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            });
            high - low
        };
        Self {
            states: starts.iter().map(|&k| samples[k].state.clone()).collect(),
            ranges: (0..size).map(range).collect(),
            first,
            speeds: cycles
                .skip(first as usize)
                .map(|c| mean_speed(speed, &samples[c[0]..=c[1]]))
                .collect(),
        }
    }

    fn cycles(&self) -> u32 {
        self.first + self.speeds.len() as u32
    }

    fn strobes<'a>(&'a self, advancing: &'a [bool]) -> Strobes<'a> {
        Strobes {
            states: self.states.iter().map(Vec::as_slice).collect(),
            ranges: &self.ranges,
            advancing,
        }
    }

    /// A motion that has settled: the mean is over whole periods.
    fn settled(&self, frequency: f64, repetition: Repetition) -> Point {
        let end = self.cycles();
        let known = repetition.from.max(self.first);
        let start = end - (end - known) / repetition.period * repetition.period;
        let (speed, _) = self.mean(start);
        Point {
            frequency,
            speed,
            cycles: start..end,
            motion: match repetition.period {
                1 => Motion::Periodic,
                period => Motion::PeriodN(period),
            },
        }
    }

    /// One that has not: the mean is over the last half of the cycles.
    fn unsettled(&self, frequency: f64, is_chaotic: bool) -> Point {
        let end = self.cycles();
        let start = end / 2;
        let (speed, spread) = self.mean(start);
        Point {
            frequency,
            speed,
            cycles: start..end,
            motion: if is_chaotic {
                Motion::Chaotic { spread }
            } else {
                Motion::Transient
            },
        }
    }

    /// Mean and standard deviation of the speeds of single cycles, from cycle `start` on.
    fn mean(&self, start: u32) -> (f64, f64) {
        let speeds = &self.speeds[start.saturating_sub(self.first) as usize..];
        let count = speeds.len() as f64;
        let mean = speeds.iter().sum::<f64>() / count;
        let squares: f64 = speeds.iter().map(|speed| (speed - mean).powi(2)).sum();
        (mean, (squares / count).sqrt())
    }
}
