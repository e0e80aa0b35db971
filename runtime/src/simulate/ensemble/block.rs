//! Trajectories side by side: where each lane stands, where its step ends, and whether that step
//! is one of the plain ones that lanes may take together.

use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::crossing::Parabola;
use crate::simulate::dead_point::NEAR;
use crate::simulate::method::{Method, cubic_at};
use crate::simulate::walk::{QUARTER_TURN, Walk};

/// Lanes that step together, each with a parameter set, a time and a state of its own.
pub(super) struct Block<S: LaneSystem, L: Lanes> {
    pub system: S::InLanes<L>,
    /// Inputs.
    pub u: Vec<L>,
    /// Where each lane stands.
    pub t: L,
    pub x: Vec<L>,
    pub d: Vec<L>,
    /// Rates there.
    pub f: Vec<L>,
    /// Where the steps that are tried end.
    pub x_end: Vec<L>,
    pub d_end: Vec<L>,
    pub f_end: Vec<L>,
    /// Positive in lanes that are under way.
    active: L,
    turning: Vec<usize>,
    loops: Loops<L>,
    events: Events<L>,
}

/// Sines of the transmission angles.
struct Loops<L> {
    /// At the start of the last step, where each lane stands, and where the step tried ends.
    before: Vec<L>,
    here: Vec<L>,
    end: Vec<L>,
    /// The last step.
    passed: L,
}

/// Values of the event functions at three looks after each other.
struct Events<L> {
    earlier: Vec<L>,
    last: Vec<L>,
    here: Vec<L>,
    x: Vec<L>,
}

/// A step that was tried, in each lane.
#[derive(Clone, Copy)]
pub(super) struct Tried<L> {
    /// Its length.
    pub h: L,
    /// The time at its end.
    pub end: L,
}

impl<S: LaneSystem, L: Lanes> Block<S, L> {
    /// No lane is under way yet; `system` stands in for those that will be.
    pub fn new(system: &S, u: &[f64]) -> Self {
        let zero = L::from_f64(0.0);
        let lanes = |count: usize| vec![zero; count];
        let (n, m) = (system.states().len(), system.discretes().len());
        let (loops, events) = (system.loop_count(), system.event_count());
        Self {
            system: system.in_every_lane(),
            u: u.iter().map(|value| L::from_f64(*value)).collect(),
            t: zero,
            x: lanes(n),
            d: lanes(m),
            f: lanes(n),
            x_end: lanes(n),
            d_end: lanes(m),
            f_end: lanes(n),
            active: L::from_f64(-1.0),
            turning: system.turning().to_vec(),
            loops: Loops {
                before: lanes(loops),
                here: lanes(loops),
                end: lanes(loops),
                passed: zero,
            },
            events: Events {
                earlier: lanes(events),
                last: lanes(events),
                here: lanes(events),
                x: lanes(n),
            },
        }
    }

    /// Takes a trajectory up where it stands.
    pub fn load<M: Method>(&mut self, lane: usize, walk: &Walk<'_, S, M>) {
        self.active.set_entry(lane, 1.0);
        self.t.set_entry(lane, walk.t);
        for (lanes, values) in [
            (&mut self.x, &walk.x),
            (&mut self.d, &walk.d),
            (&mut self.f, &walk.f),
        ] {
            for (number, value) in lanes.iter_mut().zip(values) {
                number.set_entry(lane, *value);
            }
        }
        for (index, sine) in walk.approach.sines().iter().enumerate() {
            self.loops.here[index].set_entry(lane, *sine);
        }
    }

    /// Puts a trajectory down where it stands now, having `accepted` so many steps.
    pub fn store<M: Method>(&mut self, lane: usize, walk: &mut Walk<'_, S, M>, accepted: u64) {
        self.active.set_entry(lane, -1.0);
        if accepted == 0 {
            return;
        }
        walk.summary.statistics.accepted += accepted;
        walk.t = self.t.entry(lane);
        for (values, lanes) in [
            (&mut walk.x, &self.x),
            (&mut walk.d, &self.d),
            (&mut walk.f, &self.f),
        ] {
            for (value, number) in values.iter_mut().zip(lanes) {
                *value = number.entry(lane);
            }
        }
        let loops = &self.loops;
        walk.approach
            .follow(walk.t, loops.passed.entry(lane), |index| {
                (
                    loops.before[index].entry(lane),
                    loops.here[index].entry(lane),
                )
            });
        walk.stand();
    }

    /// Whether lanes that are under way all have a positive number here.
    #[inline(always)]
    pub fn all_positive(&self, margin: L) -> bool {
        self.active
            .if_positive(margin, L::from_f64(1.0))
            .all_positive()
    }

    /// Whether any lane that is under way has a positive number here.
    #[inline(always)]
    pub fn any_positive(&self, value: L) -> bool {
        self.active
            .if_positive(value, L::from_f64(-1.0))
            .any_positive()
    }

    /// The smallest entry of lanes that are under way; infinity if there are none.
    pub fn least(&self, value: L) -> f64 {
        (0..L::COUNT)
            .filter(|lane| self.active.entry(*lane) > 0.0)
            .map(|lane| value.entry(lane))
            .fold(f64::INFINITY, f64::min)
    }

