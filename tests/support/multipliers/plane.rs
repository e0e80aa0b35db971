//! Vectors in the plane, and rows over all coordinates.

use nalgebra::{DMatrix, DVector};

use super::Plane;

pub(super) fn add(a: Plane, b: Plane) -> Plane {
    [a[0] + b[0], a[1] + b[1]]
}

pub(super) fn sub(a: Plane, b: Plane) -> Plane {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: Plane, b: Plane) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn scaled(k: f64, a: Plane) -> Plane {
    [k * a[0], k * a[1]]
}

/// A quarter turn counter-clockwise.
pub(super) fn perpendicular(a: Plane) -> Plane {
    [-a[1], a[0]]
}

pub(super) fn turned(angle: f64, a: Plane) -> Plane {
    let (sin, cos) = angle.sin_cos();
    [cos * a[0] - sin * a[1], sin * a[0] + cos * a[1]]
}

pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn rank(rows: &[Vec<f64>]) -> usize {
    if rows.is_empty() {
        return 0;
    }
    let matrix = DMatrix::from_fn(rows.len(), rows[0].len() - 3, |i, j| rows[i][j + 3]);
    matrix.rank(1e-9)
}

/// Solves a linear system and improves the solution twice by its residual.
pub(super) fn refined(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let factors = matrix.clone().lu();
    let mut solution = factors.solve(right)?;
    for _ in 0..2 {
        let residual = right - matrix * &solution;
        solution += factors.solve(&residual)?;
    }
    Some(solution)
}

/// Condition number in the norm of the largest column sum; infinite for a singular matrix.
pub(super) fn condition(matrix: &DMatrix<f64>) -> f64 {
    let norm = |matrix: &DMatrix<f64>| {
        let sums = matrix.column_iter().map(|column| column.lp_norm(1));
        sums.fold(0.0, f64::max)
    };
    match matrix.clone().lu().try_inverse() {
        Some(inverse) => norm(matrix) * norm(&inverse),
        None => f64::INFINITY,
    }
}
