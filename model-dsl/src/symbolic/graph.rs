//! The graph: nodes, their canonical form, and the constructors that keep it.
//!
//! A sum is a rational constant and terms with rational coefficients; a product is a rational
//! coefficient and factors with rational exponents. Terms and factors are kept in the order in
//! which their expressions were made, which is deterministic and reads like the derivation.

use std::collections::HashMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};

use super::{Function, Rational};

/// An expression: an index into its [`Graph`]. Equal expressions have equal indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(u32);

impl Expr {
    /// Position of the node in its graph; operands have smaller positions than what they make up.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A named quantity: an index into the symbols of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(u32);

impl Symbol {
    /// Position among the graph's symbols.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What an expression is. Built only by the constructors of [`Graph`], which keep it canonical.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// The circle constant.
    Pi,
    /// A named quantity.
    Symbol(Symbol),
    /// `constant + Σ coefficient·term`: at least two parts, terms distinct, coefficients not zero.
    Sum {
        /// Its constant part.
        constant: Rational,
        /// Terms with coefficients.
        terms: Vec<(Expr, Rational)>,
    },
    /// `coefficient · Π factor^exponent`: coefficient not zero, factors distinct, exponents not
    /// zero, and not merely one factor to the power one.
    Product {
        /// Its numeric factor.
        coefficient: Rational,
        /// Factors with exponents.
        factors: Vec<(Expr, Rational)>,
    },
    /// A function of as many arguments as it takes.
    Function(Function, Vec<Expr>),
}

#[derive(Clone, Debug)]
struct SymbolName {
    text: String,
    latex: String,
    is_sum: bool,
    varies: bool,
}

/// An arena of expressions with sharing.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    index: HashMap<Node, Expr>,
    symbols: Vec<SymbolName>,
    tables: Vec<Vec<f64>>,
}

