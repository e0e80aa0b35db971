//! Lanes with a step size each: Dormand and Prince's pair, accepted or rejected lane by lane.

use super::block::{Block, Tried};
use super::steps::{Steps, Verdict};
use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::breakdown::Breakdown;
use crate::simulate::coefficients::{TIMES, WEIGHTS, stage};
use crate::simulate::dormand_prince::{DormandPrince, advance, estimate};
use crate::simulate::method::Method;
use crate::simulate::pace::{Pace, Trial};
use crate::simulate::settings::Settings;
use crate::simulate::tolerance::{
    Tolerated, growth_limit, length_after, remembered, share_of_rejected,
};
use crate::simulate::walk::{Walk, shortest_step};
use crate::system::Variable;

/// Stages of a step, the first of which is the rate at its start.
const STAGES: usize = 12;

pub(in crate::simulate) struct OwnSteps<L> {
    stage: Vec<L>,
    /// Rates at the stages.
    k: Vec<Vec<L>>,
    allowed: Vec<L>,
    /// What the tolerance of each state rests on: the same in all lanes but for these.
    states: Vec<Tolerated>,
    start: Vec<L>,
    excursion: Vec<L>,
    relative: f64,
    longest: f64,
    /// As in `StepControl`; positive where the last step was rejected.
    wanted: L,
    last_error: L,
    was_rejected: L,
    /// How far the way to a dead point allows to go.
    approach: L,
    /// The next break, and the end.
    to: L,
    until: L,
    accepted: L,
    tried: L,
    /// What `tried` may come to.
    most: L,
    /// Positive where the last step could be judged here.
    margin: L,
    /// What is left to the break.
    left: L,
}

impl<L: Lanes> OwnSteps<L> {
    /// As [`Pace::next`].
    #[inline(always)]
    fn next(&self, t: L) -> Tried<L> {
        let left = self.to - t;
        let within = left * Trial::NEARLY - self.wanted;
        let h = within.if_positive(self.wanted.smaller(left * 0.5), left);
        let end = within.if_positive(t + h, self.to);
        let over = h - self.approach;
        Tried {
            h: over.if_positive(self.approach, h),
            end: over.if_positive(t + self.approach, end),
        }
    }

    /// Steps to `x_end`, `d_end`, `f_end` in every lane; the error in units of what is allowed.
    #[inline(always)]
    fn step<S: LaneSystem>(&mut self, block: &mut Block<S, L>, step: Tried<L>) -> L {
        let mut error = L::from_f64(0.0);
        self.k[0].copy_from_slice(&block.f);
        for index in 1..=STAGES {
            let Self { k, stage, .. } = self;
            let x = &block.x;
            match index {
                1 => advance(&stage::A2, k, step.h, x, stage),
                2 => advance(&stage::A3, k, step.h, x, stage),
                3 => advance(&stage::A4, k, step.h, x, stage),
                4 => advance(&stage::A5, k, step.h, x, stage),
                5 => advance(&stage::A6, k, step.h, x, stage),
                6 => advance(&stage::A7, k, step.h, x, stage),
                7 => advance(&stage::A8, k, step.h, x, stage),
                8 => advance(&stage::A9, k, step.h, x, stage),
                9 => advance(&stage::A10, k, step.h, x, stage),
                10 => advance(&stage::A11, k, step.h, x, stage),
                11 => advance(&stage::A12, k, step.h, x, stage),
                _ => {
                    advance(&WEIGHTS, k, step.h, x, &mut block.x_end);
                    error = self.error(block, step.h);
                    if !block.any_positive(-error + 1.0) {
                        return error;
                    }
                    block.d_end.copy_from_slice(&block.d);
                    let (end, x_end) = (step.end, &block.x_end);
                    S::accept_in_lanes(&block.system, end, x_end, &block.u, &mut block.d_end);
                }
            }
            let is_last = index == STAGES;
            let (time, x, d, rates) = if is_last {
                (step.end, &block.x_end, &block.d_end, &mut block.f_end)
            } else {
                let time = block.t + step.h * TIMES[index];
                (time, &self.stage, &block.d, &mut self.k[index])
            };
            S::rhs_in_lanes(&block.system, time, x, d, &block.u, rates);
        }
        error
    }

    #[inline(always)]
    fn error<S: LaneSystem>(&mut self, block: &Block<S, L>, h: L) -> L {
        for (i, state) in self.states.iter().enumerate() {
            let (x, x_end) = (block.x[i], block.x_end[i]);
            let excursion = state.excursion_at(self.start[i], self.excursion[i], x_end);
            self.allowed[i] = state.allowed(self.relative, excursion, x, x_end);
        }
        estimate(&self.k, h, &self.allowed)
    }

