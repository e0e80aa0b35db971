//! Messages with holes, filled when a parameter set is prepared.
//!
//! The compiler knows what can go wrong and where in the model file; only `prepare` knows the
//! numbers. A [`Failure`] is the former, [`Failure::diagnostic`] puts the latter in. The tape and
//! compiled `prepare` both use it, so that both say the same.

use std::borrow::Cow;

use crate::diagnostic::{Diagnostic, Site};

/// How a value is shown in a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A plain number.
    Number,
    /// An angle in rad, shown in degrees.
    Degree,
    /// A length in m, shown with a fitting prefix.
    Metre,
    /// An SI unit by its symbol, shown with a prefix if it is a single unit: `kg`, `N`, `N/m`.
    Other(&'static str),
}

/// An error that evaluation may find.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Message; `{0}`, `{1}` stand for values.
    pub message: Cow<'static, str>,
    /// What would mend it; with holes too.
    pub hint: Option<Cow<'static, str>>,
    /// Where.
    pub site: Option<Site>,
    /// Parts and turns of a `repeat` that bring the place there, each with what it is called.
    pub related: Cow<'static, [(Site, Cow<'static, str>)]>,
    /// Units of the values.
    pub units: Cow<'static, [Unit]>,
}

impl Failure {
    /// The error, with its holes filled.
    pub fn diagnostic(&self, values: &[f64]) -> Diagnostic {
        let mut diagnostic = Diagnostic::error(render(&self.message, values, &self.units));
        diagnostic.site.clone_from(&self.site);
        for (site, label) in self.related.iter() {
            diagnostic = diagnostic.related(site.clone(), label.clone());
        }
        diagnostic.hint = self
            .hint
            .as_ref()
            .map(|hint| render(hint, values, &self.units));
        diagnostic
    }
}

/// `template` with each hole `{0}`, `{1}`, … replaced by the value of that position.
///
/// Braces that enclose no position of a value stay as they are.
pub fn render(template: &str, values: &[f64], units: &[Unit]) -> String {
    let mut text = String::with_capacity(template.len());
    let mut rest = template;
    while let Some(open) = rest.find('{') {
        text.push_str(&rest[..open]);
        rest = &rest[open..];
        let hole = rest.find('}').and_then(|close| {
            let position: usize = rest[1..close].parse().ok()?;
            let value = *values.get(position)?;
            let unit = units.get(position).copied().unwrap_or(Unit::Number);
            Some((close, quantity(value, unit)))
        });
        match hole {
            Some((close, shown)) => {
                text.push_str(&shown);
                rest = &rest[close + 1..];
            }
            None => {
                text.push('{');
                rest = &rest[1..];
            }
        }
    }
    text.push_str(rest);
    text
}

/// A value with its unit, as a person would write it: four significant digits, SI prefix.
///
/// What is no finite number has no unit.
pub fn quantity(value: f64, unit: Unit) -> String {
    if !value.is_finite() {
        return number(value);
    }
    match unit {
        Unit::Number => number(value),
        Unit::Degree => format!("{}°", number(value.to_degrees())),
        Unit::Metre => prefixed(value, "m"),
        Unit::Other("kg") => prefixed(value * 1e3, "g"),
        Unit::Other("" | "1") => number(value),
        Unit::Other(symbol) if symbol.chars().all(char::is_alphabetic) => prefixed(value, symbol),
        Unit::Other(symbol) => format!("{} {symbol}", number(value)),
    }
}

fn prefixed(value: f64, symbol: &str) -> String {
    const PREFIXES: [(f64, &str); 8] = [
        (1e9, "G"),
        (1e6, "M"),
        (1e3, "k"),
        (1e0, ""),
        (1e-3, "m"),
        (1e-6, "µ"),
        (1e-9, "n"),
        (1e-12, "p"),
    ];
    let size = value.abs();
    // Lengths above a metre stay in metres; so does whatever no prefix fits.
    let fitting = PREFIXES
        .iter()
        .filter(|(factor, _)| symbol != "m" || *factor <= 1.0)
        .find(|(factor, _)| size >= 0.99995 * factor);
    match fitting {
        Some((factor, prefix)) if size.is_finite() && size < 1e13 => {
            format!("{} {prefix}{symbol}", number(value / factor))
        }
        _ => format!("{} {symbol}", number(value)),
    }
}

/// Four significant digits, without trailing zeros; powers of ten only where digits would be many.
fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return if value.is_nan() {
            "not a number".to_owned()
        } else if value > 0.0 {
            "larger than any number here can be".to_owned()
        } else {
            "negative and larger than any number here can be".to_owned()
        };
    }
    let scientific = format!("{value:.3e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = usize::try_from(3 - exponent).unwrap_or(0);
        trimmed(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", trimmed(mantissa))
    }
}

fn trimmed(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_read_as_written_by_hand() {
        let cases = [
            (0.0032, Unit::Metre, "3.2 mm"),
            (-0.00002345678, Unit::Metre, "-23.46 µm"),
            (0.001, Unit::Metre, "1 mm"),
            (0.00099999, Unit::Metre, "1 mm"),
            (25.0, Unit::Metre, "25 m"),
            (4321.0, Unit::Metre, "4321 m"),
            (1.3962634015954636, Unit::Degree, "80°"),
            (0.0002568, Unit::Other("kg"), "256.8 mg"),
            (20.0, Unit::Other("N"), "20 N"),
            (7.2e10, Unit::Other("Pa"), "72 GPa"),
            (3.6e6, Unit::Other("N/m"), "3.6e6 N/m"),
            (0.0, Unit::Metre, "0 m"),
            (
                f64::INFINITY,
                Unit::Metre,
                "larger than any number here can be",
            ),
            (f64::NAN, Unit::Metre, "not a number"),
            (0.99999, Unit::Number, "1"),
            (123456.0, Unit::Number, "123456"),
        ];
        for (value, unit, expected) in cases {
            assert_eq!(quantity(value, unit), expected);
        }
    }

    #[test]
    fn holes_are_filled_and_other_braces_kept() {
        assert_eq!(
            render(
                "at {0} the gap is {1}, {2} {x} {",
                &[0.5, 0.0032],
                &[Unit::Degree, Unit::Metre]
            ),
            "at 28.65° the gap is 3.2 mm, {2} {x} {"
        );
    }
}
