//! Joints as constraints, and what coordinates are in terms of bodies' positions.

use flexure_model_dsl::model::BodyId;

use super::plane::{add, dot, perpendicular, scaled, sub, turned};
use super::{Kind, Mechanism, Place, Plane};

impl Mechanism<'_> {
    pub(super) fn point(&self, q: &[f64], place: Place) -> Plane {
        let [x, y, angle] = [0, 1, 2].map(|i| q[3 * place.body + i]);
        add([x, y], turned(angle, place.at))
    }

    pub(super) fn point_velocity(&self, q: &[f64], v: &[f64], place: Place) -> Plane {
        let arm = turned(q[3 * place.body + 2], place.at);
        let [x, y, rate] = [0, 1, 2].map(|i| v[3 * place.body + i]);
        add([x, y], scaled(rate, perpendicular(arm)))
    }

    /// Adds `weight · ∂(direction · point)/∂q` to `row`.
    pub(super) fn add_point(&self, q: &[f64], place: Place, direction: Plane, row: &mut [f64]) {
        let arm = turned(q[3 * place.body + 2], place.at);
        row[3 * place.body] += direction[0];
        row[3 * place.body + 1] += direction[1];
        row[3 * place.body + 2] += dot(direction, perpendicular(arm));
    }

    /// Values of all joint constraints.
    pub(super) fn gaps(&self, q: &[f64]) -> Vec<f64> {
        let mut gaps = Vec::new();
        for &(a, b) in &self.pins {
            let gap = sub(self.point(q, a), self.point(q, b));
            gaps.extend(gap);
        }
        for (index, body) in self.bodies.iter().enumerate() {
            if let Kind::Slide {
                carrier,
                direction,
                origin,
                ..
            } = body.kind
            {
                let lateral = turned(q[3 * carrier + 2], perpendicular(direction));
                let distance = sub(
                    [q[3 * index], q[3 * index + 1]],
                    [q[3 * carrier], q[3 * carrier + 1]],
                );
                gaps.push(dot(lateral, distance) - dot(perpendicular(direction), origin));
                gaps.push(q[3 * index + 2] - q[3 * carrier + 2]);
            }
        }
        gaps
    }

    /// Rows of the constraints' Jacobian and what J·q̈ must be.
    pub(super) fn constraints(&self, q: &[f64], v: &[f64]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let width = q.len();
        let (mut rows, mut right) = (Vec::new(), Vec::new());
        for &(a, b) in &self.pins {
            for axis in [[1.0, 0.0], [0.0, 1.0]] {
                let mut row = vec![0.0; width];
                self.add_point(q, a, axis, &mut row);
                self.add_point(q, b, scaled(-1.0, axis), &mut row);
                rows.push(row);
                let towards = |place: Place| {
                    let arm = turned(q[3 * place.body + 2], place.at);
                    v[3 * place.body + 2].powi(2) * dot(axis, arm)
                };
                right.push(towards(a) - towards(b));
            }
        }
        for (index, body) in self.bodies.iter().enumerate() {
            if let Kind::Slide {
                carrier, direction, ..
            } = body.kind
            {
                let (row, bias) =
                    self.distance_along(q, v, index, carrier, perpendicular(direction));
                rows.push(row);
                right.push(-bias);
                let mut row = vec![0.0; width];
                row[3 * index + 2] += 1.0;
                row[3 * carrier + 2] -= 1.0;
                rows.push(row);
                right.push(0.0);
            }
        }
        (rows, right)
    }

    /// For s = n·(p_slide - p_carrier) with n fixed in the carrier: ∂s/∂q and s̈ - (∂s/∂q)·q̈.
    pub(super) fn distance_along(
        &self,
        q: &[f64],
        v: &[f64],
        slide: BodyId,
        carrier: BodyId,
        direction: Plane,
    ) -> (Vec<f64>, f64) {
        let n = turned(q[3 * carrier + 2], direction);
        let along = perpendicular(n);
        let vector = |w: &[f64], body: BodyId| [w[3 * body], w[3 * body + 1]];
        let distance = sub(vector(q, slide), vector(q, carrier));
        let rate = sub(vector(v, slide), vector(v, carrier));
        let turn = v[3 * carrier + 2];
        let mut row = vec![0.0; q.len()];
        for axis in 0..2 {
            row[3 * slide + axis] += n[axis];
            row[3 * carrier + axis] -= n[axis];
        }
        row[3 * carrier + 2] += dot(along, distance);
        let bias = 2.0 * turn * dot(along, rate) - turn * turn * dot(n, distance);
        (row, bias)
    }

    /// The value of a body's coordinate: a link's angle, a slide's position from its origin.
    pub(super) fn coordinate(&self, q: &[f64], body: BodyId) -> f64 {
        match self.bodies[body].kind {
            Kind::Ground => 0.0,
            Kind::Link { .. } => q[3 * body + 2],
            Kind::Slide {
                carrier,
                direction,
                origin,
                ..
            } => {
                let n = turned(q[3 * carrier + 2], direction);
                let distance = sub(
                    [q[3 * body], q[3 * body + 1]],
                    [q[3 * carrier], q[3 * carrier + 1]],
                );
                dot(n, distance) - dot(direction, origin)
            }
        }
    }

    pub(super) fn coordinate_row(&self, q: &[f64], v: &[f64], body: BodyId) -> (Vec<f64>, f64) {
        match self.bodies[body].kind {
            Kind::Slide {
                carrier, direction, ..
            } => self.distance_along(q, v, body, carrier, direction),
            _ => {
                let mut row = vec![0.0; q.len()];
                row[3 * body + 2] = 1.0;
                (row, 0.0)
            }
        }
    }
}
