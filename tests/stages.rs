//! Flexure stages and the bridge amplifier against what a handbook gives for them: static stiffness,
//! parasitic motion, amplification and natural frequencies in closed form, and the whole motion
//! against Lagrange's equations of the mechanism written down by hand.
//!
//! All numbers of the models are written here again; nothing is shared with the compiler.

mod support;

use std::f64::consts::{FRAC_PI_2, PI};

use support::by_hand::{ByHand, Drawing, Mass, Spring};
use support::probe::Probe;
use support::{assert_close, shipped};

/// Pseudo-rigid-body model of a leaf whose ends stay parallel (Howell, Compliant Mechanisms, 2001):
/// characteristic radius factor and stiffness coefficient.
const GAMMA: f64 = 0.8517;
const K_THETA: f64 = 2.65;

/// A leaf spring of aluminium.
struct Leaf {
    length: f64,
    width: f64,
    thickness: f64,
}

impl Leaf {
    const E: f64 = 72e9;

    fn bending(&self) -> f64 {
        Self::E * self.width * self.thickness.powi(3) / 12.0
    }

    /// Length of the pseudo-rigid link.
    fn link(&self) -> f64 {
        GAMMA * self.length
    }

    /// Stiffness of the torsion spring at either end.
    fn end(&self) -> f64 {
        2.0 * GAMMA * K_THETA * self.bending() / self.length
    }

    /// Transverse stiffness with parallel ends: 4 K_Θ E I / (γ L³).
    fn across(&self) -> f64 {
        4.0 * K_THETA * self.bending() / (GAMMA * self.length.powi(3))
    }
}

fn along(angle: f64) -> [f64; 2] {
    [angle.cos(), angle.sin()]
}

/// A sine, and its rate.
fn sine(amplitude: f64, frequency: f64, t: f64) -> (f64, f64) {
    let w = 2.0 * PI * frequency;
    (amplitude * (w * t).sin(), amplitude * w * (w * t).cos())
}

/// The root of a function that rises, by bisection.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

