//! A run from its start to its end, step by step.
//!
//! A walk stands at a time with a state, the rates there, and the values of all event functions.
//! Each round it chooses a step that ends at or before the next break (the end of the run, a kink
//! of a drive), tries it, shortens it to the first event that it ran into, records the rows inside
//! it, moves on, and passes the events and kinks where it then stands.

use std::ops::ControlFlow;

use super::accounting::Flow;
use super::breakdown::{Breakdown, BreakdownKind, Place};
use super::crossing::{Crossings, Found};
use super::dead_point::Approach;
use super::method::{Method, Step};
use super::pace::{Pace, Trial};
use super::rows::{Recording, Rows};
use super::run::{Ending, EventRecord, Summary};
use super::stops::{Sample, Stops};
use crate::real::Real;
use crate::system::{EventAction, System};

/// Steps between two reports of progress.
const PROGRESS_INTERVAL: u64 = 256;
/// Events that are remembered one by one.
const MOST_RECORDS: usize = 100_000;
/// Kinks of one drive, or jumps from event to event, at one instant.
const MOST_AT_ONCE: usize = 1000;
/// A body may turn by this in a step.
pub(super) const QUARTER_TURN: f64 = std::f64::consts::FRAC_PI_2;

/// A run under way.
pub(super) struct Walk<'a, S: System + ?Sized, M> {
    pub flow: Flow<'a, S>,
    method: M,
    pub pace: Pace,
    pub until: f64,
    rows: Rows<'a>,
    stops: Stops<'a>,
    pub crossings: Crossings,
    pub approach: Approach,
    /// Half of a step that a loop did not allow, where steps are equal ones.
    shortened: f64,
    /// Where it stands.
    pub t: f64,
    pub x: Vec<f64>,
    pub d: Vec<f64>,
    /// Rates there.
    pub f: Vec<f64>,
    /// Where the step that is tried ends.
    x_end: Vec<f64>,
    d_end: Vec<f64>,
    f_end: Vec<f64>,
    /// The next kink of each drive.
    kinks: Vec<f64>,
    /// Steps tried, and how many may be.
    pub tried: u64,
    pub most_steps: u64,
    pub summary: Summary,
}

/// Why a step cannot be accepted.
enum Rejection {
    TooInaccurate(f64),
    NotFinite,
    Turned(usize),
}

/// Where a run ends before its time.
pub(super) enum Halt {
    Ending(Ending),
    Breakdown(BreakdownKind),
}

impl From<BreakdownKind> for Halt {
    fn from(kind: BreakdownKind) -> Self {
        Halt::Breakdown(kind)
    }
}

/// A recorder that breaks off ends the run.
fn recorded(flow: ControlFlow<()>) -> Result<(), Halt> {
    match flow {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Halt::Ending(Ending::Interrupted)),
    }
}

/// No step is shorter, at `t` of a run until `until`.
#[inline(always)]
pub(super) fn shortest_step<T: Real>(t: T, until: T) -> T {
    t.abs() * (8.0 * f64::EPSILON) + until * 1e-18
}

fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

impl<'a, S: System + ?Sized, M: Method> Walk<'a, S, M> {
    pub fn new(
        flow: Flow<'a, S>,
        method: M,
        pace: Pace,
        until: f64,
        rows: Recording<'a>,
        most_steps: u64,
    ) -> Self {
        let width = flow.width();
        let system = flow.system;
        let mut x = vec![0.0; width];
        let mut d = vec![0.0; system.discretes().len()];
        system.start(&mut x[..flow.states], &mut d);
        Self {
            method,
            pace,
            until,
            rows: Rows::new(rows, width, until, flow.stored(0.0, &x, &d)),
            stops: Stops::default(),
            crossings: Crossings::new(system.event_count(), width),
            approach: Approach::new(system.loop_count()),
            shortened: f64::INFINITY,
            t: 0.0,
            f: vec![0.0; width],
            x_end: vec![0.0; width],
            d_end: d.clone(),
            f_end: vec![0.0; width],
            kinks: vec![f64::INFINITY; system.kink_count()],
            tried: 0,
            most_steps,
            summary: Summary::default(),
            x,
            d,
            flow,
        }
    }

