//! A model at rest: what statics and linear studies are made of.
//!
//! Signals that depend on time and params alone become quantities that are held at a value, and
//! contacts stick or are left out. What is held and what results are then states of their own, the
//! held ones with rate zero and the results as integrals, so that the one Jacobian of the equations
//! holds all four matrices of the linear model.

use std::collections::HashMap;

use flexure_runtime::diagnostic::Diagnostic;

use crate::compile::once_each;
use crate::equations::{Equations, State};
use crate::mechanics::derive;
use crate::model::{BodyKind, ContactRole, Input, Measure, MeasureUse, Model, Output};
use crate::resolve::resolve;
use crate::source::{Source, Span};
use crate::structure::structure;
use crate::suggest::closest;
use crate::symbolic::{Expr, Symbol};
use crate::units::Dimension;

/// What becomes of a contact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Hold {
    /// It is left out: neither friction nor a normal force.
    Without(String),
    /// It sticks, whatever friction force that takes.
    Stick(String),
}

/// A signal that is held at a value.
#[derive(Clone, Debug)]
pub struct Held {
    /// Name of the drive or input.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
    /// Whether it is a drive.
    pub is_drive: bool,
    /// Value at t = 0, of params.
    pub start: Expr,
    /// Value at full stroke, of params, of a drive whose form has one.
    pub full: Option<Expr>,
    /// Position of its value among the states.
    pub state: usize,
    /// Position of its rate among the states, of a drive.
    pub rate: Option<usize>,
}

/// The equations of a model at rest.
#[derive(Clone, Debug)]
pub struct AtRest {
    /// The equations: states are position and rate of each coordinate, then whatever the model
    /// integrates besides, then [`Self::held`], then the results from [`Self::first_result`] on,
    /// each as its integral.
    pub equations: Equations,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Drives and inputs that are held.
    pub held: Vec<Held>,
    /// Position of the first result among the states.
    pub first_result: usize,
    /// Number of results that the model names; the rest are places and angles of its bodies,
    /// springs and contacts.
    pub named_results: usize,
    /// Contacts taken as they are: name, and which results are friction and the most that holds.
    pub contacts: Vec<(String, usize, usize)>,
}

/// Compiles a model file at rest, as [`compile`](crate::compile()) does in motion. Contacts that
/// `holds` does not name are as they are, which at rest means that they stick as long as friction
/// holds.
///
/// # Errors
/// Everything that is wrong with the file, or a contact that it does not have.
pub fn compile_at_rest(
    source: Source,
    files: &dyn Fn(&str) -> Result<String, String>,
    holds: &[Hold],
) -> Result<(AtRest, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (mut model, mut warnings) = resolve(source, files)?;
    let as_they_are = hold_contacts(&mut model, holds).map_err(|error| vec![error])?;
    let signals = hold_signals(&mut model);
    let named_results = model.outputs.len();
    let contacts = add_results(&mut model, &as_they_are);
    let structure = structure(&model).map_err(once_each)?;
    let equations = derive(&model, &structure).map_err(once_each)?;
    warnings.extend(once_each(equations.warnings.clone()));
    let coordinates = structure.coordinates.len();
    let at_rest = with_held_and_results(equations, coordinates, signals, named_results, contacts);
    Ok((at_rest, warnings))
}

