//! Models read at run time: the same calls as on compiled ones, run on the tape.

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use flexure_codegen as codegen;
use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;
use flexure_model_dsl::suggest::closest;
use flexure_model_dsl::symbolic::Rational;
use flexure_model_dsl::units::{Dimension, Mark, parse_quantity};
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::lanes::LaneSystem;
use flexure_runtime::system::Variable;
use flexure_runtime::tape::TapeModel;
use num_traits::ToPrimitive;

use crate::assembled::Assembled;

/// Everything that is wrong with a model file, in the order in which it stands there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics(pub Vec<Diagnostic>);

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.0.iter().enumerate() {
            if index > 0 {
                f.write_str("\n\n")?;
            }
            diagnostic.fmt(f)?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}

/// A model file that was read and understood: its equations, and a tape to run them. Cheap to
/// clone.
///
/// ```
/// let model = flexure::Model::from_source("oscillator.flex", r#"
/// model oscillator
/// param k = 100 N/m
/// slide mass along (1, 0) { mass = 1 kg }
/// spring k1 between ground and mass { stiffness = k }
/// initial mass.v = 10 mm/s
/// "#)?;
/// let mut design = model.design();
/// design.set_written("k = 400 N/m")?;
/// let run = flexure::simulate(&design.prepare()?).until(1.0).rtol(1e-9).run()?;
/// assert!((run.column("mass.x").last() - 0.01 / 20.0 * 20f64.sin()).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    equations: Equations,
    warnings: Vec<Diagnostic>,
    program: codegen::Program,
    tape: TapeModel,
}

/// Largest model file that is read, in bytes; far above any that a person writes.
const LARGEST_FILE: u64 = 64 << 20;

impl Model {
    /// Reads a model file. Tables that it names are looked for beside it.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, or everything that is wrong with the model.
    pub fn from_path(path: impl AsRef<Path>) -> Result<Self, Diagnostics> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let text = read(path).map_err(|why| {
            Diagnostics(vec![Diagnostic::error(format!(
                "cannot read the model file `{name}`: {why}"
            ))])
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::compile(Source::new(name, text), &|file| read(&folder.join(file)))
    }

    /// Understands a model given as text; `name` stands for its file in messages. It cannot name
    /// tables in files of their own.
    ///
    /// # Errors
    ///
    /// Everything that is wrong with the model.
    pub fn from_source(name: &str, text: &str) -> Result<Self, Diagnostics> {
        Self::compile(Source::new(name, text), &|file| {
            Err(format!("a model given as text cannot read `{file}`"))
        })
    }

    fn compile(
        source: Source,
        files: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Self, Diagnostics> {
        let (equations, warnings) =
            flexure_model_dsl::compile(source, files).map_err(Diagnostics)?;
        let program = codegen::program(&equations);
        let tape = codegen::tape(&program);
        Ok(Self {
            inner: Arc::new(Inner {
                equations,
                warnings,
                program,
                tape,
            }),
        })
    }

    /// Name of the model.
    pub fn name(&self) -> &str {
        &self.inner.equations.name
    }

    /// Its equations of motion.
    pub fn equations(&self) -> &Equations {
        &self.inner.equations
    }

    /// What the equations are computed as, sorted by what each step depends on.
    pub fn program(&self) -> &codegen::Program {
        &self.inner.program
    }

    /// What runs it.
    pub fn tape(&self) -> &TapeModel {
        &self.inner.tape
    }

    /// What its author should know, and need not change.
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.inner.warnings
    }

    /// Its params in order of declaration, each with its default.
    pub fn params(&self) -> &[Variable] {
        self.inner.tape.params()
    }

    /// Its named parameter sets.
    pub fn sets(&self) -> impl Iterator<Item = &str> {
        self.inner
            .equations
            .sets
            .iter()
            .map(|set| set.name.as_str())
    }

    /// Signals from outside, each with the value that it has until somebody sets it.
    pub fn inputs(&self) -> &[Variable] {
        &self.inner.tape.program().inputs
    }

    /// The position of a param among [`Self::params`].
    ///
    /// # Errors
    ///
    /// If the model has no such param; the hint names the one that may be meant.
    pub fn position(&self, name: &str) -> Result<usize, Diagnostic> {
        let params = &self.equations().params;
        params
            .iter()
            .position(|param| param.name == name)
            .ok_or_else(|| {
                let error =
                    Diagnostic::error(format!("model `{}` has no param `{name}`", self.name()));
                let names = params.iter().map(|param| param.name.as_str());
                error.hint(match closest(name, names.clone()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if params.is_empty() => "it has no params at all".to_owned(),
                    None => format!("it has {}", names.collect::<Vec<_>>().join(", ")),
                })
            })
    }

    /// A parameter set to start from: every param at its default.
    pub fn design(&self) -> Design {
        Design {
            values: self.inner.tape.defaults(),
            is_exact: false,
            model: self.clone(),
        }
    }
}

pub(crate) fn read(path: &Path) -> Result<String, String> {
    let in_words = |why: std::io::Error| match why.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
        std::io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => why.to_string(),
    };
    let data = std::fs::metadata(path).map_err(in_words)?;
    if data.is_dir() {
        return Err("it is a folder".to_owned());
    }
    if data.len() > LARGEST_FILE {
        return Err(format!("it is larger than {} MiB", LARGEST_FILE >> 20));
    }
    let bytes = std::fs::read(path).map_err(in_words)?;
    String::from_utf8(bytes).map_err(|_| "it is no text in UTF-8".to_owned())
}

