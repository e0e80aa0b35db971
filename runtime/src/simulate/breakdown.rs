//! Why a run could not be followed to its end, in words for an engineer.

use std::error::Error;
use std::fmt;

use super::run::{Run, Summary};
use crate::diagnostic::Diagnostic;
use crate::failure::{Unit, quantity};
use crate::system::System;

/// A run that failed: why, and what there is of it.
#[derive(Clone, Debug)]
pub struct RunFailure {
    /// Why, when and where.
    pub breakdown: Box<Breakdown>,
    /// The run until then.
    pub run: Box<Run>,
}

/// Why, when and where a run came to a halt.
#[derive(Clone, Debug, PartialEq)]
pub struct Breakdown {
    /// Of what kind.
    pub kind: BreakdownKind,
    /// When, in s.
    pub time: f64,
    /// The continuous state at that time.
    pub state: Vec<f64>,
    /// What happened: one line, lower case, names in backticks, no full stop.
    pub message: String,
    /// What would mend it.
    pub hint: Option<String>,
}

/// Kinds of breakdowns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BreakdownKind {
    /// A setting makes no sense; nothing was run.
    Setting,
    /// A loop of the mechanism came to where it can no longer close, by its position among the
    /// system's loops.
    DeadPoint(usize),
    /// Some quantity left the range of numbers.
    NotFinite,
    /// A body turned by more than a quarter turn within one fixed step, by the position of its
    /// angle in the discrete state.
    Turned(usize),
    /// The motion changes faster than any step can follow.
    StepTooShort,
    /// More steps than allowed.
    TooManySteps,
    /// More rows than fit into memory.
    TooManyRows,
    /// An event follows itself at ever shorter intervals, by its position.
    Chatter(usize),
    /// A drive's kinks follow each other faster than time can tell apart, by its position.
    CrowdedKinks(usize),
}

/// Where a run stands: what the words need.
pub(super) struct Place<'a, S: ?Sized> {
    pub system: &'a S,
    pub time: f64,
    pub state: &'a [f64],
}

impl Breakdown {
    pub(super) fn setting(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self {
            kind: BreakdownKind::Setting,
            time: 0.0,
            state: Vec::new(),
            message: message.into(),
            hint: Some(hint.into()),
        }
    }

    pub(super) fn too_many_rows(summary: &Summary) -> Self {
        Self {
            kind: BreakdownKind::TooManyRows,
            time: summary.end,
            state: summary.state.clone(),
            message: format!("at t = {} the rows fill the memory", seconds(summary.end)),
            hint: Some("record rows at longer intervals".to_owned()),
        }
    }

    pub(super) fn at<S: System + ?Sized>(place: &Place<'_, S>, kind: BreakdownKind) -> Self {
        let system = place.system;
        let when = seconds(place.time);
        let there = configuration(place);
        let (message, hint) = match kind {
            BreakdownKind::DeadPoint(index) => (
                format!(
                    "at t = {when} the loop `{}` cannot be closed any further: it reaches a dead point",
                    system.loop_name(index)
                ),
                format!(
                    "it stands at {there} there; limit the motion, or change lengths so that the loop stays away from its dead point"
                ),
            ),
            BreakdownKind::Turned(index) => (
                format!(
                    "at t = {when} `{}` turns by more than a quarter turn in one step",
                    name(system.discretes(), index)
                ),
                "take a shorter step, or a tolerance instead of a step".to_owned(),
            ),
            BreakdownKind::StepTooShort => (
                format!("at t = {when} the motion changes faster than any step can follow"),
                format!(
                    "it stands at {there} there; look for a force that jumps or grows without bound"
                ),
            ),
            BreakdownKind::TooManySteps => (
                format!("at t = {when} all steps allowed are spent"),
                "allow more steps, or a wider tolerance; a stiff contact or spring takes many"
                    .to_owned(),
            ),
            BreakdownKind::Chatter(index) => (
                format!(
                    "at t = {when} the event `{}` follows itself at ever shorter intervals",
                    system.event_name(index)
                ),
                "give the contact or stop some compliance, so that it comes to rest".to_owned(),
            ),
            BreakdownKind::CrowdedKinks(_) => (
                format!("at t = {when} the kinks of a drive follow each other too fast"),
                "lower the drive's frequency, or make its ramps longer".to_owned(),
            ),
            BreakdownKind::NotFinite => (
                format!("at t = {when} the motion leaves the range of numbers"),
                format!(
                    "it stands at {there} there; a shorter step or a tolerance helps if the motion is sound, else look for a zero mass or stiffness"
                ),
            ),
            BreakdownKind::Setting | BreakdownKind::TooManyRows => (String::new(), String::new()),
        };
        Self {
            kind,
            time: place.time,
            state: place.state.to_vec(),
            message,
            hint: Some(hint),
        }
    }

    /// As any other error of a model.
    pub fn diagnostic(&self) -> Diagnostic {
        let diagnostic = Diagnostic::error(self.message.clone());
        match &self.hint {
            Some(hint) => diagnostic.hint(hint.clone()),
            None => diagnostic,
        }
    }
}

impl RunFailure {
    pub(super) fn new(breakdown: Breakdown, run: Run) -> Self {
        Self {
            breakdown: Box::new(breakdown),
            run: Box::new(run),
        }
    }
}

impl fmt::Display for Breakdown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostic().fmt(f)
    }
}

impl fmt::Display for RunFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.breakdown.fmt(f)
    }
}

impl Error for Breakdown {}
impl Error for RunFailure {}

fn seconds(time: f64) -> String {
    quantity(time, Unit::Other("s"))
}

fn name(variables: &[crate::system::Variable], index: usize) -> &str {
    variables.get(index).map_or("a body", |v| v.name.as_ref())
}

/// The first few states with their values.
fn configuration<S: System + ?Sized>(place: &Place<'_, S>) -> String {
    const SHOWN: usize = 6;
    let states = place.system.states();
    let mut words: Vec<String> = states
        .iter()
        .zip(place.state)
        .take(SHOWN)
        .map(|(variable, value)| {
            let shown = match variable.unit.as_ref() {
                "1" => quantity(*value, Unit::Number),
                "rad" => quantity(*value, Unit::Degree),
                "m" => quantity(*value, Unit::Metre),
                unit => format!("{} {unit}", quantity(*value, Unit::Number)),
            };
            format!("{} = {shown}", variable.name)
        })
        .collect();
    if states.len() > SHOWN {
        words.push("…".to_owned());
    }
    words.join(", ")
}
