//! Derivatives: one pass over the shared graph, given how the symbols themselves change.

use std::collections::HashMap;

use num_traits::One;

use super::{Expr, Function, Graph, Node, Rational, Symbol};

/// How symbols change: the derivative of each symbol that is not constant.
///
/// `{x: 1}` gives ∂/∂x. `{φ1: 1, φ2: ω2, φ3: ω3}` gives the total derivative along φ1 when φ2 and
/// φ3 depend on it. `{x: v, v: a, t: 1}` gives d/dt.
pub type Rates = HashMap<Symbol, Expr>;

impl Graph {
    /// The derivative of `expr` when symbols change as `rates` says; all others are constant.
    pub fn derivative(&mut self, expr: Expr, rates: &Rates) -> Expr {
        self.derivatives(&[expr], rates)[0]
    }

    /// The derivatives of several expressions; what they share is differentiated once.
    pub fn derivatives(&mut self, roots: &[Expr], rates: &Rates) -> Vec<Expr> {
        let mut memo: HashMap<Expr, Expr> = HashMap::new();
        let zero = self.zero();
        for expr in self.reachable(roots) {
            let value = match self.node(expr).clone() {
                Node::Number(_) | Node::Pi => zero,
                Node::Symbol(symbol) => rates.get(&symbol).copied().unwrap_or(zero),
                Node::Sum { terms, .. } => {
                    let terms: Vec<_> = terms.into_iter().map(|(t, k)| (memo[&t], k)).collect();
                    self.linear(Rational::from_integer(0.into()), &terms)
                }
                Node::Product {
                    coefficient,
                    factors,
                } => {
                    let mut terms = Vec::new();
                    for (index, (factor, exponent)) in factors.iter().enumerate() {
                        let inner = memo[factor];
                        if self.is_zero(inner) {
                            continue;
                        }
                        let mut rest = factors.clone();
                        rest[index].1 = exponent - Rational::one();
                        rest.push((inner, Rational::one()));
                        terms.push(self.powers(&coefficient * exponent, &rest));
                    }
                    self.sum(&terms)
                }
                // Each branch on its own, so that one without a finite rate cannot spoil the other.
                Node::Function(Function::IfPositive, arguments) => {
                    let [condition, first, second] = arguments[..] else {
                        unreachable!("three arguments")
                    };
                    let branches = [condition, memo[&first], memo[&second]];
                    self.function(Function::IfPositive, &branches)
                }
                Node::Function(function @ (Function::Min | Function::Max), arguments) => {
                    let [a, b] = arguments[..] else {
                        unreachable!("two arguments")
                    };
                    let first_is_meant = if function == Function::Max {
                        self.sub(a, b)
                    } else {
                        self.sub(b, a)
                    };
                    let branches = [first_is_meant, memo[&a], memo[&b]];
                    self.function(Function::IfPositive, &branches)
                }
                Node::Function(function, arguments) => {
                    let mut terms = Vec::new();
                    for (index, argument) in arguments.iter().enumerate() {
                        let inner = memo[argument];
                        if self.is_zero(inner) {
                            continue;
                        }
                        if let Some(partial) = function.partial(self, &arguments, index) {
                            terms.push(self.mul(partial, inner));
                        }
                    }
                    self.sum(&terms)
                }
            };
            memo.insert(expr, value);
        }
        roots.iter().map(|root| memo[root]).collect()
    }
}
