//! Derived equations against the same mechanism in absolute coordinates with Lagrange multipliers.
//!
//! `support::multipliers` shares the parser and the resolved model with the compiler, and nothing
//! after it. Accelerations are compared at random states, where a wrong lever arm, ratio of rates,
//! sign or branch shows; inertia, its derivative and the potential's derivative are compared with
//! finite differences of the energies in absolute coordinates.

mod support;

use std::collections::BTreeMap;

use flexure_model_dsl::model::BodyKind;
use flexure_model_dsl::structure::{Step, structure};
use support::four_bars::{Dimensions, Layout};
use support::grown::{Grown, grown};
use support::multipliers::{Assembly, Mechanism, Surroundings};
use support::oracle::Prepared;
use support::random::Random;
use support::windows::{Lengths, windows};
use support::{Compiled, MECHANISMS, compile, mechanism, shipped, try_compile};

/// How a comparison of many states went.
#[derive(Debug, Default)]
struct Tally {
    states: usize,
    /// The accelerations' terms cancel, or the bordered system is ill-conditioned.
    rejected: usize,
    /// The path to the state meets a dead point.
    unreachable: usize,
    worst: f64,
    condition: f64,
}

impl Tally {
    fn join(&mut self, other: &Tally) {
        self.states += other.states;
        self.rejected += other.rejected;
        self.unreachable += other.unreachable;
        self.worst = self.worst.max(other.worst);
        self.condition = self.condition.max(other.condition);
    }
}

/// A random state, by the states' names and units.
fn random_state(compiled: &Compiled, start: &[f64], random: &mut Random, turn: f64) -> Vec<f64> {
    let states = &compiled.oracle.equations.states;
    states
        .iter()
        .zip(start)
        .map(|(state, start)| match state.unit.as_str() {
            "rad" => start + random.between(-turn, turn),
            "rad/s" => random.between(-100.0, 100.0),
            "m" if state.name.ends_with(".z") => random.between(-1e-6, 1e-6),
            "m" => start + random.between(-1e-4, 1e-4),
            "m/s" => random.between(-0.5, 0.5),
            unit => panic!("a state in `{unit}`"),
        })
        .collect()
}

/// Brings both formulations to one state; `None` where the path there meets a dead point.
struct Twin<'a> {
    compiled: &'a Compiled,
    mechanism: Mechanism<'a>,
    assembly: Assembly,
    prepared: Prepared<'a>,
}

impl<'a> Twin<'a> {
    /// With params for the derived equations, and the same with all guesses as they are where the
    /// mechanism closes, for the independent formulation, which then cannot go to another branch.
    fn new(compiled: &'a Compiled, params: &[f64], closed: &[f64]) -> Result<Self, String> {
        let mechanism = Mechanism::new(&compiled.model, closed);
        let bodies: Vec<usize> = compiled.coordinates().iter().map(|c| c.0).collect();
        let assembly = mechanism.assemble(&bodies)?;
        let prepared = compiled.oracle.prepare(params)?;
        let twin = Self {
            compiled,
            mechanism,
            assembly,
            prepared,
        };
        let closed = twin.mechanism.assembled_values(&twin.assembly);
        for ((_, value, _), closed) in compiled.coordinates().iter().zip(closed) {
            let start = twin.prepared.start[*value];
            let turns = (start - closed) / std::f64::consts::TAU;
            let off = if compiled.oracle.equations.states[*value].unit == "rad" {
                (turns - turns.round()).abs()
            } else {
                (start - closed).abs()
            };
            if off > 1e-9 {
                return Err(format!("assembled at {start}, independently at {closed}"));
            }
        }
        Ok(twin)
    }

    /// Positions and velocities in absolute coordinates.
    fn absolute(&self, state: &[f64]) -> Result<(Vec<f64>, Vec<f64>), String> {
        let coordinates = self.compiled.coordinates();
        let closed = self.mechanism.assembled_values(&self.assembly);
        // Both count angles from the assembled configuration: a difference of whole turns is none.
        let values: Vec<f64> = coordinates
            .iter()
            .zip(&closed)
            .map(|((_, value, _), closed)| closed + state[*value] - self.prepared.start[*value])
            .collect();
        let rates: Vec<f64> = coordinates
            .iter()
            .map(|(_, _, rate)| state[*rate])
            .collect();
        let q = self.mechanism.configuration(&self.assembly, &values)?;
        let v = self.mechanism.velocities(&self.assembly, &q, &rates)?;
        Ok((q, v))
    }

    fn surroundings(&self, time: f64, state: &[f64]) -> Surroundings {
        let equations = &self.compiled.oracle.equations;
        let memory = equations.discretes.iter().zip(&self.prepared.discretes);
        Surroundings {
            time,
            inputs: Vec::new(),
            memory: memory.map(|(d, value)| (d.name.clone(), *value)).collect(),
            bristles: self.compiled.bristles().iter().map(|&z| state[z]).collect(),
        }
    }

