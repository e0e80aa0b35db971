//! `flexure static`: equilibrium, amplification ratios and stiffness.

use clap::Args;
use flexure::picture::{number, pretty_unit, with_unit};
use flexure::statics::{Equilibrium, Statics};

use super::held::{self, AtRest};
use super::terminal::Terminal;
use super::{Failure, print};

/// Find the equilibrium under preload and constant drive, amplification ratios and stiffness
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure static models/bridge_amplifier.flex
  flexure static models/double_rocker.flex --without tip --drive xp=10um --output C.x
  flexure static models/double_rocker.flex --stick tip

Ratio and stiffness are slopes at the equilibrium. A ratio is what a result moves per unit of a
drive, all following; a stiffness is the force in the direction of a result that moves it by one
unit, drives held; input stiffness is that of the mechanism as a drive's spring or stack sees it.
Contacts as they are stick at rest, and are checked against the friction that holds.")]
pub struct Arguments {
    #[command(flatten)]
    at_rest: AtRest,
    /// Results of which ratio and stiffness are wanted, such as stage.x [default: the model's outputs]
    #[arg(long, value_name = "NAME")]
    output: Vec<String>,
}

/// Does it.
///
/// # Errors
///
/// If a setting does not fit the model, or there is no equilibrium.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let (chosen, statics) = arguments.at_rest.choose(terminal)?;
    let rest = statics
        .prepare(chosen.design.values())
        .map_err(Failure::model)?;
    let held = arguments.at_rest.held(&chosen, &statics, &rest)?;
    let outputs: Vec<usize> = match arguments.output.is_empty() {
        true => (0..statics.output_count()).collect(),
        false => {
            let names = arguments.output.iter();
            names
                .map(|name| held::result(&statics, name))
                .collect::<Result<_, _>>()?
        }
    };
    let first = rest.equilibrium(None, &held).map_err(Failure::model)?;
    let full = rest
        .full_stroke()
        .filter(|_| arguments.at_rest.drive.is_empty());
    let second = match &full {
        Some(full) => Some(
            rest.equilibrium(Some(&first), full)
                .map_err(Failure::model)?,
        ),
        None => None,
    };
    let mut rows = Vec::new();
    let heading = |words: &str| vec![words.to_owned()];
    rows.push(match second {
        Some(_) => vec![
            "equilibrium".to_owned(),
            "at start".to_owned(),
            "at full stroke".to_owned(),
        ],
        None => heading("equilibrium"),
    });
    let mut row = |name: &str, unit: &str, value: f64, other: Option<f64>| {
        let shown = |value| with_unit(value, unit, 8);
        let mut cells = vec![format!("  {name}"), shown(value)];
        cells.extend(other.map(shown));
        rows.push(cells);
    };
    for (index, signal) in statics.held().iter().enumerate() {
        let unit = signal.dimension.si_unit();
        row(
            &signal.name,
            &unit,
            held[index],
            full.as_ref().map(|full| full[index]),
        );
    }
    for (index, state) in statics.states().iter().enumerate().step_by(2) {
        let value = |at: &Equilibrium| at.states()[index];
        row(
            &state.name,
            &state.unit,
            value(&first),
            second.as_ref().map(value),
        );
    }
    let count = statics.output_count();
    let is_state = |output: usize| {
        let states = statics.states().iter();
        states
            .step_by(2)
            .any(|state| state.name == statics.results()[output].name)
    };
    let more = outputs.iter().copied();
    let more = more.filter(|&output| output >= count && !is_state(output));
    for index in (0..count).chain(more) {
        let result = &statics.results()[index];
        let value = |at: &Equilibrium| at.results()[index];
        row(
            &result.name,
            &result.unit,
            value(&first),
            second.as_ref().map(value),
        );
    }
    for name in first.free() {
        rows.push(vec![format!(
            "  {name} is free: nothing elastic holds it, it stays"
        )]);
    }
    for (index, signal) in statics.held().iter().enumerate() {
        rows.push(heading(&format!("ratio to {}", signal.name)));
        for &output in &outputs {
            let result = &statics.results()[output];
            let ratio = first.ratio(output, index);
            let per = over(&result.unit, &signal.dimension.si_unit());
            rows.push(vec![format!("  {}", result.name), shown_ratio(ratio, &per)]);
        }
    }
    rows.push(heading("stiffness"));
    for (name, value, unit) in stiffnesses(&statics, &first, &outputs) {
        rows.push(vec![format!("  {name}"), with_unit(value, unit, 7)]);
    }
    print_table(&rows)
}

/// Input stiffness at each spring that a drive expands, and that at each output that is a place.
fn stiffnesses(
    statics: &Statics,
    at: &Equilibrium,
    outputs: &[usize],
) -> Vec<(String, f64, &'static str)> {
    let mut found = Vec::new();
    let results = statics.results();
    for (index, signal) in statics.held().iter().enumerate() {
        if !signal.is_drive || signal.dimension.si_unit() != "m" {
            continue;
        }
        for (force, row) in results.iter().enumerate().skip(statics.output_count()) {
            let Some(spring) = row.name.strip_suffix(".force") else {
                continue;
            };
            let extension = format!("{spring}.extension");
            let own = at.direct(force, index);
            let Some(extension) = results.iter().position(|row| row.name == extension) else {
                continue;
            };
            if own != 0.0 {
                let name = format!("input, at {spring}");
                found.push((name, at.stiffness(extension) - own, "N/m"));
            }
        }
    }
    for &output in outputs {
        let unit = match &*results[output].unit {
            "m" => "N/m",
            "rad" => "N*m/rad",
            _ => continue,
        };
        let stiffness = at.stiffness(output);
        if stiffness.is_finite() {
            found.push((format!("at {}", results[output].name), stiffness, unit));
        }
    }
    found
}

/// The unit of a ratio in words; nothing where both units are the same.
pub fn over(unit: &str, by: &str) -> String {
    match (unit == by, unit, by) {
        (true, ..) => String::new(),
        (_, unit, "1") => unit.to_owned(),
        (_, unit, by) => format!("{unit} per {by}"),
    }
}

fn shown_ratio(ratio: f64, unit: &str) -> String {
    format!("{} {}", number(ratio, 6), pretty_unit(unit))
}

/// Prints cells in columns.
///
/// # Errors
///
/// If standard output cannot be written to.
pub fn print_table(rows: &[Vec<String>]) -> Result<(), Failure> {
    let mut widths = [0; 8];
    for row in rows.iter().filter(|row| row.len() > 1) {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    print(|out| {
        for row in rows {
            let cells = row.iter().zip(widths);
            let line: Vec<String> = cells
                .map(|(cell, width)| format!("{cell:width$}"))
                .collect();
            writeln!(out, "{}", line.join("  ").trim_end())?;
        }
        Ok(())
    })
}
