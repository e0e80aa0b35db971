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
use super::method::{Method, Step};
use super::rosenbrock::Rosenbrock;
use crate::system::System;

/// Explicit steps that stability limits have a product of step and eigenvalue above this.
const STABLE: f64 = 6.0;
/// So many of them call for a trial of the stiff method.
const PATIENCE: u64 = 15;
/// Patience is at most this.
const MOST_PATIENCE: u64 = 2000;
/// So many steps in a row that stability does not limit put an end to the count.
const CALM: u64 = 6;
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
    patience: u64,
    /// Explicit steps that stability limited, and calm ones since.
    limited: u64,
    calm: u64,
    /// Steps tried, and steps accepted and the time they covered, since counting began.
    tried: u64,
    accepted: u64,
    covered: f64,
    /// Time that explicit steps cover per evaluation, where the last ones were limited.
    explicit_pace: f64,
    /// Length of the last explicit step.
    explicit_step: f64,
}

impl Automatic {
    pub fn new(width: usize) -> Self {
        Self {
            explicit: DormandPrince::new(width),
            stiff: Rosenbrock::new(width),
            is_stiff: false,
            stiff_cost: stiff_cost(width),
            patience: PATIENCE,
            limited: 0,
            calm: 0,
            tried: 0,
            accepted: 0,
            covered: 0.0,
            explicit_pace: 0.0,
            explicit_step: 0.0,
        }
    }

    fn count_anew(&mut self) {
        (self.tried, self.accepted, self.covered) = (0, 0, 0.0);
        (self.limited, self.calm) = (0, 0);
    }

    fn more_patience(&self) -> u64 {
        (2 * self.patience).min(MOST_PATIENCE)
    }

    fn after_explicit(&mut self, step: &Step<'_>, allowed: &[f64]) {
        if self.explicit.stretch(step, allowed) > STABLE {
            self.limited += 1;
            self.calm = 0;
        } else {
            self.calm += 1;
            if self.calm >= CALM {
                self.count_anew();
            }
        }
        if self.limited >= self.patience {
            self.explicit_pace = self.covered / (EXPLICIT_COST * self.tried as f64);
            self.explicit_step = step.h;
            self.is_stiff = true;
            self.count_anew();
        }
    }

    /// The length of the explicit step to go on with, if it is to be one.
    fn after_stiff(&mut self) -> Option<f64> {
        let pace = self.covered / (self.stiff_cost * self.tried as f64);
        let pays = pace > self.explicit_pace;
        if self.accepted == TRIAL {
            self.patience = if pays { PATIENCE } else { self.more_patience() };
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

    fn accepted(&mut self, step: &Step<'_>, allowed: &[f64]) -> Option<f64> {
        self.accepted += 1;
        self.covered += step.h;
        if self.is_stiff {
            self.after_stiff()
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
            self.patience = self.more_patience();
            self.count_anew();
        }
        self.tried += 1;
        if self.is_stiff {
            self.stiff.step(flow, t, h, x, f, d, x_end);
        } else {
            self.explicit.step(flow, t, h, x, f, d, x_end);
        }
    }

    fn error(&self, h: f64, allowed: &[f64]) -> f64 {
        if self.is_stiff {
            self.stiff.error(h, allowed)
        } else {
            self.explicit.error(h, allowed)
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
