//! Measuring several implementations of one workload, turn about.

use crate::study::Outcome;
use crate::table::{Row, Table};

/// One implementation, as a workload calls it.
pub struct Candidate<'a> {
    /// Its name in the table.
    pub name: String,
    /// Cores that it may use.
    pub cores: usize,
    /// The share of what it does that counts: one over the number of trajectories, if time per
    /// trajectory is asked for.
    pub share: f64,
    /// Does it once.
    pub run: Box<dyn Fn() -> Result<Outcome, String> + 'a>,
}

/// Measures `candidates` in `rounds` rounds, after one that warms up and is checked, and adds a row for each whose outcome `check` accepts. The baseline is the
/// fastest of those on one core whose names begin with `baseline`. `note` says the same in the
/// workload's terms.
pub fn measure(
    table: &mut Table,
    workload: &str,
    rounds: usize,
    baseline: &str,
    candidates: Vec<Candidate<'_>>,
    check: &dyn Fn(&Outcome) -> Result<(), String>,
    note: &dyn Fn(&Outcome, f64) -> String,
) {
    let mut accepted = Vec::new();
    for candidate in candidates {
        eprintln!("  {}", candidate.name);
        match (candidate.run)().and_then(|outcome| check(&outcome).map(|()| outcome)) {
            Ok(outcome) => accepted.push((candidate, outcome, f64::INFINITY)),
            Err(why) => table.remark(format!("{workload} {}: no row; {why}", candidate.name)),
        }
    }
    for _ in 0..rounds {
        for (candidate, _, seconds) in &mut accepted {
            if let Ok(outcome) = (candidate.run)() {
                *seconds = seconds.min(outcome.seconds * candidate.share);
            }
        }
    }
    let base = accepted
        .iter()
        .filter(|(candidate, ..)| candidate.cores == 1 && candidate.name.starts_with(baseline))
        .map(|(_, _, seconds)| *seconds)
        .reduce(f64::min);
    for (candidate, outcome, seconds) in accepted {
        table.row(Row {
            workload: workload.to_owned(),
            note: note(&outcome, seconds),
            ratio: base.map(|base| base / seconds),
            implementation: candidate.name,
            cores: candidate.cores,
            seconds,
        });
    }
}
