//! `flexure sweep`: many designs, a few numbers of each, as a table.
//!
//! Rows go into a journal beside the output as they are done. The output is written from it at the
//! end, and then the journal is removed: a sweep that was killed goes on where it was.

mod picture;

use std::io::{self, BufRead, IsTerminal, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use clap::Args;
use flexure::Model;
use flexure::runtime::lanes::Path as Instructions;
use flexure::study::{
    Accuracy, Axis, Draws, Journal, JournalFailure, Limit, Measure, Points, PointsFile, Row,
    Spread, Status, Sweep, Window, build, fingerprint,
};
use indicatif::ProgressBar;

use super::charts;
use super::output::{self, OutputFile, cannot_write};
use super::settings::{Chosen, Settings, non_negative_time, time, tolerance};
use super::terminal::{PROGRESS_STEPS, Terminal};
use super::yields::Yields;
use super::{Failure, csv};
use picture::Picture;

/// Simulate many designs of a model and write measures of each as a table (CSV)
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure sweep models/double_rocker.flex --vary f=100Hz..2kHz:100Hz --vary Fp=5N,10N,20N \\
      --measure 'mean(stage.v)' -o speed.csv
  flexure sweep models/double_rocker.flex --vary mu_s+mu_c=90%..110%:5% --measure 'step(stage.x)'
  flexure sweep models/double_rocker.flex --vary f=100Hz..2kHz:100Hz --vary Fp=5N,20N \\
      --measure 'mean(stage.v)' -o speed.csv --plot speed.html
  flexure sweep models/double_rocker.flex --spread l2=normal(10um) --spread 'e=uniform(±2%)' \\
      --draws 200 --limit 'mean(stage.v) > 5mm/s' -o yield.csv

Values: a list `1N,5N`, steps `100Hz..2kHz:100Hz`, numbers `100Hz..2kHz:lin20`, `…:log20`. The first
`--vary` changes slowest. `a+b` scales params by one factor.

Measures: mean, rms, min, max, peak (greatest magnitude), peak_to_peak, first, last of any state or
output over the window; of cycles step (advance per cycle), back_slip (largest retreat), overshoot
(beyond the cycle's end), settling (time until within 5 % of the step from the cycle's end), each
as a mean over the cycles.

The table: what is varied, the measures, status (ok, stopped, failed, refused), message; SI units. A
design that fails is a row. With -o, rows are kept in OUT.csv.journal until all are done: a sweep that
was broken off goes on when it is called again, and ends in the same file.")]
pub struct Arguments {
    #[command(flatten)]
    settings: Settings,
    /// Vary a param over values; several make a grid
    #[arg(long, value_name = "NAME=VALUES")]
    vary: Vec<String>,
    /// Table of design points: a header of params, `f [Hz],Fp [N]`, and a line for each point
    #[arg(long, value_name = "FILE.csv")]
    points: Vec<PathBuf>,
    /// What to measure, as in 'mean(stage.v)'
    #[arg(long, value_name = "MEASURE")]
    measure: Vec<String>,
    /// Cycles of the drive before measures begin; a time with --until [default: 10; 0s with --until]
    #[arg(long, value_name = "N|T")]
    warmup: Option<String>,
    /// Cycles of the drive that are measured [default: 20]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), conflicts_with = "until")]
    cycles: Option<u32>,
    /// Frequency of the cycles: a drive, a param, or a value [default: that of the model's drive]
    #[arg(long, value_name = "F", conflicts_with = "until")]
    frequency: Option<String>,
    /// End of each run, in place of a number of cycles
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = time)]
    until: Option<f64>,
    /// Samples that measures are taken from [default: 200 in a cycle, 2000 with --until]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    samples: Option<u32>,
    /// Let a param deviate at random: normal(standard deviation) or uniform(bound to either side)
    #[arg(long, value_name = "NAME=SPREAD", requires = "draws")]
    spread: Vec<String>,
    /// Draws of each design point
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), requires = "spread")]
    draws: Option<u32>,
    /// Seed of the draws
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Limit that designs should keep, as in 'mean(stage.v) > 5mm/s'
    #[arg(long, value_name = "LIMIT", requires = "spread")]
    limit: Vec<String>,
    /// Relative tolerance of the adaptive steps
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = tolerance, default_value = "1e-8")]
    rtol: f64,
    /// Fixed steps of this length (classical Runge–Kutta) instead of adaptive ones
    #[arg(long, value_name = "H", allow_hyphen_values = true, value_parser = time, conflicts_with = "rtol")]
    dt: Option<f64>,
    /// Functions of one coordinate in closed form, not by tables that are made when a run starts
    #[arg(long)]
    exact: bool,
    /// Threads; results do not depend on their number [default: one for each core]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    threads: usize,
    /// File for the table; standard output if not given
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
    /// Picture of the measures (.svg), or a page with their numbers and the mechanism (.html): the
    /// first varied param to the right, a curve for each value of the second
    #[arg(long, value_name = "OUT.svg|.html", value_parser = charts::path, conflicts_with = "spread")]
    plot: Option<PathBuf>,
    /// Forget what was done before and start over
    #[arg(long, requires = "output")]
    restart: bool,
    /// Run more than 100 000 designs without asking
    #[arg(long)]
    yes: bool,
}

