//! Statics and linear studies: equilibrium under preload and constant drive, stiffness, modes,
//! frequency response, from the same equations as the motion.
//!
//! ```text
//! Statics (model at rest) ──prepare(params)──▶ Rest ──equilibrium(drives)──▶ Equilibrium ──linear()──▶ Linear
//! ```
//!
//! Drives and inputs are held at a value. A contact as it is sticks at rest, and an equilibrium is
//! refused where that takes more friction than holds; [`Hold`] leaves it out or lets it stick
//! whatever it takes.
//!
//! ```
//! use flexure::statics::{Hold, Statics};
//! let holds = [Hold::Without("tip".to_owned())];
//! let statics = Statics::from_path("models/double_rocker.flex", &holds)?;
//! let rest = statics.prepare(&statics.defaults())?;
//! let equilibrium = rest.equilibrium(None, &rest.start())?;
//! let modes = equilibrium.linear().modes();
//! assert!((modes[1].frequency() - 3740.0).abs() < 10.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod equilibrium;
mod linear;
mod modes;

use std::path::Path;

use flexure_codegen as codegen;
pub use flexure_model_dsl::Hold;
use flexure_model_dsl::equations::Definition;
use flexure_model_dsl::source::Source;
use flexure_model_dsl::symbolic::Evaluator;
use flexure_model_dsl::{AtRest, Held, compile_at_rest};
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::system::{System, Variable};
use flexure_runtime::tape::{TapeModel, TapePrepared};

use crate::model::{Diagnostics, read};

pub use equilibrium::Equilibrium;
pub use linear::Linear;
pub use modes::Mode;

/// A model at rest, ready for any params.
#[derive(Clone, Debug)]
pub struct Statics {
    model: AtRest,
    tape: TapeModel,
}

impl Statics {
    /// Reads a model file and holds its drives, and its contacts as `holds` says.
    ///
    /// # Errors
    ///
    /// Everything that is wrong with the file, or a contact that it does not have.
    pub fn from_path(path: impl AsRef<Path>, holds: &[Hold]) -> Result<Self, Diagnostics> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let text = read(path).map_err(|why| {
            let words = format!("cannot read the model file `{name}`: {why}");
            Diagnostics(vec![Diagnostic::error(words)])
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let files = |file: &str| read(&folder.join(file));
        Self::compile(Source::new(name, text), &files, holds)
    }

    /// As [`Statics::from_path`], of a model given as text.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn from_source(name: &str, text: &str, holds: &[Hold]) -> Result<Self, Diagnostics> {
        let none = |file: &str| Err(format!("a model given as text cannot read `{file}`"));
        Self::compile(Source::new(name, text), &none, holds)
    }

    fn compile(
        source: Source,
        files: &dyn Fn(&str) -> Result<String, String>,
        holds: &[Hold],
    ) -> Result<Self, Diagnostics> {
        let (model, _) = compile_at_rest(source, files, holds).map_err(Diagnostics)?;
        let tape = codegen::tape(&codegen::program(&model.equations));
        Ok(Self { model, tape })
    }

    /// Drives and inputs, which are held.
    pub fn held(&self) -> &[Held] {
        &self.model.held
    }

    /// Names and units of the results: the outputs of the model first, then angles and places of
    /// its bodies, and what springs and contacts do.
    pub fn results(&self) -> &[Variable] {
        &self.tape.program().states[self.model.first_result..]
    }

    /// How many of the results are the outputs of the model.
    pub fn output_count(&self) -> usize {
        self.model.named_results
    }

    /// Names and units of the states of the mechanism: coordinates and their rates.
    pub fn states(&self) -> &[Variable] {
        &self.tape.program().states[..2 * self.model.coordinates]
    }

    /// Defaults of all params, in SI.
    pub fn defaults(&self) -> Vec<f64> {
        self.tape.defaults()
    }

    /// Closes the loops with these values of the params, in SI and in order of declaration.
    ///
    /// # Errors
    ///
    /// What is wrong with the parameter set.
    pub fn prepare(&self, params: &[f64]) -> Result<Rest<'_>, Diagnostic> {
        let system = self.tape.prepare(params)?.exact();
        let mut x = vec![0.0; system.states().len()];
        let mut d = vec![0.0; system.discretes().len()];
        system.start(&mut x, &mut d);
        Ok(Rest {
            full: self.full_strokes(params),
            statics: self,
            system,
            x,
            d,
        })
    }

    fn full_strokes(&self, params: &[f64]) -> Vec<Option<f64>> {
        let equations = &self.model.equations;
        let mut evaluator = Evaluator::new(&equations.graph);
        for (param, value) in equations.params.iter().zip(params) {
            evaluator.set(param.symbol, *value);
        }
        for definition in &equations.definitions {
            if let Definition::Value { symbol, value, .. } = definition {
                evaluator.define(*symbol, *value);
            }
        }
        let held = self.model.held.iter();
        held.map(|held| Some(evaluator.value(held.full?))).collect()
    }
}

/// A model at rest with a parameter set.
#[derive(Clone, Debug)]
pub struct Rest<'s> {
    statics: &'s Statics,
    system: TapePrepared,
    x: Vec<f64>,
    d: Vec<f64>,
    full: Vec<Option<f64>>,
}

impl Rest<'_> {
    /// Values of drives and inputs at t = 0, in SI.
    pub fn start(&self) -> Vec<f64> {
        let held = self.statics.model.held.iter();
        held.map(|held| self.x[held.state]).collect()
    }

    /// The same with all drives at full stroke that have one; `None` if that is nowhere else.
    pub fn full_stroke(&self) -> Option<Vec<f64>> {
        let start = self.start();
        let full = self.full.iter().zip(&start);
        let values: Vec<f64> = full.map(|(full, start)| full.unwrap_or(*start)).collect();
        (values != start).then_some(values)
    }
}
