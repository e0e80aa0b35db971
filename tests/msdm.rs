//! The mass–spring–damper baseline against its equations as published (Nguyen and Nguyen, Machines
//! 2025, 13, 787, equations 25 and 26, with the LuGre law of Canudas de Wit et al. 1995).

mod support;

use flexure_runtime::system::System;
use support::random::Random;
use support::{assert_close, shipped, tape};

const STACK: [f64; 3] = [15e-3, 3.6e6, 0.294];
const FLEXURE: [f64; 3] = [0.589e-3, 2.88e6, 218.0];
const STAGE: f64 = 50e-3;
const PRELOAD: f64 = 20.0;
const SIGMA: [f64; 3] = [5e6, 5.0, 0.5];
const MU: [f64; 2] = [0.3, 0.2];
const STRIBECK: f64 = 1e-3;

/// While the stack extends: 20 um in 0.95 of the period of 1 ms.
const EXTENSION: f64 = 20e-6 / 0.95e-3;

/// Accelerations of stack, flexure and stage, and the bristle's rate, with the largest term of each.
fn published(t: f64, x: [f64; 3], v: [f64; 3], z: f64) -> [(f64, f64); 4] {
    let [mp, kp, cp] = STACK;
    let [me, ke, ce] = FLEXURE;
    let slip = v[1] - v[2];
    let level = PRELOAD * (MU[1] + (MU[0] - MU[1]) * (-(slip / STRIBECK).powi(2)).exp());
    let bend = SIGMA[0] * slip.abs() * z / level;
    let friction = [SIGMA[0] * z, SIGMA[1] * (slip - bend), SIGMA[2] * slip];
    let ceramic = [kp * (EXTENSION * t - x[0]), cp * (EXTENSION - v[0])];
    let mechanism = [ke * (x[0] - x[1]), ce * (v[0] - v[1])];
    let sum = |terms: &[f64], mass: f64| {
        let largest = terms.iter().fold(0.0f64, |m, term| m.max(term.abs()));
        (terms.iter().sum::<f64>() / mass, largest / mass)
    };
    let against = |terms: [f64; 3]| terms.map(|term| -term);
    [
        sum(&[&ceramic[..], &mechanism.map(|f| -f)].concat(), mp),
        sum(&[&mechanism[..], &against(friction)].concat(), me),
        sum(&friction, STAGE),
        sum(&[slip, -bend], 1.0),
    ]
}

#[test]
fn equations_as_published() {
    let compiled = shipped("msdm");
    let system = tape(&compiled, &[]);
    let at = |name: &str| compiled.oracle.state(name);
    let bodies = ["stack", "flexure", "stage"];
    let values = bodies.map(|body| at(&format!("{body}.x")));
    let rates = bodies.map(|body| at(&format!("{body}.v")));
    let bristle = at("tip.z");
    let (mut state, mut discretes) = (vec![0.0; 7], vec![0.0; system.discretes().len()]);
    system.start(&mut state, &mut discretes);
    let mut random = Random::new(3);
    let mut worst: f64 = 0.0;
    for _ in 0..500 {
        let t = random.between(0.0, 0.95e-3);
        let x = [(); 3].map(|()| random.between(-30e-6, 30e-6));
        let speed = random.scale(1e-4, 1.0);
        let v = [(); 3].map(|()| random.between(-speed, speed));
        let z = random.between(-2e-6, 2e-6);
        for body in 0..3 {
            (state[values[body]], state[rates[body]]) = (x[body], v[body]);
        }
        state[bristle] = z;
        let mut found = vec![0.0; 7];
        system.rhs(t, &state, &discretes, &[], &mut found);
        let found = [rates[0], rates[1], rates[2], bristle].map(|index| found[index]);
        for (found, (expected, scale)) in found.iter().zip(published(t, x, v, z)) {
            let error = (found - expected).abs() / scale;
            assert!(error < 1e-13, "{found:e}, expected {expected:e}");
            worst = worst.max(error);
        }
    }
    println!("msdm: off by {worst:.1e} of the largest term");
}

/// Two masses in a row on two springs: ω⁴ − (kp/mp + ke/mp + ke/me) ω² + kp ke/(mp me) = 0.
#[test]
fn modes_of_stack_and_mechanism() {
    let compiled = shipped("msdm");
    let system = tape(&compiled, &[]);
    let (mut x, mut d) = (vec![0.0; 7], vec![0.0; system.discretes().len()]);
    system.start(&mut x, &mut d);
    let mut jacobian = vec![0.0; 49];
    system.jacobian(0.0, &x, &d, &[], &mut jacobian);
    let entry =
        |of: &str, by: &str| jacobian[7 * compiled.oracle.state(of) + compiled.oracle.state(by)];
    let slopes = nalgebra::Matrix2::new(
        entry("stack.v", "stack.x"),
        entry("stack.v", "flexure.x"),
        entry("flexure.v", "stack.x"),
        entry("flexure.v", "flexure.x"),
    );
    let mut found: Vec<f64> = (-slopes)
        .complex_eigenvalues()
        .iter()
        .map(|e| e.re)
        .collect();
    found.sort_by(f64::total_cmp);
    let ([mp, kp, _], [me, ke, _]) = (STACK, FLEXURE);
    let (sum, product) = (kp / mp + ke / mp + ke / me, kp * ke / (mp * me));
    let upper = 0.5 * (sum + (sum * sum - 4.0 * product).sqrt());
    for (found, square) in found.iter().zip([product / upper, upper]) {
        assert_close("mode in rad/s", found.sqrt(), square.sqrt(), 1e-13);
    }
}
