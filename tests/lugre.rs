//! LuGre's stick–slip of a mass pulled through a spring (Canudas de Wit et al. 1995): published
//! figures, recomputed in high precision.

mod support;

use flexure_runtime::simulate::{Ending, Integrator, simulate};
use support::{compile, shipped_text, tape};

/// Relative tolerance of the runs.
const RTOL: f64 = 1e-12;

fn assert_within(what: &str, value: f64, expected: f64, tolerance: f64) {
    println!(
        "{what}: {value:.15e}, expected {expected:.15e}, off by {:.1e}",
        value - expected
    );
    assert!(
        (value - expected).abs() <= tolerance,
        "{what}: {value:e}, expected {expected:e}"
    );
}

#[test]
fn state_at_25_seconds() {
    let compiled = support::shipped("lugre_mass");
    let system = tape(&compiled, &[]);
    let run = simulate(&system)
        .until(25.0)
        .rtol(RTOL)
        .every(0.5e-3)
        .run()
        .unwrap();
    let names = names(&compiled);
    let last = |name: &str| run.column(name).last();
    assert_within("x(25 s)", last(&names.position), 1.90883919922548, 1.9e-10);
    assert_within("v(25 s)", last(&names.velocity), 9.42415459073e-6, 9.4e-16);
    assert_within("z(25 s)", last(&names.bristle), 1.18167954559e-5, 1.2e-15);
    // The largest velocity within the samples of half a millisecond.
    assert_within("v_max", run.column(&names.velocity).max(), 0.369816, 1e-6);
}

/// Both methods, and the automatic choice between them, at a common tolerance.
#[test]
fn stiff_and_explicit_steps_lead_to_the_same_state() {
    let compiled = support::shipped("lugre_mass");
    let system = tape(&compiled, &[]);
    let names = names(&compiled);
    let mut evaluations = Vec::new();
    for integrator in [
        Integrator::Explicit,
        Integrator::Stiff,
        Integrator::Automatic,
    ] {
        let simulation = simulate(&system).until(25.0).rtol(1e-9).every(25.0);
        let run = simulation.integrator(integrator).run().unwrap();
        let last = |name: &str| run.column(name).last();
        assert_within("x(25 s)", last(&names.position), 1.90883919922548, 2e-8);
        assert_within("z(25 s)", last(&names.bristle), 1.18167954559e-5, 1e-12);
        evaluations.push(run.statistics().evaluations);
    }
    println!("evaluations: {evaluations:?}");
    assert!(evaluations[2] < evaluations[0] / 2);
}

/// The times at which the mass begins to slip, located as events that end a run.
#[test]
fn slips_begin() {
    let expected = [7.437606657, 13.800326478, 20.163046299];
    // A slip lasts for about 3.4 s: between slips.
    let after = [0.0, 12.0, 18.0];
    for (expected, after) in expected.iter().zip(after) {
        let compiled = support::shipped("lugre_mass");
        let velocity = names(&compiled).velocity;
        let text = shipped_text("lugre_mass")
            + &format!(
                "\nstop when min({velocity} / (1 mm/s) - 1, t / (1 s) - {after}) > 0 \"slips\"\n"
            );
        let system = tape(&compile("lugre_mass.flex", &text), &[]);
        let run = simulate(&system)
            .until(25.0)
            .rtol(RTOL)
            .every(1.0)
            .run()
            .unwrap();
        assert!(
            matches!(run.ending(), Ending::Stopped { .. }),
            "{:?}",
            run.ending()
        );
        let time = *run.times().last().unwrap();
        assert_within("slip begins", time, *expected, 1e-9);
    }
}

struct Names {
    position: String,
    velocity: String,
    bristle: String,
}

/// The model has one slide and one contact.
fn names(compiled: &support::Compiled) -> Names {
    let states = &compiled.oracle.equations.states;
    let ending = |suffix: &str| {
        let found: Vec<_> = states.iter().filter(|s| s.name.ends_with(suffix)).collect();
        assert_eq!(found.len(), 1, "one state ends in `{suffix}`");
        found[0].name.clone()
    };
    Names {
        position: ending(".x"),
        velocity: ending(".v"),
        bristle: ending(".z"),
    }
}
