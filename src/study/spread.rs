//! Params with a spread, as manufacture gives them: distributions and the draws from them.

use flexure_runtime::diagnostic::Diagnostic;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal, StandardUniform};

use super::Target;
use crate::{Model, quantity, split_assignment};

/// A param that deviates from its value at random.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// What deviates.
    pub target: Target,
    law: Law,
    size: Size,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Law {
    /// Normal, with the size as its standard deviation.
    Normal,
    /// Uniform, within the size to either side.
    Uniform,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Size {
    /// In SI.
    Absolute(f64),
    /// As a share of the value.
    Relative(f64),
}

/// How many designs are drawn, and by which seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Draws {
    /// What deviates.
    pub spreads: Vec<Spread>,
    /// Number of draws.
    pub count: usize,
    /// Seed. Draw `k` depends on it and on `k` alone, not on the number of draws.
    pub seed: u64,
}

impl Spread {
    /// Reads `l2=normal(10um)`, a standard deviation, or `e=uniform(±5%)`, bounds to either side. A
    /// share in % is one of the value; other sizes have the param's unit. The sign ± may be left out.
    ///
    /// # Errors
    ///
    /// If the model has no such param, or the rest is not of that form.
    pub fn parse(model: &Model, written: &str) -> Result<Self, Diagnostic> {
        let form =
            "write `l2=normal(10um)` for a standard deviation, or `e=uniform(5%)` for bounds";
        let (name, law) = split_assignment(written).map_err(|error| error.hint(form))?;
        let target = Target::named(model, name)?;
        let wrong = || Diagnostic::error(format!("`{law}` is no spread")).hint(form);
        let inner = law.strip_suffix(')').and_then(|law| law.split_once('('));
        let (law, size) = match inner {
            Some(("normal", size)) => (Law::Normal, size),
            Some(("uniform", size)) => (Law::Uniform, size),
            _ => return Err(wrong()),
        };
        let size = size.trim().trim_start_matches('±').trim();
        let size = match size.strip_suffix('%') {
            Some(share) => Size::Relative(0.01 * share.trim().parse::<f64>().map_err(|_| wrong())?),
            None => Size::Absolute(quantity(name, size, target.dimension())?),
        };
        let (Size::Absolute(value) | Size::Relative(value)) = size;
        if !(value >= 0.0 && value.is_finite()) {
            return Err(
                Diagnostic::error(format!("the spread of `{name}` is not above zero")).hint(form),
            );
        }
        Ok(Self { target, law, size })
    }
}

impl Draws {
    /// Lets all params deviate as in draw `index`; gives their values.
    pub(super) fn set(&self, index: usize, values: &mut [f64], point: &mut Vec<f64>) {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(index as u64);
        for spread in &self.spreads {
            let deviation: f64 = match spread.law {
                Law::Normal => StandardNormal.sample(&mut random),
                Law::Uniform => {
                    let share: f64 = StandardUniform.sample(&mut random);
                    2.0 * share - 1.0
                }
            };
            for &param in spread.target.params() {
                let size = match spread.size {
                    Size::Absolute(size) => size,
                    Size::Relative(share) => share * values[param],
                };
                values[param] += deviation * size;
                point.push(values[param]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        let text = "model m\nparam l = 2 m\nparam Fp = 1 N\n\
                    slide s along (1, 0) { mass = 1 kg }\nforce on s = (Fp * l / 1 m, 0 N)\n";
        Model::from_source("m.flex", text).unwrap()
    }

    #[test]
    fn draws_have_the_moments_that_were_asked_for() {
        let spreads = ["l=normal(10mm)", "Fp=uniform(±6%)"];
        let spreads = spreads.map(|written| Spread::parse(&model(), written).unwrap());
        let draws = Draws {
            spreads: spreads.to_vec(),
            count: 20_000,
            seed: 7,
        };
        let mut sums = [[0.0; 3]; 2];
        for k in 0..draws.count {
            let (mut values, mut point) = (vec![2.0, 1.0], Vec::new());
            draws.set(k, &mut values, &mut point);
            assert_eq!(values, point);
            let deviations = [(point[0] - 2.0) / 0.01, (point[1] - 1.0) / 0.06];
            assert!(deviations[1].abs() <= 1.0);
            for (sum, deviation) in sums.iter_mut().zip(deviations) {
                for (power, sum) in sum.iter_mut().enumerate() {
                    *sum += deviation.powi(power as i32 + 1) / draws.count as f64;
                }
            }
        }
        // Means within four standard errors; variances 1 and 1/3 likewise.
        let error = 1.0 / (draws.count as f64).sqrt();
        assert!(sums[0][0].abs() < 4.0 * error && sums[1][0].abs() < 4.0 * error);
        assert!((sums[0][1] - 1.0).abs() < 4.0 * 2f64.sqrt() * error);
        assert!((sums[1][1] - 1.0 / 3.0).abs() < 4.0 * 0.3 * error);
    }

    #[test]
    fn a_draw_depends_on_seed_and_number_alone() {
        let spread = Spread::parse(&model(), "l=normal(1%)").unwrap();
        let draw = |seed, count, index| {
            let draws = Draws {
                spreads: vec![spread.clone()],
                count,
                seed,
            };
            let mut values = vec![2.0, 1.0];
            draws.set(index, &mut values, &mut Vec::new());
            values[0]
        };
        assert_eq!(draw(1, 10, 3), draw(1, 1000, 3));
        assert_ne!(draw(1, 10, 3), draw(1, 10, 4));
        assert_ne!(draw(1, 10, 3), draw(2, 10, 3));
    }

    #[test]
    fn what_is_no_spread_is_refused() {
        for (written, word) in [
            ("l=normal", "no spread"),
            ("l=gamma(1m)", "no spread"),
            ("l=normal(1N)", "a length"),
            ("l=uniform(-5%)", "not above zero"),
            ("k=uniform(5%)", "no param `k`"),
        ] {
            let error = Spread::parse(&model(), written).unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
    }
}
