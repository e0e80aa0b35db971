//! x
use crate::{baseline::Baseline,table::Table};
pub fn start_to_exit(_c: Option<&Baseline>, _table: &mut Table, _full: bool) {}
