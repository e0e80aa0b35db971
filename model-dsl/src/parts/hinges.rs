//! Torsional stiffness of flexure hinges by formulas of the literature.

use crate::symbolic::{Expr, Graph, Rational};

/// Formulas for the right circular hinge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CircularFormula {
    /// K = 2 E b e^(5/2) / (9 π √r), with web thickness e, radius r and width b: the limit of a
    /// thin web, e ≪ r. J. M. Paros and L. Weisbord, *How to design flexure hinges*, Machine
    /// Design 37, 1965.
    ThinWeb,
}

impl CircularFormula {
    /// Names of all formulas, as they are written in model files.
    pub const NAMES: [&str; 1] = ["thin_web"];

    /// The formula of that name.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "thin_web" => Some(CircularFormula::ThinWeb),
            _ => None,
        }
    }
}

/// Torsional stiffness in N·m/rad of a right circular hinge of elastic modulus, width, web
/// thickness and radius.
pub fn circular(
    g: &mut Graph,
    [modulus, width, web, radius]: [Expr; 4],
    formula: CircularFormula,
) -> Expr {
    match formula {
        CircularFormula::ThinWeb => {
            let pi = g.pi();
            let power = |numerator: i64, denominator: i64| {
                Rational::new(numerator.into(), denominator.into())
            };
            g.powers(
                power(2, 9),
                &[
                    (modulus, power(1, 1)),
                    (width, power(1, 1)),
                    (web, power(5, 2)),
                    (pi, power(-1, 1)),
                    (radius, power(-1, 2)),
                ],
            )
        }
    }
}
