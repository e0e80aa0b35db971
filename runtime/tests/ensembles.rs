//! Ensembles of a system written by hand, with kinks, events and dead points: each trajectory is the
//! one that `simulate` gives, whatever runs beside it.

use std::borrow::Cow;

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::lanes::{LaneSystem, Lanes, Portable};
use flexure_runtime::real::Real;
use flexure_runtime::simulate::{
    BreakdownKind, Ending, Ensemble, PlainSteps, Run, Trajectory, TrajectoryFailure, ensemble,
    simulate,
};
use flexure_runtime::system::{Causality, Energy, EventAction, System, Variable};

/// A ball that bounces on a floor, in a field that is switched on and off twice a period.
///
/// States: height, velocity. Discrete: number of the next switch. Its "loop" cannot close any more
/// at the height of the ceiling.
#[derive(Clone, Copy, Debug)]
struct Ball<T> {
    gravity: T,
    period: T,
    ceiling: T,
    /// What is left of the speed after a bounce.
    restitution: T,
    velocity: T,
}

static STATES: [Variable; 2] = [row("height", "m"), row("velocity", "m/s")];
static SWITCH: [Variable; 1] = [row("switch", "1")];
static OUTPUTS: [Variable; 1] = [row("depth", "m")];

const fn row(name: &'static str, unit: &'static str) -> Variable {
    Variable {
        name: Cow::Borrowed(name),
        unit: Cow::Borrowed(unit),
        meaning: Cow::Borrowed(""),
        causality: Causality::State,
        start: None,
    }
}

impl<T: Real> Ball<T> {
    fn map<U>(self, turn: impl Fn(T) -> U) -> Ball<U> {
        Ball {
            gravity: turn(self.gravity),
            period: turn(self.period),
            ceiling: turn(self.ceiling),
            restitution: turn(self.restitution),
            velocity: turn(self.velocity),
        }
    }

    fn rates(&self, t: T, x: &[T], d: &[T], dx: &mut [T]) {
        let half = d[0] * 0.5;
        let is_odd = half - half.floor() - 0.25;
        dx[0] = x[1];
        dx[1] = is_odd.if_positive(self.gravity * -0.5, -self.gravity) + (t * 3.0).sin() * 0.1;
    }

    fn closure(&self, x: &[T]) -> T {
        (self.ceiling - x[0]) / self.ceiling
    }
}

impl System for Ball<f64> {
    fn states(&self) -> &[Variable] {
        &STATES
    }
    fn discretes(&self) -> &[Variable] {
        &SWITCH
    }
    fn inputs(&self) -> &[Variable] {
        &[]
    }
    fn output_variables(&self) -> &[Variable] {
        &OUTPUTS
    }
    fn start(&self, x: &mut [f64], d: &mut [f64]) {
        x.copy_from_slice(&[1.0, self.velocity]);
        d[0] = 1.0;
    }
    fn rhs(&self, t: f64, x: &[f64], d: &[f64], _: &[f64], dx: &mut [f64]) {
        self.rates(t, x, d, dx);
    }
    fn jacobian(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&[0.0, 1.0, 0.0, 0.0]);
    }
    fn outputs(&self, _: f64, x: &[f64], _: &[f64], _: &[f64], out: &mut [f64]) {
        out[0] = -x[0];
    }
    fn energy(&self, _: f64, _: &[f64], _: &[f64], _: &[f64]) -> Energy {
        Energy::default()
    }
    fn kink_count(&self) -> usize {
        1
    }
    fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
        times[0] = 0.5 * self.period * d[0];
    }
    fn pass_kink(&self, _: usize, d: &mut [f64]) {
        d[0] += 1.0;
    }
    fn event_count(&self) -> usize {
        1
    }
    fn events(&self, _: f64, x: &[f64], _: &[f64], _: &[f64], values: &mut [f64]) {
        values[0] = -x[0];
    }
    fn event_name(&self, _: usize) -> &str {
        "bounce"
    }
    fn pass_event(&self, _: usize, _: f64, x: &mut [f64], _: &mut [f64], _: &[f64]) -> EventAction {
        x[1] *= -self.restitution;
        if self.restitution > 0.0 {
            EventAction::Continue
        } else {
            EventAction::Stop(Cow::Borrowed("it lies"))
        }
    }
    fn accept(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}
    fn turning(&self) -> &[usize] {
        &[]
    }
    fn loop_count(&self) -> usize {
        1
    }
    fn closures(&self, _: f64, x: &[f64], _: &[f64], _: &[f64], values: &mut [f64]) {
        values[0] = self.closure(x);
    }
    fn loop_name(&self, _: usize) -> &str {
        "ceiling"
    }
    fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
        steps.on_lanes(self);
    }
}

