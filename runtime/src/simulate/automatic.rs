//! Explicit steps, and steps of the stiff method where those get on faster.
//!
//! While explicit steps are as long as accuracy allows, they are the cheaper ones. Where stability
//! limits them instead, the stiff method is tried; it stays if it covers more time per evaluation,
//! for a while, then explicit steps show anew how far they get. Where it does not pay, the next
//! trial waits for twice as many steps that stability limits.
//!
//! Whether stability limits a step is seen as in Hairer's code DOP853: stages 12 and 13 stand at
//! the same time, so the change of their rates over that of their states is about the largest
//! eigenvalue; times the step, the method is stable up to about 6.
//!
//! All is counted in steps that were tried: nothing depends on which rows are recorded.

use super::accounting::Flow;
use super::dormand_prince::DormandPrince;
use super::method::{Method, Plain, Step};
use super::rosenbrock::Rosenbrock;
use crate::lanes::Lanes;
use crate::real::Real;
use crate::system::System;

/// Explicit steps that stability limits have a product of step and eigenvalue above this.
const STABLE: f64 = 6.0;
/// So many of them call for a trial of the stiff method.
const PATIENCE: f64 = 15.0;
/// Patience is at most this.
const MOST_PATIENCE: f64 = 2000.0;
/// So many steps in a row that stability does not limit put an end to the count.
const CALM: f64 = 6.0;
/// Steps of a trial of the stiff method; the first of them still grow.
const TRIAL: u64 = 20;
/// Steps of the stiff method before explicit ones are tried again.
const STAY: u64 = 300;
/// Evaluations of a tried explicit step.
const EXPLICIT_COST: f64 = 12.0;
/// A stiff method that finds no step is left after so many rejections.
const MOST_REJECTED: u64 = 6;

/// Evaluations that a tried stiff step of `n` quantities costs: its own ten, and as many as its
/// Jacobian and its linear systems take the time of, fitted to the article's actuator.
fn stiff_cost(n: usize) -> f64 {
    let n = n as f64;
    10.0 + 0.5 * n + n * (n / 1.5 + 16.0) / 20.0
}

pub(super) struct Automatic {
    explicit: DormandPrince,
    stiff: Rosenbrock,
    is_stiff: bool,
    stiff_cost: f64,
    watch: Watch<f64>,
    /// Stiff steps tried and accepted, and the time they covered, since the last explicit one.
    tried: u64,
    accepted: u64,
    covered: f64,
    /// Time that explicit steps cover per evaluation, where the last ones were limited.
    explicit_pace: f64,
    /// Length of the last explicit step.
    explicit_step: f64,
}

/// Explicit steps as they are watched, by whoever takes them.
pub(super) struct Watch<T> {
    /// Whether the step being judged is one that stability limits: positive if so.
    is_limited: T,
    /// So many of them call for the stiff method.
    patience: T,
    /// Steps that stability limited, and calm ones since.
    limited: T,
    calm: T,
    /// Steps tried, and the time they covered, since counting began.
    tried: T,
    covered: T,
}

impl Watch<f64> {
    fn new() -> Self {
        Self {
            is_limited: 0.0,
            patience: PATIENCE,
            limited: 0.0,
            calm: 0.0,
            tried: 0.0,
            covered: 0.0,
        }
    }

    /// The same in every lane.
    pub fn on_lanes<L: Lanes>(&self) -> Watch<L> {
        Watch {
            is_limited: L::from_f64(self.is_limited),
            patience: L::from_f64(self.patience),
            limited: L::from_f64(self.limited),
            calm: L::from_f64(self.calm),
            tried: L::from_f64(self.tried),
            covered: L::from_f64(self.covered),
        }
    }

    fn count_anew(&mut self) {
        *self = Self {
            patience: self.patience,
            ..Self::new()
        };
    }

    fn more_patience(&mut self) {
        self.patience = (2.0 * self.patience).min(MOST_PATIENCE);
    }
}

impl<L: Lanes> Watch<L> {
    /// That of one lane.
    pub fn of_lane(&self, lane: usize) -> Watch<f64> {
        Watch {
            is_limited: self.is_limited.entry(lane),
            patience: self.patience.entry(lane),
            limited: self.limited.entry(lane),
            calm: self.calm.entry(lane),
            tried: self.tried.entry(lane),
            covered: self.covered.entry(lane),
        }
    }
}

impl<T: Real> Watch<T> {
    /// Judges an explicit step of length `h` by the squares of how much the rates and the state
    /// changed from its stage 12 to its end, at the same time: the root of their quotient is the
    /// largest eigenvalue of the Jacobian, roughly. Positive if patience allows it to count.
    #[inline(always)]
    pub fn judge(&mut self, h: T, [rates, state]: [T; 2]) -> T {
        self.is_limited = h * h * rates - state * (STABLE * STABLE);
        let left = self.patience - self.limited - 0.5;
        self.is_limited.if_positive(left - 1.0, left)
    }

