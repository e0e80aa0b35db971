//! Plain evaluation of the graph: slow, obvious, and the reference for every other evaluator.

use std::collections::HashMap;

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Expr, Graph, Node, Rational, Symbol};

/// Values of expressions, given values or definitions of symbols.
///
/// A symbol has a value ([`Evaluator::set`]) or a definition ([`Evaluator::define`]), which is
/// followed; a symbol with neither is not a number.
pub struct Evaluator<'g> {
    graph: &'g Graph,
    given: HashMap<Symbol, f64>,
    definitions: HashMap<Symbol, Expr>,
    values: HashMap<Expr, f64>,
}

/// The value of an expression and the sum S = Σ |∂out/∂v|·|v| over all intermediate values v,
/// by which rounding errors of any evaluation order are bounded (times the unit roundoff).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConditionSum {
    /// The value itself.
    pub value: f64,
    /// The sum S.
    pub sum: f64,
}

impl<'g> Evaluator<'g> {
    /// An evaluator that knows no symbol yet.
    pub fn new(graph: &'g Graph) -> Self {
        Self {
            graph,
            given: HashMap::new(),
            definitions: HashMap::new(),
            values: HashMap::new(),
        }
    }

    /// Gives a symbol a value. Values computed before are forgotten.
    pub fn set(&mut self, symbol: Symbol, value: f64) {
        self.given.insert(symbol, value);
        self.values.clear();
    }

    /// Gives a symbol a definition, used where it has no value.
    pub fn define(&mut self, symbol: Symbol, definition: Expr) {
        self.definitions.insert(symbol, definition);
        self.values.clear();
    }

    /// The value of `expr`.
    pub fn value(&mut self, expr: Expr) -> f64 {
        let mut stack = vec![expr];
        while let Some(&top) = stack.last() {
            if self.values.contains_key(&top) {
                stack.pop();
                continue;
            }
            let mut ready = true;
            self.dependencies(top, |operand| {
                if !self.values.contains_key(&operand) {
                    stack.push(operand);
                    ready = false;
                }
            });
            if ready {
                let value = self.compute(top);
                self.values.insert(top, value);
                stack.pop();
            }
        }
        self.values[&expr]
    }

    /// The value of `expr` with its condition sum, by a reverse pass over everything it is made of.
    pub fn condition(&mut self, expr: Expr) -> ConditionSum {
        let value = self.value(expr);
        let order = self.order(expr);
        let mut adjoint: HashMap<Expr, f64> = HashMap::from([(expr, 1.0)]);
        let mut sum = 0.0;
        for node in order.into_iter().rev() {
            let weight = adjoint.get(&node).copied().unwrap_or(0.0);
            if weight == 0.0 {
                continue;
            }
            sum += (weight * self.values[&node]).abs();
            for (operand, partial) in self.partials(node) {
                // Also each addend and factor is a value that an evaluator may round.
                *adjoint.entry(operand).or_insert(0.0) += weight * partial;
            }
        }
        ConditionSum { value, sum }
    }

    fn dependencies(&self, expr: Expr, mut visit: impl FnMut(Expr)) {
        if let Some(symbol) = self.graph.as_symbol(expr) {
            if !self.given.contains_key(&symbol)
                && let Some(&definition) = self.definitions.get(&symbol)
            {
                visit(definition);
            }
        } else {
            self.graph.operands(expr, visit);
        }
    }

    /// Everything below `expr`, operands and definitions first.
    fn order(&self, expr: Expr) -> Vec<Expr> {
        let mut order = Vec::new();
        let mut state: HashMap<Expr, bool> = HashMap::new();
        let mut stack = vec![(expr, false)];
        while let Some((top, expanded)) = stack.pop() {
            if expanded {
                if state.insert(top, true) != Some(true) {
                    order.push(top);
                }
                continue;
            }
            if state.contains_key(&top) {
                continue;
            }
            state.insert(top, false);
            stack.push((top, true));
            self.dependencies(top, |operand| stack.push((operand, false)));
        }
        order
    }

