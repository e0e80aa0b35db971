//! `flexure response`: mean speed of an actuator against its drive's frequency, the linear regime,
//! and the distance from an experiment.

mod picture;
mod report;

use std::path::PathBuf;

use clap::Args;
use flexure::Design;
use flexure::picture::with_unit;
use flexure::response::{Experiment, Outcome, Settle};
use flexure::runtime::diagnostic::Diagnostic;

use super::actuator::{Actuation, Actuator};
use super::axis::Axis;
use super::charts;
use super::settings::tolerance;
use super::terminal::Terminal;
use super::{Failure, print};
use report::Study;

/// Mean speed against the drive's frequency, and its linear regime
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure response models/double_rocker.flex --frequency f=100Hz..2000Hz:100Hz --speed stage.v
  flexure response models/double_rocker.flex --frequency f --speed stage.v --for Fp=1N,5N,10N,15N,20N -o preload.csv
  flexure response models/double_rocker.flex --frequency f --speed stage.v --for mu_s,mu_c='0.15,0.10;0.3,0.2'
  flexure response models/double_rocker.flex --frequency f --speed stage.v --settle --plot settled.html
  flexure response models/double_rocker.flex --frequency f=100Hz..1000Hz:100Hz --speed stage.v --experiment sun.csv

The mean speed is taken over cycles 10 to 30 of the drive, or as --warmup and --cycles say. With
--settle each motion is followed until the state at the start of each cycle repeats.
An experiment is a table with headings such as `frequency (Hz), speed (mm/s)`; its frequencies within
the range of the curve are simulated as well.")]
pub struct Arguments {
    #[command(flatten)]
    actuation: Actuation,
    /// A curve for each value: `Fp=1N,5N`, `Fp=1N..9N:2N`, `mu_s,mu_c=0.15,0.10;0.3,0.2`; several
    /// of these give a curve for each combination
    #[arg(long = "for", value_name = "PARAM=VALUES")]
    family: Vec<String>,
    /// Follow each motion until the state at the start of each cycle repeats within this share of
    /// its range
    #[arg(long, value_name = "TOLERANCE", num_args = 0..=1, require_equals = true, value_parser = tolerance, default_missing_value = "1e-6", conflicts_with_all = ["warmup", "cycles"])]
    settle: Option<f64>,
    /// Cycles after which a motion that has not settled is given up
    #[arg(long, value_name = "N", default_value_t = Settle::default().most_cycles, requires = "settle", value_parser = clap::value_parser!(u32).range(16..=1_000_000))]
    most_cycles: u32,
    /// Compare with measured speeds
    #[arg(long, value_name = "FILE.csv")]
    experiment: Option<PathBuf>,
    /// File for the table of points
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
    /// Picture of the curves (.svg), or a page with their numbers and the mechanism (.html)
    #[arg(long, value_name = "OUT.svg|.html", value_parser = charts::path)]
    plot: Option<PathBuf>,
}

/// A curve of the family.
struct Curve {
    /// What it is for: `Fp = 5 N`; empty if there is but one.
    label: String,
    /// Values of the family's params in SI.
    values: Vec<f64>,
    /// One for each frequency.
    outcomes: Vec<Outcome>,
}

