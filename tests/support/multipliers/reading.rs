//! From a resolved model and values of its params to numbers.

use flexure_model_dsl::model::{Axis, BodyId, BodyKind, End, GROUND, Local, Model, NormalForce};
use flexure_model_dsl::symbolic::{Evaluator, Expr};

use super::plane::turned;
use super::{Body, Contact, Direction, Hinge, Kind, LuGre, Mechanism, Place, Plane, Spring};

impl<'m> Mechanism<'m> {
    /// The mechanism for values of its params, in order.
    pub fn new(model: &'m Model, params: &[f64]) -> Self {
        let mut evaluator = evaluator(model, params);
        let mut number = |expr: Expr| evaluator.value(expr);
        let bodies = model
            .bodies
            .iter()
            .map(|body| Body {
                name: body.name.clone(),
                kind: match &body.kind {
                    BodyKind::Ground => Kind::Ground,
                    BodyKind::Link(link) => Kind::Link {
                        angle: link.angle.value.map(&mut number),
                        exact: link.angle.exact,
                    },
                    BodyKind::Slide(slide) => Kind::Slide {
                        carrier: slide.carrier,
                        direction: slide.direction.map(&mut number),
                        origin: local(&slide.origin, &mut number),
                        located: slide.located,
                        at: slide.at.value.map_or(0.0, &mut number),
                        exact: slide.at.exact,
                    },
                },
                masses: body
                    .masses
                    .iter()
                    .map(|mass| {
                        let center = local(&mass.center, &mut number);
                        (number(mass.mass), center, number(mass.inertia))
                    })
                    .collect(),
            })
            .collect();
        let mut pins = Vec::new();
        for pin in &model.pins {
            let places: Vec<Place> = pin
                .members
                .iter()
                .map(|(body, at)| Place {
                    body: *body,
                    at: local(at, &mut number),
                })
                .collect();
            pins.extend(places.windows(2).map(|pair| (pair[0], pair[1])));
        }
        let hinges = model
            .hinges
            .iter()
            .map(|hinge| Hinge {
                first: hinge.bodies.0,
                second: hinge.bodies.1,
                stiffness: hinge.stiffness.map_or(0.0, &mut number),
                damping: hinge.damping.map_or(0.0, &mut number),
                rest: hinge.rest.map(&mut number),
            })
            .collect();
        let springs = model
            .springs
            .iter()
            .map(|spring| Spring {
                first: place(&spring.first, &mut number),
                second: place(&spring.second, &mut number),
                direction: match spring.axis {
                    Axis::Line => Direction::Line,
                    Axis::Fixed(direction) => Direction::Fixed(GROUND, direction.map(&mut number)),
                    Axis::Guide(slide) => {
                        let (carrier, direction) = guide(model, slide, &mut number);
                        Direction::Fixed(carrier, direction)
                    }
                },
                stiffness: spring.stiffness.map_or(0.0, &mut number),
                damping: spring.damping.map_or(0.0, &mut number),
                length: spring.length.map(&mut number),
                expansion: spring.expansion,
            })
            .collect();
        let by_name = |name: &str| {
            let index = model.params.iter().position(|param| param.name == name);
            params[index.unwrap_or_else(|| panic!("a contact's model has a param `{name}`"))]
        };
        let contacts = model
            .contacts
            .iter()
            .map(|contact| {
                assert_eq!(contact.friction.law, "lugre");
                let (preload, stiffness, damping, compliant) = match contact.normal_force {
                    NormalForce::Constant(preload) => (number(preload), 0.0, 0.0, false),
                    NormalForce::Compliant {
                        preload,
                        stiffness,
                        damping,
                    } => (number(preload), number(stiffness), number(damping), true),
                };
                Contact {
                    first: place(&contact.first, &mut number),
                    second: place(&contact.second, &mut number),
                    guide: guide(model, contact.guide, &mut number),
                    normal: contact.normal.map(|normal| normal.map(&mut number)),
                    preload,
                    stiffness,
                    damping,
                    compliant,
                    law: LuGre {
                        sigma0: by_name("sigma0"),
                        sigma1: by_name("sigma1"),
                        sigma2: by_name("sigma2"),
                        mu_s: by_name("mu_s"),
                        mu_c: by_name("mu_c"),
                        v_s: by_name("v_s"),
                    },
                }
            })
            .collect();
        let gravity = model
            .gravity
            .map_or([0.0; 2], |gravity| gravity.map(&mut number));
        Self {
            model,
            params: params.to_vec(),
            bodies,
            pins,
            hinges,
            springs,
            contacts,
            gravity,
        }
    }

    /// The body of that name.
    pub fn body(&self, name: &str) -> BodyId {
        let found = self.bodies.iter().position(|body| body.name == name);
        found.unwrap_or_else(|| panic!("the model has a body `{name}`"))
    }
}

pub(super) fn evaluator<'m>(model: &'m Model, params: &[f64]) -> Evaluator<'m> {
    let mut evaluator = Evaluator::new(&model.graph);
    for (param, value) in model.params.iter().zip(params) {
        evaluator.set(param.symbol, *value);
    }
    for entry in &model.lets {
        evaluator.define(entry.symbol, entry.value);
    }
    evaluator
}

pub(super) fn local(at: &Local, number: &mut dyn FnMut(Expr) -> f64) -> Plane {
    match *at {
        Local::Origin => [0.0, 0.0],
        Local::Cartesian(x, y) => [number(x), number(y)],
        Local::Polar(radius, angle) => turned(number(angle), [number(radius), 0.0]),
    }
}

pub(super) fn place(end: &End, number: &mut dyn FnMut(Expr) -> f64) -> Place {
    Place {
        body: end.body,
        at: end.at.as_ref().map_or([0.0; 2], |at| local(at, number)),
    }
}

pub(super) fn guide(
    model: &Model,
    slide: BodyId,
    number: &mut dyn FnMut(Expr) -> f64,
) -> (BodyId, Plane) {
    match &model.bodies[slide].kind {
        BodyKind::Slide(slide) => (slide.carrier, slide.direction.map(number)),
        _ => panic!("a guide belongs to a slide"),
    }
}
