//! Values of one target: lists, steps, even and logarithmic spacing, as a person writes them.

use flexure_model_dsl::symbolic::Rational;
use flexure_runtime::diagnostic::Diagnostic;
use num_traits::{Signed, ToPrimitive, Zero};

use super::Target;
use crate::model::exact_quantity;
use crate::{Model, split_assignment};

/// More values than this on one axis are a slip of the pen.
const MOST_VALUES: usize = 1_000_000;

/// A target with the values that it takes in turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What takes them.
    pub target: Target,
    /// The values in SI.
    pub values: Vec<f64>,
}

impl Axis {
    /// Reads `NAME=VALUES`. Values are a list, `Fp=1N,5N,10N`, of values and ranges:
    ///
    /// - `100Hz..2kHz:100Hz`: from the first in steps of the last, the end included if a step ends
    ///   there;
    /// - `100Hz..2kHz:lin20`: 20 values, evenly spaced, both ends included;
    /// - `100Hz..10kHz:log20`: 20 values, each the same multiple of the one before.
    ///
    /// # Errors
    ///
    /// If the model has no such param, a value is no quantity of its kind, or a range is empty.
    pub fn parse(model: &Model, written: &str) -> Result<Self, Diagnostic> {
        let (name, list) = split_assignment(written).map_err(|error| {
            error.hint("write a name and its values: `Fp=1N,5N` or `f=100Hz..2kHz:100Hz`")
        })?;
        let target = Target::named(model, name)?;
        let mut values = Vec::new();
        for part in list.split(',').map(str::trim) {
            match part.split_once("..") {
                Some((from, rest)) => range(&target, part, from, rest, &mut values)?,
                None => values.push(double(&target, part, &exact(&target, part)?)?),
            }
        }
        Ok(Self { target, values })
    }
}

fn exact(target: &Target, written: &str) -> Result<Rational, Diagnostic> {
    exact_quantity(target.name(), written, target.dimension())
}

fn double(target: &Target, written: &str, value: &Rational) -> Result<f64, Diagnostic> {
    let value = value.to_f64().filter(|value| value.is_finite());
    value.ok_or_else(|| Diagnostic::error(format!("`{}`: {written} is too large", target.name())))
}

fn whole(number: usize) -> Rational {
    Rational::from_integer(number.into())
}

fn range(
    target: &Target,
    part: &str,
    from: &str,
    rest: &str,
    values: &mut Vec<f64>,
) -> Result<(), Diagnostic> {
    let fault = |what: &str, hint: &str| {
        Err(Diagnostic::error(format!("`{}`: the range `{part}` {what}", target.name())).hint(hint))
    };
    let Some((to, spacing)) = rest.split_once(':') else {
        return fault(
            "has no spacing",
            "give a step or a number of values: `100Hz..2kHz:100Hz`, `…:lin20`, `…:log20`",
        );
    };
    let (first, last) = (exact(target, from)?, exact(target, to)?);
    let spacing = spacing.trim();
    let counted = ["lin", "log"].into_iter().find_map(|kind| {
        let count = spacing.strip_prefix(kind)?;
        Some((kind, count.parse::<usize>().ok()))
    });
    let Some((kind, count)) = counted else {
        let step = exact(target, spacing)?;
        if step.is_zero() {
            return fault("has a step of zero", "give a step above zero");
        }
        // Where units bring π in, a step that ends at the end does so up to rounding.
        let rounding = Rational::new(1.into(), 1_000_000_000.into());
        let steps = (&last - &first) / &step + rounding;
        if steps.is_negative() {
            return fault(
                "is empty: its step leads away from its end",
                "swap its ends, or change the sign of the step",
            );
        }
        let count = steps
            .floor()
            .to_usize()
            .filter(|&count| count < MOST_VALUES);
        let Some(count) = count else {
            return fault("has more than a million values", "take a longer step");
        };
        for k in 0..=count {
            values.push(double(target, part, &(&first + whole(k) * &step))?);
        }
        return Ok(());
    };
    let count = match count {
        Some(count) if (2..=MOST_VALUES).contains(&count) => count,
        _ => {
            return fault(
                "has no such number of values",
                "give a number from 2 to 1000000, as in `lin20`",
            );
        }
    };
    let ends = [double(target, from, &first)?, double(target, to, &last)?];
    if kind == "lin" {
        let step = (&last - &first) / whole(count - 1);
        for k in 0..count {
            values.push(double(target, part, &(&first + whole(k) * &step))?);
        }
        return Ok(());
    }
    if ends.iter().any(|&end| end <= 0.0) {
        return fault(
            "cannot be spaced logarithmically",
            "both of its ends must be above zero",
        );
    }
    for k in 0..count {
        let share = k as f64 / (count - 1) as f64;
        values.push(match k {
            0 => ends[0],
            _ if k + 1 == count => ends[1],
            _ => ends[0] * (ends[1] / ends[0]).powf(share),
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        let text = "model m\nparam f = 1 kHz\nparam Fp = 1 N\nparam a = 0.1\nparam b = 0.2\n\
                    slide s along (1, 0) { mass = 1 kg }\nforce on s = (Fp * a * b * f * 1 s, 0 N)\n";
        Model::from_source("m.flex", text).unwrap()
    }

    fn values(written: &str) -> Vec<f64> {
        Axis::parse(&model(), written).unwrap().values
    }

    #[test]
    fn values_are_those_written() {
        assert_eq!(values("Fp=1N, 5N,0.01kN"), [1.0, 5.0, 10.0]);
        assert_eq!(
            values("f=100Hz..0.5kHz:100Hz"),
            [100.0, 200.0, 300.0, 400.0, 500.0]
        );
        assert_eq!(values("f=500..100:-200"), [500.0, 300.0, 100.0]);
        assert_eq!(
            values("a=0.1..0.7:0.1"),
            [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
        );
        assert_eq!(values("a=0..1:lin5,3"), [0.0, 0.25, 0.5, 0.75, 1.0, 3.0]);
        let logarithmic = values("f=100Hz..10kHz:log5");
        assert_eq!((logarithmic[0], logarithmic[4]), (100.0, 1e4));
        assert!((logarithmic[2] - 1000.0).abs() < 1e-9);
        assert_eq!(values("a+b=0.9..1.1:10%"), [0.9, 1.0, 1.1]);
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (written, word) in [
            ("Fq=1N", "no param `Fq`"),
            ("Fp=1m", "a force"),
            ("Fp=", "sets nothing"),
            ("f=2kHz..1kHz:100Hz", "is empty"),
            ("f=1kHz..2kHz:0Hz", "step of zero"),
            ("f=1kHz..2kHz", "no spacing"),
            ("f=0Hz..2kHz:log4", "logarithmically"),
            ("f=0Hz..2kHz:lin1", "from 2"),
            ("f=0Hz..2kHz:1e-9Hz", "more than a million"),
            ("a+a=1", "twice"),
        ] {
            let error = Axis::parse(&model(), written).unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
    }
}
