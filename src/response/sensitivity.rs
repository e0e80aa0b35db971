//! Sensitivity of an actuator's speed to its params, as in table 5 of Nguyen and Nguyen, Machines
//! 2025, 13, 787: S_p = (Δv̄_lin / v̄_lin) / (Δp / p), where v̄_lin is the mean speed in the linear
//! regime.
//!
//! With a param the linear regime itself changes, by whole points of the frequency grid. So there
//! are two answers: with v̄_lin of the changed design in its own window, as published, and in that of
//! the nominal design, which tells how the speed at given frequencies changes.

use flexure_model_dsl::units::{Dimension, parse_quantity};
use flexure_runtime::diagnostic::Diagnostic;
use num_traits::ToPrimitive;

use super::linear::{Definition, LinearRegime, linear_regime};
use crate::{Design, Model, quantity};

/// By how much params are changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// By this share of each one's value.
    Share(f64),
    /// By this much in SI.
    Absolute(f64),
}

/// Params that are changed together.
#[derive(Clone, Debug, PartialEq)]
pub struct Variation {
    /// Their names.
    pub params: Vec<String>,
    /// By how much each is changed.
    pub step: Step,
}

impl Variation {
    /// Reads what a person writes: names joined by `+` and, after a colon, the step, a share
    /// (`mu_s+mu_c:5%`) or a change in the params' unit (`beta1+beta2:5deg`). `usual` is the share
    /// where no step is written.
    ///
    /// # Errors
    ///
    /// If it is not of that form, the model has no such param, or the unit is another.
    pub fn parse(written: &str, usual: f64, model: &Model) -> Result<Self, Diagnostic> {
        let (names, step) = match written.split_once(':') {
            Some((names, step)) => (names, Some(step.trim())),
            None => (written, None),
        };
        let params: Vec<String> = names
            .split('+')
            .map(|name| name.trim().to_owned())
            .collect();
        let mut dimensions = Vec::new();
        for (index, name) in params.iter().enumerate() {
            if name.is_empty() {
                return Err(Diagnostic::error(format!("`{written}` names no param"))
                    .hint("write a param, several joined by `+`, with a step if it is not the usual one: `Fp`, `mu_s+mu_c:5%`, `beta1+beta2:5deg`"));
            }
            if params[..index].contains(name) {
                return Err(Diagnostic::error(format!(
                    "`{written}` names `{name}` twice"
                )));
            }
            let (_, dimension) = param(model, name)?;
            dimensions.push(dimension);
        }
        let step = match step {
            None => Step::Share(usual),
            Some(text) if text.ends_with('%') => Step::Share(share(text)?),
            Some(text) => {
                let mut value = 0.0;
                for (name, &dimension) in params.iter().zip(&dimensions) {
                    value = quantity(name, text, dimension)?;
                }
                Step::Absolute(value)
            }
        };
        if matches!(step, Step::Share(0.0) | Step::Absolute(0.0)) {
            return Err(Diagnostic::error(format!("`{written}` changes nothing"))
                .hint("give a step other than zero"));
        }
        Ok(Self { params, step })
    }

    /// What is changed, as it was written: `mu_s+mu_c`.
    pub fn name(&self) -> String {
        self.params.join("+")
    }

    /// The changed design.
    ///
    /// # Errors
    ///
    /// If a share of a param is asked for that is zero.
    pub fn apply(&self, design: &Design) -> Result<Design, Diagnostic> {
        let mut changed = design.clone();
        for name in &self.params {
            let (index, dimension) = param(design.model(), name)?;
            let value = design.values()[index];
            let new = match self.step {
                Step::Share(share) if value == 0.0 => {
                    let percent = 100.0 * share;
                    let step = match dimension.si_unit() {
                        _ if dimension.is_none() => "0.1".to_owned(),
                        unit => format!("1 {unit}"),
                    };
                    return Err(Diagnostic::error(format!(
                        "`{name}` is zero, and {percent} % of zero is no change"
                    ))
                    .hint(format!(
                        "give a step in its unit: `{}:{step}` (or deg, mm, … of that kind)",
                        self.name()
                    )));
                }
                Step::Share(share) => value * (1.0 + share),
                Step::Absolute(step) => value + step,
            };
            changed.set(name, new)?;
        }
        Ok(changed)
    }
}

/// Position and dimension of a param.
fn param(model: &Model, name: &str) -> Result<(usize, Dimension), Diagnostic> {
    // An unknown name is said as everywhere else.
    model.design().set(name, 0.0)?;
    let params = &model.equations().params;
    let index = params.iter().position(|param| param.name == name);
    let index = index.unwrap_or_default();
    Ok((index, params[index].dimension))
}

/// Reads a share: `10%`, `-5 %`.
///
/// # Errors
///
/// If it is no finite number with a percent sign.
pub fn share(text: &str) -> Result<f64, Diagnostic> {
    let error = || {
        Diagnostic::error(format!("`{text}` is no share"))
            .hint("write a number with a percent sign: `10%`")
    };
    let number = text.trim().strip_suffix('%').ok_or_else(error)?;
    match parse_quantity(number) {
        Ok((percent, None)) => percent.to_f64().map(|p| p / 100.0).ok_or_else(error),
        _ => Err(error()),
    }
}

/// What a change of params does to the linear regime.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Linear regime of the nominal design.
    pub nominal: LinearRegime,
    /// Linear regime of the changed design, if it has one.
    pub changed: Option<LinearRegime>,
    /// Mean speed of the changed design in the window of the nominal one, if no point failed there.
    pub speed_in_nominal_window: Option<f64>,
}

