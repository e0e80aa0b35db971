//! Derived equations against the same mechanism in absolute coordinates with Lagrange multipliers.
//!
//! `support::multipliers` shares the parser and the resolved model with the compiler, and nothing
//! after it. Accelerations are compared at random states, where a wrong lever arm, ratio of rates,
//! sign or branch shows.

mod support;

use std::collections::BTreeMap;

use flexure_model_dsl::model::BodyKind;
use flexure_model_dsl::structure::{Step, structure};
use support::four_bars::Layout;
use support::grown::{Grown, grown};
use support::random::Random;
use support::twin::{Tally, Twin, compare, random_state};
use support::windows::{Lengths, windows};
use support::{Compiled, MECHANISMS, compile, mechanism, shipped, try_compile};

/// The article's actuator: as printed, with the contact far out on the coupler, and with a linkage
/// whose coupler turns about as fast as the crank.
#[test]
fn double_rocker_at_random_states() {
    let compiled = shipped("double_rocker");
    let cases: [(&str, &[(&str, f64)]); 4] = [
        ("nominal", &[]),
        ("ln = 15 mm", &[("ln", 15e-3)]),
        (
            "coupler as fast as the crank",
            &[("l2", 9e-3), ("l3", 12e-3), ("l4", 19.12e-3), ("ln", 15e-3)],
        ),
        (
            "centres of mass off their lines",
            &[
                ("beta1", 0.3),
                ("beta2", -0.5),
                ("beta3", 0.8),
                ("ln", 15e-3),
            ],
        ),
    ];
    for (index, (name, changes)) in cases.iter().enumerate() {
        let tally = compare(&compiled, changes, changes, 300, 0.15, index as u64)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        println!("{name}: {tally:?}");
        assert!(tally.states >= 200, "{name}: {tally:?}");
        assert!(tally.rejected * 10 <= tally.states, "{name}: {tally:?}");
    }
}

/// Thousands of four-bars of every Grashof type, both branches, every link as the coordinate,
/// links drawn either way, masses off their lines, point masses, springs, loads and contacts.
#[test]
fn random_four_bars() {
    let mut random = Random::new(7);
    let mut tally = Tally::default();
    let mut seen = [[0usize; 2]; 4];
    let mut failures = Vec::new();
    for layout in Layout::all() {
        let text = layout.text();
        let compiled = compile("four_bar.flex", &text);
        let mut linkages = 0;
        while linkages < LINKAGES_EACH {
            let Some(dimensions) = layout.dimensions(&mut random) else {
                continue;
            };
            linkages += 1;
            seen[dimensions.grashof][usize::from(dimensions.branch)] += 1;
            let seed = random.bits();
            match compare(
                &compiled,
                &dimensions.values,
                &dimensions.closed,
                2,
                0.3,
                seed,
            ) {
                Ok(part) => tally.join(&part),
                Err(error) => failures.push(format!("{error}\n{layout:?} {:?}", dimensions.values)),
            }
        }
    }
    println!("{tally:?}");
    println!(
        "Grashof types (shortest: ground, crank or rocker, coupler; none turns) by branch: {seen:?}"
    );
    println!("{} linkages differ", failures.len());
    failures.truncate(5);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(tally.states > 2000, "{tally:?}");
    assert!(tally.rejected * 5 < tally.states, "{tally:?}");
    assert!(tally.unreachable * 3 < tally.states, "{tally:?}");
    assert!(seen.iter().flatten().all(|count| *count > 20), "{seen:?}");
}

/// A crank that has turned several times: springs still measure from the assembled configuration.
#[test]
fn after_many_turns() {
    let layout = Layout::all()[0];
    let compiled = compile("four_bar.flex", &layout.text());
    let crank_rocker = [
        ("gx", 25e-3),
        ("l1", 10e-3),
        ("l2", 23e-3),
        ("l3", 20e-3),
        ("a2", 0.5),
    ];
    let tally = compare(&compiled, &crank_rocker, &crank_rocker, 60, 25.0, 17)
        .unwrap_or_else(|error| panic!("{error}"));
    println!("after up to four turns: {tally:?}");
    assert_eq!((tally.states, tally.unreachable), (60, 0));
    assert!(tally.rejected < 6, "{tally:?}");
}

