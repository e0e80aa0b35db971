//! What `response` and `sensitivity` share: an actuator, the frequencies at which it is driven, and
//! the speed that is asked for.

use std::path::{Path, PathBuf};

use clap::Args;
use flexure::model_dsl::units::Dimension;
use flexure::response::{Cycles, Outcome, Quantity, Response, Settle, Speed, response};
use flexure::runtime::diagnostic::Diagnostic;
use flexure::runtime::system::System;
use flexure::{Design, Model};
use indicatif::ProgressBar;

use super::Failure;
use super::axis::Axis;
use super::output::{OutputFile, spare_model};
use super::settings::{Chosen, Settings, tolerance};
use super::terminal::{PROGRESS_STEPS, Terminal};

/// An actuator and how it is driven.
#[derive(Debug, Args)]
pub struct Actuation {
    #[command(flatten)]
    pub settings: Settings,
    /// Param that is the drive's frequency, with its values: `f=100Hz..2000Hz:100Hz`, `f=1kHz,2kHz`;
    /// the name alone stands for 20 values up to twice its own
    #[arg(long, value_name = "PARAM[=VALUES]")]
    frequency: String,
    /// State or output that is the speed
    #[arg(long, value_name = "NAME")]
    pub speed: String,
    /// Cycles before those that are measured
    #[arg(long, value_name = "N", default_value_t = Cycles::default().warmup, value_parser = clap::value_parser!(u32).range(..=MOST_CYCLES))]
    pub warmup: u32,
    /// Cycles over which the mean speed is taken
    #[arg(long, value_name = "N", default_value_t = Cycles::default().measured, value_parser = clap::value_parser!(u32).range(1..=MOST_CYCLES))]
    pub cycles: u32,
    /// Relative tolerance of the steps
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = tolerance, default_value = "1e-8")]
    rtol: f64,
    /// Threads to work on [default: one per core]; results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// More cycles than this are a slip of the pen.
const MOST_CYCLES: i64 = 1_000_000;

/// Values of the frequency where none are given, as shares of the param's own.
const USUAL: u32 = 20;
const USUAL_STEP: f64 = 0.1;

/// An actuator that is ready to be driven.
pub struct Actuator {
    /// Model, params, inputs.
    pub chosen: Chosen,
    /// Name of the param that is the frequency.
    pub frequency: String,
    /// Its values in Hz, rising.
    pub frequencies: Vec<f64>,
    /// How the mean speed is taken.
    pub speed: Speed,
    /// The same in words.
    pub speed_words: String,
    /// SI unit of the speed.
    pub speed_unit: String,
}

impl Actuation {
    /// Reads the model and finds frequency and speed in it.
    ///
    /// # Errors
    ///
    /// If the model is wrong or cannot be assembled, or the call does not fit it.
    pub fn choose(&self, terminal: &Terminal) -> Result<Actuator, Failure> {
        let chosen = self.settings.choose(terminal)?;
        let (frequency, frequencies) =
            self.frequencies(&chosen.design).map_err(Failure::setting)?;
        let system = chosen.design.prepare().map_err(Failure::model)?;
        let quantity = Quantity::named(&self.speed, &system).map_err(Failure::setting)?;
        let speed = Speed::of(quantity, &system);
        Ok(Actuator {
            frequency,
            frequencies,
            speed,
            speed_words: speed.described(&self.speed, &system),
            speed_unit: unit_of(quantity, &system),
            chosen,
        })
    }