    /// The same, with steps that end exactly at each of these times, where samples are taken.
    pub fn stopping(mut self, times: &'a [f64]) -> Self {
        self.stops = Stops::at(times);
        self
    }

    /// Goes to the end, and says how it went and what stopped it, if anything did.
    pub fn run(mut self) -> (Summary, Option<Breakdown>) {
        self.rows.begin(&self.flow);
        let went = self.go();
        let (summary, breakdown, _) = self.leave(went);
        (summary, breakdown)
    }

    /// How it went, what stopped it, if anything did, and the samples taken.
    pub fn leave(mut self, went: Result<(), Halt>) -> (Summary, Option<Breakdown>, Vec<Sample>) {
        let halt = match went {
            Ok(()) => Halt::Ending(Ending::Complete),
            Err(halt) => halt,
        };
        let (ending, breakdown) = match halt {
            Halt::Ending(ending) => (ending, None),
            Halt::Breakdown(kind) => {
                let place = Place {
                    system: self.flow.system,
                    time: self.t,
                    state: self.flow.own(&self.x),
                };
                (Ending::Failed, Some(Breakdown::at(&place, kind)))
            }
        };
        self.summary.end = self.t;
        self.summary.ending = ending;
        self.summary.statistics.evaluations = self.flow.evaluations;
        self.summary.state = self.flow.own(&self.x).to_vec();
        self.summary.discrete = self.d;
        (self.summary, breakdown, self.stops.samples)
    }

    fn go(&mut self) -> Result<(), Halt> {
        self.begin()?;
        while !self.is_over() {
            self.round()?;
        }
        recorded(self.rows.end(&self.flow, self.t, &self.x, &self.d))
    }

    /// Stands at the start, behind the kinks that are there.
    pub fn begin(&mut self) -> Result<(), Halt> {
        if !all_finite(&self.x) {
            return Err(BreakdownKind::NotFinite.into());
        }
        self.crossings.stand(&self.flow, self.t, &self.x, &self.d);
        if !self.pass_kinks()? {
            self.rates()?;
        }
        self.stops.pass(&self.flow, self.t, &self.x, &self.d);
        let first_break = self.next_break() - self.t;
        if let Pace::Adaptive(control) = &mut self.pace {
            control.start(self.flow.own(&self.x), first_break);
        }
        recorded(self.rows.start(&self.flow, self.t, &self.x, &self.d))?;
        self.watch_loops()
    }

    /// Whether it has come to its end.
    pub fn is_over(&self) -> bool {
        !(self.t < self.until)
    }

    /// Tries one step.
    pub fn round(&mut self) -> Result<(), Halt> {
        if self.tried >= self.most_steps {
            return Err(BreakdownKind::TooManySteps.into());
        }
        self.tried += 1;
        if self.tried.is_multiple_of(PROGRESS_INTERVAL) {
            recorded(self.rows.progress(self.t))?;
        }
        let longest = self.approach.longest_step().min(self.shortened);
        let trial = self.pace.next(self.t, self.next_break(), longest);
        match self.attempt(trial) {
            Ok(error) => self.accept(trial, error),
            Err(rejection) => self.reject(trial, &rejection),
        }
    }

    /// The time of the next kink, of the next sample or of the end.
    pub fn next_break(&self) -> f64 {
        let end = self.until.min(self.stops.next());
        self.kinks.iter().copied().fold(end, f64::min)
    }

    /// Takes the values of the event functions where it has been put.
    pub fn stand(&mut self) {
        self.crossings.stand(&self.flow, self.t, &self.x, &self.d);
    }

