//! Accelerations by the bordered system, and energies.

use nalgebra::{DMatrix, DVector};

use super::plane::{condition, dot, product, refined, turned};
use super::{Assembly, Energies, Mechanism, Motion, Place, Surroundings};

impl Mechanism<'_> {
    /// Mass matrix, and the forces that come of masses off their frames' origins.
    pub(super) fn inertia(&self, q: &[f64], v: &[f64]) -> (DMatrix<f64>, Vec<f64>) {
        let width = q.len();
        let mut matrix = DMatrix::zeros(width, width);
        let mut forces = vec![0.0; width];
        for (index, body) in self.bodies.iter().enumerate() {
            let [x, y, turn] = [3 * index, 3 * index + 1, 3 * index + 2];
            for &(mass, center, inertia) in &body.masses {
                let arm = turned(q[turn], center);
                matrix[(x, x)] += mass;
                matrix[(y, y)] += mass;
                matrix[(turn, turn)] += inertia + mass * dot(arm, arm);
                matrix[(x, turn)] -= mass * arm[1];
                matrix[(turn, x)] -= mass * arm[1];
                matrix[(y, turn)] += mass * arm[0];
                matrix[(turn, y)] += mass * arm[0];
                forces[x] += mass * v[turn].powi(2) * arm[0];
                forces[y] += mass * v[turn].powi(2) * arm[1];
            }
        }
        (matrix, forces)
    }

    /// Accelerations where bodies are at `q` and move with `v`.
    pub fn accelerations(
        &self,
        assembly: &Assembly,
        at: &Surroundings,
        q: &[f64],
        v: &[f64],
    ) -> Result<Motion, String> {
        let (mass, inertial) = self.inertia(q, v);
        let (forces, bristle_rates, friction) = self.forces(assembly, at, q, v);
        let (rows, right) = self.constraints(q, v);
        let width = q.len() - 3;
        let total = width + rows.len();
        let mut applied = inertial.clone();
        for (row, amount) in &forces {
            for (sum, entry) in applied.iter_mut().zip(row) {
                *sum += amount * entry;
            }
        }
        // Scaling: q = D·y makes the diagonal of M one; each constraint row is made of length one.
        let size = self.size();
        let typical = (1..q.len() / 3)
            .map(|body| mass[(3 * body, 3 * body)])
            .fold(0.0, f64::max);
        let scale: Vec<f64> = (0..width)
            .map(|j| {
                let unit = if j % 3 == 2 { size * size } else { 1.0 };
                1.0 / mass[(j + 3, j + 3)].max(1e-6 * typical * unit).sqrt()
            })
            .collect();
        let lengths: Vec<f64> = rows
            .iter()
            .map(|row| {
                let squares = (0..width).map(|j| (row[j + 3] * scale[j]).powi(2));
                squares.sum::<f64>().sqrt()
            })
            .collect();
        let matrix = DMatrix::from_fn(total, total, |i, j| match (i < width, j < width) {
            (true, true) => mass[(i + 3, j + 3)] * scale[i] * scale[j],
            (false, true) => rows[i - width][j + 3] * scale[j] / lengths[i - width],
            (true, false) => rows[j - width][i + 3] * scale[i] / lengths[j - width],
            (false, false) => 0.0,
        });
        let vector = DVector::from_fn(total, |i, _| {
            if i < width {
                applied[i + 3] * scale[i]
            } else {
                right[i - width] / lengths[i - width]
            }
        });
        let solution = refined(&matrix, &vector).ok_or("the bordered system is singular")?;
        let condition = condition(&matrix);
        let mut acceleration = vec![0.0; q.len()];
        for j in 0..width {
            acceleration[j + 3] = solution[j] * scale[j];
        }
        let mut coordinates = Vec::new();
        let mut magnitudes = Vec::new();
        for (index, &body) in assembly.coordinates.iter().enumerate() {
            let (row, bias) = self.coordinate_row(q, v, body);
            coordinates.push(product(&row, &acceleration) + bias);
            let mut unit = vec![0.0; assembly.coordinates.len()];
            unit[index] = 1.0;
            let tangent = self.velocities(assembly, q, &unit)?;
            let column = DVector::from_vec(tangent.clone());
            let reduced = column.dot(&(&mass * &column));
            let mut sum = forces
                .iter()
                .map(|(row, amount)| (amount * product(row, &tangent)).abs())
                .sum::<f64>();
            sum += inertial
                .iter()
                .zip(&tangent)
                .map(|(f, t)| (f * t).abs())
                .sum::<f64>();
            magnitudes.push(sum / reduced);
        }
        Ok(Motion {
            coordinates,
            magnitudes,
            bristle_rates,
            friction,
            condition,
        })
    }

    /// Energies where bodies are at `q` and move with `v`.
    pub fn energies(
        &self,
        assembly: &Assembly,
        at: &Surroundings,
        q: &[f64],
        v: &[f64],
    ) -> Energies {
        let (mut kinetic, mut potential) = (0.0, 0.0);
        for (index, body) in self.bodies.iter().enumerate() {
            for &(mass, center, inertia) in &body.masses {
                let place = Place {
                    body: index,
                    at: center,
                };
                let velocity = self.point_velocity(q, v, place);
                kinetic += 0.5 * mass * dot(velocity, velocity);
                kinetic += 0.5 * inertia * v[3 * index + 2].powi(2);
                potential -= mass * dot(self.gravity, self.point(q, place));
            }
        }
        for (hinge, rest) in self.hinges.iter().zip(&assembly.rest_angles) {
            let deflection = q[3 * hinge.second + 2] - q[3 * hinge.first + 2] - rest;
            potential += 0.5 * hinge.stiffness * deflection * deflection;
        }
        for (spring, rest) in self.springs.iter().zip(&assembly.rest_lengths) {
            let mut extension = self.length(q, spring) - rest;
            if let Some(expansion) = spring.expansion {
                extension -= self.evaluator(at, q, v).value(expansion);
            }
            potential += 0.5 * spring.stiffness * extension * extension;
        }
        for (contact, bristle) in self.contacts.iter().zip(&at.bristles) {
            if !contact.compliant {
                potential += 0.5 * contact.law.sigma0 * bristle * bristle;
            }
        }
        Energies { kinetic, potential }
    }
}
