//! Picture: the mechanism's shape in the assembled configuration.

use crate::equations::{Drawing, Mark, Shape};
use crate::model::{BodyId, BodyKind, GROUND, Local};
use crate::symbolic::Expr;

use super::Derivation;

impl Derivation<'_> {
    /// Everything that a drawing to scale shows, as expressions of params.
    pub(super) fn drawing(&mut self) -> Drawing {
        let mut drawing = Drawing::default();
        let zero = self.g.zero();
        for body in 1..self.model.bodies.len() {
            let name = self.model.bodies[body].name.clone();
            match self.model.bodies[body].kind.clone() {
                BodyKind::Link(link) => {
                    let mut corners = vec![
                        Local::Cartesian(zero, zero),
                        Local::Cartesian(link.length, zero),
                    ];
                    let pins = self.model.pins.iter().flat_map(|pin| &pin.members);
                    let points = self.model.points.iter().map(|point| (point.body, point.at));
                    for (owner, at) in pins.copied().chain(points) {
                        let off_line = !matches!(at, Local::Cartesian(_, y) if self.g.is_zero(y));
                        if owner == body && off_line && !corners.contains(&at) {
                            corners.push(at);
                        }
                    }
                    let corners = corners
                        .into_iter()
                        .map(|at| self.assembled_at(body, at))
                        .collect();
                    drawing.shapes.push(Shape::Link(name, corners));
                }
                BodyKind::Slide(_) => {
                    let at = self.assembled_at(body, Local::Cartesian(zero, zero));
                    let guide = self.guide(body);
                    let direction = self.position(&guide);
                    let direction = self.assembled(direction);
                    drawing.shapes.push(Shape::Slide(name, at, direction));
                }
                BodyKind::Ground => {}
            }
        }
        for pin in self.model.pins.clone() {
            let grounded = pin.members.iter().any(|(body, _)| *body == GROUND);
            let (body, at) = pin.members[0];
            let at = self.assembled_at(body, at);
            drawing.marks.push(Mark {
                name: pin.name,
                at,
                pin: Some(grounded),
            });
        }
        for point in self.model.points.clone() {
            if drawing.marks.iter().all(|mark| mark.name != point.name) {
                let at = self.assembled_at(point.body, point.at);
                drawing.marks.push(Mark {
                    name: point.name,
                    at,
                    pin: None,
                });
            }
        }
        for spring in self.model.springs.clone() {
            let ends = [&spring.first, &spring.second].map(|end| {
                let at = end.at.unwrap_or(Local::Cartesian(zero, zero));
                self.assembled_at(end.body, at)
            });
            drawing
                .springs
                .push((spring.name, ends[0], ends[1], spring.stack));
        }
        for contact in self.model.contacts.clone() {
            let end = if contact.first.at.is_some() {
                &contact.first
            } else {
                &contact.second
            };
            let at = end.at.unwrap_or(Local::Cartesian(zero, zero));
            let at = self.assembled_at(end.body, at);
            let guide = self.guide(contact.guide);
            let direction = self.position(&guide);
            let direction = self.assembled(direction);
            drawing.contacts.push((contact.name, at, direction));
        }
        drawing
    }

    fn assembled_at(&mut self, body: BodyId, at: Local) -> [Expr; 2] {
        let place = self.place(body, at);
        let position = self.position(&place);
        self.assembled(position)
    }

    fn assembled(&mut self, position: [Expr; 2]) -> [Expr; 2] {
        let map = self.assembled_map();
        position.map(|component| self.g.substitute(component, &map))
    }
}
