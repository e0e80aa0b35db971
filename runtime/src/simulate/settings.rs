//! What a run is asked to do, and whether that makes sense.

use super::breakdown::Breakdown;
use super::tolerance::StepControl;
use crate::system::Variable;

/// More rows than this are a slip of the pen: they would fill memory and disk.
const MOST_ROWS: f64 = 1e7;

/// What a run is asked to do.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    pub until: f64,
    pub accuracy: Accuracy,
    pub integrator: Integrator,
    pub absolute: Vec<(String, f64)>,
    pub longest_step: f64,
    pub most_steps: u64,
    pub every: Option<f64>,
    pub energy: bool,
    pub inputs: Vec<(usize, f64)>,
}

/// Which method takes adaptive steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// The explicit one, and the stiff one where stability would limit explicit steps and stiff
    /// ones get on faster.
    #[default]
    Automatic,
    /// Dormand and Prince's 8(5,3).
    Explicit,
    /// Rodas5P, with the exact Jacobian.
    Stiff,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Accuracy {
    /// Steps no longer than this, in s.
    Step(f64),
    /// Error per step relative to each state's excursion.
    Relative(f64),
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            until: 0.0,
            accuracy: Accuracy::Relative(1e-8),
            integrator: Integrator::Automatic,
            absolute: Vec::new(),
            longest_step: f64::INFINITY,
            most_steps: 100_000_000,
            every: None,
            energy: false,
            inputs: Vec::new(),
        }
    }
}

impl Settings {
    /// The step control for a relative tolerance, or what makes no sense about it.
    pub fn control(&self, rtol: f64, states: &[Variable]) -> Result<StepControl, Breakdown> {
        let (absolute, longest) = (&self.absolute, self.longest_step);
        StepControl::new(states, rtol, absolute, longest, self.until)
    }

    /// Values of the inputs, or what makes no sense about these settings.
    pub fn inputs(&self, variables: &[Variable]) -> Result<Vec<f64>, Breakdown> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if !(self.until >= 0.0 && self.until.is_finite()) {
            return Err(Breakdown::setting(
                format!("a run cannot end at t = {} s", self.until),
                "give an end time of zero or more",
            ));
        }
        if let Accuracy::Step(dt) = self.accuracy {
            if !positive(dt) {
                return Err(Breakdown::setting(
                    format!("the step cannot be {dt} s"),
                    "give a step longer than zero",
                ));
            }
            if self.until / dt > self.most_steps as f64 {
                return Err(Breakdown::setting(
                    format!(
                        "the run would take {:.1e} steps, more than {} are not allowed",
                        self.until / dt,
                        self.most_steps
                    ),
                    "give a longer step, or a tolerance instead of a step",
                ));
            }
        }
        if let Some(every) = self.every {
            if !positive(every) {
                return Err(Breakdown::setting(
                    format!("rows cannot be {every} s apart"),
                    "give an interval longer than zero",
                ));
            }
            if self.until / every > MOST_ROWS {
                return Err(Breakdown::setting(
                    format!(
                        "the run would have {:.1e} rows, more than {MOST_ROWS:.0e} are not allowed",
                        self.until / every
                    ),
                    "give a longer interval between rows, or an earlier end",
                ));
            }
        }
        if !(self.longest_step > 0.0) {
            return Err(Breakdown::setting(
                format!("the longest step cannot be {} s", self.longest_step),
                "give a longest step longer than zero",
            ));
        }
        let mut values: Vec<f64> = variables.iter().map(|v| v.start.unwrap_or(0.0)).collect();
        for &(index, value) in &self.inputs {
            let Some(place) = values.get_mut(index) else {
                return Err(Breakdown::setting(
                    format!("there is no input {index}"),
                    format!("the model has {} inputs, counted from 0", variables.len()),
                ));
            };
            if !value.is_finite() {
                return Err(Breakdown::setting(
                    format!("input `{}` cannot be {value}", variables[index].name),
                    "give a finite value",
                ));
            }
            *place = value;
        }
        Ok(values)
    }
}
