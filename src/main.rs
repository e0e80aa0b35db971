//! The `flexure` command.

fn main() {}
