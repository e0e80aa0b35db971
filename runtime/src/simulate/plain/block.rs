//! Trajectories side by side: where each lane stands, where its step ends, and whether that step
//! is one of the plain ones that lanes may take together.

use crate::lanes::{LaneSystem, Lanes, Row};
use crate::simulate::crossing::Parabola;
use crate::simulate::dead_point::NEAR;
use crate::simulate::method::cubic_at;
use crate::simulate::stand::Stand;
use crate::simulate::walk::QUARTER_TURN;

/// Lanes that step together, each with a parameter set, a time and a state of its own.
pub(in crate::simulate) struct Block<S: LaneSystem, L: Lanes> {
    pub system: Box<S::InLanes<L>>,
    /// Inputs.
    pub u: Vec<L>,
    /// Where each lane stands.
    pub here: Point<S, L>,
    /// Positive in lanes that are under way.
    active: L,
    /// Steps that ended outside of tables since a lane was taken up.
    outside_tables: L,
    /// How far each discrete number may go in a step.
    room: S::Discretes<L>,
    loops: Loops<S, L>,
    events: Events<S, L>,
}

/// An end of a step, in each lane.
pub(in crate::simulate) struct Point<S: LaneSystem, L: Lanes> {
    pub t: L,
    pub x: S::States<L>,
    pub d: S::Discretes<L>,
    /// Rates.
    pub f: S::States<L>,
}

impl<S: LaneSystem, L: Lanes> Clone for Point<S, L> {
    #[inline(always)]
    fn clone(&self) -> Self {
        Self {
            t: self.t,
            x: self.x.clone(),
            d: self.d.clone(),
            f: self.f.clone(),
        }
    }
}

/// Sines of the transmission angles.
struct Loops<S: LaneSystem, L: Lanes> {
    /// At the start of the last step, where each lane stands, and where the step tried ends.
    before: S::Loops<L>,
    here: S::Loops<L>,
    end: S::Loops<L>,
    /// The last step.
    passed: L,
}

/// Values of the event functions at three looks after each other.
struct Events<S: LaneSystem, L: Lanes> {
    earlier: S::Events<L>,
    last: S::Events<L>,
    here: S::Events<L>,
    x: S::States<L>,
}

impl<S: LaneSystem, L: Lanes> Block<S, L> {
    /// No lane is under way yet. Those that will be are of the model of `system`, with the parameter
    /// sets `in_lanes`.
    pub fn new(system: &S, in_lanes: Box<S::InLanes<L>>, u: &[f64]) -> Self {
        let zero = L::from_f64(0.0);
        let (n, m) = (system.states().len(), system.discretes().len());
        let states: S::States<L> = Row::filled(zero, n);
        let loops: S::Loops<L> = Row::filled(zero, system.loop_count());
        let events: S::Events<L> = Row::filled(zero, system.event_count());
        let mut room: S::Discretes<L> = Row::filled(L::from_f64(f64::INFINITY), m);
        for &index in system.turning() {
            room.as_mut()[index] = L::from_f64(QUARTER_TURN);
        }
        Self {
            system: in_lanes,
            u: u.iter().map(|value| L::from_f64(*value)).collect(),
            here: Point {
                t: zero,
                x: states.clone(),
                d: Row::filled(zero, m),
                f: states.clone(),
            },
            active: L::from_f64(-1.0),
            outside_tables: zero,
            room,
            loops: Loops {
                before: loops.clone(),
                here: loops.clone(),
                end: loops,
                passed: zero,
            },
            events: Events {
                earlier: events.clone(),
                last: events.clone(),
                here: events,
                x: states,
            },
        }
    }

