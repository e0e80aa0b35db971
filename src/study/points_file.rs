//! Design points from a file: a table of comma-separated values with a header of names.

use flexure_model_dsl::units::Unit;
use flexure_runtime::diagnostic::{Diagnostic, Site};

use super::Target;
use crate::{Model, quantity};

/// Design points of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct PointsFile {
    /// What each column gives a value to.
    pub targets: Vec<Target>,
    /// The points, one after the other, in SI.
    pub values: Vec<f64>,
}

/// Where a field stands.
struct Field<'t> {
    text: &'t str,
    site: Site,
}

impl PointsFile {
    /// Reads a table of which each line is a point. The first line names the params, each with a
    /// unit if it likes: `f [kHz],Fp [N]`. Fields are numbers in that unit, else in SI, or quantities
    /// with a unit of their own. Semicolons and tabs separate fields as well; empty lines and those
    /// that begin with `#` are skipped. `file` stands for the file in messages.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong, with its line and column.
    pub fn parse(model: &Model, file: &str, text: &str) -> Result<Self, Diagnostic> {
        let text = text.trim_start_matches('\u{FEFF}');
        let mut lines = text.lines().enumerate().filter(|(_, line)| {
            let line = line.trim();
            !line.is_empty() && !line.starts_with('#')
        });
        let Some((number, header)) = lines.next() else {
            return Err(
                Diagnostic::error(format!("`{file}` holds no design points")).hint(
                    "its first line names params, each other line is a point: `f [Hz],Fp [N]`",
                ),
            );
        };
        let mut targets: Vec<Target> = Vec::new();
        let mut units = Vec::new();
        for field in fields(file, number, header) {
            let at = |error: Diagnostic| error.at(field.site.clone());
            let (name, unit) = match field.text.split_once('[') {
                Some((name, unit)) => (name.trim(), Some(unit.trim_end_matches(']').trim())),
                None => (field.text, None),
            };
            let target = Target::named(model, name).map_err(at)?;
            if targets.iter().any(|other| other.name() == name) {
                return Err(at(Diagnostic::error(format!("`{name}` has two columns"))));
            }
            if let Some(unit) = unit {
                Unit::parse(unit)
                    .map_err(|part| at(Diagnostic::error(format!("`{part}` is no unit"))))?;
                quantity(name, &format!("1 {unit}"), target.dimension()).map_err(at)?;
            }
            targets.push(target);
            units.push(unit);
        }
        let mut values = Vec::new();
        for (number, line) in lines {
            let fields = fields(file, number, line);
            if fields.len() != targets.len() {
                let site = Site {
                    column: 1,
                    width: line.chars().count().max(1),
                    ..fields[0].site.clone()
                };
                let (is, wanted) = (fields.len(), targets.len());
                return Err(Diagnostic::error(format!(
                    "this line has {is} field{}, the header has {wanted}",
                    if is == 1 { "" } else { "s" }
                ))
                .at(site)
                .hint("give every point a value for each param of the header"));
            }
            for ((field, target), unit) in fields.iter().zip(&targets).zip(&units) {
                let bare = field.text.parse::<f64>().is_ok();
                let written = match unit {
                    Some(unit) if bare => format!("{} {unit}", field.text),
                    _ => field.text.to_owned(),
                };
                let value = quantity(target.name(), &written, target.dimension());
                values.push(value.map_err(|error| error.at(field.site.clone()))?);
            }
        }
        if values.is_empty() {
            return Err(
                Diagnostic::error(format!("`{file}` names params but holds no points"))
                    .hint("write a line with their values for each point"),
            );
        }
        Ok(Self { targets, values })
    }
}

fn fields<'t>(file: &str, number: usize, line: &'t str) -> Vec<Field<'t>> {
    let mut column = 1;
    line.split([',', ';', '\t'])
        .map(|field| {
            let lead = field.chars().take_while(|c| c.is_whitespace()).count();
            let text = field.trim();
            let site = Site {
                file: file.to_owned().into(),
                line: number + 1,
                column: column + if text.is_empty() { 0 } else { lead },
                width: text.chars().count().max(1),
                excerpt: line.to_owned().into(),
            };
            column += field.chars().count() + 1;
            Field { text, site }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<PointsFile, Diagnostic> {
        let model = "model m\nparam l = 1 m\nparam Fp = 1 N\n\
                     slide s along (1, 0) { mass = 1 kg }\nforce on s = (Fp * l / 1 m, 0 N)\n";
        PointsFile::parse(&Model::from_source("m.flex", model).unwrap(), "p.csv", text)
    }

    #[test]
    fn units_stand_in_the_header_or_in_the_field() {
        let points = read("\u{FEFF}# points\nl [mm] , Fp\n1,2\n\n3 um,4 kN\n").unwrap();
        assert_eq!(points.values, [1e-3, 2.0, 3e-6, 4000.0]);
    }

    #[test]
    fn mistakes_have_a_line_and_a_column() {
        for (text, line, column, word) in [
            ("l,Fq\n1,2\n", 1, 3, "no param `Fq`"),
            ("l,l\n1,2\n", 1, 3, "two columns"),
            ("l [N],Fp\n1,2\n", 1, 1, "a length"),
            ("l [foo],Fp\n1,2\n", 1, 1, "is no unit"),
            ("l,Fp\n1,2\n1\n", 3, 1, "has 1 field"),
            ("l,Fp\n1, x\n", 2, 4, "no quantity"),
            ("l,Fp\n1,2 m\n", 2, 3, "a force"),
        ] {
            let error = read(text).unwrap_err();
            let site = error.site.clone().unwrap();
            assert_eq!((site.line, site.column), (line, column), "{error}");
            assert!(error.to_string().contains(word), "{error}");
        }
        for text in ["", "l,Fp\n"] {
            assert!(read(text).unwrap_err().to_string().contains("p.csv"));
        }
    }
}
