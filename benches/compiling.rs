//! x
use crate::{baseline::Baseline,table::Table};
pub fn models(_c: Option<&Baseline>, _table: &mut Table, _full: bool) {}