    /// Whether nothing that is under way asks for more than plain steps.
    pub fn is_quiet(&self) -> bool {
        self.shortened == f64::INFINITY && self.crossings.are_quiet()
    }

    /// Takes a step to `x_end`, `d_end`, `f_end`; its error in units of what is allowed.
    fn attempt(&mut self, trial: Trial) -> Result<f64, Rejection> {
        self.method.step(
            &mut self.flow,
            self.t,
            trial.h,
            &self.x,
            &self.f,
            &self.d,
            &mut self.x_end,
        );
        if !all_finite(&self.x_end) {
            return Err(Rejection::NotFinite);
        }
        let mut error = 0.0;
        if let Pace::Adaptive(control) = &mut self.pace {
            let states = self.flow.states;
            let allowed = control.allowed(&self.x[..states], &self.x_end[..states]);
            error = self.method.error(trial.h, allowed);
            if error.is_nan() {
                return Err(Rejection::NotFinite);
            }
            if error > 1.0 {
                return Err(Rejection::TooInaccurate(error));
            }
        }
        self.finish(trial.end)?;
        Ok(error)
    }

    /// Discrete state and rates at the end of a step.
    fn finish(&mut self, end: f64) -> Result<(), Rejection> {
        self.d_end.copy_from_slice(&self.d);
        let system = self.flow.system;
        system.accept(
            end,
            self.flow.own(&self.x_end),
            &self.flow.u,
            &mut self.d_end,
        );
        for &index in system.turning() {
            let turn = (self.d_end[index] - self.d[index]).abs();
            if turn.is_nan() {
                return Err(Rejection::NotFinite);
            }
            if turn > QUARTER_TURN {
                return Err(Rejection::Turned(index));
            }
        }
        self.flow
            .rates(end, &self.x_end, &self.d_end, &mut self.f_end);
        if all_finite(&self.f_end) {
            Ok(())
        } else {
            Err(Rejection::NotFinite)
        }
    }

    fn reject(&mut self, trial: Trial, rejection: &Rejection) -> Result<(), Halt> {
        self.summary.statistics.rejected += 1;
        let shortest = shortest_step(self.t, self.until);
        let control = match &mut self.pace {
            Pace::Adaptive(control) => control,
            Pace::Fixed(_) => {
                let kind = match rejection {
                    Rejection::Turned(index) => BreakdownKind::Turned(*index),
                    _ => self.not_finite(trial.h),
                };
                self.shortened = 0.5 * trial.h;
                let may_be_nearer = matches!(kind, BreakdownKind::DeadPoint(_));
                return if may_be_nearer && self.shortened >= shortest {
                    Ok(())
                } else {
                    Err(kind.into())
                };
            }
        };
        match rejection {
            Rejection::TooInaccurate(error) => {
                control.too_inaccurate(trial.h, *error, self.method.order());
            }
            Rejection::NotFinite => control.cut(trial.h, 0.25),
            Rejection::Turned(_) => control.cut(trial.h, 0.5),
        }
        if control.wanted >= shortest {
            return Ok(());
        }
        Err(match rejection {
            Rejection::NotFinite => self.not_finite(trial.h),
            _ => BreakdownKind::StepTooShort,
        }
        .into())
    }

    /// Why there is no finite number ahead: the loop that comes to its dead point, if one does.
    fn not_finite(&mut self, h: f64) -> BreakdownKind {
        let system = self.flow.system;
        let mut closures = vec![0.0; system.loop_count()];
        let mut lowest: Option<(usize, f64)> = None;
        for ahead in [0.0, 0.5 * h, h] {
            for i in 0..self.x.len() {
                self.x_end[i] = self.x[i] + ahead * self.f[i];
            }
            if !all_finite(&self.x_end) {
                continue;
            }
            let x = self.flow.own(&self.x_end);
            system.closures(self.t + ahead, x, &self.d, &self.flow.u, &mut closures);
            for (index, &closure) in closures.iter().enumerate() {
                let closure = if closure.is_nan() { 0.0 } else { closure };
                if lowest.is_none_or(|(_, least)| closure < least) {
                    lowest = Some((index, closure));
                }
            }
        }
        match lowest {
            Some((index, closure)) if closure < 0.05 => BreakdownKind::DeadPoint(index),
            _ => BreakdownKind::NotFinite,
        }
    }

