//! Gravity: the weight of every mass, through the height of its centre.

use crate::symbolic::Expr;

use super::super::Derivation;
use super::Laws;

impl Derivation<'_> {
    /// P_g = -Σ m (gravity · r), by coordinate as g·[Σ m ∂(height)/∂q] where gravity points down.
    pub(super) fn gravity(&mut self, laws: &mut Laws) {
        let Some([gx, gy]) = self.model.gravity else {
            return;
        };
        let (one, zero) = (self.g.one(), self.g.zero());
        let mut axes: Vec<(Expr, [Expr; 2])> = Vec::new();
        for (component, axis, name) in [(gx, [one, zero], "g_x"), (gy, [zero, one], "g")] {
            if self.g.is_zero(component) {
                continue;
            }
            let downwards = self.g.neg(component);
            let name = if name == "g" && !self.g.is_zero(gx) {
                "g_y"
            } else {
                name
            };
            let magnitude = if self.g.as_symbol(downwards).is_some() {
                downwards
            } else {
                self.named(name, downwards, "acceleration of gravity")
            };
            axes.push((magnitude, axis));
        }
        let masses: Vec<_> = (0..self.model.bodies.len())
            .flat_map(|body| {
                self.model.bodies[body]
                    .masses
                    .iter()
                    .map(move |mass| (body, mass))
            })
            .map(|(body, mass)| (body, mass.mass, mass.center))
            .collect();
        for (magnitude, axis) in axes {
            let axis = self.fixed(axis);
            let mut heights = Vec::new();
            let mut weights: Vec<Vec<Expr>> = vec![Vec::new(); self.coordinates.len()];
            for &(body, mass, center) in &masses {
                let place = self.place(body, center);
                let height = self.dot(&place, &axis);
                heights.push(self.g.mul(mass, height));
                for (index, terms) in weights.iter_mut().enumerate() {
                    let lever = self.lever(&place, &axis, index);
                    let weight = self.g.mul(mass, lever);
                    if !self.g.is_zero(weight) {
                        terms.push(weight);
                    }
                }
            }
            for (index, terms) in weights.iter().enumerate() {
                let sum = self.g.sum(terms);
                let weight = self.g.mul(magnitude, sum);
                if !self.g.is_zero(weight) {
                    laws.gravity[index].push(weight);
                }
            }
            let sum = self.g.sum(&heights);
            laws.potential.push(self.g.mul(magnitude, sum));
        }
    }
}
