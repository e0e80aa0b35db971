//! Closing: the variables of the mechanism, and how each loop gives the values and rates of its
//! two unknown angles.
//!
//! A loop reads `known vectors + a e^{iφu} + b e^{iφv} = 0`. With W = -(known vectors) its value
//! follows from the triangle |a|, |b|, |W| by one square root, whose sign is the branch; the angles
//! are counted from the assembled configuration, continuous over many turns by a reference in the
//! discrete state. Its rates follow from the loop's term-by-term derivative, which is linear.

use std::collections::{HashMap, HashSet};

use crate::equations::{Direction, Discrete, Line, Loop, Partial, Shown, ShownUnit, Solve};
use crate::model::{BodyId, BodyKind, Guess, Link};
use crate::structure::ClosedLoop;
use crate::symbolic::{Expr, Function, Symbol};

use super::names::{accented, accented_latex, subscript};
use super::turned::{Turned, wave};
use super::{Coordinate, Definition, Derivation, Variable};

/// A loop as `known + first + second = 0`.
struct Triangle {
    known: Vec<Turned>,
    first: Vec<Turned>,
    second: Vec<Turned>,
}

/// A symbol in the running configuration with its definition.
type Step = (Symbol, Expr, String);

impl Derivation<'_> {
    /// Makes the symbols of the independent coordinates.
    pub(super) fn name_coordinates(&mut self) {
        for (index, &body) in self.structure.coordinates.clone().iter().enumerate() {
            let name = self.variable_name(body);
            let symbol = self.names.symbol(&mut self.g, &name);
            let value = self.g.of(symbol);
            let (assembled, guess) = match &self.model.bodies[body].kind {
                BodyKind::Link(link) => {
                    let assembled = self.assembled_symbol(&name);
                    (self.g.of(assembled), Some((assembled, link.angle)))
                }
                BodyKind::Slide(slide) => (slide.at.value.unwrap_or_else(|| self.g.zero()), None),
                BodyKind::Ground => continue,
            };
            if let Some((assembled, guess)) = guess {
                let start = guess.value.unwrap_or_else(|| self.g.zero());
                let words = format!("angle of `{}` as assembled", self.model.bodies[body].name);
                self.define(assembled, start, words);
            }
            let rate = self.names.symbol_with_latex(
                &mut self.g,
                &accented(&name, '\u{307}'),
                &accented_latex(&name, "dot"),
            );
            let acceleration = self.names.symbol_with_latex(
                &mut self.g,
                &accented(&name, '\u{308}'),
                &accented_latex(&name, "ddot"),
            );
            for varying in [symbol, rate, acceleration] {
                self.g.mark_varying(varying);
            }
            self.coordinates.push(Coordinate {
                body,
                symbol,
                rate,
                acceleration,
            });
            let shift = self.g.sub(value, assembled);
            let rates = (0..self.structure.coordinates.len())
                .map(|i| self.g.integer(i64::from(i == index)))
                .collect();
            let one = self.g.one();
            self.rates[index].insert(symbol, one);
            self.variables[body] = Some(Variable {
                symbol,
                value,
                assembled,
                shift,
                rates,
                coordinate: Some(index),
            });
        }
    }

    /// `φ1` as the user wants it, else `φ_crank`; `x_stage`.
    fn variable_name(&self, body: BodyId) -> String {
        let name = &self.model.bodies[body].name;
        match &self.model.bodies[body].kind {
            BodyKind::Link(Link {
                symbol: Some(symbol),
                ..
            }) => symbol.clone(),
            BodyKind::Link(_) => format!("φ_{name}"),
            BodyKind::Slide(_) | BodyKind::Ground => format!("x_{name}"),
        }
    }

    fn assembled_symbol(&mut self, name: &str) -> Symbol {
        let latex = format!("{}^0", crate::notation::latex_of(name));
        self.names
            .symbol_with_latex(&mut self.g, &format!("{name}⁰"), &latex)
    }

    /// Closes all loops in their order.
    pub(super) fn close_loops(&mut self) {
        let loops = self.structure.loops.clone();
        let several = loops.len() > 1;
        for (number, closed) in loops.iter().enumerate() {
            self.close(closed, several.then_some(number + 1));
        }
        self.exact_angles();
    }

    fn close(&mut self, closed: &ClosedLoop, number: Option<usize>) {
        let (u, v) = closed.unknowns;
        let names = [u, v].map(|body| self.variable_name(body));
        let symbols = names
            .clone()
            .map(|name| self.names.symbol(&mut self.g, &name));
        let assembled = names.clone().map(|name| self.assembled_symbol(&name));
        let shifts = [0, 1].map(|i| {
            let text = format!("{} - {}", names[i], self.g.symbol_text(assembled[i]));
            let latex = format!(
                "{} - {}",
                self.g.symbol_latex(symbols[i]),
                self.g.symbol_latex(assembled[i])
            );
            self.g.symbol_written_as_sum(text, latex)
        });
        for symbol in symbols.into_iter().chain(shifts) {
            self.g.mark_varying(symbol);
        }
        let zero = self.g.zero();
        let none = vec![zero; self.coordinates.len()];
        for (i, body) in [u, v].into_iter().enumerate() {
            self.variables[body] = Some(Variable {
                symbol: symbols[i],
                value: self.g.of(symbols[i]),
                assembled: self.g.of(assembled[i]),
                shift: self.g.of(shifts[i]),
                rates: none.clone(),
                coordinate: None,
            });
        }
        let triangle = self.triangle(closed);
        let name: Vec<&str> = closed
            .links
            .iter()
            .map(|b| self.model.bodies[*b].name.as_str())
            .collect();
        let name = name.join("–");

        let mut lines = vec![self.loop_line(&triangle)];
        self.values(
            closed, &triangle, &name, number, assembled, symbols, shifts, &mut lines,
        );
        lines.push(self.angles_line(symbols));
        self.loop_rates(closed, &triangle, &names, &mut lines);
        let title = format!("Loop {name}");
        self.section(&title, lines);
    }

    /// The loop's vectors, sorted by what is known.
    fn triangle(&mut self, closed: &ClosedLoop) -> Triangle {
        let members = &self.model.pins[closed.pin].members;
        let [one, other] = [closed.members.0, closed.members.1].map(|m| members[m]);
        let mut sum = self.place(one.0, one.1);
        let mut back = self.place(other.0, other.1);
        self.reverse(&mut back);
        sum.extend(back.into_iter().rev());
        let sum = self.merge(sum);
        let of = |link: Option<BodyId>, wanted: bool| -> Vec<Turned> {
            let is = |t: &&Turned| match link {
                Some(link) => t.link == Some(link),
                None => t.link != Some(closed.unknowns.0) && t.link != Some(closed.unknowns.1),
            };
            sum.iter().filter(|t| is(t) == wanted).copied().collect()
        };
        Triangle {
            known: of(None, true),
            first: of(Some(closed.unknowns.0), true),
            second: of(Some(closed.unknowns.1), true),
        }
    }

    /// A vector in its link's own frame.
    fn in_frame(&mut self, parts: &[Turned]) -> [Expr; 2] {
        let mut sums = [Vec::new(), Vec::new()];
        for part in parts {
            for (axis, sum) in sums.iter_mut().enumerate() {
                let quarter = part.quarter + if axis == 0 { 0 } else { 3 };
                let turn = wave(&mut self.g, part.offset, quarter);
                sum.push(self.g.mul(part.magnitude, turn));
            }
        }
        sums.map(|sum| self.g.sum(&sum))
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
        let squares = [self.g.powi(x, 2), self.g.powi(y, 2)];
        let sum = self.g.sum(&squares);
        self.g.sqrt(sum)
    }

    /// Values of the two angles.
    #[allow(clippy::too_many_arguments)]
    fn values(
        &mut self,
        closed: &ClosedLoop,
        triangle: &Triangle,
        name: &str,
        number: Option<usize>,
        assembled: [Symbol; 2],
        symbols: [Symbol; 2],
        shifts: [Symbol; 2],
        lines: &mut Vec<Line>,
    ) {
        let (u, v) = closed.unknowns;
        let index = number.map_or_else(String::new, |n| n.to_string());
        let [a, b] = [&triangle.first, &triangle.second].map(|parts| self.in_frame(parts));
        let [la, lb] = [a, b].map(|vector| self.length(vector));

        let mut steps: Vec<Step> = Vec::new();
        let step = |this: &mut Self, steps: &mut Vec<Step>, name: &str, value, words: &str| {
            let symbol = this.names.symbol(&mut this.g, name);
            this.g.mark_varying(symbol);
            steps.push((symbol, value, words.to_owned()));
            this.g.of(symbol)
        };
        let mut known = triangle.known.clone();
        self.reverse(&mut known);
        let [x, y] = self.position(&known);
        let words = format!("vector that the two links that close {name} span");
        let x = step(self, &mut steps, &format!("X{index}"), x, &words);
        let y = step(self, &mut steps, &format!("Y{index}"), y, "");
        let squares = [self.g.powi(x, 2), self.g.powi(y, 2)];
        let square = self.g.sum(&squares);
        let square = step(
            self,
            &mut steps,
            &format!("D{index}"),
            square,
            "its length squared",
        );

        let [aa, bb] = [la, lb].map(|length| self.g.powi(length, 2));
        let projected = self.g.linear(
            num_traits::Zero::zero(),
            &[(square, one()), (aa, one()), (bb, -one())],
        );
        let half = self.g.ratio(1, 2);
        let kappa = self.g.product(&[half, projected]);
        let kappa = self.g.div(kappa, square);
        let kappa = step(self, &mut steps, &format!("κ{index}"), kappa, "");

        let [longest, shortest] = [self.g.add(la, lb), self.g.sub(la, lb)];
        let [longest, shortest] = [longest, shortest].map(|l| self.g.powi(l, 2));
        let outer = self.g.sub(longest, square);
        let inner = self.g.sub(square, shortest);
        let radicand = self.g.mul(outer, inner);
        let quarter = self.g.ratio(1, 4);
        let closure = self.g.product(&[quarter, radicand]);
        let both = self.g.mul(aa, bb);
        let closure = self.g.div(closure, both);
        let root = self.g.sqrt(radicand);
        let branch = self.names.symbol(&mut self.g, &format!("s{index}"));
        let branch_value = self.g.of(branch);
        let eta = self.g.product(&[half, branch_value, root]);
        let eta = self.g.div(eta, square);
        let eta = step(self, &mut steps, &format!("η{index}"), eta, "");

        // First vector κ W + η i W; the second is what remains of W.
        let parts = [(kappa, x), (eta, y), (kappa, y), (eta, x)].map(|(k, w)| self.g.mul(k, w));
        let first = [
            self.g.sub(parts[0], parts[1]),
            self.g.add(parts[2], parts[3]),
        ];
        let second = [self.g.sub(x, first[0]), self.g.sub(y, first[1])];
        let mut directions = Vec::new();
        for (i, (vector, frame, square)) in
            [(first, a, aa), (second, b, bb)].into_iter().enumerate()
        {
            let [cos, sin] = self.direction(vector, frame, square);
            let sub = subscript(self.g.symbol_text(symbols[i])).to_owned();
            let latex = self.g.symbol_latex(symbols[i]).to_owned();
            let pair =
                [("c", "\\cos", cos), ("s", "\\sin", sin)].map(|(letter, function, value)| {
                    let symbol = self.names.symbol_with_latex(
                        &mut self.g,
                        &format!("{letter}{sub}"),
                        &format!("{function} {latex}"),
                    );
                    self.g.mark_varying(symbol);
                    steps.push((symbol, value, String::new()));
                    self.g.of(symbol)
                });
            directions.push(pair);
        }

        // The same in the assembled configuration.
        let mut map = self.assembled_map();
        let mut twins = Vec::new();
        for (symbol, value, _) in &steps {
            let value = self.g.substitute(*value, &map);
            let (text, latex) = (
                self.g.symbol_text(*symbol).to_owned(),
                self.g.symbol_latex(*symbol).to_owned(),
            );
            let latex = if latex.starts_with("\\cos ") || latex.starts_with("\\sin ") {
                format!("{latex}^0")
            } else {
                format!("{{{latex}}}^0")
            };
            let twin = self
                .names
                .symbol_with_latex(&mut self.g, &format!("{text}⁰"), &latex);
            self.define(twin, value, "");
            let twin = self.g.of(twin);
            map.insert(*symbol, twin);
            twins.push(twin);
        }
        let assembled_closure = self.g.substitute(closure, &map);
        let (x0, y0, square0) = (twins[0], twins[1], twins[2]);
        self.closing_checks(closed, name, assembled_closure, square0, [la, lb]);
        self.branch(closed, branch, [x0, y0], [a, b], [aa, bb]);

        for (symbol, value, words) in steps {
            self.define(symbol, value, words);
            self.equation_line(lines, symbol, value, "");
        }
        for (i, body) in [u, v].into_iter().enumerate() {
            let [cos, sin] = directions[i];
            self.directions.push(Direction {
                angle: symbols[i],
                cos,
                sin,
            });
            let [cos0, sin0] = [cos, sin].map(|part| self.g.substitute(part, &map));
            let guess = self.link_angle(body).value;
            let angle = self.g.atan2(sin0, cos0);
            let angle = match guess {
                Some(guess) => self.g.function(Function::Unwrap, &[angle, guess]),
                None => angle,
            };
            let words = format!("angle of `{}` as assembled", self.model.bodies[body].name);
            self.define(assembled[i], angle, words);
            self.turning(
                body,
                symbols[i],
                assembled[i],
                shifts[i],
                [cos, sin],
                [cos0, sin0],
            );
        }
        self.loops.push(Loop {
            name: name.to_owned(),
            closure,
        });
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

    /// An angle counted from the assembled one, continuous over many turns.
    fn turning(
        &mut self,
        body: BodyId,
        symbol: Symbol,
        assembled: Symbol,
        shift: Symbol,
        [cos, sin]: [Expr; 2],
        [cos0, sin0]: [Expr; 2],
    ) {
        let name = self.model.bodies[body].name.clone();
        let reference = self.names.symbol(&mut self.g, &format!("turn_{name}"));
        let products =
            [(cos0, sin), (sin0, cos), (cos0, cos), (sin0, sin)].map(|(p, q)| self.g.mul(p, q));
        let cross = self.g.sub(products[0], products[1]);
        let dot = self.g.add(products[2], products[3]);
        let turned = self.g.atan2(cross, dot);
        self.g.mark_varying(reference);
        let reference_value = self.g.of(reference);
        let turned = self
            .g
            .function(Function::Unwrap, &[turned, reference_value]);
        self.define(
            shift,
            turned,
            format!("angle of `{name}` from the assembled one"),
        );
        let [start, shift] = [assembled, shift].map(|s| self.g.of(s));
        let angle = self.g.add(start, shift);
        self.define(symbol, angle, format!("angle of `{name}`"));
        let zero = self.g.zero();
        self.discretes.push(Discrete {
            name: format!("{name}.turn"),
            meaning: format!("angle of `{name}` from the assembled one at the last accepted step"),
            symbol: reference,
            initial: zero,
            accepted: Some(shift),
            turning: true,
        });
    }

    /// Rates of the two angles, and the rates of those.
    fn loop_rates(
        &mut self,
        closed: &ClosedLoop,
        triangle: &Triangle,
        names: &[String; 2],
        lines: &mut Vec<Line>,
    ) {
        let unit = |this: &mut Self, parts: &[Turned]| -> Vec<Turned> {
            match parts {
                [single] => vec![Turned {
                    magnitude: this.g.one(),
                    ..*single
                }],
                several => several.to_vec(),
            }
        };
        let along = [unit(self, &triangle.first), unit(self, &triangle.second)];
        // Cross products of the loop's derivative with either unknown vector eliminate it.
        let denominators = [
            self.cross(&along[1], &triangle.first),
            self.cross(&triangle.second, &along[0]),
        ];
        let bodies = [closed.unknowns.0, closed.unknowns.1];
        let mut made: Vec<(usize, Symbol, Expr)> = Vec::new();
        for index in 0..self.coordinates.len() {
            let numerators = [0, 1].map(|i| {
                let mut terms = Vec::new();
                for part in &triangle.known {
                    let Some(link) = part.link else { continue };
                    let rate = self.variable(link).rates[index];
                    if self.g.is_zero(rate) {
                        continue;
                    }
                    let cross = if i == 0 {
                        self.cross(&[*part], &along[1])
                    } else {
                        self.cross(&along[0], &[*part])
                    };
                    terms.push(self.g.mul(rate, cross));
                }
                self.g.sum(&terms)
            });
            for i in [0, 1] {
                if self.g.is_zero(numerators[i]) {
                    continue;
                }
                let value = self.g.div(numerators[i], denominators[i]);
                let symbol = self.rate_symbol(&names[i], index);
                let words = format!(
                    "rate of the angle of `{}` per unit rate of `{}`",
                    self.model.bodies[bodies[i]].name,
                    self.model.bodies[self.coordinates[index].body].name
                );
                self.define(symbol, value, words);
                self.equation_line(lines, symbol, value, "");
                let rate = self.g.of(symbol);
                if let Some(variable) = &mut self.variables[bodies[i]] {
                    variable.rates[index] = rate;
                }
                made.push((i, symbol, numerators[i]));
            }
            for body in bodies {
                self.attach_rate(body, index);
            }
        }
        // Second rates: from the derivative of denominator·ω = numerator.
        for &(i, symbol, numerator) in &made {
            for other in 0..self.coordinates.len() {
                let rates = std::mem::take(&mut self.rates[other]);
                let parts = self.g.derivatives(&[numerator, denominators[i]], &rates);
                self.rates[other] = rates;
                let rate = self.g.of(symbol);
                let shrink = self.g.mul(rate, parts[1]);
                let value = self.g.sub(parts[0], shrink);
                if self.g.is_zero(value) {
                    continue;
                }
                let value = self.g.div(value, denominators[i]);
                let second = self.second_rate_symbol(symbol, other);
                self.define(second, value, "");
                self.equation_line(lines, second, value, "");
                let second = self.g.of(second);
                self.rates[other].insert(symbol, second);
                let state = self.coordinates[other].symbol;
                self.partials.push(Partial {
                    symbol,
                    state,
                    value: second,
                });
            }
        }
    }

    /// Tells the derivatives by coordinate `index` of all that belongs to a link's angle.
    fn attach_rate(&mut self, body: BodyId, index: usize) {
        let variable = self.variable(body).clone();
        let rate = variable.rates[index];
        if self.g.is_zero(rate) {
            return;
        }
        let state = self.coordinates[index].symbol;
        let direction = self
            .directions
            .iter()
            .find(|d| d.angle == variable.symbol)
            .copied();
        let mut facts: Vec<(Expr, Expr)> = vec![(variable.value, rate), (variable.shift, rate)];
        if let Some(Direction { cos, sin, .. }) = direction {
            let turned = self.g.mul(sin, rate);
            facts.push((cos, self.g.neg(turned)));
            facts.push((sin, self.g.mul(cos, rate)));
        }
        for (what, value) in facts {
            if let Some(symbol) = self.g.as_symbol(what) {
                self.rates[index].insert(symbol, value);
                self.partials.push(Partial {
                    symbol,
                    state,
                    value,
                });
            }
        }
    }

    /// ω2, or ω2_crank where the angle depends on several coordinates.
    fn rate_symbol(&mut self, angle: &str, index: usize) -> Symbol {
        let sub = subscript(angle);
        let separator = if angle.chars().nth(1) == Some('_') {
            "_"
        } else {
            ""
        };
        let name = if self.coordinates.len() - self.free_coordinates() > 1 {
            let body = self.coordinates[index].body;
            format!("ω{separator}{sub}_{}", self.model.bodies[body].name)
        } else {
            format!("ω{separator}{sub}")
        };
        self.names.symbol(&mut self.g, &name)
    }

    /// Number of coordinates that take part in no loop.
    fn free_coordinates(&self) -> usize {
        let in_loop = |body: BodyId| self.structure.loops.iter().any(|l| l.links.contains(&body));
        self.coordinates.iter().filter(|c| !in_loop(c.body)).count()
    }

    fn second_rate_symbol(&mut self, rate: Symbol, index: usize) -> Symbol {
        let (text, latex) = (
            self.g.symbol_text(rate).to_owned(),
            self.g.symbol_latex(rate).to_owned(),
        );
        let (text, latex) = if self.coordinates.len() - self.free_coordinates() > 1 {
            let q = self.coordinates[index].symbol;
            (
                format!("∂{text}/∂{}", self.g.symbol_text(q)),
                format!(
                    "\\frac{{\\partial {latex}}}{{\\partial {}}}",
                    self.g.symbol_latex(q)
                ),
            )
        } else {
            match latex.find('_') {
                Some(at) => (
                    format!("{text}'"),
                    format!("{}'{}", &latex[..at], &latex[at..]),
                ),
                None => (format!("{text}'"), format!("{latex}'")),
            }
        };
        self.names.symbol_with_latex(&mut self.g, &text, &latex)
    }

    /// |a||b| sin of the angle from a to b.
    fn cross(&mut self, a: &[Turned], b: &[Turned]) -> Expr {
        let mut ahead = a.to_vec();
        ahead
            .iter_mut()
            .for_each(|part| part.quarter = (part.quarter + 1) % 4);
        self.dot(b, &ahead)
    }

    /// Which of the two ways a loop can close is nearest to the guessed angles.
    fn branch(
        &mut self,
        closed: &ClosedLoop,
        branch: Symbol,
        [x, y]: [Expr; 2],
        frames: [[Expr; 2]; 2],
        squares: [Expr; 2],
    ) {
        let mut terms = Vec::new();
        for (i, body) in [closed.unknowns.0, closed.unknowns.1]
            .into_iter()
            .enumerate()
        {
            let Some(guess) = self.link_angle(body).value else {
                continue;
            };
            let [fx, fy] = frames[i];
            let (cos, sin) = (self.g.cos(guess), self.g.sin(guess));
            let products =
                [(cos, fx), (sin, fy), (sin, fx), (cos, fy)].map(|(p, q)| self.g.mul(p, q));
            let vector = [
                self.g.sub(products[0], products[1]),
                self.g.add(products[2], products[3]),
            ];
            let [left, right] = [(x, vector[1]), (y, vector[0])].map(|(p, q)| self.g.mul(p, q));
            let cross = self.g.sub(left, right);
            let cross = self.g.div(cross, squares[i]);
            terms.push(if i == 0 { cross } else { self.g.neg(cross) });
        }
        if terms.is_empty() {
            let span = self.model.bodies[closed.unknowns.0].span;
            let name = self.model.bodies[closed.unknowns.0].name.clone();
            let site = self.model.source.site(span);
            self.errors.push(
                flexure_runtime::diagnostic::Diagnostic::error(format!(
                    "`{name}` needs an angle: the loop can close in two ways"
                ))
                .at(site)
                .hint("add `angle = …` as you see it in the drawing; it need not be exact"),
            );
        }
        let side = self.g.sum(&terms);
        let (plus, minus) = (self.g.one(), self.g.integer(-1));
        let sign = self.g.function(Function::IfPositive, &[side, plus, minus]);
        self.define(branch, sign, "which way the loop closes: as drawn");
    }

    /// A loop that cannot close says by how much, and what would.
    fn closing_checks(
        &mut self,
        closed: &ClosedLoop,
        name: &str,
        closure: Expr,
        square: Expr,
        [la, lb]: [Expr; 2],
    ) {
        let span = self.model.bodies[closed.unknowns.0].span;
        let distance = self.g.sqrt(square);
        let reach = self.g.add(la, lb);
        let difference = self.g.sub(la, lb);
        let inner = self.g.function(Function::Abs, &[difference]);
        let gaps = [self.g.sub(distance, reach), self.g.sub(inner, distance)];
        let gap = self.g.function(Function::Max, &gaps);
        let least = self.g.sub(distance, lb);
        let least = self.g.function(Function::Abs, &[least]);
        let most = self.g.add(distance, lb);
        let metre = |value| Shown {
            value,
            unit: ShownUnit::Metre,
        };
        let first = self.model.bodies[closed.unknowns.0].name.clone();
        let mut values = vec![metre(gap), metre(least), metre(most)];
        let coordinate = closed
            .links
            .iter()
            .find(|link| self.variable(**link).coordinate.is_some())
            .copied();
        let at = match coordinate {
            Some(link) => {
                let value = self.variable(link).assembled;
                values.push(Shown {
                    value,
                    unit: ShownUnit::Degree,
                });
                format!(" at `{}` angle {{3}}", self.model.bodies[link].name)
            }
            None => String::new(),
        };
        let failure = self.failure(
            format!("the loop {name} cannot close:{at} the gap is {{0}}"),
            format!("`{first}` would need to be {{1}} to {{2}} long between its joints, or another link another length or angle"),
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

    /// Angles that were asked for exactly on links that are no coordinates: solved for coordinates
    /// that hold only a guess, in order; if none is left they must come out by themselves.
    fn exact_angles(&mut self) {
        let mut free: Vec<usize> = (0..self.coordinates.len())
            .filter(|&i| {
                let body = self.coordinates[i].body;
                matches!(self.model.bodies[body].kind, BodyKind::Link(_))
                    && !self.link_angle(body).exact
            })
            .collect();
        let dependents: Vec<BodyId> = self
            .structure
            .loops
            .iter()
            .flat_map(|l| [l.unknowns.0, l.unknowns.1])
            .collect();
        let (mut unknowns, mut guesses, mut residuals, mut last) =
            (Vec::new(), Vec::new(), Vec::new(), None);
        let mut remaining = Vec::new();
        for body in dependents {
            let guess = self.link_angle(body);
            let (true, Some(target)) = (guess.exact, guess.value) else {
                continue;
            };
            let variable = self.variable(body).clone();
            let residual = self.g.sub(variable.assembled, target);
            let residual = self.g.sin(residual);
            let moves = |i: &usize| !self.g.is_zero(variable.rates[*i]);
            match free.iter().position(moves) {
                Some(at) => {
                    let index = free.remove(at);
                    let coordinate = self.coordinates[index].body;
                    let assembled = self.variable(coordinate).assembled;
                    if let Some(symbol) = self.g.as_symbol(assembled) {
                        unknowns.push(symbol);
                        guesses.push(self.link_angle(coordinate).value.unwrap_or(target));
                        residuals.push(residual);
                        last = Some((guess, body));
                    }
                }
                None => remaining.push((residual, guess, body, variable.assembled, target)),
            }
        }
        if let Some((guess, body)) = last {
            // The unknowns take the place of the guesses that stood for them.
            self.definitions.retain(|definition| match definition {
                Definition::Value { symbol, .. } => !unknowns.contains(symbol),
                Definition::Solve(_) => true,
            });
            let residuals: Vec<Expr> = residuals
                .into_iter()
                .map(|residual| self.expand(residual, &unknowns))
                .collect();
            let one = self.g.one();
            let failure = self.failure(
                format!(
                    "`{}` cannot have exactly the angle that is asked for",
                    self.model.bodies[body].name
                ),
                "the loop does not reach it near the drawn configuration: remove `exact`, or change a length",
                guess.span,
                Vec::new(),
            );
            let scales = vec![one; unknowns.len()];
            self.definitions.push(Definition::Solve(Solve {
                name: "the assembled configuration".to_owned(),
                unknowns,
                guesses,
                definitions: Vec::new(),
                residuals,
                scales,
                failure,
            }));
        }
        for (residual, guess, body, assembled, target) in remaining {
            let tolerance = self.g.ratio(1, 1_000_000_000);
            let off = self.g.function(Function::Abs, &[residual]);
            let margin = self.g.sub(tolerance, off);
            let degree = |value| Shown {
                value,
                unit: ShownUnit::Degree,
            };
            let failure = self.failure(
                format!(
                    "`{}` cannot have the exact angle {{0}}: with what else is exact the loop closes at {{1}}",
                    self.model.bodies[body].name
                ),
                "more angles are exact than the mechanism has degrees of freedom: remove `exact` from one of them",
                guess.span,
                vec![degree(target), degree(assembled)],
            );
            self.check(margin, true, failure);
        }
    }

    /// `expr` with everything that depends on `unknowns` written out in terms of them.
    pub(super) fn expand(&mut self, expr: Expr, unknowns: &[Symbol]) -> Expr {
        let mut map: HashMap<Symbol, Expr> = HashMap::new();
        for symbol in unknowns {
            map.insert(*symbol, self.g.of(*symbol));
        }
        self.expand_with(expr, &mut map)
    }

    /// `expr` with symbols replaced as `map` says, also inside the definitions of the symbols that
    /// it uses; definitions that lead to nothing replaced stay symbols.
    pub(super) fn expand_with(&mut self, expr: Expr, map: &mut HashMap<Symbol, Expr>) -> Expr {
        let defined: HashMap<Symbol, Expr> = self
            .definitions
            .iter()
            .filter_map(|definition| match definition {
                Definition::Value { symbol, value, .. } => Some((*symbol, *value)),
                Definition::Solve(_) => None,
            })
            .collect();
        // A symbol may be mapped to itself, so what leads to one is known by its symbols alone.
        let mut touched: HashSet<Symbol> = map.keys().copied().collect();
        let mut stack: Vec<(Symbol, bool)> = self
            .g
            .symbols_in(&[expr])
            .into_iter()
            .rev()
            .map(|s| (s, false))
            .collect();
        while let Some((symbol, ready)) = stack.pop() {
            if map.contains_key(&symbol) {
                continue;
            }
            let Some(&value) = defined.get(&symbol) else {
                continue;
            };
            if ready {
                let inner = self.g.symbols_in(&[value]);
                let result = if inner.iter().any(|s| touched.contains(s)) {
                    touched.insert(symbol);
                    self.g.substitute(value, map)
                } else {
                    self.g.of(symbol)
                };
                map.insert(symbol, result);
            } else {
                stack.push((symbol, true));
                let inner = self.g.symbols_in(&[value]);
                stack.extend(inner.into_iter().map(|s| (s, false)));
            }
        }
        self.g.substitute(expr, map)
    }

    /// Running values to assembled ones, for all variables known so far.
    pub(super) fn assembled_map(&self) -> HashMap<Symbol, Expr> {
        self.variables
            .iter()
            .flatten()
            .map(|v| (v.symbol, v.assembled))
            .collect()
    }

    fn link_angle(&self, body: BodyId) -> Guess {
        match &self.model.bodies[body].kind {
            BodyKind::Link(link) => link.angle,
            BodyKind::Slide(slide) => slide.at,
            BodyKind::Ground => Guess {
                value: None,
                exact: true,
                span: self.model.bodies[body].span,
            },
        }
    }

    /// `φ2 = atan2(s2, c2), φ3 = atan2(s3, c3)`, where no jump by a turn is meant.
    fn angles_line(&self, symbols: [Symbol; 2]) -> Line {
        let (mut text, mut latex) = (Vec::new(), Vec::new());
        for direction in self
            .directions
            .iter()
            .filter(|d| symbols.contains(&d.angle))
        {
            let angle = direction.angle;
            let [sin, cos] = [direction.sin, direction.cos];
            text.push(format!(
                "{} = atan2({}, {})",
                self.g.symbol_text(angle),
                self.g.text(sin),
                self.g.text(cos)
            ));
            latex.push(format!(
                "{} = \\operatorname{{atan2}}({}, {})",
                self.g.symbol_latex(angle),
                self.g.latex(sin),
                self.g.latex(cos)
            ));
        }
        Line::Written {
            text: format!("{}, continuous over many turns", text.join(", ")),
            latex: format!(
                "{} \\quad\\text{{(continuous over many turns)}}",
                latex.join(",\\quad ")
            ),
        }
    }

    /// `l1 e^{iφ1} + l2 e^{iφ2} - l3 e^{iφ3} - l4 = 0`.
    fn loop_line(&mut self, triangle: &Triangle) -> Line {
        let parts: Vec<Turned> = triangle
            .known
            .iter()
            .chain(&triangle.first)
            .chain(&triangle.second)
            .copied()
            .collect();
        let mut parts = parts;
        // Vectors of ground come last, the others in the order in which they were met.
        parts.sort_by_key(|part| part.link.is_none());
        let (mut text, mut latex) = (String::new(), String::new());
        for part in parts {
            let negative = self.g.is_written_negative(part.magnitude);
            let magnitude = if negative {
                self.g.neg(part.magnitude)
            } else {
                part.magnitude
            };
            let sign = match (negative, text.is_empty()) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            };
            let angle = self.angle(&part);
            let (angle_text, angle_latex) = match angle {
                Some(angle) => (self.g.text(angle), self.g.latex(angle)),
                None => (String::new(), String::new()),
            };
            let (i_text, i_latex) = match part.quarter {
                0 => ("", ""),
                1 => ("i ", "i\\,"),
                2 => ("(-1) ", "(-1)\\,"),
                _ => ("(-i) ", "(-i)\\,"),
            };
            let exponential = if angle.is_some() {
                let plain = if angle_text.contains(' ') {
                    format!("({angle_text})")
                } else {
                    angle_text
                };
                (
                    format!(" e^(i {plain})"),
                    format!("\\, e^{{i {angle_latex}}}"),
                )
            } else {
                (String::new(), String::new())
            };
            let written = self.factor_text(magnitude);
            text.push_str(&format!("{sign}{i_text}{}{}", written.0, exponential.0));
            latex.push_str(&format!("{sign}{i_latex}{}{}", written.1, exponential.1));
        }
        Line::Written {
            text: format!("{text} = 0"),
            latex: format!("{latex} = 0"),
        }
    }

    fn factor_text(&self, expr: Expr) -> (String, String) {
        let (text, latex) = (self.g.text(expr), self.g.latex(expr));
        let sum = matches!(self.g.node(expr), crate::symbolic::Node::Sum { .. });
        if sum {
            (format!("({text})"), format!("\\left({latex}\\right)"))
        } else {
            (text, latex)
        }
    }

    /// `symbol = value` as a line of the report.
    pub(super) fn equation_line(
        &self,
        lines: &mut Vec<Line>,
        symbol: Symbol,
        right: Expr,
        note: &str,
    ) {
        lines.push(Line::Equation {
            text: self.g.symbol_text(symbol).to_owned(),
            latex: self.g.symbol_latex(symbol).to_owned(),
            right,
            note: note.to_owned(),
        });
    }
}

fn one() -> crate::symbolic::Rational {
    num_traits::One::one()
}
