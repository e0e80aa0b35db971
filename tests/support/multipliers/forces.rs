//! Forces on the bodies, each as an amount and the row along which it does work.

use flexure_model_dsl::model::{BodyId, Load, Measure};
use flexure_model_dsl::symbolic::{Evaluator, Expr};

use super::plane::{dot, perpendicular, product, scaled, sub, turned};
use super::reading::{evaluator, local, place};
use super::{Assembly, Contact, Direction, LuGre, Mechanism, Place, Plane, Spring, Surroundings};

/// The row along which a force does work, and its amount.
pub(super) type Push = (Vec<f64>, f64);

impl<'m> Mechanism<'m> {
    pub(super) fn spring_axis(&self, q: &[f64], spring: &Spring) -> Plane {
        match spring.direction {
            Direction::Fixed(carrier, direction) => turned(q[3 * carrier + 2], direction),
            Direction::Line => {
                let line = sub(self.point(q, spring.second), self.point(q, spring.first));
                scaled(1.0 / line[0].hypot(line[1]), line)
            }
        }
    }

    pub(super) fn length(&self, q: &[f64], spring: &Spring) -> f64 {
        let line = sub(self.point(q, spring.second), self.point(q, spring.first));
        dot(line, self.spring_axis(q, spring))
    }

    /// ∂(direction·(second - first))/∂q, for a direction that turns with `carrier`.
    pub(super) fn difference_row(
        &self,
        q: &[f64],
        first: Place,
        second: Place,
        direction: Plane,
        carrier: BodyId,
    ) -> Vec<f64> {
        let mut row = vec![0.0; q.len()];
        self.add_point(q, second, direction, &mut row);
        self.add_point(q, first, scaled(-1.0, direction), &mut row);
        let line = sub(self.point(q, second), self.point(q, first));
        row[3 * carrier + 2] += dot(line, perpendicular(direction));
        row
    }

    pub(super) fn gap(&self, q: &[f64], contact: &Contact, normal: Plane) -> f64 {
        let line = sub(self.point(q, contact.first), self.point(q, contact.second));
        dot(line, normal)
    }

