//! Start: initial values, static equilibrium, and the modes that follow from them.

use std::collections::HashMap;

use crate::equations::{Definition, Shown, ShownUnit, Solve, State};
use crate::model::{BodyId, BodyKind, Initial, Measure, Start};
use crate::symbolic::{Expr, Function, Symbol};

use super::Derivation;
use super::laws::Laws;
use super::motion::Motion;

/// A discrete state that is 1 where a condition is positive at the start, else 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mode {
    /// Position among the discrete states.
    pub discrete: usize,
    /// The condition.
    pub condition: Expr,
    /// Its rate, which decides where the condition is zero.
    pub rate: Option<Expr>,
}

impl Derivation<'_> {
    /// Sets the initial values of all states and discrete states.
    pub(super) fn start(&mut self, laws: &Laws, motion: &mut Motion) {
        if self.model.start == Start::Equilibrium {
            self.equilibrium(motion);
        }
        for initial in self.model.initial.clone() {
            self.initial(&initial, laws, &mut motion.states);
        }
        let map = self.start_map(&motion.states);
        // As assembled nothing has turned yet.
        let is_assembled = (0..self.coordinates.len()).all(|index| {
            let assembled = self.variable(self.coordinates[index].body).assembled;
            motion.states[2 * index].initial == assembled
        });
        for index in 0..self.discretes.len() {
            if let Some(shift) = self.discretes[index].accepted
                && !is_assembled
            {
                self.discretes[index].initial = self.expand_with(shift, &mut map.clone());
            }
        }
        let map = self.start_map(&motion.states);
        for mode in self.modes.clone() {
            let initial = self.mode_value(mode, &map);
            self.discretes[mode.discrete].initial = initial;
        }
    }

    fn mode_value(&mut self, mode: Mode, map: &HashMap<Symbol, Expr>) -> Expr {
        let (zero, one) = (self.g.zero(), self.g.one());
        let condition = self.expand_with(mode.condition, &mut map.clone());
        let undecided = match mode.rate {
            Some(rate) => {
                let rate = self.expand_with(rate, &mut map.clone());
                self.g.function(Function::IfPositive, &[rate, one, zero])
            }
            None => zero,
        };
        let opposite = self.g.neg(condition);
        let otherwise = self
            .g
            .function(Function::IfPositive, &[opposite, zero, undecided]);
        self.g
            .function(Function::IfPositive, &[condition, one, otherwise])
    }

    /// Every symbol of state, time and input with its value at the start.
    fn start_map(&mut self, states: &[State]) -> HashMap<Symbol, Expr> {
        let mut map: HashMap<Symbol, Expr> = states
            .iter()
            .map(|state| (state.symbol, state.initial))
            .collect();
        self.add_fixed_start(&mut map);
        map
    }

    fn add_fixed_start(&mut self, map: &mut HashMap<Symbol, Expr>) {
        let zero = self.g.zero();
        map.insert(self.model.time, zero);
        map.extend(
            self.model
                .inputs
                .iter()
                .map(|input| (input.symbol, input.start)),
        );
        map.extend(
            self.discretes
                .iter()
                .map(|discrete| (discrete.symbol, discrete.initial)),
        );
    }

    /// Statics: all rates zero, bristles relaxed, drives at their start. A coordinate on which no
    /// force depends stays where it is.
    fn equilibrium(&mut self, motion: &mut Motion) {
        let zero = self.g.zero();
        let mut map: HashMap<Symbol, Expr> = motion
            .states
            .iter()
            .map(|state| (state.symbol, zero))
            .collect();
        self.add_fixed_start(&mut map);
        let mut unknowns = Vec::new();
        for coordinate in self.coordinates.clone() {
            let text = format!("{}_eq", self.g.symbol_text(coordinate.symbol));
            let latex = format!("{{{}}}^{{eq}}", self.g.symbol_latex(coordinate.symbol));
            let symbol = self.names.symbol_with_latex(&mut self.g, &text, &latex);
            let value = self.g.of(symbol);
            map.insert(coordinate.symbol, value);
            unknowns.push(symbol);
        }
        for mode in self.modes.clone() {
            let symbol = self.discretes[mode.discrete].symbol;
            let mut without = map.clone();
            without.remove(&symbol);
            let value = self.mode_value(mode, &without);
            map.insert(symbol, value);
        }
        let residuals: Vec<Expr> = motion
            .imbalance
            .iter()
            .map(|&imbalance| self.expand_with(imbalance, &mut map.clone()))
            .collect();
        let used = self.g.symbols_in(&residuals);
        let mut solve = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, &symbol) in unknowns.iter().enumerate() {
            let body = self.coordinates[index].body;
            let assembled = self.variable(body).assembled;
            if !used.contains(&symbol) {
                self.define(symbol, assembled, "");
                self.unheld(body, residuals[index]);
                continue;
            }
            let rates = HashMap::from([(symbol, self.g.one())]);
            let slope = self.g.derivative(residuals[index], &rates);
            let guesses: HashMap<Symbol, Expr> = unknowns
                .iter()
                .zip(self.coordinates.clone())
                .map(|(s, c)| (*s, self.variable(c.body).assembled))
                .collect();
            let slope = self.g.substitute(slope, &guesses);
            let scale = self.g.function(Function::Abs, &[slope]);
            solve.0.push(symbol);
            solve.1.push(assembled);
            solve.2.push(residuals[index]);
            solve.3.push(scale);
        }
        for (index, &symbol) in unknowns.iter().enumerate() {
            motion.states[2 * index].initial = self.g.of(symbol);
        }
        if solve.0.is_empty() {
            return;
        }
        let span = self.model.bodies[self.coordinates[0].body].span;
        let failure = self.failure(
            "no static equilibrium was found near the assembled configuration",
            "start from `assembled`, or reduce the loads until the springs can hold them",
            span,
            Vec::new(),
        );
        self.definitions.push(Definition::Solve(Box::new(Solve {
            name: "the static equilibrium".to_owned(),
            unknowns: solve.0,
            guesses: solve.1,
            definitions: Vec::new(),
            residuals: solve.2,
            scales: solve.3,
            failure,
        })));
    }

    /// A coordinate without stiffness cannot hold a constant force.
    fn unheld(&mut self, body: BodyId, force: Expr) {
        if self.g.is_zero(force) {
            return;
        }
        let tolerance = self.g.ratio(1, 1_000_000_000_000);
        let size = self.g.function(Function::Abs, &[force]);
        let margin = self.g.sub(tolerance, size);
        let unit = match self.model.bodies[body].kind {
            BodyKind::Link(_) => "N*m",
            BodyKind::Slide(_) | BodyKind::Ground => "N",
        };
        let force = self.g.neg(force);
        let failure = self.failure(
            format!(
                "`{}` has no static equilibrium: nothing elastic holds it against {{0}}",
                self.model.bodies[body].name
            ),
            "hold it by a `spring` or a `hinge` with stiffness, or start from `assembled`",
            self.model.bodies[body].span,
            vec![Shown {
                value: force,
                unit: ShownUnit::Other(unit),
            }],
        );
        self.check(margin, true, failure);
    }

    /// One `initial` item.
    fn initial(&mut self, initial: &Initial, laws: &Laws, states: &mut [State]) {
        let coordinate_of = |this: &Self, body: BodyId| this.variable(body).coordinate;
        match initial.measure {
            Measure::Angle(body) | Measure::Position(body) | Measure::Travel(body) => {
                let Some(index) = coordinate_of(self, body) else {
                    self.initial_refused(initial, body, "angle");
                    return;
                };
                let value = match initial.measure {
                    Measure::Travel(_) => {
                        let assembled = self.variable(body).assembled;
                        self.g.add(assembled, initial.value)
                    }
                    _ => initial.value,
                };
                states[2 * index].initial = value;
            }
            Measure::AngleRate(body) | Measure::Velocity(body) => {
                if let Some(index) = coordinate_of(self, body) {
                    states[2 * index + 1].initial = initial.value;
                    return;
                }
                let rates = self.variable(body).rates.clone();
                let moving: Vec<usize> = (0..rates.len())
                    .filter(|i| !self.g.is_zero(rates[*i]))
                    .collect();
                let [index] = moving[..] else {
                    self.initial_refused(initial, body, "rate");
                    return;
                };
                let map = self.start_map(states);
                let ratio = self.expand_with(rates[index], &mut map.clone());
                states[2 * index + 1].initial = self.g.div(initial.value, ratio);
            }
            Measure::ContactState(contact, state) => {
                let index = 2 * self.coordinates.len() + laws.contacts[contact].first_state + state;
                states[index].initial = initial.value;
            }
            Measure::PointPosition(..)
            | Measure::PointVelocity(..)
            | Measure::HingeAngle(_)
            | Measure::HingeTorque(_)
            | Measure::SpringExtension(_)
            | Measure::SpringForce(_)
            | Measure::ContactFriction(_)
            | Measure::ContactNormal(_)
            | Measure::ContactSlip(_)
            | Measure::Energy(_) => {
                self.fault(
                    initial.span,
                    "this quantity follows from others and has no initial value of its own",
                    "give the angle, position or rate of a coordinate, or the state of a contact",
                );
            }
        }
    }

    fn initial_refused(&mut self, initial: &Initial, body: BodyId, what: &str) {
        let names: Vec<String> = self
            .coordinates
            .iter()
            .map(|c| {
                let [value, rate] = self.model.coordinate_names(c.body);
                format!("`{}`", if what == "rate" { rate } else { value })
            })
            .collect();
        self.fault(
            initial.span,
            format!(
                "the initial {what} of `{}` follows from the coordinates and cannot be given",
                self.model.bodies[body].name
            ),
            format!("give that of a coordinate: {}", names.join(", ")),
        );
    }
}
