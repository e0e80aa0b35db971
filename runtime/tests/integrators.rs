//! Orders of convergence, exact stops, accounts, and runs that fail: on systems with known motion.

mod systems;

use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};

use flexure_runtime::simulate::{
    BreakdownKind, Ending, Heading, Integrator, Recorder, Run, RunFailure, simulate,
};
use flexure_runtime::system::{Energy, EventAction};
use systems::FnSystem;

fn oscillator() -> FnSystem {
    FnSystem::new(&[("x", "m"), ("v", "m/s")], &[1.0, 0.0], |_, x, _, dx| {
        dx[0] = x[1];
        dx[1] = -x[0];
    })
}

/// Kepler's problem with eccentricity 0.5, from the pericentre: period 2π.
fn kepler() -> FnSystem {
    FnSystem::new(
        &[("x", "m"), ("y", "m"), ("vx", "m/s"), ("vy", "m/s")],
        &[0.5, 0.0, 0.0, 3f64.sqrt()],
        |_, x, _, dx| {
            let r3 = (x[0] * x[0] + x[1] * x[1]).powf(1.5);
            dx.copy_from_slice(&[x[2], x[3], -x[0] / r3, -x[1] / r3]);
        },
    )
}

fn distance(run: &Run, to: &[f64]) -> f64 {
    let state = &run.summary().state;
    state
        .iter()
        .zip(to)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt()
}

#[test]
fn fixed_steps_are_of_order_4() {
    for (system, start, step) in [
        (oscillator(), vec![1.0, 0.0], 0.05),
        (kepler(), vec![0.5, 0.0, 0.0, 3f64.sqrt()], 0.005),
    ] {
        let error = |dt| distance(&simulate(&system).until(TAU).dt(dt).run().unwrap(), &start);
        let order = (error(step) / error(step / 2.0)).log2();
        assert!((order - 4.0).abs() < 0.3, "{order}");
    }
}

#[test]
fn steps_of_the_adaptive_method_are_of_order_8() {
    // With the tolerance wide open, the longest step is every step.
    let system = kepler();
    let start = [0.5, 0.0, 0.0, 3f64.sqrt()];
    let error = |step: f64| {
        let simulation = simulate(&system).until(TAU).rtol(0.1).max_step(step);
        distance(&simulation.run().unwrap(), &start)
    };
    let order = (error(TAU / 100.0) / error(TAU / 200.0)).log2();
    assert!(order > 7.2 && order < 9.0, "{order}");
}

#[test]
fn steps_of_the_stiff_method_are_of_order_5() {
    // Driven, so that the slope of the rates in time has its part.
    let system = FnSystem::new(&[("x", "m"), ("v", "m/s")], &[0.0, 0.0], |t, x, _, dx| {
        dx[0] = x[1];
        dx[1] = (2.0 * t).sin() - x[0] - 0.1 * x[0].powi(3);
    });
    let run = |step: f64| {
        let stiff = simulate(&system).integrator(Integrator::Stiff).until(3.0);
        stiff.rtol(0.1).max_step(step).run().unwrap()
    };
    let exact = simulate(&system).until(3.0).rtol(1e-13).run().unwrap();
    let error = |step: f64| distance(&run(step), &exact.summary().state);
    let order = (error(0.05) / error(0.025)).log2();
    assert!((order - 5.0).abs() < 0.4, "{order}");
}

/// A state that follows a cosine at a rate a million times its own.
fn follower() -> FnSystem {
    FnSystem::new(&[("x", "m"), ("y", "m")], &[1.0, 0.0], |t, x, _, dx| {
        dx[0] = -1e6 * (x[0] - t.cos()) - t.sin();
        dx[1] = x[0];
    })
}

