//! Comparison of a response with an experiment: a table of frequencies and speeds, and the root of
//! the mean square of their difference.
//!
//! The article (Nguyen and Nguyen, Machines 2025, 13, 787) gives its error as "root mean square" of
//! the "relative modeling error", in percent, without a formula. Here it is, over the points of the
//! experiment, √(mean((v − v_e)²)) in the speed's unit, and √(mean(((v − v_e) / v_e)²)) relative.

use std::path::Path;

use flexure_model_dsl::units::{Dimension, Mark, Unit};
use flexure_runtime::diagnostic::{Diagnostic, Site};
use num_traits::ToPrimitive;

/// Measured speeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// Frequencies in Hz and speeds in SI, in the order of the file.
    pub points: Vec<(f64, f64)>,
}

/// Largest file that is read, in bytes.
const LARGEST_FILE: u64 = 16 << 20;

impl Experiment {
    /// Reads a file as [`Self::parse`].
    ///
    /// # Errors
    ///
    /// If the file cannot be read, and as [`Self::parse`].
    pub fn from_path(path: &Path, speed_unit: &str) -> Result<Self, Diagnostic> {
        let name = path.display().to_string();
        let cannot = |why: String| Diagnostic::error(format!("cannot read `{name}`: {why}"));
        let data = std::fs::metadata(path).map_err(|why| cannot(why.to_string()))?;
        if data.is_dir() {
            return Err(cannot("it is a folder".to_owned()));
        }
        if data.len() > LARGEST_FILE {
            return Err(cannot(format!(
                "it is larger than {} MiB",
                LARGEST_FILE >> 20
            )));
        }
        let bytes = std::fs::read(path).map_err(|why| cannot(why.to_string()))?;
        let text =
            String::from_utf8(bytes).map_err(|_| cannot("it is no text in UTF-8".to_owned()))?;
        Self::parse(&name, &text, speed_unit)
    }

    /// Reads a table of comma-separated values: a line of headings with units, as in
    /// `frequency (Hz), speed (mm/s)`, then a line for each point. Further columns are not looked
    /// at, nor are empty lines and those that begin with `#`. `speed_unit` is the SI unit of the
    /// speed that is compared.
    ///
    /// # Errors
    ///
    /// What is wrong with the table, and in which line and column.
    pub fn parse(name: &str, text: &str, speed_unit: &str) -> Result<Self, Diagnostic> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().enumerate().filter(|(_, line)| {
            let line = line.trim();
            !line.is_empty() && !line.starts_with('#')
        });
        let Some((index, header)) = lines.next() else {
            return Err(Diagnostic::error(format!("`{name}` has no table"))
                .hint("begin it with headings: `frequency (Hz), speed (mm/s)`"));
        };
        let line = Line::new(name, index, header);
        let speed = Unit::parse(speed_unit).map_or(Dimension::NONE, |unit| unit.dimension);
        let [frequency_factor, speed_factor] =
            [(0, Dimension::FREQUENCY), (1, speed)].map(|(column, dimension)| {
                line.field(column)
                    .and_then(|field| factor(&line, field, dimension))
            });
        let (frequency_factor, speed_factor) = (frequency_factor?, speed_factor?);
        let mut points = Vec::new();
        for (index, text) in lines {
            let line = Line::new(name, index, text);
            let frequency = line.number(0)? * frequency_factor;
            if !(frequency > 0.0) {
                return Err(line
                    .error(line.field(0)?, "a drive frequency is above zero".to_owned())
                    .hint("leave out the point without motion"));
            }
            points.push((frequency, line.number(1)? * speed_factor));
        }
        if points.is_empty() {
            return Err(Diagnostic::error(format!(
                "`{name}` has headings and no points"
            )));
        }
        Ok(Self { points })
    }

    /// How far a response is from the experiment: `simulated` gives the speed at a frequency of the
    /// experiment, if there is one. `None` if there is none at any.
    pub fn deviation(&self, simulated: impl Fn(f64) -> Option<f64>) -> Option<Deviation> {
        let pairs: Vec<(f64, f64)> = self
            .points
            .iter()
            .filter_map(|&(frequency, measured)| {
                let speed = simulated(frequency).filter(|speed| speed.is_finite())?;
                Some((measured, speed - measured))
            })
            .collect();
        let mean_square = |of: &dyn Fn(&(f64, f64)) -> f64| {
            (pairs.iter().map(|pair| of(pair).powi(2)).sum::<f64>() / pairs.len() as f64).sqrt()
        };
        let relative = mean_square(&|(measured, error)| error / measured);
        (!pairs.is_empty()).then(|| Deviation {
            points: pairs.len(),
            absolute: mean_square(&|(_, error)| *error),
            relative: Some(relative).filter(|relative| relative.is_finite()),
        })
    }
}

