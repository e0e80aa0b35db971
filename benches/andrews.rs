//! x
use crate::{baseline::Baseline,table::Table};
pub fn to_an_accuracy(_c: Option<&Baseline>, _table: &mut Table, _full: bool) {}
