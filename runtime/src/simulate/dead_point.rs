//! The way to a dead point, watched from step to step.
//!
//! As a loop comes to its dead point the coordinate that leads it comes to rest, q* - q ~ (t* - t)²,
//! while the sine of its transmission angle, the root of the closure, falls to zero at a finite
//! rate. The equations hold for one branch and are singular there: an integrator left alone stands
//! still at the dead point, or is thrown back onto the branch on which it came, and neither is the
//! mechanism's motion. So no step goes farther than half of the way on which the sine, as it falls,
//! would reach zero. A motion that turns in time turns; one that does not halves its distance with
//! every step, until the time of the dead point is known to rounding.

use crate::system::System;

/// A sine below this is zero for what comes of it: the rest of the way is taken as straight. The
/// closure, its square, still has eight digits; time and place are known to as many.
const REACHED: f64 = 1e-4;

/// So near to a dead point that steps which are a small part of the way left are so by the rounding
/// of loops that close by Newton's method, not by the motion.
pub(super) const NEAR: f64 = 1e-2;

/// Such a part.
const SMALL_PART: f64 = 1e-4;

/// What the loops' closures were and are.
pub(super) struct Approach {
    time: f64,
    /// The last step.
    passed: f64,
    closures: Vec<f64>,
    /// Sines of the transmission angles.
    sines: Vec<f64>,
    /// Their rates over the last step, in 1/s.
    rates: Vec<f64>,
}

impl Approach {
    pub fn new(loops: usize) -> Self {
        Self {
            time: 0.0,
            passed: f64::INFINITY,
            closures: vec![0.0; loops],
            sines: vec![f64::NAN; loops],
            rates: vec![0.0; loops],
        }
    }

    /// The run stands at `t`.
    pub fn stand<S: System + ?Sized>(
        &mut self,
        system: &S,
        t: f64,
        x: &[f64],
        d: &[f64],
        u: &[f64],
    ) {
        if self.closures.is_empty() {
            return;
        }
        system.closures(t, x, d, u, &mut self.closures);
        self.passed = t - self.time;
        for index in 0..self.closures.len() {
            let sine = self.closures[index].max(0.0).sqrt();
            self.set(index, self.sines[index], sine);
        }
        self.time = t;
    }

    /// Sines of the transmission angles where the run stands.
    pub fn sines(&self) -> &[f64] {
        &self.sines
    }

    /// The run stands at `t`, after a last step of length `passed`; `sines` gives for each loop the
    /// sine before that step and after it.
    pub fn follow(&mut self, t: f64, passed: f64, sines: impl Fn(usize) -> (f64, f64)) {
        self.time = t;
        self.passed = passed;
        for index in 0..self.sines.len() {
            let (before, after) = sines(index);
            self.set(index, before, after);
        }
    }

    fn set(&mut self, index: usize, before: f64, after: f64) {
        let rate = (after - before) / self.passed;
        self.rates[index] = if rate.is_finite() { rate } else { 0.0 };
        self.sines[index] = after;
    }

    /// Half of the time after which the first loop would come to its dead point.
    pub fn longest_step(&self) -> f64 {
        0.5 * self
            .left()
            .map(|(_, left)| left)
            .fold(f64::INFINITY, f64::min)
    }

    /// The loop that has come to its dead point, and the time left until then.
    pub fn reached(&self) -> Option<(usize, f64)> {
        self.left().find(|&(index, left)| {
            let sine = self.sines[index];
            sine < REACHED || (sine < NEAR && self.passed < SMALL_PART * left)
        })
    }

    /// Loops whose sine falls, and the time left until it would be zero.
    fn left(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let falling = self
            .rates
            .iter()
            .enumerate()
            .filter(|(_, rate)| **rate < 0.0);
        falling.map(|(index, rate)| (index, self.sines[index] / -rate))
    }
}
