//! The article's check values: the closed four-bar, its inertia, its free motion and the whole
//! actuator, as an independent integration in absolute coordinates gave them.

mod support;

use flexure_runtime::simulate::simulate;
use support::{Compiled, assert_close, compile, shipped, shipped_text, tape};

/// Kinetic energy at unit rate of the crank, twice: A.
fn inertia(compiled: &Compiled) -> f64 {
    let mut prepared = compiled.oracle.prepare(&compiled.params(&[])).unwrap();
    let mut state = vec![0.0; prepared.start.len()];
    let (angle, rate) = (
        compiled.oracle.state("crank.angle"),
        compiled.oracle.state("crank.rate"),
    );
    state[angle] = prepared.start[angle];
    state[rate] = 1.0;
    prepared.at(0.0, &state);
    2.0 * prepared.energy().0
}

#[test]
fn inertia_at_80_degrees() {
    let slender = inertia(&shipped("four_bar"));
    assert_close("A, slender bars", slender, 7.7343848191656e-8, 1e-10);
    let rectangular = inertia(&shipped("double_rocker"));
    assert_close(
        "A, rectangular sections",
        rectangular,
        7.7730624356e-8,
        1e-10,
    );
}

/// Angles and ratios of rates, through the results that a user would ask for.
#[test]
fn closed_configuration() {
    let text = shipped_text("double_rocker")
        + "\noutput check2 = coupler.angle\noutput check3 = rocker.angle\n\
           output ratio2 = coupler.rate\noutput ratio3 = rocker.rate\n";
    let compiled = compile("double_rocker.flex", &text);
    let mut prepared = compiled.oracle.prepare(&compiled.params(&[])).unwrap();
    let mut state = prepared.start.clone();
    state[compiled.oracle.state("crank.rate")] = 1.0;
    prepared.at(0.0, &state);
    let outputs = compiled.oracle.equations.outputs.clone();
    let mut output = |name: &str| {
        let found = outputs.iter().find(|output| output.name == name);
        prepared.value(found.unwrap().value)
    };
    assert_close(
        "φ2",
        output("check2").to_degrees(),
        -0.11133329253407,
        1e-11,
    );
    // The article's bar 3 points from D to O2, the model's rocker from O2 to D.
    assert_close(
        "φ3",
        output("check3").to_degrees(),
        180.0 - 89.83480236430641,
        1e-13,
    );
    assert_close("ω2", output("ratio2"), -0.07759427852596, 1e-11);
    assert_close("ω3", output("ratio3"), 1.00485788482694, 1e-13);
}

#[test]
fn hinge_stiffness() {
    let compiled = shipped("double_rocker");
    let mut prepared = compiled.oracle.prepare(&compiled.params(&[])).unwrap();
    let lets = &compiled.model.lets;
    let stiffness = lets.iter().find(|l| l.name == "k").expect("a let `k`");
    assert_close(
        "hinge stiffness",
        prepared.value(stiffness.value),
        42.10362726661852,
        1e-15,
    );
}

#[test]
fn free_four_bar_at_2_ms() {
    let system = tape(&shipped("four_bar"), &[]);
    let run = simulate(&system).until(2e-3).rtol(1e-13).run().unwrap();
    assert_close(
        "φ1(2 ms), adaptive",
        run.column("crank.angle").last(),
        1.39632369085868,
        1e-10,
    );
    let rate = -19.78361772873;
    assert_close(
        "φ̇1(2 ms), adaptive",
        run.column("crank.rate").last(),
        rate,
        1e-10,
    );
    let run = simulate(&system).until(2e-3).dt(5e-8).run().unwrap();
    assert_close(
        "φ̇1(2 ms), RK4",
        run.column("crank.rate").last(),
        rate,
        1e-10,
    );
}

#[test]
fn whole_actuator_at_10_ms() {
    let system = tape(&shipped("double_rocker"), &[]);
    let expected = 8.757774e-5;
    let run = simulate(&system).until(10e-3).rtol(1e-8).run().unwrap();
    assert_close(
        "x_s(10 ms), adaptive",
        run.column("stage.x").last(),
        expected,
        1e-6,
    );
    let run = simulate(&system).until(10e-3).dt(1e-7).run().unwrap();
    assert_close(
        "x_s(10 ms), RK4",
        run.column("stage.x").last(),
        expected,
        1e-6,
    );
}
