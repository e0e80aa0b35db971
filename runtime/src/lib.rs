//! What generated simulators and the `flexure` command run on.

pub mod diagnostic;
pub mod system;