/// A value for each param of a model.
#[derive(Clone, Debug)]
pub struct Design {
    model: Model,
    values: Vec<f64>,
    is_exact: bool,
}

impl Design {
    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Values of the params in SI, in order of declaration.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The same, to be changed.
    #[cfg(feature = "study")]
    pub(crate) fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Sets a param to a value in SI.
    ///
    /// # Errors
    ///
    /// If the model has no such param; the hint names the one that may be meant.
    pub fn set(&mut self, name: &str, value: f64) -> Result<&mut Self, Diagnostic> {
        let index = self.model.position(name)?;
        self.values[index] = value;
        Ok(self)
    }

    /// Sets a param as a person writes it: `Fp=15N`, `stroke = 20 um`; a bare number is in SI.
    ///
    /// # Errors
    ///
    /// If the model has no such param, or the value is no quantity or has another unit.
    pub fn set_written(&mut self, assignment: &str) -> Result<&mut Self, Diagnostic> {
        let (name, written) = split_assignment(assignment)?;
        let index = self.model.position(name)?;
        let param = &self.model.equations().params[index];
        self.values[index] = quantity(name, written, param.dimension)?;
        Ok(self)
    }

    /// Sets the params of a named set of the model; the others stay as they are.
    ///
    /// # Errors
    ///
    /// If the model has no such set; the hint lists those it has.
    pub fn use_set(&mut self, name: &str) -> Result<&mut Self, Diagnostic> {
        let sets = &self.model.inner.tape.program().sets;
        let Some((_, values)) = sets.iter().find(|(set, _)| set == name) else {
            let known: Vec<_> = sets.iter().map(|(set, _)| format!("`{set}`")).collect();
            let error = Diagnostic::error(format!(
                "model `{}` has no parameter set `{name}`",
                self.model.name()
            ));
            return Err(error.hint(match known.len() {
                0 => "it has none; one is written `set name { Fp = 15 N }` in the model file"
                    .to_owned(),
                _ => format!("it has {}", known.join(", ")),
            }));
        };
        for &(index, value) in values {
            self.values[index] = value;
        }
        Ok(self)
    }

    /// Whether right-hand sides have functions of one coordinate in closed form everywhere, instead
    /// of by tables near the start.
    pub fn exact(&mut self, wanted: bool) -> &mut Self {
        self.is_exact = wanted;
        self
    }

    /// Whether functions of one coordinate are in closed form everywhere.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Closes the loops, picks branches and computes all that depends on params alone.
    ///
    /// # Errors
    ///
    /// What is wrong with the parameter set: a loop that cannot close, a negative mass.
    pub fn prepare(&self) -> Result<impl LaneSystem + Clone + use<>, Diagnostic> {
        let prepared = self.model.inner.tape.prepare(&self.values)?;
        Ok(if self.is_exact {
            prepared.exact()
        } else {
            prepared
        })
    }

    /// The mechanism as assembled with these params: facts and places for people.
    ///
    /// # Errors
    ///
    /// As [`Design::prepare`].
    pub fn assembled(&self) -> Result<Assembled<'_>, Diagnostic> {
        let system = Box::new(self.prepare()?);
        Assembled::new(self.model.equations(), &self.values, system)
    }
}

/// Splits `name = value`.
///
/// # Errors
///
/// If it is not of that form.
pub fn split_assignment(assignment: &str) -> Result<(&str, &str), Diagnostic> {
    match assignment.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok((name.trim(), value.trim()))
        }
        _ => Err(Diagnostic::error(format!("`{assignment}` sets nothing"))
            .hint("write a name, an equals sign and a value: `Fp=15N`")),
    }
}

/// Reads a value with its unit for something of dimension `expected`; a bare number is in SI.
///
/// # Errors
///
/// If it is no quantity or has another unit.
pub fn quantity(name: &str, written: &str, expected: Dimension) -> Result<f64, Diagnostic> {
    exact_quantity(name, written, expected)?
        .to_f64()
        .filter(|value| value.is_finite())
        .ok_or_else(|| Diagnostic::error(format!("`{name}`: {written} is too large")))
}

/// [`quantity`] without rounding.
pub(crate) fn exact_quantity(
    name: &str,
    written: &str,
    expected: Dimension,
) -> Result<Rational, Diagnostic> {
    let (value, given) =
        parse_quantity(written).map_err(|why| Diagnostic::error(format!("`{name}`: {why}")))?;
    if let Some(given) = given {
        if !given.same_units(expected) {
            return Err(Diagnostic::error(format!(
                "`{name}` is {}, and {written} is {}",
                expected.described(),
                given.described()
            ))
            .hint(match expected.si_unit().as_str() {
                "1" => "give it without a unit, in deg or in %".to_owned(),
                unit => format!("give it in {unit} or a unit of that kind"),
            }));
        }
        let clash = matches!(
            (given.mark(), expected.mark()),
            (Mark::Frequency, Mark::AngularRate) | (Mark::AngularRate, Mark::Frequency)
        );
        if clash {
            return Err(Diagnostic::error(format!(
                "`{name}` is {}, and {written} is {}",
                expected.described(),
                given.described()
            ))
            .hint("1 Hz is 2π rad/s"));
        }
    }
    Ok(value)
}
