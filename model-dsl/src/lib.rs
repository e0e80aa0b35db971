//! From the text of a model file to the equations of motion.
mod compile;
pub mod equations;
pub mod expand;
mod groups;
pub mod mechanics;
pub mod model;
pub mod notation;
pub mod parts;
pub mod resolve;
mod rest;
pub mod source;
pub mod structure;
pub mod suggest;
pub mod symbolic;
pub mod syntax;
pub mod units;

pub use compile::compile;
pub use rest::{AtRest, Held, Hold, compile_at_rest};
