//! Ensembles: a trajectory is the one that `simulate` gives, whatever runs beside it.

use flexure_models::double_rocker;
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::lanes::{LaneSystem, Lanes, Portable};
use flexure_runtime::simulate::{
    Ensemble, Summary, Trajectory, TrajectoryFailure, ensemble, simulate,
};

type Outcome = Result<Trajectory, TrajectoryFailure>;
type Systems<S> = std::vec::IntoIter<Result<S, Diagnostic>>;

fn actuators(count: usize) -> Vec<double_rocker::Prepared<f64>> {
    let frequency = |i: usize| 1600.0 + 137.0 * i as f64;
    (0..count)
        .map(|i| {
            let design = double_rocker::Params {
                f: frequency(i),
                Fp: 12.0 + i as f64,
                ..Default::default()
            };
            design.prepare().expect("a design that closes")
        })
        .collect()
}

fn all<'a, S: LaneSystem + Clone>(systems: &[S]) -> Ensemble<'a, Systems<S>> {
    let each: Vec<Result<S, Diagnostic>> = systems.iter().cloned().map(Ok).collect();
    ensemble(each)
}

fn on<L: Lanes, S: LaneSystem>(runs: Ensemble<'_, Systems<S>>) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    runs.run_on::<L>(|index, outcome| {
        assert_eq!(index, outcomes.len());
        outcomes.push(outcome);
    });
    outcomes
}

fn done(outcome: &Outcome) -> &Trajectory {
    outcome.as_ref().expect("a trajectory to its end")
}

/// Bit by bit, signs of zeros included.
fn same(a: &[f64], b: &[f64]) -> bool {
    a.iter()
        .map(|v| v.to_bits())
        .eq(b.iter().map(|v| v.to_bits()))
}

fn assert_same(a: &[Outcome], b: &[Outcome]) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (done(a), done(b));
        assert_eq!(a.summary, b.summary);
        assert!(same(&a.summary.state, &b.summary.state));
        assert_eq!(a.samples, b.samples);
    }
}

/// In closed form, bit by bit: one trajectory alone has curves, which those in lanes do not have.
#[test]
fn fixed_steps_are_those_of_simulate() {
    let systems = actuators(6).into_iter().map(|system| system.exact());
    let systems: Vec<_> = systems.collect();
    let outcomes = all(&systems).until(2e-4).dt(1e-6).collect();
    for (system, outcome) in systems.iter().zip(&outcomes) {
        let run = simulate(system).until(2e-4).dt(1e-6).run().unwrap();
        assert_eq!(&done(outcome).summary, run.summary());
    }
}

#[test]
fn adaptive_steps_are_those_of_simulate() {
    let systems = actuators(6).into_iter().map(|system| system.exact());
    let systems: Vec<_> = systems.collect();
    let outcomes = all(&systems).until(1e-3).rtol(1e-8).collect();
    for (system, outcome) in systems.iter().zip(&outcomes) {
        let run = simulate(system).until(1e-3).rtol(1e-8).run().unwrap();
        assert_eq!(&done(outcome).summary, run.summary());
        assert!(done(outcome).summary.statistics.rejected > 10);
        assert!(done(outcome).summary.statistics.kinks > 1);
    }
}

/// Curves are the closed form to rounding: equal steps show it, those of the solver's choice to their
/// tolerance.
#[test]
fn curves_of_one_trajectory_alone_change_nothing() {
    let systems = actuators(6);
    let fixed = all(&systems).until(1e-3).dt(1e-6).collect();
    let adaptive = all(&systems).until(1e-3).rtol(1e-8).collect();
    for (system, outcome) in systems.iter().zip(&fixed) {
        let run = simulate(system).until(1e-3).dt(1e-6).run().unwrap();
        assert!(stage_is_off(done(outcome), run.summary()) <= 1e-9);
    }
    for (system, outcome) in systems.iter().zip(&adaptive) {
        let run = simulate(system).until(1e-3).rtol(1e-8).run().unwrap();
        assert!(stage_is_off(done(outcome), run.summary()) <= 1e-7);
    }
}

/// Relative difference of the stage's positions.
fn stage_is_off(a: &Trajectory, b: &Summary) -> f64 {
    let (a, b) = (a.summary.state[4], b.state[4]);
    (a - b).abs() / b.abs()
}

#[test]
fn results_depend_on_no_neighbour() {
    let systems = actuators(5);
    for step in [None, Some(1e-6)] {
        let runs = |systems: &[_]| {
            let runs = all(systems).until(7e-4).samples(&[3e-4, 6e-4]);
            match step {
                None => runs.rtol(1e-6),
                Some(step) => runs.dt(step),
            }
        };
        let one = on::<f64, _>(runs(&systems));
        assert_same(&one, &on::<Portable<1>, _>(runs(&systems)));
        assert_same(&one, &on::<Portable<4>, _>(runs(&systems)));
        assert_same(&one, &on::<Portable<8>, _>(runs(&systems)));
        assert_same(&one, &on::<Portable<4>, _>(runs(&systems).threads(1)));
        assert_same(&one, &on::<Portable<4>, _>(runs(&systems).threads(2)));
        assert_same(&one, &on::<Portable<4>, _>(runs(&systems).threads(3)));
        let backwards: Vec<_> = systems.iter().rev().cloned().collect();
        let mut others = on::<Portable<4>, _>(runs(&backwards).threads(2));
        others.reverse();
        assert_same(&one, &others);

        let widest = runs(&systems).threads(1).collect();
        assert_same(&widest, &runs(&systems).threads(3).collect());
        let mut others = runs(&backwards).threads(2).collect();
        others.reverse();
        assert_same(&widest, &others);
    }
}

#[test]
fn tapes_run_in_lanes_as_alone() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/models/double_rocker.flex");
    let model = flexure::Model::from_path(path).unwrap();
    let systems: Vec<_> = (0..3)
        .map(|i| {
            let mut design = model.design();
            design.set("f", 900.0 + 150.0 * f64::from(i)).unwrap();
            design.prepare().unwrap()
        })
        .collect();
    let outcomes = all(&systems).until(1.2e-3).rtol(1e-6).collect();
    for (system, outcome) in systems.iter().zip(&outcomes) {
        let run = simulate(system).until(1.2e-3).rtol(1e-6).run().unwrap();
        assert_eq!(&done(outcome).summary, run.summary());
    }
    let fixed = all(&systems).until(2e-4).dt(1e-6).collect();
    for (system, outcome) in systems.iter().zip(&fixed) {
        let run = simulate(system).until(2e-4).dt(1e-6).run().unwrap();
        assert_eq!(&done(outcome).summary, run.summary());
    }
}

#[test]
fn paths_agree_where_the_motion_is_not_chaotic() {
    let systems = actuators(5);
    let runs = || all(&systems).until(1e-3).dt(1e-6);
    let plain = on::<f64, _>(runs());
    for (a, b) in plain.iter().zip(&runs().collect()) {
        let (a, b) = (&done(a).summary.state, &done(b).summary.state);
        assert!(
            (a[4] - b[4]).abs() <= 1e-9 * a[4].abs(),
            "{} {}",
            a[4],
            b[4]
        );
    }
}
