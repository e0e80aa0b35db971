//! The ends of the derivation: drives and checks of params at its start, outputs and the whole of
//! [`Equations`] at its end.

use std::collections::{HashMap, HashSet};

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::{Discrete, Equations, Event, Kink, Line, Periodic, Shown, ShownUnit};
use crate::model::{BodyId, BodyKind, EnergyKind, Measure};
use crate::symbolic::{Expr, Function, Symbol};

use super::inertia::Inertia;
use super::laws::Laws;
use super::motion::Motion;
use super::names::{accented, accented_latex};
use super::{Definition, Derivation, order};

impl Derivation<'_> {
    /// What the model names that changes in time: the rest follows as it is defined.
    pub(super) fn mark_what_varies(&mut self) {
        let model = self.model;
        let mut varying = vec![model.time];
        varying.extend(model.inputs.iter().map(|input| input.symbol));
        varying.extend(model.measures.iter().map(|used| used.symbol));
        for drive in &model.drives {
            varying.push(drive.symbol);
            varying.extend(drive.waveform.memory.iter().map(|memory| memory.symbol));
        }
        for contact in &model.contacts {
            let friction = &contact.friction;
            varying.extend([friction.slip, friction.normal]);
            varying.extend(friction.states.iter().map(|state| state.symbol));
        }
        for symbol in varying {
            self.g.mark_varying(symbol);
        }
    }

    /// Defines what follows from params; bodies have the sizes and masses of real things.
    pub(super) fn params(&mut self) {
        for quantity in &self.model.lets {
            self.define(quantity.symbol, quantity.value, quantity.doc.clone());
        }
        for (condition, span) in &self.model.conditions {
            self.conditions(std::slice::from_ref(condition), *span);
        }
        for body in &self.model.bodies {
            if let BodyKind::Link(link) = &body.kind {
                let failure = self.failure(
                    format!("the length of `{}` is {{0}}", body.name),
                    "it must be above zero",
                    body.span,
                    vec![Shown {
                        value: link.length,
                        unit: ShownUnit::Metre,
                    }],
                );
                self.check(link.length, false, failure);
            }
            for mass in &body.masses {
                let shown = [
                    (mass.mass, "mass", "kg"),
                    (mass.inertia, "moment of inertia", "kg*m^2"),
                ];
                for (value, what, unit) in shown {
                    let failure = self.failure(
                        format!("the {what} of `{}` is {{0}}", body.name),
                        "it must not be below zero",
                        mass.span,
                        vec![Shown {
                            value,
                            unit: ShownUnit::Other(unit),
                        }],
                    );
                    self.check(value, true, failure);
                }
            }
        }
    }

    /// Drives: their memory, values, rates and kinks.
    pub(super) fn drives(&mut self) {
        for input in &self.model.inputs {
            if let Some(rate) = input.rate {
                let rate = self.g.of(rate);
                self.drive_rates.insert(input.symbol, rate);
            }
        }
        let mut lines = Vec::new();
        for drive in &self.model.drives {
            self.conditions(&drive.waveform.conditions, drive.span);
            let first = self.discretes.len();
            for memory in &drive.waveform.memory {
                self.discretes.push(Discrete {
                    name: format!("{}.{}", drive.name, memory.name),
                    meaning: format!("segment of the drive `{}`", drive.name),
                    symbol: memory.symbol,
                    initial: memory.initial,
                    accepted: None,
                    turning: false,
                });
            }
            let value = match &drive.waveform.kink {
                Some(kink) => {
                    self.kinks.push(Kink {
                        name: drive.name.clone(),
                        next: kink.next,
                        updates: (first..).zip(kink.updates.iter().copied()).collect(),
                        jumps: kink.jumps,
                    });
                    drive.waveform.value
                }
                None => self.switched(drive.waveform.value, &drive.name),
            };
            self.define(drive.symbol, value, format!("drive `{}`", drive.name));
            let rates = self.time_rates();
            let rate = self.g.derivative(value, &rates);
            let rate = if self.g.as_number(rate).is_some() {
                rate
            } else {
                let symbol = self.names.symbol_with_latex(
                    &mut self.g,
                    &accented(&drive.name, '\u{307}'),
                    &accented_latex(&drive.name, "dot"),
                );
                self.define(symbol, rate, format!("rate of the drive `{}`", drive.name));
                self.g.of(symbol)
            };
            self.drive_rates.insert(drive.symbol, rate);
            self.attach_gradient(drive.symbol, value);
            let symbol = self.g.symbol_text(drive.symbol).to_owned();
            let latex = self.g.symbol_latex(drive.symbol).to_owned();
            lines.push(Line::Written {
                text: format!("{symbol}(t) = {}", drive.written),
                latex: format!(
                    "{latex}(t) = \\text{{{}}}",
                    crate::notation::escape_latex(&drive.written)
                ),
            });
        }
        self.section("Drives", lines);
    }

    /// All that was found, in one piece.
    pub(super) fn finish(
        mut self,
        inertia: &Inertia,
        laws: Laws,
        mut motion: Motion,
    ) -> Result<Equations, Vec<Diagnostic>> {
        if !self.errors.is_empty() {
            return Err(self.errors);
        }
        self.start(&laws, &mut motion);
        self.inertia_checks(inertia);
        self.massless_together(inertia);
        self.stops();
        let outputs = self.outputs();
        self.warn_of_unbooked_jumps();
        let summary = self.summary(inertia);
        let drawing = self.drawing();
        let moving = self.moving_drawing();
        self.constants_section();
        if !self.errors.is_empty() {
            return Err(self.errors);
        }
        let definitions = match order::sorted(&self.g, std::mem::take(&mut self.definitions)) {
            Ok(definitions) => definitions,
            Err(cycle) => {
                let mut names: Vec<String> = cycle
                    .iter()
                    .map(|s| format!("`{}`", self.g.symbol_text(*s)))
                    .collect();
                names.push(names[0].clone());
                let mut error = Diagnostic::error(format!(
                    "a quantity depends on itself: {}",
                    names.join(" ← ")
                ))
                .hint("let forces and drives use time, positions, rates and the forces of other elements");
                let measures = &self.model.measures;
                if let Some(used) = measures.iter().find(|used| cycle.contains(&used.symbol)) {
                    error = self.model.source.blame(used.span, error);
                }
                return Err(vec![error]);
            }
        };
        let drives = self.model.drives.iter();
        let periodic = drives
            .filter_map(|drive| {
                Some(Periodic {
                    name: drive.name.clone(),
                    frequency: drive.waveform.frequency?,
                })
            })
            .collect();
        Ok(Equations {
            name: self.model.name.clone(),
            doc: self.model.doc.clone(),
            time: self.model.time,
            params: self.model.params.clone(),
            sets: self.model.sets.clone(),
            inputs: self.model.inputs.clone(),
            definitions,
            partials: self.partials,
            directions: self.directions,
            states: motion.states,
            discretes: self.discretes,
            periodic,
            kinks: self.kinks,
            events: self.events,
            outputs,
            energy: motion.energy,
            loops: self.loops,
            checks: self.checks,
            warnings: self.warnings,
            report: self.report,
            summary,
            drawing,
            moving,
            graph: self.g,
        })
    }

    /// A coordinate needs inertia of its own also for the params at hand.
    fn inertia_checks(&mut self, inertia: &Inertia) {
        let mut map = self.assembled_map();
        self.assembled_rates(&mut map);
        for index in 0..self.coordinates.len() {
            let entry = self.expand_with(inertia.matrix[index][index], &mut map);
            let body = self.coordinates[index].body;
            let entry = if self.g.as_symbol(entry).is_some() {
                entry
            } else {
                let name = format!("A_{}⁰", self.model.bodies[body].name);
                self.named(&name, entry, "inertia as assembled")
            };
            let failure = self.failure(
                format!(
                    "`{}` can move but has no mass",
                    self.model.bodies[body].name
                ),
                "give it a mass above zero, or join it to a body that has one",
                self.model.bodies[body].span,
                Vec::new(),
            );
            self.check(entry, false, failure);
        }
    }

    /// Names the rates of the loops' unknowns as assembled, in the order in which loops close: the
    /// rates of each loop follow from those of the loops before, and written out they would grow
    /// with the length of a chain.
    fn assembled_rates(&mut self, map: &mut HashMap<Symbol, Expr>) {
        let steps = self.structure.steps.iter();
        let unknowns: Vec<BodyId> = steps.flat_map(|step| step.unknowns()).collect();
        for body in unknowns {
            for rate in self.variable(body).rates.clone() {
                let Some(symbol) = self.g.as_symbol(rate) else {
                    continue;
                };
                if map.contains_key(&symbol) {
                    continue;
                }
                let value = self.expand_with(rate, map);
                if self.g.as_number(value).is_some() {
                    continue;
                }
                let name = format!("{}⁰", self.g.symbol_text(symbol));
                let assembled = self.named(&name, value, "rate as assembled");
                map.insert(symbol, assembled);
            }
        }
    }

    /// A drive that jumps changes the energy of its spring at once, which no rate can tell.
    fn warn_of_unbooked_jumps(&mut self) {
        let asked = self
            .model
            .measures
            .iter()
            .find(|used| used.measure == Measure::Energy(EnergyKind::Supplied));
        let (Some(used), Some(kink)) = (asked, self.kinks.iter().find(|kink| kink.jumps)) else {
            return;
        };
        let warning = Diagnostic::warning(format!(
            "`{}` does not count what the drive `{}` supplies where it jumps",
            used.name, kink.name
        ))
        .hint("ask for the energy of the whole run instead: it is accounted at jumps too");
        self.warnings
            .push(self.model.source.blame(used.span, warning));
    }

    fn stops(&mut self) {
        for stop in &self.model.stops {
            self.events.push(Event {
                name: stop.reason.clone(),
                function: stop.margin,
                state_updates: Vec::new(),
                discrete_updates: Vec::new(),
                stop: Some(stop.reason.clone()),
            });
        }
    }

    /// Definitions of params only that the printed equations use and that no other section shows.
    fn constants_section(&mut self) {
        let (rows, twins) = self.constants_in_use();
        let meanings: HashMap<Symbol, String> = self
            .definitions
            .iter()
            .filter_map(|definition| match definition {
                Definition::Value {
                    symbol, meaning, ..
                } => Some((*symbol, meaning.clone())),
                Definition::Solve(_) => None,
            })
            .collect();
        let titles: HashSet<String> = self
            .report
            .iter()
            .flat_map(|section| &section.lines)
            .filter_map(|line| match line {
                Line::Equation { text, .. } => Some(text.clone()),
                Line::Text(_) | Line::Written { .. } => None,
            })
            .collect();
        let mut lines = Vec::new();
        for (symbol, value) in rows {
            if titles.contains(self.g.symbol_text(symbol)) {
                continue;
            }
            let side = self.branches.iter().find(|(sign, _)| *sign == symbol);
            let value = match side.copied() {
                Some((_, side)) => self.g.function(Function::Sign, &[side]),
                None => value,
            };
            let meaning = meanings.get(&symbol).map_or("", String::as_str);
            self.equation_line(&mut lines, symbol, value, meaning);
        }
        if !twins.is_empty() {
            lines.push(self.twins_line(&twins));
        }
        self.section("Constants", lines);
    }

    /// Symbols fixed for a run that the report leads to, with their values; apart from them those
    /// that stand for others as assembled, as far as they are mentioned.
    fn constants_in_use(&self) -> (Vec<(Symbol, Expr)>, Vec<Symbol>) {
        let shown: Vec<Expr> = self
            .report
            .iter()
            .flat_map(|section| &section.lines)
            .filter_map(|line| match line {
                Line::Equation { right, .. } => Some(*right),
                Line::Text(_) | Line::Written { .. } => None,
            })
            .collect();
        // `φ2 - φ2⁰` is one symbol.
        let starts: HashMap<Symbol, Symbol> = self
            .variables
            .iter()
            .flatten()
            .filter_map(|v| Some((self.g.as_symbol(v.shift)?, self.g.as_symbol(v.assembled)?)))
            .collect();
        let fixed = self.fixed_for_a_run();
        let mut wanted = self.g.symbols_in(&shown);
        let mut seen: HashSet<Symbol> = wanted.iter().copied().collect();
        let mut mentioned = seen.clone();
        let (mut rows, mut at) = (Vec::new(), 0);
        while let Some(&symbol) = wanted.get(at) {
            at += 1;
            let mut inner = Vec::new();
            if let Some(&start) = starts.get(&symbol) {
                mentioned.insert(start);
                inner.push(start);
            }
            if let Some(&value) = self.values.get(&symbol)
                && fixed.contains(&symbol)
            {
                inner.extend(self.g.symbols_in(&[value]));
                if !self.twins.contains(&symbol) {
                    rows.push((symbol, value));
                    mentioned.extend(&inner);
                }
            }
            wanted.extend(inner.into_iter().filter(|symbol| seen.insert(*symbol)));
        }
        rows.sort_by_key(|(symbol, _)| *symbol);
        let mut twins: Vec<Symbol> = mentioned.intersection(&self.twins).copied().collect();
        twins.sort();
        (rows, twins)
    }

    /// `X⁰, Y⁰, φ2⁰: as in the loops, at φ1 = φ1⁰`.
    fn twins_line(&self, twins: &[Symbol]) -> Line {
        let (mut text, mut latex) = (Vec::new(), Vec::new());
        for coordinate in &self.coordinates {
            if !self.structure.in_loop(coordinate.body) {
                continue;
            }
            let start = self.variable(coordinate.body).assembled;
            let (q, q_latex) = (
                self.g.symbol_text(coordinate.symbol),
                self.g.symbol_latex(coordinate.symbol),
            );
            text.push(format!("{q} = {}", self.g.text(start)));
            latex.push(format!("{q_latex} = {}", self.g.latex(start)));
        }
        let names: Vec<&str> = twins.iter().map(|s| self.g.symbol_text(*s)).collect();
        let latex_names: Vec<&str> = twins.iter().map(|s| self.g.symbol_latex(*s)).collect();
        Line::Written {
            text: format!(
                "{}: by the formulas of the loops, at {}",
                names.join(", "),
                text.join(", ")
            ),
            latex: format!(
                "{}: \\text{{ by the formulas of the loops, at }} {}",
                latex_names.join(",\\, "),
                latex.join(",\\, ")
            ),
        }
    }

    /// Symbols with a value that is made of params, of what is solved for when the mechanism is
    /// assembled, and of other such symbols.
    fn fixed_for_a_run(&self) -> HashSet<Symbol> {
        let mut given: HashSet<Symbol> = self.model.params.iter().map(|p| p.symbol).collect();
        for definition in &self.definitions {
            if let Definition::Solve(solve) = definition {
                given.extend(&solve.unknowns);
            }
        }
        let mut users: HashMap<Symbol, Vec<Symbol>> = HashMap::new();
        let mut varying = Vec::new();
        for (&symbol, &value) in &self.values {
            for inner in self.g.symbols_in(&[value]) {
                users.entry(inner).or_default().push(symbol);
                if !given.contains(&inner) && !self.values.contains_key(&inner) {
                    varying.push(inner);
                }
            }
        }
        let mut fixed: HashSet<Symbol> = self.values.keys().copied().collect();
        while let Some(symbol) = varying.pop() {
            for user in users.remove(&symbol).into_iter().flatten() {
                if fixed.remove(&user) {
                    varying.push(user);
                }
            }
        }
        fixed
    }
}
