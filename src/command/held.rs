//! What `static` and `modes` have in common: which contacts are held how, which drives at what, and
//! results by name.

use clap::Args;
use flexure::model_dsl::suggest::closest;
use flexure::quantity;
use flexure::runtime::diagnostic::Diagnostic;
use flexure::split_assignment;
use flexure::statics::{Hold, Rest, Statics};

use super::Failure;
use super::settings::{Chosen, Settings};
use super::terminal::Terminal;

/// Options of a study at rest.
#[derive(Debug, Args)]
pub struct AtRest {
    #[command(flatten)]
    pub settings: Settings,
    /// Hold a drive at a value, as in xp=10um; others stay at their start
    #[arg(long, value_name = "NAME=VALUE")]
    pub drive: Vec<String>,
    /// Leave a contact out: neither friction nor a normal force
    #[arg(long, value_name = "CONTACT")]
    pub without: Vec<String>,
    /// Let a contact stick, its bristle as a plain spring, whatever friction that takes
    #[arg(long, value_name = "CONTACT")]
    pub stick: Vec<String>,
}

impl AtRest {
    /// Reads the model in motion, for its warnings and params, and at rest.
    ///
    /// # Errors
    ///
    /// If the model is wrong, or a setting or a contact does not fit it.
    pub fn choose(&self, terminal: &Terminal) -> Result<(Chosen, Statics), Failure> {
        let chosen = self.settings.choose(terminal)?;
        let without = self.without.iter().cloned().map(Hold::Without);
        let stick = self.stick.iter().cloned().map(Hold::Stick);
        let holds: Vec<Hold> = without.chain(stick).collect();
        // The model itself is right, so what is wrong here is a contact's name.
        let statics = Statics::from_path(&self.settings.file, &holds)
            .map_err(|errors| Failure::Setting(errors.0))?;
        Ok((chosen, statics))
    }

    /// Values at which drives and inputs are held.
    ///
    /// # Errors
    ///
    /// If there is no such drive, or a value does not fit it.
    pub fn held(
        &self,
        chosen: &Chosen,
        statics: &Statics,
        rest: &Rest,
    ) -> Result<Vec<f64>, Failure> {
        let mut values = rest.start();
        for (index, value) in &chosen.inputs {
            let name = &chosen.design.model().inputs()[*index].name;
            values[signal(statics, name)?] = *value;
        }
        for assignment in &self.drive {
            let (name, written) = split_assignment(assignment).map_err(Failure::setting)?;
            let index = signal(statics, name)?;
            let dimension = statics.held()[index].dimension;
            values[index] = quantity(name, written, dimension).map_err(Failure::setting)?;
        }
        Ok(values)
    }
}

/// Position of a drive or input.
///
/// # Errors
///
/// If there is none of that name.
pub fn signal(statics: &Statics, name: &str) -> Result<usize, Failure> {
    let names = statics.held().iter().map(|held| held.name.as_str());
    position(name, "drive or input", names)
}

/// Position of a result: an output of the model, or a place such as `stage.x`.
///
/// # Errors
///
/// If there is none of that name.
pub fn result(statics: &Statics, name: &str) -> Result<usize, Failure> {
    position(
        name,
        "result",
        statics.results().iter().map(|row| &*row.name),
    )
}

fn position<'n>(
    name: &str,
    kind: &str,
    names: impl Iterator<Item = &'n str> + Clone,
) -> Result<usize, Failure> {
    names
        .clone()
        .position(|known| known == name)
        .ok_or_else(|| {
            let error = Diagnostic::error(format!("the model has no {kind} `{name}`"));
            Failure::setting(error.hint(match closest(name, names.clone()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("it has {}", names.collect::<Vec<_>>().join(", ")),
            }))
        })
}
