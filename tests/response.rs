//! Frequency responses: the article's mean speeds, motions whose mean speed or kind is known, and
//! that nothing depends on threads.

use flexure::Model;
use flexure::response::{Cycles, Motion, Outcome, Quantity, Settle, Speed, response};
use flexure::runtime::diagnostic::Diagnostic;
use flexure::runtime::lanes::LaneSystem;
use flexure_models::double_rocker;

fn model(text: &str) -> Model {
    Model::from_source("test.flex", text).unwrap_or_else(|error| panic!("{error}"))
}

/// A design of the model with some params changed.
fn design(model: &Model, changes: &[(&str, f64)]) -> Result<impl LaneSystem + use<>, Diagnostic> {
    let mut design = model.design();
    for (name, value) in changes {
        design.set(name, *value)?;
    }
    design.prepare()
}

fn speed_named(name: &str, model: &Model) -> Speed {
    let system = design(model, &[]).unwrap();
    Speed::of(Quantity::named(name, &system).unwrap(), &system)
}

/// Mean speeds of the article's actuator over cycles 10 to 30, in m/s, each from an independent
/// integration: drive frequency, preload, speed.
const MEAN_SPEEDS: [(f64, f64, f64); 3] = [
    (1000.0, 20.0, 8.74628e-3),
    (500.0, 20.0, 3.52298e-3),
    (300.0, 5.0, 2.89968e-3),
];

#[test]
fn mean_speeds_of_the_article() {
    let prepare = |index: usize| {
        let (f, preload, _) = MEAN_SPEEDS[index];
        let design = double_rocker::Params {
            f,
            Fp: preload,
            ..Default::default()
        };
        design.prepare()
    };
    let system = prepare(0).unwrap();
    let speed = Speed::of(Quantity::named("speed", &system).unwrap(), &system);
    let position = Quantity::named("stage.x", &system).unwrap();
    assert_eq!(speed, Speed::RateOf(position));
    let frequencies = MEAN_SPEEDS.map(|(f, _, _)| f);
    let outcomes = response(&frequencies, speed, prepare).rtol(1e-7).run();
    for ((f, preload, expected), outcome) in MEAN_SPEEDS.iter().zip(outcomes) {
        let point = outcome.unwrap();
        assert_eq!(
            (point.frequency, point.cycles, point.motion),
            (*f, 10..30, Motion::Measured)
        );
        let error = (point.speed - expected).abs() / expected;
        println!(
            "{f} Hz, {preload} N: {:e} m/s, off by {error:.1e}",
            point.speed
        );
        // The values are printed with six digits; here are five of them.
        assert!(
            error < 5e-6,
            "at {f} Hz and {preload} N: {:e} m/s",
            point.speed
        );
    }
}

/// Pushed by F (1 + sin ωt) against viscous friction: once settled the mean speed is F / c.
const PUSHED: &str = "\
model pushed
param f = 10 Hz, F = 2 N, c = 4 N*s/m, m = 0.1 kg, end = 1 km
slide block along (1, 0) { mass = m }
force on block = (F * (1 + sin(2*pi*f*t)) - c * block.v, 0 N)
stop when block.x > end
output twice = 2 * block.v
output place = 3 * block.x
output triple = 3 * block.v
";

#[test]
fn a_position_that_advances_settles_with_its_speed() {
    let model = model(PUSHED);
    let frequencies = [10.0, 20.0, 40.0];
    let prepare = |i: usize| design(&model, &[("f", frequencies[i])]);
    let outcomes = response(&frequencies, speed_named("block.v", &model), prepare)
        .until_settled(Settle::default())
        .run();
    for (f, outcome) in frequencies.iter().zip(outcomes) {
        let point = outcome.unwrap();
        assert_eq!(point.motion, Motion::Periodic, "at {f} Hz");
        assert!((point.speed - 0.5).abs() < 1e-6, "{point:?}");
        // The start fades with m / c, 1/40 s: by a millionth in 0.35 s.
        assert!(f64::from(point.cycles.start) < 0.5 * f + 2.0, "{point:?}");
    }
}

#[test]
fn speeds_are_rates_of_states_or_outputs_where_they_are_any() {
    let model = model(PUSHED);
    let system = design(&model, &[]).unwrap();
    let named = |name: &str| Quantity::named(name, &system).unwrap();
    assert_eq!(
        speed_named("block.v", &model),
        Speed::RateOf(named("block.x"))
    );
    assert_eq!(speed_named("triple", &model), Speed::RateOf(named("place")));
    assert_eq!(speed_named("twice", &model), Speed::Sampled(named("twice")));
    let error = Quantity::named("block.vv", &system)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("block.vv") && error.contains("`block.v`"),
        "{error}"
    );

    let frequencies = [10.0];
    let cycles = Cycles {
        warmup: 10,
        measured: 3,
    };
    let mean = |name: &str| {
        let speed = speed_named(name, &model);
        let outcomes = response(&frequencies, speed, |_| design(&model, &[]))
            .over(cycles)
            .run();
        outcomes[0].as_ref().unwrap().speed
    };
    assert!((mean("block.v") - 0.5).abs() < 1e-6);
    assert!((mean("triple") - 1.5).abs() < 1e-6);
    assert!((mean("twice") - 1.0).abs() < 1e-6);
    let model = self::model(&format!("{PUSHED}output still = 0 * block.v\n"));
    assert!(matches!(speed_named("still", &model), Speed::Sampled(_)));
}

