//! How far a coordinate is expected to go from its start: the deflection of the linearised system
//! under what acts on it at rest, and what its rate at the start carries it.
//!
//! With K = -∂(accelerations)/∂(coordinates) at the start, the coordinates that springs hold come to
//! rest at K⁻¹ (accelerations at the start). The accelerations are sampled over the first segments
//! of the drives, so that the drives' whole stroke counts.

use crate::system::System;

/// Segments of drives that are sampled.
const SEGMENTS: usize = 8;
/// A coordinate whose own stiffness is below this share of what is usual in its row is held by
/// nothing.
const HELD: f64 = 1e-12;

/// The largest expected distance of coordinate `which` from its start, in its own unit. `None` if
/// nothing holds it. `coordinates` are the positions of all coordinates and of their rates among
/// the states.
pub(super) fn expected(
    system: &dyn System,
    coordinates: &[(usize, usize)],
    which: usize,
) -> Option<f64> {
    let n = system.states().len();
    let u = inputs(system);
    let (mut x, mut d) = (vec![0.0; n], vec![0.0; system.discretes().len()]);
    system.start(&mut x, &mut d);
    let rates: Vec<f64> = coordinates.iter().map(|&(_, rate)| x[rate]).collect();
    for &(_, rate) in coordinates {
        x[rate] = 0.0;
    }
    let mut jacobian = vec![0.0; n * n];
    system.jacobian(0.0, &x, &d, &u, &mut jacobian);
    let stiffness =
        |row: usize, column: usize| -jacobian[coordinates[row].1 * n + coordinates[column].0];
    let held: Vec<usize> = (0..coordinates.len())
        .filter(|&row| {
            let usual = (0..coordinates.len()).map(|column| stiffness(row, column).abs());
            let own = stiffness(row, row);
            own > 0.0 && own > HELD * usual.fold(0.0, f64::max)
        })
        .collect();
    let place = held.iter().position(|&row| row == which)?;
    let matrix: Vec<Vec<f64>> = held
        .iter()
        .map(|&row| held.iter().map(|&column| stiffness(row, column)).collect())
        .collect();
    // The deflection of one coordinate takes one row of the inverse.
    let compliance = row_of_inverse(matrix, place)?;
    let mut reach = (rates[which] / stiffness(which, which).sqrt()).abs();
    let mut dx = vec![0.0; n];
    for (t, d) in samples(system, d) {
        system.rhs(t, &x, &d, &u, &mut dx);
        let deflection: f64 = held
            .iter()
            .zip(&compliance)
            .map(|(&row, compliance)| compliance * dx[coordinates[row].1])
            .sum();
        // What is not a number says nothing.
        reach = reach.max(deflection.abs());
    }
    Some(reach).filter(|reach| reach.is_finite())
}

/// Start values of the inputs.
pub(super) fn inputs(system: &dyn System) -> Vec<f64> {
    let rows = system.inputs().iter();
    rows.map(|input| input.start.unwrap_or(0.0)).collect()
}

/// Times with the discrete state of their drives: both ends and the middle of each of the first
/// segments; powers of two of a second where there is no next kink.
fn samples(system: &dyn System, mut d: Vec<f64>) -> Vec<(f64, Vec<f64>)> {
    let mut samples = Vec::new();
    let mut kinks = vec![0.0; system.kink_count()];
    let mut from = 0.0;
    for _ in 0..SEGMENTS {
        system.next_kinks(&d, &mut kinks);
        let next = kinks
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, time)| time.is_finite())
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((index, to)) = next else {
            samples.push((from, d.clone()));
            samples.extend((-20..=2).map(|power| (from + f64::from(power).exp2(), d.clone())));
            break;
        };
        for share in [0.0, 0.5, 1.0] {
            samples.push((from + share * (to - from), d.clone()));
        }
        system.pass_kink(index, &mut d);
        from = to;
    }
    samples
}

/// Row `row` of the inverse: the solution of `matrix`ᵀ y = e, by elimination with pivots. `None`
/// where the matrix is singular.
fn row_of_inverse(matrix: Vec<Vec<f64>>, row: usize) -> Option<Vec<f64>> {
    let n = matrix.len();
    let mut a: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| matrix[j][i]).collect())
        .collect();
    let mut y: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == row))).collect();
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs()))?;
        a.swap(column, pivot);
        y.swap(column, pivot);
        let divisor = a[column][column];
        if divisor == 0.0 || !divisor.is_finite() {
            return None;
        }
        for i in column + 1..n {
            let factor = a[i][column] / divisor;
            if factor != 0.0 {
                for j in column..n {
                    a[i][j] -= factor * a[column][j];
                }
                y[i] -= factor * y[column];
            }
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| a[i][j] * y[j]).sum();
        y[i] = (y[i] - known) / a[i][i];
    }
    Some(y)
}
