//! Picture: the mechanism's shape in the assembled configuration and in motion.

use std::collections::HashMap;

use crate::equations::{Drawing, DrawnContact, DrawnEnd, DrawnSpring, Mark, Shape};
use crate::model::{Axis, BodyId, BodyKind, End, GROUND, Local};
use crate::symbolic::{Expr, Symbol};

use super::Derivation;

impl Derivation<'_> {
    /// Everything that a drawing to scale shows, as assembled: as expressions of params.
    pub(super) fn drawing(&mut self) -> Drawing {
        let map = self.assembled_map();
        self.drawing_with(&map)
    }

    /// The same at any state. Slides without a place have one, in which only changes matter.
    pub(super) fn moving_drawing(&mut self) -> Drawing {
        self.drawing_with(&HashMap::new())
    }

    /// The drawing with symbols replaced; none are replaced in one that moves.
    fn drawing_with(&mut self, map: &HashMap<Symbol, Expr>) -> Drawing {
        let mut drawing = Drawing::default();
        let zero = self.g.zero();
        for body in 1..self.model.bodies.len() {
            if self.model.is_traced(body) {
                continue;
            }
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
                        .map(|at| self.located(body, at, map))
                        .collect();
                    drawing.shapes.push(Shape::Link(name, corners));
                }
                BodyKind::Slide(_) => {
                    let is_shown = self.has_place(body) || map.is_empty();
                    let at =
                        is_shown.then(|| self.located(body, Local::Cartesian(zero, zero), map));
                    let direction = self.turned_guide(body, map);
                    drawing.shapes.push(Shape::Slide(name, at, direction));
                }
                BodyKind::Ground => {}
            }
        }
        for pin in self.model.pins.clone() {
            let grounded = pin.members.iter().any(|(body, _)| *body == GROUND);
            let joins = pin
                .members
                .iter()
                .filter(|(body, _)| !self.model.is_traced(*body));
            let is_joint = joins.count() > 1;
            let (body, at) = pin.members[0];
            let at = self.located(body, at, map);
            drawing.marks.push(Mark {
                name: pin.name,
                at,
                pin: is_joint.then_some(grounded),
            });
        }
        for point in self.model.points.clone() {
            if drawing.marks.iter().all(|mark| mark.name != point.name) {
                let at = self.located(point.body, point.at, map);
                drawing.marks.push(Mark {
                    name: point.name,
                    at,
                    pin: None,
                });
            }
        }
        for spring in self.model.springs.clone() {
            let axis = match spring.axis {
                Axis::Line => None,
                Axis::Fixed(direction) => Some(direction),
                Axis::Guide(slide) => Some(self.turned_guide(slide, map)),
            };
            drawing.springs.push(DrawnSpring {
                name: spring.name,
                ends: [
                    self.drawn_end(&spring.first, map),
                    self.drawn_end(&spring.second, map),
                ],
                axis,
                stack: spring.stack,
            });
        }
        for contact in self.model.contacts.clone() {
            drawing.contacts.push(DrawnContact {
                name: contact.name,
                ends: [
                    self.drawn_end(&contact.first, map),
                    self.drawn_end(&contact.second, map),
                ],
                along: self.turned_guide(contact.guide, map),
                normal: contact.normal,
            });
        }
        drawing
    }

    /// Whether the model says where a body is: all but slides that are not located and carry
    /// nothing that is.
    fn has_place(&self, body: BodyId) -> bool {
        match &self.model.bodies[body].kind {
            BodyKind::Slide(slide) => {
                let pins = self.model.pins.iter().flat_map(|pin| &pin.members);
                slide.located
                    || pins.clone().any(|(member, _)| *member == body)
                    || self.model.points.iter().any(|point| point.body == body)
            }
            BodyKind::Link(_) | BodyKind::Ground => true,
        }
    }

    fn drawn_end(&mut self, end: &End, map: &HashMap<Symbol, Expr>) -> DrawnEnd {
        let at = end.at.filter(|_| self.has_place(end.body));
        DrawnEnd {
            body: self.model.bodies[end.body].name.clone(),
            at: at.map(|at| self.located(end.body, at, map)),
        }
    }

    fn turned_guide(&mut self, slide: BodyId, map: &HashMap<Symbol, Expr>) -> [Expr; 2] {
        let guide = self.guide(slide);
        let direction = self.position(&guide);
        direction.map(|component| self.g.substitute(component, map))
    }

    fn located(&mut self, body: BodyId, at: Local, map: &HashMap<Symbol, Expr>) -> [Expr; 2] {
        let place = self.place(body, at);
        let position = self.position(&place);
        position.map(|component| self.g.substitute(component, map))
    }
}
