//! Lanes with a step size each: Dormand and Prince's pair, accepted or rejected lane by lane.

use super::block::{Block, Point, also, finite};
use super::steps::{Steps, Verdict, Way};
use crate::lanes::{LaneSystem, Lanes, Row};
use crate::simulate::automatic::Watch;
use crate::simulate::coefficients::{TIMES, WEIGHTS, stage};
use crate::simulate::dormand_prince::{DormandPrince, advance, changed, estimate};
use crate::simulate::method::Method;
use crate::simulate::pace::{Pace, Trial};
use crate::simulate::stand::Stand;
use crate::simulate::tolerance::{
    Tolerated, excursion_at, growth_limit, length_after, remembered, share_of_rejected,
    shortest_step,
};

/// Stages of a step, the first of which is the rate at its start.
const STAGES: usize = 12;

pub(in crate::simulate) struct OwnSteps<S: LaneSystem, L: Lanes> {
    /// What the tolerance of each state rests on: the same in all lanes but for these.
    states: Vec<Tolerated>,
    start: S::States<L>,
    excursion: S::States<L>,
    relative: f64,
    longest: f64,
    /// As in `StepControl`; positive where the last step was rejected.
    wanted: L,
    memory: L,
    was_rejected: L,
    /// How far the way to a dead point allows to go.
    approach: L,
    /// The next break, the time that no step reaches, and the end.
    to: L,
    row: L,
    until: L,
    accepted: L,
    tried: L,
    /// What `tried` may come to.
    most: L,
    /// Positive where the last step could be judged here.
    margin: L,
    /// What is left to the break.
    left: L,
    watch: Option<Watch<L>>,
}

/// Rates at the stages of a step.
type Rates<S, L> = [<S as LaneSystem>::States<L>; STAGES];

/// What a step goes through besides: apart from the rates, which are in memory, it may stay in
/// registers.
struct Scratch<S: LaneSystem, L: Lanes> {
    /// Rates at the last stage.
    last: S::States<L>,
    /// State at the last stage.
    stage: S::States<L>,
    /// One over the errors that are allowed.
    per_allowed: S::States<L>,
    errors: S::States<L>,
}

impl<S: LaneSystem, L: Lanes> OwnSteps<S, L> {
    /// Length and end of the next step, as [`Pace::next`].
    #[inline(always)]
    fn next(&self, t: L) -> (L, L) {
        let left = self.to - t;
        let within = left * Trial::NEARLY - self.wanted;
        let h = within.if_positive(self.wanted.smaller(left * 0.5), left);
        let end = within.if_positive(t + h, self.to);
        let over = h - self.approach;
        let h = over.if_positive(self.approach, h);
        (h, over.if_positive(t + self.approach, end))
    }

    /// Steps by `h` from `from` to `to`, whose time is set, in every lane; the square of the
    /// error in units of what is allowed.
    #[inline(always)]
    fn step(
        &self,
        block: &Block<S, L>,
        h: L,
        from: &Point<S, L>,
        to: &mut Point<S, L>,
        k: &mut Rates<S, L>,
        scratch: &mut Scratch<S, L>,
    ) -> L {
        let mut error = L::from_f64(0.0);
        let Scratch {
            last,
            stage,
            per_allowed,
            errors,
        } = scratch;
        k[0].as_mut().copy_from_slice(from.f.as_ref());
        last.as_mut().copy_from_slice(from.f.as_ref());
        for index in 1..=STAGES {
            let (x, state) = (from.x.as_ref(), stage.as_mut());
            let (rates, newest) = (&*k, last.as_ref());
            match index {
                1 => advance(&stage::A2, rates, newest, h, x, state),
                2 => advance(&stage::A3, rates, newest, h, x, state),
                3 => advance(&stage::A4, rates, newest, h, x, state),
                4 => advance(&stage::A5, rates, newest, h, x, state),
                5 => advance(&stage::A6, rates, newest, h, x, state),
                6 => advance(&stage::A7, rates, newest, h, x, state),
                7 => advance(&stage::A8, rates, newest, h, x, state),
                8 => advance(&stage::A9, rates, newest, h, x, state),
                9 => advance(&stage::A10, rates, newest, h, x, state),
                10 => advance(&stage::A11, rates, newest, h, x, state),
                11 => advance(&stage::A12, rates, newest, h, x, state),
                _ => {
                    let x_end = to.x.as_mut();
                    advance(&WEIGHTS, rates, newest, h, x, x_end);
                    let unit = per_allowed.as_mut();
                    for (i, state) in self.states[..x.len()].iter().enumerate() {
                        let (start, before) = (self.start.as_ref()[i], self.excursion.as_ref()[i]);
                        let excursion = excursion_at(start, before, x_end[i]);
                        let allowed = state.allowed(self.relative, excursion, x[i], x_end[i]);
                        unit[i] = allowed.recip();
                    }
                    error = estimate(rates, h, unit, errors.as_mut());
                    if !block.any_positive(-error + 1.0) {
                        return error;
                    }
                    let d_end = to.d.as_mut();
                    d_end.copy_from_slice(from.d.as_ref());
                    S::accept_in_lanes(&block.system, to.t, x_end, &block.u, d_end);
                }
            }
            let (system, u) = (&block.system, &block.u);
            if index < STAGES {
                let time = from.t + h * TIMES[index];
                let (state, d) = (stage.as_ref(), from.d.as_ref());
                S::rhs_in_lanes(system, time, state, d, u, last.as_mut());
                k[index].as_mut().copy_from_slice(last.as_ref());
            } else {
                let (x, d) = (to.x.as_ref(), to.d.as_ref());
                S::rhs_in_lanes(system, to.t, x, d, u, to.f.as_mut());
            }
        }
        error
    }

