//! Conditions that every parameter set must meet, whatever the model.

use crate::diagnostic::Diagnostic;
use crate::system::Variable;

/// Whether every param is a finite number.
///
/// # Errors
/// Names the first that is not, or says that their number is wrong.
pub fn check_params(rows: &[Variable], values: &[f64]) -> Result<(), Diagnostic> {
    if rows.len() != values.len() {
        return Err(Diagnostic::error(format!(
            "the model has {} params, and {} values were given",
            rows.len(),
            values.len()
        )));
    }
    for (row, value) in rows.iter().zip(values) {
        if !value.is_finite() {
            let what = if value.is_nan() {
                "not a number"
            } else {
                "infinite"
            };
            return Err(
                Diagnostic::error(format!("param `{}` is {what}", row.name)).hint(format!(
                    "give `{}` a finite value{}",
                    row.name,
                    in_unit(&row.unit)
                )),
            );
        }
    }
    Ok(())
}

/// Whether every state has a finite value at the start.
///
/// # Errors
/// Names the first that has none.
pub fn check_start(rows: &[Variable], values: &[f64]) -> Result<(), Diagnostic> {
    for (row, value) in rows.iter().zip(values) {
        if !value.is_finite() {
            return Err(Diagnostic::error(format!(
                "`{}` has no finite value at the start with these params",
                row.name
            ))
            .hint("look for a param that is zero, negative or extreme where it may not be"));
        }
    }
    Ok(())
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() || unit == "1" {
        String::new()
    } else {
        format!(" in {unit}")
    }
}
