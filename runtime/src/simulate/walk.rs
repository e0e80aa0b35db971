//! A run from its start to its end, step by step.
//!
//! A walk stands at a time with a state, the rates there, and the values of all event functions.
//! Each round it chooses a step that ends at or before the next break (the end of the run, a kink
//! of a drive), tries it, shortens it to the first event that it ran into, records the rows inside
//! it, moves on, and passes the events and kinks where it then stands.

use std::any::Any;
use std::ops::ControlFlow;

use super::accounting::Flow;
use super::breakdown::{Breakdown, BreakdownKind, Place};
use super::crossing::{Crossings, Found};
use super::dead_point::Approach;
use super::method::{Method, Step};
use super::pace::{Pace, Trial};
use super::plain::{Last, PlainSteps, Start, Verdict, Way};
use super::rows::{Recording, Rows};
use super::run::{Ending, EventRecord, Statistics, Summary};
use super::stand::Stand;
use super::stops::{Sample, Stops};
use super::tolerance::shortest_step;
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
    /// Where it stands.
    pub stand: Stand,
    rows: Rows<'a>,
    stops: Stops<'a>,
    crossings: Crossings,
    /// Half of a step that a loop did not allow, where steps are equal ones.
    shortened: f64,
    /// Where the step that is tried ends.
    x_end: Vec<f64>,
    d_end: Vec<f64>,
    f_end: Vec<f64>,
    /// The next kink of each drive.
    kinks: Vec<f64>,
    /// Steps tried when progress was reported last.
    reported: u64,
    /// What the system keeps for its plain steps.
    in_lanes: Option<Box<dyn Any>>,
    /// Where the last one of them began, if a row is inside.
    start: Start,
    summary: Summary,
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
            rows: Rows::new(rows, width, until, flow.stored(0.0, &x, &d)),
            stops: Stops::default(),
            crossings: Crossings::new(system.event_count(), width),
            shortened: f64::INFINITY,
            x_end: vec![0.0; width],
            d_end: d.clone(),
            f_end: vec![0.0; width],
            kinks: vec![f64::INFINITY; system.kink_count()],
            reported: 0,
            in_lanes: None,
            start: Start {
                t: 0.0,
                h: 0.0,
                x: vec![0.0; width],
                d: d.clone(),
                f: vec![0.0; width],
            },
            summary: Summary::default(),
            stand: Stand {
                t: 0.0,
                x,
                d,
                f: vec![0.0; width],
                pace,
                approach: Approach::new(system.loop_count()),
                until,
                tried: 0,
                most_steps,
                statistics: Statistics::default(),
            },
            flow,
        }
    }

    /// The same from a start that is this far off, state by state.
    pub fn starting_off(mut self, offsets: &[f64]) -> Self {
        let states = self.flow.states;
        for (x, offset) in self.stand.x[..states].iter_mut().zip(offsets) {
            *x += offset;
        }
        self
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
                    time: self.stand.t,
                    state: self.flow.own(&self.stand.x),
                };
                (Ending::Failed, Some(Breakdown::at(&place, kind)))
            }
        };
        self.summary.end = self.stand.t;
        self.summary.ending = ending;
        self.summary.statistics = self.stand.statistics;
        self.summary.statistics.evaluations += self.flow.evaluations;
        self.summary.state = self.flow.own(&self.stand.x).to_vec();
        self.summary.discrete = self.stand.d;
        (self.summary, breakdown, self.stops.samples)
    }

    fn go(&mut self) -> Result<(), Halt> {
        self.begin()?;
        while !self.is_over() {
            let verdict = self.go_plainly()?;
            if verdict.is_none_or(|verdict| verdict == Verdict::Special) && !self.is_over() {
                self.round()?;
            }
        }
        recorded(
            self.rows
                .end(&self.flow, self.stand.t, &self.stand.x, &self.stand.d),
        )
    }

    /// Stands at the start, behind the kinks that are there.
    pub fn begin(&mut self) -> Result<(), Halt> {
        if !all_finite(&self.stand.x) {
            return Err(BreakdownKind::NotFinite.into());
        }
        self.crossings
            .stand(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        if !self.pass_kinks()? {
            self.rates()?;
        }
        self.stops
            .pass(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        let first_break = self.next_break() - self.stand.t;
        if let Pace::Adaptive(control) = &mut self.stand.pace {
            control.start(self.flow.own(&self.stand.x), first_break);
        }
        recorded(
            self.rows
                .start(&self.flow, self.stand.t, &self.stand.x, &self.stand.d),
        )?;
        self.watch_loops()
    }

    /// Whether it has come to its end.
    pub fn is_over(&self) -> bool {
        !(self.stand.t < self.stand.until)
    }

    /// Takes the plain steps that lie ahead, if there are any and the system has a way of its own
    /// to take them; where they led.
    fn go_plainly(&mut self) -> Result<Option<Verdict>, Halt> {
        if self.flow.accounts() || !self.is_quiet() {
            return Ok(None);
        }
        let (to, row) = (self.next_break(), self.rows.due());
        let accepted = self.stand.statistics.accepted;
        let Some(plain) = self.method.plain() else {
            return Ok(None);
        };
        let mut steps = PlainSteps {
            stand: &mut self.stand,
            inputs: &self.flow.u,
            in_lanes: &mut self.in_lanes,
            way: Way {
                to,
                row,
                last: Some(Last {
                    start: &mut self.start,
                    stages: plain.stages,
                }),
                watch: plain.watch,
            },
            verdict: None,
        };
        self.flow.system.take_plain_steps(&mut steps);
        let verdict = steps.verdict;
        if verdict.is_some() {
            self.report()?;
            if self.stand.t >= row && self.stand.statistics.accepted > accepted {
                self.record_last()?;
            }
            self.resume();
            if verdict == Some(Verdict::Arrived) {
                self.arrive(false)?;
            }
        }
        Ok(verdict)
    }

    /// Records the rows inside the last plain step and at its end.
    fn record_last(&mut self) -> Result<(), Halt> {
        let step = Step {
            t: self.start.t,
            h: self.start.h,
            x: &self.start.x,
            f: &self.start.f,
            d: &self.start.d,
            x_end: &self.stand.x,
            f_end: &self.stand.f,
        };
        let end = self.stand.t;
        recorded(
            self.rows
                .inside(&mut self.flow, &mut self.method, &step, end),
        )?;
        recorded(
            self.rows
                .step_end(&self.flow, end, &self.stand.x, &self.stand.d),
        )
    }

    /// Says how far the run is, if it has gone far enough.
    fn report(&mut self) -> Result<(), Halt> {
        if self.stand.tried < self.reported + PROGRESS_INTERVAL {
            return Ok(());
        }
        self.reported = self.stand.tried;
        recorded(self.rows.progress(self.stand.t))
    }

    /// Tries one step.
    pub fn round(&mut self) -> Result<(), Halt> {
        if self.stand.tried >= self.stand.most_steps {
            return Err(BreakdownKind::TooManySteps.into());
        }
        self.stand.tried += 1;
        self.report()?;
        let longest = self.stand.approach.longest_step().min(self.shortened);
        let trial = self
            .stand
            .pace
            .next(self.stand.t, self.next_break(), longest);
        match self.attempt(trial) {
            Ok(error) => self.accept(trial, error),
            Err(rejection) => self.reject(trial, &rejection),
        }
    }

    /// The time of the next kink, of the next sample or of the end.
    pub fn next_break(&self) -> f64 {
        let end = self.stand.until.min(self.stops.next());
        self.kinks.iter().copied().fold(end, f64::min)
    }

    /// Goes on where plain steps have put it.
    pub fn resume(&mut self) {
        self.crossings
            .stand(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
    }

    /// Whether nothing that is under way asks for more than plain steps.
    pub fn is_quiet(&self) -> bool {
        self.shortened == f64::INFINITY && self.crossings.are_quiet()
    }

    /// Takes a step to `x_end`, `d_end`, `f_end`; the square of its error in units of what is allowed.
    fn attempt(&mut self, trial: Trial) -> Result<f64, Rejection> {
        self.method.step(
            &mut self.flow,
            self.stand.t,
            trial.h,
            &self.stand.x,
            &self.stand.f,
            &self.stand.d,
            &mut self.x_end,
        );
        if !all_finite(&self.x_end) {
            return Err(Rejection::NotFinite);
        }
        let mut error = 0.0;
        if let Pace::Adaptive(control) = &mut self.stand.pace {
            let states = self.flow.states;
            let allowed = control.allowed(&self.stand.x[..states], &self.x_end[..states]);
            error = self.method.error_squared(trial.h, allowed);
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
        self.d_end.copy_from_slice(&self.stand.d);
        let system = self.flow.system;
        system.accept(
            end,
            self.flow.own(&self.x_end),
            &self.flow.u,
            &mut self.d_end,
        );
        for &index in system.turning() {
            let turn = (self.d_end[index] - self.stand.d[index]).abs();
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
        self.stand.statistics.rejected += 1;
        let shortest = shortest_step(self.stand.t, self.stand.until);
        let control = match &mut self.stand.pace {
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
            for i in 0..self.stand.x.len() {
                self.x_end[i] = self.stand.x[i] + ahead * self.stand.f[i];
            }
            if !all_finite(&self.x_end) {
                continue;
            }
            let x = self.flow.own(&self.x_end);
            system.closures(
                self.stand.t + ahead,
                x,
                &self.stand.d,
                &self.flow.u,
                &mut closures,
            );
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
            t: self.stand.t,
            h: trial.h,
            x: &self.stand.x,
            f: &self.stand.f,
            d: &self.stand.d,
            x_end: &self.x_end,
            f_end: &self.f_end,
        };
        let found = self.crossings.find(&mut self.flow, &mut self.method, &step);
        let taken = match &found {
            None => trial,
            Some(found) => self.shorten(trial, found)?,
        };
        let step = Step {
            t: self.stand.t,
            h: taken.h,
            x: &self.stand.x,
            f: &self.stand.f,
            d: &self.stand.d,
            x_end: &self.x_end,
            f_end: &self.f_end,
        };
        recorded(
            self.rows
                .inside(&mut self.flow, &mut self.method, &step, taken.end),
        )?;
        self.stand.statistics.accepted += 1;
        let is_outside = self
            .flow
            .system
            .is_outside_tables(self.flow.own(&self.x_end));
        self.stand.statistics.outside_tables += u64::from(is_outside);
        self.stand.statistics.stiff += u64::from(self.method.is_stiff());
        if let Pace::Adaptive(control) = &mut self.stand.pace {
            let order = self.method.order();
            control.accepted(taken.h, error, order, self.flow.own(&self.x_end));
            if let Some(longest) = self.method.accepted(&step, control.judged_by()) {
                control.restart(longest);
            }
        }
        self.stand.t = taken.end;
        std::mem::swap(&mut self.stand.x, &mut self.x_end);
        std::mem::swap(&mut self.stand.d, &mut self.d_end);
        std::mem::swap(&mut self.stand.f, &mut self.f_end);
        self.crossings
            .stand(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        recorded(
            self.rows
                .step_end(&self.flow, self.stand.t, &self.stand.x, &self.stand.d),
        )?;
        self.shortened = f64::INFINITY;
        self.watch_loops()?;
        let happened = found.is_some();
        if let Some(found) = found {
            self.happen(found.all)?;
            self.stand.pace.restart(0.25 * trial.h);
            recorded(
                self.rows
                    .step_end(&self.flow, self.stand.t, &self.stand.x, &self.stand.d),
            )?;
        }
        self.arrive(happened)
    }

    /// Takes a sample and passes kinks, if there are any where the walk stands; events that
    /// happened may have moved kinks.
    pub fn arrive(&mut self, happened: bool) -> Result<(), Halt> {
        let sampled = self
            .stops
            .pass(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        if sampled {
            self.stand.pace.stop_over();
        }
        if !self.is_over() && (happened || sampled || self.stand.t >= self.next_break()) {
            self.pass_kinks()?;
        }
        Ok(())
    }

    /// Ends the run where a loop comes to its dead point.
    fn watch_loops(&mut self) -> Result<(), Halt> {
        let x = self.flow.own(&self.stand.x);
        self.stand.approach.stand(
            self.flow.system,
            self.stand.t,
            x,
            &self.stand.d,
            &self.flow.u,
        );
        match self.stand.approach.reached() {
            Some((index, left)) => {
                self.stand.t = (self.stand.t + left).min(self.next_break());
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
                self.stand.t,
                h,
                &self.stand.x,
                &self.stand.f,
                &self.stand.d,
                &mut self.x_end,
            );
            self.flow.system.events(
                self.stand.t + h,
                self.flow.own(&self.x_end),
                &self.stand.d,
                &self.flow.u,
                &mut values,
            );
            let correction = -values[found.index] / found.slope;
            let is_settled =
                correction.abs() <= 1e-14 * trial.h + f64::EPSILON * self.stand.t.abs();
            // A touch without a slope has no better place.
            if !(found.slope > 0.0) || is_settled || !(correction.abs() < 1e-3 * trial.h) {
                break;
            }
            h = (h + correction).clamp(0.0, trial.h);
        }
        let trial = Trial {
            h,
            end: (self.stand.t + h).min(trial.end),
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
                if self.crossings.happens(index, self.stand.t) || rounds > MOST_AT_ONCE {
                    return Err(BreakdownKind::Chatter(index).into());
                }
                self.stand.statistics.events += 1;
                if self.summary.events.len() < MOST_RECORDS {
                    self.summary.events.push(EventRecord {
                        time: self.stand.t,
                        index,
                    });
                }
                let before = self.flow.stored(self.stand.t, &self.stand.x, &self.stand.d);
                let action = self.flow.system.pass_event(
                    index,
                    self.stand.t,
                    &mut self.stand.x[..self.flow.states],
                    &mut self.stand.d,
                    &self.flow.u,
                );
                let after = self.flow.stored(self.stand.t, &self.stand.x, &self.stand.d);
                self.flow.book_event(&mut self.stand.x, after - before);
                if let EventAction::Stop(reason) = action {
                    recorded(self.rows.end(
                        &self.flow,
                        self.stand.t,
                        &self.stand.x,
                        &self.stand.d,
                    ))?;
                    return Err(Halt::Ending(Ending::Stopped(reason)));
                }
            }
            events = self
                .crossings
                .jumped(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        }
        self.rates()
    }

    /// Passes all kinks where the walk stands, and the events that their jumps bring about; whether
    /// there were any.
    fn pass_kinks(&mut self) -> Result<bool, Halt> {
        let mut passed = 0;
        let system = self.flow.system;
        loop {
            system.next_kinks(&self.stand.d, &mut self.kinks);
            let now = self.stand.t + 4.0 * f64::EPSILON * self.stand.t.abs();
            let Some(index) = self.kinks.iter().position(|&kink| kink <= now) else {
                break;
            };
            passed += 1;
            if passed > MOST_AT_ONCE * self.kinks.len() {
                return Err(BreakdownKind::CrowdedKinks(index).into());
            }
            let before = self.flow.stored(self.stand.t, &self.stand.x, &self.stand.d);
            system.pass_kink(index, &mut self.stand.d);
            let after = self.flow.stored(self.stand.t, &self.stand.x, &self.stand.d);
            self.flow.book_supplied(&mut self.stand.x, after - before);
            self.stand.statistics.kinks += 1;
        }
        if passed == 0 {
            return Ok(false);
        }
        let events = self
            .crossings
            .jumped(&self.flow, self.stand.t, &self.stand.x, &self.stand.d);
        self.happen(events)?;
        self.stand.pace.restart(f64::INFINITY);
        Ok(true)
    }

    /// Rates where the walk stands.
    fn rates(&mut self) -> Result<(), Halt> {
        self.flow.rates(
            self.stand.t,
            &self.stand.x,
            &self.stand.d,
            &mut self.stand.f,
        );
        if all_finite(&self.stand.x) && all_finite(&self.stand.f) {
            Ok(())
        } else {
            Err(self.not_finite(0.0).into())
        }
    }
}
