//! Limits on measures, and how sure a share of designs that keep them is.

use flexure_model_dsl::units::Unit;
use flexure_runtime::diagnostic::Diagnostic;

use super::Measure;
use crate::{Model, quantity};

/// A bound on a measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// As it was written: `mean(stage.v) > 5mm/s`.
    pub written: String,
    /// What is bounded.
    pub measure: Measure,
    relation: Relation,
    bound: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Above,
    NotBelow,
    Below,
    NotAbove,
}

impl Limit {
    /// Reads `mean(stage.v) > 5mm/s`; there are `>`, `>=`, `<` and `<=`. A bare number is in SI.
    ///
    /// # Errors
    ///
    /// If it is not of that form, or the bound has another unit than the measure.
    pub fn parse(model: &Model, written: &str) -> Result<Self, Diagnostic> {
        let Some(at) = written.find(['<', '>']) else {
            return Err(Diagnostic::error(format!("`{written}` is no limit"))
                .hint("compare a measure with a value: `mean(stage.v) > 5mm/s`"));
        };
        let (measure, rest) = written.split_at(at);
        let (relation, bound) = match (rest.strip_prefix(">="), rest.strip_prefix("<=")) {
            (Some(bound), _) => (Relation::NotBelow, bound),
            (_, Some(bound)) => (Relation::NotAbove, bound),
            _ if rest.starts_with('>') => (Relation::Above, &rest[1..]),
            _ => (Relation::Below, &rest[1..]),
        };
        let measure = Measure::parse(model, measure)?;
        let dimension =
            Unit::parse(measure.unit()).map_or_else(|_| Default::default(), |u| u.dimension);
        Ok(Self {
            written: written.trim().to_owned(),
            bound: quantity(measure.name(), bound.trim(), dimension)?,
            measure,
            relation,
        })
    }

    /// Whether a value of the measure keeps it; what is no number does not.
    pub fn holds(&self, value: f64) -> bool {
        match self.relation {
            Relation::Above => value > self.bound,
            Relation::NotBelow => value >= self.bound,
            Relation::Below => value < self.bound,
            Relation::NotAbove => value <= self.bound,
        }
    }
}

/// The shares that, with 95 % confidence, a count of `passed` among `count` draws speaks for:
/// Wilson's interval (J. Am. Stat. Assoc. 22, 1927, 209).
pub fn share_range(passed: usize, count: usize) -> [f64; 2] {
    let z = 1.959_963_984_540_054;
    let n = count as f64;
    let share = passed as f64 / n;
    let scale = 1.0 / (1.0 + z * z / n);
    let centre = scale * (share + z * z / (2.0 * n));
    let half = scale * z * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    [(centre - half).max(0.0), (centre + half).min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_hold_as_written() {
        let text = "model m\nslide s along (1, 0) { mass = 1 kg }\nforce on s = (1 N, 0 N)\n";
        let model = Model::from_source("m.flex", text).unwrap();
        let limit = |written: &str| Limit::parse(&model, written).unwrap();
        assert!(limit("mean(s.v) > 5 mm/s").holds(0.006));
        assert!(!limit("mean(s.v) > 5 mm/s").holds(0.005));
        assert!(limit("mean(s.v)>=5mm/s").holds(0.005));
        assert!(limit("last(s.x) <= 1um").holds(1e-6));
        assert!(!limit("last(s.x) < 1um").holds(f64::NAN));
        for (written, word) in [
            ("mean(s.v) = 1", "no limit"),
            ("mean(s.v) > 1 N", "a velocity"),
        ] {
            let error = Limit::parse(&model, written).unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
    }

    #[test]
    fn shares_have_wilsons_interval() {
        // Newcombe, Statist. Med. 17 (1998) 857, table I, method 3: 81 of 263 and 0 of 20.
        let close = |[a, b]: [f64; 2], c: f64, d: f64| (a - c).abs() < 5e-5 && (b - d).abs() < 5e-5;
        assert!(close(share_range(81, 263), 0.2553, 0.3662));
        assert!(close(share_range(0, 20), 0.0, 0.1611));
    }
}
