//! Coordinates of a point as coordinates of the mechanism: `coordinate platform.P.x, platform.P.y`.
//!
//! A coordinate belongs to a body, so a point's x and y get bodies of their own: two slides without
//! mass, one along x and one along y, the first on ground and the second on the first, with the
//! point pinned to the second.
//!
//! ```text
//! ground ──x──▶ guide ──y──▶ guide ⊙ P of the platform
//! ```
//!
//! Bodies that no joint leads to, held by springs and contacts alone, get theirs in the same way.
//! Whatever closes loops then needs to know nothing of points: with both coordinates and the
//! platform's angle the platform is placed, with one of them the other follows from a loop.

use super::{Reported, Resolved, Resolver};
use crate::groups::Groups;
use crate::model::{Body, BodyId, BodyKind, GROUND, Guess, Local, Pin, Slide};
use crate::source::Span;
use crate::symbolic::Expr;
use crate::syntax::tree::Path;

impl Resolver<'_> {
    /// The slide that stands for coordinate 0 (x) or 1 (y) of the point that `path` names.
    pub(super) fn traced(&mut self, point: usize, axis: usize, path: &Path) -> Resolved<BodyId> {
        let owner: Vec<&str> = path.parts[..path.parts.len() - 1]
            .iter()
            .map(|part| part.text.as_str())
            .collect();
        self.trace(point, axis, &owner.join("."), path.span)
    }

    /// Bodies that springs and contacts alone hold move freely: x and y of a point of theirs become
    /// coordinates beside their angle.
    pub(super) fn free_bodies(&mut self) {
        if self.failed() {
            return;
        }
        let mut joints = Groups::new(self.model.bodies.len());
        for pin in &self.model.pins {
            for pair in pin.members.windows(2) {
                joints.join(pair[0].0, pair[1].0);
            }
        }
        for (body, known) in self.model.bodies.iter().enumerate() {
            if let BodyKind::Slide(slide) = &known.kind {
                joints.join(body, slide.carrier);
            }
        }
        let mut held = joints.clone();
        for spring in &self.model.springs {
            held.join(spring.first.body, spring.second.body);
        }
        for contact in &self.model.contacts {
            held.join(contact.first.body, contact.second.body);
        }
        let mut free = Vec::new();
        for body in 1..self.model.bodies.len() {
            // Each group is led by its first body.
            if joints.lead(body) == body && held.lead(body) == GROUND {
                free.push(body);
            }
        }
        for body in free {
            let BodyKind::Link(link) = &self.model.bodies[body].kind else {
                continue;
            };
            if let Some(&point) = self.point_index.get(&link.first) {
                let owner = format!("{}.{}", self.model.bodies[body].name, link.first);
                let _ = self.trace(point, 0, &owner, self.model.bodies[body].span);
            }
        }
    }

    /// The slide whose position is coordinate `axis` of a point, made if there is none.
    fn trace(&mut self, point: usize, axis: usize, owner: &str, span: Span) -> Resolved<BodyId> {
        if let Some(known) = self.tracing(point, axis) {
            return Ok(known);
        }
        let named = self.model.points[point].clone();
        if named.body == GROUND {
            let message = format!("`{}` stands on ground", named.name);
            return Err(self.error(span, message, "name a point of a body that moves"));
        }
        let Some(drawn) = self.drawn_point(point) else {
            let message = format!("nothing says where `{}` is", named.name);
            let hint = format!(
                "no joint of `{}` leads to ground: draw the point, `point {} = (X, Y)`",
                self.body_name(named.body),
                named.name
            );
            return Err(self.error(span, message, hint));
        };
        let exact = self.places[self.place_index[&named.name]].drawn.is_some();
        let (zero, one) = (self.model.graph.zero(), self.model.graph.one());
        let mut carrier = GROUND;
        for axis in [axis, 1 - axis] {
            self.model.bodies.push(Body {
                name: format!("{owner}.{}", ["x", "y"][axis]),
                kind: BodyKind::Slide(Slide {
                    carrier,
                    direction: [[one, zero], [zero, one]][axis],
                    origin: Local::Origin,
                    located: true,
                    at: Guess {
                        value: Some(drawn[axis]),
                        exact,
                        span,
                    },
                    traces: Some((point, axis)),
                }),
                masses: Vec::new(),
                span,
            });
            carrier = self.model.bodies.len() - 1;
        }
        let member = (carrier, Local::Origin);
        match self.pin_index.get(&named.name) {
            Some(&pin) => self.model.pins[pin].members.push(member),
            None => self.model.pins.push(Pin {
                name: named.name,
                members: vec![(named.body, named.at), member],
                span: named.span,
            }),
        }
        self.tracing(point, axis).ok_or(Reported)
    }

    /// The slide whose position is coordinate `axis` of a point, if there is one.
    pub(super) fn tracing(&self, point: usize, axis: usize) -> Option<BodyId> {
        self.model.bodies.iter().position(|body| {
            matches!(&body.kind, BodyKind::Slide(slide) if slide.traces == Some((point, axis)))
        })
    }

    /// Where a point is drawn: where the user says, else as drawn links and guides lead there.
    fn drawn_point(&mut self, point: usize) -> Option<[Expr; 2]> {
        let named = self.model.points[point].clone();
        if let Some(drawn) = self.places[self.place_index[&named.name]].drawn {
            return Some(drawn);
        }
        let zero = self.model.graph.zero();
        let mut origins: Vec<Option<[Expr; 2]>> = vec![None; self.model.bodies.len()];
        origins[GROUND] = Some([zero, zero]);
        // Each round draws at least one more body, or none is left that could be.
        for _ in 0..self.model.bodies.len() {
            if let Some(origin) = origins[named.body] {
                let arm = self.drawn_arm(named.body, named.at)?;
                return Some(self.moved(origin, arm, false));
            }
            self.draw_further(&mut origins);
        }
        None
    }

    /// Draws the bodies next to those that are drawn.
    fn draw_further(&mut self, origins: &mut [Option<[Expr; 2]>]) {
        for place in 0..self.places.len() {
            let members: Vec<(BodyId, Local)> = self.places[place]
                .members
                .iter()
                .map(|member| (member.body, member.at))
                .collect();
            let mut drawn = self.places[place].drawn;
            for &(body, at) in &members {
                if let (None, Some(origin)) = (drawn, origins[body]) {
                    drawn = self
                        .drawn_arm(body, at)
                        .map(|arm| self.moved(origin, arm, false));
                }
            }
            let Some(drawn) = drawn else { continue };
            for (body, at) in members {
                if origins[body].is_none() {
                    origins[body] = self
                        .drawn_arm(body, at)
                        .map(|arm| self.moved(drawn, arm, true));
                }
            }
        }
        for body in 1..self.model.bodies.len() {
            let BodyKind::Slide(slide) = self.model.bodies[body].kind.clone() else {
                continue;
            };
            if let (None, Some(origin)) = (origins[body], origins[slide.carrier]) {
                let zero = self.model.graph.zero();
                let travelled = slide.at.value.unwrap_or(zero);
                let [x, y] = slide
                    .direction
                    .map(|part| self.model.graph.mul(part, travelled));
                let arms = [slide.origin, Local::Cartesian(x, y)]
                    .map(|local| self.drawn_arm(slide.carrier, local));
                if let [Some(first), Some(second)] = arms {
                    let start = self.moved(origin, first, false);
                    origins[body] = Some(self.moved(start, second, false));
                }
            }
        }
    }

    /// The vector from a body's origin to a place of it, turned as the body is drawn.
    fn drawn_arm(&mut self, body: BodyId, at: Local) -> Option<[Expr; 2]> {
        let mut turning = body;
        let angle = loop {
            match &self.model.bodies[turning].kind {
                BodyKind::Ground => break None,
                BodyKind::Link(link) => break Some(link.angle.value?),
                BodyKind::Slide(slide) => turning = slide.carrier,
            }
        };
        let g = &mut self.model.graph;
        let [x, y] = match at {
            Local::Origin => [g.zero(), g.zero()],
            Local::Cartesian(x, y) => [x, y],
            Local::Polar(radius, angle) => {
                let (cos, sin) = (g.cos(angle), g.sin(angle));
                [g.mul(radius, cos), g.mul(radius, sin)]
            }
        };
        let Some(angle) = angle else {
            return Some([x, y]);
        };
        let (cos, sin) = (g.cos(angle), g.sin(angle));
        let [xc, xs, yc, ys] = [(x, cos), (x, sin), (y, cos), (y, sin)].map(|(a, b)| g.mul(a, b));
        Some([g.sub(xc, ys), g.add(xs, yc)])
    }

    fn moved(&mut self, from: [Expr; 2], by: [Expr; 2], back: bool) -> [Expr; 2] {
        let g = &mut self.model.graph;
        [0, 1].map(|axis| {
            if back {
                g.sub(from[axis], by[axis])
            } else {
                g.add(from[axis], by[axis])
            }
        })
    }
}
