//! W1 to W5: the article's actuator, one trajectory and many.

use std::thread::available_parallelism;

use flexure_models::double_rocker::Params;

use crate::baseline::{Baseline, Program};
use crate::implementation::{Implementation, all};
use crate::measure::{Candidate, measure};
use crate::study::{End, Method, Outcome, STAGE_X, START, Study, difference, larger, relative};
use crate::table::Table;

/// Trajectories that are the same differ by no more than this at their ends, in each state.
const SAME: f64 = 1e-9;
/// Allowed relative error of the stage's position in W2.
const POSITION: f64 = 1e-6;
/// Allowed relative error of mean speeds in W4 and W5.
const SPEED: f64 = 1e-3;
/// A perturbation of 1e-9 rad that changes a mean speed by more than this grows.
const GROWN: f64 = 1e-5;
/// Tolerances that are tried, from the loosest.
const TOLERANCES: [f64; 14] = [
    1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 1e-9,
];
/// Steps in s that are tried, from the longest.
const STEPS: [f64; 6] = [4e-6, 2e-6, 1e-6, 5e-7, 2e-7, 1e-7];

/// Rounds of measurements of workloads that take fractions of a second, and of those that take
/// seconds.
const SHORT: usize = 5;
const LONG: usize = 2;

fn cores() -> usize {
    available_parallelism().map_or(1, |cores| cores.get())
}

/// A candidate that runs a study.
fn candidate<'a>(implementation: &'a Implementation, study: Study, per_run: bool) -> Candidate<'a> {
    Candidate {
        name: implementation.name.clone(),
        cores: study.threads,
        share: if per_run {
            1.0 / study.designs.len() as f64
        } else {
            1.0
        },
        run: Box::new(move || (implementation.run)(&study)),
    }
}

/// The end that all are compared with: that of C, or without it of the first there is.
fn reference(all: &[Implementation], study: &Study) -> Result<Vec<End>, String> {
    let first = all.first().ok_or("there is no implementation")?;
    (first.run)(study).map(|outcome| outcome.ends)
}

/// W1: one trajectory in a million steps.
pub fn one_trajectory(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let all = all(c);
    let study = Study {
        designs: vec![Params::default()],
        method: Method::Equal(1e-7),
        from: 0.0,
        until: 0.1,
        in_cycles: false,
        threads: 1,
    };
    let Ok(expected) = reference(&all, &study) else {
        return table.remark("W1: nothing to compare with");
    };
    let candidates = all.iter().map(|implementation| {
        let designs = vec![Params::default(); implementation.lanes];
        let study = Study {
            designs,
            ..study.clone()
        };
        candidate(implementation, study, true)
    });
    measure(
        table,
        "W1",
        SHORT,
        "C libm",
        candidates.collect(),
        &|outcome| {
            let worst = outcome
                .ends
                .iter()
                .map(|end| difference(&[*end], &expected, START))
                .fold(0.0, larger);
            within(worst, SAME, "its end state differs")
        },
        &|outcome, seconds| {
            let evaluations = outcome.evaluations as f64 / outcome.ends.len() as f64;
            format!("{:.1} ns a right-hand side", seconds / evaluations * 1e9)
        },
    );
}

/// W2: the same trajectory to an accuracy.
pub fn to_an_accuracy(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let all = all(c);
    let study = |tolerance| Study {
        designs: vec![Params::default()],
        method: Method::Adaptive(tolerance),
        from: 0.0,
        until: 0.1,
        in_cycles: false,
        threads: 1,
    };
    // The reference is that of the first implementation; both it and another converge to it.
    let mut expected = f64::NAN;
    for implementation in all.iter().filter(|one| {
        one.can(Method::Adaptive(1.0))
            && ["C libm", "flexure compiled simulate"].contains(&&*one.name)
    }) {
        let found: Vec<f64> = [1e-10, 1e-11, 1e-12, 1e-13]
            .into_iter()
            .filter_map(|tolerance| (implementation.run)(&study(tolerance)).ok())
            .map(|outcome| outcome.ends[0].state[STAGE_X])
            .collect();
        let Some(&last) = found.last() else { continue };
        if expected.is_nan() {
            expected = last;
        }
        let off: Vec<String> = found
            .iter()
            .map(|x| format!("{:.1e}", relative(*x, expected)))
            .collect();
        table.remark(format!(
            "W2 reference: stage.x = {expected:.12e} m; {} at 1e-10 … 1e-13 is off by {}",
            implementation.name,
            off.join(", ")
        ));
    }
    let accurate = |outcome: &Outcome| {
        let error = relative(outcome.ends[0].state[STAGE_X], expected);
        within(error, POSITION, "its position is wrong")
    };
    let candidates = all
        .iter()
        .filter_map(|implementation| {
            let tolerances = TOLERANCES.map(Method::Adaptive);
            let method = loosest(implementation, &study(1.0), &tolerances, &accurate)?;
            Some(candidate(implementation, study(method.setting()), false))
        })
        .collect();
    measure(
        table,
        "W2",
        SHORT,
        "C libm",
        candidates,
        &accurate,
        &|outcome, _| {
            let error = relative(outcome.ends[0].state[STAGE_X], expected);
            format!("{} evaluations, error {error:.1e}", outcome.evaluations)
        },
    );
}

