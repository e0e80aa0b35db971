//! Events: where an event function rises through zero within a step.
//!
//! An event is *armed* while its function has been seen below zero since it last happened, and only
//! an armed event can happen. So a function that starts at or above zero does not fire, and one that
//! rounding leaves on either side of zero after it was handled does not fire twice.
//!
//! A step is looked at in a few places along the cubic through its ends, which costs no evaluation
//! of the right-hand side; where three of them bend towards zero, also at the vertex of their
//! parabola, so that a function that only just rises above zero between two looks is found. What is
//! found is then located on the method's own dense output.

use super::accounting::Flow;
use super::method::{Method, Step, cubic};
use crate::real::Real;
use crate::system::System;

/// A look right behind an event: it may soon happen again.
const FIRST_LOOK: f64 = 1e-3;
/// Firings of one event after each other, each within [`CLOSE`] of the last, before it is chatter.
const MOST_CLOSE: u32 = 10;
/// Events this near to each other, relative to time, are close.
const CLOSE: f64 = 1e-10;

pub(super) struct Crossings {
    armed: Vec<bool>,
    /// Values at the start of the next step.
    start: Vec<f64>,
    here: Vec<f64>,
    probe: Vec<f64>,
    /// The two looks before: fractions and values.
    last: (f64, Vec<f64>),
    earlier: (f64, Vec<f64>),
    x: Vec<f64>,
    after_event: bool,
    /// When each event last happened, and how many times it followed itself closely.
    history: Vec<(f64, u32)>,
}

/// Where within a step something happens.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    /// Fraction of the step.
    pub fraction: f64,
    /// The first event there.
    pub index: usize,
    /// How fast its function rises there, per second.
    pub slope: f64,
    /// All events that happen there.
    pub all: Vec<usize>,
}

impl Crossings {
    pub fn new(events: usize, width: usize) -> Self {
        let zeros = || vec![0.0; events];
        Self {
            armed: vec![false; events],
            start: zeros(),
            here: zeros(),
            probe: zeros(),
            last: (0.0, zeros()),
            earlier: (0.0, zeros()),
            x: vec![0.0; width],
            after_event: false,
            history: vec![(f64::NEG_INFINITY, 0); events],
        }
    }

    pub fn is_empty(&self) -> bool {
        self.armed.is_empty()
    }

    /// Whether every event is armed and none has just happened, so that one happens only where its
    /// function rises above zero.
    pub fn are_quiet(&self) -> bool {
        !self.after_event
            && self.armed.iter().all(|armed| *armed)
            && self.start.iter().all(|v| *v < 0.0)
    }

    /// Takes the values at the start of a run, or after an accepted step.
    pub fn stand<S: System + ?Sized>(&mut self, flow: &Flow<'_, S>, t: f64, x: &[f64], d: &[f64]) {
        if !self.is_empty() {
            flow.system
                .events(t, flow.own(x), d, &flow.u, &mut self.start);
            for (armed, value) in self.armed.iter_mut().zip(&self.start) {
                *armed |= *value < 0.0;
            }
        }
    }

    /// As [`Self::stand`], after a jump: which armed events the jump itself has carried over zero.
    pub fn jumped<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> Vec<usize> {
        if self.is_empty() {
            return Vec::new();
        }
        flow.system
            .events(t, flow.own(x), d, &flow.u, &mut self.start);
        // Of an event that happened just now, the side of zero that it is left on means nothing.
        for ((armed, value), (last, _)) in self.armed.iter_mut().zip(&self.start).zip(&self.history)
        {
            *armed |= *value < 0.0 && *last != t;
        }
        (0..self.armed.len())
            .filter(|&i| self.armed[i] && self.start[i] >= 0.0)
            .collect()
    }

    /// Whether an event that happens now has followed itself too often too closely.
    pub fn happens(&mut self, index: usize, t: f64) -> bool {
        self.armed[index] = false;
        self.after_event = true;
        let (last, close) = &mut self.history[index];
        *close = if t - *last <= CLOSE * t.abs() {
            *close + 1
        } else {
            0
        };
        *last = t;
        *close > MOST_CLOSE
    }

    /// The first event within a step that was taken, if any. Leaves the method ready to interpolate
    /// if there is one.
    pub fn find<S: System + ?Sized, M: Method>(
        &mut self,
        flow: &mut Flow<'_, S>,
        method: &mut M,
        step: &Step<'_>,
    ) -> Option<Found> {
        if self.is_empty() {
            return None;
        }
        let first = self.after_event.then_some(FIRST_LOOK);
        self.after_event = false;
        self.last.0 = 0.0;
        self.last.1.copy_from_slice(&self.start);
        let mut looks = 0;
        let mut is_ready = false;
        for look in first.into_iter().chain(M::LOOKS.iter().copied()) {
            self.look(flow, step, look);
            looks += 1;
            let mut found: Option<Found> = None;
            for index in 0..self.armed.len() {
                if !self.armed[index] {
                    continue;
                }
                let bracket = if self.here[index] >= 0.0 {
                    Some((self.last.0, look))
                } else if looks > 1 {
                    self.vertex(flow, step, index, look)
                } else {
                    None
                };
                let Some(bracket) = bracket else { continue };
                if !is_ready {
                    method.prepare(flow, step);
                    is_ready = true;
                }
                let Some(fraction) = self.locate(flow, method, step, index, bracket) else {
                    continue;
                };
                found = Some(match found {
                    None => Found {
                        fraction,
                        index,
                        slope: 0.0,
                        all: vec![index],
                    },
                    Some(before) => before.merged(fraction, index, step),
                });
            }
            if let Some(mut found) = found {
                found.all.sort_unstable();
                let near = (found.fraction - 1e-4).max(0.0);
                let rise = self.at(flow, method, step, found.index, found.fraction)
                    - self.at(flow, method, step, found.index, near);
                found.slope = rise / ((found.fraction - near) * step.h);
                return Some(found);
            }
            for (armed, value) in self.armed.iter_mut().zip(&self.here) {
                *armed |= *value < 0.0;
            }
            std::mem::swap(&mut self.earlier, &mut self.last);
            self.last.0 = look;
            std::mem::swap(&mut self.last.1, &mut self.here);
        }
        None
    }