    pub(super) fn evaluator(&self, at: &Surroundings, q: &[f64], v: &[f64]) -> Evaluator<'m> {
        let mut evaluator = evaluator(self.model, &self.params);
        evaluator.set(self.model.time, at.time);
        for (input, value) in self.model.inputs.iter().zip(&at.inputs) {
            evaluator.set(input.symbol, *value);
        }
        for drive in &self.model.drives {
            evaluator.define(drive.symbol, drive.waveform.value);
            for memory in &drive.waveform.memory {
                let name = format!("{}.{}", drive.name, memory.name);
                match at.memory.iter().find(|(known, _)| *known == name) {
                    Some((_, value)) => evaluator.set(memory.symbol, *value),
                    None => evaluator.define(memory.symbol, memory.initial),
                }
            }
        }
        for used in &self.model.measures {
            if let Some(value) = self.measured(q, v, used.measure) {
                evaluator.set(used.symbol, value);
            }
        }
        evaluator
    }

    /// Quantities of the motion that expressions may use; others are not numbers.
    pub(super) fn measured(&self, q: &[f64], v: &[f64], measure: Measure) -> Option<f64> {
        let place = |index: usize| {
            let point = &self.model.points[index];
            let mut evaluator = evaluator(self.model, &self.params);
            Place {
                body: point.body,
                at: local(&point.at, &mut |expr| evaluator.value(expr)),
            }
        };
        match measure {
            Measure::Angle(body) | Measure::Position(body) => Some(self.coordinate(q, body)),
            Measure::AngleRate(body) => Some(v[3 * body + 2]),
            Measure::Velocity(body) => {
                let (row, _) = self.coordinate_row(q, v, body);
                Some(product(&row, v))
            }
            Measure::PointPosition(index, axis) => Some(self.point(q, place(index))[axis]),
            Measure::PointVelocity(index, axis) => {
                Some(self.point_velocity(q, v, place(index))[axis])
            }
            _ => None,
        }
    }

    /// d/dt of an expression of time alone, by extrapolated central differences.
    pub(super) fn rate(&self, at: &Surroundings, q: &[f64], v: &[f64], expr: Expr) -> f64 {
        let value = |shift: f64| {
            let moved = Surroundings {
                time: at.time + shift,
                ..at.clone()
            };
            self.evaluator(&moved, q, v).value(expr)
        };
        let mut table: Vec<Vec<f64>> = Vec::new();
        let mut step = 2e-5;
        for row in 0..4 {
            let mut line = vec![(value(step) - value(-step)) / (2.0 * step)];
            for column in 0..row {
                let factor = 4f64.powi(column as i32 + 1);
                let better =
                    line[column] + (line[column] - table[row - 1][column]) / (factor - 1.0);
                line.push(better);
            }
            table.push(line);
            step *= 0.5;
        }
        table[3][3]
    }

    /// Generalised forces, Q = Σ amount·rowᵀ; then each contact's bristle rate and friction force.
    pub(super) fn forces(
        &self,
        assembly: &Assembly,
        at: &Surroundings,
        q: &[f64],
        v: &[f64],
    ) -> (Vec<Push>, Vec<f64>, Vec<f64>) {
        let width = q.len();
        let mut forces = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            for &(mass, center, _) in &body.masses {
                let place = Place {
                    body: index,
                    at: center,
                };
                for axis in 0..2 {
                    let mut direction = [0.0; 2];
                    direction[axis] = 1.0;
                    let mut row = vec![0.0; width];
                    self.add_point(q, place, direction, &mut row);
                    forces.push((row, mass * self.gravity[axis]));
                }
            }
        }
        for (hinge, rest) in self.hinges.iter().zip(&assembly.rest_angles) {
            let mut row = vec![0.0; width];
            row[3 * hinge.second + 2] += 1.0;
            row[3 * hinge.first + 2] -= 1.0;
            let deflection = q[3 * hinge.second + 2] - q[3 * hinge.first + 2] - rest;
            let rate = v[3 * hinge.second + 2] - v[3 * hinge.first + 2];
            forces.push((row, -hinge.stiffness * deflection - hinge.damping * rate));
        }
        for (spring, rest) in self.springs.iter().zip(&assembly.rest_lengths) {
            let axis = self.spring_axis(q, spring);
            let carrier = match spring.direction {
                Direction::Line => None,
                Direction::Fixed(carrier, _) => Some(carrier),
            };
            let row =
                self.difference_row(q, spring.first, spring.second, axis, carrier.unwrap_or(0));
            let (mut extension, mut rate) = (self.length(q, spring) - rest, product(&row, v));
            if let Some(expansion) = spring.expansion {
                extension -= self.evaluator(at, q, v).value(expansion);
                rate -= self.rate(at, q, v, expansion);
            }
            forces.push((row, -spring.stiffness * extension - spring.damping * rate));
        }
        let (mut bristle_rates, mut frictions) = (Vec::new(), Vec::new());
        for (index, contact) in self.contacts.iter().enumerate() {
            let (carrier, direction) = contact.guide;
            let direction = turned(q[3 * carrier + 2], direction);
            let row = self.difference_row(q, contact.second, contact.first, direction, carrier);
            let slip = product(&row, v);
            let mut normal_force = contact.preload;
            if let Some(normal) = contact.normal {
                let normal_row = self.difference_row(q, contact.second, contact.first, normal, 0);
                if contact.compliant {
                    let approach = assembly.rest_gaps[index] - self.gap(q, contact, normal);
                    let rate = -product(&normal_row, v);
                    normal_force += contact.stiffness * approach + contact.damping * rate;
                    normal_force = normal_force.max(0.0);
                }
                forces.push((normal_row, normal_force));
            }
            let bristle = at.bristles.get(index).copied().unwrap_or(0.0);
            let (rate, friction) =
                contact
                    .law
                    .friction(slip, bristle, normal_force, contact.preload);
            bristle_rates.push(rate);
            frictions.push(friction);
            forces.push((row, -friction));
        }
        for load in &self.model.loads {
            match load {
                Load::Force { on, value, .. } => {
                    let mut evaluator = self.evaluator(at, q, v);
                    let place = place(on, &mut |expr| evaluator.value(expr));
                    for axis in 0..2 {
                        let mut direction = [0.0; 2];
                        direction[axis] = 1.0;
                        let mut row = vec![0.0; width];
                        self.add_point(q, place, direction, &mut row);
                        forces.push((row, evaluator.value(value[axis])));
                    }
                }
                Load::Torque {
                    on, against, value, ..
                } => {
                    let mut row = vec![0.0; width];
                    row[3 * on + 2] += 1.0;
                    row[3 * against + 2] -= 1.0;
                    forces.push((row, self.evaluator(at, q, v).value(*value)));
                }
            }
        }
        (forces, bristle_rates, frictions)
    }
}

impl LuGre {
    /// Rate of the bristle deflection and friction force (Canudas de Wit et al. 1995; with a
    /// normal force that varies, the force scales with it and g keeps the preload).
    pub(super) fn friction(
        &self,
        slip: f64,
        bristle: f64,
        normal: f64,
        preload: f64,
    ) -> (f64, f64) {
        if normal <= 0.0 {
            return (0.0, 0.0);
        }
        let (coulomb, holding) = (self.mu_c * preload, self.mu_s * preload);
        let level = coulomb + (holding - coulomb) * (-(slip / self.v_s).powi(2)).exp();
        let rate = slip - self.sigma0 * slip.abs() * bristle / level;
        let force = self.sigma0 * bristle + self.sigma1 * rate + self.sigma2 * slip;
        (rate, force * normal / preload)
    }
}