/// More designs than this are asked for.
const MANY: usize = 100_000;
/// More draws than this would not fit into memory for their quantiles.
const MOST_DRAWS: u32 = 10_000_000;
const DEFAULT_WARMUP: f64 = 10.0;
const DEFAULT_CYCLES: u32 = 20;
const SAMPLES_IN_A_CYCLE: u32 = 200;
const SAMPLES_IN_A_SPAN: u32 = 2000;

/// Does it.
///
/// # Errors
///
/// If the call does not fit the model, the model is wrong, a file cannot be read or written, or the
/// journal beside the output is of another sweep.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    for path in [&arguments.output, &arguments.plot].into_iter().flatten() {
        output::spare_model(path, &arguments.settings.file)?;
        for points in &arguments.points {
            if output::same_file(path, points) {
                return Err(Failure::usage(format!(
                    "writing `{}` would overwrite the design points",
                    path.display()
                )));
            }
        }
        output::check_place(path)?;
    }
    charts::keep_apart(arguments.output.as_deref(), arguments.plot.as_deref())?;
    let mut chosen = arguments.settings.choose(terminal)?;
    chosen.design.exact(arguments.exact);
    let model = chosen.design.model().clone();
    let limits = all(&arguments.limit, |written| Limit::parse(&model, written))?;
    let sweep = sweep(arguments, chosen, &model, &limits)?;
    let picture = match &arguments.plot {
        Some(_) => Some(Picture::new(&sweep, &model)?),
        None => None,
    };
    ask(arguments, sweep.points.len())?;
    let mut study = Study {
        sweep: &sweep,
        model: &model,
        threads: arguments.threads,
        yields: (!arguments.spread.is_empty()).then(|| {
            let varied = sweep.points.varied().into_iter().map(str::to_owned);
            let varied = varied.zip(sweep.points.units(&model)).collect();
            Yields::new(&sweep.measures, &limits, varied, sweep.points.draws_each())
        }),
        picture,
        counts: [0; Status::ALL.len()],
        bar: terminal.progress(),
    };
    let outcome = match &arguments.output {
        Some(output) => study.write(output, arguments.restart, terminal),
        None => study.print(),
    };
    study.bar.finish_and_clear();
    outcome?;
    let [_, stopped, failed, refused] = study.counts;
    for (count, words) in [
        (stopped, "ended early"),
        (failed, "failed"),
        (refused, "could not be assembled or run"),
    ] {
        if count > 0 {
            terminal.note(format_args!(
                "{count} of {} designs {words}: see their messages",
                sweep.points.len()
            ));
        }
    }
    if let Some(yields) = &study.yields {
        if arguments.output.is_some() {
            super::print(|out| out.write_all(yields.text().as_bytes()))?;
        } else {
            terminal.note(yields.text().trim_end());
        }
    }
    if let (Some(picture), Some(path)) = (study.picture, &arguments.plot) {
        let text = picture.charts(arguments, &sweep).file(path)?;
        OutputFile::create(path)?.finish_with(&text)?;
        terminal.note(format_args!("wrote {}", path.display()));
    }
    Ok(())
}

