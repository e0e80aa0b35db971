//! `flexure modes`: modes, frequency response and the linear model about an equilibrium.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use flexure::model_dsl::units::{Dimension, parse_quantity};
use flexure::picture::{Axis, Chart, Graphic, Look, Panel, Series, number, pretty_unit, with_unit};
use flexure::statics::{Linear, Mode, Statics};
use num_traits::ToPrimitive;

use super::charts::{self, Charts};
use super::csv;
use super::held::{self, AtRest};
use super::output::{self, OutputFile};
use super::statics::{over, print_table};
use super::terminal::Terminal;
use super::{Failure, print};

/// Find the modes about the equilibrium, a frequency response, or the linear model A, B, C, D
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure modes models/double_rocker.flex --without tip
  flexure modes models/double_rocker.flex --stick tip --matrices linear
  flexure modes models/xy_stage.flex --response ux:x --from 10Hz --to 1kHz -o response.csv
  flexure modes models/xy_stage.flex --response ux:x --to 1kHz --plot response.html

--matrices PREFIX writes PREFIX_A.csv to PREFIX_D.csv, without header, and PREFIX_names.csv with
what rows and columns stand for. Read them with numpy.loadtxt(\"PREFIX_A.csv\", delimiter=\",\", ndmin=2)
or MATLAB's readmatrix(\"PREFIX_A.csv\"). A drive is two inputs: its value and its rate in time.")]
pub struct Arguments {
    #[command(flatten)]
    at_rest: AtRest,
    /// Files for the linear model
    #[arg(long, value_name = "PREFIX")]
    matrices: Option<PathBuf>,
    /// Frequency response from a drive or input to a result, as CSV instead of the modes
    #[arg(long, value_name = "DRIVE:RESULT")]
    response: Option<String>,
    /// Lowest frequency of the response
    #[arg(long, value_name = "F", value_parser = frequency, default_value = "10Hz", requires = "response")]
    from: f64,
    /// Highest frequency of the response
    #[arg(long, value_name = "F", value_parser = frequency, default_value = "100kHz", requires = "response")]
    to: f64,
    /// Number of its points, evenly spaced on a logarithmic scale
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1_000_000), default_value = "400", requires = "response")]
    points: u32,
    /// File for the response; standard output without it
    #[arg(short, long, value_name = "OUT.csv", requires = "response")]
    output: Option<PathBuf>,
    /// Picture of the response (.svg), or a page with its numbers and the mechanism (.html)
    #[arg(long, value_name = "OUT.svg|.html", requires = "response", value_parser = charts::path)]
    plot: Option<PathBuf>,
}

fn frequency(text: &str) -> Result<f64, String> {
    let (value, unit) = parse_quantity(text)?;
    if unit.is_some_and(|unit| unit != Dimension::FREQUENCY) {
        return Err("a frequency is wanted, as in 10Hz".to_owned());
    }
    match value.to_f64() {
        Some(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("a frequency above zero is wanted".to_owned()),
    }
}

/// Does it.
///
/// # Errors
///
/// If a setting does not fit the model, there is no equilibrium, or a file cannot be written.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    if arguments.from >= arguments.to {
        return Err(Failure::usage("`--from` must be below `--to`"));
    }
    for path in [&arguments.output, &arguments.plot].into_iter().flatten() {
        output::spare_model(path, &arguments.at_rest.settings.file)?;
    }
    charts::keep_apart(arguments.output.as_deref(), arguments.plot.as_deref())?;
    let (chosen, statics) = arguments.at_rest.choose(terminal)?;
    let rest = statics
        .prepare(chosen.design.values())
        .map_err(Failure::model)?;
    let held = arguments.at_rest.held(&chosen, &statics, &rest)?;
    let asked = match &arguments.response {
        Some(asked) => Some(ends(&statics, asked)?),
        None => None,
    };
    let linear = rest
        .equilibrium(None, &held)
        .map_err(Failure::model)?
        .linear();
    if let Some(prefix) = &arguments.matrices {
        write_matrices(prefix, &linear, terminal)?;
    }
    let Some((from, to)) = asked else {
        return show(&linear);
    };
    let response = response(arguments, &linear, from, to);
    let mut text = String::new();
    csv::push_header(&mut text, ["frequency", "magnitude", "phase"].into_iter());
    for point in &response {
        csv::push_row(&mut text, point);
    }
    match &arguments.output {
        Some(output) => OutputFile::create(output)?.finish_with(&text)?,
        None => print(|out| out.write_all(text.as_bytes()))?,
    }
    if let Some(path) = &arguments.plot {
        let result = &statics.results()[to];
        let signal = &statics.held()[from];
        let unit = over(&result.unit, &signal.dimension.si_unit());
        let title = format!("Response of {} to {}", result.name, signal.name);
        let file = &arguments.at_rest.settings.file;
        let charts = Charts {
            title: title.clone(),
            design: &chosen.design,
            settings: vec![("model file".to_owned(), file.display().to_string())],
            figures: vec![(
                Graphic::Chart(bode(title, &unit, &response)),
                "Response of the linear model about the equilibrium.".to_owned(),
            )],
        };
        OutputFile::create(path)?.finish_with(&charts.file(path)?)?;
        terminal.note(format_args!("wrote {}", path.display()));
    }
    Ok(())
}

