//! Walking through a graph: what an expression is made of, and rebuilding it with other parts.

use std::collections::{HashMap, HashSet};

use super::{Expr, Graph, Node, Symbol};

impl Graph {
    /// Calls `visit` for each direct operand of `expr`.
    pub fn operands(&self, expr: Expr, mut visit: impl FnMut(Expr)) {
        match self.node(expr) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => {}
            Node::Sum { terms, .. } => terms.iter().for_each(|(term, _)| visit(*term)),
            Node::Product { factors, .. } => factors.iter().for_each(|(factor, _)| visit(*factor)),
            Node::Function(_, arguments) => arguments.iter().copied().for_each(visit),
        }
    }

    /// Every expression reachable from `roots`, operands before what they make up.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        let mut seen = HashSet::new();
        let mut stack: Vec<Expr> = roots.to_vec();
        while let Some(expr) = stack.pop() {
            if seen.insert(expr) {
                self.operands(expr, |operand| stack.push(operand));
            }
        }
        let mut order: Vec<Expr> = seen.into_iter().collect();
        order.sort_unstable();
        order
    }

    /// The symbols in `expr`, in order of their making.
    pub fn symbols_in(&self, roots: &[Expr]) -> Vec<Symbol> {
        let mut symbols: Vec<Symbol> = self
            .reachable(roots)
            .into_iter()
            .filter_map(|expr| self.as_symbol(expr))
            .collect();
        symbols.sort();
        symbols
    }

    /// `expr` with symbols replaced by expressions.
    pub fn substitute(&mut self, expr: Expr, replacement: &HashMap<Symbol, Expr>) -> Expr {
        let mut map = |g: &mut Graph, node: &Node| match node {
            Node::Symbol(symbol) => Some(
                replacement
                    .get(symbol)
                    .copied()
                    .unwrap_or_else(|| g.of(*symbol)),
            ),
            _ => None,
        };
        self.rebuild(&[expr], &mut map)[0]
    }

    /// Rebuilds `roots` bottom-up: `map` may replace a node (whose operands are already rebuilt) by
    /// an expression, or return `None` to keep it.
    pub fn rebuild(
        &mut self,
        roots: &[Expr],
        map: &mut dyn FnMut(&mut Graph, &Node) -> Option<Expr>,
    ) -> Vec<Expr> {
        let mut done: HashMap<Expr, Expr> = HashMap::new();
        for expr in self.reachable(roots) {
            let node = match self.node(expr).clone() {
                Node::Sum { constant, terms } => Node::Sum {
                    constant,
                    terms: terms
                        .into_iter()
                        .map(|(term, k)| (done[&term], k))
                        .collect(),
                },
                Node::Product {
                    coefficient,
                    factors,
                } => Node::Product {
                    coefficient,
                    factors: factors
                        .into_iter()
                        .map(|(factor, k)| (done[&factor], k))
                        .collect(),
                },
                Node::Function(function, arguments) => {
                    Node::Function(function, arguments.into_iter().map(|a| done[&a]).collect())
                }
                leaf @ (Node::Number(_) | Node::Pi | Node::Symbol(_)) => leaf,
            };
            let new = match map(self, &node) {
                Some(new) => new,
                None => self.make(&node),
            };
            done.insert(expr, new);
        }
        roots.iter().map(|root| done[root]).collect()
    }

    fn make(&mut self, node: &Node) -> Expr {
        match node {
            Node::Number(value) => self.number(value.clone()),
            Node::Pi => self.pi(),
            Node::Symbol(symbol) => self.of(*symbol),
            Node::Sum { constant, terms } => self.linear(constant.clone(), terms),
            Node::Product {
                coefficient,
                factors,
            } => self.powers(coefficient.clone(), factors),
            Node::Function(function, arguments) => self.function(*function, arguments),
        }
    }
}
