//! The whole program, from its start to its exit, beside the integration alone.

use std::process::{Command, Stdio};
use std::time::Instant;

use flexure::simulate;
use flexure_models::double_rocker::Params;

use crate::baseline::Baseline;
use crate::measure::{Candidate, measure};
use crate::study::{End, Method, Outcome, STAGE_X, Study, relative};
use crate::table::Table;

/// Rounds of measurements.
const ROUNDS: usize = 5;
/// The command's own tolerance.
const TOLERANCE: f64 = 1e-8;
const UNTIL: f64 = 0.02;
/// The stage's position at the end may be off by this, of itself.
const SAME: f64 = 1e-5;
const MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/double_rocker.flex");

/// `flexure simulate models/double_rocker.flex --until 20ms`, as a process.
fn command() -> Result<Outcome, String> {
    let table = crate::table::target().join("start_to_exit.csv");
    let start = Instant::now();
    let status = Command::new(env!("CARGO_BIN_EXE_flexure"))
        .args(["simulate", MODEL, "--until", "20ms", "-q", "-o"])
        .arg(&table)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .map_err(|why| why.to_string())?;
    let seconds = start.elapsed().as_secs_f64();
    if !status.success() {
        return Err("the command failed".to_owned());
    }
    let text = std::fs::read_to_string(&table).map_err(|why| why.to_string())?;
    let place = |line: &str, name: &str| line.split(',').position(|word| word == name);
    let x = text.lines().next().and_then(|head| place(head, "stage.x"));
    let x = x.and_then(|place| text.lines().last()?.split(',').nth(place)?.parse().ok());
    Ok(at_the_end(seconds, 0, x.ok_or("the table has no stage.x")?))
}

fn at_the_end(seconds: f64, evaluations: u64, x: f64) -> Outcome {
    let mut end = End::default();
    end.state[STAGE_X] = x;
    Outcome {
        seconds,
        evaluations,
        memory: None,
        ends: vec![end],
    }
}

/// The same run on the tape, in this process.
fn integration() -> Result<Outcome, String> {
    let model = flexure::Model::from_path(MODEL).map_err(|why| why.to_string())?;
    let system = model.design().prepare().map_err(|why| why.message)?;
    let start = Instant::now();
    let run = simulate(&system)
        .until(UNTIL)
        .rtol(TOLERANCE)
        .every(UNTIL / 2000.0)
        .run()
        .map_err(|failure| failure.breakdown.message)?;
    let seconds = start.elapsed().as_secs_f64();
    let x = run.column("stage.x").last();
    Ok(at_the_end(seconds, run.statistics().evaluations, x))
}

/// Both, and the same of C.
pub fn start_to_exit(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let study = Study {
        designs: vec![Params::default()],
        method: Method::Adaptive(TOLERANCE),
        from: 0.0,
        until: UNTIL,
        in_cycles: false,
        threads: 1,
    };
    let mut candidates: Vec<Candidate<'_>> = Vec::new();
    let mut add = |name: &str, run: Box<dyn Fn() -> Result<Outcome, String>>| {
        candidates.push(Candidate {
            name: name.to_owned(),
            cores: 1,
            share: 1.0,
            run,
        });
    };
    if let Some(c) = c.cloned() {
        let (program, study_again) = (c.libm.clone(), study.clone());
        add(
            "C libm, start to exit",
            Box::new(move || {
                let start = Instant::now();
                let mut outcome = program.study(&study_again, 0.0)?;
                outcome.seconds = start.elapsed().as_secs_f64();
                Ok(outcome)
            }),
        );
        let study = study.clone();
        add(
            "C libm, integration alone",
            Box::new(move || c.libm.study(&study, 0.0)),
        );
    }
    add("flexure tape, start to exit", Box::new(command));
    add("flexure tape, integration alone", Box::new(integration));
    let Ok(expected) = integration().map(|outcome| outcome.ends[0].state[STAGE_X]) else {
        return table.remark("program: nothing to compare with");
    };
    measure(
        table,
        "20 ms of motion",
        ROUNDS,
        "C libm, start to exit",
        candidates,
        &|outcome| {
            let error = relative(outcome.ends[0].state[STAGE_X], expected);
            if error <= SAME {
                Ok(())
            } else {
                Err(format!("its position differs by {error:.1e}"))
            }
        },
        &|_, seconds| format!("{:.2} ms", seconds * 1e3),
    );
}
