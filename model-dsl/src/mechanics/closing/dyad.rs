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

use crate::model::BodyId;
use crate::structure::Way;
use crate::symbolic::{Expr, Function, Rational, Symbol};

use super::super::Derivation;
use super::super::turned::{Turned, wave};
use super::variables::{Dependent, Kind};

/// A quantity on the way to the unknowns: symbol, definition, words.
pub(super) type Step = (Symbol, Expr, String);

/// How a loop's unknowns follow.
pub(super) struct Solution {
    /// Cosine and sine of each unknown that is an angle.
    pub directions: [Option<[Expr; 2]>; 2],
    /// Positive where the loop closes.
    pub closure: Expr,
    /// Where the branch's sign is asked: positive on the drawn side, in running symbols.
    pub side: Option<Expr>,
    /// By how much the loop misses to close, and what is said about it.
    pub gap: Expr,
    /// Least and most length of the first unknown link that would close it.
    pub range: Option<[Expr; 2]>,
}

/// A loop on the way to its solution.
pub(super) struct Dyad<'s> {
    pub sum: &'s [Turned],
    pub unknowns: [Dependent; 2],
    pub index: String,
    pub steps: Vec<Step>,
    pub branch: Symbol,
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
        let branch = self.names.symbol(&mut self.g, &format!("ε{index}"));
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

    /// Makes a step's symbol, unless the step is a number or, but for its sign, a symbol.
    fn step(&mut self, dyad: &mut Dyad<'_>, name: &str, value: Expr, words: &str) -> Expr {
        let opposite = self.g.neg(value);
        let is_plain = |expr| self.g.as_symbol(expr).is_some() || self.g.as_number(expr).is_some();
        if is_plain(value) || is_plain(opposite) {
            return value;
        }
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
            let body = dyad.unknowns[i].body;
            if let Some(side) = self.cross_with_drawn([x, y], body, frame, square) {
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

    /// A vector in its link's own frame.
    fn in_frame(&mut self, parts: &[Turned]) -> [Expr; 2] {
        [0, 3].map(|axis| {
            let terms: Vec<Expr> = parts
                .iter()
                .map(|part| {
                    let turn = wave(&mut self.g, part.offset, part.quarter + axis);
                    let scale = self.scale(part);
                    self.g.mul(scale, turn)
                })
                .collect();
            self.g.sum(&terms)
        })
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
    pub(super) fn cross_of(&mut self, a: [Expr; 2], b: [Expr; 2]) -> Expr {
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

    /// `vector` × the drawn vector of a link, over the square of the latter's length.
    fn cross_with_drawn(
        &mut self,
        vector: [Expr; 2],
        body: BodyId,
        frame: [Expr; 2],
        square: Expr,
    ) -> Option<Expr> {
        let (frame, divisor) = if self.g.is_zero(frame[1]) {
            ([self.g.one(), frame[1]], frame[0])
        } else {
            (frame, square)
        };
        let drawn = self.drawn(body, frame)?;
        let cross = self.cross_of(vector, drawn);
        Some(self.g.div(cross, divisor))
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
