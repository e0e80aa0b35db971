//! Tables against the closed forms that they stand for: the same right-hand side, the same
//! trajectories, the same balance of energy, and what a run says of them.

mod support;

use flexure_models::double_rocker::Params;
use flexure_runtime::simulate::{Run, simulate};
use flexure_runtime::system::System;
use flexure_runtime::table::TableReport;
use flexure_runtime::tape::TapePrepared;
use support::four_bars::Layout;
use support::random::Random;
use support::{compile, model_names, shipped, tape, tape_model};

/// Largest error of a table relative to the size of its functions, where their closed forms have no
/// more rounding than that.
const ROUNDING: f64 = 1e-13;
/// Coefficients are multiplied by forces and added up: by that much their errors may stand out of
/// the largest rate.
const CANCELLING: f64 = 10.0;

/// The right-hand side at random states whose coordinates are anywhere in the intervals, by tables
/// and in closed form; returns the largest error relative to the largest size of each entry, and
/// to the errors that the tables report.
fn compare(tabulated: &TapePrepared, random: &mut Random) -> f64 {
    let exact = tabulated.clone().exact();
    assert!(exact.tables().is_empty());
    let reports = tabulated.tables();
    let error = |report: &TableReport| report.error.max(ROUNDING);
    let allowed = reports.iter().map(error).fold(ROUNDING, f64::max);
    let n = tabulated.states().len();
    let u = vec![0.0; tabulated.inputs().len()];
    let (mut x0, mut d0) = (vec![0.0; n], vec![0.0; tabulated.discretes().len()]);
    tabulated.start(&mut x0, &mut d0);
    let (mut sizes, mut errors) = (vec![0.0_f64; n], vec![0.0_f64; n]);
    for _ in 0..40 {
        let mut x: Vec<f64> = x0
            .iter()
            .zip(tabulated.states())
            .map(|(x, row)| {
                let scale = match row.unit.as_ref() {
                    "m" => 1e-6,
                    "m/s" => 1e-2,
                    _ => 1.0,
                };
                x + scale * random.between(-1.0, 1.0)
            })
            .collect();
        for report in &reports {
            x[report.coordinate] = report.center + report.half_width * random.between(-1.0, 1.0);
        }
        let mut d = d0.clone();
        exact.accept(0.0, &x, &u, &mut d);
        assert!(!tabulated.is_outside_tables(&x));
        let (mut by_table, mut closed) = (vec![0.0; n], vec![0.0; n]);
        tabulated.rhs(0.0, &x, &d, &u, &mut by_table);
        exact.rhs(0.0, &x, &d, &u, &mut closed);
        for i in 0..n {
            sizes[i] = sizes[i].max(closed[i].abs());
            errors[i] = errors[i].max((by_table[i] - closed[i]).abs());
        }
        // Just outside it is the closed form itself.
        for report in &reports {
            x[report.coordinate] = report.center + 1.001 * report.half_width;
        }
        if !reports.is_empty() {
            assert!(tabulated.is_outside_tables(&x));
        }
        tabulated.rhs(0.0, &x, &d, &u, &mut by_table);
        exact.rhs(0.0, &x, &d, &u, &mut closed);
        for (a, b) in by_table.iter().zip(&closed) {
            assert_eq!(a.to_bits(), b.to_bits());
        }
    }
    let relative = sizes.iter().zip(&errors).map(
        |(size, error)| {
            if *error == 0.0 { 0.0 } else { error / size }
        },
    );
    relative.fold(0.0, f64::max) / allowed
}

#[test]
fn right_hand_sides_of_every_model() {
    let mut random = Random::new(1);
    for name in model_names() {
        let prepared = tape(&shipped(&name), &[]);
        let found = compare(&prepared, &mut random);
        println!("{name}: {found:.1e} times the tables' errors");
        assert!(found < CANCELLING, "{name}: {found}");
    }
}

/// Number of functions of each table.
#[test]
fn tables_are_where_they_pay() {
    let expected: [(&str, &[usize]); 8] = [
        ("double_rocker", &[6]),
        ("four_bar", &[2]),
        ("andrews", &[2]),
        ("xy_stage", &[4]),
        ("lugre_mass", &[]),
        ("msdm", &[]),
        ("pendulum", &[]),
        ("five_bar", &[]),
    ];
    for (name, functions) in expected {
        let reports = tape(&shipped(name), &[]).tables();
        let counts: Vec<usize> = reports.iter().map(|report| report.functions).collect();
        assert_eq!(counts, functions, "{name}");
        for report in reports {
            assert!(report.half_width > 0.0 && report.degree <= 12, "{report:?}");
            assert!(report.error <= ROUNDING, "{report:?}");
        }
    }
}

