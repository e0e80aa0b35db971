//! Published planar benchmarks, from the model file to the motion: Andrews' squeezing mechanism and
//! the chain of four-bars that passes through singular positions.
//!
//! Compared with values recomputed in high precision from the published parameters.

mod support;

use flexure_model_dsl::structure::structure;
use flexure_runtime::simulate::{Run, simulate};
use support::{Compiled, shipped, tape};

/// Relative tolerance of the runs.
const RTOL: f64 = 1e-13;

fn run(compiled: &Compiled, until: f64) -> Run {
    let system = tape(compiled, &[]);
    simulate(&system)
        .until(until)
        .rtol(RTOL)
        .every(until / 10.0)
        .run()
        .unwrap_or_else(|failure| panic!("{}", failure.breakdown.message))
}

/// Andrews' angles, then their rates.
const NAMES: [&str; 7] = ["beta", "theta", "gamma", "phi", "delta", "Omega", "epsilon"];

fn compare_andrews(until: f64, angles: [f64; 7], rates: [f64; 7], allowed: [f64; 2]) {
    let run = run(&shipped("andrews"), until);
    for (name, (angle, rate)) in NAMES.iter().zip(angles.into_iter().zip(rates)) {
        let found = run.column(name).last();
        let error = (found - angle).abs();
        println!("{name}({until}) = {found:.15e}, off by {error:.1e}");
        assert!(error <= allowed[0], "{name}: {found:e}, expected {angle:e}");
        let found = run.column(&format!("d{name}")).last();
        let error = (found - rate).abs() / rate.abs();
        println!("d{name}({until}) = {found:.15e}, off by {error:.1e} of it");
        assert!(error <= allowed[1], "d{name}: {found:e}, expected {rate:e}");
    }
}

#[test]
fn andrews_at_30_ms() {
    compare_andrews(
        0.03,
        [
            15.810771195153707,
            -15.75637105841184,
            0.0408222401196458,
            -0.5347301163420796,
            0.5244099658799541,
            0.5347301163420796,
            1.048080741041938,
        ],
        [
            1139.9203022591061,
            -1424.37929517754,
            11.032911910618594,
            19.29337410503204,
            0.5735699148295025,
            -19.29337410503204,
            0.3231791492491309,
        ],
        [1e-9, 1e-8],
    );
}

#[test]
fn andrews_at_50_ms() {
    compare_andrews(
        0.05,
        [
            33.825_867_766_954_52,
            -33.58343151746387,
            0.11339507381259902,
            -0.40785286560188444,
            0.526060444916996,
            0.40785286560188444,
            1.056902429434963,
        ],
        [
            1144.5355026538475,
            -1336.0337226511925,
            -190.937_068_604_294_6,
            -334.317_060_870_864_6,
            0.8758650829430152,
            334.317_060_870_864_6,
            -39.61728897835299,
        ],
        [1e-7, 1e-7],
    );
}

/// One differential equation of second order, and every loop by a square root at most.
#[test]
fn andrews_is_one_equation() {
    let compiled = shipped("andrews");
    let structure = structure(&compiled.model).expect("a mechanism");
    assert!(structure.is_closed_form());
    assert_eq!(structure.steps.len(), 3);
    let states = &compiled.oracle.equations.states;
    let names: Vec<&str> = states.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["crank.angle", "crank.rate"]);
}

fn compare_windows(name: &str, position: [f64; 2], velocity: [f64; 2]) {
    let run = run(&shipped(name), 10.0);
    let expected = [position, velocity].concat();
    for (column, expected) in ["x0", "y0", "v_x0", "v_y0"].iter().zip(expected) {
        let found = run.column(column).last();
        let error = (found - expected).abs();
        println!("{name}: {column}(10 s) = {found:.15e}, off by {error:.1e}");
        assert!(
            error <= 1e-8,
            "{name}: {column} {found:e}, expected {expected:e}"
        );
    }
}

#[test]
fn one_window_at_10_s() {
    compare_windows(
        "n_windows_1",
        [0.4783850577609706, 0.8781501787912093],
        [1.727264075547154, -0.9409521793715156],
    );
}

#[test]
fn two_windows_at_10_s() {
    compare_windows(
        "n_windows_2",
        [0.3284581115408154, 0.944518538178601],
        [1.423051470206944, -0.494868845487043],
    );
}

#[test]
fn forty_windows_at_10_s() {
    compare_windows(
        "n_windows_40",
        [0.180_512_226_686_728_4, 0.983_572_740_582_311_6],
        [1.148_441_277_469_414, -0.210_770_066_779_423_9],
    );
}
