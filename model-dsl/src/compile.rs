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
    let structure = structure(&model).map_err(once_each)?;
    let equations = derive(&model, &structure).map_err(once_each)?;
    warnings.extend(once_each(equations.warnings.clone()));
    Ok((equations, warnings))
}

/// What is wrong in the same way with several copies of one place is told of the first.
pub(crate) fn once_each(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut told: Vec<Diagnostic> = Vec::new();
    diagnostics.retain(|diagnostic| {
        let is_copy = |earlier: &Diagnostic| {
            !earlier.related.is_empty()
                && (&earlier.site, &earlier.hint) == (&diagnostic.site, &diagnostic.hint)
        };
        let is_new = !told.iter().any(is_copy);
        if is_new {
            told.push(diagnostic.clone());
        }
        is_new
    });
    diagnostics
}