/// What all of `written` mean.
fn all<T>(
    written: &[String],
    parse: impl Fn(&str) -> Result<T, flexure::runtime::diagnostic::Diagnostic>,
) -> Result<Vec<T>, Failure> {
    let parsed = written.iter().map(|written| parse(written));
    parsed.collect::<Result<_, _>>().map_err(Failure::setting)
}

/// The sweep that was asked for.
fn sweep(
    arguments: &Arguments,
    chosen: Chosen,
    model: &Model,
    limits: &[Limit],
) -> Result<Sweep, Failure> {
    let mut measures: Vec<Measure> = Vec::new();
    let asked = all(&arguments.measure, |written| Measure::parse(model, written))?;
    let bounded = limits.iter().map(|limit| limit.measure.clone());
    for measure in asked.into_iter().chain(bounded) {
        if !measures.contains(&measure) {
            measures.push(measure);
        }
    }
    if measures.is_empty() {
        return Err(Failure::usage(
            "nothing is measured: say what, as in --measure 'mean(stage.v)'",
        ));
    }
    let samples = match arguments.until {
        Some(_) => SAMPLES_IN_A_SPAN,
        None => SAMPLES_IN_A_CYCLE,
    };
    let sweep = Sweep {
        inputs: chosen.inputs.clone(),
        points: points(arguments, model)?,
        measures,
        window: window(arguments, model)?,
        samples: arguments.samples.unwrap_or(samples) as usize,
        accuracy: match arguments.dt {
            Some(step) => Accuracy::Step(step),
            None => Accuracy::Relative(arguments.rtol),
        },
        ..Sweep::new(chosen.design)
    };
    sweep.check().map_err(Failure::setting)?;
    Ok(sweep)
}

fn points(arguments: &Arguments, model: &Model) -> Result<Points, Failure> {
    let mut points = Points::new(model);
    for axis in all(&arguments.vary, |written| Axis::parse(model, written))? {
        points = points.axis(axis).map_err(Failure::setting)?;
    }
    for path in &arguments.points {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|why| {
            Failure::run(format!("cannot read the design points `{name}`: {why}"))
        })?;
        let file = PointsFile::parse(model, &name, &text).map_err(Failure::setting)?;
        points = points.file(file).map_err(Failure::setting)?;
    }
    let Some(draws) = arguments.draws else {
        return Ok(points);
    };
    if draws > MOST_DRAWS {
        return Err(Failure::usage(format!(
            "{draws} draws are too many: {MOST_DRAWS} are the most"
        )));
    }
    let draws = Draws {
        spreads: all(&arguments.spread, |written| Spread::parse(model, written))?,
        count: draws as usize,
        seed: arguments.seed,
    };
    points.draws(draws).map_err(Failure::setting)
}

fn window(arguments: &Arguments, model: &Model) -> Result<Window, Failure> {
    let wrong = |why: String| Failure::usage(format!("--warmup: {why}"));
    let warmup = arguments.warmup.as_deref();
    if let Some(until) = arguments.until {
        let from = warmup.map_or(Ok(0.0), non_negative_time).map_err(wrong)?;
        if from >= until {
            return Err(wrong(
                "it lasts until the run ends, and nothing is measured".to_owned(),
            ));
        }
        return Ok(Window::span(from, until));
    }
    let warmup = match warmup {
        None => DEFAULT_WARMUP,
        Some(text) => match text.parse() {
            Ok(cycles) if (0.0..1e9).contains(&cycles) => cycles,
            _ => return Err(wrong("a number of cycles is wanted".to_owned())),
        },
    };
    let cycles = arguments.cycles.unwrap_or(DEFAULT_CYCLES) as usize;
    match &arguments.frequency {
        Some(written) => Window::cycles_of(model, warmup, cycles, written),
        None => Window::cycles(model, warmup, cycles),
    }
    .map_err(Failure::setting)
}