impl Effect {
    /// Compares the curves of two designs, each of frequencies and speeds; `None` if the nominal
    /// one has no linear regime.
    pub fn of(
        nominal: &[(f64, f64)],
        changed: &[(f64, f64)],
        definition: &Definition,
    ) -> Option<Self> {
        let regime = linear_regime(nominal, definition)?;
        Some(Self {
            nominal: regime,
            changed: linear_regime(changed, definition),
            speed_in_nominal_window: regime.mean_of(changed),
        })
    }

    /// Δv̄_lin / v̄_lin, each design in its own window.
    pub fn change(&self) -> Option<f64> {
        Some(self.relative(self.changed?.mean_speed))
    }

    /// Δv̄ / v̄, both designs in the window of the nominal one.
    pub fn change_in_nominal_window(&self) -> Option<f64> {
        Some(self.relative(self.speed_in_nominal_window?))
    }

    fn relative(&self, speed: f64) -> f64 {
        speed / self.nominal.mean_speed - 1.0
    }
}

/// S_p from a change of speed, as a share; `None` for a step that is no share of the params.
pub fn sensitivity(change: f64, step: Step) -> Option<f64> {
    match step {
        Step::Share(share) => Some(change / share),
        Step::Absolute(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::linear::DEFINITIONS;
    use super::*;

    const MODEL: &str = "\
model spring_mass
param k = 100 N/m, m = 2 kg, mu_s = 0.3, mu_c = 0.2, beta = 0 deg
slide mass along (cos(beta), sin(beta)) { mass = m }
spring s between ground and mass { stiffness = k * (mu_s + mu_c) }
";

    fn model() -> Model {
        Model::from_source("spring_mass.flex", MODEL).unwrap()
    }

    fn values(written: &str) -> Result<Vec<f64>, Diagnostic> {
        let model = model();
        let variation = Variation::parse(written, 0.1, &model)?;
        Ok(variation.apply(&model.design())?.values().to_vec())
    }

    #[track_caller]
    fn assert_values(written: &str, expected: [f64; 5]) {
        let values = values(written).unwrap();
        for (value, expected) in values.iter().zip(expected) {
            assert!(
                (value - expected).abs() < 1e-12 * expected.abs().max(1.0),
                "{values:?}"
            );
        }
    }

    #[test]
    fn params_change_alone_or_together() {
        assert_values("k", [110.0, 2.0, 0.3, 0.2, 0.0]);
        assert_values("mu_s + mu_c", [100.0, 2.0, 0.33, 0.22, 0.0]);
        assert_values("mu_s+mu_c: -5 %", [100.0, 2.0, 0.285, 0.19, 0.0]);
        assert_values("beta:5deg", [100.0, 2.0, 0.3, 0.2, 5f64.to_radians()]);
        assert_values("m:10g", [100.0, 2.01, 0.3, 0.2, 0.0]);
    }

    #[test]
    fn what_makes_no_sense_is_said() {
        let cases = [
            ("beta", "`beta` is zero, and 10 % of zero"),
            ("mu_k", "no param `mu_k`"),
            ("k+", "names no param"),
            ("k+k", "twice"),
            ("k:5mm", "`k` is a stiffness"),
            ("k+m:5", ""),
            ("k:x%", "no share"),
            ("k:0%", "changes nothing"),
        ];
        for (written, expected) in cases {
            match values(written) {
                Err(error) => assert!(error.to_string().contains(expected), "{error}"),
                Ok(values) => assert_eq!(written, "k+m:5", "{values:?}"),
            }
        }
        let error = values("beta").unwrap_err();
        assert!(error.hint.unwrap().contains("beta:"), "a step in its unit");
    }

    #[test]
    fn effects_are_those_of_known_curves() {
        let curve = |slope: f64, end: f64| -> Vec<(f64, f64)> {
            let frequencies = (1..=12).map(|k| 100.0 * f64::from(k));
            frequencies
                .map(|f| {
                    (
                        f,
                        if f <= end {
                            slope * f
                        } else {
                            slope * end / 9.0
                        },
                    )
                })
                .collect()
        };
        // Mean speeds on lines: slope times the mean frequency of the window.
        let nominal = curve(1e-5, 900.0);
        let effect = Effect::of(&nominal, &curve(1.1e-5, 900.0), &DEFINITIONS[2]).unwrap();
        assert_eq!(
            (effect.nominal.to, effect.changed.unwrap().to),
            (900.0, 900.0)
        );
        assert!((effect.change().unwrap() - 0.1).abs() < 1e-12);
        assert!((effect.change_in_nominal_window().unwrap() - 0.1).abs() < 1e-12);
        let wider = Effect::of(&nominal, &curve(1e-5, 1100.0), &DEFINITIONS[2]).unwrap();
        assert!((wider.change().unwrap() - 0.2).abs() < 1e-12);
        assert!(wider.change_in_nominal_window().unwrap().abs() < 1e-12);
        assert_eq!(sensitivity(0.2, Step::Share(0.1)), Some(2.0));
        assert_eq!(sensitivity(0.2, Step::Absolute(0.1)), None);
        let flat = curve(0.0, 900.0);
        assert_eq!(Effect::of(&flat, &nominal, &DEFINITIONS[2]), None);
        assert_eq!(
            Effect::of(&nominal, &flat, &DEFINITIONS[2])
                .unwrap()
                .change(),
            None
        );
    }
}
