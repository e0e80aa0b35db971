//! `flexure simulate`: a run on the tape, as a table and as a picture.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use flexure::picture::with_unit;
use flexure::runtime::simulate::{BreakdownKind, Ending, Integrator, Simulation, simulate};
use flexure::runtime::system::System;

use super::Failure;
use super::charts;
use super::output::{self, OutputFile, cannot_write};
use super::portrait::Portrait;
use super::recording::Recording;
use super::settings::{Chosen, Settings, non_negative_time, time, tolerance};
use super::terminal::Terminal;

/// Simulate a model and write its motion as a table (CSV) and as a picture
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure simulate models/double_rocker.flex --until 20ms -o motion.csv --plot motion.html
  flexure simulate models/double_rocker.flex --until 10ms --use table2 --set Fp=15N --plot m.svg
  flexure simulate models/pendulum.flex --until 2s --dt 0.1ms --every 10ms > pendulum.csv

The table: first column t, then every state, then every output; SI units, 17 significant digits.
It goes to standard output if neither -o nor --plot is given. A run that fails keeps its rows.")]
pub struct Arguments {
    #[command(flatten)]
    pub settings: Settings,
    /// End of the run, as in 20ms
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = non_negative_time)]
    pub until: f64,
    /// Fixed steps of this length (classical Runge–Kutta) instead of adaptive ones
    #[arg(long, value_name = "H", allow_hyphen_values = true, value_parser = time, conflicts_with = "rtol")]
    pub dt: Option<f64>,
    /// Relative tolerance of the adaptive steps
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = tolerance, default_value = "1e-8")]
    pub rtol: f64,
    /// Functions of one coordinate in closed form, not by tables that are made when a run starts
    #[arg(long)]
    exact: bool,
    /// Method of the adaptive steps
    #[arg(long, value_enum, default_value_t, conflicts_with = "dt")]
    pub method: Method,
    /// Time between rows; 0 for a row per step of the integrator [default: 1/2000 of the run]
    #[arg(long, value_name = "DT", allow_hyphen_values = true, value_parser = non_negative_time)]
    every: Option<f64>,
    /// Add columns of energy: kinetic, potential, dissipated, supplied, and their balance
    #[arg(long)]
    energy: bool,
    /// File for the table; `-` is standard output
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
    /// Picture of the motion (.svg), or a page with the mechanism and its equations (.html)
    #[arg(long, value_name = "OUT.svg|.html", value_parser = charts::path)]
    plot: Option<PathBuf>,
}

/// Method of adaptive steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Explicit steps, stiff ones where stability would limit explicit ones
    #[default]
    Auto,
    /// Dormand–Prince 8(5,3)
    Explicit,
    /// Rodas5P, with the model's own Jacobian
    Stiff,
}

impl From<Method> for Integrator {
    fn from(method: Method) -> Self {
        match method {
            Method::Auto => Integrator::Automatic,
            Method::Explicit => Integrator::Explicit,
            Method::Stiff => Integrator::Stiff,
        }
    }
}

const DEFAULT_ROWS: f64 = 2000.0;
/// Stands for standard output.
const STDOUT: &str = "-";