/// Frequencies of two coupled coordinates, lowest first: det(K − ω² M) = 0 for K = k I.
fn pair(m: [[f64; 2]; 2], k: f64) -> [f64; 2] {
    let (sum, product) = (m[0][0] + m[1][1], m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    let root = (sum * sum - 4.0 * product).sqrt();
    [(sum + root), (sum - root)].map(|twice| (k / (0.5 * twice)).sqrt())
}

/// Four springs at the ends of two leaves that tilt by the same angle.
fn ends(leaf: &Leaf, damping: f64, tilt: f64) -> impl Iterator<Item = Spring> {
    let stiffness = leaf.end();
    (0..4).map(move |_| Spring::new(stiffness, damping, tilt))
}

const SLIM: Leaf = Leaf {
    length: 40e-3,
    width: 10e-3,
    thickness: 0.5e-3,
};
const SLIM_MASS: f64 = 0.54e-3;

#[test]
fn parallelogram_stage() {
    let probe = Probe::new(&shipped("parallelogram_stage"), &[]);
    let (l, leaf, stage, push, f) = (SLIM.link(), SLIM_MASS, 60e-3, 2.0, 15.0);
    let hand = ByHand {
        gravity: 0.0,
        draw: &|q, t| {
            let tip = along(q[0]).map(|c| l * c);
            let web = || Mass::bar(leaf, l, tip.map(|c| 0.5 * c), q[0]);
            Drawing {
                masses: vec![web(), web(), Mass::point(stage, tip)],
                springs: ends(&SLIM, 0.0, q[0] - FRAC_PI_2).collect(),
                work: sine(push, f, t).0 * tip[0],
            }
        },
    };
    probe.compare(&hand, &probe.start(), 0.5, 20.0);

    let position = |q: &[f64]| ["x", "y"].map(|name| probe.output(name, q, &[0.0], 0.0));
    let upright = position(&[FRAC_PI_2])[1];
    assert_close("height", upright, l, 1e-15);
    for tilt in [-0.3f64, -1e-2, 1e-2, 0.1, 0.4] {
        let [x, y] = position(&[FRAC_PI_2 - tilt]);
        assert_close("travel L sin θ", x, l * tilt.sin(), 1e-13);
        let fall = l * (1.0 - tilt.cos());
        assert!(
            (upright - y - fall).abs() < 1e-16,
            "it falls by L(1 − cos θ)"
        );
    }

    // F L cos θ = 4 k θ, where the push is greatest.
    let t = 0.25 / f;
    let tilt = root(0.0, 1.0, |tilt| {
        4.0 * SLIM.end() * tilt - push * l * tilt.cos()
    });
    let still = probe.equilibrium(&[FRAC_PI_2], t);
    assert_close("tilt under a push", FRAC_PI_2 - still[0], tilt, 1e-13);
    // A small push, and the stiffness of two beams guided at their ends, 24 E I / L³, which the
    // textbook's constants miss by K_Θ/(3 γ) = 1.037.
    let small = Probe::new(&shipped("parallelogram_stage"), &[("push", 1e-4)]);
    let still = small.equilibrium(&[FRAC_PI_2], t);
    let stiffness = 1e-4 / small.output("x", &still, &[0.0], t);
    assert_close("stiffness", stiffness, 2.0 * SLIM.across(), 1e-8);
    let beams = 24.0 * SLIM.bending() / SLIM.length.powi(3);
    assert_close("against beams", stiffness / beams, 1.037, 1e-3);

    let mass = stage + 2.0 * leaf / 3.0;
    let frequency = (2.0 * SLIM.across() / mass).sqrt();
    let found = probe.frequencies(&[FRAC_PI_2], 0.0)[0];
    assert_close("first mode in rad/s", found, frequency, 1e-12);
}

#[test]
fn double_parallelogram_stage() {
    let probe = Probe::new(&shipped("double_parallelogram_stage"), &[]);
    let (l, leaf, frame, stage, push, f) = (SLIM.link(), SLIM_MASS, 25e-3, 60e-3, 1.0, 8.0);
    let margin = 15e-3;
    let hand = ByHand {
        gravity: 0.0,
        draw: &|q, t| {
            let outer = along(q[0]).map(|c| l * c);
            let inner = along(q[1]).map(|c| l * c);
            let on = |part: f64| [0, 1].map(|k| outer[k] + part * inner[k]);
            let up = || Mass::bar(leaf, l, outer.map(|c| 0.5 * c), q[0]);
            let down = || Mass::bar(leaf, l, on(0.5), q[1]);
            let (frame, stage) = (Mass::point(frame, outer), Mass::point(stage, on(1.0)));
            let springs = ends(&SLIM, 0.0, q[0] - FRAC_PI_2);
            Drawing {
                masses: vec![up(), up(), frame, down(), down(), stage],
                springs: springs.chain(ends(&SLIM, 0.0, q[1] + FRAC_PI_2)).collect(),
                work: sine(push, f, t).0 * on(1.0)[0],
            }
        },
    };
    probe.compare(&hand, &probe.start(), 0.4, 20.0);

    let at_rest = [FRAC_PI_2, -FRAC_PI_2];
    let position = |q: &[f64], t: f64| ["x", "y"].map(|name| probe.output(name, q, &[0.0; 2], t));
    // Frame and stage tilt their leaves alike, by F L cos θ = 4 k θ: twice the travel of one pair,
    // and what the frame sinks the stage rises.
    let t = 0.25 / f;
    let tilt = root(0.0, 1.0, |tilt| {
        4.0 * SLIM.end() * tilt - push * l * tilt.cos()
    });
    let still = probe.equilibrium(&at_rest, t);
    let [x, y] = position(&still, t);
    assert_close("travel", x - margin, 2.0 * l * tilt.sin(), 1e-12);
    assert!(y.abs() < 1e-16, "the travel is straight: {y:e} m off");
    // Leaves that tilt by different angles leave the difference of what both fall.
    let [_, y] = position(&[FRAC_PI_2 - 0.1, -FRAC_PI_2 + 0.02], 0.0);
    assert_close("fall", y, l * (0.1f64.cos() - 0.02f64.cos()), 1e-12);

    let small = Probe::new(&shipped("double_parallelogram_stage"), &[("push", 1e-4)]);
    let still = small.equilibrium(&at_rest, t);
    let stiffness = 1e-4 / (small.output("x", &still, &[0.0; 2], t) - margin);
    // The travel is a difference to 15 mm of some 80 nm, which leaves eight digits.
    assert_close(
        "half of one pair's stiffness",
        stiffness,
        SLIM.across(),
        1e-8,
    );

    // Upright leaves and hanging ones turn their far ends opposite ways.
    let moved = frame + 2.0 * leaf + stage + 2.0 * leaf / 3.0;
    let hung = stage + 2.0 * leaf / 3.0;
    let across = stage + leaf;
    let expected = pair([[moved, -across], [-across, hung]], 2.0 * SLIM.across());
    for (found, expected) in probe.frequencies(&at_rest, 0.0).iter().zip(expected) {
        assert_close("mode in rad/s", *found, expected, 1e-11);
    }
}

#[test]
fn bridge_amplifier() {
    let probe = Probe::new(&shipped("bridge_amplifier"), &[]);
    let (l, rise) = (20e-3, 8f64.to_radians());
    let (arm, block, output) = (0.8e-3, 4e-3, 12e-3);
    let (k, c, stack, stack_damping, stroke, f) = (1.5, 2e-5, 2e7, 60.0, 10e-6, 200.0);
    let hand = ByHand {
        gravity: 0.0,
        draw: &|q, t| {
            let rise_now = PI - q[0];
            let [out, up] = along(rise_now).map(|c| l * c);
            let sides = [-1.0, 1.0].into_iter();
            let mut masses = vec![Mass::point(output, [0.0, 2.0 * up])];
            for side in sides {
                let (lower, upper) = ([0.5 * side * out, 0.5 * up], [0.5 * side * out, 1.5 * up]);
                masses.push(Mass::bar(arm, l, lower, side * rise_now));
                masses.push(Mass::bar(arm, l, upper, -side * rise_now));
                masses.push(Mass::point(block, [side * out, up]));
            }
            // Two hinges at either end against bodies that do not turn, two between arms.
            let turn = rise_now - rise;
            let mut springs: Vec<Spring> = (0..4).map(|_| Spring::new(k, c, turn)).collect();
            springs.extend((0..2).map(|_| Spring::new(k, c, 2.0 * turn)));
            let (free, free_rate) = sine(stroke, f, t);
            springs.push(Spring {
                free,
                free_rate,
                ..Spring::new(stack, stack_damping, 2.0 * (out - l * rise.cos()))
            });
            Drawing {
                masses,
                springs,
                work: 0.0,
            }
        },
    };
    probe.compare(&hand, &probe.start(), 0.1, 100.0);

    // Rigid arms: the output moves by cot α for each of the stack's movement.
    let outputs =
        |q: f64| ["stretch", "position"].map(|name| probe.output(name, &[q], &[0.0], 0.0));
    for turn in [-0.05, 0.0, 0.03] {
        let [stretch, position] = outputs(PI - rise - turn);
        assert_close("stretch", stretch, 2.0 * l * (rise + turn).cos(), 1e-14);
        assert_close("position", position, 2.0 * l * (rise + turn).sin(), 1e-13);
        let rates = ["stretch", "position"].map(|name| {
            let h = 1e-4;
            let at = |shift: f64| probe.output(name, &[PI - rise - turn + shift], &[0.0], 0.0);
            (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h)
        });
        let ratio = -1.0 / (rise + turn).tan();
        // Differences over 0.1 mrad leave eleven digits of the arms' 20 mm.
        assert_close("amplification", rates[1] / rates[0], ratio, 1e-9);
    }

    // The stack works against the hinges' 12 k, seen through its lever 2 l sin α.
    let lever = 2.0 * l * rise.sin();
    let t = 0.25 / f;
    let moved = |stroke: f64| {
        let changes = [("cs", 0.0), ("stroke", stroke)];
        let probe = Probe::new(&shipped("bridge_amplifier"), &changes);
        let still = probe.equilibrium(&[PI - rise], t);
        probe.output("position", &still, &[0.0], t)
    };
    let amplification = -1.0 / rise.tan() / (1.0 + 12.0 * k / (stack * lever * lever));
    // Both ways, so that the geometry's second order cancels; 0.1 um of 5.6 mm is left of rounding.
    let found = (moved(1e-8) - moved(-1e-8)) / 2e-8;
    assert_close("static amplification", found, amplification, 1e-9);
    // At full stroke, from the balance of moments.
    let turn = root(-0.01, 0.01, |turn| {
        let now = rise + turn;
        let extension = 2.0 * l * (now.cos() - rise.cos()) - stroke;
        12.0 * k * turn - stack * extension * 2.0 * l * now.sin()
    });
    let still = probe.equilibrium(&[PI - rise], t);
    assert_close("turn of an arm", PI - still[0] - rise, turn, 1e-11);

    // Blocks and lower arms turn about the ground's pin, upper arms about points twice as high.
    let (sin, cos) = rise.sin_cos();
    let upper = 0.25 * (sin * sin + 9.0 * cos * cos) + 1.0 / 12.0;
    let inertia = l * l * (2.0 * (arm / 3.0 + block + arm * upper) + 4.0 * output * cos * cos);
    let frequency = ((12.0 * k + stack * lever * lever) / inertia).sqrt();
    let undamped = Probe::new(&shipped("bridge_amplifier"), &[("cs", 0.0)]);
    let found = undamped.frequencies(&[PI - rise], 0.0)[0];
    assert_close("first mode in rad/s", found, frequency, 1e-11);
}

#[test]
fn xy_stage() {
    let leaf = Leaf {
        length: 30e-3,
        width: 12e-3,
        thickness: 0.8e-3,
    };
    let probe = Probe::new(&shipped("xy_stage"), &[]);
    let (l, web, frame, platform) = (leaf.link(), 0.8e-3, 120e-3, 45e-3);
    let (c, stack, stack_damping, stroke, fx, fy) = (1e-4, 2e6, 40.0, 20e-6, 80.0, 110.0);
    let hand = ByHand {
        gravity: 0.0,
        draw: &|q, t| {
            let (first, second) = (along(q[0]).map(|c| l * c), along(q[1]).map(|c| l * c));
            let on = |part: f64| [0, 1].map(|k| first[k] + part * second[k]);
            let up = || Mass::bar(web, l, first.map(|c| 0.5 * c), q[0]);
            let right = || Mass::bar(web, l, on(0.5), q[1]);
            let (frame, platform) = (Mass::point(frame, first), Mass::point(platform, on(1.0)));
            let mut springs: Vec<Spring> = ends(&leaf, c, q[0] - FRAC_PI_2).collect();
            springs.extend(ends(&leaf, c, q[1]));
            for (stretch, f) in [(first[0], fx), (second[1], fy)] {
                let (free, free_rate) = sine(stroke, f, t);
                springs.push(Spring {
                    free,
                    free_rate,
                    ..Spring::new(stack, stack_damping, stretch)
                });
            }
            Drawing {
                masses: vec![up(), up(), frame, right(), right(), platform],
                springs,
                work: 0.0,
            }
        },
    };
    probe.compare(&hand, &probe.start(), 0.2, 20.0);

    // Without the damper beside the stack, which would push with the rate of its free extension.
    let probe = Probe::new(&shipped("xy_stage"), &[("cs", 0.0)]);
    // Each pair of leaves with its stack balances for itself; the other axis moves by what the
    // leaves' ends fall, and by nothing else.
    let t = 0.2 / fx;
    let tilt = |free: f64| {
        root(-0.1, 0.1, |tilt| {
            4.0 * leaf.end() * tilt + stack * (l * tilt.sin() - free) * l * tilt.cos()
        })
    };
    let [tilt_x, tilt_y] = [fx, fy].map(|f| tilt(sine(stroke, f, t).0));
    let still = probe.equilibrium(&[FRAC_PI_2, 0.0], t);
    assert_close("tilt in x", FRAC_PI_2 - still[0], tilt_x, 1e-11);
    assert_close("tilt in y", still[1], tilt_y, 1e-11);
    let [x, y] = ["x", "y"].map(|name| probe.output(name, &still, &[0.0; 2], t));
    let [x0, y0] = [l, l + 10e-3];
    let fall = |tilt: f64| l * (1.0 - tilt.cos());
    let (moved_x, moved_y) = (x - x0, y - y0);
    let crossed = (moved_x - l * tilt_x.sin(), moved_y - l * tilt_y.sin());
    println!(
        "of 20 um, cross-talk moves {:e} m and {:e} m",
        crossed.0, crossed.1
    );
    assert!((crossed.0 + fall(tilt_y)).abs() < 2e-17, "{}", crossed.0);
    assert!((crossed.1 + fall(tilt_x)).abs() < 2e-17, "{}", crossed.1);
    assert!(crossed.0 < -1e-12 && crossed.1 < -1e-12);

    // Leaves at right angles: the inertia does not couple the axes.
    let k = 2.0 * leaf.across() + stack;
    let inner = platform + 2.0 * web / 3.0;
    let outer = frame + 2.0 * web / 3.0 + platform + 2.0 * web;
    let found = probe.frequencies(&[FRAC_PI_2, 0.0], 0.0);
    assert_close("mode in x in rad/s", found[0], (k / outer).sqrt(), 1e-12);
    assert_close("mode in y in rad/s", found[1], (k / inner).sqrt(), 1e-12);
}