impl LaneSystem for Ball<f64> {
    type InLanes<L: Lanes> = Ball<L>;
    type States<L: Lanes> = [L; 2];
    type Discretes<L: Lanes> = Vec<L>;
    type Loops<L: Lanes> = [L; 1];
    type Events<L: Lanes> = [L; 1];

    fn in_every_lane<L: Lanes>(&self) -> Ball<L> {
        self.map(L::from_f64)
    }
    fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Ball<L>) {
        lanes.gravity.set_entry(lane, self.gravity);
        lanes.period.set_entry(lane, self.period);
        lanes.ceiling.set_entry(lane, self.ceiling);
        lanes.restitution.set_entry(lane, self.restitution);
        lanes.velocity.set_entry(lane, self.velocity);
    }
    fn rhs_in_lanes<L: Lanes>(lanes: &Ball<L>, t: L, x: &[L], d: &[L], _: &[L], dx: &mut [L]) {
        lanes.rates(t, x, d, dx);
    }
    fn accept_in_lanes<L: Lanes>(_: &Ball<L>, _: L, _: &[L], _: &[L], _: &mut [L]) {}
    fn events_in_lanes<L: Lanes>(_: &Ball<L>, _: L, x: &[L], _: &[L], _: &[L], values: &mut [L]) {
        values[0] = -x[0];
    }
    fn closures_in_lanes<L: Lanes>(
        lanes: &Ball<L>,
        _: L,
        x: &[L],
        _: &[L],
        _: &[L],
        values: &mut [L],
    ) {
        values[0] = lanes.closure(x);
    }
}

/// Balls that bounce (0, 1, 4, …), hit the ceiling (2), stay where they fall (3).
fn balls(count: usize) -> Vec<Ball<f64>> {
    (0..count)
        .map(|i| Ball {
            gravity: 9.81 + 0.3 * i as f64,
            period: 0.31 + 0.01 * i as f64,
            ceiling: 2.0,
            restitution: if i % 5 == 3 { 0.0 } else { 0.8 },
            velocity: if i % 5 == 2 { 6.0 } else { 0.5 },
        })
        .collect()
}

type Outcome = Result<Trajectory, TrajectoryFailure>;
type Systems = std::vec::IntoIter<Result<Ball<f64>, Diagnostic>>;

fn runs<'a>(balls: &[Ball<f64>], is_fixed: bool) -> Ensemble<'a, Systems> {
    let systems: Vec<_> = balls.iter().copied().map(Ok).collect();
    let runs = ensemble(systems).until_each(|index| 1.5 + 0.1 * (index % 5) as f64);
    if is_fixed {
        runs.dt(1e-3)
    } else {
        runs.rtol(1e-9)
    }
}

fn on<L: Lanes>(runs: Ensemble<'_, Systems>) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    runs.run_on::<L>(|index, outcome| {
        assert_eq!(index, outcomes.len());
        outcomes.push(outcome);
    });
    outcomes
}

/// What there is of a trajectory, and why there is no more.
fn parts(outcome: &Outcome) -> (&Trajectory, Option<BreakdownKind>) {
    match outcome {
        Ok(trajectory) => (trajectory, None),
        Err(TrajectoryFailure::Run {
            breakdown,
            trajectory,
        }) => (trajectory, Some(breakdown.kind)),
        Err(TrajectoryFailure::Preparation(why)) => panic!("{why}"),
    }
}

