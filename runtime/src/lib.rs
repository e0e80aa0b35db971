//! What generated simulators and the `flexure` command run on.

#![deny(unsafe_code, unsafe_op_in_unsafe_fn)]

pub mod checks;
pub mod diagnostic;
pub mod dual;
pub mod failure;
pub mod generated;
pub mod lanes;
pub mod newton;
pub mod real;
pub mod simulate;
pub mod system;
pub mod table;
pub mod tape;

pub use simulate::{Run, ensemble, simulate};