    /// Draws the conclusions from a step of length `h` whose error has this square.
    #[inline(always)]
    fn conclude(
        &mut self,
        block: &mut Block<S, L>,
        h: L,
        error: L,
        from: &mut Point<S, L>,
        to: &Point<S, L>,
        scratch: &Scratch<S, L>,
    ) {
        let no = L::from_f64(-1.0);
        let logarithm = error.ln() * 0.5;
        let (good, bad) = (-error + 1.0, error - 1.0);
        let mut plain = no;
        if block.any_positive(good) {
            plain = block.judge(from, to, h, DormandPrince::LOOKS);
            if let Some(watch) = &mut self.watch {
                let unit = scratch.per_allowed.as_ref();
                let rates = changed(to.f.as_ref(), scratch.last.as_ref(), unit);
                let state = changed(to.x.as_ref(), scratch.stage.as_ref(), unit);
                plain = also(plain, watch.judge(h, [rates, state]));
            }
        }
        let (mut shorter, mut room) = (h, no);
        if block.any_positive(bad) {
            shorter = h * share_of_rejected(logarithm, DormandPrince::ORDER);
            room = shorter - shortest_step(from.t, self.until);
            room = finite(to.x.as_ref()).if_positive(room, no);
        }
        self.margin = good.if_positive(plain, bad.if_positive(room, no));
        let accepted = self.margin.if_positive(good, no);
        let rejected = self.margin.if_positive(bad, no);

        let longer = length_after(
            h,
            [logarithm, self.memory],
            DormandPrince::ORDER,
            growth_limit(self.was_rejected),
            self.wanted,
            L::from_f64(self.longest),
        );
        self.wanted = accepted.if_positive(longer, rejected.if_positive(shorter, self.wanted));
        self.memory = accepted.if_positive(remembered(logarithm), self.memory);
        let was_rejected = rejected.if_positive(L::from_f64(1.0), self.was_rejected);
        self.was_rejected = accepted.if_positive(no, was_rejected);
        let starts = self.start.as_ref().iter().zip(to.x.as_ref());
        for (excursion, (start, x)) in self.excursion.as_mut().iter_mut().zip(starts) {
            let farthest = excursion_at(*start, *excursion, *x);
            *excursion = accepted.if_positive(farthest, *excursion);
        }
        let passed = to.t - from.t;
        self.approach = accepted.if_positive(block.longest_step(passed), self.approach);
        self.accepted = accepted.if_positive(self.accepted + 1.0, self.accepted);
        self.tried = self.margin.if_positive(self.tried + 1.0, self.tried);
        if let Some(watch) = &mut self.watch {
            watch.count(self.margin, accepted, h);
        }
        block.follow_where(accepted, passed, to);
        from.take_where(accepted, to);
    }
}