/// Sets the role of each contact; returns those that are taken as they are.
fn hold_contacts(model: &mut Model, holds: &[Hold]) -> Result<Vec<usize>, Diagnostic> {
    let mut as_they_are: Vec<usize> = (0..model.contacts.len()).collect();
    for contact in &mut model.contacts {
        contact.role = ContactRole::Sticks;
    }
    for hold in holds {
        let (name, role) = match hold {
            Hold::Without(name) => (name, ContactRole::LeftOut),
            Hold::Stick(name) => (name, ContactRole::Sticks),
        };
        let Some(index) = model.contacts.iter().position(|known| known.name == *name) else {
            let error =
                Diagnostic::error(format!("model `{}` has no contact `{name}`", model.name));
            let names = model.contacts.iter().map(|contact| contact.name.as_str());
            return Err(error.hint(match closest(name, names.clone()) {
                Some(near) => format!("did you mean `{near}`?"),
                None if model.contacts.is_empty() => "it has no contacts at all".to_owned(),
                None => format!("it has {}", names.collect::<Vec<_>>().join(", ")),
            }));
        };
        if !as_they_are.contains(&index) {
            let error = Diagnostic::error(format!("contact `{name}` is given twice"));
            return Err(error.hint("leave it out or let it stick, once"));
        }
        as_they_are.retain(|known| *known != index);
        model.contacts[index].role = role;
    }
    // Bristles are where their sides are.
    let is_held = |measure: Measure| matches!(measure, Measure::ContactState(..));
    model.initial.retain(|initial| !is_held(initial.measure));
    Ok(as_they_are)
}

/// What a signal was before it was held.
struct Signal {
    is_drive: bool,
    start: Expr,
    full: Option<Expr>,
    dimension: Dimension,
    value: Symbol,
    rate: Option<Symbol>,
    name: String,
}

/// Turns drives of time and params alone into inputs; returns all inputs.
fn hold_signals(model: &mut Model) -> Vec<Signal> {
    let others: Vec<Symbol> = {
        let inputs = model.inputs.iter().map(|input| input.symbol);
        let measures = model.measures.iter().map(|used| used.symbol);
        let drives = model.drives.iter().map(|drive| drive.symbol);
        inputs.chain(measures).chain(drives).collect()
    };
    let mut signals: Vec<Signal> = Vec::new();
    for input in &model.inputs {
        signals.push(Signal {
            is_drive: false,
            start: input.start,
            full: None,
            dimension: input.dimension,
            value: input.symbol,
            rate: None,
            name: input.name.clone(),
        });
    }
    let mut following = Vec::new();
    for drive in std::mem::take(&mut model.drives) {
        let uses = model.graph.symbols_in(&[drive.waveform.value]);
        if uses.iter().any(|symbol| others.contains(symbol)) {
            following.push(drive);
            continue;
        }
        let zero = model.graph.zero();
        let mut at_start = HashMap::from([(model.time, zero)]);
        let memory = drive.waveform.memory.iter();
        at_start.extend(memory.map(|memory| (memory.symbol, memory.initial)));
        let start = model.graph.substitute(drive.waveform.value, &at_start);
        let name = format!("{}.rate", drive.name);
        let rate = model.graph.symbol(name.clone(), name.clone());
        let input = |name, symbol, start, rate, dimension| Input {
            name,
            symbol,
            start,
            rate,
            dimension,
            doc: String::new(),
        };
        let (dimension, value) = (drive.dimension, drive.symbol);
        let speed = dimension.over(Dimension::TIME).unwrap_or(Dimension::NONE);
        model.inputs.extend([
            input(drive.name.clone(), value, start, Some(rate), dimension),
            input(name, rate, zero, None, speed),
        ]);
        signals.push(Signal {
            is_drive: true,
            start,
            full: drive.waveform.full,
            dimension,
            value,
            rate: Some(rate),
            name: drive.name,
        });
    }
    model.drives = following;
    signals
}

