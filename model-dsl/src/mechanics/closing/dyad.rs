//! Dyads: two unknown variables that close one loop, in closed form.
//!
//! With W = -(what is known) the loop reads
//!
//! | unknown | loop | solution |
//! |---|---|---|
//! | two angles (RRR) | a e^{iα} + b e^{iβ} = W | the triangle with sides |a|, |b|, |W|: one root |
//! | an angle and a slide on a known guide (RRP) | a e^{iα} + s n = W | a circle and a line: one root |
//! | an angle and a slide on its link (RPR) | (a + s n) e^{iα} = W | a right triangle: one root |
//! | two slides (PRP, RPP) | s n + t m = W | linear |
//!
//! The sign of a root is the branch: that which is nearest to the drawing.

use std::collections::HashMap;

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::{Direction, Discrete, Line, Loop, Shown, ShownUnit};
use crate::model::BodyId;
use crate::structure::Way;
use crate::symbolic::{Expr, Function, Rational, Symbol};

use super::super::Derivation;
use super::super::names::subscript;
use super::super::turned::{Turned, wave};
use super::variables::{Dependent, Kind};

/// A quantity on the way to the unknowns: symbol, definition, words.
type Step = (Symbol, Expr, String);

/// How a loop's unknowns follow.
struct Solution {
    /// Cosine and sine of each unknown that is an angle.
    directions: [Option<[Expr; 2]>; 2],
    /// Positive where the loop closes.
    closure: Expr,
    /// Where the branch's sign is asked: positive on the drawn side, in running symbols.
    side: Option<Expr>,
    /// By how much the loop misses to close, and what is said about it.
    gap: Expr,
    /// Least and most length of the first unknown link that would close it.
    range: Option<[Expr; 2]>,
}

/// A loop on the way to its solution.
struct Dyad<'s> {
    sum: &'s [Turned],
    unknowns: [Dependent; 2],
    index: String,
    steps: Vec<Step>,
    branch: Symbol,
}