#[test]
fn a_point_that_fails_leaves_the_others() {
    let model = model(PUSHED);
    let frequencies = [10.0, 0.0, 20.0, 40.0, -5.0];
    let prepare = |i: usize| match i {
        2 => design(&model, &[("m", -1.0)]),
        3 => design(&model, &[("end", 0.1)]),
        _ => design(&model, &[]),
    };
    let speed = speed_named("block.v", &model);
    for settle in [None, Some(Settle::default())] {
        let runs = response(&frequencies, speed, prepare);
        let outcomes = match settle {
            None => runs.run(),
            Some(settle) => runs.until_settled(settle).run(),
        };
        let message = |i: usize| outcomes[i].as_ref().unwrap_err().message.clone();
        assert!((outcomes[0].as_ref().unwrap().speed - 0.5).abs() < 1e-5);
        assert!(message(1).contains("no cycles at 0 Hz"), "{}", message(1));
        assert!(message(2).contains("mass"), "{}", message(2));
        assert!(
            message(3).contains("the run ended at t = "),
            "{}",
            message(3)
        );
        assert!(message(4).contains("-5 Hz"), "{}", message(4));
    }
}

/// Duffing's oscillator with two wells, ẍ + 0.3 ẋ − x + x³ = γ cos(1.2 t), whose motions for
/// several γ are those of D. W. Jordan and P. Smith, Nonlinear Ordinary Differential Equations,
/// 4th edition, 2007, section 9.3: periods 1, 2, 4, 5, chaos, and period 2 again.
const TWO_WELLS: &str = "\
model two_wells
param f = 1 Hz, gamma = 0.2 N
slide mass along (1, 0) { mass = 1 kg }
force on mass = (gamma * cos(2*pi*f*t) - 0.3 N*s/m * mass.v + 1 N/m * mass.x - 1 N/m^3 * mass.x^3, 0 N)
initial mass.x = 1 m
";

fn duffing(threads: usize) -> Vec<Outcome> {
    let model = model(TWO_WELLS);
    let gammas = [0.20, 0.28, 0.29, 0.37, 0.50, 0.65];
    let frequency = 1.2 / std::f64::consts::TAU;
    let speed = speed_named("mass.v", &model);
    let prepare = |i: usize| design(&model, &[("f", frequency), ("gamma", gammas[i])]);
    response(&[frequency; 6], speed, prepare)
        .until_settled(Settle {
            most_cycles: 200,
            ..Settle::default()
        })
        .threads(threads)
        .run()
}

#[test]
fn motions_of_duffings_oscillator() {
    let outcomes = duffing(0);
    let motions: Vec<Motion> = outcomes
        .iter()
        .map(|o| o.as_ref().unwrap().motion)
        .collect();
    let known = [
        Motion::Periodic,
        Motion::PeriodN(2),
        Motion::PeriodN(4),
        Motion::PeriodN(5),
    ];
    assert_eq!(motions[..4], known);
    assert_eq!(motions[5], Motion::PeriodN(2));
    let Motion::Chaotic { spread } = motions[4] else {
        panic!("{:?}", motions[4]);
    };
    assert!((0.01..1.0).contains(&spread), "{spread}");
    // It stays in place: over whole periods it gets nowhere.
    for outcome in outcomes
        .iter()
        .filter(|o| o.as_ref().unwrap().motion != motions[4])
    {
        let point = outcome.as_ref().unwrap();
        assert!(point.speed.abs() < 1e-6, "{point:?}");
        if let Motion::PeriodN(period) = point.motion {
            assert_eq!((point.cycles.end - point.cycles.start) % period, 0);
        }
    }
}

#[test]
fn results_do_not_depend_on_threads() {
    let outcomes = duffing(1);
    for threads in [2, 3] {
        let others = duffing(threads);
        for (a, b) in outcomes.iter().zip(others) {
            let (a, b) = (a.as_ref().unwrap(), b.unwrap());
            assert_eq!(a.speed.to_bits(), b.speed.to_bits());
            assert_eq!(*a, b);
        }
    }
}

/// A motion that dies down slowly is told from chaos: friction takes 1 % of the energy a cycle.
#[test]
fn a_slow_transient_is_no_chaos() {
    let model = model(
        "model slow\nparam f = 1 Hz\nslide mass along (1, 0) { mass = 1 kg }\n\
         spring k between ground and mass { stiffness = 100 N/m, damping = 0.01 N*s/m }\n\
         force on mass = (1 N * sin(2*pi*f*t), 0 N)\n",
    );
    let speed = speed_named("mass.v", &model);
    let outcomes = response(&[1.0], speed, |_| design(&model, &[]))
        .until_settled(Settle {
            most_cycles: 64,
            ..Settle::default()
        })
        .run();
    let point = outcomes[0].as_ref().unwrap();
    assert_eq!(
        (point.motion, point.cycles.clone()),
        (Motion::Transient, 32..64)
    );
}