/// Asks whether so many designs are meant.
fn ask(arguments: &Arguments, count: usize) -> Result<(), Failure> {
    if count <= MANY || arguments.yes {
        return Ok(());
    }
    let mut answer = String::new();
    if io::stdin().is_terminal() && io::stderr().is_terminal() {
        let _ = write!(io::stderr(), "This runs {count} designs. Go on? [y/N] ");
        let _ = io::stdin().lock().read_line(&mut answer);
    }
    match answer.trim() {
        "y" | "Y" | "yes" => Ok(()),
        _ => Err(Failure::usage(format!(
            "this would run {count} designs; add --yes if that is meant"
        ))),
    }
}

/// A sweep on its way into a table.
struct Study<'a> {
    sweep: &'a Sweep,
    model: &'a Model,
    threads: usize,
    yields: Option<Yields<'a>>,
    picture: Option<Picture<'a>>,
    /// Rows of each status.
    counts: [usize; Status::ALL.len()],
    bar: ProgressBar,
}

impl Study<'_> {
    /// Rows go to standard output as they are done.
    fn print(&mut self) -> Result<(), Failure> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        let mut line = String::new();
        self.push_header(&mut line);
        let mut failure = out.write_all(line.as_bytes()).err();
        let mut progress = Progress::new(self.sweep, &self.bar, 0);
        let sweep = self.sweep;
        if failure.is_none() {
            sweep.run(0, self.threads, |rows| {
                line.clear();
                for row in rows {
                    self.push_row(&mut line, row);
                }
                failure = out
                    .write_all(line.as_bytes())
                    .and_then(|()| out.flush())
                    .err();
                progress.done(rows);
                match failure {
                    Some(_) => ControlFlow::Break(()),
                    None => ControlFlow::Continue(()),
                }
            });
        }
        match failure {
            Some(why) if why.kind() == io::ErrorKind::BrokenPipe => Err(Failure::ReaderGone),
            Some(why) => Err(cannot_write(Path::new("standard output"), &why)),
            None => Ok(()),
        }
    }

    /// Rows go to the journal, and from there into the file when all are done.
    fn write(&mut self, output: &Path, restart: bool, terminal: &Terminal) -> Result<(), Failure> {
        let mut path = output.as_os_str().to_owned();
        path.push(".journal");
        let path = PathBuf::from(path);
        if restart && path.exists() {
            std::fs::remove_file(&path).map_err(|why| cannot_write(&path, &why))?;
        }
        let identity = self.identity()?;
        let mut journal =
            Journal::open(&path, &identity).map_err(|failure| refused(&path, &failure))?;
        let total = self.sweep.points.len();
        if journal.rows() > 0 {
            terminal.note(format_args!(
                "{} of {total} designs are done already, by {}",
                journal.rows(),
                path.display()
            ));
        }
        let mut progress = Progress::new(self.sweep, &self.bar, journal.rows());
        let mut failure = None;
        self.sweep.run(journal.rows(), self.threads, |rows| {
            failure = journal.append(rows).err();
            progress.done(rows);
            match failure {
                Some(_) => ControlFlow::Break(()),
                None => ControlFlow::Continue(()),
            }
        });
        if let Some(why) = failure {
            return Err(cannot_write(&path, &why));
        }
        let mut file = OutputFile::create(output)?;
        let mut line = String::new();
        self.push_header(&mut line);
        let written = file.write_all(line.as_bytes()).and_then(|()| {
            journal.read(|mut row| {
                let mut design = self.sweep.design.clone();
                row.point = self.sweep.points.set(row.index, &mut design);
                line.clear();
                self.push_row(&mut line, &row);
                file.write_all(line.as_bytes())
            })
        });
        written.map_err(|why| cannot_write(output, &why))?;
        file.finish()?;
        journal
            .remove()
            .map_err(|why| Failure::run(format!("cannot remove `{}`: {why}", path.display())))?;
        terminal.note(format_args!("wrote {}", output.display()));
        Ok(())
    }

    /// What rows depend on.
    fn identity(&self) -> Result<Vec<(&'static str, String)>, Failure> {
        let sweep = self.sweep;
        let build = build()
            .map_err(|why| Failure::run(format!("cannot read the program's own file: {why}")))?;
        let names: Vec<&str> = sweep.measures.iter().map(Measure::name).collect();
        let settings = (&sweep.window, sweep.samples, sweep.accuracy, &sweep.inputs);
        Ok(vec![
            ("build", build),
            ("instruction path", Instructions::chosen().name().to_owned()),
            (
                "model",
                format!(
                    "{} {}",
                    self.model.name(),
                    fingerprint(&self.model.tape().program())
                ),
            ),
            ("measures", names.join(", ")),
            (
                "design points",
                format!("{} {}", sweep.points.len(), fingerprint(&sweep.points)),
            ),
            (
                "params",
                fingerprint(&(sweep.design.values(), sweep.design.is_exact())),
            ),
            ("settings", format!("{settings:?}")),
        ])
    }

    fn push_header(&self, line: &mut String) {
        let columns = self.sweep.points.columns(self.model);
        let measures = self.sweep.measures.iter().map(Measure::name);
        let names = columns.iter().map(String::as_str).chain(measures);
        csv::push_header(line, names.chain(["status", "message"]));
    }

    fn push_row(&mut self, line: &mut String, row: &Row) {
        let missing = self.sweep.measures.len() - row.measures.len();
        csv::push_values(line, row.point.iter().chain(&row.measures));
        line.push_str(&",".repeat(missing));
        line.push_str(&format!("{},", row.status));
        csv::push_text(line, &row.message);
        line.push('\n');
        if let Some(index) = Status::ALL.iter().position(|&status| status == row.status) {
            self.counts[index] += 1;
        }
        if let Some(yields) = &mut self.yields {
            yields.add(row);
        }
        if let Some(picture) = &mut self.picture {
            picture.add(row);
        }
    }
}