    /// Values at a fraction of the step, on the cubic.
    fn look<S: System + ?Sized>(&mut self, flow: &Flow<'_, S>, step: &Step<'_>, fraction: f64) {
        if fraction < 1.0 {
            cubic(step, fraction, &mut self.x);
        } else {
            self.x.copy_from_slice(step.x_end);
        }
        flow.system.events(
            step.t + fraction * step.h,
            flow.own(&self.x),
            step.d,
            &flow.u,
            &mut self.here,
        );
    }

    /// If the last three looks at an event bend to a vertex above zero between them: the bracket
    /// of its rise.
    fn vertex<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        step: &Step<'_>,
        index: usize,
        look: f64,
    ) -> Option<(f64, f64)> {
        let (a, ga) = (self.earlier.0, self.earlier.1[index]);
        let (b, gb) = (self.last.0, self.last.1[index]);
        let c = look;
        let parabola = Parabola::through([(a, ga), (b, gb), (c, self.here[index])]);
        let at = parabola.at;
        if !(parabola.bend < 0.0 && at > a && at < c) || parabola.gap() > 0.0 {
            return None;
        }
        cubic(step, at, &mut self.x);
        flow.system.events(
            step.t + at * step.h,
            flow.own(&self.x),
            step.d,
            &flow.u,
            &mut self.probe,
        );
        let (from, below) = if at > b { (b, gb) } else { (a, ga) };
        (below < 0.0 && self.probe[index] >= 0.0).then_some((from, at))
    }

    /// The value of one event function on the dense output.
    fn at<S: System + ?Sized, M: Method>(
        &mut self,
        flow: &Flow<'_, S>,
        method: &M,
        step: &Step<'_>,
        index: usize,
        fraction: f64,
    ) -> f64 {
        if fraction < 1.0 {
            method.interpolate(step, fraction, &mut self.x);
        } else {
            self.x.copy_from_slice(step.x_end);
        }
        flow.system.events(
            step.t + fraction * step.h,
            flow.own(&self.x),
            step.d,
            &flow.u,
            &mut self.probe,
        );
        self.probe[index]
    }

    /// The root in a bracket, from the side above zero; `None` if the dense output, which is more
    /// accurate than the cubic, does not rise through zero there.
    fn locate<S: System + ?Sized, M: Method>(
        &mut self,
        flow: &Flow<'_, S>,
        method: &M,
        step: &Step<'_>,
        index: usize,
        (mut low, mut high): (f64, f64),
    ) -> Option<f64> {
        let mut above = self.at(flow, method, step, index, high);
        if !(above >= 0.0) {
            return None;
        }
        let mut below = if low > 0.0 {
            self.at(flow, method, step, index, low)
        } else {
            self.start[index]
        };
        if !(below < 0.0) {
            return Some(low);
        }
        // Regula falsi with Anderson and Björck's weights; bisection where it dawdles.
        let resolution = 1e-15 + f64::EPSILON * (step.t.abs() / step.h);
        for round in 0..100 {
            let width = high - low;
            if width <= resolution {
                break;
            }
            let mut middle = low + width * (below / (below - above));
            if round % 4 == 3 || !(middle > low && middle < high) {
                middle = low + 0.5 * width;
            }
            let value = self.at(flow, method, step, index, middle);
            if value >= 0.0 {
                let weight = 1.0 - value / above;
                below *= if weight > 0.0 { weight } else { 0.5 };
                (high, above) = (middle, value);
            } else {
                let weight = 1.0 - value / below;
                above *= if weight > 0.0 { weight } else { 0.5 };
                (low, below) = (middle, value);
            }
            if above == 0.0 {
                break;
            }
        }
        Some(high)
    }
}

/// The parabola through three looks at an event function, by fractions of the step.
pub(super) struct Parabola<T> {
    /// Negative if its vertex is its highest point.
    pub bend: T,
    /// Where its vertex is.
    pub at: T,
    peak: T,
    lowest: T,
}

impl<T: Real> Parabola<T> {
    #[inline(always)]
    pub fn through([(a, ga), (b, gb), (c, gc)]: [(f64, T); 3]) -> Self {
        let first = (gb - ga) / (b - a);
        let bend = ((gc - gb) / (c - b) - first) / (c - a);
        let at = -(first * 0.5 / bend) + 0.5 * (a + b);
        Self {
            bend,
            at,
            peak: ga + (at - a) * (first + bend * (at - b)),
            lowest: ga.smaller(gb).smaller(gc),
        }
    }

    /// How far below zero its peak stays, less what the function may differ from it there.
    #[inline(always)]
    pub fn gap(&self) -> T {
        (self.peak - self.lowest) * -0.25 - self.peak
    }
}

impl Found {
    /// The earlier of this and another event, or both if one is as early as the other.
    fn merged(mut self, fraction: f64, index: usize, step: &Step<'_>) -> Self {
        let apart = fraction - self.fraction;
        let resolution = 1e-12 + 4.0 * f64::EPSILON * (step.t.abs() / step.h);
        if apart.abs() <= resolution {
            self.all.push(index);
            self
        } else if apart < 0.0 {
            Found {
                fraction,
                index,
                slope: 0.0,
                all: vec![index],
            }
        } else {
            self
        }
    }
}