/// W3: many trajectories in equal steps.
pub fn many_trajectories(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let all = all(c);
    let designs = (0..64).map(|i| Params {
        f: 100.0 + 1900.0 * f64::from(i) / 63.0,
        ..Params::default()
    });
    let study = Study {
        designs: designs.collect(),
        method: Method::Equal(2e-7),
        from: 0.0,
        until: 0.02,
        in_cycles: false,
        threads: 1,
    };
    let Ok(expected) = reference(&all, &study) else {
        return table.remark("W3: nothing to compare with");
    };
    measure(
        table,
        "W3",
        LONG,
        "C libm",
        on_one_core_and_all(&all, |_| Some(study.clone())),
        &|outcome| {
            within(
                difference(&outcome.ends, &expected, START),
                SAME,
                "its end states differ",
            )
        },
        &|outcome, seconds| {
            let count = outcome.ends.len() as f64;
            format!("{:.1} trajectories a second", count / seconds)
        },
    );
}

/// W4: figure 8 of the article.
pub fn preloads_and_frequencies(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let designs = [1.0, 5.0, 10.0, 15.0, 20.0]
        .into_iter()
        .flat_map(|preload| {
            (1..=20).map(move |i| Params {
                Fp: preload,
                f: 100.0 * f64::from(i),
                ..Params::default()
            })
        });
    speeds(c, table, "W4", designs.collect(), (10.0, 30.0));
}

/// W5: random designs.
pub fn designs(c: Option<&Baseline>, table: &mut Table, full: bool) {
    let count = if full { 10_000 } else { 256 };
    let mut random = Random(1);
    let mut designs = Vec::new();
    while designs.len() < count {
        let design = random.design();
        // Links that cannot close are no design.
        if design.prepare().is_ok() {
            designs.push(design);
        }
    }
    table.remark(format!(
        "W5: {count} designs{}",
        if full { "" } else { ", 10000 with `--full`" }
    ));
    speeds(c, table, "W5", designs, (10.0, 20.0));
}

/// Mean speeds between two numbers of cycles.
fn speeds(
    c: Option<&Baseline>,
    table: &mut Table,
    workload: &str,
    designs: Vec<Params>,
    (from, until): (f64, f64),
) {
    let Some(c) = c else {
        return table.remark(format!("{workload}: speeds are compared with those of C"));
    };
    let all = all(Some(c));
    let study = Study {
        designs,
        method: Method::Adaptive(1e-10),
        from,
        until,
        in_cycles: true,
        threads: cores(),
    };
    let (expected, steady) = match steady_ways(&c.libm, &study) {
        Ok(found) => found,
        Err(why) => return table.remark(format!("{workload}: no reference; {why}")),
    };
    let counted = steady.iter().filter(|steady| **steady).count();
    table.remark(format!(
        "{workload}: compared at {counted} of {} points, where a perturbation of 1e-9 rad does not grow",
        steady.len()
    ));
    let accurate = |outcome: &Outcome| {
        let worst = outcome
            .ends
            .iter()
            .zip(&expected)
            .zip(&steady)
            .filter(|(_, steady)| **steady)
            .map(|((end, expected), _)| (end.way() - expected).abs() / expected.abs())
            .fold(0.0, larger);
        within(worst, SPEED, "a mean speed is wrong")
    };
    // Those of one family step alike: the first of each finds the setting for all, and every row's
    // accuracy is checked.
    let mut chosen: Vec<(&Implementation, Method)> = Vec::new();
    for methods in [
        TOLERANCES.map(Method::Adaptive).to_vec(),
        STEPS.map(Method::Equal).to_vec(),
    ] {
        let mut found: Vec<(&str, Method)> = Vec::new();
        for implementation in all.iter().filter(|one| one.can(methods[0])) {
            let family = implementation.family();
            let known = found.iter().find(|(name, _)| *name == family);
            let method = match known {
                Some((_, method)) => Some(*method),
                None => loosest(implementation, &study, &methods, &accurate),
            };
            match method {
                Some(method) => {
                    found.push((family, method));
                    chosen.push((implementation, method));
                }
                None => table.remark(format!(
                    "{workload} {}: no row; not accurate enough at {:e}",
                    implementation.name,
                    methods[methods.len() - 1].setting()
                )),
            }
        }
    }
    let mut threads = vec![1, cores()];
    threads.dedup();
    let candidates = threads
        .into_iter()
        .flat_map(|threads| {
            let study = &study;
            chosen.iter().map(move |&(implementation, method)| {
                let study = Study {
                    threads,
                    ..study.with(method)
                };
                let mut candidate = candidate(implementation, study, false);
                candidate.name += &match method {
                    Method::Equal(step) => format!(", dt {step:.0e}"),
                    Method::Adaptive(tolerance) => format!(", tolerance {tolerance:.0e}"),
                };
                candidate
            })
        })
        .collect();
    measure(
        table,
        workload,
        LONG,
        "C libm",
        candidates,
        &accurate,
        &|outcome, seconds| {
            let memory = outcome.memory.map_or(String::new(), |bytes| {
                format!(", {:.1} MB", bytes as f64 / 1e6)
            });
            format!(
                "{:.1} designs a second, {} evaluations{memory}",
                outcome.ends.len() as f64 / seconds,
                outcome.evaluations
            )
        },
    );
}

