//! The graph: nodes, symbols, tables, numbers, and the arithmetic that everybody uses.
//!
//! A sum is a rational constant and terms with rational coefficients; a product is a rational
//! coefficient and factors with rational exponents. Terms and factors are kept in the order in
//! which their expressions were made, which is deterministic and reads like the derivation.

use std::collections::HashMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

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
    pub(super) nodes: Vec<Node>,
    index: HashMap<Node, Expr>,
    symbols: Vec<SymbolName>,
    tables: Vec<Vec<f64>>,
}

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

    pub(super) fn intern(&mut self, node: Node) -> Expr {
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
}
