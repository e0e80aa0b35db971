//! Options that several subcommands share: which model, and with which params.

use std::path::PathBuf;

use clap::Args;
use flexure::model_dsl::units::{Dimension, parse_quantity};
use flexure::{Design, Model, quantity, split_assignment};
use num_traits::ToPrimitive;

use super::Failure;
use super::terminal::Terminal;

/// A model file and values of its params.
#[derive(Debug, Args)]
pub struct Settings {
    /// Model file (.flex)
    pub file: PathBuf,
    /// Set a param (or hold an input), with its unit as in the model file; a bare number is SI
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Use a named parameter set of the model; `--set` goes on top
    #[arg(long = "use", value_name = "SET")]
    pub use_sets: Vec<String>,
}

/// A model with values for its params and inputs.
pub struct Chosen {
    /// The params.
    pub design: Design,
    /// Inputs held at a value: position and value in SI.
    pub inputs: Vec<(usize, f64)>,
}

impl Settings {
    /// Reads the model, reports its warnings and sets its params.
    ///
    /// # Errors
    ///
    /// If the model is wrong, or a setting does not fit it.
    pub fn choose(&self, terminal: &Terminal) -> Result<Chosen, Failure> {
        let model = load(&self.file, terminal)?;
        let mut design = model.design();
        let mut inputs = Vec::new();
        for set in &self.use_sets {
            design.use_set(set).map_err(Failure::setting)?;
        }
        for assignment in &self.set {
            let (name, written) = split_assignment(assignment).map_err(Failure::setting)?;
            let input = model.equations().inputs.iter().position(|i| i.name == name);
            if let Some(index) = input {
                let dimension = model.equations().inputs[index].dimension;
                let value = quantity(name, written, dimension).map_err(Failure::setting)?;
                inputs.push((index, value));
            } else {
                design.set_written(assignment).map_err(Failure::setting)?;
            }
        }
        Ok(Chosen { design, inputs })
    }
}

/// Reads a model and reports its warnings.
///
/// # Errors
///
/// If it cannot be read or is wrong.
pub fn load(file: &PathBuf, terminal: &Terminal) -> Result<Model, Failure> {
    let model = Model::from_path(file).map_err(|errors| Failure::Model(errors.0))?;
    terminal.warnings(model.warnings());
    Ok(model)
}

/// A time on the command line: `20ms`, `0.02`; for clap.
///
/// # Errors
///
/// If it is no time above zero.
pub fn time(text: &str) -> Result<f64, String> {
    match non_negative_time(text)? {
        0.0 => Err("a time above zero is wanted".to_owned()),
        value => Ok(value),
    }
}

/// As [`time`], zero included.
///
/// # Errors
///
/// If it is no time, or negative.
pub fn non_negative_time(text: &str) -> Result<f64, String> {
    let (value, unit) = parse_quantity(text)?;
    if let Some(unit) = unit
        && !unit.same_units(Dimension::TIME)
    {
        return Err(format!(
            "{} is wanted, this is {}",
            Dimension::TIME.described(),
            unit.described()
        ));
    }
    match value.to_f64() {
        Some(value) if (0.0..f64::INFINITY).contains(&value) => Ok(value),
        _ => Err("a time above zero is wanted".to_owned()),
    }
}

/// A relative tolerance on the command line, for clap.
///
/// # Errors
///
/// If it is no number from 1e-13 to 0.1.
pub fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if (1e-13..=0.1).contains(&value) => Ok(value),
        _ => Err("a number from 1e-13 to 0.1 is wanted".to_owned()),
    }
}
