//! Links that parallelograms hold parallel to ground: their angles cannot be coordinates.
//!
//! Two legs of one length that stand on a frame as far apart as on a link keep the link parallel
//! to the frame, if they are drawn parallel. All lengths are compared as expressions, so that it
//! holds for all params. What is parallel to ground over any number of such frames does not turn.

use std::collections::HashMap;

use crate::model::{BodyId, BodyKind, GROUND, Local, Model};
use crate::structure::turning_link;
use crate::symbolic::{Expr, Graph};

/// The links whose angles cannot change, by body.
pub(crate) fn held_parallel(model: &Model) -> Vec<bool> {
    let mut frames = Frames {
        model,
        g: model.graph.clone(),
        pins_of: vec![Vec::new(); model.bodies.len()],
    };
    for (pin, joined) in model.pins.iter().enumerate() {
        for (body, at) in &joined.members {
            frames.pins_of[*body].push((pin, *at));
        }
    }
    // Slides turn with what carries them.
    let mut carriers = vec![Vec::new(); model.bodies.len()];
    for body in 0..model.bodies.len() {
        carriers[turning_link(model, body).unwrap_or(GROUND)].push(body);
    }
    let mut held = vec![false; model.bodies.len()];
    let mut last = vec![GROUND];
    // From ground outwards: each frame that is held holds others.
    while let Some(frame) = last.pop() {
        for &carrier in &carriers[frame] {
            for link in frames.parallel_to(carrier) {
                if !held[link] {
                    held[link] = true;
                    last.push(link);
                }
            }
        }
    }
    held
}

/// A pin on a body, and its place there.
type Joint = (usize, Local);

/// A leg that stands on a frame.
#[derive(Clone, Copy)]
struct Leg {
    link: BodyId,
    /// Its pin on the frame.
    foot: usize,
    /// From the foot to the head in the leg's frame.
    along: [Expr; 2],
    /// Its other pin.
    head: usize,
    /// The foot in the frame.
    stands: [Expr; 2],
}

struct Frames<'m> {
    model: &'m Model,
    g: Graph,
    /// The pins on each body.
    pins_of: Vec<Vec<Joint>>,
}

impl Frames<'_> {
    /// The links that pairs of equal legs on `carrier` hold parallel to it.
    fn parallel_to(&mut self, carrier: BodyId) -> Vec<BodyId> {
        let legs = self.legs(carrier);
        let mut by_head: HashMap<usize, Vec<usize>> = HashMap::new();
        for (index, leg) in legs.iter().enumerate() {
            by_head.entry(leg.head).or_default().push(index);
        }
        let model = self.model;
        let mut found = Vec::new();
        for one in &legs {
            for &(link, from) in &model.pins[one.head].members {
                let is_link = matches!(model.bodies[link].kind, BodyKind::Link(_));
                if !is_link || link == one.link {
                    continue;
                }
                for (head, to) in self.pins_of[link].clone() {
                    let others = by_head.get(&head).into_iter().flatten();
                    let others = others.map(|index| &legs[*index]);
                    for other in others.filter(|other| other.link != link) {
                        if self.is_parallelogram(one, other, [from, to]) {
                            found.push(link);
                        }
                    }
                }
            }
        }
        found
    }

    /// Whether two legs are equal and parallel, and as far apart as two places of another link.
    fn is_parallelogram(&mut self, one: &Leg, other: &Leg, [from, to]: [Local; 2]) -> bool {
        if one.link == other.link || one.foot == other.foot || one.head == other.head {
            return false;
        }
        let apart = [0, 1].map(|i| self.g.sub(other.stands[i], one.stands[i]));
        let across = self.between(from, to);
        across.is_some_and(|across| self.turned(apart, across).is_some())
            && self.are_parallel(one, other)
    }

    /// The links on a body, each with every way over it.
    fn legs(&mut self, frame: BodyId) -> Vec<Leg> {
        let mut legs = Vec::new();
        for (pin, there) in self.pins_of[frame].clone() {
            for (link, at) in &self.model.pins[pin].members {
                let is_link = matches!(self.model.bodies[*link].kind, BodyKind::Link(_));
                if !is_link || *link == frame {
                    continue;
                }
                for (head, end) in self.pins_of[*link].clone() {
                    if head == pin {
                        continue;
                    }
                    let (Some(along), Some(stands)) = (self.between(*at, end), self.plain(there))
                    else {
                        continue;
                    };
                    legs.push(Leg {
                        link: *link,
                        foot: pin,
                        along,
                        head,
                        stands,
                    });
                }
            }
        }
        legs
    }

    /// Whether two legs are equally long and drawn parallel.
    fn are_parallel(&mut self, one: &Leg, other: &Leg) -> bool {
        let guess = |link: BodyId| match &self.model.bodies[link].kind {
            BodyKind::Link(link) => link.angle.value,
            BodyKind::Slide(_) | BodyKind::Ground => None,
        };
        let (Some(first), Some(second)) = (guess(one.link), guess(other.link)) else {
            return false;
        };
        let Some(quarters) = self.turned(one.along, other.along) else {
            return false;
        };
        // other.along is one.along turned by so many quarters, and so are their frames back.
        let ahead = self.g.sub(first, second);
        let pi = self.g.pi();
        let halves = self.g.div(ahead, pi);
        let off = self.g.ratio(i64::from(quarters), 2);
        let off = self.g.sub(halves, off);
        let turns = self.g.ratio(1, 2);
        let turns = self.g.mul(off, turns);
        self.g.as_number(turns).is_some_and(|n| n.is_integer())
    }

    /// By how many quarter turns `b` is ahead of `a`, if they are equally long and it is whole.
    fn turned(&mut self, a: [Expr; 2], b: [Expr; 2]) -> Option<u8> {
        let mut turned = a;
        for quarters in 0..4 {
            if turned == b {
                return Some(quarters);
            }
            turned = [self.g.neg(turned[1]), turned[0]];
        }
        None
    }

    /// From one place of a body to another.
    fn between(&mut self, from: Local, to: Local) -> Option<[Expr; 2]> {
        let (from, to) = (self.plain(from)?, self.plain(to)?);
        Some([0, 1].map(|i| self.g.sub(to[i], from[i])))
    }

    /// A place as two lengths; of a place by length and angle only where it lies on the x axis.
    fn plain(&mut self, at: Local) -> Option<[Expr; 2]> {
        let zero = self.g.zero();
        match at {
            Local::Origin => Some([zero, zero]),
            Local::Cartesian(x, y) => Some([x, y]),
            Local::Polar(radius, angle) => self.g.is_zero(angle).then_some([radius, zero]),
        }
    }
}
