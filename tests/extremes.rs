//! Any parameter set gives an error value or a run: never a panic, never a hang.

mod support;

use std::time::{Duration, Instant};

use flexure_runtime::simulate::simulate;
use flexure_runtime::system::System;
use flexure_runtime::tape::TapeModel;
use support::four_bars::Layout;
use support::random::Random;
use support::{MECHANISMS, compile, mechanism, model_names, shipped, tape_model};

/// What a param is set to, besides multiples of its default.
const EXTREMES: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1e300,
    -1e300,
    1e-300,
    -1e-300,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    1e16,
    1e-16,
];

/// How parameter sets fared.
#[derive(Debug, Default)]
struct Tally {
    refused: usize,
    ran: usize,
    broke: usize,
    slowest: Duration,
}

/// Prepares and runs a few steps, adaptive and fixed.
fn attempt(model: &TapeModel, params: &[f64], tally: &mut Tally) {
    let begun = Instant::now();
    match model.prepare(params) {
        Err(problem) => {
            assert!(!problem.message.is_empty());
            assert!(!problem.message.contains('{'), "{}", problem.message);
            tally.refused += 1;
        }
        Ok(system) => {
            let mut x = vec![0.0; system.states().len()];
            let mut d = vec![0.0; system.discretes().len()];
            system.start(&mut x, &mut d);
            let adaptive = simulate(&system)
                .until(1e-5)
                .rtol(1e-6)
                .max_steps(60)
                .energy(true)
                .run();
            let fixed = simulate(&system).until(1e-5).dt(1e-6).max_steps(60).run();
            for result in [adaptive, fixed] {
                match result {
                    Ok(_) => tally.ran += 1,
                    Err(failure) => {
                        assert!(!failure.breakdown.message.is_empty());
                        tally.broke += 1;
                    }
                }
            }
        }
    }
    let took = begun.elapsed();
    tally.slowest = tally.slowest.max(took);
}

fn batter(name: &str, model: &TapeModel, random: &mut Random) {
    let defaults = model.defaults();
    let mut tally = Tally::default();
    attempt(model, &defaults, &mut tally);
    assert_eq!(tally.ran, 2, "{name}: the defaults run: {tally:?}");
    for index in 0..defaults.len() {
        let near = [
            -defaults[index],
            1e6 * defaults[index],
            1e-6 * defaults[index],
        ];
        for value in EXTREMES.iter().chain(&near) {
            let mut params = defaults.clone();
            params[index] = *value;
            attempt(model, &params, &mut tally);
        }
    }
    for _ in 0..200 {
        let mut params = defaults.clone();
        let wild = random.below(3);
        for value in &mut params {
            match (wild, random.below(4)) {
                (0, 0) | (1, _) => *value = EXTREMES[random.below(EXTREMES.len())],
                (2, _) => {
                    *value *= random.scale(1e-12, 1e12) * if random.coin() { 1.0 } else { -1.0 }
                }
                _ => {}
            }
        }
        attempt(model, &params, &mut tally);
    }
    println!("{name}: {tally:?}");
}

#[test]
fn every_model_survives_any_parameters() {
    let mut random = Random::new(3);
    for name in model_names() {
        batter(&name, &tape_model(&shipped(&name)), &mut random);
    }
}

#[test]
fn other_mechanisms_survive_any_parameters() {
    let mut random = Random::new(5);
    for name in MECHANISMS {
        batter(name, &tape_model(&mechanism(name)), &mut random);
    }
}

#[test]
fn a_four_bar_with_everything_on_it_survives_any_parameters() {
    let mut random = Random::new(4);
    let layouts = Layout::all();
    for layout in [layouts[0], layouts[16]] {
        let compiled = compile("four_bar.flex", &layout.text());
        batter("four-bar", &tape_model(&compiled), &mut random);
    }
}