fn assert_same(a: &[Outcome], b: &[Outcome]) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert_eq!(parts(a), parts(b));
    }
}

/// A run alone with rows at multiples of an interval, or at every step, as far as it goes.
fn alone(ball: &Ball<f64>, accuracy: Result<f64, f64>, every: Option<f64>) -> Run {
    let run = simulate(ball).until(1.6);
    let run = match accuracy {
        Ok(step) => run.dt(step),
        Err(tolerance) => run.rtol(tolerance),
    };
    let run = match every {
        Some(interval) => run.every(interval),
        None => run,
    };
    run.run().unwrap_or_else(|failure| *failure.run)
}

#[test]
fn rows_have_no_influence_on_steps_in_lanes() {
    for ball in &balls(5) {
        let exact = alone(ball, Err(1e-13), Some(1e-4));
        for accuracy in [Ok(1e-3), Ok(0.7e-4), Err(1e-6), Err(1e-9)] {
            let runs = [None, Some(1e-4), Some(0.0137), Some(2.0)]
                .map(|every| alone(ball, accuracy, every));
            for run in &runs {
                let [mut ours, mut others] = [run, &runs[0]].map(|run| run.summary().clone());
                // Dense output costs evaluations.
                (ours.statistics.evaluations, others.statistics.evaluations) = (0, 0);
                assert_eq!(ours, others);
                assert!(run.times().is_sorted());
            }
            assert!(runs[0].len() as u64 > runs[0].statistics().accepted);
            let dense = &runs[1];
            assert!(dense.len() > 900, "{}", dense.len());
            let rows = dense.times().iter().zip(dense.column("height").values());
            let exact = exact.times().iter().zip(exact.column("height").values());
            for ((time, height), (same, expected)) in rows.zip(exact).take(900) {
                assert_eq!(time, same);
                assert!((height - expected).abs() < 1e-5, "{accuracy:?} {time}");
            }
        }
    }
}

#[test]
fn trajectories_are_those_of_simulate() {
    let balls = balls(13);
    for is_fixed in [true, false] {
        let outcomes = runs(&balls, is_fixed).collect();
        let (mut bounces, mut dead, mut lying) = (0, 0, 0);
        for (index, (ball, outcome)) in balls.iter().zip(&outcomes).enumerate() {
            let run = simulate(ball).until(1.5 + 0.1 * (index % 5) as f64);
            let run = if is_fixed {
                run.dt(1e-3)
            } else {
                run.rtol(1e-9)
            };
            let (trajectory, kind) = parts(outcome);
            let summary = match run.run() {
                Ok(run) => {
                    assert_eq!(kind, None);
                    run.summary().clone()
                }
                Err(failure) => {
                    assert_eq!(kind, Some(failure.breakdown.kind));
                    failure.run.summary().clone()
                }
            };
            assert_eq!(trajectory.summary, summary, "{index}");
            bounces += summary.events.len();
            dead += usize::from(matches!(kind, Some(BreakdownKind::DeadPoint(0))));
            lying += usize::from(matches!(summary.ending, Ending::Stopped(_)));
        }
        assert!(
            bounces > 10 && dead == 3 && lying == 2,
            "{bounces} {dead} {lying}"
        );
    }
}

#[test]
fn results_depend_on_no_neighbour() {
    let balls = balls(11);
    let with_samples = |balls: &[Ball<f64>], is_fixed| {
        let ends = runs(balls, is_fixed).until(1.5);
        ends.samples(&[0.0, 0.37, 0.4, 1.5])
    };
    for is_fixed in [true, false] {
        let one = on::<f64>(with_samples(&balls, is_fixed));
        for threads in [1, 2, 3] {
            let these = || with_samples(&balls, is_fixed).threads(threads);
            assert_same(&one, &on::<Portable<1>>(these()));
            assert_same(&one, &on::<Portable<3>>(these()));
            assert_same(&one, &on::<Portable<4>>(these()));
            assert_same(&one, &on::<Portable<8>>(these()));
            let backwards: Vec<_> = balls.iter().rev().copied().collect();
            let backwards = with_samples(&backwards, is_fixed).threads(threads);
            let mut others = on::<Portable<4>>(backwards);
            others.reverse();
            assert_same(&one, &others);
        }
        let widest = with_samples(&balls, is_fixed).threads(1).collect();
        assert_same(
            &widest,
            &with_samples(&balls, is_fixed).threads(3).collect(),
        );
    }
}

