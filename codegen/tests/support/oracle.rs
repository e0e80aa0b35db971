//! The oracle: equations evaluated by the symbolic graph itself, definition by definition.

use flexure_model_dsl::equations::{Definition, Equations};
use flexure_model_dsl::symbolic::{ConditionSum, Evaluator, Expr};
use flexure_runtime::newton;

/// An evaluator of `equations` at a parameter set, with its Newton blocks solved by differences of
/// the oracle's own residuals.
pub struct Oracle<'e> {
    equations: &'e Equations,
    evaluator: Evaluator<'e>,
}

impl<'e> Oracle<'e> {
    /// An oracle for that parameter set.
    pub fn new(equations: &'e Equations, params: &[f64]) -> Self {
        let mut evaluator = Evaluator::new(&equations.graph);
        for (param, value) in equations.params.iter().zip(params) {
            evaluator.set(param.symbol, *value);
        }
        for definition in &equations.definitions {
            match definition {
                Definition::Value { symbol, value, .. } => evaluator.define(*symbol, *value),
                Definition::Solve(solve) => {
                    for (symbol, value) in &solve.definitions {
                        evaluator.define(*symbol, *value);
                    }
                    let mut at: Vec<f64> =
                        solve.guesses.iter().map(|g| evaluator.value(*g)).collect();
                    let scales: Vec<f64> =
                        solve.scales.iter().map(|s| evaluator.value(*s)).collect();
                    let mut residuals_at = |at: &[f64]| -> Vec<f64> {
                        for (unknown, value) in solve.unknowns.iter().zip(at) {
                            evaluator.set(*unknown, *value);
                        }
                        solve
                            .residuals
                            .iter()
                            .map(|r| evaluator.value(*r))
                            .collect()
                    };
                    newton::solve(&mut at, &scales, &mut |at, residuals, jacobian| {
                        residuals.copy_from_slice(&residuals_at(at));
                        let count = at.len();
                        for column in 0..count {
                            let step = 1e-7 * at[column].abs().max(1e-3);
                            let mut moved = at.to_vec();
                            moved[column] = at[column] + step;
                            let ahead = residuals_at(&moved);
                            moved[column] = at[column] - step;
                            let behind = residuals_at(&moved);
                            for row in 0..count {
                                jacobian[row * count + column] =
                                    (ahead[row] - behind[row]) / (2.0 * step);
                            }
                        }
                    })
                    .expect("the oracle's Newton block has a solution");
                    residuals_at(&at);
                }
            }
        }
        Self {
            equations,
            evaluator,
        }
    }

    /// Puts the oracle at a time, a state and inputs.
    pub fn place(&mut self, t: f64, x: &[f64], d: &[f64], u: &[f64]) {
        self.evaluator.set(self.equations.time, t);
        for (state, value) in self.equations.states.iter().zip(x) {
            self.evaluator.set(state.symbol, *value);
        }
        for (discrete, value) in self.equations.discretes.iter().zip(d) {
            self.evaluator.set(discrete.symbol, *value);
        }
        for (input, value) in self.equations.inputs.iter().zip(u) {
            self.evaluator.set(input.symbol, *value);
        }
    }

    /// The value of an expression.
    pub fn value(&mut self, expr: Expr) -> f64 {
        self.evaluator.value(expr)
    }

    /// The value of an expression with its condition sum.
    pub fn condition(&mut self, expr: Expr) -> ConditionSum {
        self.evaluator.condition(expr)
    }
}