#[test]
fn stiff_systems_take_stiff_steps_and_others_explicit_ones() {
    let follower = follower();
    let with = |integrator| {
        let simulation = simulate(&follower).until(1.0).rtol(1e-7);
        simulation.integrator(integrator).run().unwrap()
    };
    let explicit = with(Integrator::Explicit);
    let (stiff, automatic) = (with(Integrator::Stiff), with(Integrator::Automatic));
    for run in [&explicit, &stiff, &automatic] {
        assert!(distance(run, &[1f64.cos(), 1f64.sin()]) < 1e-6);
    }
    assert_eq!(explicit.statistics().stiff, 0);
    assert_eq!(stiff.statistics().stiff, stiff.statistics().accepted);
    let counts = automatic.statistics();
    assert!(counts.stiff > 0 && counts.evaluations < explicit.statistics().evaluations / 20);
    let calm = simulate(&kepler()).until(TAU).run().unwrap();
    assert_eq!(calm.statistics().stiff, 0);
}

#[test]
fn stiff_steps_have_dense_output_and_accounts_and_do_not_depend_on_rows() {
    let system = driven();
    let run = |every: f64| {
        let stiff = simulate(&system).integrator(Integrator::Stiff).energy(true);
        stiff.until(2.0).rtol(1e-8).every(every).run().unwrap()
    };
    let (coarse, fine) = (run(0.5), run(0.01));
    assert_eq!(coarse.summary().state, fine.summary().state);
    let explicit = simulate(&system).until(2.0).rtol(1e-12).every(0.01);
    let explicit = explicit.integrator(Integrator::Explicit).run().unwrap();
    let name = fine.headings()[1].name.clone();
    let pairs = fine
        .column(&name)
        .values()
        .iter()
        .zip(explicit.column(&name).values());
    let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-6 * explicit.column(&name).max(), "{worst}");
    let balance = fine.column("energy.balance");
    let bound = 1e-6 * fine.column("energy.supplied").max();
    assert!(
        balance.max().max(-balance.min()) < bound,
        "{}",
        balance.max()
    );
}

#[test]
fn error_follows_the_tolerance() {
    let system = kepler();
    let start = [0.5, 0.0, 0.0, 3f64.sqrt()];
    let mut last = f64::INFINITY;
    for exponent in [4, 6, 8, 10, 12] {
        let rtol = 10f64.powi(-exponent);
        let run = simulate(&system).until(TAU).rtol(rtol).run().unwrap();
        let error = distance(&run, &start);
        assert!(
            error < 30.0 * rtol && error < last / 5.0,
            "{rtol:e}: {error:e}"
        );
        assert!(run.statistics().evaluations < 4000);
        last = error;
    }
}

#[test]
fn dense_output_is_as_good_as_the_steps() {
    let system = oscillator();
    let error = |run: &Run| {
        let values = run.times().iter().zip(run.column("x").values());
        values.map(|(t, x)| (x - t.cos()).abs()).fold(0.0, f64::max)
    };
    let adaptive = simulate(&system)
        .until(20.0)
        .rtol(1e-10)
        .every(0.01)
        .run()
        .unwrap();
    assert_eq!(adaptive.len(), 2001);
    assert!(adaptive.statistics().accepted < 100);
    assert!(error(&adaptive) < 1e-8, "{:e}", error(&adaptive));
    // Order of the dense output: 8 in a step, one more than its degree.
    let in_steps = |step: f64| {
        let simulation = simulate(&system)
            .until(2.0)
            .rtol(0.1)
            .max_step(step)
            .every(0.013);
        error(&simulation.run().unwrap())
    };
    let order = (in_steps(0.5) / in_steps(0.25)).log2();
    assert!(order > 6.5, "{order}");
    let fixed = |dt| {
        error(
            &simulate(&system)
                .until(2.0)
                .dt(dt)
                .every(0.0123)
                .run()
                .unwrap(),
        )
    };
    let order = (fixed(0.1) / fixed(0.05)).log2();
    assert!((order - 4.0).abs() < 0.5, "{order}");
}

#[test]
fn small_motions_about_a_large_value_are_resolved() {
    // A crank at 80° that swings by a microradian.
    let rest = 80f64.to_radians();
    let system = FnSystem::new(
        &[("angle", "rad"), ("rate", "rad/s")],
        &[rest, 1e-3],
        move |_, x, _, dx| {
            dx[0] = x[1];
            dx[1] = -1e6 * (x[0] - rest);
        },
    );
    let run = simulate(&system).until(10e-3).rtol(1e-8).run().unwrap();
    let error = run.column("angle").last() - rest - 1e-6 * 10f64.sin();
    assert!(error.abs() < 1e-12, "{error:e}");
}