    /// Moves on to the end of a step that was found good, or to the first event in it.
    fn accept(&mut self, trial: Trial, error: f64) -> Result<(), Halt> {
        let step = Step {
            t: self.t,
            h: trial.h,
            x: &self.x,
            f: &self.f,
            d: &self.d,
            x_end: &self.x_end,
            f_end: &self.f_end,
        };
        let found = self.crossings.find(&mut self.flow, &mut self.method, &step);
        let taken = match &found {
            None => trial,
            Some(found) => self.shorten(trial, found)?,
        };
        let step = Step {
            t: self.t,
            h: taken.h,
            x: &self.x,
            f: &self.f,
            d: &self.d,
            x_end: &self.x_end,
            f_end: &self.f_end,
        };
        recorded(
            self.rows
                .inside(&mut self.flow, &mut self.method, &step, taken.end),
        )?;
        self.summary.statistics.accepted += 1;
        let is_outside = self
            .flow
            .system
            .is_outside_tables(self.flow.own(&self.x_end));
        self.summary.statistics.outside_tables += u64::from(is_outside);
        self.summary.statistics.stiff += u64::from(self.method.is_stiff());
        if let Pace::Adaptive(control) = &mut self.pace {
            let order = self.method.order();
            control.accepted(taken.h, error, order, self.flow.own(&self.x_end));
            if let Some(longest) = self.method.accepted(&step, control.judged_by()) {
                control.restart(longest);
            }
        }
        self.t = taken.end;
        std::mem::swap(&mut self.x, &mut self.x_end);
        std::mem::swap(&mut self.d, &mut self.d_end);
        std::mem::swap(&mut self.f, &mut self.f_end);
        self.crossings.stand(&self.flow, self.t, &self.x, &self.d);
        recorded(self.rows.step_end(&self.flow, self.t, &self.x, &self.d))?;
        self.shortened = f64::INFINITY;
        self.watch_loops()?;
        let happened = found.is_some();
        if let Some(found) = found {
            self.happen(found.all)?;
            self.pace.restart(0.25 * trial.h);
            recorded(self.rows.step_end(&self.flow, self.t, &self.x, &self.d))?;
        }
        self.arrive(happened)
    }

    /// Takes a sample and passes kinks, if there are any where the walk stands; events that
    /// happened may have moved kinks.
    pub fn arrive(&mut self, happened: bool) -> Result<(), Halt> {
        let sampled = self.stops.pass(&self.flow, self.t, &self.x, &self.d);
        if sampled {
            self.pace.stop_over();
        }
        if !self.is_over() && (happened || sampled || self.t >= self.next_break()) {
            self.pass_kinks()?;
        }
        Ok(())
    }

    /// Ends the run where a loop comes to its dead point.
    fn watch_loops(&mut self) -> Result<(), Halt> {
        let x = self.flow.own(&self.x);
        self.approach
            .stand(self.flow.system, self.t, x, &self.d, &self.flow.u);
        match self.approach.reached() {
            Some((index, left)) => {
                self.t = (self.t + left).min(self.next_break());
                Err(BreakdownKind::DeadPoint(index).into())
            }
            None => Ok(()),
        }
    }