fn refused(path: &Path, failure: &JournalFailure) -> Failure {
    let path = path.display();
    match failure {
        JournalFailure::File(why) => cannot_write(Path::new(&path.to_string()), why),
        JournalFailure::InUse => Failure::run(format!(
            "`{path}`: {failure}; wait for it, or choose another output"
        )),
        JournalFailure::Foreign => Failure::run(format!(
            "`{path}` is in the way: {failure}; move it, or choose another output"
        )),
        JournalFailure::Differs { .. } => Failure::run(format!(
            "`{path}` is the journal of another sweep: {failure}; go on with what it was begun \
             with, or add --restart to start over"
        )),
    }
}

/// How far a sweep is, by the time that its runs simulate; by their number where there are many.
struct Progress<'a> {
    sweep: &'a Sweep,
    bar: ProgressBar,
    weighted: bool,
    total: f64,
    done: f64,
}

impl<'a> Progress<'a> {
    fn new(sweep: &'a Sweep, bar: &ProgressBar, first: usize) -> Self {
        let count = sweep.points.len();
        let weighted = count <= MANY && !bar.is_hidden();
        let mut progress = Self {
            sweep,
            bar: bar.clone(),
            weighted,
            total: 0.0,
            done: 0.0,
        };
        progress.done = (0..first).map(|index| progress.weight(index)).sum();
        let rest: f64 = (first..count).map(|index| progress.weight(index)).sum();
        progress.total = progress.done + rest;
        bar.set_message("sweeping");
        progress.show();
        bar.reset_eta();
        progress
    }

    fn weight(&self, index: usize) -> f64 {
        if self.weighted {
            self.sweep.duration(index)
        } else {
            1.0
        }
    }

    fn done(&mut self, rows: &[Row]) {
        self.done += rows.iter().map(|row| self.weight(row.index)).sum::<f64>();
        self.show();
    }

    fn show(&self) {
        let share = (self.done / self.total.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        self.bar
            .set_position((share * PROGRESS_STEPS as f64) as u64);
    }
}