    /// Positive where a step was a plain one: a finite state, no body that turned too far, no loop
    /// near a dead point, no event.
    #[inline(always)]
    pub fn judge(&mut self, step: Tried<L>, looks: &[f64]) -> L {
        let mut margin = self.finite_end();
        for value in &self.f_end {
            margin = value.times_plus(L::from_f64(0.0), margin);
        }
        for &index in &self.turning {
            let turn = (self.d_end[index] - self.d[index]).abs();
            margin = also(margin, L::from_f64(QUARTER_TURN) - turn);
        }
        margin = self.judge_loops(margin, step);
        self.judge_events(margin, step, looks)
    }

    /// Positive where the state at the end of the step tried is finite.
    #[inline(always)]
    pub fn finite_end(&self) -> L {
        let mut finite = L::from_f64(1.0);
        for value in &self.x_end {
            finite = value.times_plus(L::from_f64(0.0), finite);
        }
        finite
    }

    #[inline(always)]
    fn judge_loops(&mut self, mut margin: L, step: Tried<L>) -> L {
        let Loops { here, end, .. } = &mut self.loops;
        if end.is_empty() {
            return margin;
        }
        S::closures_in_lanes(
            &self.system,
            step.end,
            &self.x_end,
            &self.d_end,
            &self.u,
            end,
        );
        for (end, here) in end.iter_mut().zip(here) {
            *end = end.larger(L::from_f64(0.0)).sqrt();
            let fallen = *here - *end;
            margin = also(margin, fallen.if_positive(*end - NEAR, L::from_f64(1.0)));
        }
        margin
    }

    /// As [`Crossings::find`](crate::simulate::crossing::Crossings::find) looks, with all events
    /// armed.
    #[inline(always)]
    fn judge_events(&mut self, mut margin: L, step: Tried<L>, looks: &[f64]) -> L {
        let Events {
            earlier,
            last,
            here,
            x,
        } = &mut self.events;
        if here.is_empty() {
            return margin;
        }
        S::events_in_lanes(&self.system, self.t, &self.x, &self.d, &self.u, last);
        let (mut a, mut b) = (0.0, 0.0);
        for (count, &c) in looks.iter().enumerate() {
            for i in 0..x.len() {
                x[i] = if c < 1.0 {
                    let (from, to) = (self.x[i], self.x_end[i]);
                    cubic_at(c, step.h, [from, to], [self.f[i], self.f_end[i]])
                } else {
                    self.x_end[i]
                };
            }
            let time = step.h.times_plus(L::from_f64(c), self.t);
            S::events_in_lanes(&self.system, time, x, &self.d, &self.u, here);
            for i in 0..here.len() {
                margin = also(margin, -here[i]);
                if count > 0 {
                    margin = also(margin, room([(a, earlier[i]), (b, last[i]), (c, here[i])]));
                }
            }
            std::mem::swap(earlier, last);
            std::mem::swap(last, here);
            (a, b) = (b, c);
        }
        margin
    }

    /// Half of the time after which the first loop would come to its dead point, as the step just
    /// tried goes.
    #[inline(always)]
    pub fn longest_step(&self, step: Tried<L>) -> L {
        let never = L::from_f64(f64::INFINITY);
        let passed = step.end - self.t;
        let mut longest = never;
        for (end, here) in self.loops.end.iter().zip(&self.loops.here) {
            let fallen = -((*end - *here) / passed);
            let left = fallen.if_positive(*end / fallen, never);
            longest = longest.smaller(left * 0.5);
        }
        longest
    }

    /// Moves every lane on.
    #[inline(always)]
    pub fn commit(&mut self, step: Tried<L>) {
        self.loops.passed = step.end - self.t;
        self.t = step.end;
        std::mem::swap(&mut self.x, &mut self.x_end);
        std::mem::swap(&mut self.d, &mut self.d_end);
        std::mem::swap(&mut self.f, &mut self.f_end);
        let Loops {
            before, here, end, ..
        } = &mut self.loops;
        std::mem::swap(before, here);
        std::mem::swap(here, end);
    }

    /// Moves on the lanes where `taken` is positive.
    #[inline(always)]
    pub fn commit_where(&mut self, taken: L, step: Tried<L>) {
        self.loops.passed = taken.if_positive(step.end - self.t, self.loops.passed);
        self.t = taken.if_positive(step.end, self.t);
        copy_where(taken, &self.x_end, &mut self.x);
        copy_where(taken, &self.d_end, &mut self.d);
        copy_where(taken, &self.f_end, &mut self.f);
        copy_where(taken, &self.loops.here, &mut self.loops.before);
        copy_where(taken, &self.loops.end, &mut self.loops.here);
    }
}

/// Positive where an event function stays clear of zero between three looks at it.
#[inline(always)]
fn room<L: Lanes>(looks: [(f64, L); 3]) -> L {
    let [(from, _), _, (to, _)] = looks;
    let parabola = Parabola::through(looks);
    let one = L::from_f64(1.0);
    let inside =
        (parabola.at - from).if_positive((-parabola.at + to).if_positive(parabola.gap(), one), one);
    (-parabola.bend).if_positive(inside, one)
}

#[inline(always)]
fn copy_where<L: Lanes>(wanted: L, from: &[L], to: &mut [L]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = wanted.if_positive(*from, *to);
    }
}

/// `margin` where `other` is positive, else something negative.
#[inline(always)]
pub(super) fn also<L: Lanes>(margin: L, other: L) -> L {
    other.if_positive(margin, L::from_f64(-1.0))
}