    /// Takes a trajectory up where it stands.
    pub fn load(&mut self, lane: usize, stand: &Stand) {
        self.active.set_entry(lane, 1.0);
        self.outside_tables.set_entry(lane, 0.0);
        self.here.t.set_entry(lane, stand.t);
        for (lanes, values) in [
            (self.here.x.as_mut(), &stand.x),
            (self.here.d.as_mut(), &stand.d),
            (self.here.f.as_mut(), &stand.f),
        ] {
            for (number, value) in lanes.iter_mut().zip(values) {
                number.set_entry(lane, *value);
            }
        }
        for (index, sine) in stand.approach.sines().iter().enumerate() {
            self.loops.here.as_mut()[index].set_entry(lane, *sine);
        }
    }

    /// Puts a trajectory down where it stands now, having `accepted` so many steps.
    pub fn store(&mut self, lane: usize, stand: &mut Stand, accepted: u64) {
        self.active.set_entry(lane, -1.0);
        if accepted == 0 {
            return;
        }
        stand.statistics.accepted += accepted;
        stand.statistics.outside_tables += self.outside_tables.entry(lane) as u64;
        stand.t = self.here.t.entry(lane);
        for (values, lanes) in [
            (&mut stand.x, self.here.x.as_ref()),
            (&mut stand.d, self.here.d.as_ref()),
            (&mut stand.f, self.here.f.as_ref()),
        ] {
            for (value, number) in values.iter_mut().zip(lanes) {
                *value = number.entry(lane);
            }
        }
        let loops = &self.loops;
        stand
            .approach
            .follow(stand.t, loops.passed.entry(lane), |index| {
                (
                    loops.before.as_ref()[index].entry(lane),
                    loops.here.as_ref()[index].entry(lane),
                )
            });
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

    /// Positive where a step of length `h` was a plain one: a finite state, no body that turned too
    /// far, no loop near a dead point, no event.
    #[inline(always)]
    pub fn judge(&mut self, from: &Point<S, L>, to: &Point<S, L>, h: L, looks: &[f64]) -> L {
        let zero = L::from_f64(0.0);
        let mut margin = finite(to.x.as_ref());
        for value in to.f.as_ref() {
            margin = value.times_plus(zero, margin);
        }
        let ends = from.d.as_ref().iter().zip(to.d.as_ref());
        for ((from, to), room) in ends.zip(self.room.as_ref()) {
            margin = also(margin, *room - (*to - *from).abs());
        }
        margin = self.judge_loops(margin, to);
        self.judge_events(margin, from, to, h, looks)
    }

    #[inline(always)]
    fn judge_loops(&mut self, mut margin: L, to: &Point<S, L>) -> L {
        let Loops { here, end, .. } = &mut self.loops;
        let (here, end) = (here.as_ref(), end.as_mut());
        if end.is_empty() {
            return margin;
        }
        let (x, d) = (to.x.as_ref(), to.d.as_ref());
        S::closures_in_lanes(&self.system, to.t, x, d, &self.u, end);
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
    fn judge_events(
        &mut self,
        mut margin: L,
        from: &Point<S, L>,
        to: &Point<S, L>,
        h: L,
        looks: &[f64],
    ) -> L {
        let Events {
            earlier,
            last,
            here,
            x,
        } = &mut self.events;
        let (earlier, last) = (earlier.as_mut(), last.as_mut());
        let (here, x) = (here.as_mut(), x.as_mut());
        if here.is_empty() {
            return margin;
        }
        let d = from.d.as_ref();
        S::events_in_lanes(&self.system, from.t, from.x.as_ref(), d, &self.u, last);
        let (mut a, mut b) = (0.0, 0.0);
        for (count, &c) in looks.iter().enumerate() {
            for i in 0..x.len() {
                x[i] = if c < 1.0 {
                    let states = [from.x.as_ref()[i], to.x.as_ref()[i]];
                    cubic_at(c, h, states, [from.f.as_ref()[i], to.f.as_ref()[i]])
                } else {
                    to.x.as_ref()[i]
                };
            }
            let time = h.times_plus(L::from_f64(c), from.t);
            S::events_in_lanes(&self.system, time, x, d, &self.u, here);
            for i in 0..here.len() {
                margin = also(margin, -here[i]);
                if count > 0 {
                    margin = also(margin, room([(a, earlier[i]), (b, last[i]), (c, here[i])]));
                }
            }
            earlier.copy_from_slice(last);
            last.copy_from_slice(here);
            (a, b) = (b, c);
        }
        margin
    }

    /// Positive where no loop would come to its dead point within twice a step of length `h`, as
    /// the step just tried, of duration `passed`, goes.
    #[inline(always)]
    pub fn may_step(&self, h: L, passed: L) -> L {
        let mut margin = L::from_f64(1.0);
        for (end, here) in self.loops.end.as_ref().iter().zip(self.loops.here.as_ref()) {
            let fallen = *here - *end;
            margin = also(margin, *end * passed - fallen * h * 2.0);
        }
        margin
    }

    /// Half of the time after which the first loop would come to its dead point, as the step just
    /// tried, of duration `passed`, goes.
    #[inline(always)]
    pub fn longest_step(&self, passed: L) -> L {
        let never = L::from_f64(f64::INFINITY);
        let mut longest = never;
        for (end, here) in self.loops.end.as_ref().iter().zip(self.loops.here.as_ref()) {
            let fallen = *here - *end;
            if fallen.any_positive() {
                let left = *end / (fallen / passed);
                longest = longest.smaller(fallen.if_positive(left * 0.5, never));
            }
        }
        longest
    }

    /// Every lane has moved on by the step just judged, to `end`.
    #[inline(always)]
    pub fn follow(&mut self, passed: L, end: &Point<S, L>) {
        self.count_outside(L::from_f64(1.0), end);
        self.loops.passed = passed;
        let Loops {
            before, here, end, ..
        } = &mut self.loops;
        before.as_mut().copy_from_slice(here.as_ref());
        here.as_mut().copy_from_slice(end.as_ref());
    }

    /// The lanes where `taken` is positive have moved on by the step just judged, to `end`.
    #[inline(always)]
    pub fn follow_where(&mut self, taken: L, passed: L, end: &Point<S, L>) {
        self.count_outside(taken, end);
        let loops = &mut self.loops;
        loops.passed = taken.if_positive(passed, loops.passed);
        copy_where(taken, loops.here.as_ref(), loops.before.as_mut());
        copy_where(taken, loops.end.as_ref(), loops.here.as_mut());
    }

    #[inline(always)]
    fn count_outside(&mut self, taken: L, end: &Point<S, L>) {
        let outside = S::outside_tables_in_lanes(&self.system, end.x.as_ref());
        if outside.any_positive() {
            let count = self.outside_tables;
            let one_more = outside.if_positive(count + 1.0, count);
            self.outside_tables = taken.if_positive(one_more, count);
        }
    }
}

impl<S: LaneSystem, L: Lanes> Point<S, L> {
    /// Takes over from `other`, number by number: swapping would send them through memory.
    #[inline(always)]
    pub fn take(&mut self, other: &Self) {
        self.t = other.t;
        self.x.as_mut().copy_from_slice(other.x.as_ref());
        self.d.as_mut().copy_from_slice(other.d.as_ref());
        self.f.as_mut().copy_from_slice(other.f.as_ref());
    }

    /// Takes over from `other` the lanes where `wanted` is positive.
    #[inline(always)]
    pub fn take_where(&mut self, wanted: L, other: &Self) {
        self.t = wanted.if_positive(other.t, self.t);
        copy_where(wanted, other.x.as_ref(), self.x.as_mut());
        copy_where(wanted, other.d.as_ref(), self.d.as_mut());
        copy_where(wanted, other.f.as_ref(), self.f.as_mut());
    }
}

/// Positive where all numbers are finite.
#[inline(always)]
pub(super) fn finite<L: Lanes>(row: &[L]) -> L {
    let mut finite = L::from_f64(1.0);
    for value in row {
        finite = value.times_plus(L::from_f64(0.0), finite);
    }
    finite
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