/// Does it.
///
/// # Errors
///
/// If the call does not fit the model, the model is wrong, the run fails, or a file cannot be
/// written. What there is of a failed run is written all the same.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    check_files(arguments)?;
    let mut chosen = arguments.settings.choose(terminal)?;
    chosen.design.exact(arguments.exact);
    let system = chosen.design.prepare().map_err(Failure::model)?;
    // Files are opened before the run, so that a wrong place shows at once.
    let table_path = arguments
        .output
        .as_deref()
        .filter(|path| *path != Path::new(STDOUT));
    let mut table = table_path.map(OutputFile::create).transpose()?;
    let plot = arguments
        .plot
        .as_deref()
        .map(OutputFile::create)
        .transpose()?;
    let mut stdout = io::BufWriter::with_capacity(1 << 16, io::stdout().lock());
    let to_stdout = table.is_none() && (arguments.output.is_some() || plot.is_none());
    let writer: Option<&mut dyn Write> = match &mut table {
        Some(file) => Some(file),
        None if to_stdout => Some(&mut stdout),
        None => None,
    };
    let bar = terminal.progress();
    let mut recording = Recording::new(writer, plot.is_some(), bar, arguments.until);
    let outcome = simulation(arguments, &chosen, &system).run_with(&mut recording);
    let recorded = recording.finish();
    if let Some(why) = &recorded.failure {
        return Err(match (why.kind(), table_path) {
            (io::ErrorKind::BrokenPipe, None) => Failure::ReaderGone,
            (_, path) => cannot_write(path.unwrap_or(Path::new("standard output")), why),
        });
    }
    if recorded.rows > 0 {
        if let Some(plot) = plot {
            let portrait = Portrait {
                arguments,
                chosen: &chosen,
                recorded: &recorded,
                outcome: &outcome,
            };
            plot.finish_with(&if arguments.wants_page() {
                portrait.page()?
            } else {
                portrait.figure()
            })?;
        }
        if let Some(table) = table {
            table.finish()?;
        }
    }
    for path in [table_path, arguments.plot.as_deref()]
        .into_iter()
        .flatten()
    {
        if recorded.rows > 0 {
            terminal.note(format_args!("wrote {}", path.display()));
        }
    }
    match outcome {
        Ok(summary) => {
            let statistics = &summary.statistics;
            if statistics.outside_tables > 0 {
                terminal.note(format_args!(
                    "{} of {} steps were outside of the tables' intervals and took the closed form",
                    statistics.outside_tables, statistics.accepted
                ));
            }
            if let Ending::Stopped(why) = &summary.ending {
                terminal.note(format_args!("ended at t = {}: {why}", seconds(summary.end)));
            }
            let statistics = summary.statistics;
            if arguments.method == Method::Auto && statistics.stiff > 0 {
                terminal.note(format_args!("steps: {}", statistics.steps()));
            }
            Ok(())
        }
        Err(breakdown) => {
            if recorded.rows > 0 {
                terminal.note(format_args!(
                    "the run failed at t = {}; its rows until then are kept: {}",
                    seconds(breakdown.time),
                    recorded.rows
                ));
            }
            Err(match breakdown.kind {
                BreakdownKind::Setting => Failure::setting(breakdown.diagnostic()),
                _ => Failure::model(breakdown.diagnostic()),
            })
        }
    }
}

/// Refuses files that would overwrite each other or the model.
fn check_files(arguments: &Arguments) -> Result<(), Failure> {
    let model = &arguments.settings.file;
    for path in [&arguments.output, &arguments.plot].into_iter().flatten() {
        output::spare_model(path, model)?;
    }
    charts::keep_apart(arguments.output.as_deref(), arguments.plot.as_deref())
}

fn simulation<'s, S: System>(
    arguments: &Arguments,
    chosen: &Chosen,
    system: &'s S,
) -> Simulation<'s, S> {
    let mut simulation = simulate(system)
        .until(arguments.until)
        .energy(arguments.energy);
    simulation = match arguments.dt {
        Some(step) => simulation.dt(step),
        None => simulation
            .rtol(arguments.rtol)
            .integrator(arguments.method.into()),
    };
    if let Some(interval) = arguments.row_interval() {
        simulation = simulation.every(interval);
    }
    for &(index, value) in &chosen.inputs {
        simulation = simulation.input(index, value);
    }
    simulation
}

impl Arguments {
    fn wants_page(&self) -> bool {
        self.plot.as_deref().is_some_and(charts::is_page)
    }

    /// Time between rows in s; `None` for a row per step.
    pub fn row_interval(&self) -> Option<f64> {
        match self.every {
            Some(interval) => Some(interval).filter(|&interval| interval > 0.0),
            None => Some(self.until / DEFAULT_ROWS).filter(|&interval| interval > 0.0),
        }
    }
}

fn seconds(value: f64) -> String {
    with_unit(value, "s", 6)
}