    fn compute(&self, expr: Expr) -> f64 {
        match self.graph.node(expr) {
            Node::Number(value) => to_f64(value),
            Node::Pi => std::f64::consts::PI,
            Node::Symbol(symbol) => match (self.given.get(symbol), self.definitions.get(symbol)) {
                (Some(value), _) => *value,
                (None, Some(definition)) => self.values[definition],
                (None, None) => f64::NAN,
            },
            Node::Sum { constant, terms } => {
                terms.iter().fold(to_f64(constant), |sum, (term, k)| {
                    sum + to_f64(k) * self.values[term]
                })
            }
            Node::Product {
                coefficient,
                factors,
            } => factors.iter().fold(to_f64(coefficient), |product, (f, k)| {
                product * power(self.values[f], k)
            }),
            Node::Function(function, arguments) => {
                let x: Vec<f64> = arguments.iter().map(|a| self.values[a]).collect();
                function.value(&x, self.graph.tables())
            }
        }
    }

    /// Partial derivatives of one node with respect to its operands, at the current values.
    fn partials(&self, expr: Expr) -> Vec<(Expr, f64)> {
        match self.graph.node(expr) {
            Node::Number(_) | Node::Pi => Vec::new(),
            Node::Symbol(symbol) => match (self.given.get(symbol), self.definitions.get(symbol)) {
                (None, Some(definition)) => vec![(*definition, 1.0)],
                _ => Vec::new(),
            },
            Node::Sum { terms, .. } => terms.iter().map(|(t, k)| (*t, to_f64(k))).collect(),
            Node::Product {
                coefficient,
                factors,
            } => (0..factors.len())
                .map(|i| {
                    let (base, exponent) = &factors[i];
                    let mut partial = to_f64(coefficient) * to_f64(exponent);
                    partial *= power(self.values[base], &(exponent - Rational::one()));
                    for (j, (factor, k)) in factors.iter().enumerate() {
                        if j != i {
                            partial *= power(self.values[factor], k);
                        }
                    }
                    (*base, partial)
                })
                .collect(),
            Node::Function(function, arguments) => {
                // Numerically, by the function's own rule on a scratch graph of plain numbers.
                let x: Vec<f64> = arguments.iter().map(|a| self.values[a]).collect();
                let mut scratch = Graph::new();
                let symbols: Vec<Symbol> = (0..x.len())
                    .map(|i| scratch.symbol(format!("x{i}"), ""))
                    .collect();
                let operands: Vec<Expr> = symbols.iter().map(|&s| scratch.of(s)).collect();
                let partials: Vec<Option<Expr>> = (0..x.len())
                    .map(|i| function.partial(&mut scratch, &operands, i))
                    .collect();
                let mut evaluator = Evaluator::new(&scratch);
                for (symbol, value) in symbols.iter().zip(&x) {
                    evaluator.set(*symbol, *value);
                }
                arguments
                    .iter()
                    .zip(partials)
                    .map(|(a, partial)| (*a, partial.map_or(0.0, |p| evaluator.value(p))))
                    .collect()
            }
        }
    }
}

/// The nearest f64.
pub(crate) fn to_f64(value: &Rational) -> f64 {
    value.to_f64().unwrap_or_else(|| {
        if value.is_negative() {
            f64::MIN
        } else {
            f64::MAX
        }
    })
}

/// `base^exponent` for an exact exponent: whole powers by multiplication, halves by a root.
fn power(base: f64, exponent: &Rational) -> f64 {
    if exponent.is_zero() {
        1.0
    } else if exponent.is_one() {
        base
    } else if exponent.is_integer() {
        match exponent.to_i32() {
            Some(n) => base.powi(n),
            None => base.powf(to_f64(exponent)),
        }
    } else if *exponent.denom() == 2.into() {
        match exponent.numer().to_i32() {
            Some(n) => base.sqrt().powi(n),
            None => base.powf(to_f64(exponent)),
        }
    } else {
        base.powf(to_f64(exponent))
    }
}