/// Mechanisms that are no four-bars: guides that turn, coupled inertia, slides that carry links and
/// slides, contacts that follow the approach. Params are scattered about their defaults.
#[test]
fn other_mechanisms() {
    let mut random = Random::new(5);
    for name in MECHANISMS {
        let compiled = mechanism(name);
        let mut tally = Tally::default();
        for _ in 0..60 {
            let mut params = compiled.oracle.defaults();
            for value in &mut params {
                *value *= random.scale(0.7, 1.4);
            }
            let names = compiled.model.params.iter().map(|p| p.name.as_str());
            let changes: Vec<(&str, f64)> = names.zip(params.iter().copied()).collect();
            match compare(&compiled, &changes, &changes, 5, 0.6, random.bits()) {
                Ok(part) => tally.join(&part),
                Err(error) => panic!("{name} with {changes:?}: {error}"),
            }
        }
        println!("{name}: {tally:?}");
        assert!(tally.states >= 290, "{name}: {tally:?}");
        assert!(tally.rejected * 5 <= tally.states, "{name}: {tally:?}");
    }
}

/// The linkages and stages among this repository's models, with their params scattered: several
/// loops, several coordinates, slides in loops, parallelograms, and loops that close together.
#[test]
fn linkages_and_stages() {
    let names = [
        "andrews",
        "bridge_amplifier",
        "double_parallelogram_stage",
        "five_bar",
        "n_windows_1",
        "n_windows_2",
        "parallelogram_stage",
        "six_bar",
        "slider_crank",
        "three_rrr",
        "three_rrr_cranks",
        "xy_stage",
    ];
    let mut random = Random::new(31);
    for name in names {
        let compiled = shipped(name);
        let mut tally = Tally::default();
        let mut unassembled = 0;
        for _ in 0..SETS_EACH {
            let mut params = compiled.oracle.defaults();
            for value in &mut params {
                *value *= random.scale(0.97, 1.03);
            }
            let names = compiled.model.params.iter().map(|p| p.name.as_str());
            let changes: Vec<(&str, f64)> = names.zip(params.iter().copied()).collect();
            if compiled.oracle.prepare(&params).is_err() {
                unassembled += 1;
                continue;
            }
            match compare(&compiled, &changes, &changes, 5, 0.1, random.bits()) {
                Ok(part) => tally.join(&part),
                Err(error) => panic!("{name} with {changes:?}: {error}"),
            }
        }
        println!("{name}: {tally:?}, {unassembled} unassembled");
        assert!(tally.states >= 4 * SETS_EACH, "{name}: {tally:?}");
        assert!(tally.rejected * 5 <= tally.states, "{name}: {tally:?}");
    }
}

/// Chains of four-bars in which each loop follows from the one before, up to six of them.
#[test]
fn chains_of_windows() {
    for lengths in [Lengths::Equal, Lengths::Unequal] {
        for count in [1, 3, 6] {
            let compiled = compile("windows.flex", &windows(count, lengths));
            let tally = compare(&compiled, &[], &[], 20, 0.5, count as u64)
                .unwrap_or_else(|error| panic!("{count} windows, {lengths:?}: {error}"));
            println!("{count} windows, {lengths:?} lengths: {tally:?}");
            assert_eq!((tally.states, tally.unreachable), (20, 0), "{tally:?}");
            assert!(tally.rejected <= 4, "{tally:?}");
        }
    }
}

