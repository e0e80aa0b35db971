//! A model file that is not there.

flexure_macros::include_model!(::flexure_runtime, "no/such/file.flex");

fn main() {}
