//! Closing: how each loop gives the values and rates of its unknown variables.
//!
//! ```text
//! Step ─▶ sum of turned vectors = 0 ─┬─▶ a parallelogram: angles are those of the opposite sides
//!                                    ├─▶ two unknowns: a dyad, by at most one square root
//!                                    └─▶ more: Newton's method, unrolled
//!         its derivative, linear ─────▶ rates, and rates of rates
//! ```
//!
//! Angles are counted from the assembled configuration, continuous over many turns by a reference
//! in the discrete state. Everything is worked out twice: with running values, and as assembled.

mod dyad;
mod exact;
mod expand;
mod lines;
mod parallel;
mod rates;
mod settle;
mod together;
mod variables;

pub(crate) use parallel::Alias;

use crate::model::{BodyId, GROUND};
use crate::structure::{Leg, Step, Way};
use crate::symbolic::Expr;

use super::Derivation;
use super::turned::{Moving, Turned};

impl Derivation<'_> {
    /// Closes all loops in their order.
    pub(super) fn close_loops(&mut self) {
        let steps = self.structure.steps.clone();
        let dyads = steps
            .iter()
            .filter(|step| !matches!(step, Step::Redundant { .. }))
            .count();
        let mut number = 0;
        for step in &steps {
            match step {
                Step::Close { way, unknowns } => {
                    number += 1;
                    let number = (dyads > 1).then_some(number);
                    let sum = self.around(way);
                    if !self.parallelogram(way, &sum, *unknowns) {
                        self.dyad(way, &sum, *unknowns, number);
                    }
                }
                Step::Redundant { way, unknown } => self.redundant(way, *unknown),
                Step::Together { ways, unknowns } => {
                    number += 1;
                    self.together(ways, unknowns, (dyads > 1).then_some(number));
                }
            }
        }
        self.exact_angles();
    }

    /// The vectors around a loop: their sum is zero.
    fn around(&mut self, way: &Way) -> Vec<Turned> {
        let mut sum = self.place(way.start.0, way.start.1);
        for leg in &way.legs {
            match *leg {
                Leg::Across { body, enter, leave } => {
                    let mut back = self.vector_in(body, enter);
                    self.reverse(&mut back);
                    sum.extend(back);
                    let forth = self.vector_in(body, leave);
                    sum.extend(forth);
                }
                Leg::Along { slide, outward } => {
                    let mut along = self.travelled(slide);
                    if !outward {
                        self.reverse(&mut along);
                    }
                    sum.extend(along);
                }
            }
        }
        let mut end = self.place(way.end.0, way.end.1);
        self.reverse(&mut end);
        sum.extend(end.into_iter().rev());
        self.merge(sum)
    }

    /// Name of a loop by its bodies.
    pub(super) fn way_name(&self, way: &Way) -> String {
        let bodies = self.structure.way_bodies(way);
        crate::structure::loop_names(self.model, &bodies)
    }

    /// The part of a loop's velocity that belongs to one variable, per unit of its rate.
    fn moved_by(&mut self, sum: &[Turned], variable: BodyId) -> Vec<Turned> {
        let moving = self.velocity(sum);
        moving
            .into_iter()
            .filter(|m| m.variable == variable)
            .map(|m| m.vector)
            .collect()
    }

    /// The part of a loop's velocity that belongs to all variables but some.
    fn moved_by_others(&mut self, sum: &[Turned], but: &[BodyId]) -> Vec<Moving> {
        let moving = self.velocity(sum);
        moving
            .into_iter()
            .filter(|m| !but.contains(&m.variable))
            .collect()
    }

    /// |a||b| sin of the angle from a to b.
    fn cross(&mut self, a: &[Turned], b: &[Turned]) -> Expr {
        let mut ahead = a.to_vec();
        ahead
            .iter_mut()
            .for_each(|part| part.quarter = (part.quarter + 1) % 4);
        self.dot(b, &ahead)
    }

    /// Where a loop is to be blamed in the file: the first of the bodies that close it.
    fn way_span(&self, way: &Way, unknowns: &[BodyId]) -> crate::source::Span {
        match (unknowns.first(), way.pin) {
            (Some(body), _) => self.model.bodies[*body].span,
            (None, Some(pin)) => self.model.pins[pin].span,
            (None, None) => {
                self.model.bodies[if way.end.0 == GROUND {
                    way.start.0
                } else {
                    way.end.0
                }]
                .span
            }
        }
    }
}
