//! `flexure response`: mean speed of an actuator against its drive's frequency, the linear regime,
//! and the distance from an experiment.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use flexure::Design;
use flexure::response::{
    DEFINITIONS, Definition, Deviation, Experiment, LinearRegime, Motion, Outcome, Settle,
    linear_regime,
};
use flexure::runtime::diagnostic::Diagnostic;

use super::actuator::{Actuation, Actuator};
use super::axis::Axis;
use super::columns::columns;
use super::output::same_file;
use super::plot::frequency::{FrequencyCurve, FrequencyFigure, standalone};
use super::plot::scale::{self, DisplayUnit};
use super::settings::tolerance;
use super::terminal::Terminal;
use super::{Failure, csv, print};

/// Mean speed against the drive's frequency, and its linear regime
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure response models/double_rocker.flex --frequency f=100Hz..2000Hz:100Hz --speed stage.v
  flexure response models/double_rocker.flex --frequency f --speed stage.v --for Fp=1N,5N,10N,15N,20N -o preload.csv
  flexure response models/double_rocker.flex --frequency f --speed stage.v --for mu_s,mu_c='0.15,0.10;0.3,0.2'
  flexure response models/double_rocker.flex --frequency f --speed stage.v --settle
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
    /// Picture of the curves
    #[arg(long, value_name = "OUT.svg", value_parser = picture)]
    plot: Option<PathBuf>,
}

fn picture(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match path.extension() {
        Some(extension) if extension == "svg" => Ok(path),
        _ => Err("a picture of a response is a file that ends in .svg".to_owned()),
    }
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
    if let (Some(output), Some(plot)) = (&arguments.output, &arguments.plot)
        && same_file(output, plot)
    {
        return Err(Failure::usage(format!(
            "`{}` cannot be both the table and the picture",
            plot.display()
        )));
    }
    let table = actuation.open(arguments.output.as_deref())?;
    let plot = actuation.open(arguments.plot.as_deref())?;
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
    if let Some(plot) = plot {
        plot.finish_with(&study.figure(), terminal)?;
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
    scale::with_unit(frequency, "Hz", 6)
}

/// What a motion is called.
fn described(motion: Motion) -> String {
    match motion {
        Motion::Measured => "measured".to_owned(),
        Motion::Periodic => "periodic".to_owned(),
        Motion::PeriodN(period) => format!("period-{period}"),
        Motion::Transient => "transient".to_owned(),
        Motion::Chaotic { .. } => "chaotic".to_owned(),
    }
}

/// Everything that was found.
struct Study<'a> {
    arguments: &'a Arguments,
    actuator: &'a Actuator,
    family: &'a [String],
    frequencies: &'a [f64],
    curves: &'a [Curve],
    experiment: Option<&'a Experiment>,
}

