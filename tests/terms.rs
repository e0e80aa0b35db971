//! Derived terms of the equations against the same mechanism in absolute coordinates: inertia, its
//! derivative and the potential's derivative are compared with finite differences of energies.

mod support;

use support::four_bars::{Dimensions, Layout};
use support::random::Random;
use support::twin::Twin;
use support::{Compiled, compile};

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