/// How far a response is from an experiment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Number of points compared.
    pub points: usize,
    /// Root of the mean square of the differences, in the speed's unit.
    pub absolute: f64,
    /// Root of the mean square of the differences, each relative to the measured speed; `None` if a
    /// measured speed is zero.
    pub relative: Option<f64>,
}

/// A field: where it begins in its line, in bytes, and what stands there.
#[derive(Clone, Copy)]
struct Field<'a> {
    start: usize,
    text: &'a str,
}

struct Line<'a> {
    file: &'a str,
    number: usize,
    text: &'a str,
}

impl<'a> Line<'a> {
    fn new(file: &'a str, index: usize, text: &'a str) -> Self {
        Self {
            file,
            number: index + 1,
            text,
        }
    }

    /// A field without blanks and quotation marks around it.
    fn field(&self, column: usize) -> Result<Field<'a>, Diagnostic> {
        let mut start = 0;
        for (index, text) in self.text.split(',').enumerate() {
            if index == column {
                let bare = text.trim_matches(|c: char| c.is_whitespace() || c == '"');
                let inner = text.find(bare).unwrap_or(0);
                return Ok(Field {
                    start: start + inner,
                    text: bare,
                });
            }
            start += text.len() + 1;
        }
        let whole = Field {
            start: 0,
            text: self.text,
        };
        Err(self
            .error(
                whole,
                "two values are wanted: frequency and speed".to_owned(),
            )
            .hint("separate them by a comma, and write decimals with a point"))
    }

    fn number(&self, column: usize) -> Result<f64, Diagnostic> {
        let field = self.field(column)?;
        match field.text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(self
                .error(field, format!("`{}` is no number", field.text))
                .hint("separate values by commas, and write decimals with a point")),
        }
    }

    fn error(&self, field: Field<'_>, message: String) -> Diagnostic {
        let before = self.text.get(..field.start).unwrap_or("");
        Diagnostic::error(message).at(Site {
            file: self.file.to_owned().into(),
            line: self.number,
            column: before.chars().count() + 1,
            width: field.text.chars().count().max(1),
            excerpt: self.text.to_owned().into(),
        })
    }
}