    /// Counts the step where `tried` is positive, as one that counts where `accepted` is.
    #[inline(always)]
    pub fn count(&mut self, tried: T, accepted: T, h: T) {
        let zero = T::from_f64(0.0);
        self.tried = tried.if_positive(self.tried + 1.0, self.tried);
        self.covered = accepted.if_positive(self.covered + h, self.covered);
        let limited = self
            .is_limited
            .if_positive(self.limited + 1.0, self.limited);
        self.limited = accepted.if_positive(limited, self.limited);
        let calm = self.is_limited.if_positive(zero, self.calm + 1.0);
        self.calm = accepted.if_positive(calm, self.calm);
        let again = self.calm - (CALM - 0.5);
        for number in [
            &mut self.tried,
            &mut self.covered,
            &mut self.limited,
            &mut self.calm,
        ] {
            *number = again.if_positive(zero, *number);
        }
    }
}

impl Automatic {
    pub fn new(width: usize) -> Self {
        Self {
            explicit: DormandPrince::new(width),
            stiff: Rosenbrock::new(width),
            is_stiff: false,
            stiff_cost: stiff_cost(width),
            watch: Watch::new(),
            tried: 0,
            accepted: 0,
            covered: 0.0,
            explicit_pace: 0.0,
            explicit_step: 0.0,
        }
    }

    fn count_anew(&mut self) {
        (self.tried, self.accepted, self.covered) = (0, 0, 0.0);
        self.watch.count_anew();
    }

    fn after_explicit(&mut self, step: &Step<'_>, allowed: &[f64]) {
        let changes = self.explicit.changes(step, allowed);
        let has_patience = self.watch.judge(step.h, changes) > 0.0;
        self.watch.count(-1.0, 1.0, step.h);
        if !has_patience {
            self.explicit_pace = self.watch.covered / (EXPLICIT_COST * self.watch.tried);
            self.explicit_step = step.h;
            self.is_stiff = true;
            self.count_anew();
        }
    }

    /// The length of the explicit step to go on with, if it is to be one.
    fn after_stiff(&mut self, h: f64) -> Option<f64> {
        self.accepted += 1;
        self.covered += h;
        let pace = self.covered / (self.stiff_cost * self.tried as f64);
        let pays = pace > self.explicit_pace;
        if self.accepted == TRIAL {
            if pays {
                self.watch.patience = PATIENCE;
            } else {
                self.watch.more_patience();
            }
        }
        if self.accepted < TRIAL || (pays && self.accepted < STAY) {
            return None;
        }
        self.is_stiff = false;
        self.count_anew();
        Some(self.explicit_step)
    }
}

impl Method for Automatic {
    const LOOKS: &'static [f64] = DormandPrince::LOOKS;

    fn order(&self) -> f64 {
        if self.is_stiff {
            self.stiff.order()
        } else {
            self.explicit.order()
        }
    }

    fn is_stiff(&self) -> bool {
        self.is_stiff
    }

    fn plain(&mut self) -> Option<Plain<'_>> {
        (!self.is_stiff).then_some(Plain {
            watch: Some(&mut self.watch),
        })
    }

    fn accepted(&mut self, step: &Step<'_>, allowed: &[f64]) -> Option<f64> {
        if self.is_stiff {
            self.after_stiff(step.h)
        } else {
            self.after_explicit(step, allowed);
            None
        }
    }

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
        if self.is_stiff && self.tried > 2 * self.accepted + MOST_REJECTED {
            self.is_stiff = false;
            self.watch.more_patience();
            self.count_anew();
        }
        if self.is_stiff {
            self.tried += 1;
            self.stiff.step(flow, t, h, x, f, d, x_end);
        } else {
            self.watch.tried += 1.0;
            self.explicit.step(flow, t, h, x, f, d, x_end);
        }
    }

    fn error_squared(&self, h: f64, allowed: &[f64]) -> f64 {
        if self.is_stiff {
            self.stiff.error_squared(h, allowed)
        } else {
            self.explicit.error_squared(h, allowed)
        }
    }

    fn prepare<S: System + ?Sized>(&mut self, flow: &mut Flow<'_, S>, step: &Step<'_>) {
        if self.is_stiff {
            self.stiff.prepare(flow, step);
        } else {
            self.explicit.prepare(flow, step);
        }
    }

    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]) {
        if self.is_stiff {
            self.stiff.interpolate(step, fraction, x);
        } else {
            self.explicit.interpolate(step, fraction, x);
        }
    }
}
