//! Measures: what the names `crank.angle`, `stage.v`, `tip.z` in a user's expressions stand for.
//!
//! Measures of the configuration get their meaning, and their derivatives, before the laws that may
//! use them; the others after the motion is known.

use crate::model::{BodyId, EnergyKind, Measure};
use crate::symbolic::Expr;

use super::Derivation;
use super::laws::Laws;
use super::motion::Motion;

impl Derivation<'_> {
    /// Defines the measures that depend on the configuration alone.
    pub(super) fn position_measures(&mut self) {
        for used in self.model.measures.clone() {
            let value = match used.measure {
                Measure::Angle(body) | Measure::Position(body) => self.variable(body).value,
                Measure::Travel(body) => self.variable(body).shift,
                Measure::PointPosition(point, axis) => {
                    let point = self.model.points[point].clone();
                    let place = self.place(point.body, point.at);
                    self.position(&place)[axis]
                }
                Measure::AngleRate(_)
                | Measure::Velocity(_)
                | Measure::PointVelocity(..)
                | Measure::HingeAngle(_)
                | Measure::HingeTorque(_)
                | Measure::SpringExtension(_)
                | Measure::SpringForce(_)
                | Measure::ContactState(..)
                | Measure::ContactFriction(_)
                | Measure::ContactNormal(_)
                | Measure::ContactSlip(_)
                | Measure::Energy(_) => continue,
            };
            self.define(used.symbol, value, "");
            self.attach_gradient(used.symbol, value);
        }
    }

    /// Defines all other measures.
    pub(super) fn other_measures(&mut self, laws: &Laws, motion: &Motion) {
        for used in self.model.measures.clone() {
            let value = match used.measure {
                Measure::Angle(_)
                | Measure::Position(_)
                | Measure::Travel(_)
                | Measure::PointPosition(..) => continue,
                Measure::AngleRate(body) | Measure::Velocity(body) => self.variable_rate(body),
                Measure::PointVelocity(point, axis) => {
                    let point = self.model.points[point].clone();
                    let place = self.place(point.body, point.at);
                    let (one, zero) = (self.g.one(), self.g.zero());
                    let axis = self.fixed([[one, zero], [zero, one]][axis]);
                    let levers: Vec<Expr> = (0..self.coordinates.len())
                        .map(|i| self.lever(&place, &axis, i))
                        .collect();
                    self.rate_of(&levers)
                }
                Measure::HingeAngle(hinge) => laws.hinges[hinge].0,
                Measure::HingeTorque(hinge) => laws.hinges[hinge].1,
                Measure::SpringExtension(spring) => laws.springs[spring].0,
                Measure::SpringForce(spring) => laws.springs[spring].1,
                Measure::ContactState(contact, state) => laws.contacts[contact].states[state],
                Measure::ContactFriction(contact) => laws.contacts[contact].friction,
                Measure::ContactNormal(contact) => laws.contacts[contact].normal,
                Measure::ContactSlip(contact) => laws.contacts[contact].slip,
                Measure::Energy(kind) => match kind {
                    EnergyKind::Kinetic => motion.energy.kinetic,
                    EnergyKind::Potential => motion.energy.potential,
                    EnergyKind::Total => self.g.add(motion.energy.kinetic, motion.energy.potential),
                    EnergyKind::DissipatedPower => motion.energy.dissipated_power,
                    EnergyKind::SuppliedPower => motion.energy.supplied_power,
                    // States of their own: see `motion`.
                    EnergyKind::Dissipated | EnergyKind::Supplied => continue,
                },
            };
            self.define(used.symbol, value, "");
        }
    }

    /// Rate in time of a link's angle or a slide's position.
    pub(super) fn variable_rate(&mut self, body: BodyId) -> Expr {
        let rates = self.variable(body).rates.clone();
        self.rate_of(&rates)
    }
}
