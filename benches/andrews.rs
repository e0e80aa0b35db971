//! W7: Andrews' squeezing mechanism to an accuracy.

use std::time::Instant;

use flexure::runtime::system::System;
use flexure::simulate;
use flexure_models::andrews;

use crate::baseline::Baseline;
use crate::measure::{Candidate, measure};
use crate::study::{End, Outcome, larger};
use crate::table::Table;

/// End of the run, in s.
const UNTIL: f64 = 0.03;
/// Allowed error of the angles, relative to those above 1 rad.
const ACCURACY: f64 = 1e-8;
/// The published angles at 0.03 s, recomputed from the published parameters in quadruple precision.
const NAMES: [&str; 7] = ["beta", "theta", "gamma", "phi", "delta", "Omega", "epsilon"];
const EXPECTED: [f64; 7] = [
    15.810771195153707,
    -15.75637105841184,
    0.0408222401196458,
    -0.5347301163420796,
    0.5244099658799541,
    0.5347301163420796,
    1.048080741041938,
];
/// Rounds of measurements.
const ROUNDS: usize = 5;
/// Runs in one measurement, of which the fastest counts.
const RUNS: usize = 20;
/// Tolerances that are tried, from the loosest.
const TOLERANCES: [f64; 13] = [
    1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 3e-10, 1e-10, 1e-11, 1e-12,
];

/// The angles stand where a study has its states.
fn error(outcome: &Outcome) -> f64 {
    let angles = outcome.ends[0].state;
    angles
        .iter()
        .zip(EXPECTED)
        .map(|(found, expected)| (found - expected).abs() / expected.abs().max(1.0))
        .fold(0.0, larger)
}

fn accurate(outcome: &Outcome) -> Result<(), String> {
    let error = error(outcome);
    if error <= ACCURACY {
        Ok(())
    } else {
        Err(format!("its angles are off by {error:.1e}"))
    }
}

fn absolute(c: &Baseline, tolerance: f64) -> Result<Outcome, String> {
    let arguments = [
        format!("{tolerance:e}"),
        format!("{UNTIL}"),
        RUNS.to_string(),
    ];
    let (head, lines) = c.andrews.numbers(&arguments, "")?;
    match (&head[..], lines.first().map(Vec::as_slice)) {
        (&[seconds, evaluations], Some(angles)) => outcome(seconds, evaluations as u64, angles),
        _ => Err("the program of C printed something else".to_owned()),
    }
}

fn outcome(seconds: f64, evaluations: u64, angles: &[f64]) -> Result<Outcome, String> {
    let state = angles.try_into().map_err(|_| "there are seven angles")?;
    Ok(Outcome {
        seconds,
        evaluations,
        memory: None,
        ends: vec![End { from: 0.0, state }],
    })
}

fn simulated<S: System + ?Sized>(model: &S, tolerance: f64) -> Result<Outcome, String> {
    let mut seconds = f64::INFINITY;
    let mut evaluations = 0;
    let mut angles = Vec::new();
    for _ in 0..RUNS {
        let start = Instant::now();
        let run = simulate(model).until(UNTIL).rtol(tolerance).every(UNTIL);
        let run = run.run().map_err(|failure| failure.breakdown.message)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
        evaluations = run.statistics().evaluations;
        angles = NAMES.map(|name| run.column(name).last()).to_vec();
    }
    outcome(seconds, evaluations, &angles)
}

type Solver<'a> = Box<dyn Fn(f64) -> Result<Outcome, String> + 'a>;

/// W7.
pub fn to_an_accuracy(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let mut solvers: Vec<(&str, Solver<'_>)> = Vec::new();
    if let Some(c) = c {
        let run = |tolerance| absolute(c, tolerance);
        solvers.push(("C absolute coordinates", Box::new(run)));
    }
    solvers.push((
        "flexure compiled simulate",
        Box::new(|tolerance| {
            let model = andrews::Params::default().prepare();
            simulated(&model.map_err(|why| why.message)?, tolerance)
        }),
    ));
    solvers.push((
        "flexure tape simulate",
        Box::new(|tolerance| {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/models/andrews.flex");
            let model = flexure::Model::from_path(path).map_err(|why| why.to_string())?;
            let system = model.design().prepare().map_err(|why| why.message)?;
            simulated(&system, tolerance)
        }),
    ));
    let candidates = solvers
        .iter()
        .map(|(name, run)| {
            // The loosest tolerance that is good enough together with the next tighter one.
            let good = TOLERANCES
                .map(|tolerance| run(tolerance).is_ok_and(|outcome| accurate(&outcome).is_ok()));
            let loosest = (0..TOLERANCES.len() - 1)
                .find(|&i| good[i] && good[i + 1])
                .unwrap_or(TOLERANCES.len() - 1);
            Candidate {
                name: format!("{name}, tolerance {:.0e}", TOLERANCES[loosest]),
                cores: 1,
                share: 1.0,
                run: Box::new(move || run(TOLERANCES[loosest])),
            }
        })
        .collect();
    measure(
        table,
        "W7",
        ROUNDS,
        "C absolute",
        candidates,
        &accurate,
        &|outcome, seconds| {
            format!(
                "{:.1} µs, {} evaluations, error {:.1e}",
                seconds * 1e6,
                outcome.evaluations,
                error(outcome)
            )
        },
    );
}
