//! How large an error a step may have, and how long the next step should be.

use super::breakdown::Breakdown;
use crate::real::Real;
use crate::system::Variable;

/// Steps grow by this factor at most.
const LARGEST_GROWTH: f64 = 6.0;
/// Steps shrink to this at most, for want of accuracy.
const LARGEST_CUT: f64 = 0.2;
/// The share of the step that just meets the tolerance.
const SAFETY: f64 = 0.9;
/// Exponent of the error of the step before, in proportional–integral control.
const MEMORY: f64 = 0.02;

/// Proportional–integral step control with scales that follow the motion.
pub(super) struct StepControl {
    pub relative: f64,
    pub longest: f64,
    /// Length wanted for the next step.
    pub wanted: f64,
    /// Logarithm of the error of the last accepted step.
    pub memory: f64,
    /// Whether the last step was rejected.
    pub was_rejected: bool,
    pub states: Vec<Tolerated>,
    /// Allowed errors for the step being judged.
    allowed: Vec<f64>,
}

/// What the tolerance of one state rests on.
#[derive(Clone)]
pub(super) struct Tolerated {
    /// Tolerance given by the user; zero for none.
    absolute: f64,
    /// This share of the state itself counts as an excursion.
    share: f64,
    /// Value at the start of the run.
    pub start: f64,
    /// Largest excursion from it so far.
    pub excursion: f64,
    /// The excursion counts up to this.
    most: f64,
    /// The excursion counts as this at least.
    least: f64,
}

impl StepControl {
    pub fn new(
        states: &[Variable],
        relative: f64,
        absolute: &[(String, f64)],
        longest: f64,
        until: f64,
    ) -> Result<Self, Breakdown> {
        if !(1e-13..=0.1).contains(&relative) {
            return Err(Breakdown::setting(
                format!("the relative tolerance cannot be {relative}"),
                "give one between 1e-13 and 0.1",
            ));
        }
        let mut tolerated: Vec<Tolerated> = states.iter().map(Tolerated::new).collect();
        for (name, tolerance) in absolute {
            let Some(index) = states.iter().position(|state| state.name == *name) else {
                let names: Vec<&str> = states.iter().map(|state| state.name.as_ref()).collect();
                return Err(Breakdown::setting(
                    format!("there is no state `{name}` to give a tolerance"),
                    format!("the states are {}", names.join(", ")),
                ));
            };
            if !(*tolerance > 0.0 && tolerance.is_finite()) {
                return Err(Breakdown::setting(
                    format!("the tolerance of `{name}` cannot be {tolerance}"),
                    "give one above zero",
                ));
            }
            tolerated[index].within(*tolerance);
        }
        Ok(Self {
            relative,
            longest,
            wanted: longest.min(until),
            memory: least_memory(),
            was_rejected: false,
            allowed: vec![0.0; states.len()],
            states: tolerated,
        })
    }

    /// Takes the run's start.
    pub fn start(&mut self, x: &[f64], first_break: f64) {
        for (state, &x) in self.states.iter_mut().zip(x) {
            state.start = x;
        }
        // Whatever is too long is rejected; nothing that happens in the first stretch is missed.
        self.wanted = self.longest.min(1e-4 * first_break);
    }

    /// The error that each state may have in a step to `x_end`.
    pub fn allowed(&mut self, x: &[f64], x_end: &[f64]) -> &[f64] {
        for (i, (allowed, state)) in self.allowed.iter_mut().zip(&self.states).enumerate() {
            let excursion = excursion_at(state.start, state.excursion, x_end[i]);
            *allowed = state.allowed(self.relative, excursion, x[i], x_end[i]);
        }
        &self.allowed
    }

    /// The errors that were allowed in the step that was judged last.
    pub fn judged_by(&self) -> &[f64] {
        &self.allowed
    }

    /// The next step's length after one of length `h` whose error, of `order` in the step, was
    /// acceptable.
    pub fn accepted(&mut self, h: f64, error_squared: f64, order: f64, x_end: &[f64]) {
        for (state, &x) in self.states.iter_mut().zip(x_end) {
            state.excursion = excursion_at(state.start, state.excursion, x);
        }
        let most = growth_limit(if self.was_rejected { 1.0 } else { -1.0 });
        let logarithm = 0.5 * Real::ln(error_squared);
        let logarithms = [logarithm, self.memory];
        self.wanted = length_after(h, logarithms, order, most, self.wanted, self.longest);
        self.memory = remembered(logarithm);
        self.was_rejected = false;
    }