#[test]
fn samples_are_taken_exactly_where_they_are_asked_for() {
    let balls = balls(2);
    let times = [0.0, 0.1, 0.2, 0.2];
    let outcomes = runs(&balls, false).samples(&times).collect();
    for (ball, outcome) in balls.iter().zip(&outcomes) {
        let samples = &parts(outcome).0.samples;
        let taken: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
        assert_eq!(taken, times);
        assert_eq!(samples[0].state, [1.0, 0.5]);
        let run = simulate(ball).until(0.2).rtol(1e-11).run().unwrap();
        for (a, b) in samples[2].state.iter().zip(&run.summary().state) {
            assert!((a - b).abs() < 1e-8, "{a} {b}");
        }
        assert_eq!(samples[2].outputs, [-samples[2].state[0]]);
        assert_eq!(samples[2], samples[3]);
    }
}

#[test]
fn a_start_that_is_off_is_another_start() {
    let balls = balls(4);
    let off = |index: usize| 0.125 * index as f64;
    let offset = runs(&balls, false).offsets_each(|index| vec![0.0, off(index)]);
    let mut others = balls.clone();
    for (index, ball) in others.iter_mut().enumerate() {
        ball.velocity += off(index);
    }
    assert_same(&offset.collect(), &runs(&others, false).collect());
    let unchanged = runs(&balls, false).offsets_each(|_| Vec::new()).collect();
    assert_same(&unchanged, &runs(&balls, false).collect());
}

#[test]
fn what_fails_has_its_place_among_the_results() {
    let refuse = |index: usize, ball: Ball<f64>| {
        if index % 3 == 1 {
            Err(Diagnostic::error("no such ball"))
        } else {
            Ok(ball)
        }
    };
    let systems = balls(9)
        .into_iter()
        .enumerate()
        .map(|(index, ball)| refuse(index, ball));
    let outcomes = ensemble(systems).until(0.3).collect();
    for (index, outcome) in outcomes.iter().enumerate() {
        match outcome {
            Err(TrajectoryFailure::Preparation(why)) => {
                assert_eq!(index % 3, 1);
                assert!(why.to_string().contains("no such ball"));
            }
            _ => assert_ne!(index % 3, 1),
        }
    }
    let settings: [fn(Ensemble<'_, Systems>) -> Ensemble<'_, Systems>; 4] = [
        |runs| runs.dt(0.0),
        |runs| runs.rtol(2.0),
        |runs| runs.until(-1.0),
        |runs| runs.samples(&[0.2, 0.1]),
    ];
    for change in settings {
        let outcomes = change(runs(&balls(2), false)).collect();
        assert_eq!(outcomes.len(), 2);
        for outcome in &outcomes {
            assert_eq!(parts(outcome).1, Some(BreakdownKind::Setting));
        }
    }
    let outcomes = runs(&balls(2), false).max_steps(10).collect();
    for outcome in &outcomes {
        assert_eq!(parts(outcome).1, Some(BreakdownKind::TooManySteps));
        let statistics = parts(outcome).0.summary.statistics;
        assert_eq!(statistics.accepted + statistics.rejected, 10);
    }
}

#[test]
fn many_trajectories_stream_in_order() {
    let ball = balls(1)[0];
    let systems = (0..2000).map(|i| {
        Ok(Ball {
            velocity: 0.5 - 1e-4 * f64::from(i),
            ..ball
        })
    });
    let (mut count, mut last) = (0, f64::INFINITY);
    ensemble(systems)
        .until(0.1)
        .rtol(1e-6)
        .threads(2)
        .run(|index, outcome| {
            assert_eq!(index, count);
            let height = parts(&outcome).0.summary.state[0];
            assert!(height < last);
            (count, last) = (count + 1, height);
        });
    assert_eq!(count, 2000);
}
