//! When measures are taken: over cycles of a drive, or over a span of time.

use flexure_model_dsl::equations::Definition;
use flexure_model_dsl::symbolic::{Evaluator, Expr};
use flexure_model_dsl::units::Dimension;
use flexure_runtime::diagnostic::Diagnostic;

use crate::{Design, Model, quantity};

/// The part of a run that measures are of.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    extent: Extent,
}

#[derive(Clone, Debug, PartialEq)]
enum Extent {
    Cycles {
        warmup: f64,
        count: usize,
        frequency: Frequency,
    },
    Span {
        from: f64,
        until: f64,
    },
}

#[derive(Clone, Debug, PartialEq)]
enum Frequency {
    Param(usize),
    Expression(Expr),
    Given(f64),
}

/// A window with the params of one design.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    /// Its start in s.
    pub from: f64,
    /// Its end in s, which is that of the run.
    pub until: f64,
    /// Number of cycles in it; 0 if it is not one of cycles.
    pub cycles: usize,
}

impl Window {
    /// `count` cycles of the model's drive after `warmup` cycles, not necessarily a whole number.
    ///
    /// # Errors
    ///
    /// If no drive of the model repeats, or drives repeat at different frequencies.
    pub fn cycles(model: &Model, warmup: f64, count: usize) -> Result<Self, Diagnostic> {
        let periodic = &model.equations().periodic;
        let Some(first) = periodic.first() else {
            return Err(
                Diagnostic::error("the model has no drive that repeats, so no cycles").hint(
                    "give a span of time (`--until 20ms`), or a frequency (`--frequency 1kHz`)",
                ),
            );
        };
        if let Some(other) = periodic.iter().find(|d| d.frequency != first.frequency) {
            return Err(Diagnostic::error(format!(
                "the drives `{}` and `{}` repeat at frequencies of their own",
                first.name, other.name
            ))
            .hint(format!("choose one: `--frequency {}`", first.name)));
        }
        Ok(Self::of(warmup, count, frequency(model, first.frequency)))
    }

    /// The same of the frequency of a drive or a param, by its name, or of a written one.
    ///
    /// # Errors
    ///
    /// If it is none of these.
    pub fn cycles_of(
        model: &Model,
        warmup: f64,
        count: usize,
        written: &str,
    ) -> Result<Self, Diagnostic> {
        let equations = model.equations();
        let drive = equations.periodic.iter().find(|d| d.name == written);
        let frequency = match drive {
            Some(drive) => frequency(model, drive.frequency),
            None if written.starts_with(|c: char| c.is_ascii_digit() || c == '.') => {
                let value = quantity("--frequency", written, Dimension::FREQUENCY)?;
                if value <= 0.0 {
                    return Err(Diagnostic::error("a frequency above zero is wanted"));
                }
                Frequency::Given(value)
            }
            None => {
                let index = model.position(written)?;
                let dimension = equations.params[index].dimension;
                if !dimension.same_units(Dimension::RATE) {
                    return Err(Diagnostic::error(format!(
                        "`{written}` is {}, not a frequency",
                        dimension.described()
                    )));
                }
                Frequency::Param(index)
            }
        };
        Ok(Self::of(warmup, count, frequency))
    }

    /// From a time to the end of the run, both in s.
    pub fn span(from: f64, until: f64) -> Self {
        Self {
            extent: Extent::Span { from, until },
        }
    }

    fn of(warmup: f64, count: usize, frequency: Frequency) -> Self {
        Self {
            extent: Extent::Cycles {
                warmup,
                count,
                frequency,
            },
        }
    }

    /// Whether it is one of cycles, which measures within a cycle need.
    pub fn has_cycles(&self) -> bool {
        matches!(self.extent, Extent::Cycles { .. })
    }

    pub(super) fn of_design(&self, design: &Design) -> Result<Span, Diagnostic> {
        match &self.extent {
            &Extent::Span { from, until } => Ok(Span {
                from,
                until,
                cycles: 0,
            }),
            Extent::Cycles {
                warmup,
                count,
                frequency,
            } => {
                let frequency = match frequency {
                    Frequency::Given(value) => *value,
                    Frequency::Param(index) => design.values()[*index],
                    Frequency::Expression(expr) => value(design, *expr),
                };
                if !(frequency > 0.0 && frequency.is_finite()) {
                    return Err(Diagnostic::error(format!(
                        "the frequency of the drive is {frequency} Hz: there are no cycles"
                    )));
                }
                Ok(Span {
                    from: warmup / frequency,
                    until: (warmup + *count as f64) / frequency,
                    cycles: *count,
                })
            }
        }
    }
}

fn frequency(model: &Model, expr: Expr) -> Frequency {
    let equations = model.equations();
    let symbol = equations.graph.as_symbol(expr);
    let params = &equations.params;
    let param = symbol.and_then(|symbol| params.iter().position(|p| p.symbol == symbol));
    param.map_or(Frequency::Expression(expr), Frequency::Param)
}

/// Value of an expression of params; not a number if it needs equations to be solved.
fn value(design: &Design, expr: Expr) -> f64 {
    let equations = design.model().equations();
    let mut evaluator = Evaluator::new(&equations.graph);
    for (param, value) in equations.params.iter().zip(design.values()) {
        evaluator.set(param.symbol, *value);
    }
    for definition in &equations.definitions {
        if let Definition::Value { symbol, value, .. } = definition {
            evaluator.define(*symbol, *value);
        }
    }
    evaluator.value(expr)
}

impl Span {
    /// `count` + 1 times, evenly spaced, both ends included.
    pub(super) fn times(&self, count: usize) -> Vec<f64> {
        let length = self.until - self.from;
        let inner = (0..count).map(|k| self.from + length * (k as f64 / count as f64));
        inner.chain([self.until]).collect()
    }
}
