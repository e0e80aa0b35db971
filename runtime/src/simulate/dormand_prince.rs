//! Dormand and Prince's pair 8(5,3) with dense output of order 7, after Hairer, Nørsett and Wanner
//! (see [`coefficients`](super::coefficients)): twelve evaluations a step, three more where
//! something is asked of its inside.

use super::accounting::Flow;
use super::coefficients::{
    DENSE4, DENSE5, DENSE6, DENSE7, ERROR3, ERROR5, ERROR6, Entry, TIMES, WEIGHTS, stage,
};
use super::method::{Method, Plain, Step};
use crate::real::Real;
use crate::system::System;

pub(super) struct DormandPrince {
    /// Rates at the stages; the thirteenth is that at the end of the step.
    k: [Vec<f64>; 16],
    /// State at a stage.
    stage: Vec<f64>,
    /// State at stage 12.
    twelfth: Vec<f64>,
    /// Coefficients of each quantity's dense output, from the first order on.
    dense: Vec<[f64; 7]>,
}

impl DormandPrince {
    /// Order of a step's error estimate in its length.
    pub const ORDER: f64 = 8.0;

    pub fn new(width: usize) -> Self {
        Self {
            k: std::array::from_fn(|_| vec![0.0; width]),
            stage: vec![0.0; width],
            twelfth: vec![0.0; width],
            dense: vec![[0.0; 7]; width],
        }
    }

    /// How the rates and the state changed from stage 12 to the end of the step, at the same time.
    pub fn changes(&self, step: &Step<'_>, allowed: &[f64]) -> [f64; 2] {
        let unit: Vec<f64> = allowed.iter().map(|allowed| allowed.recip()).collect();
        [
            changed(step.f_end, &self.k[11], &unit),
            changed(step.x_end, &self.twelfth, &unit),
        ]
    }
}

/// Square of the difference of two vectors, each entry by `unit`.
#[inline(always)]
pub(super) fn changed<T: Real>(a: &[T], b: &[T], unit: &[T]) -> T {
    let mut sum = T::from_f64(0.0);
    for (i, unit) in unit.iter().enumerate() {
        let change = (a[i] - b[i]) * *unit;
        sum = change.times_plus(change, sum);
    }
    sum
}

/// out = x + h Σ row · k, where `last` are the rates of the row's last entry, which may still be in
/// registers. Inlined, so that every row becomes straight code.
#[inline(always)]
pub(super) fn advance<T: Real, K: AsRef<[T]>, const N: usize>(
    row: &[Entry; N],
    k: &[K],
    last: &[T],
    h: T,
    x: &[T],
    out: &mut [T],
) {
    combine(row, k, last, out);
    for (out, x) in out.iter_mut().zip(x) {
        *out = h.times_plus(*out, *x);
    }
}

/// out = Σ row · k, as [`advance`]: all quantities side by side.
#[inline(always)]
fn combine<T: Real, K: AsRef<[T]>, const N: usize>(
    row: &[Entry; N],
    k: &[K],
    last: &[T],
    out: &mut [T],
) {
    let n = out.len();
    for (m, (position, share)) in row.iter().enumerate() {
        let rates = if m + 1 < N {
            &k[position - 1].as_ref()[..n]
        } else {
            &last[..n]
        };
        for i in 0..n {
            out[i] = if m == 0 {
                rates[i] * *share
            } else {
                rates[i].times_plus(T::from_f64(*share), out[i])
            };
        }
    }
}

/// The square of Hairer's combination of the errors of orders 5 and 3, which is of order 8 in the
/// step; or the estimate of order 6, if larger; from the rates `k` at the stages, each quantity's
/// error by `unit`. `errors` is overwritten.
///
/// Where the motion is smooth the combination is the larger. Across a kink in the rates (friction
/// whose sliding turns round) it may be small by chance, and squares that chance: on the article's
/// actuator one step in three thousand was accepted with 20 000 times the error allowed. The other
/// estimate, of other stages, has not been seen small at the same time.
#[inline(always)]
pub(super) fn estimate<T: Real, K: AsRef<[T]>>(k: &[K], h: T, unit: &[T], errors: &mut [T]) -> T {
    let last = k[11].as_ref();
    combine(&ERROR3, k, last, errors);
    let third = weighted(errors, unit);
    combine(&ERROR5, k, last, errors);
    let fifth = weighted(errors, unit);
    combine(&ERROR6, k, k[10].as_ref(), errors);
    let sixth = weighted(errors, unit);
    let sum = fifth + third * 0.01;
    let combined = (fifth * fifth / sum).larger(sixth) * (unit.len() as f64).recip();
    sum.if_positive(h * h * combined, sum)
}

