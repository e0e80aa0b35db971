//! Dimensions, units and quantities: what `3.6e6 N/m` means.
//!
//! A [`Dimension`] is a product of powers of the SI base units; a [`Unit`] is one symbol or chain of
//! symbols of a closed list with its exact factor to SI; [`parse_quantity`] reads a number with a
//! unit as it stands on a command line. Model files use the same units through the grammar.

mod dimension;
mod quantity;
mod unit;

pub use dimension::{Dimension, Mark};
pub(crate) use quantity::exact_decimal;
pub use quantity::{NumberError, parse_quantity};
pub use unit::Unit;
