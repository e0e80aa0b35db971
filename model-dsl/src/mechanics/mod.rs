//! Mechanics: from a model and its structure to the equations of motion.
//!
//! ```text
//! coordinates ─▶ loops close ─▶ inertia: M(q) by blocks ─┐
//!  (variables)   (values, rates) laws: forces on measures ├─▶ motion ─▶ start, outputs ─▶ Equations
//!                                (virtual work)           ┘
//! ```
//!
//! Three ideas carry every element: a *body* has kinetic energy; a *measure* is a scalar function
//! of the configuration; a *law* turns measures and their rates into a force on a measure, which
//! reaches the coordinates by virtual work (force times ∂measure/∂q). Conservative laws within one
//! block of coordinates enter its equation through ∂P/∂q, all others through τ.
//!
//! Angles of a loop stay symbols with two attached facts: how to get the value (`closing`) and
//! the rate by each coordinate. Total derivatives use the rates and never differentiate a loop's
//! closed form.

mod closing;
mod coupled;
mod finish;
mod immobile;
mod inertia;
mod laws;
mod massless;
mod measures;
mod motion;
mod names;
mod order;
mod outputs;
mod picture;
mod start;
mod summary;
mod switches;
mod turned;

use std::collections::{HashMap, HashSet};

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::{
    Check, Definition, Direction, Discrete, Equations, Event, Failure, Kink, Line, Loop, Partial,
    Section, Shown,
};
use crate::model::{BodyId, Model};
use crate::structure::Structure;
use crate::symbolic::{Expr, Graph, Rates, Symbol};

use names::Names;

/// Derives the equations of motion.
///
/// # Errors
/// A mechanism whose laws contradict each other: bodies that move without mass, forces that depend
/// on themselves, initial values that cannot hold.
pub fn derive(model: &Model, structure: &Structure) -> Result<Equations, Vec<Diagnostic>> {
    let mut derivation = Derivation::new(model, structure);
    derivation.mark_what_varies();
    derivation.params();
    derivation.name_coordinates();
    derivation.close_loops();
    derivation.warn_of_trusses();
    derivation.position_measures();
    derivation.drives();
    let inertia = derivation.inertia()?;
    let laws = derivation.laws(&inertia);
    let motion = derivation.motion(&inertia, &laws);
    derivation.other_measures(&laws, &motion);
    derivation.finish(&inertia, laws, motion)
}

/// The angle of a link or the position of a slide.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    /// Its symbol.
    pub symbol: Symbol,
    /// Its symbol as an expression.
    pub value: Expr,
    /// Value in the assembled configuration.
    pub assembled: Expr,
    /// Value less the assembled one.
    pub shift: Expr,
    /// Rate by each coordinate: 1, 0, or a symbol such as ω2.
    pub rates: Vec<Expr>,
    /// Position among the coordinates if it is one.
    pub coordinate: Option<usize>,
}

/// An independent coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Coordinate {
    /// Link or slide.
    pub body: BodyId,
    /// q.
    pub symbol: Symbol,
    /// q̇.
    pub rate: Symbol,
    /// q̈, a defined symbol.
    pub acceleration: Symbol,
}