    /// Draws the conclusions from a step with this error.
    #[inline(always)]
    fn conclude<S: LaneSystem>(&mut self, block: &mut Block<S, L>, step: Tried<L>, error: L) {
        let no = L::from_f64(-1.0);
        let (good, bad) = (-error + 1.0, error - 1.0);
        let plain = if block.any_positive(good) {
            block.judge(step, DormandPrince::LOOKS)
        } else {
            no
        };
        let shorter = step.h * share_of_rejected(error, DormandPrince::ORDER);
        let room = shorter - shortest_step(block.t, self.until);
        let room = block.finite_end().if_positive(room, no);
        self.margin = good.if_positive(plain, bad.if_positive(room, no));
        let accepted = self.margin.if_positive(good, no);
        let rejected = self.margin.if_positive(bad, no);

        let most = growth_limit(self.was_rejected);
        let longest = L::from_f64(self.longest);
        let longer = length_after(
            step.h,
            [error, self.last_error],
            DormandPrince::ORDER,
            most,
            self.wanted,
            longest,
        );
        self.wanted = accepted.if_positive(longer, rejected.if_positive(shorter, self.wanted));
        self.last_error = accepted.if_positive(remembered(error), self.last_error);
        self.was_rejected = accepted.if_positive(
            no,
            rejected.if_positive(L::from_f64(1.0), self.was_rejected),
        );
        for (i, state) in self.states.iter().enumerate() {
            let excursion = state.excursion_at(self.start[i], self.excursion[i], block.x_end[i]);
            self.excursion[i] = accepted.if_positive(excursion, self.excursion[i]);
        }
        self.approach = accepted.if_positive(block.longest_step(step), self.approach);
        self.accepted = accepted.if_positive(self.accepted + 1.0, self.accepted);
        self.tried = self.margin.if_positive(self.tried + 1.0, self.tried);
        block.commit_where(accepted, step);
    }
}

impl<L: Lanes> Steps<L> for OwnSteps<L> {
    type Method = DormandPrince;

    fn new(states: usize) -> Self {
        let zero = L::from_f64(0.0);
        let lanes = || vec![zero; states];
        Self {
            stage: lanes(),
            k: vec![lanes(); STAGES],
            allowed: lanes(),
            states: Vec::new(),
            start: lanes(),
            excursion: lanes(),
            relative: 0.0,
            longest: 0.0,
            wanted: zero,
            last_error: L::from_f64(1.0),
            was_rejected: zero,
            approach: zero,
            to: zero,
            until: zero,
            accepted: zero,
            tried: zero,
            most: zero,
            margin: zero,
            left: zero,
        }
    }

    fn of_a_walk(
        accuracy: f64,
        states: &[Variable],
        settings: &Settings,
    ) -> Result<(DormandPrince, Pace), Breakdown> {
        let control = settings.control(accuracy, states)?;
        let method = DormandPrince::new(states.len());
        Ok((method, Pace::Adaptive(control)))
    }

    fn can_take<S: LaneSystem>(&self, _: &mut Walk<'_, S, DormandPrince>) -> bool {
        true
    }

    fn load<S: LaneSystem>(&mut self, lane: usize, walk: &mut Walk<'_, S, DormandPrince>) {
        let to = walk.next_break();
        let Pace::Adaptive(control) = &walk.pace else {
            return;
        };
        self.states.clone_from(&control.states);
        self.relative = control.relative;
        self.longest = control.longest;
        self.wanted.set_entry(lane, control.wanted);
        self.last_error.set_entry(lane, control.last_error);
        let was_rejected = if control.was_rejected { 1.0 } else { -1.0 };
        self.was_rejected.set_entry(lane, was_rejected);
        for (i, state) in control.states.iter().enumerate() {
            self.start[i].set_entry(lane, state.start);
            self.excursion[i].set_entry(lane, state.excursion);
        }
        self.approach.set_entry(lane, walk.approach.longest_step());
        self.to.set_entry(lane, to);
        self.until.set_entry(lane, walk.until);
        self.accepted.set_entry(lane, 0.0);
        self.tried.set_entry(lane, 0.0);
        self.most
            .set_entry(lane, (walk.most_steps - walk.tried) as f64);
        self.margin.set_entry(lane, 1.0);
        self.left.set_entry(lane, to - walk.t);
    }

    fn store<S: LaneSystem>(
        &mut self,
        lane: usize,
        walk: &mut Walk<'_, S, DormandPrince>,
        block: &mut Block<S, L>,
    ) {
        let accepted = self.accepted.entry(lane) as u64;
        let tried = self.tried.entry(lane) as u64;
        walk.tried += tried;
        walk.summary.statistics.rejected += tried - accepted;
        walk.flow.evaluations += (STAGES as u64 - 1) * tried + accepted;
        if let Pace::Adaptive(control) = &mut walk.pace {
            control.wanted = self.wanted.entry(lane);
            control.last_error = self.last_error.entry(lane);
            control.was_rejected = self.was_rejected.entry(lane) > 0.0;
            for (state, excursion) in control.states.iter_mut().zip(&self.excursion) {
                state.excursion = excursion.entry(lane);
            }
        }
        block.store(lane, walk, accepted);
        // An idle lane stands still.
        self.to.set_entry(lane, block.t.entry(lane));
    }

    #[inline(always)]
    fn advance<S: LaneSystem>(&mut self, block: &mut Block<S, L>, rounds: u64) {
        let left = block.least(self.most - self.tried);
        for _ in 0..rounds.min(left as u64) {
            let step = self.next(block.t);
            let error = self.step(block, step);
            self.conclude(block, step, error);
            self.left = self.to - block.t;
            if !block.all_positive(self.margin) || !block.all_positive(self.left) {
                return;
            }
        }
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