#[test]
fn steps_end_exactly_at_kinks() {
    // A triangle wave whose kinks come at multiples of 0.1, integrated.
    let passed: Arc<Mutex<Vec<f64>>> = Arc::default();
    let seen = Arc::clone(&passed);
    let build = || {
        let seen = Arc::clone(&seen);
        FnSystem::new(&[("x", "m")], &[0.0], |t, _, d, dx| {
            let sign = if d[0] % 2.0 == 0.0 { 1.0 } else { -1.0 };
            dx[0] = sign * (t - 0.1 * d[0] - 0.05);
        })
        .discrete("wave.segment", 0.0)
        .kink(
            |d| 0.1 * (d[0] + 1.0),
            move |d| {
                seen.lock().unwrap().push(0.1 * (d[0] + 1.0));
                d[0] += 1.0;
            },
        )
    };
    let system = build();
    for simulation in [simulate(&system).dt(0.03), simulate(&system).rtol(1e-9)] {
        passed.lock().unwrap().clear();
        let run = simulation.until(1.0).run().unwrap();
        let kinks = passed.lock().unwrap().clone();
        assert_eq!(kinks.len(), 9);
        assert_eq!(run.statistics().kinks, 9);
        for kink in kinks {
            assert!(run.times().contains(&kink), "{kink}");
        }
        assert!(run.column("x").last().abs() < 1e-15);
    }
    // Steps of 0.03 fit four times into 0.1.
    let run = simulate(&system).until(1.0).dt(0.03).run().unwrap();
    assert_eq!(run.statistics().accepted, 40);
}

fn ball(restitution: f64) -> FnSystem {
    FnSystem::new(
        &[("height", "m"), ("v", "m/s")],
        &[1.0, 0.0],
        |_, x, _, dx| {
            dx[0] = x[1];
            dx[1] = -2.0;
        },
    )
    .energy(|_, x, _| Energy {
        kinetic: 0.5 * x[1] * x[1],
        potential: 2.0 * x[0],
        ..Energy::default()
    })
    .event(
        |_, x, _| -x[0],
        move |_, x, _| {
            x[1] *= -restitution;
            EventAction::Continue
        },
    )
}

#[test]
fn a_bouncing_ball_bounces_on_time() {
    // Falls for 1 s, then flies for 2 r, 2 r², …
    let restitution = 0.7;
    let system = ball(restitution);
    for simulation in [simulate(&system).dt(0.01), simulate(&system).rtol(1e-10)] {
        let run = simulation.until(5.0).every(0.1).energy(true).run().unwrap();
        let mut time = 1.0;
        let mut flight = 2.0 * restitution;
        let events = &run.summary().events;
        assert!(events.len() == 6);
        for event in events {
            assert!(
                (event.time - time).abs() < 1e-12 * 5.0,
                "{} {time}",
                event.time
            );
            time += flight;
            flight *= restitution;
        }
        assert!(run.column("height").min() > -1e-12);
        assert!(run.column("energy.balance").max().abs() < 1e-12);
        assert!(run.column("energy.dissipated").last() > 1.5);
    }
}

#[test]
fn a_ball_that_comes_to_rest_is_chatter() {
    let system = ball(0.5);
    let failure = simulate(&system).until(5.0).rtol(1e-8).run().unwrap_err();
    assert_eq!(failure.breakdown.kind, BreakdownKind::Chatter(0));
    assert!((failure.breakdown.time - 3.0).abs() < 1e-8);
    assert!(
        failure.to_string().contains("at ever shorter intervals"),
        "{failure}"
    );
    assert!(failure.run.len() > 30);
}