/// Square of a vector, each entry by `unit`.
#[inline(always)]
fn weighted<T: Real>(errors: &[T], unit: &[T]) -> T {
    let mut sum = T::from_f64(0.0);
    for (error, unit) in errors.iter().zip(unit) {
        let error = *error * *unit;
        sum = error.times_plus(error, sum);
    }
    sum
}

/// Σ row · k of quantity `i`.
fn combined<const N: usize>(row: &[Entry; N], k: &[Vec<f64>], i: usize) -> f64 {
    row.iter()
        .map(|(position, share)| k[position - 1][i] * share)
        .sum()
}

/// The change within a step up to a fraction of it, by the nested form of the dense output.
#[inline]
pub(super) fn polynomial(coefficients: &[f64; 7], fraction: f64) -> f64 {
    let [c1, c2, c3, c4, c5, c6, c7] = coefficients;
    let (s, r) = (fraction, 1.0 - fraction);
    s * (c1 + r * (c2 + s * (c3 + r * (c4 + s * (c5 + r * (c6 + s * c7))))))
}

impl Method for DormandPrince {
    const LOOKS: &'static [f64] = &[0.25, 0.5, 0.75, 1.0];

    fn order(&self) -> f64 {
        Self::ORDER
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
        let Self {
            k, stage, twelfth, ..
        } = self;
        k[0].copy_from_slice(f);
        macro_rules! stages {
            ($($position:literal: $row:ident),+) => {$(
                let last = &k[$position - 2];
                advance(&stage::$row, k, last, h, x, stage);
                flow.rates(t + TIMES[$position - 1] * h, stage, d, &mut k[$position - 1]);
            )+};
        }
        stages!(2: A2, 3: A3, 4: A4, 5: A5, 6: A6, 7: A7, 8: A8, 9: A9, 10: A10, 11: A11);
        advance(&stage::A12, k, &k[10], h, x, twelfth);
        flow.rates(t + TIMES[11] * h, twelfth, d, &mut k[11]);
        advance(&WEIGHTS, k, &k[11], h, x, x_end);
    }

    fn error_squared(&self, h: f64, allowed: &[f64]) -> f64 {
        let unit: Vec<f64> = allowed.iter().map(|allowed| allowed.recip()).collect();
        estimate(&self.k, h, &unit, &mut vec![0.0; unit.len()])
    }

    fn prepare<S: System + ?Sized>(&mut self, flow: &mut Flow<'_, S>, step: &Step<'_>) {
        let Self {
            k, stage, dense, ..
        } = self;
        k[12].copy_from_slice(step.f_end);
        macro_rules! stages {
            ($($position:literal: $row:ident),+) => {$(
                let last = &k[$position - 2];
                advance(&stage::$row, k, last, step.h, step.x, stage);
                let time = step.t + TIMES[$position - 1] * step.h;
                flow.rates(time, stage, step.d, &mut k[$position - 1]);
            )+};
        }
        stages!(14: A14, 15: A15, 16: A16);
        for (i, dense) in dense.iter_mut().enumerate() {
            let whole = step.x_end[i] - step.x[i];
            *dense = [
                whole,
                step.h * step.f[i] - whole,
                2.0 * whole - step.h * (step.f[i] + step.f_end[i]),
                step.h * combined(&DENSE4, k, i),
                step.h * combined(&DENSE5, k, i),
                step.h * combined(&DENSE6, k, i),
                step.h * combined(&DENSE7, k, i),
            ];
        }
    }

    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]) {
        for (i, x) in x.iter_mut().enumerate() {
            *x = step.x[i] + polynomial(&self.dense[i], fraction);
        }
    }
}
