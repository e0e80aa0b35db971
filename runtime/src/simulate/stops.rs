//! Samples at given times, each at the end of a step.

use super::accounting::Flow;
use crate::system::System;

/// What a trajectory was like at a time that was asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sample {
    /// The time in s.
    pub time: f64,
    /// The continuous state, in the order of [`System::states`].
    pub state: Vec<f64>,
    /// The outputs, in the order of [`System::output_variables`].
    pub outputs: Vec<f64>,
}

/// Times at which samples are taken, and those taken so far.
#[derive(Default)]
pub(super) struct Stops<'a> {
    /// Times to come, rising.
    times: &'a [f64],
    pub samples: Vec<Sample>,
}

impl<'a> Stops<'a> {
    pub fn at(times: &'a [f64]) -> Self {
        Self {
            times,
            samples: Vec::with_capacity(times.len()),
        }
    }

    /// The time of the next sample; infinity for none.
    pub fn next(&self) -> f64 {
        self.times.first().copied().unwrap_or(f64::INFINITY)
    }

    /// Takes the samples of time `t`, up to rounding; whether there are any.
    pub fn pass<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> bool {
        let now = t + 4.0 * f64::EPSILON * t.abs();
        let mut any = false;
        while let Some((&time, later)) = self.times.split_first()
            && time <= now
        {
            let state = flow.own(x).to_vec();
            let mut outputs = vec![0.0; flow.system.output_variables().len()];
            flow.system.outputs(t, &state, d, &flow.u, &mut outputs);
            self.samples.push(Sample {
                time,
                state,
                outputs,
            });
            self.times = later;
            any = true;
        }
        any
    }
}
