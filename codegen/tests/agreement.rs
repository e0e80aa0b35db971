//! Oracle and tape give the same numbers, to rounding, at random states.

mod support;

use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::symbolic::Expr;
use flexure_runtime::system::System;
use support::oracle::Oracle;
use support::random::Random;

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

fn check(equations: &Equations, states: usize) {
    let program = flexure_codegen::program(equations);
    let tape = flexure_codegen::tape(&program);
    let params = tape.defaults();
    let prepared = tape.prepare(&params).expect("the model can be prepared");
    let mut oracle = Oracle::new(equations, &params);
    let mut random = Random::new(7);
    let (mut x0, mut d0) = (
        vec![0.0; prepared.states().len()],
        vec![0.0; prepared.discretes().len()],
    );
    prepared.start(&mut x0, &mut d0);
    let initial: Vec<Expr> = equations.states.iter().map(|s| s.initial).collect();
    agree(&mut oracle, "start", &initial, &x0);
    let mut skipped = 0;
    for _ in 0..states {
        let x: Vec<f64> = x0
            .iter()
            .map(|x| x + random.signed() * (0.1 + x.abs()))
            .collect();
        let d: Vec<f64> = d0
            .iter()
            .map(|d| d + (3.0 * random.signed()).round())
            .collect();
        let u: Vec<f64> = prepared.inputs().iter().map(|_| random.signed()).collect();
        let t = random.signed();
        oracle.place(t, &x, &d, &u);
        let mut out = vec![0.0; x.len()];
        prepared.rhs(t, &x, &d, &u, &mut out);
        let rates: Vec<Expr> = equations.states.iter().map(|s| s.rate).collect();
        skipped += agree(&mut oracle, "rate", &rates, &out);
        let mut out = vec![0.0; equations.outputs.len()];
        prepared.outputs(t, &x, &d, &u, &mut out);
        let outputs: Vec<Expr> = equations.outputs.iter().map(|o| o.value).collect();
        skipped += agree(&mut oracle, "output", &outputs, &out);
        let energy = prepared.energy(t, &x, &d, &u);
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
        let mut out = vec![0.0; prepared.kink_count()];
        prepared.next_kinks(&d, &mut out);
        let kinks: Vec<Expr> = equations.kinks.iter().map(|k| k.next).collect();
        skipped += agree(&mut oracle, "kink", &kinks, &out);
        let mut out = vec![0.0; prepared.event_count()];
        prepared.events(t, &x, &d, &u, &mut out);
        let events: Vec<Expr> = equations.events.iter().map(|e| e.function).collect();
        skipped += agree(&mut oracle, "event", &events, &out);
        let mut out = vec![0.0; prepared.loop_count()];
        prepared.closures(t, &x, &d, &u, &mut out);
        let closures: Vec<Expr> = equations.loops.iter().map(|l| l.closure).collect();
        skipped += agree(&mut oracle, "closure", &closures, &out);
        for (index, kink) in equations.kinks.iter().enumerate() {
            let mut after = d.clone();
            prepared.pass_kink(index, &mut after);
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
        prepared.accept(t, &x, &u, &mut after);
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
        "{}: {states} states, {skipped} values ill conditioned",
        equations.name
    );
}

#[test]
fn tape_agrees_with_the_oracle_on_equations_made_by_hand() {
    check(&support::handmade::slider_crank(), 300);
}