/// Does it.
///
/// # Errors
///
/// If the call does not fit the model, the model is wrong, or a file cannot be read or written. A
/// point that fails is a row of the table.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let actuation = &arguments.actuation;
    let actuator = actuation.choose(terminal)?;
    let family = Family::new(&arguments.family, &actuator).map_err(Failure::setting)?;
    let experiment = arguments.experiment.as_deref();
    let experiment = experiment
        .map(|path| Experiment::from_path(path, &actuator.speed_unit))
        .transpose()
        .map_err(Failure::model)?;
    charts::keep_apart(arguments.output.as_deref(), arguments.plot.as_deref())?;
    let table = actuation.open(arguments.output.as_deref())?;
    let picture = actuation.open(arguments.plot.as_deref())?;
    let frequencies = with_measured(&actuator.frequencies, experiment.as_ref(), terminal);
    let settle = arguments.settle.map(|tolerance| Settle {
        tolerance,
        most_cycles: arguments.most_cycles,
    });
    let bar = terminal.progress();
    let all = actuation.drive(&actuator, &family.designs, &frequencies, &bar, settle);
    bar.finish_and_clear();
    let curves: Vec<Curve> = (family.labels.into_iter().zip(family.values).zip(all))
        .map(|((label, values), outcomes)| Curve {
            label,
            values,
            outcomes,
        })
        .collect();
    let study = Study {
        arguments,
        actuator: &actuator,
        family: &family.names,
        frequencies: &frequencies,
        curves: &curves,
        experiment: experiment.as_ref(),
    };
    print(|out| out.write_all(study.report().as_bytes()))?;
    study.say_failures(terminal);
    if let Some(table) = table {
        table.finish_with(&study.table(), terminal)?;
    }
    if let (Some(picture), Some(path)) = (picture, &arguments.plot) {
        picture.finish_with(&study.charts().file(path)?, terminal)?;
    }
    Ok(())
}

/// The designs of a family of curves.
#[derive(Default)]
struct Family {
    names: Vec<String>,
    labels: Vec<String>,
    values: Vec<Vec<f64>>,
    designs: Vec<Design>,
}

impl Family {
    fn new(written: &[String], actuator: &Actuator) -> Result<Self, Diagnostic> {
        let mut family = Self {
            names: Vec::new(),
            labels: vec![String::new()],
            values: vec![Vec::new()],
            designs: vec![actuator.chosen.design.clone()],
        };
        for text in written {
            family.extend(&Axis::parse(text, actuator.model())?, actuator)?;
        }
        Ok(family)
    }

    /// Each curve so far, with each value of another axis.
    fn extend(&mut self, axis: &Axis, actuator: &Actuator) -> Result<(), Diagnostic> {
        for name in &axis.names {
            if *name == actuator.frequency {
                return Err(
                    Diagnostic::error(format!("`{name}` is the drive's frequency"))
                        .hint("give its values with `--frequency`"),
                );
            }
            if self.names.contains(name) {
                return Err(Diagnostic::error(format!("`{name}` is given twice")));
            }
        }
        let before = std::mem::take(self);
        self.names = before.names;
        self.names.extend(axis.names.iter().cloned());
        for ((label, values), design) in before
            .labels
            .iter()
            .zip(&before.values)
            .zip(&before.designs)
        {
            for (index, more) in axis.values.iter().enumerate() {
                let mut design = design.clone();
                axis.apply(index, &mut design)?;
                let before = Some(label.clone()).filter(|label| !label.is_empty());
                let now = axis.described(index, actuator.model());
                let labels: Vec<String> = before.into_iter().chain([now]).collect();
                self.labels.push(labels.join(", "));
                self.values.push([values.as_slice(), more].concat());
                self.designs.push(design);
            }
        }
        Ok(())
    }
}

/// The frequencies of the curve, and those of the experiment in their range.
fn with_measured(
    frequencies: &[f64],
    experiment: Option<&Experiment>,
    terminal: &Terminal,
) -> Vec<f64> {
    let mut all = frequencies.to_vec();
    let (Some(experiment), [low, .., high] | [low @ high]) = (experiment, frequencies) else {
        return all;
    };
    let measured = experiment.points.iter().map(|point| point.0);
    let (inside, outside): (Vec<f64>, Vec<f64>) =
        measured.partition(|f| (*low..=*high).contains(f));
    if !outside.is_empty() {
        terminal.note(format_args!(
            "{} points of the experiment are outside of {} to {} and are left out",
            outside.len(),
            hertz(*low),
            hertz(*high)
        ));
    }
    all.extend(inside);
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

fn hertz(frequency: f64) -> String {
    with_unit(frequency, "Hz", 6)
}
