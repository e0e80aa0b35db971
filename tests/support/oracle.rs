//! Plain evaluation of the equations as derived: the reference for what the compiler says.
//!
//! It follows `Equations` literally with the graph's own evaluator: definitions by name, `Solve`
//! blocks by Newton's method, no staging, no tape. It is used where a test asks about the
//! derivation and wants no back end in between.

use std::collections::HashMap;

use flexure_model_dsl::equations::{Definition, Equations};
use flexure_model_dsl::symbolic::{Evaluator, Expr, Graph, Rates, Symbol};
use nalgebra::{DMatrix, DVector};

/// Equations ready for evaluation.
pub struct Oracle {
    /// The equations.
    pub equations: Equations,
    graph: Graph,
    /// For each definition that is solved for, ∂residual/∂unknown row by row.
    jacobians: Vec<Vec<Expr>>,
}

/// Equations with a parameter set.
pub struct Prepared<'o> {
    oracle: &'o Oracle,
    evaluator: Evaluator<'o>,
    /// State at the start.
    pub start: Vec<f64>,
    /// Discrete state, brought along by [`Prepared::accept`].
    pub discretes: Vec<f64>,
    first_discretes: Vec<f64>,
}

impl Oracle {
    /// For these equations.
    pub fn new(equations: Equations) -> Self {
        let mut graph = equations.graph.clone();
        let mut jacobians = Vec::new();
        for definition in &equations.definitions {
            let Definition::Solve(solve) = definition else {
                jacobians.push(Vec::new());
                continue;
            };
            let mut columns = Vec::new();
            for &unknown in &solve.unknowns {
                let mut rates: Rates = HashMap::from([(unknown, graph.one())]);
                for &(symbol, value) in &solve.definitions {
                    let rate = graph.derivative(value, &rates);
                    rates.insert(symbol, rate);
                }
                columns.push(graph.derivatives(&solve.residuals, &rates));
            }
            let count = solve.unknowns.len();
            let entries = (0..count * count).map(|k| columns[k % count][k / count]);
            jacobians.push(entries.collect());
        }
        Self {
            equations,
            graph,
            jacobians,
        }
    }

    /// Default values of the params.
    pub fn defaults(&self) -> Vec<f64> {
        let mut evaluator = Evaluator::new(&self.graph);
        let params = self.equations.params.iter();
        params.map(|p| evaluator.value(p.default)).collect()
    }

    /// With values for its params, or what a check says against them.
    pub fn prepare(&self, params: &[f64]) -> Result<Prepared<'_>, String> {
        let mut evaluator = Evaluator::new(&self.graph);
        for (param, value) in self.equations.params.iter().zip(params) {
            evaluator.set(param.symbol, *value);
        }
        for input in &self.equations.inputs {
            let start = evaluator.value(input.start);
            evaluator.set(input.symbol, start);
        }
        evaluator.set(self.equations.time, 0.0);
        for (definition, jacobian) in self.equations.definitions.iter().zip(&self.jacobians) {
            match definition {
                Definition::Value { symbol, value, .. } => evaluator.define(*symbol, *value),
                Definition::Solve(solve) => {
                    for &(symbol, value) in &solve.definitions {
                        evaluator.define(symbol, value);
                    }
                    let unknowns = newton(&mut evaluator, solve, jacobian)
                        .ok_or_else(|| format!("no solution: {}", solve.name))?;
                    for (symbol, value) in solve.unknowns.iter().zip(unknowns) {
                        evaluator.set(*symbol, value);
                    }
                }
            }
        }
        for check in &self.equations.checks {
            let margin = evaluator.value(check.margin);
            let well = margin > 0.0 || margin == 0.0 && check.zero_is_well;
            if !well {
                return Err(check.failure.message.clone());
            }
        }
        let mut prepared = Prepared {
            oracle: self,
            evaluator,
            start: Vec::new(),
            discretes: Vec::new(),
            first_discretes: Vec::new(),
        };
        for state in &self.equations.states {
            let value = prepared.evaluator.value(state.initial);
            prepared.start.push(value);
        }
        let start = prepared.start.clone();
        prepared.set_states(&start);
        for discrete in &self.equations.discretes {
            let value = prepared.evaluator.value(discrete.initial);
            prepared.discretes.push(value);
        }
        prepared.first_discretes = prepared.discretes.clone();
        prepared.set_discretes();
        Ok(prepared)
    }

    /// Position of a state by name.
    pub fn state(&self, name: &str) -> usize {
        let found = self.equations.states.iter().position(|s| s.name == name);
        found.unwrap_or_else(|| panic!("there is a state `{name}`"))
    }

    /// The symbol that prints as `text` among the definitions.
    pub fn defined(&self, text: &str) -> Option<Symbol> {
        self.equations.definitions.iter().find_map(|d| match d {
            Definition::Value { symbol, .. } => {
                (self.graph.symbol_text(*symbol) == text).then_some(*symbol)
            }
            Definition::Solve(_) => None,
        })
    }
}

