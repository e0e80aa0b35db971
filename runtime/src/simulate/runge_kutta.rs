//! The classical Runge–Kutta method of order 4, with the cubic through a step's ends as dense
//! output (local error h⁴, as large as the method's global error).

use super::accounting::Flow;
use super::method::{Method, Plain, Step, cubic};
use crate::system::System;

/// Shares of a step, for the rates at each stage: how far the next stage is away by them, and their
/// weight.
pub(super) const STAGES: [(f64, f64); 4] = [
    (0.5, 1.0 / 6.0),
    (0.5, 1.0 / 3.0),
    (1.0, 1.0 / 3.0),
    (0.0, 1.0 / 6.0),
];

pub(super) struct RungeKutta {
    stage: Vec<f64>,
    k: Vec<f64>,
}

impl RungeKutta {
    pub fn new(width: usize) -> Self {
        Self {
            stage: vec![0.0; width],
            k: vec![0.0; width],
        }
    }
}

impl Method for RungeKutta {
    const LOOKS: &'static [f64] = &[0.5, 1.0];

    fn order(&self) -> f64 {
        4.0
    }

    fn plain(&mut self) -> Option<Plain<'_>> {
        Some(Plain { watch: None })
    }

    #[inline]
    fn step<S: System + ?Sized>(
        &mut self,
        flow: &mut Flow<'_, S>,
        t: f64,
        h: f64,
        x: &[f64],
        f: &[f64],
        d: &[f64],
        x_end: &mut [f64],
    ) {
        let (n, f) = (x.len(), &f[..x.len()]);
        let (stage, k, x_end) = (&mut self.stage[..n], &mut self.k[..n], &mut x_end[..n]);
        k.copy_from_slice(f);
        x_end.copy_from_slice(x);
        for (index, (away, weight)) in STAGES.into_iter().enumerate() {
            let (away, weight) = (h * away, h * weight);
            for i in 0..n {
                x_end[i] += k[i] * weight;
                stage[i] = x[i] + k[i] * away;
            }
            if index + 1 < STAGES.len() {
                flow.rates(t + away, stage, d, k);
            }
        }
    }

    fn error_squared(&self, _h: f64, _allowed: &[f64]) -> f64 {
        0.0
    }

    fn prepare<S: System + ?Sized>(&mut self, _flow: &mut Flow<'_, S>, _step: &Step<'_>) {}

    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]) {
        cubic(step, fraction, x);
    }
}
