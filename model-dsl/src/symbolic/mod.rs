//! Symbolic expressions: a hash-consed graph with exact rational constants.
//!
//! ```text
//! constructors ──▶ Graph (shared nodes, canonical form) ──▶ derivative, substitution
//!                                                      ├──▶ evaluation (the oracle)
//!                                                      └──▶ text, LaTeX
//! ```
//!
//! An [`Expr`] is an index into its [`Graph`]; equal expressions have equal indices, so sharing is
//! by construction and comparison is free. Numbers stay exact ([`Rational`]) until somebody
//! evaluates or emits them. Nothing is ever expanded: a product of sums stays a product of sums,
//! which is what keeps derived equations as short as the person who reads them would write them.
//!
//! This module knows nothing of mechanics, units or Rust. A [`Symbol`] is a name; what it stands
//! for, and how it changes, is told from outside ([`Graph::derivative`] takes the symbols' own
//! derivatives, [`Evaluator`] their values or definitions).

mod canonical;
mod derivative;
mod evaluate;
mod function;
mod graph;
mod print;
mod walk;

pub use derivative::Rates;
pub use evaluate::{ConditionSum, Evaluator};
pub use function::Function;
pub use graph::{Expr, Graph, Node, Symbol};
pub use print::{Style, Term};

/// An exact rational number of any size.
pub type Rational = num_rational::BigRational;

#[cfg(test)]
mod tests;