/// Adds the places and angles of all bodies, springs and contacts as outputs. Returns for each
/// contact in `as_they_are` its name and the outputs that tell its friction and what holds.
fn add_results(model: &mut Model, as_they_are: &[usize]) -> Vec<(String, usize, usize)> {
    let mut wanted: Vec<(Measure, String, Dimension)> = Vec::new();
    for (body, known) in model.bodies.iter().enumerate() {
        match &known.kind {
            BodyKind::Link(_) => {
                wanted.push((
                    Measure::Angle(body),
                    format!("{}.angle", known.name),
                    Dimension::NONE,
                ));
            }
            BodyKind::Slide(slide) if slide.traces.is_none() => {
                wanted.push((
                    Measure::Position(body),
                    format!("{}.x", known.name),
                    Dimension::LENGTH,
                ));
            }
            BodyKind::Slide(_) | BodyKind::Ground => {}
        }
    }
    for (index, point) in model.points.iter().enumerate() {
        if !matches!(model.bodies[point.body].kind, BodyKind::Ground) {
            for (axis, letter) in ["x", "y"].iter().enumerate() {
                let name = format!("{}.{letter}", point.name);
                wanted.push((Measure::PointPosition(index, axis), name, Dimension::LENGTH));
            }
        }
    }
    for (index, spring) in model.springs.iter().enumerate() {
        let name = &spring.name;
        let (extension, force) = (format!("{name}.extension"), format!("{name}.force"));
        wanted.push((
            Measure::SpringExtension(index),
            extension,
            Dimension::LENGTH,
        ));
        wanted.push((Measure::SpringForce(index), force, Dimension::FORCE));
    }
    for (index, contact) in model.contacts.iter().enumerate() {
        let friction = format!("{}.friction", contact.name);
        wanted.push((Measure::ContactFriction(index), friction, Dimension::FORCE));
    }
    for (measure, name, dimension) in wanted {
        let known = model.measures.iter().find(|used| used.measure == measure);
        let symbol = match known {
            Some(used) => used.symbol,
            None => {
                let symbol = model.graph.symbol(name.clone(), name.clone());
                model.measures.push(MeasureUse {
                    symbol,
                    measure,
                    name: name.clone(),
                    span: Span::default(),
                });
                symbol
            }
        };
        let value = model.graph.of(symbol);
        push_output(model, name, value, dimension);
    }
    let mut limits = Vec::new();
    for &index in as_they_are {
        let contact = model.contacts[index].clone();
        let friction = format!("{}.friction", contact.name);
        let Some(friction) = model
            .outputs
            .iter()
            .rposition(|output| output.name == friction)
        else {
            continue;
        };
        let limit = model.outputs.len();
        let name = format!("{}.holds", contact.name);
        push_output(model, name, contact.friction.holds, Dimension::FORCE);
        limits.push((contact.name, friction, limit));
    }
    limits
}

fn push_output(model: &mut Model, name: String, value: Expr, dimension: Dimension) {
    model.outputs.push(Output {
        name,
        value,
        dimension,
        doc: String::new(),
        span: Span::default(),
    });
}

/// Makes states of what is held and of what results.
fn with_held_and_results(
    mut equations: Equations,
    coordinates: usize,
    signals: Vec<Signal>,
    named_results: usize,
    contacts: Vec<(String, usize, usize)>,
) -> AtRest {
    let zero = equations.graph.zero();
    let mut position = HashMap::new();
    for input in std::mem::take(&mut equations.inputs) {
        position.insert(input.symbol, equations.states.len());
        equations.states.push(State {
            name: input.name,
            unit: input.dimension.si_unit(),
            meaning: input.doc,
            symbol: input.symbol,
            initial: input.start,
            rate: zero,
            coordinate: None,
        });
    }
    let held = signals.into_iter().map(|signal| Held {
        name: signal.name,
        dimension: signal.dimension,
        is_drive: signal.is_drive,
        start: signal.start,
        full: signal.full,
        state: position[&signal.value],
        rate: signal.rate.map(|rate| position[&rate]),
    });
    let held = held.collect();
    let first_result = equations.states.len();
    for output in std::mem::take(&mut equations.outputs) {
        let name = format!("∫{}", output.name);
        let symbol = equations.graph.symbol(name.clone(), name);
        equations.states.push(State {
            name: output.name,
            unit: output.unit,
            meaning: output.meaning,
            symbol,
            initial: zero,
            rate: output.value,
            coordinate: None,
        });
    }
    AtRest {
        equations,
        coordinates,
        held,
        first_result,
        named_results,
        contacts,
    }
}
