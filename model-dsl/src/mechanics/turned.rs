//! Sums of turned vectors: how every place and velocity of a planar mechanism is written.
//!
//! A vector of magnitude a in the frame of a link with angle φ is a·e^{i(φ + β)}. A place is a sum
//! of such vectors, those of slides scaled by the slide's position; its velocity is the sum of the
//! same vectors a quarter turn further, times the rates of their angles. Scalar products are
//! cosines of differences of angles. Trigonometry is never expanded here: quarter turns are
//! counted, so cos(θ + π/2) is written -sin θ from the start.

use crate::model::{BodyId, BodyKind, Local, Slide};
use crate::structure::{Attachment, turning_link};
use crate::symbolic::{Expr, Function, Graph};

use super::Derivation;

/// `magnitude · position of slide · e^{i(angle of link + offset + quarter·π/2)}`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turned {
    /// Length in m (or a number, for directions).
    pub magnitude: Expr,
    /// Slide whose position scales it.
    pub slide: Option<BodyId>,
    /// Link with which it turns; `None` for the fixed frame.
    pub link: Option<BodyId>,
    /// Constant angle in rad.
    pub offset: Option<Expr>,
    /// Quarter turns, 0 to 3.
    pub quarter: u8,
}

/// A term of a velocity: the rate of `variable` (a link's angle or a slide's position) times
/// `vector`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving {
    pub variable: BodyId,
    pub vector: Turned,
}

/// cos(angle + quarter·π/2).
pub(crate) fn wave(g: &mut Graph, angle: Option<Expr>, quarter: u8) -> Expr {
    let Some(angle) = angle else {
        return g.integer([1, 0, -1, 0][usize::from(quarter % 4)]);
    };
    match quarter % 4 {
        0 => g.cos(angle),
        1 => {
            let sin = g.sin(angle);
            g.neg(sin)
        }
        2 => {
            let cos = g.cos(angle);
            g.neg(cos)
        }
        _ => g.sin(angle),
    }
}

/// coefficient · (cos(now + quarter·π/2) - cos(then + quarter·π/2)) without cancellation, written
/// with a positive sign.
fn wave_difference(g: &mut Graph, coefficient: Expr, now: Expr, then: Expr, quarter: u8) -> Expr {
    let (function, negative) = match quarter % 4 {
        0 => (Function::CosDifference, false),
        1 => (Function::SinDifference, true),
        2 => (Function::CosDifference, true),
        _ => (Function::SinDifference, false),
    };
    let (coefficient, swap) = if g.is_written_negative(coefficient) {
        (g.neg(coefficient), !negative)
    } else {
        (coefficient, negative)
    };
    let difference = if swap {
        g.function(function, &[then, now])
    } else {
        g.function(function, &[now, then])
    };
    g.mul(coefficient, difference)
}

