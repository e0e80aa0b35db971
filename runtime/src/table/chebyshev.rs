//! Chebyshev expansions of several functions at once, side by side.
//!
//! Arrays hold a row for each node or degree, with an entry for each function.

use std::f64::consts::PI;

/// Nodes: enough to see the decay behind the largest degree.
pub(super) const NODES: usize = 17;

/// The nodes, and Chebyshev polynomials there.
pub(super) struct Grid {
    /// cos(k (2j + 1) π / 2n): the polynomial of degree k at node j.
    at_nodes: [[f64; NODES]; NODES],
}

impl Grid {
    pub fn new() -> Self {
        let step = PI / (2 * NODES) as f64;
        // A whole turn is 4 NODES steps.
        let cosines: [f64; 4 * NODES] = std::array::from_fn(|k| (k as f64 * step).cos());
        Self {
            at_nodes: std::array::from_fn(|k| {
                std::array::from_fn(|j| cosines[k * (2 * j + 1) % (4 * NODES)])
            }),
        }
    }

    /// The nodes, from 1 down to -1.
    pub fn nodes(&self) -> &[f64; NODES] {
        &self.at_nodes[1]
    }

    /// Coefficients of the polynomials through `values` at the nodes.
    pub fn expand(&self, values: &[f64], count: usize) -> Vec<f64> {
        let mut coefficients = vec![0.0; NODES * count];
        for (k, row) in coefficients.chunks_exact_mut(count).enumerate() {
            let share = if k == 0 { 1.0 } else { 2.0 } / NODES as f64;
            for (polynomial, values) in self.at_nodes[k].iter().zip(values.chunks_exact(count)) {
                add(row, share * polynomial, values);
            }
        }
        coefficients
    }

    /// Coefficients of the polynomials through `values` that were taken at the points `taken_at`,
    /// close to the nodes: the slopes of a first expansion move them to the nodes.
    pub fn expand_moved(&self, values: &[f64], taken_at: &[f64; NODES], count: usize) -> Vec<f64> {
        let slopes = derivative(&self.expand(values, count), count);
        let mut moved = values.to_vec();
        for (j, row) in moved.chunks_exact_mut(count).enumerate() {
            let step = self.nodes()[j] - taken_at[j];
            for (slopes, at_nodes) in slopes.chunks_exact(count).zip(&self.at_nodes) {
                add(row, step * at_nodes[j], slopes);
            }
        }
        self.expand(&moved, count)
    }
}

/// Adds `factor` times a row to another.
fn add(to: &mut [f64], factor: f64, row: &[f64]) {
    for (to, entry) in to.iter_mut().zip(row) {
        *to += factor * entry;
    }
}

/// Coefficients of the derivatives: c'ₖ₋₁ = c'ₖ₊₁ + 2k cₖ.
fn derivative(coefficients: &[f64], count: usize) -> Vec<f64> {
    let rows = coefficients.len() / count;
    let mut slopes = vec![0.0; (rows + 1) * count];
    for k in (1..rows).rev() {
        for f in 0..count {
            slopes[(k - 1) * count + f] =
                slopes[(k + 1) * count + f] + 2.0 * k as f64 * coefficients[k * count + f];
        }
    }
    slopes[..count].iter_mut().for_each(|slope| *slope *= 0.5);
    slopes
}

/// Coefficients of powers, by Tₖ₊₁ = 2 s Tₖ - Tₖ₋₁; one row for each power.
pub(super) fn powers(coefficients: &[f64], count: usize) -> Vec<Vec<f64>> {
    let rows = coefficients.len() / count;
    let mut sums = vec![vec![0.0; count]; rows];
    let mut before = vec![0.0; rows];
    let mut now = vec![0.0; rows];
    now[0] = 1.0;
    for (k, row) in coefficients.chunks_exact(count).enumerate() {
        for (sum, weight) in sums.iter_mut().zip(&now) {
            add(sum, *weight, row);
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let next = (0..rows)
            .map(|power| {
                let raised = if power == 0 { 0.0 } else { now[power - 1] };
                factor * raised - before[power]
            })
            .collect();
        before = std::mem::replace(&mut now, next);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_come_back() {
        // 1 - 3 s + 2 s⁵ and s², side by side, taken a little beside the nodes.
        let of = |s: f64| [1.0 - 3.0 * s + 2.0 * s.powi(5), s * s];
        let grid = Grid::new();
        let taken_at = grid.nodes().map(|node| node * (1.0 - 1e-9));
        let values: Vec<f64> = taken_at.iter().flat_map(|s| of(*s)).collect();
        let coefficients = powers(&grid.expand_moved(&values, &taken_at, 2), 2);
        let expected = [
            [1.0, 0.0],
            [-3.0, 0.0],
            [0.0, 1.0],
            [0.0; 2],
            [0.0; 2],
            [2.0, 0.0],
        ];
        for (power, row) in coefficients.iter().enumerate() {
            for (function, value) in row.iter().enumerate() {
                let expected = expected.get(power).map_or(0.0, |row| row[function]);
                // Powers of degree 16 have coefficients of 2¹⁵, and rounding errors of that size.
                assert!((value - expected).abs() < 1e-10, "{power}: {value}");
            }
        }
    }
}
