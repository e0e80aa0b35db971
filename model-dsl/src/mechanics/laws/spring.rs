//! Springs, dampers and stacks: a force along the line between two ends, or along a direction.

use crate::model::{Axis, BodyKind, End, GROUND, Local, Measure, Spring};
use crate::notation::latex_of;
use crate::symbolic::{Expr, Symbol};

use super::super::Derivation;
use super::super::inertia::Inertia;
use super::super::turned::Turned;
use super::Laws;

impl Derivation<'_> {
    /// F = -k ε - c ε̇ on the second end, ε = (second - first)·axis - expansion.
    pub(super) fn spring(&mut self, index: usize, inertia: &Inertia, laws: &mut Laws) {
        let spring = self.model.springs[index].clone();
        let (extension, levers) = match spring.axis {
            Axis::Line => self.extension_along_line(&spring, laws),
            Axis::Fixed(axis) => {
                let axis = self.fixed(axis);
                self.with_gradient(|this| this.extension_along(&spring, &axis, laws))
            }
            Axis::Guide(slide) => {
                let axis = self.guide(slide);
                let moves = axis.iter().any(|part| part.link.is_some());
                self.with_gradient(|this| {
                    if moves {
                        this.extension_along_moving_guide(&spring, slide)
                    } else {
                        this.extension_along(&spring, &axis, laws)
                    }
                })
            }
        };
        let expansion = spring
            .expansion
            .map(|expansion| self.switched(expansion, &spring.name));
        let strain = match expansion {
            Some(expansion) => self.g.sub(extension, expansion),
            None => extension,
        };
        let expansion_rate = expansion.map(|expansion| {
            let rates = self.time_rates();
            self.g.derivative(expansion, &rates)
        });
        let stretching = self.rate_of(&levers);
        let strain_rate = match expansion_rate {
            Some(rate) => self.g.sub(stretching, rate),
            None => stretching,
        };

        let mut terms = Vec::new();
        let mut elastic = None;
        if let Some(stiffness) = spring.stiffness {
            let force = self.g.mul(stiffness, strain);
            terms.push(self.minus(force));
            elastic = Some(force);
            let half = self.g.ratio(1, 2);
            let square = self.g.powi(strain, 2);
            laws.potential
                .push(self.g.product(&[half, stiffness, square]));
        }
        if let Some(damping) = spring.damping {
            if let Some(expansion) = expansion {
                self.refuse_rates(expansion, &spring);
            }
            let force = self.g.mul(damping, strain_rate);
            terms.push(self.minus(force));
            let square = self.g.powi(strain_rate, 2);
            laws.dissipated.push(self.g.mul(damping, square));
        }
        let total = self.g.sum(&terms);
        let moves_itself = expansion.is_some_and(|e| !self.is_of_params(e));
        let conservative = !moves_itself && self.is_within_block(inertia, &levers);
        let force = match elastic {
            // Within one block and passive: its elastic part enters through P.
            Some(elastic) if conservative => {
                self.elastic(inertia, laws, elastic, &levers);
                if let [_, viscous] = terms[..] {
                    self.push_forces(laws, viscous, &levers);
                }
                total
            }
            _ => {
                let words = format!("force of `{}` on its second end", spring.name);
                let named = self.named_force(laws, &format!("F_{}", spring.name), total, &words);
                self.push_forces(laws, named, &levers);
                named
            }
        };
        if let Some(rate) = expansion_rate {
            laws.supplied.push(self.g.mul(force, rate));
        }
        laws.springs.push((strain, force));
    }

    /// A measure of the configuration and its gradient.
    fn with_gradient(&mut self, measure: impl FnOnce(&mut Self) -> Expr) -> (Expr, Vec<Expr>) {
        let measure = measure(self);
        let levers = self.gradient(measure);
        (measure, levers)
    }

    /// The place of an end; ground without a point stays at the origin.
    fn end_place(&mut self, end: &End) -> Vec<Turned> {
        let zero = self.g.zero();
        let at = end.at.unwrap_or(Local::Cartesian(zero, zero));
        self.place(end.body, at)
    }

    /// (second - first)·axis from the assembled configuration, or less the free length.
    fn extension_along(&mut self, spring: &Spring, axis: &[Turned], laws: &mut Laws) -> Expr {
        let shifts = [&spring.first, &spring.second].map(|end| {
            let place = self.end_place(end);
            let shift = self.displacement(&place, axis);
            self.named_displacement(end, axis, shift, laws)
        });
        let moved = self.g.sub(shifts[1], shifts[0]);
        match spring.length {
            None => moved,
            Some(length) => {
                let places = [&spring.first, &spring.second].map(|end| self.end_place(end));
                let [first, second] = places.map(|place| self.dot(&place, axis));
                let distance = self.g.sub(second, first);
                let map = &mut self.assembled_map();
                let assembled = self.expand_with(distance, map);
                let stretched = self.g.sub(assembled, length);
                let words = format!("extension of `{}` as assembled", spring.name);
                let stretched = self.named(&format!("e_{}⁰", spring.name), stretched, words);
                self.g.add(moved, stretched)
            }
        }
    }

    /// A displacement that is more than one symbol gets a name, as x_a in the article's (17).
    fn named_displacement(
        &mut self,
        end: &End,
        axis: &[Turned],
        shift: Expr,
        laws: &mut Laws,
    ) -> Expr {
        if self.g.as_symbol(shift).is_some() || self.g.as_number(shift).is_some() {
            return shift;
        }
        let letter = match axis {
            [single] if single.quarter % 2 == 0 => "x",
            [single] if single.quarter % 2 == 1 => "y",
            _ => "u",
        };
        let words = format!("displacement of `{}`", end.name);
        let named = self.named_force(laws, &format!("{letter}_{}", end.name), shift, &words);
        // Its derivatives are those of what it stands for.
        if let Some(symbol) = self.g.as_symbol(named) {
            self.attach_gradient(symbol, shift);
        }
        named
    }

    /// Tells how a defined symbol of the configuration changes with the coordinates.
    pub(in super::super) fn attach_gradient(&mut self, symbol: Symbol, value: Expr) {
        for (index, rate) in self.gradient(value).into_iter().enumerate() {
            if !self.g.is_zero(rate) {
                self.rates[index].insert(symbol, rate);
            }
        }
    }

    /// Change of the distance of the ends, without cancellation: δ = (d² - d⁰²)/(L + L⁰), and how
    /// it changes along each coordinate: ∂L/∂q = d·∂d/∂q / L.
    fn extension_along_line(&mut self, spring: &Spring, laws: &mut Laws) -> (Expr, Vec<Expr>) {
        let name = &spring.name;
        let [first, second] = [&spring.first, &spring.second].map(|end| self.end_place(end));
        let (one, zero) = (self.g.one(), self.g.zero());
        let (mut now, mut then, mut changes) = (Vec::new(), Vec::new(), Vec::new());
        let n = self.coordinates.len();
        let mut projected = vec![Vec::new(); n];
        for (letter, axis) in [("x", [one, zero]), ("y", [zero, one])] {
            let axis = self.fixed(axis);
            let [a, b] = [&first, &second].map(|place| self.dot(place, &axis));
            let distance = self.g.sub(b, a);
            let map = &mut self.assembled_map();
            let assembled = self.expand_with(distance, map);
            let assembled = self.named(&format!("Δ{letter}_{name}⁰"), assembled, "");
            let [a, b] = [&first, &second].map(|place| self.displacement(place, &axis));
            let moved = self.g.sub(b, a);
            let words = format!("change of Δ{letter}_{name}");
            let moved = self.named_part(laws, &format!("δ{letter}_{name}"), moved, &words);
            let component = self.g.add(assembled, moved);
            let words = format!("from end to end of `{name}`");
            let component = self.named_part(laws, &format!("Δ{letter}_{name}"), component, &words);
            let both = self.g.add(assembled, component);
            changes.push(self.g.mul(moved, both));
            for (index, projected) in projected.iter_mut().enumerate() {
                let [a, b] = [&first, &second].map(|place| self.lever(place, &axis, index));
                let lever = self.g.sub(b, a);
                projected.push(self.g.mul(component, lever));
                for part in [moved, component] {
                    self.attach_lever(part, index, lever);
                }
            }
            now.push(component);
            then.push(assembled);
        }
        let [length, start] = [now, then].map(|components| {
            let squares: Vec<Expr> = components.iter().map(|c| self.g.powi(*c, 2)).collect();
            let square = self.g.sum(&squares);
            self.g.sqrt(square)
        });
        let words = format!("length of `{name}` as assembled");
        let start = self.named(&format!("L_{name}⁰"), start, words);
        let words = format!("length of `{name}`");
        let length = self.named_force(laws, &format!("L_{name}"), length, &words);
        let change = self.g.sum(&changes);
        let lengths = self.g.add(length, start);
        let mut extension = self.g.div(change, lengths);
        if let Some(free) = spring.length {
            let stretched = self.g.sub(start, free);
            extension = self.g.add(extension, stretched);
        }
        let words = format!("extension of `{name}`");
        let note = match spring.length {
            Some(_) => "extension: the length less the free one, without cancellation",
            None => "extension: the length less that as assembled, without cancellation",
        };
        let symbol = self.names.symbol(&mut self.g, &format!("e_{name}"));
        self.define(symbol, extension, words);
        self.equation_line(&mut laws.lines, symbol, extension, note);
        let extension = self.g.of(symbol);
        let mut levers = Vec::new();
        for (index, terms) in projected.into_iter().enumerate() {
            let sum = self.g.sum(&terms);
            let lever = self.g.div(sum, length);
            levers.push(self.named_lever(spring, index, lever, laws));
        }
        for (index, lever) in levers.iter().enumerate() {
            for part in [extension, length] {
                self.attach_lever(part, index, *lever);
            }
        }
        (extension, levers)
    }

    /// A named part of the extension, unless it is no more than a symbol or a number.
    fn named_part(&mut self, laws: &mut Laws, name: &str, value: Expr, words: &str) -> Expr {
        if self.g.as_symbol(value).is_some() || self.g.as_number(value).is_some() {
            return value;
        }
        self.named_force(laws, name, value, words)
    }

    /// Tells how a named part changes with coordinate `index`.
    fn attach_lever(&mut self, part: Expr, index: usize, lever: Expr) {
        let Some(symbol) = self.g.as_symbol(part) else {
            return;
        };
        if !self.g.is_zero(lever) {
            self.rates[index].insert(symbol, lever);
        }
    }

    /// ∂L/∂q by its name.
    fn named_lever(&mut self, spring: &Spring, index: usize, lever: Expr, laws: &mut Laws) -> Expr {
        if self.g.is_zero(lever) {
            return lever;
        }
        let q = self.coordinates[index].symbol;
        let length = format!("L_{}", spring.name);
        let text = format!("∂{length}/∂{}", self.g.symbol_text(q));
        let latex = format!(
            "\\frac{{\\partial {}}}{{\\partial {}}}",
            latex_of(&length),
            self.g.symbol_latex(q)
        );
        let symbol = self.names.symbol_with_latex(&mut self.g, &text, &latex);
        let words = format!("lever of `{}`: change of its length", spring.name);
        self.define(symbol, lever, words);
        self.equation_line(&mut laws.lines, symbol, lever, "");
        self.g.of(symbol)
    }

    /// Along a guide that turns with its carrier: only between the carrier and its slide.
    fn extension_along_moving_guide(&mut self, spring: &Spring, slide: usize) -> Expr {
        let travel = self.variable(slide).shift;
        let carrier = match &self.model.bodies[slide].kind {
            BodyKind::Slide(slide) => slide.carrier,
            BodyKind::Link(_) | BodyKind::Ground => GROUND,
        };
        let extension = match (spring.first.body, spring.second.body) {
            (first, second) if first == carrier && second == slide => travel,
            (first, second) if first == slide && second == carrier => self.g.neg(travel),
            _ => {
                self.fault(
                    spring.span,
                    format!(
                        "`{}` acts along a guide that turns, between bodies that are not this slide and its carrier",
                        spring.name
                    ),
                    "let it act along the line between two points: name a point at each end",
                );
                travel
            }
        };
        match spring.length {
            None => extension,
            Some(length) => {
                let position = self.variable(slide).assembled;
                let stretched = self.g.sub(position, length);
                self.g.add(extension, stretched)
            }
        }
    }

    /// A damper needs the rate of the expansion, so the expansion must not use velocities.
    fn refuse_rates(&mut self, expansion: Expr, spring: &Spring) {
        for symbol in self.g.symbols_in(&[expansion]) {
            let used = self.model.measures.iter().find(|m| m.symbol == symbol);
            let Some(used) = used else { continue };
            let smooth = matches!(
                used.measure,
                Measure::Angle(_)
                    | Measure::Travel(_)
                    | Measure::Position(_)
                    | Measure::PointPosition(..)
                    | Measure::HingeAngle(_)
            );
            if !smooth {
                self.fault(
                    spring.span,
                    format!(
                        "the expansion of `{}` uses `{}`, but its damper needs the expansion's rate",
                        spring.name, used.name
                    ),
                    "use positions and time only, or leave out `damping`",
                );
            }
        }
    }
}
