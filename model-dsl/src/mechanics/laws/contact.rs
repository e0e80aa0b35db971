//! Contacts: friction along a guide and a normal force that is constant or follows the approach.

use std::collections::HashMap;

use crate::equations::{Discrete, Event, Shown, ShownUnit};
use crate::model::{BodyKind, Contact, ContactRole, End, GROUND, Local, NormalForce};
use crate::symbolic::{Expr, Function};

use super::super::Derivation;
use super::super::start::Mode;
use super::super::turned::Turned;
use super::{ContactValues, InternalState, Laws};

/// The normal force with what comes with it.
struct Normal {
    /// The force.
    force: Expr,
    /// Its rate in time; zero where it is constant.
    rate: Expr,
    /// 1 while the bodies touch, where they may lift off.
    closed: Option<Expr>,
}

impl Derivation<'_> {
    /// Friction F_f on the second end along the guide and -F_f on the first; normal force on the
    /// first end along `normal` and its opposite on the second.
    pub(super) fn contact(&mut self, index: usize, laws: &mut Laws) {
        let contact = self.model.contacts[index].clone();
        let friction = contact.friction.clone();
        self.conditions(&friction.conditions, contact.span);
        let places = [&contact.first, &contact.second].map(|end| self.contact_place(end));
        let along = self.guide(contact.guide);
        let slip_levers = self.relative_levers(&places, &along);
        let slip = self.rate_of(&slip_levers);
        let suffix = if self.model.contacts.len() > 1 {
            format!("_{}", contact.name)
        } else {
            String::new()
        };

        let first_state = laws.states.len();
        if contact.role == ContactRole::LeftOut {
            self.define(friction.slip, slip, "");
            let (zero, slip) = (self.g.zero(), self.g.of(friction.slip));
            laws.contacts.push(ContactValues {
                friction: zero,
                normal: zero,
                slip,
                states: vec![zero; friction.states.len()],
                first_state,
            });
            return;
        }
        let normal = self.normal_force(&contact, &places, &suffix, first_state, laws);
        self.define(
            friction.normal,
            normal.force,
            format!("normal force of `{}`", contact.name),
        );
        self.define(
            friction.slip,
            slip,
            format!("slip velocity of `{}`", contact.name),
        );
        self.equation_line(&mut laws.lines, friction.normal, normal.force, "");
        self.equation_line(&mut laws.lines, friction.slip, slip, "");

        let sticks = contact.role == ContactRole::Sticks;
        if sticks {
            let slipped = self.slipped(&contact, &places, &along);
            for state in &friction.states {
                self.define(state.symbol, slipped, state.meaning.clone());
                self.attach_gradient(state.symbol, slipped);
            }
        }
        let is_rate = |symbol| {
            let rates = friction.states.iter().map(|state| state.rate);
            rates
                .filter_map(|rate| self.g.as_symbol(rate))
                .any(|rate| rate == symbol)
        };
        let definitions: Vec<_> = friction
            .definitions
            .iter()
            .map(|&(symbol, value)| match sticks && is_rate(symbol) {
                true => (symbol, slip),
                false => (symbol, value),
            })
            .collect();
        for (symbol, value) in definitions {
            self.define(symbol, value, "");
            self.equation_line(&mut laws.lines, symbol, value, "");
        }
        let words = format!("friction force of `{}` on its second end", contact.name);
        let force = self.named_force(laws, &format!("F_f{suffix}"), friction.force, &words);
        let resisting = self.g.neg(force);
        self.push_forces(laws, resisting, &slip_levers);

        let integrated = if sticks { &[] } else { &friction.states[..] };
        for state in integrated {
            let rate = match normal.closed {
                Some(closed) => {
                    let half = self.g.ratio(1, 2);
                    let margin = self.g.sub(closed, half);
                    let zero = self.g.zero();
                    self.g
                        .function(Function::IfPositive, &[margin, state.rate, zero])
                }
                None => state.rate,
            };
            laws.states.push(InternalState {
                name: format!("{}.{}", contact.name, state.name),
                unit: state.dimension.si_unit(),
                meaning: state.meaning.clone(),
                symbol: state.symbol,
                rate,
            });
        }

        // What friction takes from the motion and does not store is heat.
        let mut rates: HashMap<_, _> = friction
            .states
            .iter()
            .map(|state| (state.symbol, state.rate))
            .collect();
        rates.insert(friction.normal, normal.rate);
        let storing = self.g.derivative(friction.energy, &rates);
        let slip_value = self.g.of(friction.slip);
        let power = self.g.mul(force, slip_value);
        laws.dissipated.push(self.g.sub(power, storing));
        laws.potential.push(friction.energy);
        let normal_value = self.g.of(friction.normal);
        let states = friction.states.iter();
        let states = states.map(|state| self.g.of(state.symbol)).collect();
        laws.contacts.push(ContactValues {
            friction: force,
            normal: normal_value,
            slip: slip_value,
            states,
            first_state,
        });
    }

    /// How far the first side has moved against the second along the guide since assembly.
    fn slipped(&mut self, contact: &Contact, places: &[Vec<Turned>; 2], along: &[Turned]) -> Expr {
        if along.iter().all(|part| part.link.is_none()) {
            let [first, second] = [0, 1].map(|side| self.displacement(&places[side], along));
            return self.g.sub(first, second);
        }
        // Along a guide that turns the travel tells it, between the slide and what carries it.
        let slide = contact.guide;
        let carrier = match &self.model.bodies[slide].kind {
            BodyKind::Slide(slide) => slide.carrier,
            BodyKind::Link(_) | BodyKind::Ground => GROUND,
        };
        let travel = self.variable(slide).shift;
        match (contact.first.body, contact.second.body) {
            (first, second) if first == carrier && second == slide => self.g.neg(travel),
            (first, second) if first == slide && second == carrier => travel,
            _ => {
                self.fault(
                    contact.span,
                    format!(
                        "`{}` slides along a guide that turns, between bodies that are not this slide and its carrier: it cannot be held",
                        contact.name
                    ),
                    "leave it out",
                );
                travel
            }
        }
    }

    fn contact_place(&mut self, end: &End) -> Vec<Turned> {
        let zero = self.g.zero();
        self.place(end.body, end.at.unwrap_or(Local::Cartesian(zero, zero)))
    }

    /// ∂(first - second)/∂q along a direction.
    fn relative_levers(&mut self, places: &[Vec<Turned>; 2], along: &[Turned]) -> Vec<Expr> {
        (0..self.coordinates.len())
            .map(|i| {
                let [first, second] = [&places[0], &places[1]].map(|p| self.lever(p, along, i));
                self.g.sub(first, second)
            })
            .collect()
    }

    fn normal_force(
        &mut self,
        contact: &Contact,
        places: &[Vec<Turned>; 2],
        suffix: &str,
        first_state: usize,
        laws: &mut Laws,
    ) -> Normal {
        let zero = self.g.zero();
        let normal_axis = contact.normal.map(|normal| self.fixed(normal));
        let levers = match &normal_axis {
            Some(axis) => self.relative_levers(places, axis),
            None => vec![zero; self.coordinates.len()],
        };
        let separating = self.rate_of(&levers);
        let symbol = self.g.of(contact.friction.normal);
        self.push_forces(laws, symbol, &levers);
        match contact.normal_force {
            NormalForce::Constant(force) => {
                // A preload is brought in from outside.
                laws.supplied.push(self.g.mul(symbol, separating));
                Normal {
                    force,
                    rate: zero,
                    closed: None,
                }
            }
            NormalForce::Compliant {
                preload,
                stiffness,
                damping,
            } => {
                let axis = normal_axis.unwrap_or_default();
                let [first, second] =
                    [&places[0], &places[1]].map(|place| self.displacement(place, &axis));
                let approach = self.g.sub(second, first);
                let approach = self.named_force(
                    laws,
                    &format!("δ{suffix}"),
                    approach,
                    "approach of the bodies",
                );
                if let Some(symbol) = self.g.as_symbol(approach) {
                    let value = self.g.sub(second, first);
                    self.attach_gradient(symbol, value);
                }
                let approach_rate = self.g.neg(separating);
                let spring = self.g.mul(stiffness, approach);
                let elastic = self.g.add(preload, spring);
                let damper = self.g.mul(damping, approach_rate);
                let pressed = self.g.add(elastic, damper);
                let words = format!("normal force of `{}` while the bodies touch", contact.name);
                let pressed = self.named_force(laws, &format!("N{suffix}"), pressed, &words);
                let closed = self.lift_off(contact, pressed, suffix, first_state);
                let force = self.g.mul(closed, pressed);

                self.positive(stiffness, "the normal stiffness", "N/m", contact);
                let half = self.g.ratio(1, 2);
                let square = self.g.powi(elastic, 2);
                let stored = self.g.product(&[half, closed, square]);
                laws.potential.push(self.g.div(stored, stiffness));
                let square = self.g.powi(approach_rate, 2);
                laws.dissipated
                    .push(self.g.product(&[closed, damping, square]));

                // The rate of the normal force needs the accelerations where it is damped.
                let mut rates = self.time_rates();
                for coordinate in self.coordinates.clone() {
                    let acceleration = self.g.of(coordinate.acceleration);
                    rates.insert(coordinate.rate, acceleration);
                }
                let value = self.g.add(elastic, damper);
                let rate = self.g.derivative(value, &rates);
                let rate = self.g.mul(closed, rate);
                Normal {
                    force,
                    rate,
                    closed: Some(closed),
                }
            }
        }
    }

    /// The mode of a contact that may lift off, with its two events.
    fn lift_off(
        &mut self,
        contact: &Contact,
        pressed: Expr,
        suffix: &str,
        first_state: usize,
    ) -> Expr {
        let name = &contact.name;
        let mode = self.names.symbol(&mut self.g, &format!("closed{suffix}"));
        self.g.mark_varying(mode);
        let closed = self.g.of(mode);
        let (zero, one) = (self.g.zero(), self.g.one());
        let index = self.discretes.len();
        self.modes.push(Mode {
            discrete: index,
            condition: pressed,
            rate: None,
        });
        self.discretes.push(Discrete {
            name: format!("{name}.closed"),
            meaning: format!("1 while the bodies of `{name}` touch, 0 while they are apart"),
            symbol: mode,
            initial: zero,
            accepted: None,
            turning: false,
        });
        let half = self.g.ratio(1, 2);
        let margin = self.g.sub(closed, half);
        let minus = self.g.integer(-1);
        let lifting = self.g.neg(pressed);
        let lifting = self
            .g
            .function(Function::IfPositive, &[margin, lifting, minus]);
        let touching = self
            .g
            .function(Function::IfPositive, &[margin, minus, pressed]);
        let integrated = match contact.role {
            ContactRole::Slides => contact.friction.states.len(),
            ContactRole::Sticks | ContactRole::LeftOut => 0,
        };
        let states = (0..integrated)
            .map(|i| (2 * self.coordinates.len() + first_state + i, zero))
            .collect();
        self.events.push(Event {
            name: format!("`{name}` lifts off"),
            function: lifting,
            state_updates: states,
            discrete_updates: vec![(index, zero)],
            stop: None,
        });
        self.events.push(Event {
            name: format!("`{name}` touches"),
            function: touching,
            state_updates: Vec::new(),
            discrete_updates: vec![(index, one)],
            stop: None,
        });
        closed
    }

    fn positive(&mut self, value: Expr, what: &str, unit: &'static str, contact: &Contact) {
        let failure = self.failure(
            format!("{what} of `{}` is {{0}}", contact.name),
            "it must be above zero",
            contact.span,
            vec![Shown {
                value,
                unit: ShownUnit::Other(unit),
            }],
        );
        self.check(value, false, failure);
    }
}
