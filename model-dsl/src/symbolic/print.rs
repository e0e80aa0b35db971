//! How an expression is written down: plain text or LaTeX, as a textbook would have it.
//!
//! ```text
//! node ──▶ factor by factor, term by term ──▶ Written (text, how tightly it holds together)
//! ```
//!
//! Products are written side by side: numbers, symbols, powers, sums in parentheses, functions.
//! Sums keep the order in which their terms were made, but do not start with a minus if they need
//! not. Printing unfolds a graph into a tree, which may be very much larger, so it stops with an
//! ellipsis at a limit of characters and of nesting.

mod function;
mod number;
mod product;

use num_traits::{One, Signed, Zero};

use super::{Expr, Function, Graph, Node, Rational};
use number::{Fraction, Written as WrittenNumber};

/// How to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Plain text, for a terminal.
    Text,
    /// LaTeX mathematics, without dollar signs.
    Latex,
}

/// A term of a sum as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// Whether a minus stands before it.
    pub negative: bool,
    /// The term without its sign.
    pub text: String,
}

/// Characters after which printing stops.
const LIMIT: usize = 20_000;

/// Nesting at which printing stops.
const DEPTH: usize = 100;

impl Graph {
    /// The expression in plain text.
    pub fn text(&self, expr: Expr) -> String {
        self.written(expr, Style::Text)
    }

    /// The expression in LaTeX, for mathematics mode.
    pub fn latex(&self, expr: Expr) -> String {
        self.written(expr, Style::Latex)
    }

    /// The expression in a style.
    pub fn written(&self, expr: Expr, style: Style) -> String {
        Printer::new(self, style).expr(expr).text
    }

    /// The terms of the sum that the expression is, in the order in which they are written; one
    /// term if it is no sum. A caller breaks lines between them.
    pub fn terms(&self, expr: Expr, style: Style) -> Vec<Term> {
        Printer::new(self, style).terms(expr)
    }
}

/// How tightly a piece of text holds together: what has to be put in parentheses where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    /// `if … then … else …`
    Choice,
    /// A sum, or anything that starts with a minus.
    Sum,
    /// A product or a quotient.
    Product,
    /// A power or something raised or dashed: not to be raised again.
    Power,
    /// A symbol, a plain number, or something in brackets.
    Atom,
}

/// A piece of text.
#[derive(Clone, Debug)]
struct Written {
    text: String,
    level: Level,
}

impl Written {
    fn new(text: impl Into<String>, level: Level) -> Self {
        Self {
            text: text.into(),
            level,
        }
    }
}

struct Printer<'g> {
    graph: &'g Graph,
    style: Style,
    left: usize,
    depth: usize,
}

impl<'g> Printer<'g> {
    fn new(graph: &'g Graph, style: Style) -> Self {
        Self {
            graph,
            style,
            left: LIMIT,
            depth: 0,
        }
    }

    fn is_latex(&self) -> bool {
        self.style == Style::Latex
    }

    fn ellipsis(&self) -> Written {
        Written::new(if self.is_latex() { r"\ldots" } else { "…" }, Level::Atom)
    }

    /// Counts characters of a leaf, and what usually stands around it.
    fn count(&mut self, text: &str) {
        let around = if self.is_latex() { 8 } else { 1 };
        self.left = self.left.saturating_sub(text.len() + around);
    }

    fn expr(&mut self, expr: Expr) -> Written {
        if self.left == 0 || self.depth == DEPTH {
            self.count("…");
            return self.ellipsis();
        }
        self.depth += 1;
        self.left = self.left.saturating_sub(1);
        let written = match self.graph.node(expr) {
            Node::Number(value) => {
                let Fraction { negative, written } = number::write(value, self.style);
                self.count(&written.text);
                let WrittenNumber { text, level } = written;
                if negative {
                    Written::new(format!("-{text}"), Level::Sum)
                } else {
                    Written::new(text, level)
                }
            }
            Node::Pi => {
                self.count("π");
                Written::new(if self.is_latex() { r"\pi" } else { "π" }, Level::Atom)
            }
            Node::Symbol(_) => self.symbol(expr),
            Node::Sum { .. } => {
                let terms = self.terms(expr);
                join(&terms)
            }
            Node::Product {
                coefficient,
                factors,
            } => {
                let (negative, written) = self.product(coefficient, factors);
                self.signed(negative, written)
            }
            Node::Function(function, arguments) => self.function(*function, arguments),
        };
        self.depth -= 1;
        written
    }