/// What a mechanism has, for the count of what was compared.
fn kinds(compiled: &Compiled, grown: &Grown) -> Vec<String> {
    let model = &compiled.model;
    let structure = structure(model).expect("a mechanism");
    let is_slide = |body: usize| matches!(model.bodies[body].kind, BodyKind::Slide(_));
    let carrier = |body: usize| match &model.bodies[body].kind {
        BodyKind::Slide(slide) => Some(slide.carrier),
        _ => None,
    };
    let mut kinds: Vec<String> = grown.features.iter().map(|f| (*f).to_owned()).collect();
    for step in &structure.steps {
        let kind = match step {
            Step::Close { unknowns, .. } => {
                let [a, b] = *unknowns;
                let carried = carrier(a) == Some(b) || carrier(b) == Some(a);
                match (is_slide(a), is_slide(b), carried) {
                    (false, false, _) => "RRR",
                    (true, true, true) => "RPP",
                    (true, true, false) => "PRP",
                    (_, _, true) => "RPR",
                    (_, _, false) => "RRP",
                }
            }
            Step::Redundant { .. } => "redundant",
            Step::Together { .. } => "Newton block",
        };
        kinds.push(kind.to_owned());
    }
    kinds.push(format!("{} loops", grown.loops));
    kinds.push(format!("{} coordinates", grown.coordinates));
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

/// Mechanisms grown loop by loop: one to four loops, one to three coordinates, every kind of dyad.
#[test]
fn mechanisms_grown_loop_by_loop() {
    let mut random = Random::new(GROWN_SEED);
    let mut tally = Tally::default();
    let mut coverage: BTreeMap<String, usize> = BTreeMap::new();
    let (mut unassembled, mut mechanisms) = (0, 0);
    let mut failures: Vec<String> = Vec::new();
    while mechanisms < GROWN {
        let (loops, coordinates) = (1 + mechanisms % 4, 1 + mechanisms / 4 % 3);
        let Some(grown) = grown(&mut random, loops, coordinates) else {
            continue;
        };
        mechanisms += 1;
        let compiled = match try_compile("grown.flex", &grown.text) {
            Ok(compiled) => compiled,
            Err(error) => {
                failures.push(format!("{error}\n{}", grown.text));
                continue;
            }
        };
        let params = compiled.params(&[]);
        let mut twin = match Twin::new(&compiled, &params, &params) {
            Ok(twin) => twin,
            Err(error) => {
                unassembled += 1;
                println!("unassembled: {error}");
                continue;
            }
        };
        let start = twin.prepared.start.clone();
        let mut part = Tally::default();
        for _ in 0..STATES_GROWN {
            let mut state = random_state(&compiled, &start, &mut random, 0.3);
            for (coordinate, value, rate) in compiled.coordinates() {
                if matches!(compiled.model.bodies[coordinate].kind, BodyKind::Slide(_)) {
                    state[value] = start[value] + random.between(-3e-3, 3e-3);
                    state[rate] = random.between(-2.0, 2.0);
                }
            }
            if let Err(error) = twin.compare(0.0, &state, 1e6, &mut part) {
                failures.push(format!("at {state:?}: {error}\n{}", grown.text));
                break;
            }
        }
        for kind in kinds(&compiled, &grown) {
            *coverage.entry(kind).or_default() += part.states - part.rejected;
        }
        tally.join(&part);
    }
    println!("{mechanisms} mechanisms, {unassembled} not assembled, {tally:?}");
    for (kind, count) in &coverage {
        println!("  {kind}: {count} states");
    }
    println!("{} mechanisms differ", failures.len());
    failures.truncate(SHOWN);
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    for kind in COVERED {
        let count = coverage.get(kind).copied().unwrap_or(0);
        assert!(count >= 200, "{kind}: compared at {count} states only");
    }
    assert!(
        unassembled * 10 <= mechanisms,
        "{unassembled} not assembled"
    );
    assert!(tally.rejected * 4 <= tally.states, "{tally:?}");
}

/// What grown mechanisms must cover.
const COVERED: [&str; 18] = [
    "1 coordinates",
    "1 loops",
    "2 coordinates",
    "2 loops",
    "3 coordinates",
    "3 loops",
    "4 loops",
    "Newton block",
    "PRP",
    "RPP",
    "RPR",
    "RRP",
    "RRR",
    "contact",
    "moving guide",
    "off-axis mass",
    "stack",
    "ternary body",
];

/// Mechanisms grown, states of each, the seed, and how many failures are shown in full.
const GROWN: usize = 156;
const STATES_GROWN: usize = 12;
const GROWN_SEED: u64 = 2;
const SHOWN: usize = 3;

/// Parameter sets compared for each linkage.
const SETS_EACH: usize = 30;

/// Four-bars compared for each layout.
const LINKAGES_EACH: usize = 90;
