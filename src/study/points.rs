//! Design points: the product of axes and files, each point drawn several times where params have
//! a spread. Points are computed as they are asked for, so that a million of them take no memory.

use flexure_runtime::diagnostic::Diagnostic;

use super::target::unit;
use super::{Axis, Draws, PointsFile, Target};
use crate::{Design, Model};

/// Design points of a model, counted from 0: the first axis changes slowest, draws fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    model: String,
    factors: Vec<Factor>,
    draws: Option<Draws>,
}

/// What is combined with all others: values of some targets.
#[derive(Clone, Debug, PartialEq)]
struct Factor {
    targets: Vec<Target>,
    values: Vec<f64>,
}

impl Factor {
    fn len(&self) -> usize {
        self.values.len() / self.targets.len()
    }
}

impl Points {
    /// One point: the base values.
    pub fn new(model: &Model) -> Self {
        Self {
            model: model.name().to_owned(),
            factors: Vec::new(),
            draws: None,
        }
    }

    /// Each of these points with each value of an axis.
    ///
    /// # Errors
    ///
    /// If a param of it is varied already, or the points are too many to count.
    pub fn axis(self, axis: Axis) -> Result<Self, Diagnostic> {
        self.factor(Factor {
            targets: vec![axis.target],
            values: axis.values,
        })
    }

    /// Each of these points with each point of a file.
    ///
    /// # Errors
    ///
    /// As [`Self::axis`].
    pub fn file(self, file: PointsFile) -> Result<Self, Diagnostic> {
        self.factor(Factor {
            targets: file.targets,
            values: file.values,
        })
    }

    /// Each of these points as many times as there are draws, with params that deviate.
    ///
    /// # Errors
    ///
    /// As [`Self::axis`], and if a param has two spreads.
    pub fn draws(mut self, draws: Draws) -> Result<Self, Diagnostic> {
        let mut seen = Vec::new();
        for spread in &draws.spreads {
            for param in spread.target.params() {
                if seen.contains(param) {
                    let name = spread.target.name();
                    return Err(Diagnostic::error(format!("`{name}` has two spreads")));
                }
                seen.push(*param);
            }
        }
        self.draws = Some(draws);
        self.counted()
    }

    fn factor(mut self, factor: Factor) -> Result<Self, Diagnostic> {
        let known = self.factors.iter().flat_map(|factor| &factor.targets);
        let known: Vec<&Target> = known.collect();
        for (index, target) in factor.targets.iter().enumerate() {
            let others = known.iter().copied().chain(&factor.targets[..index]);
            for other in others {
                if other.params().iter().any(|p| target.params().contains(p)) {
                    return Err(
                        Diagnostic::error(format!("`{}` is varied twice", target.name()))
                            .hint("give all its values in one place"),
                    );
                }
            }
        }
        self.factors.push(factor);
        self.counted()
    }

    fn counted(self) -> Result<Self, Diagnostic> {
        let count = self.draws.as_ref().map_or(1, |draws| draws.count);
        let mut counts = self.factors.iter().map(Factor::len);
        match counts.try_fold(count, |all, count| all.checked_mul(count)) {
            Some(0) => Err(Diagnostic::error("there are no design points")),
            Some(_) => Ok(self),
            None => Err(Diagnostic::error(
                "there are more design points than can be counted",
            )),
        }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.grid_len() * self.draws_each()
    }

    /// Whether there are none; there is always one.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of points before draws.
    fn grid_len(&self) -> usize {
        self.factors.iter().map(Factor::len).product()
    }

    /// Draws of each point; 1 without spreads. Those of one point follow each other.
    pub fn draws_each(&self) -> usize {
        self.draws.as_ref().map_or(1, |draws| draws.count)
    }

    /// Names of what is varied without spreads, in the order of the columns that come first.
    pub fn varied(&self) -> Vec<&str> {
        let factors = self.factors.iter().flat_map(|factor| &factor.targets);
        factors.map(Target::name).collect()
    }

    /// Headings of the columns of a point; a param that is varied and has a spread has two.
    pub fn columns(&self, model: &Model) -> Vec<String> {
        let mut columns: Vec<String> = self.varied().into_iter().map(str::to_owned).collect();
        let spreads = self.draws.iter().flat_map(|draws| &draws.spreads);
        for param in spreads.flat_map(|spread| spread.target.params()) {
            let name = &model.equations().params[*param].name;
            let drawn = columns.contains(name);
            columns.push(if drawn {
                format!("{name} (drawn)")
            } else {
                name.clone()
            });
        }
        columns
    }

    /// SI units of the columns of a point.
    pub fn units(&self, model: &Model) -> Vec<String> {
        let factors = self.factors.iter().flat_map(|factor| &factor.targets);
        let varied = factors.map(Target::unit);
        let spreads = self.draws.iter().flat_map(|draws| &draws.spreads);
        let params = spreads.flat_map(|spread| spread.target.params());
        let drawn = params.map(|param| unit(model.equations().params[*param].dimension));
        varied.chain(drawn).collect()
    }

    /// Sets a design, which has the base values, to point `index`; gives its columns.
    pub fn set(&self, index: usize, design: &mut Design) -> Vec<f64> {
        let values = design.values_mut();
        let mut point = Vec::new();
        let mut left = index / self.draws_each();
        let mut size = self.grid_len();
        for factor in &self.factors {
            size /= factor.len();
            let row = left / size;
            left %= size;
            let width = factor.targets.len();
            let row = &factor.values[row * width..(row + 1) * width];
            for (target, &value) in factor.targets.iter().zip(row) {
                target.set(values, value);
                point.push(value);
            }
        }
        if let Some(draws) = &self.draws {
            draws.set(index % draws.count, values, &mut point);
        }
        point
    }
}