    /// Compares all accelerations at one state; states with a greater condition number than
    /// `most_condition` are counted and left out, because the reference loses digits there.
    fn compare(
        &mut self,
        time: f64,
        state: &[f64],
        most_condition: f64,
        tally: &mut Tally,
    ) -> Result<(), String> {
        let Ok((q, v)) = self.absolute(state) else {
            tally.unreachable += 1;
            return Ok(());
        };
        self.prepared.follow(time, state);
        self.prepared.settle();
        let surroundings = self.surroundings(time, state);
        let motion = self
            .mechanism
            .accelerations(&self.assembly, &surroundings, &q, &v)?;
        let rates = self.prepared.rates();
        tally.states += 1;
        if motion.condition > most_condition {
            tally.rejected += 1;
            return Ok(());
        }
        let mut rejected = false;
        let mut worst: f64 = 0.0;
        for (index, (_, _, rate)) in self.compiled.coordinates().iter().enumerate() {
            let (derived, reference) = (rates[*rate], motion.coordinates[index]);
            if reference.abs() < 1e-3 * motion.magnitudes[index] {
                rejected = true;
                continue;
            }
            worst = worst.max((derived - reference).abs() / reference.abs());
            if !derived.is_finite() {
                return Err(format!("acceleration {derived}, independently {reference}"));
            }
        }
        for (z, reference) in self.compiled.bristles().iter().zip(&motion.bristle_rates) {
            let slip = rates[*z];
            // The bristle's rate is a difference of two terms: compare on the larger one's scale.
            let scale = reference.abs().max(1e-3);
            worst = worst.max((slip - reference).abs() / scale);
        }
        if rejected {
            tally.rejected += 1;
        } else {
            tally.worst = tally.worst.max(worst);
            tally.condition = tally.condition.max(motion.condition);
            if worst > 1e-9 {
                return Err(format!(
                    "differ by {worst:e} (condition {:e}): derived {:?}, independently {:?}",
                    motion.condition,
                    self.compiled
                        .coordinates()
                        .iter()
                        .map(|c| rates[c.2])
                        .collect::<Vec<f64>>(),
                    motion.coordinates
                ));
            }
        }
        Ok(())
    }
}

/// Compares accelerations at random states of one parameter set.
fn compare(
    compiled: &Compiled,
    changes: &[(&str, f64)],
    closed: &[(&str, f64)],
    states: usize,
    turn: f64,
    seed: u64,
) -> Result<Tally, String> {
    let params = compiled.params(changes);
    let mut twin = Twin::new(compiled, &params, &compiled.params(closed))?;
    let mut tally = Tally::default();
    let mut random = Random::new(seed);
    let start = twin.prepared.start.clone();
    for _ in 0..states {
        let state = random_state(compiled, &start, &mut random, turn);
        let time = random.between(0.0, 0.9e-3);
        twin.compare(time, &state, 1e7, &mut tally)
            .map_err(|error| format!("at t = {time}, state {state:?}: {error}"))?;
    }
    Ok(tally)
}

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

/// Derivative of `f` at 0 by central differences with steps `h`, `h/2`, `h/4`, `h/8`, extrapolated.
/// Also by how much the last extrapolation changed it.
fn slope(h: f64, f: &mut dyn FnMut(f64) -> Result<f64, String>) -> Result<(f64, f64), String> {
    let mut line: Vec<f64> = Vec::new();
    for row in 0..4 {
        let step = h / f64::from(1 << row);
        let mut next = vec![(f(step)? - f(-step)?) / (2.0 * step)];
        for (column, above) in line.iter().enumerate() {
            let factor = 4f64.powi(column as i32 + 1);
            next.push(next[column] + (next[column] - above) / (factor - 1.0));
        }
        line = next;
    }
    Ok((line[3], (line[3] - line[2]).abs()))
}

