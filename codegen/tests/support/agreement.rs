//! Whether a system computes what the oracle computes, to rounding, at random states.

use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::symbolic::Expr;
use flexure_runtime::system::System;

use super::oracle::Oracle;
use super::random::Random;

/// How far an evaluator may be off, in units of the condition sum.
const ROUNDING: f64 = 1e-13;
/// States where rounding alone decides are drawn again.
const ILL_CONDITIONED: f64 = 1e10;

/// Compares one function at the oracle's place; returns how many values were too ill conditioned
/// to say anything.
fn agree(oracle: &mut Oracle<'_>, what: &str, exprs: &[Expr], values: &[f64]) -> usize {
    let mut skipped = 0;
    for (index, (expr, value)) in exprs.iter().zip(values).enumerate() {
        let expected = oracle.condition(*expr);
        if expected.value.is_nan() {
            assert!(value.is_nan(), "{what} {index}: {value} is not NaN");
        } else if expected.sum > ILL_CONDITIONED * expected.value.abs() && expected.value != 0.0 {
            skipped += 1;
        } else {
            let error = (value - expected.value).abs();
            assert!(
                error <= ROUNDING * expected.sum.max(expected.value.abs()),
                "{what} {index}: {value:e} is not {:e}, S = {:e}",
                expected.value,
                expected.sum
            );
        }
    }
    skipped
}

/// Margins below this are those of Newton blocks: a tolerance of 1e-12 of the loops' size in m, less
/// what the last step leaves.
const NEWTON_MARGIN: f64 = 1e-11;

/// A place where functions are compared.
#[derive(Clone, Debug)]
pub struct Place {
    pub t: f64,
    pub x: Vec<f64>,
    pub d: Vec<f64>,
    pub u: Vec<f64>,
    /// Drawn from the widest range: angles half a radian, rates tens of radians per second about
    /// the start, or at least a tenth of that.
    pub far: bool,
}

/// Random places about the start of `system`: near and far, for angles up to half a radian.
pub fn places(system: &dyn System, count: usize, seed: u64) -> Vec<Place> {
    let mut random = Random::new(seed);
    let (mut x0, mut d0) = (
        vec![0.0; system.states().len()],
        vec![0.0; system.discretes().len()],
    );
    system.start(&mut x0, &mut d0);
    (0..count)
        .map(|_| {
            let reach = random.scale(1e-6, 1.0);
            Place {
                t: random.between(0.0, 1e-3),
                far: reach > 0.1,
                x: x0
                    .iter()
                    .zip(system.states())
                    .map(|(x, row)| {
                        // Rates move faster than coordinates, bristles bend by micrometres.
                        let scale = match row.unit.as_ref() {
                            "rad" => 0.5,
                            "m" => 1e-4,
                            "m/s" => 0.1,
                            _ => 30.0,
                        };
                        x + random.between(-1.0, 1.0) * scale * reach
                    })
                    .collect(),
                d: d0
                    .iter()
                    .zip(system.discretes())
                    .map(|(d, row)| match row.unit.as_ref() {
                        "rad" => d + 0.1 * random.between(-1.0, 1.0),
                        _ => d + f64::from(u8::from(random.between(-1.0, 1.0) > 0.0)),
                    })
                    .collect(),
                u: system
                    .inputs()
                    .iter()
                    .map(|_| random.between(-1.0, 1.0))
                    .collect(),
            }
        })
        .collect()
}