    fn symbol(&mut self, expr: Expr) -> Written {
        let Some(symbol) = self.graph.as_symbol(expr) else {
            return self.ellipsis();
        };
        let text = if self.is_latex() {
            self.graph.symbol_latex(symbol)
        } else {
            self.graph.symbol_text(symbol)
        };
        self.count(text);
        let raised = if self.is_latex() {
            text.contains('^') || text.contains('\'')
        } else {
            text.ends_with(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹'′".contains(c))
        };
        let level = if self.graph.symbol_is_sum(symbol) {
            Level::Sum
        } else if raised {
            Level::Power
        } else {
            Level::Atom
        };
        Written::new(text, level)
    }

    fn signed(&self, negative: bool, written: Written) -> Written {
        if !negative {
            return written;
        }
        let text = self.at_least(Level::Product, written);
        Written::new(format!("-{text}"), Level::Sum)
    }

    /// The text, in parentheses if it holds together less than `level`.
    fn at_least(&self, level: Level, written: Written) -> String {
        if written.level >= level {
            written.text
        } else {
            self.parentheses(&written.text)
        }
    }

    fn parentheses(&self, text: &str) -> String {
        if self.is_latex() {
            format!(r"\left({text}\right)")
        } else {
            format!("({text})")
        }
    }

    // ── Sums ───────────────────────────────────────────────────────────────────────────────────

    fn terms(&mut self, expr: Expr) -> Vec<Term> {
        self.signed_terms(expr, false)
    }

    /// The terms of a sum with all signs changed.
    fn opposite_terms(&mut self, expr: Expr) -> Vec<Term> {
        self.signed_terms(expr, true)
    }

    /// The terms of a sum, the first positive one in front. Whether a term needs parentheses
    /// depends on its sign, so signs are changed before texts are made of the terms.
    fn signed_terms(&mut self, expr: Expr, opposite: bool) -> Vec<Term> {
        let mut parts = self.parts(expr);
        if let [(negative, _)] = parts[..]
            && negative == opposite
            && let Some((_, alone)) = parts.pop()
        {
            return vec![Term {
                negative: false,
                text: alone.text,
            }];
        }
        let mut terms: Vec<Term> = parts
            .into_iter()
            .map(|(negative, written)| self.term(negative != opposite, written))
            .collect();
        lead_with_positive(&mut terms);
        terms
    }

    /// The parts of a sum, each with whether a minus sign stands before it.
    fn parts(&mut self, expr: Expr) -> Vec<(bool, Written)> {
        let Node::Sum { constant, terms } = self.graph.node(expr) else {
            return match self.graph.node(expr) {
                Node::Product {
                    coefficient,
                    factors,
                } => vec![self.product(coefficient, factors)],
                Node::Number(_)
                | Node::Pi
                | Node::Symbol(_)
                | Node::Function(..)
                | Node::Sum { .. } => vec![(false, self.expr(expr))],
            };
        };
        let mut written = Vec::with_capacity(terms.len().min(LIMIT));
        for (term, coefficient) in self.order_of_terms(terms) {
            if self.left == 0 {
                break;
            }
            written.extend(self.parts_of(*term, coefficient));
        }
        if self.left == 0 {
            written.push((false, self.ellipsis()));
        } else if !constant.is_zero() {
            let Fraction {
                negative,
                written: number,
            } = number::write(constant, self.style);
            self.count(&number.text);
            written.push((negative, Written::new(number.text, number.level)));
        }
        written
    }

    /// In the order of their making, but in a sum of mere symbols those that vary stand first:
    /// `φ2 - φ1 + β2`.
    fn order_of_terms<'t>(&self, terms: &'t [(Expr, Rational)]) -> Vec<&'t (Expr, Rational)> {
        let mut order: Vec<_> = terms.iter().collect();
        let graph = self.graph;
        if order
            .iter()
            .all(|(term, _)| graph.as_symbol(*term).is_some())
        {
            order.sort_by_key(|(term, _)| {
                graph
                    .as_symbol(*term)
                    .is_none_or(|symbol| !graph.symbol_varies(symbol))
            });
        }
        order
    }

    fn parts_of(&mut self, term: Expr, coefficient: &Rational) -> Vec<(bool, Written)> {
        if coefficient.abs().is_one()
            && let Node::Function(
                function @ (Function::CosDifference | Function::SinDifference),
                arguments,
            ) = self.graph.node(term)
        {
            let mut pair = self.difference(*function, arguments);
            if coefficient.is_negative() {
                pair.reverse();
            }
            let [first, second] = pair.map(|text| Written::new(text, Level::Product));
            return vec![(false, first), (true, second)];
        }
        let part = match self.graph.node(term) {
            Node::Product {
                coefficient: inner,
                factors,
            } => {
                let product = inner * coefficient;
                self.product(&product, factors)
            }
            Node::Number(_)
            | Node::Pi
            | Node::Symbol(_)
            | Node::Sum { .. }
            | Node::Function(..) => self.product(coefficient, &[(term, Rational::one())]),
        };
        vec![part]
    }

    fn term(&self, negative: bool, written: Written) -> Term {
        let lowest = if negative { Level::Product } else { Level::Sum };
        Term {
            negative,
            text: self.at_least(lowest, written),
        }
    }
}

/// Moves the first positive term to the front, if there is one.
fn lead_with_positive(terms: &mut [Term]) {
    if let Some(positive) = terms.iter().position(|term| !term.negative) {
        terms[..=positive].rotate_right(1);
    }
}

/// A sum of terms on one line.
fn join(terms: &[Term]) -> Written {
    let mut text = String::new();
    for (index, term) in terms.iter().enumerate() {
        text.push_str(match (index, term.negative) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        });
        text.push_str(&term.text);
    }
    Written::new(text, Level::Sum)
}

#[cfg(test)]
#[path = "print/tests.rs"]
mod tests;
