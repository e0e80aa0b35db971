//! Reach: over which range of each coordinate every loop of a mechanism closes.
//!
//! A coordinate is led outward from its assembled value in steps, the others held there; loops
//! follow on their branch, by the same functions that a simulation asks
//! ([`System::closures`], [`System::accept`]). Where a loop no longer closes the steps shrink until
//! they are lost in rounding: there is the dead point. Between steps each loop's closure is
//! followed to its minima, so that none is missed that lies inside a step.

// `!(a > b)` is meant where it stands: what is not a number is then on the safe side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use std::f64::consts::TAU;

use flexure_model_dsl::equations::Equations;
use flexure_runtime::system::System;

mod words;

pub use words::facts;

/// Steps in a turn, and in a slide's travel by the size of the mechanism.
const STEPS: f64 = 360.0;
/// How far a slide is led, in sizes of the mechanism.
const FARTHEST: f64 = 10.0;
/// No link may turn by more than this in a step, in rad: it would have changed its branch.
const MOST_TURN: f64 = 0.5;
/// A closure below this is a dead point: the sine of a transmission angle of 1e-7 rad, squared. It
/// decides only where a loop touches its dead point without passing it.
const TOUCHES: f64 = 1e-14;
/// Evaluations in one direction: far above what any mechanism takes.
const MOST_TRIALS: usize = 100_000;

/// How far a coordinate that loops follow can be led from its assembled value.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Its position among the states.
    pub state: usize,
    /// Downwards.
    pub lower: Limit,
    /// Upwards.
    pub upper: Limit,
    /// For each loop of the equations how near it comes to a dead point on the way.
    pub approaches: Vec<Approach>,
}

/// What ends a coordinate's range on one side.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// Nothing: a link comes round, or a slide moves by ten times the mechanism's size.
    None,
    /// Loops, by their positions, reach a dead point at this value, in rad or m: one loop, or those
    /// that close together.
    DeadPoint(f64, Vec<usize>),
}

/// How near a loop comes to a dead point: its closures, which are squared sines of the transmission
/// angle for loops that have one.
///
/// The transmission angle is that between the links that meet in the middle joint of the dyad, in
/// a four-bar coupler and rocker, taken as the acute angle (Norton, Design of Machinery, 2012,
/// section 3.3). Where one member of the dyad is a slide it is the angle between the link and the
/// normal of the guide, for a link pinned to the slide; between the guide and the line from the
/// slide's pin to the link's own pivot, for a slide along the link; between the guides of two
/// slides. In each case 90° is best, and at 0° the force that the dyad transmits has no lever: it
/// stands at a dead point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// As assembled.
    pub assembled: f64,
    /// The least on the way.
    pub least: f64,
    /// Value of the coordinate in rad or m where it is least.
    pub at: f64,
    /// The greatest on the way.
    pub greatest: f64,
}

impl Approach {
    /// The transmission angle in rad as assembled, for loops that have one.
    pub fn assembled_angle(&self) -> f64 {
        angle(self.assembled)
    }

    /// The transmission angle in rad where it is least, for loops that have one.
    pub fn least_angle(&self) -> f64 {
        angle(self.least)
    }
}

impl Approach {
    fn comes_to(&mut self, at: f64, closure: f64) {
        if closure < self.least {
            (self.at, self.least) = (at, closure);
        }
        self.greatest = self.greatest.max(closure);
    }
}

fn angle(closure: f64) -> f64 {
    closure.clamp(0.0, 1.0).sqrt().asin()
}

