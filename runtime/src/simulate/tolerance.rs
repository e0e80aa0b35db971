//! How large an error a step may have, and how long the next step should be.

use super::breakdown::Breakdown;
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
    relative: f64,
    longest: f64,
    /// Length wanted for the next step.
    pub wanted: f64,
    /// Error of the last accepted step.
    last_error: f64,
    /// Whether the last step was rejected.
    was_rejected: bool,
    states: Vec<Tolerated>,
    /// Allowed errors for the step being judged.
    allowed: Vec<f64>,
}

/// What the tolerance of one state rests on.
struct Tolerated {
    /// Tolerance given by the user.
    absolute: Option<f64>,
    /// Value at the start of the run.
    start: f64,
    /// Largest excursion from it so far.
    excursion: f64,
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
            tolerated[index].absolute = Some(*tolerance);
        }
        Ok(Self {
            relative,
            longest,
            wanted: longest.min(until),
            last_error: 1e-4,
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
            let size = x[i].abs().max(x_end[i].abs());
            *allowed = match state.absolute {
                Some(absolute) => absolute + self.relative * size,
                None => {
                    let excursion = state.excursion.max((x_end[i] - state.start).abs());
                    self.relative * excursion.min(state.most).max(1e-6 * size).max(state.least)
                }
            };
        }
        &self.allowed
    }

    /// The errors that were allowed in the step that was judged last.
    pub fn judged_by(&self) -> &[f64] {
        &self.allowed
    }

    /// The next step's length after one of length `h` whose error, of `order` in the step, was
    /// acceptable.
    pub fn accepted(&mut self, h: f64, error: f64, order: f64, x_end: &[f64]) {
        for (state, &x) in self.states.iter_mut().zip(x_end) {
            state.excursion = state.excursion.max((x - state.start).abs());
        }
        let proportional = error.powf(-(order.recip() - 0.2 * MEMORY));
        let growth = SAFETY * proportional * self.last_error.powf(MEMORY);
        let growth = growth.clamp(
            LARGEST_CUT,
            if self.was_rejected {
                1.0
            } else {
                LARGEST_GROWTH
            },
        );
        // A step cut short by a break says little about what is possible behind it.
        let grown = h * growth;
        self.wanted = if h < 0.99 * self.wanted {
            grown.max(self.wanted)
        } else {
            grown
        }
        .min(self.longest);
        self.last_error = error.max(1e-4);
        self.was_rejected = false;
    }

    /// After a step of length `h` whose error, of `order` in the step, was too large.
    pub fn too_inaccurate(&mut self, h: f64, error: f64, order: f64) {
        let factor = SAFETY * error.powf(-order.recip());
        self.cut(h, factor.clamp(LARGEST_CUT, 0.9));
    }

    /// After a step of length `h` that cannot be taken at all.
    pub fn cut(&mut self, h: f64, factor: f64) {
        self.wanted = h * factor;
        self.was_rejected = true;
    }

    /// Forgets what the last step taught: the motion goes on differently.
    pub fn restart(&mut self, longest: f64) {
        self.wanted = self.wanted.min(longest);
        self.last_error = 1e-4;
    }
}

impl Tolerated {
    fn new(state: &Variable) -> Self {
        let (most, least) = match state.unit.as_ref() {
            "rad" => (1.0, 1e-9),
            "rad/s" | "m/s" => (f64::INFINITY, 1e-6),
            _ => (f64::INFINITY, 1e-12),
        };
        Self {
            absolute: None,
            start: 0.0,
            excursion: 0.0,
            most,
            least,
        }
    }
}