/// The size in SI of the unit in a heading: `speed (mm/s)`, `speed [mm/s]`.
fn factor(line: &Line<'_>, field: Field<'_>, wanted: Dimension) -> Result<f64, Diagnostic> {
    let example = match wanted.mark() {
        Mark::Frequency => "frequency (Hz)".to_owned(),
        _ => format!("speed ({})", wanted.si_unit()),
    };
    let hint = format!("write the unit in parentheses: `{example}`");
    let inside = field.text.rsplit_once(['(', '[']).map(|(_, rest)| rest);
    let Some(written) = inside.and_then(|rest| rest.strip_suffix([')', ']'])) else {
        let message = if field.text.parse::<f64>().is_ok() {
            "the first line has no headings".to_owned()
        } else {
            format!("the heading `{}` has no unit", field.text)
        };
        return Err(line.error(field, message).hint(hint));
    };
    let written = written.trim();
    let unit = Unit::parse(written).map_err(|part| {
        line.error(field, format!("`{part}` is no unit"))
            .hint(hint.clone())
    })?;
    let is_other_rate =
        wanted.mark() == Mark::Frequency && unit.dimension.mark() == Mark::AngularRate;
    if !unit.dimension.same_units(wanted) || is_other_rate {
        let message = format!(
            "{} is wanted, and `{written}` is {}",
            wanted.described(),
            unit.dimension.described()
        );
        return Err(line.error(field, message).hint(hint));
    }
    let factor = unit.factor.to_f64().unwrap_or(f64::NAN);
    Ok(factor * std::f64::consts::PI.powi(unit.pi_power))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Vec<(f64, f64)>, String> {
        let read = Experiment::parse("sun.csv", text, "m/s");
        read.map(|e| e.points).map_err(|error| error.to_string())
    }

    #[test]
    fn tables_are_read_in_their_units() {
        let text = "\u{feff}# measured\nfrequency (kHz), \"speed [mm/s]\", spread\r\n\n0.1, 0.8, 0.1\r\n 0.2 ,1.75\n";
        assert_eq!(parse(text).unwrap(), [(100.0, 0.8e-3), (200.0, 1.75e-3)]);
    }

    #[test]
    fn faults_have_line_and_column() {
        let cases = [
            ("", "has no table"),
            ("# nothing\n\n", "has no table"),
            ("f (Hz), v (mm/s)\n", "no points"),
            ("100, 0.8\n", "sun.csv:1:1"),
            ("100, 0.8\n", "no headings"),
            ("f (Hz), v\n", "sun.csv:1:9"),
            ("f (Hz), v\n", "has no unit"),
            ("f (Hz), v (mm)\n", "is wanted, and `mm` is a length"),
            ("f (rad/s), v (m/s)\n", "a frequency (Hz) is wanted"),
            ("f (Hz), v (knots)\n", "`knots` is no unit"),
            ("f (Hz)\n", "two values are wanted"),
            ("f (Hz), v (m/s)\n100, 0.8\n200, o.9\n", "sun.csv:3:6"),
            (
                "f (Hz), v (m/s)\n100, 0.8\n200, o.9\n",
                "`o.9` is no number",
            ),
            ("f (Hz), v (m/s)\n100\n", "sun.csv:2:1"),
            ("f (Hz), v (m/s)\n100; 0.8\n", "separate values by commas"),
            ("f (Hz), v (m/s)\n0, 0\n", "above zero"),
            ("f (Hz), v (m/s)\n1, NaN\n", "`NaN` is no number"),
            ("f (Hz), v (m/s)\n1,\n", "`` is no number"),
        ];
        for (text, expected) in cases {
            let error = parse(text).unwrap_err();
            assert!(error.contains(expected), "{text:?}: {error}");
        }
    }

    #[test]
    fn deviations_by_hand() {
        let experiment = Experiment {
            points: vec![(100.0, 1.0), (200.0, 2.0), (300.0, 4.0)],
        };
        let speeds = |f: f64| match f {
            100.0 => Some(1.3),
            200.0 => Some(1.6),
            _ => None,
        };
        let found = experiment.deviation(speeds).unwrap();
        assert_eq!(found.points, 2);
        // √((0.3² + 0.4²)/2), √((0.3² + 0.2²)/2)
        assert!((found.absolute - 0.125_f64.sqrt()).abs() < 1e-12);
        assert!((found.relative.unwrap() - 0.065_f64.sqrt()).abs() < 1e-12);
        assert_eq!(experiment.deviation(|_| None), None);
        assert_eq!(experiment.deviation(|_| Some(f64::NAN)), None);
        let at_rest = Experiment {
            points: vec![(100.0, 0.0)],
        };
        assert_eq!(at_rest.deviation(|_| Some(1.0)).unwrap().relative, None);
    }
}