/// Magnitude above phase.
fn bode(title: String, unit: &str, response: &[[f64; 3]]) -> Chart {
    let frequency: Arc<[f64]> = response.iter().map(|point| point[0]).collect();
    let panel = |y: Axis, value: &dyn Fn(&[f64; 3]) -> f64| {
        let values: Vec<f64> = response.iter().map(value).collect();
        Panel {
            y,
            series: vec![Series::new("", frequency.clone(), values, Look::Line)],
            ..Panel::default()
        }
    };
    let magnitude = match pretty_unit(unit).as_str() {
        "" => "magnitude".to_owned(),
        unit => format!("magnitude ({unit})"),
    };
    Chart {
        title,
        x: Axis::logarithmic("frequency", "Hz"),
        panels: vec![
            panel(Axis::logarithmic(magnitude, ""), &|point| point[1]),
            panel(Axis::linear("phase", "°"), &|point| point[2].to_degrees()),
        ],
        ordered: false,
    }
}

fn ends(statics: &Statics, asked: &str) -> Result<(usize, usize), Failure> {
    let Some((from, to)) = asked.split_once(':') else {
        let words =
            format!("`{asked}` is no response: write a drive and a result, as in xp:stage.x");
        return Err(Failure::usage(words));
    };
    Ok((held::signal(statics, from)?, held::result(statics, to)?))
}

/// Frequency in Hz, magnitude and phase in rad of each point.
fn response(arguments: &Arguments, linear: &Linear, from: usize, to: usize) -> Vec<[f64; 3]> {
    let decades = (arguments.to / arguments.from).ln();
    let points = (0..arguments.points).map(|point| {
        let share = f64::from(point) / f64::from(arguments.points - 1);
        let frequency = arguments.from * (decades * share).exp();
        match linear.response(from, to, frequency) {
            Some(response) => [frequency, response.norm(), response.arg()],
            None => [frequency, f64::INFINITY, f64::NAN],
        }
    });
    points.collect()
}

/// Shares of the kinetic energy below this are not shown.
const SHOWN_SHARE: f64 = 5e-4;

fn show(linear: &Linear) -> Result<(), Failure> {
    let words = [
        "mode",
        "frequency",
        "damping ratio",
        "share of the motion's energy",
    ];
    let mut rows = vec![words.map(str::to_owned).to_vec()];
    for (index, mode) in linear.modes().iter().enumerate() {
        let (frequency, damping) = if mode.is_free {
            ("free".to_owned(), String::new())
        } else {
            let frequency = with_unit(mode.frequency(), "Hz", 6);
            let unstable = if mode.damping() < 0.0 {
                ", unstable"
            } else {
                ""
            };
            (frequency, number(mode.damping(), 4) + unstable)
        };
        rows.push(vec![
            (index + 1).to_string(),
            frequency,
            damping,
            shares(linear, mode),
        ]);
    }
    print_table(&rows)
}

fn shares(linear: &Linear, mode: &Mode) -> String {
    let mut order: Vec<usize> = (0..mode.shares.len()).collect();
    order.sort_by(|&i, &j| mode.shares[j].total_cmp(&mode.shares[i]));
    let shown = order.into_iter().filter(|&i| mode.shares[i] >= SHOWN_SHARE);
    let shown: Vec<String> = shown
        .map(|i| format!("{} {:.1} %", linear.states[2 * i].0, 100.0 * mode.shares[i]))
        .collect();
    shown.join(", ")
}

fn write_matrices(prefix: &Path, linear: &Linear, terminal: &Terminal) -> Result<(), Failure> {
    let file = |part: &str| {
        let mut name = prefix.as_os_str().to_owned();
        name.push(format!("_{part}.csv"));
        PathBuf::from(name)
    };
    let matrices = [
        ("A", &linear.a),
        ("B", &linear.b),
        ("C", &linear.c),
        ("D", &linear.d),
    ];
    for (name, matrix) in matrices {
        let mut text = String::new();
        for row in matrix.row_iter() {
            let values: Vec<f64> = row.iter().copied().collect();
            csv::push_row(&mut text, &values);
        }
        OutputFile::create(&file(name))?.finish_with(&text)?;
    }
    let mut text = String::from("kind,number,name,unit\n");
    let kinds = [
        ("state", &linear.states),
        ("input", &linear.inputs),
        ("output", &linear.outputs),
    ];
    for (kind, rows) in kinds {
        for (index, (name, unit)) in rows.iter().enumerate() {
            let _ = writeln!(text, "{kind},{},{name},{unit}", index + 1);
        }
    }
    OutputFile::create(&file("names"))?.finish_with(&text)?;
    let shown = prefix.display();
    terminal.note(format_args!(
        "wrote {shown}_A.csv, _B.csv, _C.csv, _D.csv and _names.csv"
    ));
    Ok(())
}