impl Study<'_> {
    fn curve(&self, curve: &Curve) -> Vec<(f64, f64)> {
        let all = Actuator::curve(self.frequencies, &curve.outcomes);
        // Points of the experiment alone are not the curve's.
        let own = |point: &(f64, f64)| self.actuator.frequencies.contains(&point.0);
        all.into_iter().filter(own).collect()
    }

    /// Speed at a frequency of a curve.
    fn speed(&self, curve: &Curve, frequency: f64) -> Option<f64> {
        let index = self.frequencies.iter().position(|f| *f == frequency)?;
        curve.outcomes[index].as_ref().ok().map(|point| point.speed)
    }

    fn deviation(&self, curve: &Curve) -> Option<Deviation> {
        self.experiment?
            .deviation(|frequency| self.speed(curve, frequency))
    }

    /// The unit in which speeds read best.
    fn unit(&self) -> DisplayUnit {
        let speeds = self.curves.iter().flat_map(|curve| &curve.outcomes);
        let sizes = speeds.filter_map(|outcome| Some(outcome.as_ref().ok()?.speed.abs()));
        scale::display_unit(&self.actuator.speed_unit, sizes.fold(0.0, f64::max))
    }

    /// What a person reads.
    fn report(&self) -> String {
        let arguments = self.arguments;
        let mut text = format!("{}\n", self.actuator.speed_words);
        let _ = match arguments.settle {
            Some(tolerance) => writeln!(
                text,
                "until the state at the start of each cycle repeats to {tolerance:e} of its range, \
                 in at most {} cycles",
                arguments.most_cycles
            ),
            None => {
                let cycles = arguments.actuation.measured();
                let end = u64::from(cycles.warmup) + u64::from(cycles.measured);
                writeln!(text, "over cycles {} to {end}", cycles.warmup)
            }
        };
        text.push('\n');
        text.push_str(&self.speeds());
        text.push('\n');
        text.push_str(&self.regimes());
        if self.experiment.is_some() {
            text.push('\n');
            text.push_str(&self.deviations());
        }
        text
    }

    fn speeds(&self) -> String {
        let unit = self.unit();
        let heading = |curve: &Curve| match (curve.label.as_str(), unit.name.as_str()) {
            ("", "") => self.arguments.actuation.speed.clone(),
            ("", unit) => format!("{} ({unit})", self.arguments.actuation.speed),
            (label, "") => label.to_owned(),
            (label, unit) => format!("{label} ({unit})"),
        };
        let mut headings = vec![self.actuator.frequency.clone()];
        headings.extend(self.curves.iter().map(heading));
        let measured = |frequency: f64| {
            let points = self.experiment.map_or(&[][..], |e| &e.points);
            let found = points.iter().find(|point| point.0 == frequency);
            found.map_or(String::new(), |point| digits(point.1 / unit.factor))
        };
        if self.experiment.is_some() {
            headings.push("experiment".to_owned());
        }
        let rows = self
            .frequencies
            .iter()
            .enumerate()
            .map(|(index, &frequency)| {
                let mut row = vec![hertz(frequency)];
                row.extend(
                    self.curves
                        .iter()
                        .map(|curve| match &curve.outcomes[index] {
                            Ok(point) => {
                                let speed = digits(point.speed / unit.factor);
                                match point.motion {
                                    Motion::Measured | Motion::Periodic => speed,
                                    Motion::Chaotic { spread } => {
                                        format!(
                                            "{speed} ± {} chaotic",
                                            digits(spread / unit.factor)
                                        )
                                    }
                                    motion => format!("{speed} {}", described(motion)),
                                }
                            }
                            Err(_) => "failed".to_owned(),
                        }),
                );
                if self.experiment.is_some() {
                    row.push(measured(frequency));
                }
                row
            });
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    fn regimes(&self) -> String {
        let unit = self.unit();
        let headings = [
            "linear regime",
            "window",
            "points",
            "R²",
            "slope",
            "intercept",
            "mean speed",
        ];
        let rows = self.curves.iter().flat_map(|curve| {
            let points = self.curve(curve);
            DEFINITIONS.iter().map(move |definition| {
                let name = match curve.label.as_str() {
                    "" => definition.name.to_owned(),
                    label => format!("{label}: {}", definition.name),
                };
                let mut row = vec![name];
                match linear_regime(&points, definition) {
                    Some(found) => row.extend(self.regime(&found)),
                    None => row.push(too_short(&points, definition)),
                }
                row
            })
        });
        let headings: Vec<String> = headings
            .iter()
            .map(|heading| match (*heading, unit.name.as_str()) {
                ("intercept" | "mean speed", name) if !name.is_empty() => {
                    format!("{heading} ({name})")
                }
                _ => (*heading).to_owned(),
            })
            .collect();
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    fn regime(&self, found: &LinearRegime) -> [String; 6] {
        let unit = self.unit();
        // A speed over a frequency is a step: m/s per Hz is m.
        let step = match self.actuator.speed_unit.strip_suffix("/s") {
            Some(step) => scale::with_unit(found.slope, step, 5),
            None => format!("{} {}/Hz", digits(found.slope), self.actuator.speed_unit),
        };
        [
            format!("{} to {}", hertz(found.from), hertz(found.to)),
            found.points.to_string(),
            format!("{:.4}", found.r_squared),
            step,
            digits(found.intercept / unit.factor),
            digits(found.mean_speed / unit.factor),
        ]
    }

    fn deviations(&self) -> String {
        let headings = ["error against the experiment", "points", "RMSE", "relative"];
        let headings: Vec<String> = headings.iter().map(|h| (*h).to_owned()).collect();
        let rows = self.curves.iter().map(|curve| {
            let mut row = vec![curve.label.clone()];
            match self.deviation(curve) {
                Some(found) => row.extend([
                    found.points.to_string(),
                    scale::with_unit(found.absolute, &self.actuator.speed_unit, 5),
                    found.relative.map_or("–".to_owned(), |relative| {
                        format!("{} %", scale::number(100.0 * relative, 4))
                    }),
                ]),
                None => row.push("none".to_owned()),
            }
            row
        });
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    /// The curves as SVG, with the linear regimes from the lowest frequency.
    fn figure(&self) -> String {
        let curve = |curve: &Curve| {
            let points = self.curve(curve);
            let ends = |found: LinearRegime| {
                [found.from, found.to].map(|f| (f, found.intercept + found.slope * f))
            };
            FrequencyCurve {
                name: curve.label.clone(),
                line: linear_regime(&points, &DEFINITIONS[3]).map(ends),
                points,
            }
        };
        standalone(&FrequencyFigure {
            title: self.actuator.model().name(),
            speed: &self.arguments.actuation.speed,
            unit: &self.actuator.speed_unit,
            curves: self.curves.iter().map(curve).collect(),
            measured: self.experiment.map_or(&[], |e| &e.points),
        })
    }

    /// The points as a table of comma-separated values.
    fn table(&self) -> String {
        let mut text = String::new();
        let speed = format!("mean({})", self.arguments.actuation.speed);
        let mut names: Vec<&str> = self.family.iter().map(String::as_str).collect();
        names.extend([
            self.actuator.frequency.as_str(),
            &speed,
            "from_cycle",
            "to_cycle",
        ]);
        names.extend(["motion", "spread", "experiment", "status", "message"]);
        csv::push_header(&mut text, names.into_iter());
        for curve in self.curves {
            for (&frequency, outcome) in self.frequencies.iter().zip(&curve.outcomes) {
                let mut fields: Vec<String> = curve
                    .values
                    .iter()
                    .map(|value| csv::number(*value))
                    .collect();
                fields.push(csv::number(frequency));
                let points = self.experiment.map_or(&[][..], |e| &e.points);
                let measured = points.iter().find(|point| point.0 == frequency);
                let measured = measured.map_or(String::new(), |point| csv::number(point.1));
                match outcome {
                    Ok(point) => fields.extend([
                        csv::number(point.speed),
                        point.cycles.start.to_string(),
                        point.cycles.end.to_string(),
                        described(point.motion),
                        match point.motion {
                            Motion::Chaotic { spread } => csv::number(spread),
                            _ => String::new(),
                        },
                        measured,
                        "ok".to_owned(),
                        String::new(),
                    ]),
                    Err(why) => {
                        fields.extend([const { String::new() }; 5]);
                        fields.extend([measured, "failed".to_owned(), why.message.clone()]);
                    }
                }
                csv::push_fields(&mut text, &fields);
            }
        }
        text
    }

    /// Says why points failed: each reason once, with the points that it is the reason for.
    fn say_failures(&self, terminal: &Terminal) {
        let mut reasons: Vec<(String, Vec<String>)> = Vec::new();
        for curve in self.curves {
            for (&frequency, outcome) in self.frequencies.iter().zip(&curve.outcomes) {
                let Err(why) = outcome else { continue };
                let place = match curve.label.as_str() {
                    "" => hertz(frequency),
                    label => format!("{label} at {}", hertz(frequency)),
                };
                match reasons
                    .iter_mut()
                    .find(|(reason, _)| *reason == why.message)
                {
                    Some((_, places)) => places.push(place),
                    None => reasons.push((why.message.clone(), vec![place])),
                }
            }
        }
        for (reason, places) in reasons {
            let shown = places
                .iter()
                .take(3)
                .cloned()
                .collect::<Vec<_>>()
                .join("; ");
            let more = match places.len().saturating_sub(3) {
                0 => String::new(),
                more => format!(" and at {more} more points"),
            };
            terminal.note(format_args!("failed: {shown}{more}: {reason}"));
        }
    }
}

/// Where there is no linear regime: whether one fits that has too few points.
fn too_short(points: &[(f64, f64)], definition: &Definition) -> String {
    let shorter = Definition {
        least_points: DEFINITIONS[0].least_points,
        ..*definition
    };
    match linear_regime(points, &shorter) {
        Some(found) => format!("none: {} points to {}", found.points, hertz(found.to)),
        None => "none".to_owned(),
    }
}

/// A number in a table.
fn digits(value: f64) -> String {
    scale::number(value, 6)
}
