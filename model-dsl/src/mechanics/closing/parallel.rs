//! Parallelograms and redundant joints: loops that hold by the equality of expressions.
//!
//! Where opposite sides of a loop are the same expressions and it is drawn as a parallelogram, its
//! unknown links turn with the opposite ones: they get the same angle, no root, and no trouble
//! where all four lie in one line. A further parallel leg is then a joint that holds by itself.

use std::collections::HashSet;

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::Line;
use crate::model::BodyId;
use crate::structure::{Way, joints_named};
use crate::symbolic::{Evaluator, Expr, Function};

use super::super::Derivation;
use super::super::turned::Turned;
use super::variables::Dependent;

/// A link that turns with another, or with the fixed frame, some quarter turns ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Alias {
    /// The other link; `None` for the fixed frame.
    pub link: Option<BodyId>,
    /// Quarter turns, 0 to 3.
    pub quarter: u8,
}

impl Derivation<'_> {
    /// Closes a loop as a parallelogram, if it is one.
    pub(super) fn parallelogram(&mut self, way: &Way, sum: &[Turned], bodies: [BodyId; 2]) -> bool {
        let Some(pairs) = self.drawn_parallel(sum, bodies) else {
            return false;
        };
        let name = self.way_name(way);
        let unknowns = bodies.map(|body| self.dependent(body));
        let mut lines = vec![self.loop_line(sum)];
        for (unknown, alias) in unknowns.iter().zip(pairs) {
            self.turn_with(unknown, alias, &mut lines);
        }
        self.section(&format!("Parallelogram {name}"), lines);
        true
    }

    /// For each unknown the link with which it would turn, for each way in which the sides of the
    /// loop are equal in pairs (a rhombus has two).
    fn opposite_sides(&mut self, sum: &[Turned], bodies: [BodyId; 2]) -> Vec<[Alias; 2]> {
        if sum.len() != 4 || sum.iter().any(|part| part.slide.is_some()) {
            return Vec::new();
        }
        let is_unknown = |part: &&Turned| bodies.iter().any(|b| part.link == Some(*b));
        let own: Vec<Turned> = sum.iter().filter(is_unknown).copied().collect();
        let known: Vec<Turned> = sum
            .iter()
            .filter(|part| !is_unknown(part))
            .copied()
            .collect();
        let (&[one, other], &[first, second]) = (own.as_slice(), known.as_slice()) else {
            return Vec::new();
        };
        let unknown = if one.link == Some(bodies[0]) {
            [one, other]
        } else {
            [other, one]
        };
        let mut found = Vec::new();
        for [a, b] in [[first, second], [second, first]] {
            let pair = [self.opposes(&unknown[0], &a), self.opposes(&unknown[1], &b)];
            if let [Some(a), Some(b)] = pair {
                found.push([a, b]);
            }
        }
        found
    }

    /// How a link has to turn so that its vector is the opposite of another.
    fn opposes(&mut self, unknown: &Turned, known: &Turned) -> Option<Alias> {
        if unknown.offset != known.offset {
            return None;
        }
        let turned = (known.quarter + 4 - unknown.quarter) % 4;
        let [own, other] = [unknown, known].map(|part| self.in_params(part.magnitude));
        let opposite = self.g.neg(other);
        let quarter = if own == opposite {
            turned
        } else if own == other {
            (turned + 2) % 4
        } else {
            return None;
        };
        Some(Alias {
            link: known.link,
            quarter,
        })
    }

    /// The pairing of equal sides that is as drawn with the default params, unless the crossed loop
    /// is nearer to the drawing.
    fn drawn_parallel(&mut self, sum: &[Turned], bodies: [BodyId; 2]) -> Option<[Alias; 2]> {
        let candidates = self.opposite_sides(sum, bodies);
        if candidates.is_empty() {
            return None;
        }
        let known: Vec<Turned> = sum
            .iter()
            .filter(|part| !bodies.iter().any(|b| part.link == Some(*b)))
            .copied()
            .collect();
        let place = self.position(&known);
        let map = self.assembled_map();
        let [x, y] = place.map(|component| {
            let component = self.g.substitute(component, &map);
            self.by_default(component)
        });
        let diagonal = y.atan2(x);
        let mut best: Option<(f64, [Alias; 2])> = None;
        for pairs in candidates {
            let (mut parallel, mut crossed) = (0.0, 0.0);
            for (body, alias) in bodies.into_iter().zip(pairs) {
                let Some(guess) = self.guess(body).value else {
                    continue;
                };
                let guess = self.by_default(guess);
                let base = match alias.link {
                    Some(link) => self.by_default(self.variable(link).assembled),
                    None => 0.0,
                };
                let angle = base + f64::from(alias.quarter) * std::f64::consts::FRAC_PI_2;
                parallel += (guess - angle).cos();
                crossed += (guess - (2.0 * diagonal - angle)).cos();
            }
            let is_better = best.is_none_or(|(known, _)| parallel > known);
            if parallel >= crossed - 1e-9 && is_better {
                best = Some((parallel, pairs));
            }
        }
        best.map(|(_, pairs)| pairs)
    }

    /// A link turns with another from now on.
    fn turn_with(&mut self, unknown: &Dependent, alias: Alias, lines: &mut Vec<Line>) {
        let body = unknown.body;
        let (start, shift) = match alias.link {
            Some(link) => (self.variable(link).assembled, self.variable(link).shift),
            None => (self.g.zero(), self.g.zero()),
        };
        let turn = {
            let pi = self.g.pi();
            let halves = self.g.ratio(i64::from(alias.quarter), 2);
            self.g.mul(pi, halves)
        };
        let start = self.g.add(start, turn);
        let start = match self.guess(body).value {
            Some(guess) => self.g.function(Function::Unwrap, &[start, guess]),
            None => start,
        };
        let words = format!("angle of `{}` as assembled", self.model.bodies[body].name);
        self.define(unknown.assembled, start, words);
        self.define(unknown.shift, shift, "");
        let [start, own_shift] = [unknown.assembled, unknown.shift].map(|s| self.g.of(s));
        let value = self.g.add(start, own_shift);
        self.define(
            unknown.symbol,
            value,
            format!("angle of `{}`", self.model.bodies[body].name),
        );
        let rates = match alias.link {
            Some(link) => self.variable(link).rates.clone(),
            None => vec![self.g.zero(); self.coordinates.len()],
        };
        if let Some(variable) = &mut self.variables[body] {
            variable.rates = rates;
        }
        for index in 0..self.coordinates.len() {
            self.attach_rate(body, index);
        }
        // What acts on the turn from the assembled angle acts on the other's: no sum remembers it.
        if let Some(variable) = &mut self.variables[body] {
            variable.shift = shift;
        }
        self.aliases[body] = Some(alias);
        let (name, latex) = (
            self.g.symbol_text(unknown.symbol),
            self.g.symbol_latex(unknown.symbol),
        );
        let (other, other_latex) = match alias.link {
            Some(link) => {
                let symbol = self.variable(link).symbol;
                (
                    self.g.symbol_text(symbol).to_owned(),
                    self.g.symbol_latex(symbol).to_owned(),
                )
            }
            None => (String::new(), String::new()),
        };
        let turn = match (alias.quarter % 4, alias.link) {
            (0, None) => ("0", "0"),
            (1, None) => ("π/2", "\\pi/2"),
            (2, None) => ("π", "\\pi"),
            (_, None) => ("-π/2", "-\\pi/2"),
            (0, Some(_)) => ("", ""),
            (1, Some(_)) => (" + π/2", " + \\pi/2"),
            (2, Some(_)) => (" + π", " + \\pi"),
            (_, Some(_)) => (" - π/2", " - \\pi/2"),
        };
        lines.push(Line::Written {
            text: format!("{name} = {other}{} (opposite sides are equal)", turn.0),
            latex: format!(
                "{latex} = {other_latex}{} \\quad\\text{{(opposite sides are equal)}}",
                turn.1
            ),
        });
    }

    /// A loop with fewer than two unknowns must hold by itself.
    pub(super) fn redundant(&mut self, way: &Way, unknown: Option<BodyId>) {
        let mut sum = self.around(way);
        sum.retain(|part| {
            let size = self.in_params(part.magnitude);
            !self.g.is_zero(size)
        });
        let holds = match unknown {
            None => sum.is_empty(),
            Some(body) => match sum.as_slice() {
                [a, b] if a.slide.is_none() && b.slide.is_none() => {
                    let (own, other) = if a.link == Some(body) { (a, b) } else { (b, a) };
                    match self.opposes(own, other) {
                        Some(alias) if own.link == Some(body) && other.link != Some(body) => {
                            let unknown = self.dependent(body);
                            self.turn_with(&unknown, alias, &mut Vec::new());
                            true
                        }
                        _ => false,
                    }
                }
                _ => false,
            },
        };
        let name = self.way_name(way);
        let closing: Vec<BodyId> = unknown.into_iter().collect();
        let span = self.way_span(way, &closing);
        let around = self.structure.way_bodies(way);
        let joints = joints_named(self.model, &around);
        if holds {
            let warning = Diagnostic::warning(format!(
                "the loop {name} is redundant: of {joints} one is too many, but opposite sides are equal"
            ))
            .hint("the mechanism moves as without it; its forces share the load in a way that rigid links cannot tell");
            self.warnings.push(self.model.source.blame(span, warning));
            return;
        }
        if let Some(body) = unknown
            && self.variables[body].is_none()
        {
            // The derivation goes on, so that further errors are found.
            let unknown = self.dependent(body);
            let zero = self.g.zero();
            for symbol in [unknown.symbol, unknown.assembled, unknown.shift] {
                self.define(symbol, zero, "");
            }
        }
        let equal = match sum.as_slice() {
            [a, b] if unknown.is_some() => self.equal_in_value(a, b),
            _ => None,
        };
        let fits = unknown.is_none() && self.fits_by_default(&sum);
        let hint = match equal {
            Some(equal) => format!(
                "{equal}: let the two share one param, so that they are equal with all values"
            ),
            None if fits => "it fits with these values only: let opposite sides share their params, so that it fits with all".to_owned(),
            None => "remove a link or a pin of this loop, or let it be a parallelogram whose opposite sides share their params".to_owned(),
        };
        self.fault(
            span,
            format!("the loop {name} is over-constrained by {joints}: its bodies cannot move against each other"),
            hint,
        );
    }

    /// Whether two vectors are equally long with the default params, but not as expressions: what to
    /// say of it.
    pub(super) fn equal_in_value(&mut self, a: &Turned, b: &Turned) -> Option<String> {
        if a.slide.is_some() || b.slide.is_some() {
            return None;
        }
        if self.are_equal(a, b) {
            return None;
        }
        let [one, other] = [a, b].map(|part| self.by_default(part.magnitude).abs());
        let written = |this: &mut Self, part: &Turned| {
            let opposite = this.g.neg(part.magnitude);
            let symbol = this
                .g
                .as_symbol(part.magnitude)
                .or(this.g.as_symbol(opposite));
            let link = part.link.map(|link| &this.model.bodies[link].name);
            match (symbol, link) {
                (Some(symbol), _) => format!("`{}`", this.g.symbol_text(symbol)),
                (None, Some(link)) => format!("the length on `{link}`"),
                (None, None) => "the distance on ground".to_owned(),
            }
        };
        let is_near = (one - other).abs() <= 1e-9 * one;
        is_near.then(|| {
            format!(
                "{} and {} are equal in their present values only",
                written(self, a),
                written(self, b)
            )
        })
    }

    fn are_equal(&mut self, a: &Turned, b: &Turned) -> bool {
        let [a, b] = [a, b].map(|part| self.in_params(part.magnitude));
        a == b || a == self.g.neg(b)
    }

    /// The opposite sides of a loop that are equal in value only, if each side has its opposite.
    pub(super) fn nearly_parallelogram(&mut self, sum: &[Turned]) -> Option<String> {
        let [a, b, c, d] = sum else {
            return None;
        };
        let mut said = Vec::new();
        for [one, other] in [[a, c], [b, d]] {
            let is_same = self.are_equal(one, other);
            match self.equal_in_value(one, other) {
                Some(equal) => said.push(equal),
                None if is_same && one.slide.is_none() && other.slide.is_none() => {}
                None => return None,
            }
        }
        (!said.is_empty()).then(|| said.join(", "))
    }

    /// Whether a sum of vectors vanishes in the assembled configuration with the default params.
    fn fits_by_default(&mut self, sum: &[Turned]) -> bool {
        let place = self.position(sum);
        let map = self.assembled_map();
        let place = place.map(|component| self.g.substitute(component, &map));
        let size: f64 = sum
            .iter()
            .map(|part| self.by_default(part.magnitude).abs())
            .sum();
        place
            .into_iter()
            .all(|component| self.by_default(component).abs() <= 1e-9 * size)
    }

    /// Value of an expression of params with their defaults.
    pub(crate) fn by_default(&self, expr: Expr) -> f64 {
        let mut evaluator = Evaluator::new(&self.g);
        for param in &self.model.params {
            evaluator.define(param.symbol, param.default);
        }
        // Only what the expression leads to: this is asked for each loop.
        let mut seen = HashSet::new();
        let mut stack = self.g.symbols_in(&[expr]);
        while let Some(symbol) = stack.pop() {
            if seen.insert(symbol)
                && let Some(&value) = self.values.get(&symbol)
            {
                evaluator.define(symbol, value);
                stack.extend(self.g.symbols_in(&[value]));
            }
        }
        evaluator.value(expr)
    }
}
