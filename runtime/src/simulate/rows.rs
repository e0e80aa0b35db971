//! From steps to the rows that a recorder gets.

use std::borrow::Cow;
use std::ops::ControlFlow;

use super::accounting::Flow;
use super::method::{Method, Step};
use super::recorder::{Heading, Recorder};
use crate::system::System;

const ENERGIES: [(&str, &str); 5] = [
    ("energy.kinetic", "kinetic energy"),
    (
        "energy.potential",
        "potential energy of springs, gravity and bristles",
    ),
    ("energy.dissipated", "energy turned to heat since the start"),
    ("energy.supplied", "energy brought in since the start"),
    (
        "energy.balance",
        "kinetic + potential - what they were at the start - supplied + dissipated",
    ),
];

/// Who gets rows, and how often.
pub(super) struct Recording<'a> {
    /// Nobody, or a recorder.
    pub recorder: Option<&'a mut dyn Recorder>,
    /// Interval in s; without it a row at the end of every step.
    pub every: Option<f64>,
}

/// Writes rows.
pub(super) struct Rows<'a> {
    recorder: Option<&'a mut dyn Recorder>,
    samples: Option<Samples>,
    /// Energy columns that are recorded.
    energies: Vec<usize>,
    outputs: usize,
    row: Vec<f64>,
    x: Vec<f64>,
    stored_at_start: f64,
    last_time: f64,
}

/// Rows at multiples of an interval.
struct Samples {
    interval: f64,
    next: f64,
    until: f64,
}

impl Samples {
    /// The time of the next row. A multiple that only rounding keeps from the end is the end.
    fn time(&self) -> f64 {
        let time = self.next * self.interval;
        if (time - self.until).abs() <= 1e-9 * self.interval {
            self.until
        } else {
            time
        }
    }
}

impl<'a> Rows<'a> {
    pub fn new(recording: Recording<'a>, width: usize, until: f64, stored_at_start: f64) -> Self {
        Self {
            recorder: recording.recorder,
            samples: recording.every.map(|interval| Samples {
                interval,
                next: 0.0,
                until,
            }),
            energies: Vec::new(),
            outputs: 0,
            row: Vec::new(),
            x: vec![0.0; width],
            stored_at_start,
            last_time: f64::NEG_INFINITY,
        }
    }

    /// Announces the columns.
    pub fn begin<S: System + ?Sized>(&mut self, flow: &Flow<'_, S>) {
        let Some(recorder) = &mut self.recorder else {
            return;
        };
        let system = flow.system;
        let mut headings = vec![Heading {
            name: Cow::Borrowed("t"),
            unit: Cow::Borrowed("s"),
            meaning: Cow::Borrowed("time"),
        }];
        let variables = system.states().iter().chain(system.output_variables());
        headings.extend(variables.map(|variable| Heading {
            name: variable.name.clone(),
            unit: variable.unit.clone(),
            meaning: variable.meaning.clone(),
        }));
        self.outputs = system.output_variables().len();
        if flow.accounts() {
            for (index, (name, meaning)) in ENERGIES.into_iter().enumerate() {
                if headings.iter().all(|heading| heading.name != name) {
                    self.energies.push(index);
                    headings.push(Heading {
                        name: Cow::Borrowed(name),
                        unit: Cow::Borrowed("J"),
                        meaning: Cow::Borrowed(meaning),
                    });
                }
            }
        }
        self.row = vec![0.0; headings.len()];
        recorder.begin(&headings);
    }

    /// The time of the next row: what a step passes before it is not recorded.
    pub fn due(&self) -> f64 {
        match (&self.recorder, &self.samples) {
            (None, _) => f64::INFINITY,
            (Some(_), None) => f64::NEG_INFINITY,
            (Some(_), Some(samples)) => samples.time(),
        }
    }

    /// Says how far the run is.
    pub fn progress(&mut self, t: f64) -> ControlFlow<()> {
        match &mut self.recorder {
            Some(recorder) => recorder.progress(t),
            None => ControlFlow::Continue(()),
        }
    }

    /// The row at the start.
    pub fn start<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> ControlFlow<()> {
        if let Some(samples) = &mut self.samples {
            samples.next = 1.0;
        }
        self.write(flow, t, x, d)
    }

    /// The rows at multiples of the interval within a step that ends at `end`.
    pub fn inside<S: System + ?Sized, M: Method>(
        &mut self,
        flow: &mut Flow<'_, S>,
        method: &mut M,
        step: &Step<'_>,
        end: f64,
    ) -> ControlFlow<()> {
        let mut is_ready = false;
        while let Some(time) = self.samples.as_ref().map(Samples::time)
            && time <= end
        {
            let mut x = std::mem::take(&mut self.x);
            if time == end {
                x.copy_from_slice(step.x_end);
            } else {
                if !is_ready {
                    method.prepare(flow, step);
                    is_ready = true;
                }
                let fraction = ((time - step.t) / step.h).clamp(0.0, 1.0);
                method.interpolate(step, fraction, &mut x);
            }
            let written = self.write(flow, time, &x, step.d);
            self.x = x;
            written?;
            if let Some(samples) = &mut self.samples {
                samples.next += 1.0;
            }
        }
        ControlFlow::Continue(())
    }

    /// The row at the end of a step, where every step has one.
    pub fn step_end<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> ControlFlow<()> {
        if self.samples.is_some() {
            return ControlFlow::Continue(());
        }
        self.write(flow, t, x, d)
    }

    /// The row at the end of the run, if it is not there yet.
    pub fn end<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> ControlFlow<()> {
        if self.last_time == t {
            return ControlFlow::Continue(());
        }
        self.write(flow, t, x, d)
    }

    fn write<S: System + ?Sized>(
        &mut self,
        flow: &Flow<'_, S>,
        t: f64,
        x: &[f64],
        d: &[f64],
    ) -> ControlFlow<()> {
        let Some(recorder) = &mut self.recorder else {
            return ControlFlow::Continue(());
        };
        let own = flow.own(x);
        let (time, rest) = self.row.split_at_mut(1);
        let (states, rest) = rest.split_at_mut(own.len());
        let (outputs, energies) = rest.split_at_mut(self.outputs);
        time[0] = t;
        states.copy_from_slice(own);
        flow.system.outputs(t, own, d, &flow.u, outputs);
        if flow.accounts() {
            let energy = flow.energy(t, x, d);
            let (dissipated, supplied) = flow.accounted(x);
            let gained = energy.kinetic + energy.potential - self.stored_at_start;
            let all = [
                energy.kinetic,
                energy.potential,
                dissipated,
                supplied,
                gained - supplied + dissipated,
            ];
            for (place, &index) in energies.iter_mut().zip(&self.energies) {
                *place = all[index];
            }
        }
        self.last_time = t;
        recorder.row(&self.row)
    }
}
