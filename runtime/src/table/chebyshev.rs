//! Chebyshev expansions, and the polynomials that they are.

use std::f64::consts::PI;

/// Nodes: enough to see the decay behind the largest degree.
pub(super) const NODES: usize = 17;

/// The nodes, and Chebyshev polynomials there.
pub(super) struct Grid {
    /// cos(k (2j + 1) π / 2n) at (j, k): the polynomial of degree k at node j.
    at_nodes: [[f64; NODES]; NODES],
    /// The polynomials of degree 1: from 1 down to -1.
    pub nodes: [f64; NODES],
}

impl Grid {
    pub fn new() -> Self {
        let step = PI / (2 * NODES) as f64;
        // A whole turn is 4 NODES steps.
        let cosines: [f64; 4 * NODES] = std::array::from_fn(|k| (k as f64 * step).cos());
        let at_nodes = std::array::from_fn(|j| {
            std::array::from_fn(|k| cosines[k * (2 * j + 1) % (4 * NODES)])
        });
        Self {
            at_nodes,
            nodes: at_nodes.map(|polynomials| polynomials[1]),
        }
    }

    /// Coefficients of the polynomial through `values` at the nodes.
    pub fn expand(&self, values: &[f64; NODES]) -> [f64; NODES] {
        let mut sums = [0.0; NODES];
        for (value, polynomials) in values.iter().zip(&self.at_nodes) {
            for (sum, polynomial) in sums.iter_mut().zip(polynomials) {
                *sum += value * polynomial;
            }
        }
        let mut coefficients = sums.map(|sum| sum * (2.0 / NODES as f64));
        coefficients[0] *= 0.5;
        coefficients
    }

    /// Coefficients of the polynomial through `values` that were taken at points that far below the
    /// nodes: the slopes of a first expansion move them to the nodes.
    pub fn expand_moved(&self, values: &[f64; NODES], below: &[f64; NODES]) -> [f64; NODES] {
        let slopes = derivative(&self.expand(values));
        self.expand(&std::array::from_fn(|j| {
            let terms = slopes.iter().zip(&self.at_nodes[j]);
            let slope: f64 = terms.map(|(slope, polynomial)| slope * polynomial).sum();
            values[j] + below[j] * slope
        }))
    }
}

/// Coefficients of the derivative: c'ₖ₋₁ = c'ₖ₊₁ + 2k cₖ.
fn derivative(coefficients: &[f64; NODES]) -> [f64; NODES] {
    let mut slopes = [0.0; NODES];
    for k in (1..NODES).rev() {
        let after = slopes.get(k + 1).copied().unwrap_or(0.0);
        slopes[k - 1] = after + 2.0 * k as f64 * coefficients[k];
    }
    slopes[0] *= 0.5;
    slopes
}

/// Coefficients of the powers in the Chebyshev polynomials, by Tₖ₊₁ = 2 s Tₖ - Tₖ₋₁.
pub(super) fn polynomials() -> [[f64; NODES]; NODES] {
    let mut all = [[0.0; NODES]; NODES];
    all[0][0] = 1.0;
    all[1][1] = 1.0;
    for k in 2..NODES {
        for power in 0..=k {
            let raised = if power == 0 {
                0.0
            } else {
                all[k - 1][power - 1]
            };
            all[k][power] = 2.0 * raised - all[k - 2][power];
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_come_back() {
        // 1 - 3 s + 2 s⁵, taken a little beside the nodes.
        let of = |s: f64| 1.0 - 3.0 * s + 2.0 * s.powi(5);
        let grid = Grid::new();
        let taken_at = grid.nodes.map(|node| node * (1.0 - 1e-9));
        let below = std::array::from_fn(|j| grid.nodes[j] - taken_at[j]);
        let coefficients = grid.expand_moved(&taken_at.map(of), &below);
        // T₁ = s, T₃ = 4s³ - 3s, T₅ = 16s⁵ - 20s³ + 5s.
        let expected = [1.0, -3.0 + 10.0 / 8.0, 0.0, 5.0 / 8.0, 0.0, 1.0 / 8.0];
        for (k, coefficient) in coefficients.iter().enumerate() {
            let expected = expected.get(k).copied().unwrap_or(0.0);
            assert!((coefficient - expected).abs() < 1e-15, "{k}: {coefficient}");
        }
        assert_eq!(polynomials()[5][..6], [0.0, 5.0, 0.0, -20.0, 0.0, 16.0]);
    }
}
