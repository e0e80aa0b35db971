//! The article's actuator, written out by hand from its equations (four-bar with hinges, piezo
//! stack, slider under LuGre friction, sawtooth drive), against the published check value of the
//! slider's position: the integrators alone, without the compiler.

mod systems;

use flexure_runtime::simulate::simulate;
use systems::FnSystem;

/// Everything at table 5's nominal values, preload 20 N, 1 kHz, 20 µm, rise 0.95.
fn actuator() -> FnSystem {
    let (l1, l2, l3, l4) = (10.2e-3f64, 23.2e-3f64, 10e-3f64, 25e-3f64);
    let (m1, m2, m3) = (0.2568e-3, 0.5877e-3, 0.2529e-3);
    let height = 3e-3f64;
    let (la, ln) = (5.1e-3f64, 5e-3f64);
    let (mp, kp, cp, ku) = (15e-3, 3.6e6, 0.294, 3e7);
    let (ms, preload) = (50e-3, 20.0);
    let (sigma0, sigma1, sigma2) = (5e6, 5.0, 0.5);
    let (static_force, sliding_force, stribeck) = (0.3 * preload, 0.2 * preload, 1e-3f64);
    let (stroke, frequency, rise) = (20e-6, 1e3, 0.95);
    let g = 9.81;
    let k = 2.0 * 72e9 * 3e-3 * 1.5e-3f64.powf(2.5) / (9.0 * std::f64::consts::PI * 1e-3f64.sqrt());
    let inertia = |m: f64, l: f64| m * (l * l + height * height) / 12.0;
    let c0 = inertia(m1, l1) + m1 * l1 * l1 / 4.0 + m2 * l1 * l1;
    let c1 = inertia(m2, l2) + m2 * l2 * l2 / 4.0;
    let c2 = inertia(m3, l3) + m3 * l3 * l3 / 4.0;
    let c3 = m2 * l2 * l1;
    // The loop O1–B–D–O2 with the rocker drawn from O2: its angles for a crank angle.
    let close = move |phi1: f64| {
        let (bx, by) = (l1 * phi1.cos(), l1 * phi1.sin());
        let (ex, ey) = (l4 - bx, -by);
        let distance2 = ex * ex + ey * ey;
        let along = (distance2 + l2 * l2 - l3 * l3) / (2.0 * distance2);
        let across = (l2 * l2 / distance2 - along * along).sqrt();
        let (dx, dy) = (along * ex - across * ey, along * ey + across * ex);
        let phi2 = dy.atan2(dx);
        let phi3 = (by + dy).atan2(bx + dx - l4);
        (phi2, phi3)
    };
    let start1 = 80f64.to_radians();
    let (start2, start3) = close(start1);
    FnSystem::new(
        &[
            ("crank.angle", "rad"),
            ("crank.rate", "rad/s"),
            ("stack.x", "m"),
            ("stack.v", "m/s"),
            ("stage.x", "m"),
            ("stage.v", "m/s"),
            ("tip.z", "m"),
        ],
        &[start1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        move |t, x, d, dx| {
            let [phi1, rate, xu, vu, _, vs, z] = *x else {
                unreachable!()
            };
            let cycle = d[0].div_euclid(2.0);
            let tau = t - cycle / frequency;
            let (xp, vp) = if d[0].rem_euclid(2.0) == 0.0 {
                let slope = stroke * frequency / rise;
                (slope * tau, slope)
            } else {
                let slope = -stroke * frequency / (1.0 - rise);
                (slope * (tau - 1.0 / frequency), slope)
            };
            let (phi2, phi3) = close(phi1);
            let (s1, co1) = phi1.sin_cos();
            let (s2, co2) = phi2.sin_cos();
            let co3 = phi3.cos();
            let across = (phi2 - phi3).sin();
            let w2 = l1 * (phi3 - phi1).sin() / (l2 * across);
            let w3 = l1 * (phi2 - phi1).sin() / (l3 * across);
            let dw2 = w2 * ((w3 - 1.0) / (phi3 - phi1).tan() - (w2 - w3) / (phi2 - phi3).tan());
            let dw3 = w3 * ((1.0 - w2) / (phi1 - phi2).tan() - (w2 - w3) / (phi2 - phi3).tan());
            let (c21, s21) = ((phi2 - phi1).cos(), (phi2 - phi1).sin());
            let a = c0 + c1 * w2 * w2 + c2 * w3 * w3 + c3 * w2 * c21;
            let da =
                2.0 * (c1 * w2 * dw2 + c2 * w3 * dw3) + c3 * (dw2 * c21 - w2 * s21 * (w2 - 1.0));
            let (q1, q2, q3) = (phi1 - start1, phi2 - start2, phi3 - start3);
            let springs = k * (q1 + (q2 - q1) * (w2 - 1.0) + (q3 - q2) * (w3 - w2) + q3 * w3);
            let gravity = g
                * (m1 * l1 / 2.0 * co1
                    + m2 * (l1 * co1 + l2 / 2.0 * co2 * w2)
                    + m3 * l3 / 2.0 * co3 * w3);
            let lever = l1 * s1 + ln * w2 * s2;
            let v = lever * rate - vs;
            let limit =
                sliding_force + (static_force - sliding_force) * (-(v / stribeck).powi(2)).exp();
            let dz = v - v.abs() * z * sigma0 / limit;
            let friction = sigma0 * z + sigma1 * dz + sigma2 * v;
            let xa = la * (start1.cos() - co1);
            let joint = ku * (xu - xa);
            let torque = la * s1 * joint - preload * (l1 * co1 + ln * w2 * co2) - friction * lever;
            dx[0] = rate;
            dx[1] = (torque - 0.5 * da * rate * rate - springs - gravity) / a;
            dx[2] = vu;
            dx[3] = (-joint - cp * (vu - vp) - kp * (xu - xp)) / mp;
            dx[4] = vs;
            dx[5] = friction / ms;
            dx[6] = dz;
        },
    )
    .discrete("xp.segment", 0.0)
    .kink(
        move |d| {
            let cycle = d[0].div_euclid(2.0);
            let part = if d[0].rem_euclid(2.0) == 0.0 {
                rise
            } else {
                1.0
            };
            (cycle + part) / frequency
        },
        |d| d[0] += 1.0,
    )
}

const STAGE_AT_10_MS: f64 = 8.757774e-5;

#[test]
fn fixed_steps_reach_the_published_position() {
    let run = simulate(&actuator())
        .until(10e-3)
        .dt(1e-7)
        .every(1e-4)
        .run()
        .unwrap();
    let statistics = run.statistics();
    assert!((run.column("stage.x").last() / STAGE_AT_10_MS - 1.0).abs() < 1e-6);
    assert_eq!(statistics.accepted, 100_000);
    assert_eq!(statistics.kinks, 19);
}

#[test]
fn adaptive_steps_reach_it_too_with_few_evaluations() {
    let run = |rtol| {
        let run = simulate(&actuator())
            .until(10e-3)
            .rtol(rtol)
            .every(1e-4)
            .run()
            .unwrap();
        (run.column("stage.x").last(), run.statistics().evaluations)
    };
    let (position, evaluations) = run(1e-8);
    assert!(
        (position / STAGE_AT_10_MS - 1.0).abs() < 1e-6,
        "{position:e}"
    );
    assert!(evaluations < 60_000, "{evaluations}");
    // Converged: a tolerance a thousand times tighter moves it by no more than a tenth of that.
    let (tight, _) = run(1e-11);
    assert!(
        (position / tight - 1.0).abs() < 1e-7,
        "{position:e} {tight:e}"
    );
}

#[test]
fn rows_have_no_influence_on_the_motion() {
    let system = actuator();
    for simulation in [simulate(&system).dt(1e-6), simulate(&system).rtol(1e-6)] {
        let simulation = simulation.until(2e-3);
        let all = simulation.clone().run().unwrap();
        let few = simulation.clone().every(3.3e-5).run().unwrap();
        let accounted = simulation.energy(true).every(1e-3).run().unwrap();
        assert_eq!(all.summary().state, few.summary().state);
        assert_eq!(all.summary().state, accounted.summary().state);
        assert_eq!(few.len(), 62);
        // Dense output agrees with the steps around it.
        let (times, stage) = (all.times(), all.column("stage.v"));
        let after = times.partition_point(|&t| t < few.times()[30]);
        let (low, high) = (stage.values()[after - 1], stage.values()[after]);
        let between = few.column("stage.v").values()[30];
        let slack = 0.1 * (high - low).abs();
        assert!(between > low.min(high) - slack && between < low.max(high) + slack);
    }
}