impl Derivation<'_> {
    /// The link with whose angle a body turns, and by how many quarter turns it is ahead: links
    /// that turn with others are told by those.
    fn turning(&self, body: BodyId) -> (Option<BodyId>, u8) {
        let own = turning_link(self.model, body);
        match own.and_then(|link| self.aliases[link]) {
            Some(alias) => (alias.link, alias.quarter),
            None => (own, 0),
        }
    }

    /// The link with whose angle a body turns.
    pub(crate) fn turned_link(&self, body: BodyId) -> Option<BodyId> {
        self.turning(body).0
    }

    /// A vector given in a body's frame, as turned vectors.
    pub(crate) fn vector_in(&mut self, body: BodyId, local: Local) -> Vec<Turned> {
        let (link, turn) = self.turning(body);
        let turned = |magnitude, offset, quarter| Turned {
            magnitude,
            slide: None,
            link,
            offset,
            quarter: (quarter + turn) % 4,
        };
        let parts = match local {
            Local::Origin => Vec::new(),
            Local::Polar(radius, angle) if self.g.is_zero(angle) => vec![turned(radius, None, 0)],
            Local::Polar(radius, angle) => vec![turned(radius, Some(angle), 0)],
            Local::Cartesian(x, y) => vec![turned(x, None, 0), turned(y, None, 1)],
        };
        self.merge(parts)
    }

    /// The place of a point of a body, from ground by the body's shortest way.
    pub(crate) fn place(&mut self, body: BodyId, local: Local) -> Vec<Turned> {
        let mut sum = self.frame(body);
        sum.extend(self.vector_in(body, local));
        self.merge(sum)
    }

    /// The place of the origin of a body's frame.
    fn frame(&mut self, body: BodyId) -> Vec<Turned> {
        let mut sum = Vec::new();
        let mut at = body;
        loop {
            let (parts, next) = match self.structure.attachments[at] {
                Attachment::Root => {
                    // From ground outwards, as one would write the way down.
                    sum.reverse();
                    return sum;
                }
                Attachment::Pinned {
                    parent,
                    there,
                    here,
                } => {
                    let mut parts = self.vector_in(parent, there);
                    let mut back = self.vector_in(at, here);
                    self.reverse(&mut back);
                    parts.extend(back);
                    (parts, parent)
                }
                Attachment::Guided { carrier } => (self.guided(at), carrier),
                Attachment::Carried { slide } => {
                    let mut parts = self.guided(slide);
                    self.reverse(&mut parts);
                    (parts, slide)
                }
            };
            sum.extend(parts.into_iter().rev());
            at = next;
        }
    }

    /// The place of a slide from the origin of its carrier's frame.
    fn guided(&mut self, slide: BodyId) -> Vec<Turned> {
        let BodyKind::Slide(Slide {
            carrier, origin, ..
        }) = self.model.bodies[slide].kind
        else {
            return Vec::new();
        };
        let mut parts = self.vector_in(carrier, origin);
        let travelled = self.travelled(slide);
        parts.extend(travelled);
        parts
    }

    /// What a slide has travelled along its guide from the guide's origin.
    pub(crate) fn travelled(&mut self, slide: BodyId) -> Vec<Turned> {
        let mut along = self.guide(slide);
        along.iter_mut().for_each(|part| part.slide = Some(slide));
        along
    }

    /// Turns a vector round.
    pub(crate) fn reverse(&mut self, sum: &mut [Turned]) {
        for part in sum {
            part.magnitude = self.g.neg(part.magnitude);
        }
    }

    /// Adds magnitudes of parallel parts; drops what is zero.
    pub(crate) fn merge(&mut self, parts: Vec<Turned>) -> Vec<Turned> {
        let mut merged: Vec<Turned> = Vec::with_capacity(parts.len());
        for part in parts {
            let parallel = merged.iter_mut().find(|known| {
                (known.slide, known.link, known.offset, known.quarter % 2)
                    == (part.slide, part.link, part.offset, part.quarter % 2)
            });
            match parallel {
                Some(known) if known.quarter == part.quarter => {
                    known.magnitude = self.g.add(known.magnitude, part.magnitude);
                }
                // Half a turn apart.
                Some(known) => known.magnitude = self.g.sub(known.magnitude, part.magnitude),
                None => merged.push(part),
            }
        }
        merged.retain(|part| !self.g.is_zero(part.magnitude));
        merged
    }

    /// The fixed direction (x, y).
    pub(crate) fn fixed(&mut self, [x, y]: [Expr; 2]) -> Vec<Turned> {
        self.vector_in(crate::model::GROUND, Local::Cartesian(x, y))
    }

    /// The direction of a slide's guide.
    pub(crate) fn guide(&mut self, slide: BodyId) -> Vec<Turned> {
        match &self.model.bodies[slide].kind {
            BodyKind::Slide(Slide {
                carrier,
                direction: [x, y],
                ..
            }) => self.vector_in(*carrier, Local::Cartesian(*x, *y)),
            BodyKind::Ground | BodyKind::Link(_) => Vec::new(),
        }
    }

    /// The velocity that belongs to a place, term by term.
    pub(crate) fn velocity(&mut self, place: &[Turned]) -> Vec<Moving> {
        let mut terms = Vec::new();
        for part in place {
            if let Some(slide) = part.slide {
                let vector = Turned {
                    slide: None,
                    ..*part
                };
                terms.push(Moving {
                    variable: slide,
                    vector,
                });
            }
            if let Some(link) = part.link {
                let vector = Turned {
                    quarter: (part.quarter + 1) % 4,
                    ..*part
                };
                terms.push(Moving {
                    variable: link,
                    vector,
                });
            }
        }
        terms
    }

    /// Angle of a turned vector without its quarter turns; `None` if it is zero.
    pub(crate) fn angle(&mut self, part: &Turned) -> Option<Expr> {
        let link = part.link.map(|link| self.variable(link).value);
        match (link, part.offset) {
            (Some(link), Some(offset)) => Some(self.g.add(link, offset)),
            (Some(angle), None) | (None, Some(angle)) => Some(angle),
            (None, None) => None,
        }
    }

    /// cos of the angle between two turned vectors.
    pub(crate) fn cos_between(&mut self, a: &Turned, b: &Turned) -> Expr {
        let (first, second) = (self.angle(a), self.angle(b));
        let difference = match (first, second) {
            (Some(first), Some(second)) => {
                let difference = self.g.sub(first, second);
                (!self.g.is_zero(difference)).then_some(difference)
            }
            (Some(first), None) => Some(first),
            (None, Some(second)) => Some(self.g.neg(second)),
            (None, None) => None,
        };
        wave(&mut self.g, difference, (a.quarter + 4 - b.quarter) % 4)
    }

    /// The magnitude of a vector, times the position of the slide that scales it.
    pub(crate) fn scale(&mut self, part: &Turned) -> Expr {
        match part.slide {
            Some(slide) => {
                let position = self.variable(slide).value;
                self.g.mul(part.magnitude, position)
            }
            None => part.magnitude,
        }
    }

    /// Scalar product of two sums of turned vectors.
    pub(crate) fn dot(&mut self, a: &[Turned], b: &[Turned]) -> Expr {
        let mut terms = Vec::new();
        for p in a {
            for q in b {
                let factors = [self.scale(p), self.scale(q), self.cos_between(p, q)];
                terms.push(self.g.product(&factors));
            }
        }
        self.g.sum(&terms)
    }

    /// Scalar product of a velocity and a direction when only coordinate `index` moves, per unit
    /// of its rate: ∂(place)/∂q · direction.
    pub(crate) fn lever(&mut self, place: &[Turned], direction: &[Turned], index: usize) -> Expr {
        let mut terms = Vec::new();
        for Moving { variable, vector } in self.velocity(place) {
            let rate = self.variable(variable).rates[index];
            if self.g.is_zero(rate) {
                continue;
            }
            let along = self.dot(&[vector], direction);
            terms.push(self.g.mul(rate, along));
        }
        self.g.sum(&terms)
    }

    /// Displacement of a place from the assembled configuration along a fixed direction, without
    /// cancellation.
    pub(crate) fn displacement(&mut self, place: &[Turned], direction: &[Turned]) -> Expr {
        let mut terms = Vec::new();
        for part in place {
            for along in direction {
                let quarter = (part.quarter + 4 - along.quarter) % 4;
                let magnitude = self.g.mul(part.magnitude, along.magnitude);
                if let Some(slide) = part.slide {
                    let shift = self.variable(slide).shift;
                    let bare = self.angle(part);
                    let turn = wave(&mut self.g, bare, quarter);
                    terms.push(self.g.product(&[magnitude, shift, turn]));
                }
                if let Some(link) = part.link {
                    let (now, then) = (self.variable(link).value, self.variable(link).assembled);
                    let [now, then] = [now, then].map(|angle| match part.offset {
                        Some(offset) => self.g.add(angle, offset),
                        None => angle,
                    });
                    let start = part.slide.map(|slide| self.variable(slide).assembled);
                    let coefficient = match start {
                        Some(start) => self.g.mul(magnitude, start),
                        None => magnitude,
                    };
                    if !self.g.is_zero(coefficient) {
                        terms.push(wave_difference(
                            &mut self.g,
                            coefficient,
                            now,
                            then,
                            quarter,
                        ));
                    }
                }
            }
        }
        self.g.sum(&terms)
    }

    /// Coordinates x and y of a place.
    pub(crate) fn position(&mut self, place: &[Turned]) -> [Expr; 2] {
        let (one, zero) = (self.g.one(), self.g.zero());
        let (x, y) = (self.fixed([one, zero]), self.fixed([zero, one]));
        [self.dot(place, &x), self.dot(place, &y)]
    }
}
