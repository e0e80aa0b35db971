//! Springs, dampers and stacks: a force along the line between two ends, or along a direction.

use crate::model::{Axis, BodyKind, End, GROUND, Local, Measure, Spring};
use crate::symbolic::{Expr, Symbol};

use super::super::Derivation;
use super::super::inertia::Inertia;
use super::super::turned::Turned;
use super::Laws;

impl Derivation<'_> {
    /// F = -k ε - c ε̇ on the second end, ε = (second - first)·axis - expansion.
    pub(super) fn spring(&mut self, index: usize, inertia: &Inertia, laws: &mut Laws) {
        let spring = self.model.springs[index].clone();
        let extension = match spring.axis {
            Axis::Line => self.extension_along_line(&spring),
            Axis::Fixed(axis) => {
                let axis = self.fixed(axis);
                self.extension_along(&spring, &axis, laws)
            }
            Axis::Guide(slide) => {
                let axis = self.guide(slide);
                if axis.iter().all(|part| part.link.is_none()) {
                    self.extension_along(&spring, &axis, laws)
                } else {
                    self.extension_along_moving_guide(&spring, slide)
                }
            }
        };
        let levers = self.gradient(extension);
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
                let stretched = self.named(&format!("ε_{}⁰", spring.name), stretched, words);
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

    /// Change of the distance of the ends, without cancellation: (|d|² - |d⁰|²)/(|d| + |d⁰|).
    fn extension_along_line(&mut self, spring: &Spring) -> Expr {
        let [first, second] = [&spring.first, &spring.second].map(|end| self.end_place(end));
        let (one, zero) = (self.g.one(), self.g.zero());
        let mut squares = Vec::new();
        let mut squares_assembled = Vec::new();
        let mut changes = Vec::new();
        for axis in [[one, zero], [zero, one]] {
            let axis = self.fixed(axis);
            let [a, b] = [&first, &second].map(|place| self.dot(place, &axis));
            let distance = self.g.sub(b, a);
            let map = &mut self.assembled_map();
            let assembled = self.expand_with(distance, map);
            let [a, b] = [&first, &second].map(|place| self.displacement(place, &axis));
            let change = self.g.sub(b, a);
            let letter = if axis[0].quarter == 0 { "x" } else { "y" };
            let name = format!("Δ{letter}_{}⁰", spring.name);
            let assembled = self.named(&name, assembled, "");
            let now = self.g.add(assembled, change);
            squares.push(self.g.powi(now, 2));
            squares_assembled.push(self.g.powi(assembled, 2));
            let twice = self.g.add(assembled, now);
            changes.push(self.g.mul(change, twice));
        }
        let square = self.g.sum(&squares_assembled);
        let start = self.g.sqrt(square);
        let words = format!("length of `{}` as assembled", spring.name);
        let start = self.named(&format!("L_{}⁰", spring.name), start, words);
        let square = self.g.sum(&squares);
        let length = self.g.sqrt(square);
        let change = self.g.sum(&changes);
        let lengths = self.g.add(length, start);
        let extension = self.g.div(change, lengths);
        match spring.length {
            None => extension,
            Some(free) => {
                let stretched = self.g.sub(start, free);
                self.g.add(extension, stretched)
            }
        }
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
