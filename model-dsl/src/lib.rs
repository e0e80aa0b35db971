//! From the text of a model file to the equations of motion.
pub mod equations;
pub mod model;
pub mod notation;
pub mod parts;
pub mod source;
pub mod symbolic;
pub mod units;