/// The reach of each coordinate that loops follow; `assembled` is the value of each state that is a
/// coordinate, `size` that of the mechanism in m.
pub fn reaches(
    system: &dyn System,
    equations: &Equations,
    assembled: &[Option<f64>],
    size: f64,
) -> Vec<Reach> {
    let mut x = vec![0.0; system.states().len()];
    // References of loops are zero as assembled; nothing else that is discrete moves a loop.
    let d = vec![0.0; system.discretes().len()];
    system.start(&mut x, &mut d.clone());
    for (value, assembled) in x.iter_mut().zip(assembled) {
        *value = assembled.unwrap_or(*value);
    }
    let inputs = system.inputs().iter();
    let u: Vec<f64> = inputs.map(|row| row.start.unwrap_or(0.0)).collect();
    let leading = equations.states.iter().enumerate().filter(|(_, state)| {
        state
            .coordinate
            .is_some_and(|coordinate| coordinate.leads_loops)
    });
    leading
        .map(|(state, row)| {
            let (longest, farthest) = if row.unit == "rad" {
                (TAU / STEPS, TAU)
            } else {
                (size / STEPS, FARTHEST * size)
            };
            let mut walker = Walker {
                system,
                equations,
                x: x.clone(),
                u: &u,
                state,
                longest,
                farthest,
                approaches: Vec::new(),
            };
            walker.reach(&d)
        })
        .collect()
}

/// Leads one coordinate.
struct Walker<'a> {
    system: &'a dyn System,
    equations: &'a Equations,
    x: Vec<f64>,
    u: &'a [f64],
    state: usize,
    longest: f64,
    farthest: f64,
    approaches: Vec<Approach>,
}

/// A configuration in which every loop closes.
#[derive(Clone)]
struct Stand {
    at: f64,
    d: Vec<f64>,
    closures: Vec<f64>,
}

