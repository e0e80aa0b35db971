//! Settling a dyad: its quantities get their definitions, with running values and as assembled,
//! its branch, and the checks that its params must pass.

use std::collections::HashMap;

use crate::equations::{Direction, Discrete, Line, Loop, Shown, ShownUnit};
use crate::model::{BodyId, Pin};
use crate::structure::{Way, bodies_named, coordinate_named, turning_link};
use crate::symbolic::{Expr, Function, Symbol};

use super::super::Derivation;
use super::super::names::subscript;
use super::dyad::{Dyad, Solution};
use super::variables::{Dependent, Kind};

/// By how little, in rad or m, a drawing is to one side so that it is to neither.
const BETWEEN: f64 = 1e-9;

impl Derivation<'_> {
    /// Defines all that was found, with running values and as assembled.
    pub(super) fn settle(
        &mut self,
        way: &Way,
        mut dyad: Dyad<'_>,
        solution: Solution,
        name: &str,
        lines: &mut Vec<Line>,
    ) {
        let mut named = Vec::new();
        for (unknown, direction) in dyad.unknowns.clone().iter().zip(solution.directions) {
            let Some([cos, sin]) = direction else {
                named.push(None);
                continue;
            };
            let sub = match subscript(&unknown.name) {
                "" => format!("_{}", unknown.name),
                sub => sub.to_owned(),
            };
            let latex = self.g.symbol_latex(unknown.symbol).to_owned();
            let pair =
                [("c", "\\cos", cos), ("s", "\\sin", sin)].map(|(letter, function, value)| {
                    let symbol = self.names.symbol_with_latex(
                        &mut self.g,
                        &format!("{letter}{sub}"),
                        &format!("{function} {latex}"),
                    );
                    self.g.mark_varying(symbol);
                    dyad.steps.push((symbol, value, String::new()));
                    self.g.of(symbol)
                });
            named.push(Some(pair));
        }
        let map = self.assembled_twins(&dyad);
        let at_start = |this: &mut Self, expr: Expr| this.g.substitute(expr, &map);
        let closure = at_start(self, solution.closure);
        let gap = at_start(self, solution.gap);
        let range = solution
            .range
            .map(|range| range.map(|expr| at_start(self, expr)));
        let side = solution.side.map(|side| at_start(self, side));
        self.closing_checks(way, &dyad, name, closure, gap, range);
        if self
            .g
            .symbols_in(&dyad.steps.iter().map(|s| s.1).collect::<Vec<_>>())
            .contains(&dyad.branch)
        {
            self.branch(&dyad, side, closure, name);
        }
        for (symbol, value, words) in &dyad.steps {
            self.define(*symbol, *value, words.clone());
            self.equation_line(lines, *symbol, *value, "");
        }
        for (unknown, direction) in dyad.unknowns.clone().iter().zip(named) {
            match direction {
                Some([cos, sin]) => {
                    self.directions.push(Direction {
                        angle: unknown.symbol,
                        cos,
                        sin,
                    });
                    let assembled = [cos, sin].map(|part| self.g.substitute(part, &map));
                    self.count_turns(unknown, [cos, sin], assembled);
                }
                None => {
                    let [now, then] = [unknown.symbol, unknown.assembled].map(|s| self.g.of(s));
                    let shift = self.g.sub(now, then);
                    let body = &self.model.bodies[unknown.body].name;
                    let words = format!("position of `{body}` from the assembled one");
                    self.define(unknown.shift, shift, words);
                }
            }
        }
        let angles: Vec<Symbol> = dyad
            .unknowns
            .iter()
            .filter(|unknown| unknown.kind == Kind::Angle)
            .map(|unknown| unknown.symbol)
            .collect();
        if !angles.is_empty() {
            lines.push(self.angles_line(&angles));
        }
        self.loops.push(Loop {
            name: name.to_owned(),
            closure: solution.closure,
            has_transmission_angle: true,
        });
    }

    /// Defines every step's twin in the assembled configuration; returns running symbols to twins.
    fn assembled_twins(&mut self, dyad: &Dyad<'_>) -> HashMap<Symbol, Expr> {
        let mut map = self.assembled_map();
        for (symbol, value, _) in &dyad.steps {
            let value = self.g.substitute(*value, &map);
            let position = dyad
                .unknowns
                .iter()
                .find(|unknown| unknown.symbol == *symbol);
            let twin = match position {
                Some(unknown) => {
                    let body = &self.model.bodies[unknown.body].name;
                    let words = format!("position of `{body}` as assembled");
                    self.define(unknown.assembled, value, words);
                    unknown.assembled
                }
                None => {
                    let text = format!("{}⁰", self.g.symbol_text(*symbol));
                    let latex = self.g.symbol_latex(*symbol).to_owned();
                    let is_function = latex.starts_with("\\cos ") || latex.starts_with("\\sin ");
                    let latex = if is_function {
                        format!("{latex}^0")
                    } else {
                        format!("{{{latex}}}^0")
                    };
                    let twin = self.names.symbol_with_latex(&mut self.g, &text, &latex);
                    self.define(twin, value, "");
                    twin
                }
            };
            self.twins.insert(twin);
            let twin = self.g.of(twin);
            map.insert(*symbol, twin);
        }
        map
    }

    /// An angle counted from the assembled one, continuous over many turns.
    fn count_turns(&mut self, unknown: &Dependent, [cos, sin]: [Expr; 2], [cos0, sin0]: [Expr; 2]) {
        let name = self.model.bodies[unknown.body].name.clone();
        let angle = self.g.atan2(sin0, cos0);
        let angle = match self.guess(unknown.body).value {
            Some(guess) => self.g.function(Function::Unwrap, &[angle, guess]),
            None => angle,
        };
        self.twins.insert(unknown.assembled);
        self.define(
            unknown.assembled,
            angle,
            format!("angle of `{name}` as assembled"),
        );
        let cross = self.cross_of([cos0, sin0], [cos, sin]);
        let products = [(cos0, cos), (sin0, sin)].map(|(p, q)| self.g.mul(p, q));
        let dot = self.g.add(products[0], products[1]);
        let turned = self.g.atan2(cross, dot);
        let reference = self.turn_reference(unknown);
        let turned = self.g.function(Function::Unwrap, &[turned, reference]);
        self.define(
            unknown.shift,
            turned,
            format!("angle of `{name}` from the assembled one"),
        );
        let [start, shift] = [unknown.assembled, unknown.shift].map(|s| self.g.of(s));
        let angle = self.g.add(start, shift);
        self.define(unknown.symbol, angle, format!("angle of `{name}`"));
    }

    /// The discrete state that holds a variable's shift at the last accepted step.
    pub(super) fn turn_reference(&mut self, unknown: &Dependent) -> Expr {
        let name = self.model.bodies[unknown.body].name.clone();
        let reference = self.names.symbol(&mut self.g, &format!("turn_{name}"));
        self.g.mark_varying(reference);
        let (what, suffix) = match unknown.kind {
            Kind::Angle => ("angle", "turn"),
            Kind::Position => ("position", "reference"),
        };
        let shift = self.g.of(unknown.shift);
        let initial = self.g.zero();
        self.discretes.push(Discrete {
            name: format!("{name}.{suffix}"),
            meaning: format!("{what} of `{name}` from the assembled one at the last accepted step"),
            symbol: reference,
            initial,
            accepted: Some(shift),
            turning: unknown.kind == Kind::Angle,
        });
        self.g.of(reference)
    }

    /// Which of two ways a loop can close is as drawn.
    fn branch(&mut self, dyad: &Dyad<'_>, side: Option<Expr>, closure: Expr, name: &str) {
        let Some(side) = side else {
            let body = &self.model.bodies[dyad.unknowns[0].body];
            self.fault(
                body.span,
                format!("`{}` needs an angle or a place: the loop {name} can close in two ways", body.name),
                "add `angle = …` to a link or `at = …` to a slide, as you see it in the drawing; it need not be exact",
            );
            return;
        };
        let is_between = self.by_default(side).abs() < BETWEEN;
        if is_between && self.by_default(closure) > BETWEEN {
            let bodies = dyad.unknowns.clone().map(|unknown| unknown.body);
            self.fault(
                self.model.bodies[bodies[0]].span,
                format!(
                    "{} are drawn right between the two ways in which the loop {name} can close",
                    bodies_named(self.model, &bodies)
                ),
                "draw them on the side on which they stand: change an `angle` or an `at`; it need not be exact",
            );
        }
        let (plus, minus) = (self.g.one(), self.g.integer(-1));
        let sign = self.g.function(Function::IfPositive, &[side, plus, minus]);
        self.branches.push((dyad.branch, side));
        self.define(dyad.branch, sign, "which way the loop closes: as drawn");
    }

    /// A loop that cannot close says by how much, and what would.
    fn closing_checks(
        &mut self,
        way: &Way,
        dyad: &Dyad<'_>,
        name: &str,
        closure: Expr,
        gap: Expr,
        range: Option<[Expr; 2]>,
    ) {
        let bodies = [dyad.unknowns[0].body, dyad.unknowns[1].body];
        let span = self.way_span(way, &bodies);
        let metre = |value| Shown {
            value,
            unit: ShownUnit::Metre,
        };
        let first = self.model.bodies[bodies[0]].name.clone();
        let mut values = vec![metre(gap)];
        let hint = match range {
            Some([least, most]) => {
                values.extend([metre(least), metre(most)]);
                format!(
                    "`{first}` would need to be {{1}} to {{2}} long between its joints, or another link another length or angle"
                )
            }
            None => "change a length, an angle or the place of a guide".to_owned(),
        };
        let coordinate = self
            .structure
            .way_bodies(way)
            .into_iter()
            .find(|body| self.variable(*body).coordinate.is_some());
        let at = match coordinate {
            Some(body) => {
                let is_link = turning_link(self.model, body) == Some(body);
                let unit = if is_link {
                    ShownUnit::Degree
                } else {
                    ShownUnit::Metre
                };
                let what = if is_link { "angle" } else { "position" };
                values.push(Shown {
                    value: self.variable(body).assembled,
                    unit,
                });
                format!(
                    " at `{}` {what} {{{}}}",
                    self.model.bodies[body].name,
                    values.len() - 1
                )
            }
            None => String::new(),
        };
        let failure = self.failure(
            format!("the loop {name} cannot close:{at} the gap is {{0}}"),
            hint,
            span,
            values.clone(),
        );
        self.check(closure, true, failure);
        let threshold = self.g.ratio(1, 1_000_000_000_000);
        let margin = self.g.sub(closure, threshold);
        let stands = self.dead_point(dyad);
        let way_out = self.out_of_dead_point(dyad);
        let failure = self.failure(
            format!("the loop {name} stands at a dead point:{at} {stands}"),
            way_out,
            span,
            values,
        );
        self.check(margin, false, failure);
    }

    /// How the bodies that close a loop stand where they do not determine it.
    fn dead_point(&self, dyad: &Dyad<'_>) -> String {
        let bodies = dyad.unknowns.clone().map(|unknown| unknown.body);
        let [a, b] = bodies.map(|body| &self.model.bodies[body].name);
        match dyad.unknowns.clone().map(|unknown| unknown.kind) {
            [Kind::Angle, Kind::Angle] if self.are_pinned(bodies) => {
                format!("the joints of `{a}` and `{b}` lie in one line")
            }
            [Kind::Angle, Kind::Angle] => {
                format!("the joints of `{a}` and of `{b}` lie in parallel lines")
            }
            [Kind::Position, Kind::Position] => {
                format!("the guides of `{a}` and `{b}` are parallel")
            }
            [Kind::Angle, Kind::Position] => format!("`{a}` stands square to the guide of `{b}`"),
            [Kind::Position, Kind::Angle] => format!("`{b}` stands square to the guide of `{a}`"),
        }
    }

    fn are_pinned(&self, bodies: [BodyId; 2]) -> bool {
        let on = |body: &BodyId, pin: &Pin| pin.members.iter().any(|(member, _)| member == body);
        let pins = &self.model.pins;
        pins.iter()
            .any(|pin| bodies.iter().all(|body| on(body, pin)))
    }

    fn out_of_dead_point(&mut self, dyad: &Dyad<'_>) -> String {
        let other = coordinate_named(self.model, dyad.unknowns[0].body);
        let hint = match self.nearly_parallelogram(dyad.sum) {
            Some(equal) => {
                format!("{equal}: let opposite sides share their params, then they stay parallel")
            }
            None => "assemble it in another configuration: change an angle or a length".to_owned(),
        };
        format!("{hint}; or ask for the coordinate {other}, if that leads it through")
    }
}