/// Constants are folded only while they stay this small, so that no input can make them explode.
const FOLD_LIMIT_BITS: u64 = 4096;

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of distinct expressions made so far.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether nothing was made yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// What `expr` is.
    pub fn node(&self, expr: Expr) -> &Node {
        &self.nodes[expr.index()]
    }

    fn intern(&mut self, node: Node) -> Expr {
        if let Some(&expr) = self.index.get(&node) {
            return expr;
        }
        let expr = Expr(u32::try_from(self.nodes.len()).expect("fewer than 2^32 expressions"));
        self.nodes.push(node.clone());
        self.index.insert(node, expr);
        expr
    }

    // ── Symbols ────────────────────────────────────────────────────────────────────────────────

    /// A new symbol; `text` and `latex` are how it prints. Two symbols may print alike.
    pub fn symbol(&mut self, text: impl Into<String>, latex: impl Into<String>) -> Symbol {
        self.new_symbol(text.into(), latex.into(), false)
    }

    /// A new symbol whose name is itself written as a sum, such as `φ2 - φ2⁰`: it is put in
    /// parentheses where a sum would be.
    pub fn symbol_written_as_sum(
        &mut self,
        text: impl Into<String>,
        latex: impl Into<String>,
    ) -> Symbol {
        self.new_symbol(text.into(), latex.into(), true)
    }

    fn new_symbol(&mut self, text: String, latex: String, is_sum: bool) -> Symbol {
        let symbol = Symbol(u32::try_from(self.symbols.len()).expect("fewer than 2^32 symbols"));
        self.symbols.push(SymbolName {
            text,
            latex,
            is_sum,
            varies: false,
        });
        symbol
    }

    /// Number of symbols.
    pub fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    /// The names of all symbols in plain text, in order of their making.
    pub fn symbol_texts(&self) -> impl Iterator<Item = &str> {
        self.symbols.iter().map(|name| name.text.as_str())
    }

    /// The symbol's name in plain text.
    pub fn symbol_text(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.index()].text
    }

    /// The symbol's name in LaTeX.
    pub fn symbol_latex(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.index()].latex
    }

    /// Whether the symbol's name is written as a sum.
    pub fn symbol_is_sum(&self, symbol: Symbol) -> bool {
        self.symbols[symbol.index()].is_sum
    }

    /// Whether the symbol was marked as varying.
    pub fn symbol_varies(&self, symbol: Symbol) -> bool {
        self.symbols[symbol.index()].varies
    }

    /// Marks a symbol as one that varies while others stay as they are: it prints behind them in
    /// products (`C1 ω2²`) and before them in sums (`φ2 - φ1 + β2`).
    pub fn mark_varying(&mut self, symbol: Symbol) {
        self.symbols[symbol.index()].varies = true;
    }

    /// Changes how a symbol prints.
    pub fn rename(&mut self, symbol: Symbol, text: impl Into<String>, latex: impl Into<String>) {
        let name = &mut self.symbols[symbol.index()];
        name.text = text.into();
        name.latex = latex.into();
    }

    /// The symbol as an expression.
    pub fn of(&mut self, symbol: Symbol) -> Expr {
        self.intern(Node::Symbol(symbol))
    }

    /// The symbol that `expr` is, if it is one.
    pub fn as_symbol(&self, expr: Expr) -> Option<Symbol> {
        match self.node(expr) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    // ── Tables ─────────────────────────────────────────────────────────────────────────────────

    /// Adds a table of numbers for [`Function::Lookup`]; it must not be empty.
    pub fn table(&mut self, entries: Vec<f64>) -> Function {
        assert!(!entries.is_empty(), "a table has at least one entry");
        self.tables.push(entries);
        Function::Lookup(u32::try_from(self.tables.len() - 1).expect("fewer than 2^32 tables"))
    }

    /// All tables.
    pub fn tables(&self) -> &[Vec<f64>] {
        &self.tables
    }

    // ── Numbers ────────────────────────────────────────────────────────────────────────────────

    /// An exact number.
    pub fn number(&mut self, value: Rational) -> Expr {
        self.intern(Node::Number(value))
    }

    /// A whole number.
    pub fn integer(&mut self, value: i64) -> Expr {
        self.number(BigRational::from_integer(BigInt::from(value)))
    }

    /// `numerator / denominator`; the denominator must not be zero.
    pub fn ratio(&mut self, numerator: i64, denominator: i64) -> Expr {
        self.number(BigRational::new(numerator.into(), denominator.into()))
    }

    /// A finite number as its shortest decimal says it: 0.1 is a tenth. `None` if it is not finite.
    pub fn decimal(&mut self, value: f64) -> Option<Expr> {
        if !value.is_finite() {
            return None;
        }
        let written = format!("{value:e}");
        let (digits, exponent) = written.split_once('e')?;
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let mantissa: BigInt = format!("{whole}{fraction}").parse().ok()?;
        let exponent = exponent.parse::<i32>().ok()? - i32::try_from(fraction.len()).ok()?;
        let power = Pow::pow(BigInt::from(10), exponent.unsigned_abs());
        Some(self.number(if exponent < 0 {
            BigRational::new(mantissa, power)
        } else {
            BigRational::from_integer(mantissa * power)
        }))
    }

    /// 0
    pub fn zero(&mut self) -> Expr {
        self.integer(0)
    }

    /// 1
    pub fn one(&mut self) -> Expr {
        self.integer(1)
    }

    /// π
    pub fn pi(&mut self) -> Expr {
        self.intern(Node::Pi)
    }

    /// The number that `expr` is, if it is one.
    pub fn as_number(&self, expr: Expr) -> Option<&Rational> {
        match self.node(expr) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Whether `expr` is the number 0.
    pub fn is_zero(&self, expr: Expr) -> bool {
        self.as_number(expr).is_some_and(Zero::is_zero)
    }

    /// Whether `expr` is the number 1.
    pub fn is_one(&self, expr: Expr) -> bool {
        self.as_number(expr).is_some_and(One::is_one)
    }

    // ── Sums and products ──────────────────────────────────────────────────────────────────────

    /// a + b
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.sum(&[a, b])
    }

    /// a - b
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        let minus = -Rational::one();
        self.linear(Rational::zero(), &[(a, Rational::one()), (b, minus)])
    }

    /// -a
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.scale(a, -Rational::one())
    }

    /// a · b
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.product(&[a, b])
    }

    /// a / b
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.powers(
            Rational::one(),
            &[(a, Rational::one()), (b, -Rational::one())],
        )
    }

    /// The number `factor` times `a`.
    pub fn scale(&mut self, a: Expr, factor: Rational) -> Expr {
        self.powers(factor, &[(a, Rational::one())])
    }

    /// `a` to a whole power.
    pub fn powi(&mut self, a: Expr, exponent: i64) -> Expr {
        self.powers(
            Rational::one(),
            &[(a, BigRational::from_integer(exponent.into()))],
        )
    }

    /// `a` to a rational power.
    pub fn powr(&mut self, a: Expr, exponent: Rational) -> Expr {
        self.powers(Rational::one(), &[(a, exponent)])
    }

    /// Square root.
    pub fn sqrt(&mut self, a: Expr) -> Expr {
        self.powers(
            Rational::one(),
            &[(a, BigRational::new(1.into(), 2.into()))],
        )
    }

    /// Sum of all `terms`.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let terms: Vec<_> = terms.iter().map(|&term| (term, Rational::one())).collect();
        self.linear(Rational::zero(), &terms)
    }

    /// Product of all `factors`.
    pub fn product(&mut self, factors: &[Expr]) -> Expr {
        let factors: Vec<_> = factors
            .iter()
            .map(|&factor| (factor, Rational::one()))
            .collect();
        self.powers(Rational::one(), &factors)
    }

    /// `constant + Σ coefficient·term`, in canonical form.
    pub fn linear(&mut self, constant: Rational, terms: &[(Expr, Rational)]) -> Expr {
        let mut total = constant;
        let mut collected: Vec<(Expr, Rational)> = Vec::with_capacity(terms.len());
        let mut position: HashMap<Expr, usize> = HashMap::new();
        for (term, coefficient) in terms {
            self.collect_term(
                *term,
                coefficient,
                &mut total,
                &mut collected,
                &mut position,
            );
        }
        collected.retain(|(_, coefficient)| !coefficient.is_zero());
        collected.sort_by_key(|(term, _)| *term);
        if collected.is_empty() {
            return self.number(total);
        }
        if total.is_zero() && collected.len() == 1 {
            let (term, coefficient) = collected.pop().expect("one term");
            return self.scale(term, coefficient);
        }
        self.intern(Node::Sum {
            constant: total,
            terms: collected,
        })
    }

    fn collect_term(
        &mut self,
        term: Expr,
        coefficient: &Rational,
        total: &mut Rational,
        collected: &mut Vec<(Expr, Rational)>,
        position: &mut HashMap<Expr, usize>,
    ) {
        match self.node(term).clone() {
            Node::Number(value) => *total += value * coefficient,
            // Sums open up only when nothing has to be multiplied out.
            Node::Sum { constant, terms } if coefficient.abs().is_one() => {
                *total += constant * coefficient;
                for (inner, inner_coefficient) in terms {
                    push_term(inner, inner_coefficient * coefficient, collected, position);
                }
            }
            Node::Product {
                coefficient: inner,
                factors,
            } if !inner.is_one() => {
                let bare = self.powers(Rational::one(), &factors);
                let scaled = inner * coefficient;
                // The bare product may itself be a sum (2·(a+b) with 2·½ = 1).
                if scaled.abs().is_one() && matches!(self.node(bare), Node::Sum { .. }) {
                    self.collect_term(bare, &scaled, total, collected, position);
                } else {
                    push_term(bare, scaled, collected, position);
                }
            }
            Node::Pi
            | Node::Symbol(_)
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Function(..) => {
                push_term(term, coefficient.clone(), collected, position);
            }
        }
    }

    /// `coefficient · Π factor^exponent`, in canonical form.
    pub fn powers(&mut self, coefficient: Rational, factors: &[(Expr, Rational)]) -> Expr {
        let mut total = coefficient;
        let mut collected: Vec<(Expr, Rational)> = Vec::with_capacity(factors.len());
        for (factor, exponent) in factors {
            self.collect_factor(*factor, exponent, &mut total, &mut collected);
        }
        // Exponents may have met: x^½ · x^½ made of a number or a product opens up again.
        let again: Vec<(Expr, Rational)> = collected
            .iter()
            .filter(|(base, exponent)| {
                exponent.is_integer()
                    && match self.node(*base) {
                        Node::Number(value) => foldable(value, exponent),
                        Node::Product { .. } => true,
                        Node::Pi | Node::Symbol(_) | Node::Sum { .. } | Node::Function(..) => false,
                    }
                    && !exponent.is_zero()
            })
            .cloned()
            .collect();
        if !again.is_empty() {
            collected.retain(|entry| !again.contains(entry));
            for (factor, exponent) in &again {
                self.collect_factor(*factor, exponent, &mut total, &mut collected);
            }
        }
        collected.retain(|(_, exponent)| !exponent.is_zero());
        if total.is_zero() {
            return self.zero();
        }
        collected.sort_by_key(|(factor, _)| *factor);
        if collected.is_empty() {
            return self.number(total);
        }
        if total.is_one() && collected.len() == 1 && collected[0].1.is_one() {
            return collected[0].0;
        }
        // -(a + b) is a sum like any other: -a - b.
        if total.abs().is_one()
            && collected.len() == 1
            && collected[0].1.is_one()
            && matches!(self.node(collected[0].0), Node::Sum { .. })
        {
            return self.linear(Rational::zero(), &[(collected[0].0, total)]);
        }
        self.intern(Node::Product {
            coefficient: total,
            factors: collected,
        })
    }

    fn collect_factor(
        &self,
        factor: Expr,
        exponent: &Rational,
        total: &mut Rational,
        collected: &mut Vec<(Expr, Rational)>,
    ) {
        match self.node(factor) {
            Node::Number(value) => {
                if let Some(power) = fold_power(value, exponent) {
                    if bits(total) + bits(&power) <= FOLD_LIMIT_BITS {
                        *total *= power;
                        return;
                    }
                }
                push_factor(factor, exponent.clone(), collected);
            }
            Node::Product {
                coefficient,
                factors,
            } if exponent.is_integer() => {
                if let Some(power) = fold_power(coefficient, exponent)
                    && bits(total) + bits(&power) <= FOLD_LIMIT_BITS
                {
                    *total *= power;
                    for (inner, inner_exponent) in factors {
                        push_factor(*inner, inner_exponent * exponent, collected);
                    }
                } else {
                    push_factor(factor, exponent.clone(), collected);
                }
            }
            Node::Pi
            | Node::Symbol(_)
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Function(..) => {
                push_factor(factor, exponent.clone(), collected);
            }
        }
    }

    // ── Functions ──────────────────────────────────────────────────────────────────────────────

    /// sin a
    pub fn sin(&mut self, a: Expr) -> Expr {
        self.function(Function::Sin, &[a])
    }

    /// cos a
    pub fn cos(&mut self, a: Expr) -> Expr {
        self.function(Function::Cos, &[a])
    }

    /// atan2(y, x): the direction of (x, y)
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        self.function(Function::Atan2, &[y, x])
    }

    /// A function applied to its arguments, folded where the result is exact.
    ///
    /// # Panics
    /// If the number of arguments is not the function's arity.
    pub fn function(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        use Function::*;
        assert_eq!(
            arguments.len(),
            function.arity(),
            "{} takes other arguments",
            function.name()
        );
        let a = arguments[0];
        match function {
            Sin | Cos | Tan => {
                if let Some(quarter) = self.quarter_turns(a) {
                    let (sin, cos) = [(0, 1), (1, 0), (0, -1), (-1, 0)][quarter];
                    match function {
                        Sin => return self.integer(sin),
                        Cos => return self.integer(cos),
                        _ if cos != 0 => return self.zero(),
                        _ => {}
                    }
                }
                if self.is_written_negative(a) {
                    let positive = self.neg(a);
                    let value = self.intern(Node::Function(function, vec![positive]));
                    return if function == Cos {
                        value
                    } else {
                        self.neg(value)
                    };
                }
            }
            Asin | Atan | Tanh | Sign | Floor if self.is_zero(a) => return self.zero(),
            Exp if self.is_zero(a) => return self.one(),
            Log if self.is_one(a) => return self.zero(),
            Abs => {
                if let Some(value) = self.as_number(a) {
                    let value = value.abs();
                    return self.number(value);
                }
                if self.is_written_negative(a) {
                    let positive = self.neg(a);
                    return self.intern(Node::Function(Abs, vec![positive]));
                }
            }
            CosDifference | SinDifference if a == arguments[1] => return self.zero(),
            Min | Max if a == arguments[1] => return a,
            Min | Max => {
                if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(arguments[1])) {
                    let first = if function == Min { x <= y } else { x >= y };
                    return if first { a } else { arguments[1] };
                }
            }
            Atan2 if self.is_zero(a) => {
                if self
                    .as_number(arguments[1])
                    .is_some_and(Signed::is_positive)
                {
                    return self.zero();
                }
            }
            Power => {
                if let Some(exponent) = self.as_number(arguments[1]).cloned() {
                    return self.powr(a, exponent);
                }
            }
            IfPositive => {
                if arguments[1] == arguments[2] {
                    return arguments[1];
                }
                if let Some(condition) = self.as_number(a) {
                    return if condition.is_positive() {
                        arguments[1]
                    } else {
                        arguments[2]
                    };
                }
            }
            _ => {}
        }
        self.intern(Node::Function(function, arguments.to_vec()))
    }

    /// Whether the expression is rather the negative of a positive one: more of its terms are
    /// subtracted than added. Of `a` and `-a` at most one is.
    pub fn is_written_negative(&self, a: Expr) -> bool {
        match self.node(a) {
            Node::Number(value) => value.is_negative(),
            Node::Product { coefficient, .. } => coefficient.is_negative(),
            Node::Sum { terms, .. } => {
                let negative = terms.iter().filter(|(_, k)| k.is_negative()).count();
                let positive = terms.len() - negative;
                negative > positive || (negative == positive && terms[0].1.is_negative())
            }
            Node::Pi | Node::Symbol(_) | Node::Function(..) => false,
        }
    }

    /// `a` in quarter turns modulo a full turn, if `a` is a whole number of them.
    fn quarter_turns(&self, a: Expr) -> Option<usize> {
        let multiple = match self.node(a) {
            Node::Number(value) if value.is_zero() => return Some(0),
            Node::Pi => Rational::one(),
            Node::Product {
                coefficient,
                factors,
            } if factors.len() == 1
                && factors[0].1.is_one()
                && matches!(self.node(factors[0].0), Node::Pi) =>
            {
                coefficient.clone()
            }
            _ => return None,
        };
        let quarters = multiple * BigRational::from_integer(2.into());
        if !quarters.is_integer() {
            return None;
        }
        let four = BigInt::from(4);
        let turns = ((quarters.to_integer() % &four) + &four) % &four;
        turns.to_usize()
    }

    // ── Walking ────────────────────────────────────────────────────────────────────────────────

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
        let mut seen = vec![false; self.nodes.len()];
        let mut stack: Vec<Expr> = roots.to_vec();
        while let Some(expr) = stack.pop() {
            if !std::mem::replace(&mut seen[expr.index()], true) {
                self.operands(expr, |operand| stack.push(operand));
            }
        }
        (0..self.nodes.len() as u32)
            .map(Expr)
            .filter(|expr| seen[expr.index()])
            .collect()
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