impl Walker<'_> {
    fn reach(&mut self, d: &[f64]) -> Reach {
        let at = self.x[self.state];
        let from = Stand {
            at,
            d: d.to_vec(),
            closures: Vec::new(),
        };
        let (lower, upper) = match self.stand(&from, at) {
            Ok(start) => {
                let closures = start.closures.iter();
                self.approaches = closures
                    .map(|&closure| Approach {
                        assembled: closure,
                        least: closure,
                        at,
                        greatest: closure,
                    })
                    .collect();
                (self.lead(&start, -1.0), self.lead(&start, 1.0))
            }
            Err(loops) => {
                let limit = Limit::DeadPoint(at, loops);
                (limit.clone(), limit)
            }
        };
        Reach {
            state: self.state,
            lower,
            upper,
            approaches: std::mem::take(&mut self.approaches),
        }
    }

    /// Goes from `start` in direction `sign` until a loop reaches a dead point, or far enough.
    fn lead(&mut self, start: &Stand, sign: f64) -> Limit {
        let mut here = start.clone();
        let mut before = self.stand(start, start.at - sign * self.longest).ok();
        let mut step = self.longest;
        let end = start.at + sign * self.farthest;
        let mut blocking = Vec::new();
        for _ in 0..MOST_TRIALS {
            let left = (end - here.at).abs();
            if left <= 1e-12 * self.farthest {
                return Limit::None;
            }
            let shortest = f64::EPSILON * here.at.abs().max(self.longest);
            if step < shortest {
                break;
            }
            match self.stand(&here, here.at + sign * step.min(left)) {
                Err(loops) => {
                    blocking = loops;
                    step *= 0.25;
                }
                Ok(there) => {
                    if let Some(before) = &before
                        && let Some(limit) = self.dip(start.at, [before, &here, &there])
                    {
                        return limit;
                    }
                    self.notice(&there);
                    before = Some(std::mem::replace(&mut here, there));
                    step = (2.0 * step).min(self.longest);
                }
            }
        }
        self.touch(&blocking, here.at);
        Limit::DeadPoint(here.at, blocking)
    }

    /// The configuration with the coordinate at `at`, loops followed from where they stood; or the
    /// loops that cannot be followed.
    fn stand(&mut self, from: &Stand, at: f64) -> Result<Stand, Vec<usize>> {
        self.x[self.state] = at;
        let mut closures = vec![0.0; self.system.loop_count()];
        let (system, x, u) = (self.system, &self.x, self.u);
        system.closures(0.0, x, &from.d, u, &mut closures);
        // A loop that fails makes those that follow it not-a-number.
        if let Some(first) = closures.iter().position(|closure| !(*closure > 0.0)) {
            return Err(self.closed_with(first));
        }
        let mut d = from.d.clone();
        system.accept(0.0, x, u, &mut d);
        let turned = |&index: &usize| !((d[index] - from.d[index]).abs() < MOST_TURN);
        if system.turning().iter().any(turned) {
            return Err(self.nearest(&closures));
        }
        Ok(Stand { at, d, closures })
    }

    /// The loops that close together with this one.
    fn closed_with(&self, first: usize) -> Vec<usize> {
        let loops = &self.equations.loops;
        (0..loops.len())
            .filter(|&index| loops[index].closure == loops[first].closure)
            .collect()
    }

    /// The loop nearest to its dead point, and those that close together with it.
    fn nearest(&self, closures: &[f64]) -> Vec<usize> {
        let least = (0..closures.len()).min_by(|&a, &b| closures[a].total_cmp(&closures[b]));
        least.map_or_else(Vec::new, |index| self.closed_with(index))
    }

    fn notice(&mut self, there: &Stand) {
        for (approach, &closure) in self.approaches.iter_mut().zip(&there.closures) {
            approach.comes_to(there.at, closure);
        }
    }

    /// Loops reach a dead point there.
    fn touch(&mut self, loops: &[usize], at: f64) {
        for &index in loops {
            self.approaches[index].comes_to(at, 0.0);
        }
    }

    /// Follows the closure of each loop that is least at the middle of three configurations to its
    /// minimum: a dead point may lie there. What lies on the other side of `start` is not asked.
    fn dip(&mut self, start: f64, [before, here, there]: [&Stand; 3]) -> Option<Limit> {
        let mut nearest: Option<Limit> = None;
        for index in 0..here.closures.len() {
            let [a, b, c] = [before, here, there].map(|stand| stand.closures[index]);
            let is_least = b < a && b <= c;
            if !is_least {
                continue;
            }
            let (at, closure) = self.bottom(before, there.at, index);
            if (at - start) * (there.at - start) < 0.0 {
                continue;
            }
            if closure > TOUCHES {
                self.approaches[index].comes_to(at, closure);
                continue;
            }
            let at = if closure < -TOUCHES {
                self.first_dead(before, at, index)
            } else {
                at
            };
            let is_nearer = match &nearest {
                Some(Limit::DeadPoint(other, _)) => {
                    (at - before.at).abs() < (other - before.at).abs()
                }
                _ => true,
            };
            if is_nearer {
                nearest = Some(Limit::DeadPoint(at, self.closed_with(index)));
            }
        }
        if let Some(Limit::DeadPoint(at, loops)) = &nearest {
            self.touch(loops, *at);
        }
        nearest
    }

    /// Closure of a loop with the coordinate at `at`, followed from `from`; below zero where it or
    /// a loop before it cannot close.
    fn closure(&mut self, from: &Stand, at: f64, index: usize) -> f64 {
        self.x[self.state] = at;
        let mut closures = vec![0.0; self.system.loop_count()];
        self.system
            .closures(0.0, &self.x, &from.d, self.u, &mut closures);
        if closures[index].is_nan() {
            -1.0
        } else {
            closures[index]
        }
    }

    /// The least closure of a loop between `from` and `end`, by golden sections: where, how much.
    fn bottom(&mut self, from: &Stand, end: f64, index: usize) -> (f64, f64) {
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let (mut a, mut b) = (from.at, end);
        let inner = |a: f64, b: f64| [b - golden * (b - a), a + golden * (b - a)];
        let [mut left, mut right] = inner(a, b);
        let mut low = self.closure(from, left, index);
        let mut high = self.closure(from, right, index);
        for _ in 0..60 {
            if low <= high {
                (b, right, high) = (right, left, low);
                left = inner(a, b)[0];
                low = self.closure(from, left, index);
            } else {
                (a, left, low) = (left, right, high);
                right = inner(a, b)[1];
                high = self.closure(from, right, index);
            }
        }
        if low <= high {
            (left, low)
        } else {
            (right, high)
        }
    }

    /// Where on the way to `dead` a loop comes to its dead point.
    fn first_dead(&mut self, from: &Stand, dead: f64, index: usize) -> f64 {
        let (mut closed, mut dead) = (from.at, dead);
        for _ in 0..100 {
            let middle = 0.5 * (closed + dead);
            if self.closure(from, middle, index) > 0.0 {
                closed = middle;
            } else {
                dead = middle;
            }
        }
        dead
    }
}
