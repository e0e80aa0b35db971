//! What the walk asks of a method of integration.

use super::accounting::Flow;
use super::automatic::Watch;
use crate::real::Real;
use crate::system::System;

/// A step that was taken: both of its ends.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    /// Time at its start.
    pub t: f64,
    /// Its length.
    pub h: f64,
    /// State at its start.
    pub x: &'a [f64],
    /// Rates at its start.
    pub f: &'a [f64],
    /// Discrete state during it.
    pub d: &'a [f64],
    /// State at its end.
    pub x_end: &'a [f64],
    /// Rates at its end.
    pub f_end: &'a [f64],
}

/// Plain steps of a method, which may be taken on lanes.
pub(super) struct Plain<'m> {
    /// To be kept, if there is one.
    pub watch: Option<&'m mut Watch<f64>>,
}

/// A one-step method.
pub(super) trait Method {
    /// Where, within a step, event functions are looked at, as fractions of the step; ends in 1.
    const LOOKS: &'static [f64];

    /// The order of the estimated error in the step.
    fn order(&self) -> f64;

    /// Whether its steps are those of the stiff method.
    fn is_stiff(&self) -> bool {
        false
    }

    /// What is to be known of its steps if they are taken elsewhere; `None` if they cannot be.
    fn plain(&mut self) -> Option<Plain<'_>> {
        None
    }

    /// Takes note of a step that counts, with the errors that were allowed in it. Where the next
    /// one is another method's: the length to begin with.
    fn accepted(&mut self, _step: &Step<'_>, _allowed: &[f64]) -> Option<f64> {
        None
    }

    /// Steps from `x` with rates `f` at `t` by `h`, to `x_end`.
    #[allow(clippy::too_many_arguments)]
    fn step<S: System + ?Sized>(
        &mut self,
        flow: &mut Flow<'_, S>,
        t: f64,
        h: f64,
        x: &[f64],
        f: &[f64],
        d: &[f64],
        x_end: &mut [f64],
    );

    /// Square of the estimated error of the step just taken over the first quantities, each in
    /// units of `allowed`: it may be accepted if not above 1.
    fn error_squared(&self, h: f64, allowed: &[f64]) -> f64;

    /// Makes ready to interpolate within the step just taken.
    fn prepare<S: System + ?Sized>(&mut self, flow: &mut Flow<'_, S>, step: &Step<'_>);

    /// The state at a fraction of the step that was made ready.
    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]);
}

/// The cubic through both ends of a step: of order 3, from what is known anyway.
pub(super) fn cubic(step: &Step<'_>, fraction: f64, x: &mut [f64]) {
    for (i, x) in x.iter_mut().enumerate() {
        let states = [step.x[i], step.x_end[i]];
        *x = cubic_at(fraction, step.h, states, [step.f[i], step.f_end[i]]);
    }
}

/// The same of one quantity, by its values and rates at both ends.
#[inline(always)]
pub(super) fn cubic_at<T: Real>(s: f64, h: T, [from, to]: [T; 2], rates: [T; 2]) -> T {
    let to_end = s * s * (3.0 - 2.0 * s);
    let rate_start = h * s * (1.0 - s) * (1.0 - s);
    let rate_end = -h * s * s * (1.0 - s);
    from + (to - from) * to_end + rate_start * rates[0] + rate_end * rates[1]
}