    /// Takes the step again, to end at the event: the dense output says where, Newton's method on
    /// the steps' own ends the rest.
    fn shorten(&mut self, trial: Trial, found: &Found) -> Result<Trial, Halt> {
        let mut values = vec![0.0; self.flow.system.event_count()];
        let mut h = found.fraction * trial.h;
        for _ in 0..4 {
            self.method.step(
                &mut self.flow,
                self.t,
                h,
                &self.x,
                &self.f,
                &self.d,
                &mut self.x_end,
            );
            self.flow.system.events(
                self.t + h,
                self.flow.own(&self.x_end),
                &self.d,
                &self.flow.u,
                &mut values,
            );
            let correction = -values[found.index] / found.slope;
            let is_settled = correction.abs() <= 1e-14 * trial.h + f64::EPSILON * self.t.abs();
            // A touch without a slope has no better place.
            if !(found.slope > 0.0) || is_settled || !(correction.abs() < 1e-3 * trial.h) {
                break;
            }
            h = (h + correction).clamp(0.0, trial.h);
        }
        let trial = Trial {
            h,
            end: (self.t + h).min(trial.end),
        };
        match self.finish(trial.end) {
            Ok(()) => Ok(trial),
            Err(_) => Err(self.not_finite(h).into()),
        }
    }

    /// Passes events where the walk stands, and those that they bring about at once.
    fn happen(&mut self, mut events: Vec<usize>) -> Result<(), Halt> {
        let mut rounds = 0;
        while !events.is_empty() {
            rounds += 1;
            for index in events {
                if self.crossings.happens(index, self.t) || rounds > MOST_AT_ONCE {
                    return Err(BreakdownKind::Chatter(index).into());
                }
                self.summary.statistics.events += 1;
                if self.summary.events.len() < MOST_RECORDS {
                    self.summary.events.push(EventRecord {
                        time: self.t,
                        index,
                    });
                }
                let before = self.flow.stored(self.t, &self.x, &self.d);
                let action = self.flow.system.pass_event(
                    index,
                    self.t,
                    &mut self.x[..self.flow.states],
                    &mut self.d,
                    &self.flow.u,
                );
                let after = self.flow.stored(self.t, &self.x, &self.d);
                self.flow.book_event(&mut self.x, after - before);
                if let EventAction::Stop(reason) = action {
                    recorded(self.rows.end(&self.flow, self.t, &self.x, &self.d))?;
                    return Err(Halt::Ending(Ending::Stopped(reason)));
                }
            }
            events = self.crossings.jumped(&self.flow, self.t, &self.x, &self.d);
        }
        self.rates()
    }

    /// Passes all kinks where the walk stands, and the events that their jumps bring about; whether
    /// there were any.
    fn pass_kinks(&mut self) -> Result<bool, Halt> {
        let mut passed = 0;
        let system = self.flow.system;
        loop {
            system.next_kinks(&self.d, &mut self.kinks);
            let now = self.t + 4.0 * f64::EPSILON * self.t.abs();
            let Some(index) = self.kinks.iter().position(|&kink| kink <= now) else {
                break;
            };
            passed += 1;
            if passed > MOST_AT_ONCE * self.kinks.len() {
                return Err(BreakdownKind::CrowdedKinks(index).into());
            }
            let before = self.flow.stored(self.t, &self.x, &self.d);
            system.pass_kink(index, &mut self.d);
            let after = self.flow.stored(self.t, &self.x, &self.d);
            self.flow.book_supplied(&mut self.x, after - before);
            self.summary.statistics.kinks += 1;
        }
        if passed == 0 {
            return Ok(false);
        }
        let events = self.crossings.jumped(&self.flow, self.t, &self.x, &self.d);
        self.happen(events)?;
        self.pace.restart(f64::INFINITY);
        Ok(true)
    }

    /// Rates where the walk stands.
    fn rates(&mut self) -> Result<(), Halt> {
        self.flow.rates(self.t, &self.x, &self.d, &mut self.f);
        if all_finite(&self.x) && all_finite(&self.f) {
            Ok(())
        } else {
            Err(self.not_finite(0.0).into())
        }
    }
}