#[test]
fn events_fire_once_each_and_only_when_rising() {
    let sine = |shift: f64| move |t: f64, _: &[f64], _: &[f64]| (t - shift).sin();
    let go_on = |_: f64, _: &mut [f64], _: &mut [f64]| EventAction::Continue;
    let system = FnSystem::new(&[("x", "1")], &[0.0], |t, _, _, dx| dx[0] = t.cos())
        .event(sine(1.0), go_on)
        .event(sine(1.0), go_on) // simultaneous with the first
        .event(sine(-1.0), go_on) // starts positive
        .event(|t, _, _| (t - 4.0).powi(2), go_on) // never below zero
        .event(|t, _, _| 1e-6 - (t - 5.0).powi(2), go_on); // rises for 2 ms only
    for simulation in [simulate(&system).dt(0.3), simulate(&system).rtol(1e-4)] {
        let run = simulation.until(10.0).run().unwrap();
        let times = |index| {
            let events = run.summary().events.iter().filter(|e| e.index == index);
            events.map(|e| e.time).collect::<Vec<_>>()
        };
        let near = |found: Vec<f64>, expected: &[f64]| {
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() < 1e-12, "{a} {b}");
            }
        };
        near(times(0), &[1.0, 1.0 + TAU]);
        near(times(1), &[1.0, 1.0 + TAU]);
        near(times(2), &[TAU - 1.0]);
        near(times(3), &[]);
        near(times(4), &[4.999]);
    }
}

#[test]
fn a_stop_ends_a_run_regularly() {
    let system = oscillator().event(
        |_, x, _| -x[0],
        |_, _, _| EventAction::Stop("the mass is at rest".into()),
    );
    for simulation in [simulate(&system).dt(0.1), simulate(&system).rtol(1e-10)] {
        let run = simulation.until(10.0).every(1.0).run().unwrap();
        assert_eq!(run.ending(), &Ending::Stopped("the mass is at rest".into()));
        assert_eq!(run.times().last(), Some(&run.summary().end));
        assert!((run.summary().end - FRAC_PI_2).abs() < 1e-5);
    }
}

#[test]
fn a_jump_of_a_drive_fires_what_it_carries_over_zero() {
    let system = FnSystem::new(&[("x", "m")], &[0.0], |_, _, _, dx| dx[0] = 0.0)
        .discrete("step", -1.0)
        .kink(
            |d| if d[0] < 0.0 { 0.25 } else { f64::INFINITY },
            |d| d[0] = 1.0,
        )
        .event(|_, _, d| d[0], |_, _, _| EventAction::Continue);
    let run = simulate(&system).until(1.0).run().unwrap();
    assert_eq!(run.summary().events.len(), 1);
    assert_eq!(run.summary().events[0].time, 0.25);
}

/// A damped oscillator whose support moves as sin 3t.
fn driven() -> FnSystem {
    let force = |t: f64, x: &[f64]| ((3.0 * t).sin() - x[0], -0.3 * x[1]);
    FnSystem::new(
        &[("x", "m"), ("v", "m/s")],
        &[0.3, 0.0],
        move |t, x, _, dx| {
            let (spring, damper) = force(t, x);
            dx[0] = x[1];
            dx[1] = spring + damper;
        },
    )
    .energy(move |t, x, _| {
        let (spring, damper) = force(t, x);
        Energy {
            kinetic: 0.5 * x[1] * x[1],
            potential: 0.5 * spring * spring,
            dissipated_power: -damper * x[1],
            supplied_power: spring * 3.0 * (3.0 * t).cos(),
        }
    })
}

#[test]
fn the_energy_balance_shrinks_with_the_step_and_with_the_tolerance() {
    let system = driven();
    let worst = |run: &Run| {
        let balance = run.column("energy.balance");
        balance.max().max(-balance.min())
    };
    let fixed = |dt| {
        worst(
            &simulate(&system)
                .until(10.0)
                .dt(dt)
                .energy(true)
                .run()
                .unwrap(),
        )
    };
    let order = (fixed(0.04) / fixed(0.02)).log2();
    assert!((order - 4.0).abs() < 0.4, "{order}");
    let adaptive = |rtol| {
        worst(
            &simulate(&system)
                .until(10.0)
                .rtol(rtol)
                .energy(true)
                .every(0.1)
                .run()
                .unwrap(),
        )
    };
    for rtol in [1e-5, 1e-8, 1e-11] {
        assert!(
            adaptive(rtol) < 30.0 * rtol,
            "{rtol:e}: {:e}",
            adaptive(rtol)
        );
    }
    let run = simulate(&system).until(10.0).energy(true).run().unwrap();
    assert!(run.column("energy.dissipated").last() > 0.1);
    assert!(run.column("energy.supplied").last() > 0.1);
}

