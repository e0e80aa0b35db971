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
    /// What it comes to with the step that passes the row.
    row: L,
    /// Positive where the last step was a plain one.
    margin: L,
}

/// Steps of length `h` from `from` to `to`, whose time is set, in every lane. The stages are written one
/// after the other: a loop over them would send states and rates through memory between any two,
/// a tenth of the time.
#[inline(always)]
fn step<S: LaneSystem, L: Lanes>(
    block: &Block<S, L>,
    h: L,
    from: &Point<S, L>,
    to: &mut Point<S, L>,
    stage: &mut S::States<L>,
) {
    let n = from.x.as_ref().len();
    to.x.as_mut().copy_from_slice(from.x.as_ref());
    to.d.as_mut().copy_from_slice(from.d.as_ref());
    to.f.as_mut().copy_from_slice(from.f.as_ref());
    macro_rules! move_on {
        ($index:literal) => {
            let (away, weight) = (h * STAGES[$index].0, h * STAGES[$index].1);
            let (x, f) = (to.x.as_mut(), to.f.as_ref());
            let (start, stage) = (from.x.as_ref(), stage.as_mut());
            for i in 0..n {
                x[i] = f[i].times_plus(weight, x[i]);
                stage[i] = f[i].times_plus(away, start[i]);
            }
        };
    }
    macro_rules! rates {
        ($time:expr, $at:expr) => {
            let (x, d) = ($at.as_ref(), to.d.as_ref());
            S::rhs_in_lanes(&block.system, $time, x, d, &block.u, to.f.as_mut());
        };
    }
    let half = from.t + h * 0.5;
    move_on!(0);
    rates!(half, stage);
    move_on!(1);
    rates!(half, stage);
    move_on!(2);
    rates!(from.t + h, stage);
    move_on!(3);
    S::accept_in_lanes(&block.system, to.t, to.x.as_ref(), &block.u, to.d.as_mut());
    rates!(to.t, to.x);
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
            row: L::from_f64(f64::INFINITY),
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
        self.most.set_entry(lane, stretch.taken + left);
        self.row.set_entry(lane, stretch.steps_to(way.row));
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
        let h = stretch.h;
        block.store(lane, stand, taken as u64);
        if let Some(last) = way.last
            && stand.t >= way.row
            && taken > 0.0
        {
            block.write_down(lane, h, last.start);
        }
        // An idle lane stands still.
        self.h.set_entry(lane, 0.0);
        self.from.set_entry(lane, stand.t);
        self.to.set_entry(lane, stand.t);
    }

    #[inline(always)]
    fn advance(&mut self, block: &mut Block<S, L>, rounds: u64) {
        let most = self.steps.smaller(self.most).smaller(self.row);
        let rounds = rounds.min(block.least(most - self.taken) as u64);
        let mut here = block.here.clone();
        let (mut end, mut stage) = (here.clone(), here.x.clone());
        for round in 1..=rounds {
            if round == rounds {
                block.before.take(&here);
            }
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
