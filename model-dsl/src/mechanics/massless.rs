//! Coordinates without inertia: a body alone, or several that can move together without moving any
//! mass, which makes M singular.

use crate::model::{BodyId, Mass};
use crate::structure::bodies_named;

use super::Derivation;
use super::inertia::Inertia;

/// A pivot of M, in parts of its diagonal entry, that counts as zero.
const ZERO: f64 = 1e-11;

impl Derivation<'_> {
    /// A coordinate that moves no mass at all.
    pub(super) fn massless(&mut self, index: usize) {
        let body = &self.model.bodies[self.coordinates[index].body];
        let hint =
            "give it a `mass` (or a `section` and a `density`), or join it to a body that has one";
        self.fault(
            body.span,
            format!("`{}` can move but has no mass", body.name),
            hint,
        );
    }

    /// Blocks of M that are singular as drawn, with the default params.
    pub(super) fn massless_together(&mut self, inertia: &Inertia) {
        for block in &inertia.blocks {
            let is_bare = |index: &usize| {
                let masses = &self.model.bodies[self.coordinates[*index].body].masses;
                let turns = |mass: &Mass| !self.g.is_zero(mass.inertia);
                !masses.iter().any(turns)
            };
            // Where every body has inertia of its own M cannot be singular.
            if block.len() < 2 || !block.iter().any(is_bare) {
                continue;
            }
            let mut map = self.assembled_map();
            let matrix: Vec<Vec<f64>> = block
                .iter()
                .map(|&row| {
                    let entries = block.iter().map(|&column| inertia.matrix[row][column]);
                    let entries: Vec<_> = entries.collect();
                    entries
                        .into_iter()
                        .map(|entry| {
                            let entry = self.expand_with(entry, &mut map);
                            self.by_default(entry)
                        })
                        .collect()
                })
                .collect();
            let Some(motion) = massless_motion(&matrix) else {
                continue;
            };
            let bodies: Vec<BodyId> = motion
                .into_iter()
                .map(|at| self.coordinates[block[at]].body)
                .collect();
            let bare = bodies.iter().copied().find(|body| {
                let masses = &self.model.bodies[*body].masses;
                masses.iter().all(|mass| self.g.is_zero(mass.mass))
            });
            let span = self.model.bodies[bare.unwrap_or(bodies[0])].span;
            self.fault(
                span,
                format!(
                    "{} can move together, as drawn, without moving any mass",
                    bodies_named(self.model, &bodies)
                ),
                "give each of them a `mass` (or a `section` and a `density`), or make those without one link",
            );
        }
    }
}

/// The rows of a symmetric matrix, positive semidefinite, that take part in a vector which it takes
/// to zero; `None` where it is definite, or holds what is no number.
fn massless_motion(matrix: &[Vec<f64>]) -> Option<Vec<usize>> {
    let size = matrix.len();
    let scale: Vec<f64> = (0..size).map(|i| matrix[i][i].sqrt()).collect();
    if scale.iter().any(|s| !s.is_normal()) {
        return None;
    }
    // M = L D Lᵀ of the matrix scaled to a diagonal of ones.
    let mut lower = vec![vec![0.0; size]; size];
    let mut pivots: Vec<f64> = Vec::with_capacity(size);
    for i in 0..size {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k] * pivots[k]).sum();
            let value = matrix[i][j] / (scale[i] * scale[j]) - known;
            if j < i {
                lower[i][j] = value / pivots[j];
            } else if value.is_nan() {
                return None;
            } else if value > ZERO {
                pivots.push(value);
            } else {
                // Lᵀ v = 0 with v_i = 1.
                let mut vector = vec![0.0; i + 1];
                vector[i] = 1.0;
                for row in (0..i).rev() {
                    let known: f64 = (row + 1..=i).map(|k| lower[k][row] * vector[k]).sum();
                    vector[row] = -known;
                }
                let moves = |at: &usize| vector[*at].abs() > 1e-6;
                return Some((0..=i).filter(moves).collect());
            }
        }
    }
    None
}