#[test]
fn a_jumping_drive_supplies_the_jump_of_the_stored_energy() {
    let system = FnSystem::new(&[("x", "m"), ("v", "m/s")], &[0.0; 2], |_, x, d, dx| {
        dx[0] = x[1];
        dx[1] = d[0] - x[0];
    })
    .discrete("support", 0.0)
    .kink(
        |d| if d[0] == 0.0 { 1.0 } else { f64::INFINITY },
        |d| d[0] = 2.0,
    )
    .energy(|_, x, d| Energy {
        kinetic: 0.5 * x[1] * x[1],
        potential: 0.5 * (x[0] - d[0]).powi(2),
        ..Energy::default()
    });
    let run = simulate(&system).until(5.0).energy(true).run().unwrap();
    assert!((run.column("energy.supplied").last() - 2.0).abs() < 1e-15);
    assert!(run.column("energy.balance").max().abs() < 1e-7);
}

#[test]
fn a_turn_that_is_too_far_is_taken_in_shorter_steps() {
    // One turn a second, which only `accept` follows.
    let turning = || {
        FnSystem::new(&[("x", "1")], &[0.0], |_, _, _, dx| dx[0] = TAU)
            .discrete("crank.turn", 0.0)
            .accept(|x, d| d[0] = x[0])
            .turning(0)
    };
    let system = turning();
    let run = simulate(&system).until(3.0).rtol(1e-3).run().unwrap();
    let longest = run
        .times()
        .windows(2)
        .map(|t| t[1] - t[0])
        .fold(0.0, f64::max);
    assert!(longest <= 0.25, "{longest}");
    assert!(run.statistics().rejected > 0);
    let failure = simulate(&system).until(3.0).dt(0.5).run().unwrap_err();
    assert_eq!(failure.breakdown.kind, BreakdownKind::Turned(0));
    assert!(failure.to_string().contains("`crank.turn`"), "{failure}");
}

#[test]
fn a_loop_that_cannot_close_any_further_is_named() {
    // Runs into the end of its domain at t = 1.
    let system = FnSystem::new(&[("crank.angle", "rad")], &[0.0], |_, x, _, dx| {
        dx[0] = 1.0 + 0.0 * (1.0 - x[0]).sqrt();
    })
    .closure(|x| (1.0 - x[0]) * (1.0 - x[0]).abs());
    let failure = simulate(&system).until(2.0).rtol(1e-8).run().unwrap_err();
    assert_eq!(failure.breakdown.kind, BreakdownKind::DeadPoint(0));
    assert!((failure.breakdown.time - 1.0).abs() < 1e-9, "{failure}");
    assert!(
        failure.to_string().contains("`crank–coupler–rocker`"),
        "{failure}"
    );
    assert!(failure.run.column("crank.angle").last() > 0.9);
    let failure = simulate(&system).until(2.0).dt(0.01).run().unwrap_err();
    assert_eq!(failure.breakdown.kind, BreakdownKind::DeadPoint(0));
}

fn kind(result: Result<Run, RunFailure>) -> BreakdownKind {
    result.unwrap_err().breakdown.kind
}

