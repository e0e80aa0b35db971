//! Lanes in lockstep: the classical Runge–Kutta method of order 4, each lane with its own equal
//! steps to its own next break.

use super::block::{Block, Point, also};
use super::steps::{Steps, Verdict, Way};
use crate::lanes::{LaneSystem, Lanes};
use crate::simulate::method::Method;
use crate::simulate::pace::Pace;
use crate::simulate::runge_kutta::{RungeKutta, STAGES};
use crate::simulate::stand::Stand;

pub(in crate::simulate) struct Lockstep<L> {
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

/// Steps of length `h` from `from` to `to`, whose time is set, in every lane. All that is stepped
/// through are local numbers: there is one place where the right-hand side is evaluated.
#[inline(always)]
fn step<S: LaneSystem, L: Lanes>(
    block: &Block<S, L>,
    h: L,
    from: &Point<S, L>,
    to: &mut Point<S, L>,
    stage: &mut S::States<L>,
) {
    let n = from.x.as_ref().len();
    to.f.as_mut().copy_from_slice(from.f.as_ref());
    to.x.as_mut().copy_from_slice(from.x.as_ref());
    to.d.as_mut().copy_from_slice(from.d.as_ref());
    for (index, (away, weight)) in STAGES.into_iter().enumerate() {
        let (away, weight) = (h * away, h * weight);
        {
            let (x, f) = (to.x.as_mut(), to.f.as_ref());
            let (start, stage) = (from.x.as_ref(), stage.as_mut());
            for i in 0..n {
                x[i] = f[i].times_plus(weight, x[i]);
                stage[i] = f[i].times_plus(away, start[i]);
            }
        }
        let mut time = from.t + away;
        if index + 1 == STAGES.len() {
            time = to.t;
            stage.as_mut().copy_from_slice(to.x.as_ref());
            S::accept_in_lanes(&block.system, time, to.x.as_ref(), &block.u, to.d.as_mut());
        }
        let (x, d) = (stage.as_ref(), to.d.as_ref());
        S::rhs_in_lanes(&block.system, time, x, d, &block.u, to.f.as_mut());
    }
}

impl<S: LaneSystem, L: Lanes> Steps<S, L> for Lockstep<L> {
    fn new(_: usize) -> Self {
        let zero = L::from_f64(0.0);
        Self {
            from: zero,
            to: zero,
            h: zero,
            steps: zero,
            taken: zero,
            most: zero,
            margin: zero,
        }
    }

    fn can_take(stand: &mut Stand, to: f64) -> bool {
        let Pace::Fixed(equal) = &mut stand.pace else {
            return false;
        };
        equal.stretch(stand.t, to).h < stand.approach.longest_step()
    }

    fn load(&mut self, lane: usize, stand: &mut Stand, way: &Way<'_>) {
        let Pace::Fixed(equal) = &mut stand.pace else {
            return;
        };
        let stretch = equal.stretch(stand.t, way.to);
        self.from.set_entry(lane, stretch.from);
        self.to.set_entry(lane, stretch.to);
        self.h.set_entry(lane, stretch.h);
        self.steps.set_entry(lane, stretch.steps);
        self.taken.set_entry(lane, stretch.taken);
        let left = (stand.most_steps - stand.tried) as f64;
        let most = stretch.taken + left;
        let before_row = ((way.row - stretch.from) / stretch.h).floor();
        self.most.set_entry(lane, most.min(before_row));
        self.margin.set_entry(lane, 1.0);
    }

    fn store(&mut self, lane: usize, stand: &mut Stand, way: Way<'_>, block: &mut Block<S, L>) {
        let Pace::Fixed(equal) = &mut stand.pace else {
            return;
        };
        let stretch = equal.stretch(stand.t, way.to);
        let taken = self.taken.entry(lane) - stretch.taken;
        stretch.taken += taken;
        stand.tried += taken as u64;
        stand.statistics.evaluations += 4 * taken as u64;
        block.store(lane, stand, taken as u64);
        // An idle lane stands still.
        self.h.set_entry(lane, 0.0);
        self.from.set_entry(lane, stand.t);
        self.to.set_entry(lane, stand.t);
    }

    #[inline(always)]
    fn advance(&mut self, block: &mut Block<S, L>, rounds: u64) {
        let left = block.least(self.steps.smaller(self.most) - self.taken);
        let mut here = block.here.clone();
        let (mut end, mut stage) = (here.clone(), here.x.clone());
        for _ in 0..rounds.min(left as u64) {
            let taken = self.taken + 1.0;
            end.t = (self.steps - taken).if_positive(self.from + taken * self.h, self.to);
            step(block, self.h, &here, &mut end, &mut stage);
            let passed = end.t - here.t;
            let margin = block.judge(&here, &end, self.h, RungeKutta::LOOKS);
            self.margin = also(margin, block.may_step(self.h, passed));
            if !block.all_positive(self.margin) {
                block.follow_where(self.margin, passed, &end);
                here.take_where(self.margin, &end);
                self.taken = self.margin.if_positive(taken, self.taken);
                break;
            }
            block.follow(passed, &end);
            here.take(&end);
            self.taken = taken;
        }
        block.here = here;
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
