//! The pendulum and the linkages against geometry with ruler and compasses: positions by
//! intersecting circles, motion by Lagrange's equations of the mechanism written down by hand, and
//! periods by the integral of energy.
//!
//! All numbers of the models are written here again; nothing is shared with the compiler.

mod support;

use std::f64::consts::{FRAC_PI_2, PI};

use flexure_runtime::simulate::simulate;
use support::by_hand::{ByHand, Drawing, Mass, Spring};
use support::probe::Probe;
use support::{assert_close, compile, shipped, shipped_text, tape};

type Plane = [f64; 2];

/// The point at a distance and an angle from another.
fn ray([x, y]: Plane, length: f64, angle: f64) -> Plane {
    [x + length * angle.cos(), y + length * angle.sin()]
}

fn middle(a: Plane, b: Plane) -> Plane {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// Where circles about `a` and `b` meet, on the left of the way from `a` to `b`.
fn compasses(a: Plane, ra: f64, b: Plane, rb: f64) -> Plane {
    let way = [b[0] - a[0], b[1] - a[1]];
    let distance = way[0].hypot(way[1]);
    let foot = (ra * ra - rb * rb + distance * distance) / (2.0 * distance);
    let height = (ra * ra - foot * foot).sqrt();
    let [ex, ey] = way.map(|c| c / distance);
    [
        a[0] + foot * ex - height * ey,
        a[1] + foot * ey + height * ex,
    ]
}

/// The angle of the way from `a` to `b`, within half a turn of how it is drawn.
fn angle(a: Plane, b: Plane, drawn: f64) -> f64 {
    let (sin, cos) = drawn.sin_cos();
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    drawn + (cos * y - sin * x).atan2(cos * x + sin * y)
}

/// A bar between two points.
fn bar(mass: f64, from: Plane, to: Plane, angle: f64) -> Mass {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    Mass::bar(mass, length, middle(from, to), angle)
}

/// Hinges by the angles that they see, which are at rest where the mechanism is assembled.
fn hinges(k: f64, c: f64, angles: &[f64], assembled: &[f64]) -> Vec<Spring> {
    let turns = angles.iter().zip(assembled);
    turns
        .map(|(angle, rest)| Spring::new(k, c, angle - rest))
        .collect()
}

fn sine(amplitude: f64, frequency: f64, t: f64) -> f64 {
    amplitude * (2.0 * PI * frequency * t).sin()
}

/// Compares the modes about the equilibrium at time 0, and where that is.
fn compare_modes(probe: &Probe, hand: &ByHand<'_>, name: &str) {
    let expected = hand.equilibrium(&probe.start(), 0.0);
    let found = probe.equilibrium(&probe.start(), 0.0);
    for (found, expected) in found.iter().zip(&expected) {
        let error = (found - expected).abs();
        println!("{name} in balance at {found} rad, off by {error:.1e}");
        assert!(error < 1e-12, "{name}: {found}, expected {expected}");
    }
    let modes = hand.frequencies(&expected, 0.0);
    for (found, expected) in probe.frequencies(&found, 0.0).iter().zip(modes) {
        assert_close(&format!("{name}: mode in rad/s"), *found, expected, 1e-9);
    }
}

/// Period of an undamped swing of one coordinate that passes `start` with this rate: twice the
/// integral of dq/q̇ between the turning points, with q̇² = 2 (E − P)/A.
fn period(hand: &ByHand<'_>, start: f64, rate: f64) -> f64 {
    let inertia = |q: f64| hand.inertia(&[q], 0.0)[(0, 0)];
    let potential = |q: f64| hand.potential(&[q], 0.0);
    let energy = 0.5 * inertia(start) * rate * rate + potential(start);
    let turning = |way: f64| {
        let (mut inside, mut outside) = (start, start + way);
        while potential(outside) < energy {
            (inside, outside) = (outside, outside + way);
        }
        for _ in 0..100 {
            let half = 0.5 * (inside + outside);
            if potential(half) < energy {
                inside = half;
            } else {
                outside = half;
            }
        }
        outside
    };
    let (low, high) = (turning(-0.05), turning(0.05));
    let (center, reach) = (0.5 * (low + high), 0.5 * (high - low));
    // q = center + reach sin s: smooth and periodic in s, so that midpoints converge at once.
    let count = 60;
    let piece = PI / f64::from(count);
    let sum: f64 = (0..count)
        .map(|n| {
            let s = (f64::from(n) + 0.5) * piece - FRAC_PI_2;
            let q = center + reach * s.sin();
            let speed = (2.0 * (energy - potential(q)) / inertia(q)).sqrt();
            reach * s.cos() / speed
        })
        .sum();
    2.0 * piece * sum
}

/// After one period an undamped swing is where it was, as fast as it was.
fn compare_period(name: &str, body: &str, rate: f64, changes: &[(&str, f64)], hand: &ByHand<'_>) {
    let text = shipped_text(name) + &format!("\ninitial {body}.rate = {rate} rad/s\n");
    let compiled = compile(name, &text);
    let start = Probe::new(&compiled, changes).start()[0];
    let period = period(hand, start, rate);
    let system = tape(&compiled, changes);
    let run = simulate(&system).until(period).rtol(1e-12).run();
    let run = run.unwrap_or_else(|failure| panic!("{}", failure.breakdown.message));
    println!("{name}: a period of {period:e} s");
    assert_close(
        "angle after it",
        run.column(&format!("{body}.angle")).last(),
        start,
        1e-9,
    );
    assert_close(
        "rate after it",
        run.column(&format!("{body}.rate")).last(),
        rate,
        1e-9,
    );
}

#[test]
fn pendulum() {
    let (length, width, height, density, k) = (0.2, 0.02, 5e-3, 2700.0, 0.02);
    let mass = density * length * width * height;
    let swing = |c: f64| {
        move |q: &[f64], _: f64| {
            let [x, y] = ray([0.0; 2], 0.5 * length, q[0]);
            Drawing {
                masses: vec![Mass {
                    mass,
                    inertia: mass * (length * length + height * height) / 12.0,
                    pose: [x, y, q[0]],
                }],
                springs: vec![Spring::new(k, c, q[0] + FRAC_PI_2)],
                work: 0.0,
            }
        }
    };
    let gravity = 9.81;
    let draw = &swing(0.05e-3);
    let probe = Probe::new(&shipped("pendulum"), &[]);
    probe.compare(&ByHand { draw, gravity }, &probe.start(), 1.0, 10.0);
    let about_pivot = mass * (length * length / 3.0 + height * height / 12.0);
    let frequency = ((k + 0.5 * mass * gravity * length) / about_pivot).sqrt();
    let found = probe.frequencies(&[-FRAC_PI_2], 0.0)[0];
    assert_close("small swings in rad/s", found, frequency, 1e-12);
    let draw = &swing(0.0);
    let free = ByHand { draw, gravity };
    compare_period("pendulum", "bar", 3.0, &[("c", 0.0)], &free);
}

/// Angle of the rod and position of the slide, in closed form.
fn slider_crank_at(q: f64) -> (f64, f64) {
    let (r, l, offset) = (15e-3, 50e-3, 4e-3);
    let rise = offset - r * f64::sin(q);
    (
        (rise / l).asin(),
        r * q.cos() + (l * l - rise * rise).sqrt(),
    )
}

#[test]
fn slider_crank() {
    let (r, offset, k, kr) = (15e-3, 4e-3, 0.3, 400.0);
    let (crank, rod, slide) = (4e-3, 9e-3, 20e-3);
    let (torque, f, assembled) = (0.1, 12.0, 75f64.to_radians());
    let (rod_assembled, x_assembled) = slider_crank_at(assembled);
    let draw = |c: f64, torque: f64| {
        move |q: &[f64], t: f64| {
            let (psi, x) = slider_crank_at(q[0]);
            let pin = ray([0.0; 2], r, q[0]);
            let end = [x, offset];
            let seen = [q[0], psi - q[0], -psi];
            let rest = [assembled, rod_assembled - assembled, -rod_assembled];
            let mut springs = hinges(k, c, &seen, &rest);
            springs.push(Spring::new(kr, 0.0, x - x_assembled));
            Drawing {
                masses: vec![
                    bar(crank, [0.0; 2], pin, q[0]),
                    bar(rod, pin, end, psi),
                    Mass::point(slide, end),
                ],
                springs,
                work: sine(torque, f, t) * q[0],
            }
        }
    };
    let gravity = 9.81;
    let hand = ByHand {
        draw: &draw(1e-5, torque),
        gravity,
    };
    let probe = Probe::new(&shipped("slider_crank"), &[]);
    for q in [0.7, 1.0, assembled, 1.6] {
        let (psi, x) = slider_crank_at(q);
        let rate = 40.0;
        // The crank's pin moves across the crank; the rod passes on what lies along it.
        let speed = -r * rate * (q - psi).sin() / psi.cos();
        let found = ["position", "velocity"].map(|name| probe.output(name, &[q], &[rate], 0.0));
        assert_close("position", found[0], x, 1e-14);
        assert_close("velocity", found[1], speed, 1e-13);
    }
    probe.compare(&hand, &probe.start(), 0.4, 100.0);
    compare_modes(&probe, &hand, "slider_crank");
    let free = ByHand {
        draw: &draw(0.0, 0.0),
        gravity,
    };
    let changes = [("c", 0.0), ("torque", 0.0)];
    compare_period("slider_crank", "crank", 100.0, &changes, &free);
}

/// Points and angles of the six-bar at an angle of its crank.
struct SixBar {
    a: Plane,
    b: Plane,
    c: Plane,
    d: Plane,
    coupler: f64,
    rocker: f64,
    connector: f64,
    output: f64,
}

const SECOND_PIVOT: Plane = [32e-3, -3e-3];
const THIRD_PIVOT: Plane = [38e-3, 22e-3];

fn six_bar_at(crank: f64) -> SixBar {
    let a = ray([0.0; 2], 12e-3, crank);
    let b = compasses(a, 30e-3, SECOND_PIVOT, 22e-3);
    let coupler = angle(a, b, 0.25);
    let c = ray(ray(a, 14e-3, coupler), 11e-3, coupler + FRAC_PI_2);
    let d = compasses(c, 21e-3, THIRD_PIVOT, 17e-3);
    SixBar {
        rocker: angle(SECOND_PIVOT, b, 1.5),
        connector: angle(c, d, 0.6),
        output: angle(THIRD_PIVOT, d, 2.0),
        a,
        b,
        c,
        d,
        coupler,
    }
}

impl SixBar {
    /// What the hinges see, from O1, A, B, O2, C, D to O3.
    fn turns(&self, crank: f64) -> [f64; 7] {
        [
            crank,
            self.coupler - crank,
            self.rocker - self.coupler,
            self.rocker,
            self.connector - self.coupler,
            self.output - self.connector,
            self.output,
        ]
    }
}

#[test]
fn six_bar() {
    let (k, torque, f, assembled) = (1.2, 0.25, 60.0, 70f64.to_radians());
    let rest = six_bar_at(assembled).turns(assembled);
    let draw = |c: f64, torque: f64| {
        move |q: &[f64], t: f64| {
            let now = six_bar_at(q[0]);
            let center = ray(
                ray(now.a, 15e-3, now.coupler),
                11e-3 / 3.0,
                now.coupler + FRAC_PI_2,
            );
            Drawing {
                masses: vec![
                    bar(0.8e-3, [0.0; 2], now.a, q[0]),
                    Mass::bar(2.6e-3, 30e-3, center, now.coupler),
                    bar(1.5e-3, SECOND_PIVOT, now.b, now.rocker),
                    bar(1.4e-3, now.c, now.d, now.connector),
                    bar(1.1e-3, THIRD_PIVOT, now.d, now.output),
                ],
                springs: hinges(k, c, &now.turns(q[0]), &rest),
                work: sine(torque, f, t) * q[0],
            }
        }
    };
    let gravity = 9.81;
    let hand = ByHand {
        draw: &draw(2e-6, torque),
        gravity,
    };
    let probe = Probe::new(&shipped("six_bar"), &[]);
    for shift in [-0.3, -0.1, 0.0, 0.2] {
        let q = assembled + shift;
        let found = probe.output("swing", &[q], &[0.0], 0.0);
        assert_close("output rocker", found, six_bar_at(q).output, 1e-14);
    }
    probe.compare(&hand, &probe.start(), 0.3, 100.0);
    compare_modes(&probe, &hand, "six_bar");
    let free = ByHand {
        draw: &draw(0.0, 0.0),
        gravity,
    };
    let changes = [("c", 0.0), ("torque", 0.0)];
    compare_period("six_bar", "crank", 200.0, &changes, &free);
}

/// The cranks' ends, the tool and the couplers' angles of the five-bar.
fn five_bar_at(q: &[f64]) -> ([Plane; 3], [f64; 2]) {
    let (a, b) = (ray([0.0; 2], 25e-3, q[0]), ray([40e-3, 0.0], 25e-3, q[1]));
    let p = compasses(a, 35e-3, b, 35e-3);
    ([a, b, p], [angle(a, p, 0.4), angle(b, p, 2.7)])
}

#[test]
fn five_bar() {
    let (base, k, c, f) = ([40e-3, 0.0], 0.4, 2e-5, 12.0);
    let (crank, coupler, tool) = (5e-3, 6e-3, 8e-3);
    let assembled = [120f64.to_radians(), 60f64.to_radians()];
    let turns =
        |q: &[f64], [left, right]: [f64; 2]| [q[0], q[1], left - q[0], right - q[1], right - left];
    let rest = turns(&assembled, five_bar_at(&assembled).1);
    let hand = ByHand {
        gravity: 0.0,
        draw: &|q, t| {
            let ([a, b, p], angles) = five_bar_at(q);
            let quarter = 0.25 / f;
            Drawing {
                masses: vec![
                    bar(crank, [0.0; 2], a, q[0]),
                    bar(crank, base, b, q[1]),
                    bar(coupler, a, p, angles[0]),
                    bar(coupler, b, p, angles[1]),
                    Mass::point(tool, p),
                ],
                springs: hinges(k, c, &turns(q, angles), &rest),
                work: sine(0.08, f, t) * q[0] + sine(0.05, f, t + quarter) * q[1],
            }
        },
    };
    let probe = Probe::new(&shipped("five_bar"), &[]);
    for (left, right) in [(0.0, 0.0), (0.1, 0.0), (-0.3, 0.1), (0.1, 0.3)] {
        let q = [assembled[0] + left, assembled[1] + right];
        let ([.., p], _) = five_bar_at(&q);
        for (name, expected) in ["x", "y"].iter().zip(p) {
            let found = probe.output(name, &q, &[0.0; 2], 0.0);
            assert_close("tool", found, expected, 1e-13);
        }
    }
    // As assembled the couplers are near their reach: states lie on the inner side of that.
    let inwards = [assembled[0] - 0.35, assembled[1] + 0.35];
    probe.compare(&hand, &inwards, 0.2, 50.0);
    compare_modes(&probe, &hand, "five_bar");
}