#[test]
fn random_four_bars() {
    let mut random = Random::new(2);
    let (mut compared, mut fitted, mut worst) = (0, 0, 0.0_f64);
    for layout in Layout::all() {
        let compiled = compile("four_bar.flex", &layout.text());
        let model = tape_model(&compiled);
        for _ in 0..12 {
            let Some(dimensions) = layout.dimensions(&mut random) else {
                continue;
            };
            let Ok(prepared) = model.prepare(&compiled.params(&dimensions.values)) else {
                continue;
            };
            let reports = prepared.tables();
            assert_eq!(reports.len(), 1);
            compared += 1;
            if reports[0].half_width > 0.0 {
                fitted += 1;
                let found = compare(&prepared, &mut random);
                worst = worst.max(found);
                let values = &dimensions.values;
                assert!(found < CANCELLING, "{layout:?} {values:?}: {found}");
            }
        }
    }
    println!("{fitted} of {compared} four-bars have a table; {worst:.1} times their errors");
    assert!(compared > 100);
    assert!(10 * fitted > 9 * compared, "{fitted} of {compared}");
}

/// Rows every 0.1 ms of twenty cycles of the drive, by equal steps.
fn twenty_cycles(system: &dyn System, energy: bool) -> Run {
    simulate(system)
        .until(20e-3)
        .dt(2.5e-7)
        .every(1e-4)
        .energy(energy)
        .run()
        .unwrap()
}

#[test]
fn the_same_twenty_cycles() {
    let tabulated = tape(&shipped("double_rocker"), &[]);
    let exact = tabulated.clone().exact();
    let (by_table, closed) = (twenty_cycles(&tabulated, true), twenty_cycles(&exact, true));
    assert_eq!(by_table.statistics().outside_tables, 0);
    same(&tabulated, &by_table, &closed);
    let largest = |run: &Run, column: &str| {
        let values = run.column(column);
        values.values().iter().map(|x| x.abs()).fold(0.0, f64::max)
    };
    let [with, without] = [&by_table, &closed].map(|run| largest(run, "energy.balance"));
    let supplied = largest(&closed, "energy.supplied");
    println!("balance {with:e}, {without:e} in closed form, of {supplied:e}");
    assert!(with <= without + 1e-12 * supplied, "{with:e} {without:e}");
}

/// A compiled model has a curve besides.
#[test]
fn the_same_twenty_cycles_compiled() {
    let tabulated = Params::default().prepare().unwrap();
    assert_eq!(tabulated.curves().len(), 1);
    let exact = tabulated.clone().exact();
    assert!(exact.curves().is_empty());
    let (by_table, closed) = (
        twenty_cycles(&tabulated, false),
        twenty_cycles(&exact, false),
    );
    same(&tabulated, &by_table, &closed);
}

/// Two runs of a system are the same motion.
fn same(system: &dyn System, by_table: &Run, closed: &Run) {
    for state in system.states() {
        let (a, b) = (by_table.column(&state.name), closed.column(&state.name));
        let start = b.values()[0];
        let size = b
            .values()
            .iter()
            .map(|x| (x - start).abs())
            .fold(0.0, f64::max);
        let pairs = a.values().iter().zip(b.values());
        let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("{}: {:.1e}", state.name, error / size);
        assert!(error <= 1e-9 * size, "{}: {:e}", state.name, error / size);
    }
}

#[test]
fn steps_outside_are_counted_and_the_motion_is_the_same() {
    let tabulated = tape(&shipped("andrews"), &[]);
    let exact = tabulated.clone().exact();
    let run = |system: &TapePrepared| {
        let run = simulate(system).until(0.02).dt(1e-5).run();
        run.unwrap()
    };
    let (by_table, closed) = (run(&tabulated), run(&exact));
    let statistics = by_table.statistics();
    assert!(statistics.outside_tables > 0, "{statistics:?}");
    assert!(
        statistics.outside_tables < statistics.accepted,
        "{statistics:?}"
    );
    assert_eq!(closed.statistics().outside_tables, 0);
    for state in tabulated.states() {
        let [a, b] = [&by_table, &closed].map(|run| run.column(&state.name).last());
        assert!((a - b).abs() <= 1e-9 * b.abs(), "{}: {a} {b}", state.name);
    }
}

/// Tables depend on the parameter set alone: prepared again they are the same, bit for bit.
#[test]
fn tables_are_the_same_each_time() {
    let compiled = shipped("double_rocker");
    let reports = [0, 1].map(|_| tape(&compiled, &[]).tables());
    assert_eq!(reports[0], reports[1]);
    let narrow = tape(&compiled, &[("stroke", 1e-7)]).tables();
    assert_ne!(reports[0], narrow);
}