/// The stage's ways in a study, and where they do not depend on a perturbation.
fn steady_ways(c: &Program, study: &Study) -> Result<(Vec<f64>, Vec<bool>), String> {
    let ways = |perturbation| -> Result<Vec<f64>, String> {
        let outcome = c.study(study, perturbation)?;
        Ok(outcome.ends.iter().map(End::way).collect())
    };
    let (plain, perturbed) = (ways(0.0)?, ways(1e-9)?);
    let steady = plain
        .iter()
        .zip(&perturbed)
        .map(|(a, b)| relative(*a, *b) <= GROWN)
        .collect();
    Ok((plain, steady))
}

/// The loosest of `methods` that `accurate` accepts together with the next tighter one.
fn loosest(
    implementation: &Implementation,
    study: &Study,
    methods: &[Method],
    accurate: &dyn Fn(&Outcome) -> Result<(), String>,
) -> Option<Method> {
    if !implementation.can(*methods.first()?) {
        return None;
    }
    eprintln!("  looking for the loosest setting: {}", implementation.name);
    let mut last = None;
    for &method in methods {
        let outcome = (implementation.run)(&study.with(method));
        let good = outcome.is_ok_and(|outcome| accurate(&outcome).is_ok());
        match (good, last) {
            (true, Some(method)) => return Some(method),
            (true, None) => last = Some(method),
            (false, _) => last = None,
        }
    }
    last
}

/// All implementations that a study can be made for, on one core and, where there are more, on all.
/// One trajectory after the other on the tape is left out: W1 has its time per right-hand side.
fn on_one_core_and_all<'a>(
    all: &'a [Implementation],
    study: impl Fn(&Implementation) -> Option<Study>,
) -> Vec<Candidate<'a>> {
    let mut threads = vec![1, cores()];
    threads.dedup();
    threads
        .into_iter()
        .flat_map(|threads| {
            let study = &study;
            all.iter().filter_map(move |implementation| {
                let study = Study {
                    threads,
                    ..study(implementation)?
                };
                let can = implementation.can(study.method)
                    && implementation.name != "flexure tape simulate";
                can.then(|| candidate(implementation, study, false))
            })
        })
        .collect()
}

fn within(found: f64, allowed: f64, what: &str) -> Result<(), String> {
    if found <= allowed {
        Ok(())
    } else {
        Err(format!("{what} by {found:.1e}, {allowed:.0e} is allowed"))
    }
}

/// A generator of equally distributed numbers (SplitMix64).
struct Random(u64);

impl Random {
    /// Between 0 and 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// All params within 20 % of their defaults, but for the drive: 800 Hz, and the share of the
    /// period in which it falls, rather than rises, within 20 %.
    fn design(&mut self) -> Params {
        let defaults = Params::default();
        let mut near = |value: f64| value * (0.8 + 0.4 * self.unit());
        let mut design = Params::from_values(defaults.values().map(&mut near));
        design.f = 800.0;
        design.rise = 1.0 - near(1.0 - defaults.rise);
        design
    }
}
