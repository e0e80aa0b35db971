//! Laws: forces on measures, and by virtual work on the coordinates.
//!
//! Each kind of element adds its share to [`Laws`]: a hinge acts on a relative angle, a spring on
//! the distance of two ends, a contact on the slip along a guide and the approach along a normal,
//! gravity on heights. A force F on a measure δ is F ∂δ/∂q on the coordinate q.

use crate::equations::{Line, Shown, ShownUnit};
use crate::model::{BodyId, Condition, Load};
use crate::source::Span;
use crate::structure::turning_link;
use crate::symbolic::{Expr, Node, Symbol};

use super::Derivation;
use super::inertia::Inertia;

mod contact;
mod gravity;
mod hinge;
mod spring;

/// What all laws do to the coordinates, and what energies and powers come with them.
#[derive(Default)]
pub(crate) struct Laws {
    /// For each coordinate the terms of ∂P_s/∂q: springs within its block.
    pub elastic: Vec<Vec<Expr>>,
    /// For each coordinate ∂P_g/∂q: gravity.
    pub gravity: Vec<Vec<Expr>>,
    /// For each coordinate the terms of τ: everything else.
    pub forces: Vec<Vec<Expr>>,
    /// Terms of the potential energy.
    pub potential: Vec<Expr>,
    /// Terms of the dissipated power.
    pub dissipated: Vec<Expr>,
    /// Terms of the supplied power.
    pub supplied: Vec<Expr>,
    /// Internal states.
    pub states: Vec<InternalState>,
    /// Deflection and torque of each hinge.
    pub hinges: Vec<(Expr, Expr)>,
    /// ε and force of each spring.
    pub springs: Vec<(Expr, Expr)>,
    /// Quantities of each contact.
    pub contacts: Vec<ContactValues>,
    /// Lines of the report: named forces and what they are made of.
    pub lines: Vec<Line>,
}

/// An internal state of a law.
pub(crate) struct InternalState {
    pub name: String,
    pub unit: String,
    pub meaning: String,
    pub symbol: Symbol,
    pub rate: Expr,
}

/// Quantities of a contact that others may ask for.
#[derive(Clone)]
pub(crate) struct ContactValues {
    pub friction: Expr,
    pub normal: Expr,
    pub slip: Expr,
    /// The internal states of its friction law.
    pub states: Vec<Expr>,
    /// Position of the first of them in [`Laws::states`], where they are integrated.
    pub first_state: usize,
}

impl Derivation<'_> {
    /// Adds up all laws.
    pub(super) fn laws(&mut self, inertia: &Inertia) -> Laws {
        let n = self.coordinates.len();
        let mut laws = Laws {
            elastic: vec![Vec::new(); n],
            gravity: vec![Vec::new(); n],
            forces: vec![Vec::new(); n],
            ..Laws::default()
        };
        for index in 0..self.model.hinges.len() {
            self.hinge(index, inertia, &mut laws);
        }
        for index in 0..self.model.springs.len() {
            self.spring(index, inertia, &mut laws);
        }
        for index in 0..self.model.contacts.len() {
            self.contact(index, &mut laws);
        }
        self.gravity(&mut laws);
        for index in 0..self.model.loads.len() {
            self.load(index, &mut laws);
        }
        laws
    }

    /// A conservative force -stiffness·measure: within one block it enters through P, between
    /// blocks through τ. `gradient` is ∂measure/∂q.
    fn is_within_block(&self, inertia: &Inertia, gradient: &[Expr]) -> bool {
        let touched = inertia
            .blocks
            .iter()
            .filter(|block| block.iter().any(|&i| !self.g.is_zero(gradient[i])))
            .count();
        touched <= 1
    }

    /// Adds force · lever to τ of each coordinate.
    fn push_forces(&mut self, laws: &mut Laws, force: Expr, levers: &[Expr]) {
        for (terms, lever) in laws.forces.iter_mut().zip(levers) {
            let product = self.g.mul(force, *lever);
            if !self.g.is_zero(product) {
                terms.push(product);
            }
        }
    }

    /// -expr, with sums opened, so that the sign goes into the terms.
    pub(super) fn minus(&mut self, expr: Expr) -> Expr {
        if let Node::Product {
            coefficient,
            factors,
        } = self.g.node(expr).clone()
            && let Some(at) = factors.iter().position(|(f, k)| {
                *k == num_traits::One::one() && matches!(self.g.node(*f), Node::Sum { .. })
            })
        {
            let mut factors = factors;
            factors[at].0 = self.g.neg(factors[at].0);
            return self.g.powers(coefficient, &factors);
        }
        self.g.neg(expr)
    }

    fn load(&mut self, index: usize, laws: &mut Laws) {
        match self.model.loads[index].clone() {
            Load::Force { on, value, .. } => {
                let [fx, fy] = value
                    .map(|component| self.switched(component, &format!("force on {}", on.name)));
                let Some(at) = on.at else { return };
                let place = self.place(on.body, at);
                let (one, zero) = (self.g.one(), self.g.zero());
                for (component, axis) in [(fx, [one, zero]), (fy, [zero, one])] {
                    if self.g.is_zero(component) {
                        continue;
                    }
                    let axis = self.fixed(axis);
                    let levers: Vec<Expr> = (0..self.coordinates.len())
                        .map(|i| self.lever(&place, &axis, i))
                        .collect();
                    self.push_forces(laws, component, &levers);
                    let speed = self.rate_of(&levers);
                    laws.supplied.push(self.g.mul(component, speed));
                }
            }
            Load::Torque {
                on, against, value, ..
            } => {
                let name = format!("torque on {}", self.model.bodies[on].name);
                let torque = self.switched(value, &name);
                let levers = self.relative_rates(against, on);
                self.push_forces(laws, torque, &levers);
                let speed = self.rate_of(&levers);
                laws.supplied.push(self.g.mul(torque, speed));
            }
        }
    }

    /// Rates by each coordinate of the angle of `second` relative to `first`.
    fn relative_rates(&mut self, first: BodyId, second: BodyId) -> Vec<Expr> {
        let [first, second] = [first, second].map(|body| turning_link(self.model, body));
        (0..self.coordinates.len())
            .map(|i| {
                let [a, b] = [first, second].map(|link| match link {
                    Some(link) => self.variable(link).rates[i],
                    None => self.g.zero(),
                });
                self.g.sub(b, a)
            })
            .collect()
    }

    /// Turns the conditions of a waveform or law into checks.
    pub(super) fn conditions(&mut self, conditions: &[Condition], span: Span) {
        for condition in conditions {
            let shown = Shown {
                value: condition.value,
                unit: condition.unit.map_or(ShownUnit::Number, ShownUnit::Other),
            };
            let (message, hint) = (condition.message.clone(), condition.hint.clone());
            let failure = self.failure(message, hint, span, vec![shown]);
            self.check(condition.margin, condition.zero_is_well, failure);
        }
    }

    /// `name = value` in the report and as a definition.
    fn named_force(&mut self, laws: &mut Laws, name: &str, value: Expr, words: &str) -> Expr {
        let named = self.named(name, value, words);
        if let Some(symbol) = self.g.as_symbol(named) {
            self.equation_line(&mut laws.lines, symbol, value, "");
        }
        named
    }
}