impl Prepared<'_> {
    fn set_states(&mut self, states: &[f64]) {
        for (state, value) in self.oracle.equations.states.iter().zip(states) {
            self.evaluator.set(state.symbol, *value);
        }
    }

    fn set_discretes(&mut self) {
        let discretes = &self.oracle.equations.discretes;
        for (discrete, value) in discretes.iter().zip(&self.discretes) {
            self.evaluator.set(discrete.symbol, *value);
        }
    }

    /// Goes to a time and state, without accepting it.
    pub fn at(&mut self, time: f64, states: &[f64]) {
        self.evaluator.set(self.oracle.equations.time, time);
        self.set_states(states);
    }

    /// Accepts the present state: references of angles follow.
    pub fn accept(&mut self) {
        let mut next = self.discretes.clone();
        for (value, discrete) in next.iter_mut().zip(&self.oracle.equations.discretes) {
            if let Some(accepted) = discrete.accepted {
                *value = self.evaluator.value(accepted);
            }
        }
        self.discretes = next;
        self.set_discretes();
    }

    /// Goes from the start to a state in small steps, accepting each.
    pub fn follow(&mut self, time: f64, states: &[f64]) {
        let start = self.start.clone();
        self.discretes = self.first_discretes.clone();
        self.at(time, &start);
        self.set_discretes();
        let largest = start
            .iter()
            .zip(states)
            .zip(&self.oracle.equations.states)
            .filter(|(_, state)| state.unit == "rad")
            .map(|((a, b), _)| (a - b).abs())
            .fold(0.0, f64::max);
        let steps = (largest / 0.05).ceil().max(1.0) as usize;
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            let between: Vec<f64> = start
                .iter()
                .zip(states)
                .map(|(a, b)| {
                    if step == steps {
                        *b
                    } else {
                        a + part * (b - a)
                    }
                })
                .collect();
            self.at(time, &between);
            self.accept();
        }
    }

    /// Lets events that are due change the discrete state (contacts lift off or close), as a run
    /// would have done on the way; updates of continuous states are left aside.
    pub fn settle(&mut self) {
        for event in &self.oracle.equations.events {
            if event.stop.is_none() && self.evaluator.value(event.function) > 0.0 {
                for &(index, value) in &event.discrete_updates {
                    self.discretes[index] = self.evaluator.value(value);
                }
                self.set_discretes();
            }
        }
    }

    /// Rates of all states.
    pub fn rates(&mut self) -> Vec<f64> {
        let states = self.oracle.equations.states.iter();
        states.map(|s| self.evaluator.value(s.rate)).collect()
    }

    /// Value of any expression of the equations.
    pub fn value(&mut self, expr: Expr) -> f64 {
        self.evaluator.value(expr)
    }

    /// Value of a defined symbol by its printed name.
    pub fn named(&mut self, text: &str) -> f64 {
        let symbol = self.oracle.defined(text);
        let symbol = symbol.unwrap_or_else(|| panic!("there is a definition `{text}`"));
        let definition = self
            .oracle
            .equations
            .definitions
            .iter()
            .find_map(|d| match d {
                Definition::Value {
                    symbol: own, value, ..
                } if *own == symbol => Some(*value),
                _ => None,
            });
        self.evaluator.value(definition.expect("found above"))
    }

    /// Kinetic and potential energy.
    pub fn energy(&mut self) -> (f64, f64) {
        let energy = self.oracle.equations.energy;
        let kinetic = self.evaluator.value(energy.kinetic);
        (kinetic, self.evaluator.value(energy.potential))
    }
}

/// Newton's method with halved steps, until rounding stops it.
fn newton(
    evaluator: &mut Evaluator<'_>,
    solve: &flexure_model_dsl::equations::Solve,
    jacobian: &[Expr],
) -> Option<Vec<f64>> {
    let count = solve.unknowns.len();
    let scales: Vec<f64> = solve.scales.iter().map(|s| evaluator.value(*s)).collect();
    let mut x: Vec<f64> = solve.guesses.iter().map(|g| evaluator.value(*g)).collect();
    let residuals = |evaluator: &mut Evaluator<'_>, x: &[f64]| -> (Vec<f64>, f64) {
        for (symbol, value) in solve.unknowns.iter().zip(x) {
            evaluator.set(*symbol, *value);
        }
        let values: Vec<f64> = solve
            .residuals
            .iter()
            .zip(&scales)
            .map(|(r, scale)| evaluator.value(*r) / scale)
            .collect();
        let norm = values.iter().map(|r| r * r).sum::<f64>().sqrt();
        (values, norm)
    };
    let (mut present, mut norm) = residuals(evaluator, &x);
    for _ in 0..100 {
        let matrix = DMatrix::from_fn(count, count, |i, j| {
            evaluator.value(jacobian[i * count + j]) / scales[i]
        });
        let step = matrix.lu().solve(&DVector::from_vec(present.clone()))?;
        let mut part = 1.0;
        let mut improved = false;
        while part > 1e-6 {
            let trial: Vec<f64> = (0..count).map(|i| x[i] - part * step[i]).collect();
            let (values, size) = residuals(evaluator, &trial);
            if size < norm {
                (x, present, norm, improved) = (trial, values, size, true);
                break;
            }
            part *= 0.5;
        }
        if !improved {
            residuals(evaluator, &x);
            break;
        }
    }
    (norm < 1e-11).then_some(x)
}
