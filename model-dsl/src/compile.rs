//! The whole way from text to equations.

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::Equations;
use crate::mechanics::derive;
use crate::resolve::resolve;
use crate::source::Source;
use crate::structure::structure;

/// Compiles a model file: text, model, structure, equations.
///
/// `files` gives the text of other files that the model names (tables of drives), by the path as
/// written in the model.
///
/// Returns the equations together with warnings.
///
/// # Errors
/// Everything that is wrong with the file, as far as it can be told at once.
pub fn compile(
    source: Source,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<(Equations, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (model, mut warnings) = resolve(source, files)?;
    let structure = structure(&model)?;
    let equations = derive(&model, &structure)?;
    warnings.extend(equations.warnings.iter().cloned());
    Ok((equations, warnings))
}
