//! The classical Runge–Kutta method of order 4, with the cubic through a step's ends as dense
//! output (local error h⁴, as large as the method's global error).

use super::accounting::Flow;
use super::method::{Method, Step, cubic};
use crate::system::System;

pub(super) struct RungeKutta {
    stage: Vec<f64>,
    k2: Vec<f64>,
    k3: Vec<f64>,
    k4: Vec<f64>,
}

impl RungeKutta {
    pub fn new(width: usize) -> Self {
        let zeros = || vec![0.0; width];
        Self {
            stage: zeros(),
            k2: zeros(),
            k3: zeros(),
            k4: zeros(),
        }
    }
}

impl Method for RungeKutta {
    const LOOKS: &'static [f64] = &[0.5, 1.0];

    fn order(&self) -> f64 {
        4.0
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
        let n = x.len();
        let (k1, stage) = (&f[..n], &mut self.stage[..n]);
        let (k2, k3, k4) = (&mut self.k2[..n], &mut self.k3[..n], &mut self.k4[..n]);
        let half = 0.5 * h;
        for i in 0..n {
            stage[i] = x[i] + half * k1[i];
        }
        flow.rates(t + half, stage, d, k2);
        for i in 0..n {
            stage[i] = x[i] + half * k2[i];
        }
        flow.rates(t + half, stage, d, k3);
        for i in 0..n {
            stage[i] = x[i] + h * k3[i];
        }
        flow.rates(t + h, stage, d, k4);
        let (x_end, sixth) = (&mut x_end[..n], h / 6.0);
        for i in 0..n {
            x_end[i] = x[i] + sixth * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }

    fn error(&self, _h: f64, _allowed: &[f64]) -> f64 {
        0.0
    }

    fn prepare<S: System + ?Sized>(&mut self, _flow: &mut Flow<'_, S>, _step: &Step<'_>) {}

    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]) {
        cubic(step, fraction, x);
    }
}
