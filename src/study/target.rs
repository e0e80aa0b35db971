//! What a design point gives a value to: a param, or several that are scaled together.

use flexure_model_dsl::units::{Dimension, Mark};
use flexure_runtime::diagnostic::Diagnostic;

use crate::Model;

/// A param, or several params that are scaled together by a factor on their base values.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    name: String,
    params: Vec<usize>,
    dimension: Dimension,
    is_factor: bool,
}

impl Target {
    /// The param `Fp`, or `mu_s+mu_c` for both scaled by one factor.
    ///
    /// # Errors
    ///
    /// If the model has no such params, or one of them is named twice.
    pub fn named(model: &Model, name: &str) -> Result<Self, Diagnostic> {
        if name.contains('+') {
            let names: Vec<&str> = name.split('+').map(str::trim).collect();
            return Self::scaled(model, &names);
        }
        let inputs = &model.equations().inputs;
        if inputs.iter().any(|input| input.name == name) {
            return Err(
                Diagnostic::error(format!("`{name}` is an input, which no design varies"))
                    .hint(format!("hold it at a value in all runs: `--set {name}=…`")),
            );
        }
        let index = model.position(name)?;
        Ok(Self {
            name: name.to_owned(),
            params: vec![index],
            dimension: model.equations().params[index].dimension,
            is_factor: false,
        })
    }

    /// These params times one factor.
    ///
    /// # Errors
    ///
    /// As [`Self::named`].
    pub fn scaled(model: &Model, names: &[&str]) -> Result<Self, Diagnostic> {
        let mut params = Vec::new();
        for name in names {
            let index = model.position(name)?;
            if params.contains(&index) {
                return Err(Diagnostic::error(format!(
                    "`{name}` would be scaled twice by one factor"
                )));
            }
            params.push(index);
        }
        Ok(Self {
            name: names.join("+"),
            params,
            dimension: Dimension::NONE,
            is_factor: true,
        })
    }

    /// Its name, which heads a column: `Fp`, `mu_s+mu_c`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Dimension of its values; a factor has none.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// SI unit of its values, `1` if it has none.
    pub fn unit(&self) -> String {
        unit(self.dimension)
    }

    /// Positions of its params in the model.
    pub fn params(&self) -> &[usize] {
        &self.params
    }

    /// Gives it a value in SI, over the base values in `values`.
    pub(super) fn set(&self, values: &mut [f64], value: f64) {
        for &param in &self.params {
            values[param] = if self.is_factor {
                values[param] * value
            } else {
                value
            };
        }
    }
}

/// The SI unit of a dimension, with Hz for frequencies.
pub(super) fn unit(dimension: Dimension) -> String {
    if dimension.mark() == Mark::Frequency && dimension.same_units(Dimension::FREQUENCY) {
        "Hz".to_owned()
    } else {
        dimension.si_unit()
    }
}