/// A, ∂A/∂q and ∂P/∂q of one four-bar at one configuration against energies in absolute
/// coordinates. The derived terms are taken from what equations do, not from what they are called:
/// A from the kinetic energy at unit rate, ∂P/∂q from the acceleration at rest without loads,
/// ∂A/∂q from the mean of the accelerations at two opposite rates, in which damping cancels.
///
/// The worst of their errors; `None` where a dead point is so near that finite differences say
/// nothing.
fn compare_energies(
    compiled: &Compiled,
    dimensions: &Dimensions,
    random: &mut Random,
) -> Result<Option<f64>, String> {
    let unloaded = |values: &[(&'static str, f64)]| {
        let mut changes = values.to_vec();
        for load in ["fx", "fy", "torque1", "torque2", "stroke"] {
            changes.push((load, 0.0));
        }
        compiled.params(&changes)
    };
    let params = unloaded(&dimensions.values);
    let mut twin = Twin::new(compiled, &params, &unloaded(&dimensions.closed))?;
    let (_, value, rate) = compiled.coordinates()[0];
    let mut state = twin.prepared.start.clone();
    state[value] += random.between(-0.05, 0.05);
    state[rate] = 1.0;
    let surroundings = twin.surroundings(0.0, &state);
    let Ok((q, _)) = twin.absolute(&state) else {
        return Ok(None);
    };
    let here = twin.mechanism.assembled_values(&twin.assembly)[0] + state[value]
        - twin.prepared.start[value];
    let energies = |shift: f64| {
        let q = twin.mechanism.beside(&twin.assembly, &q, &[here + shift])?;
        let v = twin.mechanism.velocities(&twin.assembly, &q, &[1.0])?;
        Ok::<_, String>(
            twin.mechanism
                .energies(&twin.assembly, &surroundings, &q, &v),
        )
    };
    let inertia = 2.0 * energies(0.0)?.kinetic;
    let potential = energies(0.0)?.potential;
    let h = 2e-3;
    let (Ok((inertia_slope, inertia_doubt)), Ok((potential_slope, potential_doubt))) = (
        slope(h, &mut |shift| Ok(2.0 * energies(shift)?.kinetic)),
        slope(h, &mut |shift| Ok(energies(shift)?.potential)),
    ) else {
        return Ok(None);
    };
    let torque = potential_slope.abs().max(params_scale(compiled, &params));
    let inertia_change = inertia_slope.abs().max(inertia);
    if inertia_doubt > 1e-9 * inertia_change || potential_doubt > 1e-9 * torque {
        return Ok(None);
    }

    let mut derived = |rate_value: f64| {
        let mut state = state.clone();
        state[rate] = rate_value;
        twin.prepared.follow(0.0, &state);
        let acceleration = twin.prepared.rates()[rate];
        (acceleration, twin.prepared.energy())
    };
    let (at_rest, (_, derived_potential)) = derived(0.0);
    let (_, (derived_kinetic, _)) = derived(1.0);
    // Fast enough that the velocity terms are as large as the others.
    let fast = (potential_slope.abs() / inertia).sqrt().max(10.0);
    let mean = 0.5 * (derived(fast).0 + derived(-fast).0);
    let start = twin.prepared.start.clone();
    twin.prepared.follow(0.0, &start);
    let derived_rise = derived_potential - twin.prepared.energy().1;
    let assembled = twin
        .mechanism
        .energies(
            &twin.assembly,
            &surroundings,
            &twin.assembly.positions,
            &vec![0.0; q.len()],
        )
        .potential;
    let derived_inertia = 2.0 * derived_kinetic;
    let derived_potential_slope = -derived_inertia * at_rest;
    let derived_inertia_slope = -2.0 * derived_inertia * (mean - at_rest) / (fast * fast);

    let mut worst: f64 = 0.0;
    let mut judge = |what: &str, derived: f64, reference: f64, scale: f64| {
        let error = (derived - reference).abs() / scale;
        worst = worst.max(error);
        if error < 1e-8 {
            Ok(())
        } else {
            Err(format!(
                "{what}: derived {derived:e}, from energies {reference:e} (scale {scale:e})"
            ))
        }
    };
    judge("A", derived_inertia, inertia, inertia)?;
    judge(
        "∂A/∂q",
        derived_inertia_slope,
        inertia_slope,
        inertia_change,
    )?;
    judge("∂P/∂q", derived_potential_slope, potential_slope, torque)?;
    judge("P", derived_rise, potential - assembled, torque)?;
    Ok(Some(worst))
}

/// A torque to measure rounding by: hinges at a few hundredths of a radian.
fn params_scale(compiled: &Compiled, params: &[f64]) -> f64 {
    let names = ["k1", "k2", "k3", "k4"];
    let stiffness = compiled.model.params.iter().zip(params);
    let sum: f64 = stiffness
        .filter(|(param, _)| names.contains(&param.name.as_str()))
        .map(|(_, value)| value)
        .sum();
    0.02 * sum
}

/// The derived terms of thousands of four-bars against finite differences of energies.
#[test]
fn derived_terms_of_random_four_bars() {
    let mut random = Random::new(11);
    let (mut count, mut rejected, mut worst): (usize, usize, f64) = (0, 0, 0.0);
    let mut failures = Vec::new();
    for layout in Layout::all() {
        let layout = Layout {
            attached: false,
            ..layout
        };
        let compiled = compile("four_bar.flex", &layout.text());
        let mut linkages = 0;
        while linkages < LINKAGES_EACH {
            let Some(dimensions) = layout.dimensions(&mut random) else {
                continue;
            };
            linkages += 1;
            match compare_energies(&compiled, &dimensions, &mut random) {
                Ok(None) => rejected += 1,
                Ok(Some(error)) => {
                    count += 1;
                    worst = worst.max(error);
                }
                Err(error) => failures.push(format!("{error}\n{layout:?} {:?}", dimensions.values)),
            }
        }
    }
    println!(
        "{count} linkages, worst {worst:e}, {rejected} too near a dead point, {} differ",
        failures.len()
    );
    failures.truncate(5);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(count >= 1200);
}