/// Compares other rates of `system` than its own at the same kind of places.
pub fn compare_rates(
    equations: &Equations,
    params: &[f64],
    system: &dyn System,
    rates: &dyn Fn(&Place) -> Vec<f64>,
) {
    let mut oracle = Oracle::new(equations, params);
    let expected: Vec<Expr> = equations.states.iter().map(|s| s.rate).collect();
    let mut compared = 0;
    for place in places(system, 200, 13) {
        let found = rates(&place);
        let Place { t, x, d, u, .. } = &place;
        oracle.place(*t, x, d, u);
        // Where a loop cannot close, or hardly, there is nothing to compare.
        let mut closures = vec![0.0; equations.loops.len()];
        system.closures(*t, x, d, u, &mut closures);
        if closures.iter().all(|closure| *closure > 1e-6) {
            agree(&mut oracle, "rate", &expected, &found);
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared} states compared");
}

/// Compares every function of `system`, which is `equations` at the parameter set `params`.
pub fn compare(equations: &Equations, params: &[f64], system: &dyn System, states: usize) {
    let mut oracle = Oracle::new(equations, params);
    let (mut x0, mut d0) = (
        vec![0.0; system.states().len()],
        vec![0.0; system.discretes().len()],
    );
    system.start(&mut x0, &mut d0);
    let initial: Vec<Expr> = equations.states.iter().map(|s| s.initial).collect();
    agree(&mut oracle, "start", &initial, &x0);
    // Functions of closure have units of their own: they count against their values at the start.
    let mut assembled = vec![0.0; equations.loops.len()];
    let held = vec![0.0; equations.inputs.len()];
    system.closures(0.0, &x0, &d0, &held, &mut assembled);
    let (mut skipped, mut open, mut moved) = (0, 0, 0);
    for place in places(system, states, 7) {
        let Place { t, x, d, u, far } = &place;
        let t = *t;
        oracle.place(t, x, d, u);
        let mut out = vec![0.0; equations.loops.len()];
        system.closures(t, x, d, u, &mut out);
        // Where a loop cannot close there is nothing to compare.
        let mut closures = out.iter().zip(&assembled);
        if !closures.all(|(closure, assembled)| *closure > 1e-6 * assembled) {
            open += 1;
            continue;
        }
        moved += usize::from(*far);
        let mut out = vec![0.0; x.len()];
        system.rhs(t, x, d, u, &mut out);
        let rates: Vec<Expr> = equations.states.iter().map(|s| s.rate).collect();
        skipped += agree(&mut oracle, "rate", &rates, &out);
        let mut out = vec![0.0; equations.outputs.len()];
        system.outputs(t, x, d, u, &mut out);
        let outputs: Vec<Expr> = equations.outputs.iter().map(|o| o.value).collect();
        skipped += agree(&mut oracle, "output", &outputs, &out);
        let energy = system.energy(t, x, d, u);
        let expected = &equations.energy;
        skipped += agree(
            &mut oracle,
            "energy",
            &[
                expected.kinetic,
                expected.potential,
                expected.dissipated_power,
                expected.supplied_power,
            ],
            &[
                energy.kinetic,
                energy.potential,
                energy.dissipated_power,
                energy.supplied_power,
            ],
        );
        let mut out = vec![0.0; system.kink_count()];
        system.next_kinks(d, &mut out);
        let kinks: Vec<Expr> = equations.kinks.iter().map(|k| k.next).collect();
        skipped += agree(&mut oracle, "kink", &kinks, &out);
        let mut out = vec![0.0; system.event_count()];
        system.events(t, x, d, u, &mut out);
        let events: Vec<Expr> = equations.events.iter().map(|e| e.function).collect();
        skipped += agree(&mut oracle, "event", &events, &out);
        let mut out = vec![0.0; system.loop_count()];
        system.closures(t, x, d, u, &mut out);
        for (closure, value) in equations.loops.iter().zip(&out) {
            // What Newton's method leaves is rounding itself: only its sign says something.
            if value.abs() < NEWTON_MARGIN {
                let expected = oracle.condition(closure.closure).value;
                assert_eq!(*value > 0.0, expected > 0.0, "closure {}", closure.name);
            } else {
                skipped += agree(&mut oracle, "closure", &[closure.closure], &[*value]);
            }
        }
        for (index, kink) in equations.kinks.iter().enumerate() {
            let mut after = d.clone();
            system.pass_kink(index, &mut after);
            for (position, value) in &kink.updates {
                agree(
                    &mut oracle,
                    "update",
                    &[*value],
                    &after[*position..=*position],
                );
            }
        }
        let mut after = d.clone();
        system.accept(t, x, u, &mut after);
        for (position, discrete) in equations.discretes.iter().enumerate() {
            match discrete.accepted {
                Some(value) => {
                    agree(
                        &mut oracle,
                        "accepted",
                        &[value],
                        &after[position..=position],
                    );
                }
                None => assert_eq!(after[position], d[position]),
            }
        }
    }
    println!(
        "{}: {states} states, {moved} far from the start, {open} do not close, {skipped} values ill conditioned",
        equations.name
    );
    assert!(2 * open < states, "most states do not close");
    assert!(
        20 * moved > states,
        "hardly any state is far from the start"
    );
}
