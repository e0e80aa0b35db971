//! `flexure check`: what a model says, assembled, and what its author should know.

use clap::Args;
use flexure::runtime::simulate::simulate;

use super::settings::Settings;
use super::terminal::Terminal;
use super::{Failure, print};

/// Say what a model describes: bodies, joints, loops, degrees of freedom, closed angles, dead points, warnings
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure check models/double_rocker.flex
  flexure check models/double_rocker.flex --use table2
  flexure check models/double_rocker.flex --set 'l2 = 24 mm'      does it still assemble")]
pub struct Arguments {
    #[command(flatten)]
    settings: Settings,
}

/// Steps of a run from the start that show which method suits, and when it ends at last, in s.
const PROBE_STEPS: u64 = 2000;
const PROBE_TIME: f64 = 1.0;

/// Does it.
///
/// # Errors
///
/// If the model is wrong or cannot be assembled with these params.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let chosen = arguments.settings.choose(terminal)?;
    let mut assembled = chosen.design.assembled().map_err(Failure::model)?;
    let mut facts = assembled.facts();
    let system = chosen.design.prepare().map_err(Failure::model)?;
    let probe = simulate(&system).until(PROBE_TIME).probe(PROBE_STEPS);
    facts.push(("first steps".to_owned(), probe.statistics.steps()));
    let model = chosen.design.model();
    let width = facts
        .iter()
        .map(|(subject, _)| subject.chars().count())
        .max()
        .unwrap_or(0);
    print(|out| {
        writeln!(out, "model {}", model.name())?;
        let mut last = "";
        for (subject, words) in &facts {
            let shown = if subject == last { "" } else { subject };
            writeln!(out, "  {shown:width$}  {words}")?;
            last = subject;
        }
        let warnings = model.warnings().len();
        match warnings {
            0 => writeln!(out, "no warnings"),
            1 => writeln!(out, "1 warning"),
            _ => writeln!(out, "{warnings} warnings"),
        }
    })
}
