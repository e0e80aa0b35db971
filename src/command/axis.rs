//! Values of params of a family of curves: of one param as in a sweep, `Fp=1N,5N,10N`, and of several
//! that go together, `mu_s,mu_c=0.15,0.10;0.3,0.2`.

use flexure::model_dsl::units::Mark;
use flexure::picture::{number, with_unit};
use flexure::runtime::diagnostic::Diagnostic;
use flexure::{Design, Model, quantity, split_assignment, study};

/// Params and the values that they take, together.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Names of the params.
    pub names: Vec<String>,
    /// Their values in SI: one entry for each param.
    pub values: Vec<Vec<f64>>,
}

impl Axis {
    /// Reads what a person wrote.
    ///
    /// # Errors
    ///
    /// If it is not of that form, the model has no such param, a value has another unit, or a range
    /// is empty.
    pub fn parse(written: &str, model: &Model) -> Result<Self, Diagnostic> {
        let (names, values) = split_assignment(written)?;
        let names: Vec<String> = names
            .split(',')
            .map(|name| name.trim().to_owned())
            .collect();
        for name in &names {
            model.design().set(name, 0.0)?;
        }
        if let [name] = names.as_slice() {
            let axis = study::Axis::parse(model, written)?;
            let values = axis.values.into_iter().map(|value| vec![value]).collect();
            return Ok(Self {
                names: vec![name.clone()],
                values,
            });
        }
        let tuples = values.split(';');
        let values = tuples
            .map(|tuple| together(written, &names, tuple, model))
            .collect::<Result<_, Diagnostic>>()?;
        Ok(Self { names, values })
    }

    /// A design with the values at a position.
    ///
    /// # Errors
    ///
    /// If the model has no such param.
    pub fn apply(&self, index: usize, design: &mut Design) -> Result<(), Diagnostic> {
        for (name, &value) in self.names.iter().zip(&self.values[index]) {
            design.set(name, value)?;
        }
        Ok(())
    }

    /// The values at a position, for people: `Fp = 5 N`, `mu_s = 0.3, mu_c = 0.2`; neighbours that
    /// have the same value are `beta1 = beta2 = 0.1`.
    pub fn described(&self, index: usize, model: &Model) -> String {
        let shown = |(name, &value): (&String, &f64)| shown(name, value, model);
        let values: Vec<String> = self
            .names
            .iter()
            .zip(&self.values[index])
            .map(shown)
            .collect();
        let mut text = String::new();
        for (position, name) in self.names.iter().enumerate() {
            text.push_str(name);
            text.push_str(" = ");
            let next = values.get(position + 1);
            if next != Some(&values[position]) {
                text.push_str(&values[position]);
                text.push_str(if next.is_some() { ", " } else { "" });
            }
        }
        text
    }
}

/// A value of a param with its unit, for people: `5 N`.
fn shown(name: &str, value: f64, model: &Model) -> String {
    let params = model.params().iter().zip(&model.equations().params);
    let found = params.into_iter().find(|(param, _)| param.name == name);
    let Some((variable, param)) = found else {
        return number(value, 6);
    };
    match param.dimension.mark() {
        Mark::Frequency => with_unit(value, "Hz", 6),
        Mark::AngularRate => with_unit(value, "rad/s", 6),
        Mark::Plain => with_unit(value, &variable.unit, 6),
    }
}

fn value(name: &str, text: &str, model: &Model) -> Result<f64, Diagnostic> {
    let params = &model.equations().params;
    let param = params.iter().find(|param| param.name == name);
    let dimension = param.map(|param| param.dimension).unwrap_or_default();
    quantity(name, text.trim(), dimension)
}

/// Values of several params: one for each, or one for all.
fn together(
    written: &str,
    names: &[String],
    tuple: &str,
    model: &Model,
) -> Result<Vec<f64>, Diagnostic> {
    let texts: Vec<&str> = tuple.split(',').collect();
    if texts.len() != 1 && texts.len() != names.len() {
        return Err(Diagnostic::error(format!(
            "`{}` in `{written}` has {} values for {} params",
            tuple.trim(),
            texts.len(),
            names.len()
        ))
        .hint("write a value for each param, or one for all, and semicolons between the groups: `mu_s,mu_c=0.15,0.10;0.3,0.2`"));
    }
    let text = |index: usize| texts.get(index).unwrap_or(&texts[0]);
    let all = names.iter().enumerate();
    all.map(|(index, name)| value(name, text(index), model))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        let text = "model m\nparam f = 1 kHz, Fp = 20 N, mu_s = 0.3, mu_c = 0.2\n\
                    slide mass along (1, 0) { mass = 1 kg * (1 + mu_s * mu_c) }\n\
                    force on mass = (Fp * sin(2 * pi * f * t), 0 N)\n";
        Model::from_source("m.flex", text).unwrap()
    }

    fn values(written: &str) -> Vec<Vec<f64>> {
        Axis::parse(written, &model()).unwrap().values
    }

    #[test]
    fn lists_ranges_and_groups() {
        let range = values("f=100Hz..2kHz:100Hz");
        assert_eq!(
            (range.len(), range[0][0], range[19][0]),
            (20, 100.0, 2000.0)
        );
        assert_eq!(values("f=0.1..0.7:0.1").len(), 7);
        assert_eq!(values("f=3..1:-1"), [[3.0], [2.0], [1.0]]);
        assert_eq!(values("Fp=1N, 5 N,10"), [[1.0], [5.0], [10.0]]);
        assert_eq!(
            values("mu_s,mu_c=0.15,0.10; 0.3,0.2"),
            [[0.15, 0.10], [0.3, 0.2]]
        );
        assert_eq!(values("mu_s,mu_c=0.1;0.2"), [[0.1, 0.1], [0.2, 0.2]]);
    }

    #[test]
    fn values_are_described_for_people() {
        let described = |written: &str| {
            let model = model();
            Axis::parse(written, &model).unwrap().described(0, &model)
        };
        assert_eq!(described("f=1200Hz"), "f = 1.2 kHz");
        assert_eq!(described("mu_s,mu_c=0.15,0.10"), "mu_s = 0.15, mu_c = 0.1");
        assert_eq!(
            described("Fp,mu_s,mu_c=3,0.2,0.2"),
            "Fp = 3 N, mu_s = mu_c = 0.2"
        );
    }

    #[test]
    fn faults_are_said() {
        let cases = [
            ("f", "sets nothing"),
            ("g=1,2", "no param `g`"),
            ("f=100Hz..2kHz", "has no spacing"),
            ("f=2kHz..1kHz:100Hz", "is empty"),
            ("mu_s+mu_c=1,2", "no param `mu_s+mu_c`"),
            ("Fp=1N,2mm", "`Fp` is a force"),
            ("mu_s,mu_c=1,2,3", "has 3 values for 2 params"),
        ];
        for (written, expected) in cases {
            let error = Axis::parse(written, &model()).unwrap_err().to_string();
            assert!(error.contains(expected), "{written}: {error}");
        }
    }
}