/// Everything known so far on the way to [`Equations`].
pub(crate) struct Derivation<'m> {
    pub model: &'m Model,
    pub structure: &'m Structure,
    pub g: Graph,
    pub names: Names,
    pub coordinates: Vec<Coordinate>,
    /// Whether loops follow several coordinates, whose names rates then bear.
    pub several_lead: bool,
    /// By body; `None` for ground and until it is known.
    variables: Vec<Option<Variable>>,
    /// For each coordinate: how symbols change with it.
    pub rates: Vec<Rates>,
    pub definitions: Vec<Definition>,
    /// Value of each symbol that has one, as [`Self::definitions`] give it.
    pub values: HashMap<Symbol, Expr>,
    pub partials: Vec<Partial>,
    pub directions: Vec<Direction>,
    pub discretes: Vec<Discrete>,
    pub kinks: Vec<Kink>,
    pub events: Vec<Event>,
    pub loops: Vec<Loop>,
    pub checks: Vec<Check>,
    pub report: Vec<Section>,
    /// Rate in time of each drive.
    pub drive_rates: HashMap<Symbol, Expr>,
    /// Links that turn with others, by body.
    pub aliases: Vec<Option<closing::Alias>>,
    /// Symbols that stand for others in the assembled configuration, by the same formulas.
    pub twins: HashSet<Symbol>,
    /// Signs that tell how loops close, and what they are the signs of.
    pub branches: Vec<(Symbol, Expr)>,
    /// Modes whose value at the start follows from the start state.
    pub modes: Vec<start::Mode>,
    pub errors: Vec<Diagnostic>,
    pub warnings: Vec<Diagnostic>,
}