impl Derivation<'_> {
    /// Closes a loop for two unknowns: their values, rates and checks.
    pub(super) fn dyad(
        &mut self,
        way: &Way,
        sum: &[Turned],
        bodies: [BodyId; 2],
        number: Option<usize>,
    ) {
        let unknowns = bodies.map(|body| self.dependent(body));
        let name = self.way_name(way);
        let mut lines = vec![self.loop_line(sum)];
        let index = number.map_or_else(String::new, |n| n.to_string());
        let branch = self.names.symbol(&mut self.g, &format!("s{index}"));
        let mut dyad = Dyad {
            sum,
            unknowns,
            index,
            steps: Vec::new(),
            branch,
        };
        let kinds = [dyad.unknowns[0].kind, dyad.unknowns[1].kind];
        let slide = dyad
            .unknowns
            .iter()
            .position(|unknown| unknown.kind == Kind::Position);
        let solution = match (kinds, slide) {
            ([Kind::Angle, Kind::Angle], _) => self.two_angles(&mut dyad, &name),
            ([Kind::Position, Kind::Position], _) => self.two_slides(&mut dyad, &name),
            (_, slide) => {
                let slide = slide.unwrap_or(0);
                let (link, guide) = (bodies[1 - slide], bodies[slide]);
                let on_link = sum
                    .iter()
                    .any(|t| t.slide == Some(guide) && t.link == Some(link));
                if on_link {
                    self.slide_on_link(&mut dyad, slide, &name)
                } else {
                    self.angle_and_slide(&mut dyad, slide, &name)
                }
            }
        };
        self.settle(way, dyad, solution, &name, &mut lines);
        self.loop_rates(sum, bodies, &mut lines);
        self.section(&format!("Loop {name}"), lines);
    }

    /// Makes a step's symbol.
    fn step(&mut self, dyad: &mut Dyad<'_>, name: &str, value: Expr, words: &str) -> Expr {
        let symbol = self
            .names
            .symbol(&mut self.g, &format!("{name}{}", dyad.index));
        self.g.mark_varying(symbol);
        dyad.steps.push((symbol, value, words.to_owned()));
        self.g.of(symbol)
    }

    /// W: minus the vectors that turn with no unknown link and scale with no unknown slide.
    fn span(&mut self, dyad: &mut Dyad<'_>, name: &str) -> [Expr; 2] {
        let bodies = [dyad.unknowns[0].body, dyad.unknowns[1].body];
        let is_known = |t: &&Turned| {
            !t.slide.is_some_and(|slide| bodies.contains(&slide))
                && !t.link.is_some_and(|link| bodies.contains(&link))
        };
        let mut known: Vec<Turned> = dyad.sum.iter().filter(is_known).copied().collect();
        self.reverse(&mut known);
        let [x, y] = self.position(&known);
        let words = format!("vector that is left to close {name}");
        let x = self.step(dyad, "X", x, &words);
        let y = self.step(dyad, "Y", y, "");
        [x, y]
    }

    /// The vectors that turn with an unknown link, in its frame; slides are left out.
    fn own(&mut self, dyad: &Dyad<'_>, unknown: usize) -> [Expr; 2] {
        let body = dyad.unknowns[unknown].body;
        let sliding = dyad.unknowns.iter().map(|u| u.body).collect::<Vec<_>>();
        let parts: Vec<Turned> = dyad
            .sum
            .iter()
            .filter(|t| t.link == Some(body) && !t.slide.is_some_and(|s| sliding.contains(&s)))
            .copied()
            .collect();
        self.in_frame(&parts)
    }

    /// The direction in which an unknown slide moves, not scaled.
    fn sliding(&self, dyad: &Dyad<'_>, unknown: usize) -> Vec<Turned> {
        let body = dyad.unknowns[unknown].body;
        let along = dyad.sum.iter().filter(|t| t.slide == Some(body));
        along.map(|t| Turned { slide: None, ..*t }).collect()
    }

    /// RRR: κ W + η i W is the first vector, the second is what remains of W.
    fn two_angles(&mut self, dyad: &mut Dyad<'_>, name: &str) -> Solution {
        let [a, b] = [0, 1].map(|i| self.own(dyad, i));
        let [la, lb] = [a, b].map(|vector| self.length(vector));
        let [x, y] = self.span(dyad, name);
        let square = self.squares([x, y]);
        let square = self.step(dyad, "D", square, "its length squared");
        let [aa, bb] = [la, lb].map(|length| self.g.powi(length, 2));
        let plus: Rational = num_traits::One::one();
        let terms = [(square, plus.clone()), (aa, plus.clone()), (bb, -plus)];
        let projected = self.g.linear(num_traits::Zero::zero(), &terms);
        let half = self.g.ratio(1, 2);
        let kappa = self.g.mul(half, projected);
        let kappa = self.g.div(kappa, square);
        let kappa = self.step(dyad, "κ", kappa, "");
        let reach = [self.g.add(la, lb), self.g.sub(la, lb)];
        let [longest, shortest] = reach.map(|l| self.g.powi(l, 2));
        let [outer, inner] = [self.g.sub(longest, square), self.g.sub(square, shortest)];
        let radicand = self.g.mul(outer, inner);
        let quarter = self.g.ratio(1, 4);
        let both = self.g.mul(aa, bb);
        let closure = self.g.mul(quarter, radicand);
        let closure = self.g.div(closure, both);
        let root = self.g.sqrt(radicand);
        let sign = self.g.of(dyad.branch);
        let eta = self.g.product(&[half, sign, root]);
        let eta = self.g.div(eta, square);
        let eta = self.step(dyad, "η", eta, "");
        let parts = [(kappa, x), (eta, y), (kappa, y), (eta, x)].map(|(k, w)| self.g.mul(k, w));
        let first = [
            self.g.sub(parts[0], parts[1]),
            self.g.add(parts[2], parts[3]),
        ];
        let second = [self.g.sub(x, first[0]), self.g.sub(y, first[1])];
        let directions = [self.direction(first, a, aa), self.direction(second, b, bb)];

        let mut sides = Vec::new();
        for (i, (frame, square)) in [(a, aa), (b, bb)].into_iter().enumerate() {
            if let Some(drawn) = self.drawn(dyad.unknowns[i].body, frame) {
                let cross = self.cross_of([x, y], drawn);
                let side = self.g.div(cross, square);
                sides.push(if i == 0 { side } else { self.g.neg(side) });
            }
        }
        let distance = self.g.sqrt(square);
        let too_far = self.g.sub(distance, reach[0]);
        let difference = self.g.function(Function::Abs, &[reach[1]]);
        let too_near = self.g.sub(difference, distance);
        let gap = self.g.function(Function::Max, &[too_far, too_near]);
        let least = self.g.sub(distance, lb);
        let least = self.g.function(Function::Abs, &[least]);
        let most = self.g.add(distance, lb);
        Solution {
            directions: directions.map(Some),
            closure,
            side: (!sides.is_empty()).then(|| self.g.sum(&sides)),
            gap,
            range: Some([least, most]),
        }
    }

    /// RRP: s = W·n ± √(a² - (n×W)²).
    fn angle_and_slide(&mut self, dyad: &mut Dyad<'_>, slide: usize, name: &str) -> Solution {
        let link = 1 - slide;
        let frame = self.own(dyad, link);
        let length = self.length(frame);
        let [x, y] = self.span(dyad, name);
        let guide = self.sliding(dyad, slide);
        let [nx, ny] = self.position(&guide);
        let products = [(nx, x), (ny, y), (nx, y), (ny, x)].map(|(n, w)| self.g.mul(n, w));
        let along = self.g.add(products[0], products[1]);
        let along = self.step(dyad, "P", along, "its part along the guide");
        let across = self.g.sub(products[2], products[3]);
        let across = self.step(dyad, "N", across, "its part across the guide");
        let [aa, nn] = [length, across].map(|l| self.g.powi(l, 2));
        let radicand = self.g.sub(aa, nn);
        let closure = self.g.div(radicand, aa);
        let root = self.g.sqrt(radicand);
        let sign = self.g.of(dyad.branch);
        let reach = self.g.mul(sign, root);
        let position = self.g.add(along, reach);
        dyad.steps
            .push((dyad.unknowns[slide].symbol, position, String::new()));
        let position = self.g.of(dyad.unknowns[slide].symbol);
        let rest = [(x, nx), (y, ny)].map(|(w, n)| {
            let moved = self.g.mul(position, n);
            self.g.sub(w, moved)
        });
        let direction = self.direction(rest, frame, aa);
        let mut directions = [None, None];
        directions[link] = Some(direction);

        let mut sides = Vec::new();
        if let Some(guess) = self.guess(dyad.unknowns[slide].body).value {
            sides.push(self.g.sub(guess, along));
        }
        if let Some([dx, dy]) = self.drawn(dyad.unknowns[link].body, frame) {
            let products = [(dx, nx), (dy, ny)].map(|(d, n)| self.g.mul(d, n));
            let ahead = self.g.add(products[0], products[1]);
            sides.push(self.g.neg(ahead));
        }
        let distance = self.g.function(Function::Abs, &[across]);
        let gap = self.g.sub(distance, length);
        Solution {
            directions,
            closure,
            side: (!sides.is_empty()).then(|| self.g.sum(&sides)),
            gap,
            range: None,
        }
    }

    /// RPR: |a + s n| = |W|, s = -a·n ± √(W² - (n×a)²).
    fn slide_on_link(&mut self, dyad: &mut Dyad<'_>, slide: usize, name: &str) -> Solution {
        let link = 1 - slide;
        let frame = self.own(dyad, link);
        let guide = self.sliding(dyad, slide);
        let guide = self.in_frame(&guide);
        let [x, y] = self.span(dyad, name);
        let square = self.squares([x, y]);
        let square = self.step(dyad, "D", square, "its length squared");
        let products = [(frame[0], guide[0]), (frame[1], guide[1])].map(|(a, n)| self.g.mul(a, n));
        let ahead = self.g.add(products[0], products[1]);
        let aside = self.cross_of(guide, frame);
        let aside_squared = self.g.powi(aside, 2);
        let radicand = self.g.sub(square, aside_squared);
        let closure = self.g.div(radicand, square);
        let root = self.g.sqrt(radicand);
        let sign = self.g.of(dyad.branch);
        let reach = self.g.mul(sign, root);
        let position = self.g.sub(reach, ahead);
        dyad.steps
            .push((dyad.unknowns[slide].symbol, position, String::new()));
        let position = self.g.of(dyad.unknowns[slide].symbol);
        let inner = [0, 1].map(|axis| {
            let moved = self.g.mul(position, guide[axis]);
            self.g.add(frame[axis], moved)
        });
        let products = [(x, inner[0]), (y, inner[1]), (y, inner[0]), (x, inner[1])]
            .map(|(w, v)| self.g.mul(w, v));
        let cos = self.g.add(products[0], products[1]);
        let sin = self.g.sub(products[2], products[3]);
        let mut directions = [None, None];
        directions[link] = Some([self.g.div(cos, square), self.g.div(sin, square)]);

        let mut sides = Vec::new();
        if let Some(guess) = self.guess(dyad.unknowns[slide].body).value {
            sides.push(self.g.add(guess, ahead));
        }
        if let Some([dx, dy]) = self.drawn(dyad.unknowns[link].body, guide) {
            let products = [(dx, x), (dy, y)].map(|(d, w)| self.g.mul(d, w));
            sides.push(self.g.add(products[0], products[1]));
        }
        let distance = self.g.function(Function::Abs, &[aside]);
        let length = self.g.sqrt(square);
        let gap = self.g.sub(distance, length);
        Solution {
            directions,
            closure,
            side: (!sides.is_empty()).then(|| self.g.sum(&sides)),
            gap,
            range: None,
        }
    }

    /// Two slides: s (n×m) = W×m, t (n×m) = n×W.
    fn two_slides(&mut self, dyad: &mut Dyad<'_>, name: &str) -> Solution {
        let guides = [0, 1].map(|i| {
            let guide = self.sliding(dyad, i);
            self.position(&guide)
        });
        let span = self.span(dyad, name);
        let determinant = self.cross_of(guides[0], guides[1]);
        let numerators = [
            self.cross_of(span, guides[1]),
            self.cross_of(guides[0], span),
        ];
        for (unknown, numerator) in dyad.unknowns.clone().iter().zip(numerators) {
            let value = self.g.div(numerator, determinant);
            dyad.steps.push((unknown.symbol, value, String::new()));
        }
        let closure = self.g.powi(determinant, 2);
        Solution {
            directions: [None, None],
            closure,
            side: None,
            gap: self.g.zero(),
            range: None,
        }
    }

    /// Defines all that was found, with running values and as assembled.
    fn settle(
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
            let sub = subscript(&unknown.name).to_owned();
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
            self.branch(&dyad, side);
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
    fn branch(&mut self, dyad: &Dyad<'_>, side: Option<Expr>) {
        let Some(side) = side else {
            let body = &self.model.bodies[dyad.unknowns[0].body];
            let error = Diagnostic::error(format!(
                "`{}` needs an angle or a place: the loop can close in two ways",
                body.name
            ))
            .at(self.model.source.site(body.span))
            .hint("add `angle = …` to a link or `at = …` to a slide, as you see it in the drawing; it need not be exact");
            self.errors.push(error);
            return;
        };
        let (plus, minus) = (self.g.one(), self.g.integer(-1));
        let sign = self.g.function(Function::IfPositive, &[side, plus, minus]);
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
            .way_bodies(self.model, way)
            .into_iter()
            .find(|body| self.variable(*body).coordinate.is_some());
        let at = match coordinate {
            Some(body) => {
                let is_link = self.structure.turning_link(self.model, body) == Some(body);
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
        let failure = self.failure(
            format!("the loop {name} stands at a dead point:{at} two of its links lie in one line"),
            "assemble it in another configuration: change an angle or a length",
            span,
            values,
        );
        self.check(margin, false, failure);
    }

    /// A vector in its link's own frame.
    fn in_frame(&mut self, parts: &[Turned]) -> [Expr; 2] {
        [0, 3].map(|axis| {
            let terms: Vec<Expr> = parts
                .iter()
                .map(|part| {
                    let turn = wave(&mut self.g, part.offset, part.quarter + axis);
                    self.scaled(part, turn)
                })
                .collect();
            self.g.sum(&terms)
        })
    }

    fn scaled(&mut self, part: &Turned, turn: Expr) -> Expr {
        let scaled = self.g.mul(part.magnitude, turn);
        match part.slide {
            Some(slide) => {
                let position = self.variable(slide).value;
                self.g.mul(scaled, position)
            }
            None => scaled,
        }
    }

    /// Length of a vector of params; a bare param is taken to be positive, which a check ensures.
    fn length(&mut self, [x, y]: [Expr; 2]) -> Expr {
        if self.g.is_zero(y) {
            let positive = if self.g.is_written_negative(x) {
                self.g.neg(x)
            } else {
                x
            };
            if self.g.as_symbol(positive).is_some() {
                return positive;
            }
        }
        let square = self.squares([x, y]);
        self.g.sqrt(square)
    }

    fn squares(&mut self, vector: [Expr; 2]) -> Expr {
        let squares = vector.map(|component| self.g.powi(component, 2));
        self.g.sum(&squares)
    }

    /// a × b of plain vectors.
    fn cross_of(&mut self, a: [Expr; 2], b: [Expr; 2]) -> Expr {
        let products = [(a[0], b[1]), (a[1], b[0])].map(|(p, q)| self.g.mul(p, q));
        self.g.sub(products[0], products[1])
    }

    /// A vector of a link's frame at its drawn angle, if one was given.
    fn drawn(&mut self, body: BodyId, [fx, fy]: [Expr; 2]) -> Option<[Expr; 2]> {
        let guess = self.guess(body).value?;
        let (cos, sin) = (self.g.cos(guess), self.g.sin(guess));
        let products = [(cos, fx), (sin, fy), (sin, fx), (cos, fy)].map(|(p, q)| self.g.mul(p, q));
        Some([
            self.g.sub(products[0], products[1]),
            self.g.add(products[2], products[3]),
        ])
    }

    /// Cosine and sine of a link's angle from its vector in the fixed frame and in its own.
    fn direction(&mut self, vector: [Expr; 2], frame: [Expr; 2], square: Expr) -> [Expr; 2] {
        if self.g.is_zero(frame[1]) {
            return vector.map(|component| self.g.div(component, frame[0]));
        }
        let [vx, vy] = vector;
        let [fx, fy] = frame;
        let products = [(vx, fx), (vy, fy), (vy, fx), (vx, fy)].map(|(p, q)| self.g.mul(p, q));
        let cos = self.g.add(products[0], products[1]);
        let sin = self.g.sub(products[2], products[3]);
        [self.g.div(cos, square), self.g.div(sin, square)]
    }
}
