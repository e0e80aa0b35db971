//! Where the bodies are: closing the loops, following coordinates, velocities.

use flexure_model_dsl::model::{BodyId, GROUND};
use nalgebra::{DMatrix, DVector};

use super::plane::{add, rank, refined, scaled, sub, turned};
use super::{Assembly, Kind, Mechanism, Place};

impl Mechanism<'_> {
    /// A length to compare angles with lengths.
    pub(super) fn size(&self) -> f64 {
        let mut size: f64 = 1e-3;
        for (a, b) in &self.pins {
            size = size.max(a.at[0].hypot(a.at[1])).max(b.at[0].hypot(b.at[1]));
        }
        size
    }

    /// Solves all constraints together with `held` bodies' coordinates, from a guess.
    pub(super) fn close(&self, guess: &[f64], held: &[(BodyId, f64)]) -> Result<Vec<f64>, String> {
        let mut q = guess.to_vec();
        let zero = vec![0.0; q.len()];
        let unknowns = q.len() - 3;
        let size = self.size();
        let mut best = f64::INFINITY;
        for _ in 0..60 {
            let mut gaps = self.gaps(&q);
            let (mut rows, _) = self.constraints(&q, &zero);
            for &(body, value) in held {
                gaps.push(self.coordinate(&q, body) - value);
                rows.push(self.coordinate_row(&q, &zero, body).0);
            }
            if rows.len() != unknowns {
                return Err(format!("{} conditions for {unknowns} unknowns", rows.len()));
            }
            let error = gaps
                .iter()
                .fold(0.0, |worst: f64, gap| worst.max(gap.abs()));
            // Converged: as small as rounding lets it be, and no longer falling.
            if error <= 1e-11 * size && error >= 0.5 * best || error == 0.0 {
                return Ok(q);
            }
            best = best.min(error);
            let matrix = DMatrix::from_fn(unknowns, unknowns, |i, j| {
                // Angles in units of 1/size.
                rows[i][j + 3] / if j % 3 == 2 { size } else { 1.0 }
            });
            let step = matrix
                .lu()
                .solve(&DVector::from_vec(gaps))
                .ok_or("the constraints are singular")?;
            let largest = step.iter().fold(0.0, |worst: f64, s| worst.max(s.abs()));
            if !largest.is_finite() {
                return Err("the constraints are singular".to_owned());
            }
            let damping = (0.5 * size / largest).min(1.0);
            for j in 0..unknowns {
                q[j + 3] -= damping * step[j] / if j % 3 == 2 { size } else { 1.0 };
            }
        }
        if best <= 1e-11 * size {
            Ok(q)
        } else {
            Err(format!("the loops do not close: gap {best:e} m"))
        }
    }

    /// Bodies where they are drawn, loops open.
    pub(super) fn drawn(&self) -> Vec<f64> {
        let count = self.bodies.len();
        let mut q = vec![0.0; 3 * count];
        let mut placed = vec![false; count];
        placed[GROUND] = true;
        loop {
            let mut progress = false;
            for (index, body) in self.bodies.iter().enumerate() {
                if placed[index] {
                    continue;
                }
                if let Kind::Slide {
                    carrier,
                    direction,
                    origin,
                    at,
                    ..
                } = body.kind
                {
                    if placed[carrier] {
                        let place = Place {
                            body: carrier,
                            at: add(origin, scaled(at, direction)),
                        };
                        let point = self.point(&q, place);
                        q[3 * index] = point[0];
                        q[3 * index + 1] = point[1];
                        q[3 * index + 2] = q[3 * carrier + 2];
                        placed[index] = true;
                        progress = true;
                    }
                    continue;
                }
                let joint = self.pins.iter().find_map(|&(a, b)| {
                    if a.body == index && placed[b.body] {
                        Some((a, b))
                    } else if b.body == index && placed[a.body] {
                        Some((b, a))
                    } else {
                        None
                    }
                });
                if let (Some((own, other)), Kind::Link { angle, .. }) = (joint, &body.kind) {
                    let angle = angle.unwrap_or(0.0);
                    let origin = sub(self.point(&q, other), turned(angle, own.at));
                    q[3 * index] = origin[0];
                    q[3 * index + 1] = origin[1];
                    q[3 * index + 2] = angle;
                    placed[index] = true;
                    progress = true;
                }
            }
            if !progress {
                return q;
            }
        }
    }

    /// Closes the loops from the drawn guesses: exact values first, then `coordinates` as drawn
    /// as far as they are still free.
    pub fn assemble(&self, coordinates: &[BodyId]) -> Result<Assembly, String> {
        let drawn = self.drawn();
        let zero = vec![0.0; drawn.len()];
        let exact = |body: &BodyId| match self.bodies[*body].kind {
            Kind::Link { exact, .. } | Kind::Slide { exact, .. } => exact,
            Kind::Ground => false,
        };
        let value = |body: BodyId| match self.bodies[body].kind {
            Kind::Link { angle, .. } => angle.unwrap_or(0.0),
            Kind::Slide { at, .. } => at,
            Kind::Ground => 0.0,
        };
        let mut candidates: Vec<BodyId> = (1..self.bodies.len()).filter(|b| exact(b)).collect();
        candidates.extend(coordinates.iter().filter(|b| !exact(b)));
        let (mut rows, _) = self.constraints(&drawn, &zero);
        let mut held = Vec::new();
        for body in candidates {
            if rows.len() == drawn.len() - 3 {
                break;
            }
            let before = rank(&rows);
            rows.push(self.coordinate_row(&drawn, &zero, body).0);
            if rank(&rows) == before {
                rows.pop();
            } else {
                held.push((body, value(body)));
            }
        }
        let positions = self.close(&drawn, &held)?;
        let rest_angles = self
            .hinges
            .iter()
            .map(|h| {
                let assembled = positions[3 * h.second + 2] - positions[3 * h.first + 2];
                h.rest.unwrap_or(assembled)
            })
            .collect();
        let rest_lengths = self
            .springs
            .iter()
            .map(|s| s.length.unwrap_or_else(|| self.length(&positions, s)))
            .collect();
        let rest_gaps = self
            .contacts
            .iter()
            .map(|c| c.normal.map_or(0.0, |n| self.gap(&positions, c, n)))
            .collect();
        Ok(Assembly {
            positions,
            coordinates: coordinates.to_vec(),
            rest_angles,
            rest_lengths,
            rest_gaps,
        })
    }

    /// Values of the coordinates as assembled.
    pub fn assembled_values(&self, assembly: &Assembly) -> Vec<f64> {
        let bodies = assembly.coordinates.iter();
        bodies
            .map(|&body| self.coordinate(&assembly.positions, body))
            .collect()
    }

    /// Positions of all bodies where the coordinates have `values`, reached from the assembled
    /// configuration on a straight path in small steps, so that angles are continuous.
    pub fn configuration(&self, assembly: &Assembly, values: &[f64]) -> Result<Vec<f64>, String> {
        let start = self.assembled_values(assembly);
        let size = self.size();
        let largest = assembly
            .coordinates
            .iter()
            .zip(start.iter().zip(values))
            .map(|(&body, (a, b))| match self.bodies[body].kind {
                Kind::Slide { .. } => (b - a).abs() / size,
                _ => (b - a).abs(),
            })
            .fold(0.0, f64::max);
        let steps = (largest / 0.05).ceil().max(1.0) as usize;
        let mut q = assembly.positions.clone();
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            let held: Vec<(BodyId, f64)> = assembly
                .coordinates
                .iter()
                .zip(start.iter().zip(values))
                .map(|(&body, (a, b))| {
                    (
                        body,
                        if step == steps {
                            *b
                        } else {
                            a + part * (b - a)
                        },
                    )
                })
                .collect();
            let next = self.close(&q, &held)?;
            let jump = (1..self.bodies.len())
                .map(|body| (next[3 * body + 2] - q[3 * body + 2]).abs())
                .fold(0.0, f64::max);
            if jump > 0.5 {
                return Err(format!("a body turns by {jump} rad in one small step"));
            }
            q = next;
        }
        Ok(q)
    }

    /// Positions of all bodies where the coordinates have `values`, a little beside `q`.
    pub fn beside(
        &self,
        assembly: &Assembly,
        q: &[f64],
        values: &[f64],
    ) -> Result<Vec<f64>, String> {
        let coordinates = assembly.coordinates.iter();
        let held: Vec<(BodyId, f64)> = coordinates.copied().zip(values.iter().copied()).collect();
        self.close(q, &held)
    }

    /// Velocities of all bodies where the coordinates have `rates`.
    pub fn velocities(
        &self,
        assembly: &Assembly,
        q: &[f64],
        rates: &[f64],
    ) -> Result<Vec<f64>, String> {
        let zero = vec![0.0; q.len()];
        let (mut rows, right) = self.constraints(q, &zero);
        let mut right = vec![0.0; right.len()];
        for (&body, &rate) in assembly.coordinates.iter().zip(rates) {
            rows.push(self.coordinate_row(q, &zero, body).0);
            right.push(rate);
        }
        let unknowns = q.len() - 3;
        let size = self.size();
        let matrix = DMatrix::from_fn(unknowns, unknowns, |i, j| {
            rows[i][j + 3] / if j % 3 == 2 { size } else { 1.0 }
        });
        let solution =
            refined(&matrix, &DVector::from_vec(right)).ok_or("the constraints are singular")?;
        let mut v = zero;
        for j in 0..unknowns {
            v[j + 3] = solution[j] / if j % 3 == 2 { size } else { 1.0 };
        }
        Ok(v)
    }
}