impl<S: LaneSystem, L: Lanes> Steps<S, L> for OwnSteps<S, L> {
    fn new(states: usize) -> Self {
        let zero = L::from_f64(0.0);
        Self {
            states: Vec::new(),
            start: Row::filled(zero, states),
            excursion: Row::filled(zero, states),
            relative: 0.0,
            longest: 0.0,
            wanted: zero,
            memory: zero,
            was_rejected: zero,
            approach: zero,
            to: zero,
            row: L::from_f64(f64::INFINITY),
            until: zero,
            accepted: zero,
            tried: zero,
            most: zero,
            margin: zero,
            left: zero,
            watch: None,
        }
    }

    fn can_take(_: &mut Stand, _: f64) -> bool {
        true
    }

    fn load(&mut self, lane: usize, stand: &mut Stand, way: &Way<'_>) {
        let Pace::Adaptive(control) = &stand.pace else {
            return;
        };
        self.states.clone_from(&control.states);
        self.relative = control.relative;
        self.longest = control.longest;
        self.wanted.set_entry(lane, control.wanted);
        self.memory.set_entry(lane, control.memory);
        let was_rejected = if control.was_rejected { 1.0 } else { -1.0 };
        self.was_rejected.set_entry(lane, was_rejected);
        for (i, state) in control.states.iter().enumerate() {
            self.start.as_mut()[i].set_entry(lane, state.start);
            self.excursion.as_mut()[i].set_entry(lane, state.excursion);
        }
        self.approach.set_entry(lane, stand.approach.longest_step());
        self.to.set_entry(lane, way.to);
        self.row.set_entry(lane, way.row);
        self.until.set_entry(lane, stand.until);
        self.accepted.set_entry(lane, 0.0);
        self.tried.set_entry(lane, 0.0);
        self.most
            .set_entry(lane, (stand.most_steps - stand.tried) as f64);
        self.margin.set_entry(lane, 1.0);
        self.left.set_entry(lane, way.to - stand.t);
        self.watch = way.watch.as_ref().map(|watch| watch.on_lanes());
    }

    fn store(&mut self, lane: usize, stand: &mut Stand, way: Way<'_>, block: &mut Block<S, L>) {
        let accepted = self.accepted.entry(lane) as u64;
        let tried = self.tried.entry(lane) as u64;
        stand.tried += tried;
        stand.statistics.rejected += tried - accepted;
        stand.statistics.evaluations += (STAGES as u64 - 1) * tried + accepted;
        if let Pace::Adaptive(control) = &mut stand.pace {
            control.wanted = self.wanted.entry(lane);
            control.memory = self.memory.entry(lane);
            control.was_rejected = self.was_rejected.entry(lane) > 0.0;
            for (state, excursion) in control.states.iter_mut().zip(self.excursion.as_ref()) {
                state.excursion = excursion.entry(lane);
            }
        }
        if let (Some(of_stand), Some(ours)) = (way.watch, &self.watch) {
            *of_stand = ours.of_lane(lane);
        }
        block.store(lane, stand, accepted);
        // An idle lane stands still.
        self.to.set_entry(lane, block.here.t.entry(lane));
    }

    #[inline(always)]
    fn advance(&mut self, block: &mut Block<S, L>, rounds: u64) {
        let left = block.least(self.most - self.tried);
        let mut here = block.here.clone();
        let mut end = here.clone();
        let mut k: Rates<S, L> = std::array::from_fn(|_| here.x.clone());
        let mut scratch = Scratch::<S, L> {
            last: here.x.clone(),
            stage: here.x.clone(),
            per_allowed: here.x.clone(),
            errors: here.x.clone(),
        };
        for _ in 0..rounds.min(left as u64) {
            let (h, time) = self.next(here.t);
            self.margin = also(self.margin, self.row - time);
            if !block.all_positive(self.margin) {
                break;
            }
            end.t = time;
            let error = self.step(block, h, &here, &mut end, &mut k, &mut scratch);
            self.conclude(block, h, error, &mut here, &end, &scratch);
            self.left = self.to - here.t;
            if !block.all_positive(self.margin) || !block.all_positive(self.left) {
                break;
            }
        }
        block.here = here;
    }

    fn verdict(&self, lane: usize) -> Verdict {
        if !(self.left.entry(lane) > 0.0) {
            Verdict::Arrived
        } else if !(self.margin.entry(lane) > 0.0)
            || self.tried.entry(lane) >= self.most.entry(lane)
        {
            Verdict::Special
        } else {
            Verdict::UnderWay
        }
    }
}