    /// After a step of length `h` whose error, of `order` in the step, was too large.
    pub fn too_inaccurate(&mut self, h: f64, error_squared: f64, order: f64) {
        self.cut(h, share_of_rejected(0.5 * Real::ln(error_squared), order));
    }

    /// After a step of length `h` that cannot be taken at all.
    pub fn cut(&mut self, h: f64, factor: f64) {
        self.wanted = h * factor;
        self.was_rejected = true;
    }

    /// Forgets what the last step taught: the motion goes on differently.
    pub fn restart(&mut self, longest: f64) {
        self.wanted = self.wanted.min(longest);
        self.memory = least_memory();
    }
}

/// No step is shorter, at `t` of a run until `until`.
#[inline(always)]
pub(super) fn shortest_step<T: Real>(t: T, until: T) -> T {
    t.abs() * (8.0 * f64::EPSILON) + until * 1e-18
}

/// The largest factor by which a step may grow, after a rejected one if that is positive.
#[inline(always)]
pub(super) fn growth_limit<T: Real>(was_rejected: T) -> T {
    was_rejected.if_positive(T::from_f64(1.0), T::from_f64(LARGEST_GROWTH))
}

/// The length wanted after an accepted step of length `h`, given the logarithms of its error and
/// of the error of the step before, which are of `order` in the step.
#[inline(always)]
pub(super) fn length_after<T: Real>(
    h: T,
    [error, last_error]: [T; 2],
    order: f64,
    most: T,
    wanted: T,
    longest: T,
) -> T {
    // Products of powers, by logarithms: of an error of zero as well.
    let growth = last_error * MEMORY - error * (order.recip() - 0.2 * MEMORY);
    let growth = growth.exp() * SAFETY;
    let grown = h * growth.larger(T::from_f64(LARGEST_CUT)).smaller(most);
    // A step cut short by a break says little about what is possible behind it.
    (wanted * 0.99 - h)
        .if_positive(grown.larger(wanted), grown)
        .smaller(longest)
}

/// The logarithm of the error of an accepted step as the next one's control sees it.
#[inline(always)]
pub(super) fn remembered<T: Real>(logarithm: T) -> T {
    logarithm.larger(T::from_f64(least_memory()))
}

/// What is remembered of a step that was hardly a challenge, or of none.
#[inline(always)]
fn least_memory() -> f64 {
    -4.0 * std::f64::consts::LN_10
}

/// The largest excursion from `start`, which was `excursion`, with one to `x`.
#[inline(always)]
pub(super) fn excursion_at<T: Real>(start: T, excursion: T, x: T) -> T {
    excursion.larger((x - start).abs())
}

/// The share of a step whose error, of this logarithm and of `order` in the step, was too large
/// that is tried next.
#[inline(always)]
pub(super) fn share_of_rejected<T: Real>(logarithm: T, order: f64) -> T {
    let share = (logarithm * -order.recip()).exp() * SAFETY;
    share
        .larger(T::from_f64(LARGEST_CUT))
        .smaller(T::from_f64(0.9))
}

impl Tolerated {
    /// The error that a step from `x` to `x_end` may have, with that one's excursion.
    #[inline(always)]
    pub fn allowed<T: Real>(&self, relative: f64, excursion: T, x: T, x_end: T) -> T {
        let size = x.abs().larger(x_end.abs());
        let scale = excursion.smaller(T::from_f64(self.most));
        let scale = scale.larger(size * self.share);
        scale.larger(T::from_f64(self.least)) * relative + self.absolute
    }

    /// Holds the error below `tolerance` plus the relative tolerance times the state's size.
    fn within(&mut self, tolerance: f64) {
        self.absolute = tolerance;
        (self.most, self.least, self.share) = (0.0, 0.0, 1.0);
    }

    fn new(state: &Variable) -> Self {
        let (most, least) = match state.unit.as_ref() {
            "rad" => (1.0, 1e-9),
            "rad/s" | "m/s" => (f64::INFINITY, 1e-6),
            _ => (f64::INFINITY, 1e-12),
        };
        Self {
            absolute: 0.0,
            share: 1e-6,
            start: 0.0,
            excursion: 0.0,
            most,
            least,
        }
    }
}