    fn frequencies(&self, design: &Design) -> Result<(String, Vec<f64>), Diagnostic> {
        let model = design.model();
        let (name, mut values) = if self.frequency.contains('=') {
            let axis = Axis::parse(&self.frequency, model)?;
            let [name] = axis.names.as_slice() else {
                return Err(Diagnostic::error("the drive's frequency is one param"));
            };
            (name.clone(), axis.values.concat())
        } else {
            let name = self.frequency.trim().to_owned();
            // An unknown name is said as everywhere else.
            design.clone().set(&name, 0.0)?;
            let params = model.equations().params.iter();
            let own = params
                .zip(design.values())
                .find(|(param, _)| param.name == name);
            let own = own.map_or(f64::NAN, |(_, &value)| value);
            let shares = (1..=USUAL).map(|k| f64::from(k) * (USUAL_STEP * own));
            (name, shares.collect())
        };
        let param = model
            .equations()
            .params
            .iter()
            .find(|param| param.name == name);
        let dimension = param.map(|param| param.dimension).unwrap_or_default();
        if !dimension.same_units(Dimension::FREQUENCY) || dimension.described().contains("rad/s") {
            return Err(Diagnostic::error(format!(
                "`{name}` is {}, no frequency",
                dimension.described()
            ))
            .hint("the frequency of the drive is a param in Hz"));
        }
        if let Some(wrong) = values.iter().find(|value| **value <= 0.0) {
            return Err(
                Diagnostic::error(format!("there are no cycles at {wrong} Hz"))
                    .hint("give drive frequencies above zero"),
            );
        }
        values.sort_by(f64::total_cmp);
        values.dedup();
        Ok((name, values))
    }

    /// Opens a file for results, so that a wrong place shows before the work.
    ///
    /// # Errors
    ///
    /// If it is the model, or cannot be written.
    pub fn open(&self, path: Option<&Path>) -> Result<Option<ResultFile>, Failure> {
        let Some(path) = path else {
            return Ok(None);
        };
        spare_model(path, &self.settings.file)?;
        Ok(Some(ResultFile {
            path: path.to_owned(),
            file: OutputFile::create(path)?,
        }))
    }

    /// The cycles that are measured.
    pub fn measured(&self) -> Cycles {
        Cycles {
            warmup: self.warmup,
            measured: self.cycles,
        }
    }

    /// Drives each of `designs` at each of `frequencies`, over the stated cycles or until motions
    /// have settled; outcomes design by design.
    pub fn drive(
        &self,
        actuator: &Actuator,
        designs: &[Design],
        frequencies: &[f64],
        bar: &ProgressBar,
        until_settled: Option<Settle>,
    ) -> Vec<Vec<Outcome>> {
        let all = frequencies.repeat(designs.len());
        let prepare = |index: usize| {
            let mut design = designs[index / frequencies.len()].clone();
            design.set(&actuator.frequency, all[index])?;
            design.prepare()
        };
        let mut runs: Response<'_, _> = response(&all, actuator.speed, prepare)
            .rtol(self.rtol)
            .threads(self.threads.unwrap_or(0).into())
            .progress(|share| bar.set_position((share * PROGRESS_STEPS as f64) as u64));
        runs = match until_settled {
            None => runs.over(self.measured()),
            Some(settle) => runs.until_settled(settle),
        };
        for &(index, value) in &actuator.chosen.inputs {
            runs = runs.input(index, value);
        }
        let outcomes = runs.run();
        outcomes
            .chunks(frequencies.len().max(1))
            .map(<[Outcome]>::to_vec)
            .collect()
    }
}

/// A file for results.
pub struct ResultFile {
    path: PathBuf,
    file: OutputFile,
}

impl ResultFile {
    /// Writes it and says so.
    ///
    /// # Errors
    ///
    /// If it cannot be completed.
    pub fn finish_with(self, text: &str, terminal: &Terminal) -> Result<(), Failure> {
        self.file.finish_with(text)?;
        terminal.note(format_args!("wrote {}", self.path.display()));
        Ok(())
    }
}

fn unit_of(quantity: Quantity, system: &impl System) -> String {
    quantity.variable(system).unit.to_string()
}

impl Actuator {
    /// The model.
    pub fn model(&self) -> &Model {
        self.chosen.design.model()
    }

    /// The curve of outcomes: speeds at these frequencies, not numbers where they failed.
    pub fn curve(frequencies: &[f64], outcomes: &[Outcome]) -> Vec<(f64, f64)> {
        let speed = |outcome: &Outcome| outcome.as_ref().map_or(f64::NAN, |point| point.speed);
        frequencies
            .iter()
            .zip(outcomes)
            .map(|(&f, o)| (f, speed(o)))
            .collect()
    }
}
