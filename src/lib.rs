//! From a model file of a planar flexure mechanism to its equations of motion in closed form and
//! a fast simulator.

pub use flexure_codegen as codegen;
pub use flexure_model_dsl as model_dsl;
pub use flexure_runtime as runtime;