fn push_term(
    term: Expr,
    coefficient: Rational,
    collected: &mut Vec<(Expr, Rational)>,
    position: &mut HashMap<Expr, usize>,
) {
    match position.get(&term) {
        Some(&at) => collected[at].1 += coefficient,
        None => {
            position.insert(term, collected.len());
            collected.push((term, coefficient));
        }
    }
}

fn push_factor(factor: Expr, exponent: Rational, collected: &mut Vec<(Expr, Rational)>) {
    match collected.iter_mut().find(|(known, _)| *known == factor) {
        Some((_, known)) => *known += exponent,
        None => collected.push((factor, exponent)),
    }
}

fn bits(value: &Rational) -> u64 {
    value.numer().bits() + value.denom().bits()
}

fn foldable(value: &Rational, exponent: &Rational) -> bool {
    fold_power(value, exponent).is_some()
}

/// `value^exponent` where that is an exact number of reasonable size.
fn fold_power(value: &Rational, exponent: &Rational) -> Option<Rational> {
    if exponent.is_one() || value.is_one() {
        return Some(value.clone());
    }
    let numerator = exponent.numer().to_i32()?;
    let denominator = exponent.denom().to_u32()?;
    if value.is_zero() {
        return (numerator > 0).then(Rational::zero);
    }
    let root = if denominator == 1 {
        value.clone()
    } else {
        if value.is_negative() || denominator > 8 || bits(value) > 256 {
            return None;
        }
        let root = BigRational::new(
            value.numer().nth_root(denominator),
            value.denom().nth_root(denominator),
        );
        if Pow::pow(&root, denominator) != *value {
            return None;
        }
        root
    };
    if bits(&root).saturating_mul(u64::from(numerator.unsigned_abs())) > FOLD_LIMIT_BITS {
        return None;
    }
    Some(Pow::pow(&root, numerator))
}
