//! Hinges: torsion spring and damper on the relative angle of two bodies.

use crate::structure::turning_link;
use crate::symbolic::{Expr, Function};

use super::super::Derivation;
use super::super::inertia::Inertia;
use super::Laws;

impl Derivation<'_> {
    /// Deflection θ = (second - first) - rest; torque -k θ - c θ̇ on the second body.
    pub(super) fn hinge(&mut self, index: usize, inertia: &Inertia, laws: &mut Laws) {
        let hinge = self.model.hinges[index].clone();
        let (first, second) = hinge.bodies;
        let [a, b] = [first, second].map(|body| turning_link(self.model, body));
        let [shift_a, shift_b] = [a, b].map(|link| match link {
            Some(link) => self.variable(link).shift,
            None => self.g.zero(),
        });
        let mut angle = self.g.sub(shift_b, shift_a);
        if let Some(rest) = hinge.rest {
            let [start_a, start_b] = [a, b].map(|link| match link {
                Some(link) => self.variable(link).assembled,
                None => self.g.zero(),
            });
            let assembled = self.g.sub(start_b, start_a);
            let wound = self.g.sub(assembled, rest);
            let zero = self.g.zero();
            // The same relative angle may have been drawn a full turn away.
            let wound = self.g.function(Function::Unwrap, &[wound, zero]);
            let name = format!("θ_{}⁰", hinge.name);
            let words = format!("deflection of the hinge at `{}` as assembled", hinge.name);
            let wound = self.named(&name, wound, words);
            angle = self.g.add(angle, wound);
        }
        let levers = self.relative_rates(first, second);
        let mut torque = Vec::new();
        if let Some(stiffness) = hinge.stiffness {
            let elastic = self.g.mul(stiffness, angle);
            torque.push(self.g.neg(elastic));
            self.elastic(inertia, laws, elastic, &levers);
            let half = self.g.ratio(1, 2);
            let square = self.g.powi(angle, 2);
            laws.potential
                .push(self.g.product(&[half, stiffness, square]));
        }
        if let Some(damping) = hinge.damping {
            let rate = self.rate_of(&levers);
            let viscous = self.g.mul(damping, rate);
            let viscous = self.g.neg(viscous);
            torque.push(viscous);
            self.push_forces(laws, viscous, &levers);
            let square = self.g.powi(rate, 2);
            laws.dissipated.push(self.g.mul(damping, square));
        }
        let torque = self.g.sum(&torque);
        laws.hinges.push((angle, torque));
    }

    /// A conservative force `elastic` that works against a measure with these levers: through P
    /// within a block, through τ between blocks.
    pub(super) fn elastic(
        &mut self,
        inertia: &Inertia,
        laws: &mut Laws,
        elastic: Expr,
        levers: &[Expr],
    ) {
        if self.is_within_block(inertia, levers) {
            for (terms, lever) in laws.elastic.iter_mut().zip(levers) {
                let product = self.g.mul(elastic, *lever);
                if !self.g.is_zero(product) {
                    terms.push(product);
                }
            }
        } else {
            let force = self.minus(elastic);
            self.push_forces(laws, force, levers);
        }
    }
}
