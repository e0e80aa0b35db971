//! From equations of motion to programs.
//!
//! ```text
//! Equations ──program──▶ Program ──tape──▶ TapeModel      what the command runs
//!         │                     ├──rust──▶ Rust tokens    what the macro gives
//!         │                     ├──listing──▶ text        the stages, for people and tests
//!         │                     └──dot──▶ a graph         for pictures
//!         └──report──▶ text, LaTeX, Markdown              for readers
//! ```
//!
//! The [`Program`] sorts every value by its binding time ([`Stage`]): constants are
//! computed here, what depends on params alone once in `prepare`, the rest in each evaluation,
//! configuration first. Everything that back ends have in common (sharing, sines from geometry,
//! derivatives, stages) is done before they start, so that they only write down. What pays in compiled
//! code alone is in the functions of [`Compiled`].

mod assemble;
mod curves;
mod cut;
mod directions;
mod dot;
mod jacobian;
mod late;
mod listing;
mod lower;
mod names;
mod program;
pub mod report;
mod rust;
mod schedule;
mod symbolic;
mod tape;
mod tape_listing;
mod values;

pub use assemble::{program, unit};
pub use dot::dot;
pub use listing::listing;
pub use program::{
    Check, Compiled, Configuration, Curve, Event, Function, Message, Name, Program, Set, Solve,
    Symbols,
};
pub use rust::{Texts, module_name, rust, rust_source, skeleton};
pub use tape::tape;
pub use tape_listing::tape_listing;
pub use values::{Node, Stage, Value, Values};
