//! Outputs: what the user wants to see, each with its unit.

use crate::equations::Output;
use crate::model::{EnergyKind, Measure};
use crate::symbolic::{Expr, Node, Symbol};

use super::Derivation;

impl Derivation<'_> {
    pub(super) fn outputs(&self) -> Vec<Output> {
        self.model
            .outputs
            .iter()
            .map(|output| Output {
                name: output.name.clone(),
                unit: match self.unit_of_measures(output.value) {
                    Some(unit) => unit.to_owned(),
                    None => output.dimension.si_unit(),
                },
                meaning: output.doc.clone(),
                value: output.value,
            })
            .collect()
    }

    /// The unit where dimensions do not tell it: angles are numbers, energies have the dimension of
    /// torques. It is that of a measure that stands alone or as a term of a sum, whose terms are
    /// all of one kind.
    fn unit_of_measures(&self, value: Expr) -> Option<&'static str> {
        match self.g.node(value) {
            Node::Symbol(symbol) => self.unit_of_measure(*symbol),
            Node::Sum { terms, .. } => terms
                .iter()
                .filter_map(|(term, _)| self.g.as_symbol(*term))
                .find_map(|symbol| self.unit_of_measure(symbol)),
            Node::Number(_) | Node::Pi | Node::Product { .. } | Node::Function(..) => None,
        }
    }

    fn unit_of_measure(&self, symbol: Symbol) -> Option<&'static str> {
        let used = self
            .model
            .measures
            .iter()
            .find(|used| used.symbol == symbol)?;
        match used.measure {
            Measure::Angle(_) | Measure::HingeAngle(_) => Some("rad"),
            Measure::AngleRate(_) => Some("rad/s"),
            Measure::Energy(
                EnergyKind::Kinetic
                | EnergyKind::Potential
                | EnergyKind::Total
                | EnergyKind::Dissipated
                | EnergyKind::Supplied,
            ) => Some("J"),
            Measure::Energy(EnergyKind::DissipatedPower | EnergyKind::SuppliedPower)
            | Measure::Travel(_)
            | Measure::Position(_)
            | Measure::Velocity(_)
            | Measure::PointPosition(..)
            | Measure::PointVelocity(..)
            | Measure::HingeTorque(_)
            | Measure::SpringExtension(_)
            | Measure::SpringForce(_)
            | Measure::ContactState(..)
            | Measure::ContactFriction(_)
            | Measure::ContactNormal(_)
            | Measure::ContactSlip(_) => None,
        }
    }
}
