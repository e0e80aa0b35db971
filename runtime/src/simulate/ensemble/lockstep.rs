//! Lanes in lockstep: the classical Runge–Kutta method of order 4, each lane with its own equal
//! steps to its own next break.

use super::block::{Block, Tried, also};
use super::steps::{Steps, Verdict};
use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::breakdown::Breakdown;
use crate::simulate::method::Method;
use crate::simulate::pace::Pace;
use crate::simulate::runge_kutta::RungeKutta;
use crate::simulate::settings::Settings;
use crate::simulate::walk::Walk;
use crate::system::Variable;

pub(in crate::simulate) struct Lockstep<L> {
    stage: Vec<L>,
    /// Rates at the second to the fourth stage.
    k: [Vec<L>; 3],
    /// The way to each lane's break, as in `Stretch`.
    from: L,
    to: L,
    h: L,
    steps: L,
    taken: L,
    /// What `taken` may come to.
    most: L,
    /// Positive where the last step was a plain one.
    margin: L,
}

impl<L: Lanes> Lockstep<L> {
    /// Steps of length `h` that end at `end`, in every lane.
    #[inline(always)]
    fn step<S: LaneSystem>(&mut self, block: &mut Block<S, L>, step: Tried<L>) {
        let Self { stage, k, .. } = self;
        let n = stage.len();
        let (x, f, x_end) = (&block.x[..n], &block.f[..n], &mut block.x_end[..n]);
        for index in 0..4 {
            if index < 3 {
                let share = step.h * [0.5, 0.5, 1.0][index];
                let rates: &[L] = if index == 0 { f } else { &k[index - 1][..n] };
                for i in 0..n {
                    stage[i] = rates[i].times_plus(share, x[i]);
                }
                let time = block.t + share;
                S::rhs_in_lanes(
                    &block.system,
                    time,
                    stage,
                    &block.d,
                    &block.u,
                    &mut k[index],
                );
            } else {
                let [k2, k3, k4] = [&k[0][..n], &k[1][..n], &k[2][..n]];
                let sixth = step.h / 6.0;
                for i in 0..n {
                    let sum = f[i] + (k2[i] + k3[i]) * 2.0 + k4[i];
                    x_end[i] = sum.times_plus(sixth, x[i]);
                }
                block.d_end.copy_from_slice(&block.d);
                S::accept_in_lanes(&block.system, step.end, x_end, &block.u, &mut block.d_end);
                S::rhs_in_lanes(
                    &block.system,
                    step.end,
                    x_end,
                    &block.d_end,
                    &block.u,
                    &mut block.f_end,
                );
            }
        }
    }
}

impl<L: Lanes> Steps<L> for Lockstep<L> {
    type Method = RungeKutta;

    fn new(states: usize) -> Self {
        let zero = L::from_f64(0.0);
        Self {
            stage: vec![zero; states],
            k: std::array::from_fn(|_| vec![zero; states]),
            from: zero,
            to: zero,
            h: zero,
            steps: zero,
            taken: zero,
            most: zero,
            margin: zero,
        }
    }

    fn of_a_walk(
        accuracy: f64,
        states: &[Variable],
        _: &Settings,
    ) -> Result<(RungeKutta, Pace), Breakdown> {
        Ok((RungeKutta::new(states.len()), Pace::fixed(accuracy)))
    }

    fn can_take<S: LaneSystem>(&self, walk: &mut Walk<'_, S, RungeKutta>) -> bool {
        let to = walk.next_break();
        let Pace::Fixed(equal) = &mut walk.pace else {
            return false;
        };
        equal.stretch(walk.t, to).h < walk.approach.longest_step()
    }

    fn load<S: LaneSystem>(&mut self, lane: usize, walk: &mut Walk<'_, S, RungeKutta>) {
        let to = walk.next_break();
        let Pace::Fixed(equal) = &mut walk.pace else {
            return;
        };
        let stretch = equal.stretch(walk.t, to);
        self.from.set_entry(lane, stretch.from);
        self.to.set_entry(lane, stretch.to);
        self.h.set_entry(lane, stretch.h);
        self.steps.set_entry(lane, stretch.steps);
        self.taken.set_entry(lane, stretch.taken);
        let left = (walk.most_steps - walk.tried) as f64;
        self.most.set_entry(lane, stretch.taken + left);
        self.margin.set_entry(lane, 1.0);
    }

    fn store<S: LaneSystem>(
        &mut self,
        lane: usize,
        walk: &mut Walk<'_, S, RungeKutta>,
        block: &mut Block<S, L>,
    ) {
        let to = walk.next_break();
        let Pace::Fixed(equal) = &mut walk.pace else {
            return;
        };
        let stretch = equal.stretch(walk.t, to);
        let taken = self.taken.entry(lane) - stretch.taken;
        stretch.taken += taken;
        walk.tried += taken as u64;
        walk.flow.evaluations += 4 * taken as u64;
        block.store(lane, walk, taken as u64);
        // An idle lane stands still.
        self.h.set_entry(lane, 0.0);
        self.from.set_entry(lane, walk.t);
        self.to.set_entry(lane, walk.t);
    }

    #[inline(always)]
    fn advance<S: LaneSystem>(&mut self, block: &mut Block<S, L>, rounds: u64) {
        let left = block.least(self.steps.smaller(self.most) - self.taken);
        for _ in 0..rounds.min(left as u64) {
            let taken = self.taken + 1.0;
            let step = Tried {
                h: self.h,
                end: (self.steps - taken).if_positive(self.from + taken * self.h, self.to),
            };
            self.step(block, step);
            let margin = block.judge(step, RungeKutta::LOOKS);
            self.margin = also(margin, block.longest_step(step) - self.h);
            if block.all_positive(self.margin) {
                block.commit(step);
                self.taken = taken;
            } else {
                block.commit_where(self.margin, step);
                self.taken = self.margin.if_positive(taken, self.taken);
                return;
            }
        }
    }

    fn verdict(&self, lane: usize) -> Verdict {
        let taken = self.taken.entry(lane);
        if taken >= self.steps.entry(lane) {
            Verdict::Arrived
        } else if !(self.margin.entry(lane) > 0.0) || taken >= self.most.entry(lane) {
            Verdict::Special
        } else {
            Verdict::UnderWay
        }
    }
}