#[test]
fn what_cannot_be_followed_is_an_error_value() {
    let exploding = FnSystem::new(&[("x", "m")], &[1.0], |_, x, _, dx| dx[0] = x[0] * x[0]);
    let short = kind(simulate(&exploding).until(2.0).run());
    assert!(matches!(
        short,
        BreakdownKind::StepTooShort | BreakdownKind::NotFinite
    ));
    assert_eq!(
        kind(simulate(&exploding).until(5.0).dt(0.1).run()),
        BreakdownKind::NotFinite
    );
    for bad in [f64::NAN, f64::INFINITY] {
        let rates = FnSystem::new(&[("x", "m")], &[1.0], move |_, _, _, dx| dx[0] = bad);
        assert_eq!(
            kind(simulate(&rates).until(1.0).run()),
            BreakdownKind::NotFinite
        );
        assert_eq!(
            kind(simulate(&rates).until(1.0).dt(0.1).run()),
            BreakdownKind::NotFinite
        );
        let start = FnSystem::new(&[("x", "m")], &[bad], |_, _, _, dx| dx[0] = 0.0);
        assert_eq!(
            kind(simulate(&start).until(1.0).run()),
            BreakdownKind::NotFinite
        );
        let event = oscillator().event(move |_, _, _| bad, |_, _, _| EventAction::Continue);
        assert!(simulate(&event).until(1.0).run().is_ok());
        let kink = oscillator().kink(move |_| -bad, |_| ());
        let result = simulate(&kink).until(1.0).run();
        assert!(result.is_ok() || kind(result) == BreakdownKind::CrowdedKinks(0));
    }
    let crowded = oscillator()
        .discrete("n", 1.0)
        .kink(|d| 0.5 - 0.5 / d[0], |d| d[0] += 1e18);
    assert_eq!(
        kind(simulate(&crowded).until(1.0).run()),
        BreakdownKind::CrowdedKinks(0)
    );
    let spent = simulate(&kepler())
        .until(1e3)
        .max_steps(100)
        .run()
        .unwrap_err();
    assert_eq!(spent.breakdown.kind, BreakdownKind::TooManySteps);
    assert_eq!(spent.run.ending(), &Ending::Failed);
    assert!(spent.run.len() > 50);
}

#[test]
fn settings_that_make_no_sense_are_refused() {
    let system = oscillator();
    let start = || simulate(&system);
    for simulation in [
        start().until(-1.0),
        start().until(f64::NAN),
        start().until(f64::INFINITY),
        start().until(1.0).rtol(0.0),
        start().until(1.0).rtol(f64::NAN),
        start().until(1.0).dt(0.0),
        start().until(1.0).dt(-1.0),
        start().until(1.0).dt(1e-300),
        start().until(1.0).every(0.0),
        start().until(1.0).every(1e-300),
        start().until(1.0).max_step(0.0),
        start().until(1.0).atol("y", 1e-3),
        start().until(1.0).atol("x", -1e-3),
        start().until(1.0).input(0, 1.0),
    ] {
        assert_eq!(kind(simulation.run()), BreakdownKind::Setting);
    }
    let run = start().until(0.0).run().unwrap();
    assert_eq!((run.len(), run.column("x").last()), (1, 1.0));
    assert_eq!(run.column("x").mean(), 1.0);
    let empty = FnSystem::new(&[], &[], |_, _, _, _| ());
    for simulation in [simulate(&empty).dt(0.1), simulate(&empty).rtol(1e-6)] {
        assert_eq!(simulation.until(1.0).every(0.5).run().unwrap().len(), 3);
    }
}

#[test]
fn columns_know_their_means() {
    let run = simulate(&oscillator())
        .until(TAU)
        .rtol(1e-10)
        .every(TAU / 1000.0)
        .run()
        .unwrap();
    let x = run.column("x");
    assert!(x.mean().abs() < 1e-9);
    assert!((x.rms() - 0.5f64.sqrt()).abs() < 1e-5);
    assert!((x.max() - 1.0).abs() < 1e-15 && (x.min() + 1.0).abs() < 1e-8);
    let quarter = x.between(0.0, FRAC_PI_2);
    assert_eq!(quarter.values().len(), 251);
    assert!((quarter.mean() - 1.0 / FRAC_PI_2).abs() < 1e-5);
    assert!(run.get("y").is_none());
}

/// Takes five rows.
#[derive(Default)]
struct Five {
    names: Vec<String>,
    rows: usize,
}

impl Recorder for Five {
    fn begin(&mut self, columns: &[Heading]) {
        self.names = columns.iter().map(|c| c.name.to_string()).collect();
    }
    fn row(&mut self, _: &[f64]) -> ControlFlow<()> {
        self.rows += 1;
        if self.rows < 5 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }
}

#[test]
fn a_recorder_may_break_off() {
    let mut five = Five::default();
    let summary = simulate(&oscillator())
        .until(1.0)
        .every(0.01)
        .run_with(&mut five)
        .unwrap();
    assert_eq!(summary.ending, Ending::Interrupted);
    assert_eq!(five.names, ["t", "x", "v"]);
    assert_eq!(five.rows, 5);
}
