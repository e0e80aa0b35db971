//! Equilibrium, stiffness and modes against formulas by hand and against simulated motion.

use std::f64::consts::TAU;
use std::fs;

use flexure::statics::{Hold, Mode, Statics};
use flexure::{Model, simulate};

fn source(name: &str) -> String {
    fs::read_to_string(format!("{}/models/{name}.flex", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn params(text: &str, set: &[(&str, f64)]) -> Vec<f64> {
    let mut design = Model::from_source("model.flex", text).unwrap().design();
    for (name, value) in set {
        design.set(name, *value).unwrap();
    }
    design.values().to_vec()
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / expected.abs();
    assert!(
        error <= tolerance,
        "{what}: {found} and {expected}: {error:e}"
    );
}

fn modes(text: &str, holds: &[Hold], set: &[(&str, f64)]) -> Vec<Mode> {
    let statics = Statics::from_source("model.flex", text, holds).unwrap();
    let rest = statics.prepare(&params(text, set)).unwrap();
    let found = rest.equilibrium(None, &rest.start()).unwrap();
    found.linear().modes()
}

fn without() -> [Hold; 1] {
    [Hold::Without("tip".to_owned())]
}

#[test]
fn a_damped_oscillator_on_a_stack() {
    let text = "model o\nparam m = 2 kg, k = 800 N/m, c = 4 N*s/m\n\
                drive xp = sine(1 mm, frequency = 3 Hz)\n\
                slide mass along (1, 0) { mass = m }\n\
                spring s between ground and mass { stiffness = k, damping = c, expansion = xp }\n\
                output place = mass.x\n";
    let (m, k, c) = (2.0, 800.0, 4.0);
    let statics = Statics::from_source("o.flex", text, &[]).unwrap();
    let rest = statics.prepare(&statics.defaults()).unwrap();
    let still = rest.equilibrium(None, &[2e-3]).unwrap();
    close("place", still.results()[0], 2e-3, 1e-14);
    close("ratio", still.ratio(0, 0), 1.0, 1e-14);
    close("stiffness", still.stiffness(0), k, 1e-14);
    let linear = still.linear();
    let mode = &linear.modes()[0];
    close("frequency", mode.frequency(), (k / m).sqrt() / TAU, 1e-12);
    close("damping", mode.damping(), c / (2.0 * (k * m).sqrt()), 1e-12);
    for f in [0.3, 3.0, 40.0] {
        let w = TAU * f;
        let found = linear.response(0, 0, f).unwrap();
        // (k + iωc)/(k + iωc - mω²): the damper sees the rate of the expansion.
        let square = |re: f64, im: f64| re * re + im * im;
        let size = square(k, c * w) / square(k - m * w * w, c * w);
        close("response", found.norm_sqr(), size, 1e-12);
    }
}

#[test]
fn double_rocker_without_its_contact() {
    let text = source("double_rocker");
    // Rectangular sections, then slender bars.
    let slender = text.replace("  section = rect(b, h)\n", "");
    let slender = slender.replace("param h  = 3 mm", "// ");
    for (ku, printed, exact, ratio) in [
        (3e7, [3740.0, 18680.0], [3740.80, 18720.89], 0.6144),
        (3e6, [3078.0, 9269.0], [3078.22, 9291.68], 0.3684),
        (8e7, [3835.0, 29046.0], [3836.66, 29107.62], 0.6443),
    ] {
        let set = [("ku", ku)];
        let found = modes(&text, &without(), &set);
        assert!(
            found[0].is_free && found[0].shares[2] == 1.0,
            "{:?}",
            found[0]
        );
        for (mode, printed) in found[1..].iter().zip(printed) {
            assert!(
                (mode.frequency() - printed).abs() <= 0.5,
                "{} {printed}",
                mode.frequency()
            );
        }
        let found = modes(&slender, &without(), &set);
        for (mode, exact) in found[1..].iter().zip(exact) {
            assert!(
                (mode.frequency() - exact).abs() <= 0.005,
                "{} {exact}",
                mode.frequency()
            );
        }
        let statics = Statics::from_source("m.flex", &text, &without()).unwrap();
        let set = [("ku", ku), ("ln", 0.0)];
        let rest = statics.prepare(&params(&text, &set)).unwrap();
        let still = rest.equilibrium(None, &rest.start()).unwrap();
        let c = statics
            .results()
            .iter()
            .position(|row| row.name == "C.x")
            .unwrap();
        assert!(
            (still.ratio(c, 0) + ratio).abs() <= 5e-5,
            "{} {ratio}",
            still.ratio(c, 0)
        );
        assert_eq!(still.free(), ["stage.x"]);
    }
}

#[test]
fn the_bare_linkage() {
    let text = source("four_bar");
    let found = modes(&text, &[], &[]);
    println!("{} Hz", found[0].frequency());
    let statics = Statics::from_source("m.flex", &text, &[]).unwrap();
    let rest = statics.prepare(&statics.defaults()).unwrap();
    let still = rest.equilibrium(None, &rest.start()).unwrap();
    let crank = statics
        .results()
        .iter()
        .position(|row| row.name == "crank.angle")
        .unwrap();
    let stiffness = still.stiffness(crank);
    assert!((stiffness - 182.8414).abs() <= 2e-3, "{stiffness}");
    assert!(
        (found[0].frequency() - 7738.28).abs() <= 0.05,
        "{}",
        found[0].frequency()
    );
}

/// Frequency of a column that swings about zero, by its first and last rising crossings.
fn ringing(time: &[f64], values: &[f64]) -> f64 {
    let crossings: Vec<f64> = (1..values.len())
        .filter(|&k| values[k - 1] < 0.0 && values[k] >= 0.0)
        .map(|k| {
            let share = -values[k - 1] / (values[k] - values[k - 1]);
            time[k - 1] + share * (time[k] - time[k - 1])
        })
        .collect();
    (crossings.len() - 1) as f64 / (crossings[crossings.len() - 1] - crossings[0])
}

#[test]
fn a_stuck_stage_rings_at_its_mode() {
    // A mass that a bristle holds: strong friction, a small push.
    let text = "model m\nparam mu = 100\nslide base along (1, 0) { mass = 1 kg }\n\
                slide stage along (1, 0) { mass = 50 g }\n\
                spring s between ground and base { stiffness = 1e6 N/m }\n\
                contact tip between base and stage { preload = 20 N\n\
                friction = lugre(5e6 N/m, 5 N*s/m, 0.5 N*s/m, mu, mu, 1 mm/s) }\n\
                initial base.v = 1 mm/s, stage.v = 1 mm/s\n";
    let found = modes(text, &[], &[]);
    assert!(found.iter().all(|mode| !mode.is_free));
    let run = simulate(
        &Model::from_source("m.flex", text)
            .unwrap()
            .design()
            .prepare()
            .unwrap(),
    )
    .until(50e-3)
    .rtol(1e-10)
    .every(1e-5)
    .run()
    .unwrap();
    let time: Vec<f64> = (0..=5000).map(|k| f64::from(k) * 1e-5).collect();
    let values: Vec<f64> = run.column("base.x").values().to_vec();
    close(
        "ringing",
        ringing(&time, &values),
        found[0].frequency(),
        1e-3,
    );
}

#[test]
fn what_has_no_equilibrium_says_so() {
    let loose = "model l\nslide a along (0, 1) { mass = 1 kg }\ngravity = (0, -9.81 m/s^2)\n";
    let statics = Statics::from_source("l.flex", loose, &[]).unwrap();
    let rest = statics.prepare(&statics.defaults()).unwrap();
    let error = rest.equilibrium(None, &[]).unwrap_err().to_string();
    assert!(
        error.contains("nothing elastic holds `a.x` against 9.81 N"),
        "{error}"
    );
    let text = source("double_rocker");
    let error = Statics::from_source("d.flex", &text, &[Hold::Stick("tap".to_owned())]);
    let error = error.unwrap_err().to_string();
    assert!(
        error.contains("no contact `tap`") && error.contains("`tip`"),
        "{error}"
    );
}

#[test]
fn the_linkage_without_its_contact_rings_at_its_mode() {
    let text = source("double_rocker").replace("gravity = (0, -9.81 m/s^2)", "");
    let found = modes(&text, &without(), &[]);
    let (before, rest) = text.split_once("contact tip").unwrap();
    let (_, after) = rest.split_once("\n}").unwrap();
    let after = after.replace("output friction = tip.friction ", "// ");
    let bare = format!("{before}{after}\ninitial stack.v = 1 mm/s\n");
    let mut design = Model::from_source("bare.flex", &bare).unwrap().design();
    design.set("stroke", 0.0).unwrap();
    let run = simulate(&design.prepare().unwrap())
        .until(30e-3)
        .rtol(1e-10)
        .every(2e-6)
        .run()
        .unwrap();
    let values = run.column("stack.x").values().to_vec();
    let rung = ringing(run.times(), &values);
    close("ringing", rung, found[1].frequency(), 1e-3);
}

#[test]
fn amplification_of_the_bridge() {
    let (l, rise, k, stack) = (20e-3, 8f64.to_radians(), 1.5, 2e7);
    let lever = 2.0 * l * rise.sin();
    let text = source("bridge_amplifier");
    let statics = Statics::from_source("b.flex", &text, &[]).unwrap();
    let rest = statics.prepare(&statics.defaults()).unwrap();
    let still = rest.equilibrium(None, &rest.start()).unwrap();
    let at = |name: &str| {
        let rows = statics.results();
        rows.iter().position(|row| row.name == name).unwrap()
    };
    // The stack works against the hinges' 12 k through its lever; the output moves by cot α of it.
    let ratio = -1.0 / rise.tan() / (1.0 + 12.0 * k / (stack * lever * lever));
    close(
        "amplification",
        still.ratio(at("position"), 0),
        ratio,
        1e-11,
    );
    let total = stack + 12.0 * k / (lever * lever);
    close(
        "stiffness",
        still.stiffness(at("piezo.extension")),
        total,
        1e-11,
    );
    close(
        "the stack's own",
        still.direct(at("piezo.force"), 0),
        stack,
        1e-12,
    );
}
