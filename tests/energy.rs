//! Energy balance of every model along its trajectory: kinetic and potential energy, less what
//! was supplied, plus what was dissipated, stays what it was at the start but for the error of the
//! steps. At fixed step the error shrinks with the method's order where the model is smooth, and at
//! least at first order where a contact rubs; with adaptive steps about in proportion to the
//! tolerance.
//!
//! A balance holds for any consistent derivation, also for a wrong one: what is right is shown in
//! `multipliers.rs`. Here it is shown that energies, powers and motion belong together.

mod support;

use flexure_runtime::simulate::simulate;
use flexure_runtime::tape::TapePrepared;
use support::{Compiled, MECHANISMS, mechanism, model_names, shipped, tape};

/// How a model is run.
struct Trial {
    name: &'static str,
    /// Length of the run in s.
    until: f64,
    /// Longest of the fixed steps in s.
    step: f64,
    /// How often it is halved, before rounding is all that is left.
    halvings: u32,
    /// Whether it has no friction contact.
    smooth: bool,
}

const TRIALS: [Trial; 18] = [
    Trial {
        name: "andrews",
        until: 0.02,
        step: 1e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "bridge_amplifier",
        until: 4e-3,
        step: 2e-5,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "double_parallelogram_stage",
        until: 0.1,
        step: 5e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "double_rocker",
        until: 2e-3,
        step: 1e-6,
        halvings: 3,
        smooth: false,
    },
    Trial {
        name: "five_bar",
        until: 0.05,
        step: 2e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "four_bar",
        until: 2e-3,
        step: 1e-5,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "lugre_mass",
        until: 7.6, // the first slip begins at 7.44 s
        step: 4e-4,
        halvings: 3,
        smooth: false,
    },
    Trial {
        name: "msdm",
        until: 2e-3,
        step: 1e-6,
        halvings: 3,
        smooth: false,
    },
    Trial {
        name: "n_windows_1",
        until: 1.0,
        step: 5e-3,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "n_windows_2",
        until: 1.0,
        step: 5e-3,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "n_windows_40",
        until: 1.0,
        step: 5e-3,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "parallelogram_stage",
        until: 0.05,
        step: 2e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "pendulum",
        until: 0.5,
        step: 5e-3,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "six_bar",
        until: 20e-3,
        step: 5e-5,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "slider_crank",
        until: 50e-3,
        step: 4e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "three_rrr",
        until: 40e-3,
        step: 4e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "three_rrr_cranks",
        until: 40e-3,
        step: 4e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        // The error goes as h⁴ (1 - h/30 µs): its terms of fourth and fifth order oppose each
        // other, and from 2 µs on rounding is all that is left.
        name: "xy_stage",
        until: 5e-3,
        step: 5e-6,
        halvings: 1,
        smooth: true,
    },
];

/// The mechanisms made for tests.
const MORE_TRIALS: [Trial; 7] = [
    Trial {
        name: "cart_pole",
        until: 0.3,
        step: 2e-3,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "chain",
        until: 0.2,
        step: 8e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "held_by_springs",
        until: 0.1,
        step: 4e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "pressing_arm",
        until: 4e-3,
        step: 2e-6,
        halvings: 3,
        smooth: false,
    },
    Trial {
        name: "slide_on_link",
        until: 0.05,
        step: 1e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "two_link_arm",
        until: 0.06,
        step: 6e-4,
        halvings: 3,
        smooth: true,
    },
    Trial {
        name: "xy_stage",
        until: 20e-3,
        step: 1e-5,
        halvings: 3,
        smooth: false,
    },
];

/// Every trial with its compiled model.
fn trials() -> impl Iterator<Item = (&'static Trial, Compiled)> {
    let models = TRIALS.iter().map(|trial| (trial, shipped(trial.name)));
    let more = MORE_TRIALS.iter();
    models.chain(more.map(|trial| (trial, mechanism(trial.name))))
}

/// The largest imbalance over a run, relative to the energy that was moved.
fn imbalance(system: &TapePrepared, until: f64, accuracy: Accuracy) -> f64 {
    let simulation = simulate(system).until(until).energy(true);
    let run = match accuracy {
        Accuracy::Step(step) => simulation.dt(step),
        Accuracy::Tolerance(tolerance) => simulation.rtol(tolerance),
    }
    .run()
    .unwrap_or_else(|failure| panic!("{}", failure.breakdown.message));
    let largest = |name: &str| {
        let values = run.column(name).values();
        let first = values[0];
        values
            .iter()
            .fold(0.0, |worst: f64, v| worst.max((v - first).abs()))
    };
    let moved = [
        "energy.kinetic",
        "energy.potential",
        "energy.dissipated",
        "energy.supplied",
    ]
    .iter()
    .map(|name| largest(name))
    .fold(0.0, f64::max);
    assert!(moved > 0.0, "something moves");
    largest("energy.balance") / moved
}

enum Accuracy {
    Step(f64),
    Tolerance(f64),
}

#[test]
fn every_model_has_a_trial() {
    let names: Vec<&str> = TRIALS.iter().map(|trial| trial.name).collect();
    assert_eq!(model_names(), names);
    let names: Vec<&str> = MORE_TRIALS.iter().map(|trial| trial.name).collect();
    assert_eq!(MECHANISMS, *names);
}

#[test]
fn fixed_steps() {
    let mut failures = Vec::new();
    for (trial, compiled) in trials() {
        let system = tape(&compiled, &[]);
        let errors: Vec<f64> = (0..=trial.halvings)
            .map(|k| {
                let step = trial.step / f64::from(1 << k);
                imbalance(&system, trial.until, Accuracy::Step(step))
            })
            .collect();
        println!("{}: {errors:?}", trial.name);
        let order = (errors[0] / errors[errors.len() - 1]).log2() / f64::from(trial.halvings);
        println!("{}: order {order}", trial.name);
        let least = if trial.smooth { 3.8 } else { 1.0 };
        if order < least {
            failures.push(format!("{}: order {order}, {errors:?}", trial.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn adaptive_steps() {
    let mut failures = Vec::new();
    for (trial, compiled) in trials() {
        let system = tape(&compiled, &[]);
        let tolerances = [1e-5, 1e-7, 1e-9];
        let errors: Vec<f64> = tolerances
            .iter()
            .map(|&tolerance| imbalance(&system, trial.until, Accuracy::Tolerance(tolerance)))
            .collect();
        println!("{}: {errors:?}", trial.name);
        let order = (errors[0] / errors[2]).log10() / 4.0;
        println!(
            "{}: error goes as tolerance to the power {order}",
            trial.name
        );
        let least = if trial.smooth { 0.8 } else { 0.5 };
        if order < least || errors[2] >= 1e-6 {
            failures.push(format!("{}: power {order}, {errors:?}", trial.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Without this the trial of the pressing arm would say nothing of lifting off.
#[test]
fn the_pressing_arm_lifts_off() {
    let trial = MORE_TRIALS.iter().find(|t| t.name == "pressing_arm");
    let until = trial.expect("a trial").until;
    let system = tape(&mechanism("pressing_arm"), &[]);
    let run = simulate(&system).until(until).rtol(1e-8).run().unwrap();
    let events = run.summary().events.len();
    println!("{events} events");
    assert!(events >= 2, "lifts off and touches again: {events} events");
}