impl<'m> Derivation<'m> {
    fn new(model: &'m Model, structure: &'m Structure) -> Self {
        let leads = |body: &&BodyId| structure.in_loop(**body);
        let several_lead = structure.coordinates.iter().filter(leads).count() > 1;
        Self {
            model,
            structure,
            g: model.graph.clone(),
            names: Names::new(&model.graph),
            coordinates: Vec::new(),
            several_lead,
            variables: vec![None; model.bodies.len()],
            rates: vec![Rates::new(); structure.coordinates.len()],
            definitions: Vec::new(),
            values: HashMap::new(),
            partials: Vec::new(),
            directions: Vec::new(),
            discretes: Vec::new(),
            kinks: Vec::new(),
            events: Vec::new(),
            loops: Vec::new(),
            checks: Vec::new(),
            report: Vec::new(),
            drive_rates: HashMap::new(),
            aliases: vec![None; model.bodies.len()],
            twins: HashSet::new(),
            branches: Vec::new(),
            modes: Vec::new(),
            errors: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The variable of a link or slide.
    pub(crate) fn variable(&self, body: BodyId) -> &Variable {
        self.variables[body]
            .as_ref()
            .expect("bodies on the way are assembled before they are used")
    }

    /// Gives `symbol` a meaning. It varies if what it stands for does.
    pub(crate) fn define(&mut self, symbol: Symbol, value: Expr, meaning: impl Into<String>) {
        if !self.is_of_params(value) {
            self.g.mark_varying(symbol);
        }
        self.values.insert(symbol, value);
        self.definitions.push(Definition::Value {
            symbol,
            value,
            meaning: meaning.into(),
        });
    }

    /// Whether an expression is fixed for a run: made of params and of what follows from them.
    pub(crate) fn is_of_params(&self, expr: Expr) -> bool {
        self.g
            .symbols_in(&[expr])
            .iter()
            .all(|symbol| !self.g.symbol_varies(*symbol))
    }

    /// A new symbol of that name with a meaning, as an expression.
    pub(crate) fn named(&mut self, name: &str, value: Expr, meaning: impl Into<String>) -> Expr {
        let symbol = self.names.symbol(&mut self.g, name);
        self.define(symbol, value, meaning);
        self.g.of(symbol)
    }

    /// What tells the quantities of a coordinate from those of others: `1` of `φ1`, or the whole
    /// symbol where that is not enough: `θ`, `x_P` beside `y_P`.
    pub(crate) fn coordinate_label(&self, index: usize) -> String {
        let symbol = |index: usize| self.g.symbol_text(self.coordinates[index].symbol);
        let label = names::subscript(symbol(index));
        let is_shared = (0..self.coordinates.len())
            .any(|other| other != index && names::subscript(symbol(other)) == label);
        if label.is_empty() || is_shared {
            symbol(index).to_owned()
        } else {
            label.to_owned()
        }
    }

    /// A condition on params that must be positive.
    pub(crate) fn check(&mut self, margin: Expr, zero_is_well: bool, failure: Failure) {
        // What is a constant and well need not be asked again.
        if let Some(value) = self.g.as_number(margin) {
            let zero = num_traits::Zero::zero();
            if *value > zero || (zero_is_well && *value == zero) {
                return;
            }
        }
        self.checks.push(Check {
            margin,
            zero_is_well,
            failure,
        });
    }

    /// How symbols change in time: coordinates by their rates, drives by theirs, time by 1.
    pub(crate) fn time_rates(&mut self) -> Rates {
        let mut rates = Rates::new();
        for (index, coordinate) in self.coordinates.clone().iter().enumerate() {
            let rate = self.g.of(coordinate.rate);
            let mut known: Vec<(Symbol, Expr)> =
                self.rates[index].iter().map(|(s, e)| (*s, *e)).collect();
            known.sort_by_key(|(symbol, _)| *symbol);
            for (symbol, by_coordinate) in known {
                let part = self.g.mul(by_coordinate, rate);
                let sum = match rates.get(&symbol) {
                    Some(&so_far) => self.g.add(so_far, part),
                    None => part,
                };
                rates.insert(symbol, sum);
            }
        }
        for (drive, rate) in &self.drive_rates {
            rates.insert(*drive, *rate);
        }
        rates.insert(self.model.time, self.g.one());
        rates
    }

    /// The rate in time of a measure Σ ∂measure/∂q·q̇.
    pub(crate) fn rate_of(&mut self, levers: &[Expr]) -> Expr {
        let terms: Vec<Expr> = levers
            .iter()
            .zip(self.coordinates.clone())
            .map(|(lever, coordinate)| {
                let rate = self.g.of(coordinate.rate);
                if self.g.is_zero(*lever) {
                    *lever
                } else {
                    self.g.mul(*lever, rate)
                }
            })
            .collect();
        self.g.sum(&terms)
    }

    /// Whether each coordinate moves an expression.
    pub(crate) fn moved_by_coordinates(&self, measure: Expr) -> Vec<bool> {
        let symbols = self.g.symbols_in(&[measure]);
        self.rates
            .iter()
            .map(|rates| symbols.iter().any(|symbol| rates.contains_key(symbol)))
            .collect()
    }

    /// ∂measure/∂q for each coordinate.
    pub(crate) fn gradient(&mut self, measure: Expr) -> Vec<Expr> {
        let zero = self.g.zero();
        let moved = self.moved_by_coordinates(measure);
        (0..self.coordinates.len())
            .map(|index| {
                if !moved[index] {
                    return zero;
                }
                self.along(&[measure], index)[0]
            })
            .collect()
    }

    /// Total derivatives along a coordinate.
    pub(crate) fn along(&mut self, values: &[Expr], index: usize) -> Vec<Expr> {
        let rates = std::mem::take(&mut self.rates[index]);
        let derivatives = self.g.derivatives(values, &rates);
        self.rates[index] = rates;
        derivatives
    }

    /// A new section of the report.
    pub(crate) fn section(&mut self, title: &str, lines: Vec<Line>) {
        if !lines.is_empty() {
            self.report.push(Section {
                title: title.to_owned(),
                lines,
            });
        }
    }

    /// Reports an error at a place of the model file.
    pub(crate) fn fault(
        &mut self,
        span: crate::source::Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        let error = Diagnostic::error(message).hint(hint);
        self.errors.push(self.model.source.blame(span, error));
    }

    /// A failure at a place of the model file.
    pub(crate) fn failure(
        &self,
        message: impl Into<String>,
        hint: impl Into<String>,
        span: crate::source::Span,
        values: Vec<Shown>,
    ) -> Failure {
        Failure {
            message: message.into(),
            hint: Some(hint.into()),
            site: Some(self.model.source.site(span)),
            related: self.model.source.origins(span),
            values,
        }
    }
}
