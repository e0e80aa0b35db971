//! From text to a syntax tree with places.
//!
//! ```text
//! text ──split──▶ items (comments blanked, line ends sorted out) ──parse (pest)──▶ tree
//! ```
//!
//! `split` cuts the file where an item starts a line, so that a mistake in one item
//! leaves the others readable; it also refuses what is nested too deeply before the parser, which
//! recurses, sees it. The grammar then reads one item at a time.

mod grammar;
mod parse;
mod problem;
mod reader;
mod row;
mod split;
pub mod tree;

pub use parse::parse;
pub use problem::Problem;
pub(crate) use problem::listed;
