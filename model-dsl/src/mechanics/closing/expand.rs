//! Writing definitions out: an expression in terms of other symbols than those it was made of.

use std::collections::{HashMap, HashSet};

use crate::symbolic::{Expr, Symbol};

use super::super::Derivation;

impl Derivation<'_> {
    /// `expr` with symbols replaced as `map` says, also inside the definitions of the symbols that
    /// it uses; definitions that lead to nothing replaced stay symbols.
    pub(in super::super) fn expand_with(
        &mut self,
        expr: Expr,
        map: &mut HashMap<Symbol, Expr>,
    ) -> Expr {
        // A symbol may be mapped to itself, so what leads to one is known by its symbols alone.
        let mut touched: HashSet<Symbol> = map.keys().copied().collect();
        let mut stack: Vec<(Symbol, bool)> = self
            .g
            .symbols_in(&[expr])
            .into_iter()
            .rev()
            .map(|s| (s, false))
            .collect();
        while let Some((symbol, ready)) = stack.pop() {
            if map.contains_key(&symbol) {
                continue;
            }
            let Some(&value) = self.values.get(&symbol) else {
                continue;
            };
            if ready {
                let inner = self.g.symbols_in(&[value]);
                let result = if inner.iter().any(|s| touched.contains(s)) {
                    touched.insert(symbol);
                    self.g.substitute(value, map)
                } else {
                    self.g.of(symbol)
                };
                map.insert(symbol, result);
            } else {
                stack.push((symbol, true));
                let inner = self.g.symbols_in(&[value]);
                stack.extend(inner.into_iter().map(|s| (s, false)));
            }
        }
        self.g.substitute(expr, map)
    }

    /// `expr` with every quantity that has a value of params written out.
    pub(super) fn in_params(&mut self, expr: Expr) -> Expr {
        let mut expr = expr;
        loop {
            let map: HashMap<Symbol, Expr> = self
                .g
                .symbols_in(&[expr])
                .into_iter()
                .filter_map(|symbol| Some((symbol, *self.values.get(&symbol)?)))
                .collect();
            if map.is_empty() {
                return expr;
            }
            expr = self.g.substitute(expr, &map);
        }
    }

    /// Running values to assembled ones, for all variables known so far.
    pub(in super::super) fn assembled_map(&self) -> HashMap<Symbol, Expr> {
        self.variables
            .iter()
            .flatten()
            .map(|v| (v.symbol, v.assembled))
            .collect()
    }
}
