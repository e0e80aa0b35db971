//! How products and powers are written.

use num_integer::Integer;
use num_traits::{One, Signed};

use super::number::{self, Written as WrittenNumber};
use super::{Level, Printer, Style, Written, join};
use crate::symbolic::{Expr, Function, Node, Rational};

/// Place of a factor in a product.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    Number,
    Symbol,
    Power,
    Varying,
    VaryingPower,
    Magnitude,
    Sum,
    Function,
}

impl Printer<'_> {
    /// A product without its sign, and the sign.
    pub(super) fn product(
        &mut self,
        coefficient: &Rational,
        factors: &[(Expr, Rational)],
    ) -> (bool, Written) {
        let magnitude = coefficient.abs();
        let (negative, turned) = self.signs(coefficient.is_negative(), factors);
        if let [(factor, exponent)] = factors
            && magnitude.is_one()
            && exponent.is_one()
        {
            return (negative, self.factor(*factor, exponent, &turned));
        }
        if let Some(written) = self.power_of_quotient(&magnitude, factors) {
            return (coefficient.is_negative(), written);
        }

        let (mut above, mut below): (Vec<_>, Vec<_>) = factors
            .iter()
            .map(|(factor, exponent)| (*factor, exponent.clone()))
            .partition(|(_, exponent)| exponent.is_positive());
        for (_, exponent) in &mut below {
            *exponent = -exponent.clone();
        }
        above.sort_by_key(|(factor, exponent)| self.class(*factor, exponent));
        below.sort_by_key(|(factor, exponent)| self.class(*factor, exponent));

        // A fraction joins the fraction bar that is there; any other number stands in front.
        let split = !below.is_empty() && number::is_fraction(&magnitude);
        let (front, divisor) = if split {
            (
                Rational::from_integer(magnitude.numer().clone()),
                Rational::from_integer(magnitude.denom().clone()),
            )
        } else {
            (magnitude, Rational::one())
        };
        let top = self.side(&front, &above, &turned, below.is_empty());
        if below.is_empty() {
            return (negative, self.side_by_side(&top));
        }
        let bottom = self.side(&divisor, &below, &turned, false);
        (negative, self.quotient(top, bottom))
    }

    /// The factors of one side of a fraction bar, each as it is written in a product.
    fn side(
        &mut self,
        number: &Rational,
        factors: &[(Expr, Rational)],
        turned: &[Expr],
        is_alone: bool,
    ) -> Vec<(Class, Written)> {
        let mut side = Vec::new();
        if !number.is_one() || factors.is_empty() {
            let written = number::write(number, self.style).written;
            self.count(&written.text);
            let WrittenNumber { text, level } = written;
            // `5/16 x` reads well in front, but not over or under another bar.
            let text = if level == Level::Product && !is_alone && !self.is_latex() {
                self.parentheses(&text)
            } else {
                text
            };
            side.push((Class::Number, Written::new(text, Level::Atom)));
        }
        for (factor, exponent) in factors {
            if self.left == 0 {
                side.push((Class::Function, self.ellipsis()));
                break;
            }
            let written = self.factor(*factor, exponent, turned);
            side.push((self.class(*factor, exponent), written));
        }
        side
    }

    fn class(&self, factor: Expr, exponent: &Rational) -> Class {
        match self.graph.node(factor) {
            Node::Number(_) | Node::Pi => Class::Number,
            Node::Symbol(symbol) if self.graph.symbol_is_sum(*symbol) => Class::Sum,
            Node::Symbol(symbol) => match (self.graph.symbol_varies(*symbol), exponent.is_one()) {
                (false, true) => Class::Symbol,
                (false, false) => Class::Power,
                (true, true) => Class::Varying,
                (true, false) => Class::VaryingPower,
            },
            Node::Sum { .. } | Node::Product { .. } => Class::Sum,
            Node::Function(Function::Abs, _) => Class::Magnitude,
            Node::Function(Function::CosDifference | Function::SinDifference, _) => Class::Sum,
            Node::Function(..) => Class::Function,
        }
    }

    /// Factors side by side.
    fn side_by_side(&self, factors: &[(Class, Written)]) -> Written {
        if let [(_, only)] = factors {
            return only.clone();
        }
        let mut text = String::new();
        for (_, factor) in factors {
            let factor = self.at_least(Level::Power, factor.clone());
            if !text.is_empty() {
                let is_number = factor.starts_with(|c: char| c.is_ascii_digit());
                text.push_str(match (self.style, is_number) {
                    (Style::Text, false) => " ",
                    (Style::Text, true) => "·",
                    (Style::Latex, true) => r" \cdot ",
                    (Style::Latex, false) if spaces_itself(&factor) => " ",
                    (Style::Latex, false) => r" \, ",
                });
            }
            text.push_str(&factor);
        }
        Written::new(text, Level::Product)
    }

    fn quotient(&self, mut top: Vec<(Class, Written)>, bottom: Vec<(Class, Written)>) -> Written {
        if self.is_latex() {
            // Sums stand behind the fraction of what is simple: `F_N/F_p (…)`.
            let is_sum = |(class, _): &(Class, Written)| *class == Class::Sum;
            let mut behind = Vec::new();
            if top.len() > 1 && !top.iter().all(is_sum) && !bottom.iter().any(is_sum) {
                behind = top
                    .iter()
                    .filter(|factor| is_sum(factor))
                    .cloned()
                    .collect();
                top.retain(|factor| !is_sum(factor));
            }
            let (over, under) = (self.side_by_side(&top), self.side_by_side(&bottom));
            let fraction = format!(r"\frac{{{}}}{{{}}}", over.text, under.text);
            let fraction = Written::new(fraction, Level::Product);
            if behind.is_empty() {
                return fraction;
            }
            let fraction = Written::new(fraction.text, Level::Power);
            behind.insert(0, (Class::Number, fraction));
            return self.side_by_side(&behind);
        }
        let simple = top.len() == 1 && bottom.len() == 1;
        let over = self.at_least(Level::Product, self.side_by_side(&top));
        let under = self.at_least(Level::Power, self.side_by_side(&bottom));
        let simple = simple && !over.contains(' ') && !under.contains(' ');
        let bar = if simple { "/" } else { " / " };
        Written::new(format!("{over}{bar}{under}"), Level::Product)
    }

    /// `(v/v_S)²` for what is v² v_S⁻² inside.
    fn power_of_quotient(
        &mut self,
        magnitude: &Rational,
        factors: &[(Expr, Rational)],
    ) -> Option<Written> {
        let [(first, m), (second, n)] = factors else {
            return None;
        };
        let whole = m.is_integer() && !m.abs().is_one() && *m == -n.clone();
        if !magnitude.is_one() || !whole {
            return None;
        }
        let [over, under] = if m.is_positive() {
            [*first, *second]
        } else {
            [*second, *first]
        };
        let one = (Class::Symbol, Written::new("", Level::Atom));
        let [mut top, mut bottom] = [one.clone(), one];
        top.1 = self.expr(over);
        bottom.1 = self.expr(under);
        let quotient = self.quotient(vec![top], vec![bottom]);
        let base = self.parentheses(&quotient.text);
        Some(self.raised(&base, &m.abs()))
    }

    /// Whether a minus sign is left in front, and the factors that are written as the negative of
    /// what they are: sums of nothing but negative terms, and a function that takes in the sign.
    fn signs(&self, negative: bool, factors: &[(Expr, Rational)]) -> (bool, Vec<Expr>) {
        let mut negative = negative;
        let mut turned = Vec::new();
        if let [(_, exponent)] = factors
            && exponent.is_one()
            && !negative
        {
            return (negative, turned);
        }
        for (factor, exponent) in factors {
            if exponent.is_integer()
                && let Node::Sum { constant, terms } = self.graph.node(*factor)
                && !constant.is_positive()
                && terms.iter().all(|(_, k)| k.is_negative())
            {
                turned.push(*factor);
                negative ^= exponent.numer().is_odd();
            }
        }
        if !negative {
            return (negative, turned);
        }
        // The sign goes into a factor above the fraction bar if one can take it, else below.
        let taker = [Rational::one(), -Rational::one()]
            .iter()
            .find_map(|wanted| {
                let takes = |(factor, exponent): &&(Expr, Rational)| {
                    exponent == wanted && self.takes_sign(*factor)
                };
                factors.iter().find(takes).map(|(factor, _)| *factor)
            });
        // Else into a difference: -(a - b) c is (b - a) c.
        let taker = taker.or_else(|| {
            let difference = factors
                .iter()
                .rev()
                .find(|(factor, exponent)| exponent.is_one() && self.is_balanced(*factor));
            difference.map(|(factor, _)| *factor)
        });
        turned.extend(taker);
        (taker.is_none(), turned)
    }

    /// Whether the factor is a sum with as many terms subtracted as added.
    fn is_balanced(&self, factor: Expr) -> bool {
        let Node::Sum { constant, terms } = self.graph.node(factor) else {
            return false;
        };
        let numbers = || terms.iter().map(|(_, k)| k).chain([constant]);
        let added = numbers().filter(|number| number.is_positive()).count();
        added == numbers().filter(|number| number.is_negative()).count()
    }

    /// Whether a minus sign can go into the factor: `-sin(a - b)` is `sin(b - a)`.
    fn takes_sign(&self, factor: Expr) -> bool {
        use Function::*;
        match self.graph.node(factor) {
            Node::Function(CosDifference | SinDifference, _) => true,
            Node::Function(Sin | Tan, arguments) => match self.graph.node(arguments[0]) {
                Node::Sum { constant, terms } => {
                    let numbers = terms.iter().map(|(_, k)| k).chain([constant]);
                    let (mut more, mut less) = (0, 0);
                    for number in numbers {
                        more += usize::from(number.is_positive());
                        less += usize::from(number.is_negative());
                    }
                    less >= more
                }
                Node::Number(_)
                | Node::Pi
                | Node::Symbol(_)
                | Node::Product { .. }
                | Node::Function(..) => false,
            },
            Node::Number(_)
            | Node::Pi
            | Node::Symbol(_)
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Function(..) => false,
        }
    }

    /// A factor of a product; those that are `turned` are written as their negative.
    fn factor(&mut self, factor: Expr, exponent: &Rational, turned: &[Expr]) -> Written {
        if !turned.contains(&factor) {
            return self.power(factor, exponent);
        }
        if let Node::Function(function, arguments) = self.graph.node(factor) {
            return self.turned(*function, arguments);
        }
        let opposite = join(&self.opposite_terms(factor));
        if exponent.is_one() {
            return opposite;
        }
        let base = self.at_least(Level::Atom, opposite);
        self.raised(&base, exponent)
    }

    /// `base^exponent` for a positive exponent.
    fn power(&mut self, base: Expr, exponent: &Rational) -> Written {
        if exponent.is_one() {
            return self.expr(base);
        }
        if *exponent.denom() == 2.into() && exponent.numer().is_one() {
            let inner = self.expr(base).text;
            return if self.is_latex() {
                Written::new(format!(r"\sqrt{{{inner}}}"), Level::Power)
            } else {
                Written::new(format!("sqrt({inner})"), Level::Atom)
            };
        }
        if let Node::Function(function, arguments) = self.graph.node(base)
            && exponent.is_integer()
            && let Some(written) = self.function_power(*function, arguments, exponent)
        {
            return written;
        }
        let inner = self.expr(base);
        let inner = self.at_least(Level::Atom, inner);
        self.raised(&inner, exponent)
    }

    fn raised(&self, base: &str, exponent: &Rational) -> Written {
        Written::new(
            format!("{base}{}", number::exponent(exponent, self.style)),
            Level::Power,
        )
    }
}

/// Whether LaTeX sets space in front of it without being told.
fn spaces_itself(factor: &str) -> bool {
    let operators = [
        r"\left",
        r"\cos",
        r"\sin",
        r"\tan",
        r"\arc",
        r"\exp",
        r"\ln",
        r"\min",
        r"\max",
        r"\operatorname",
    ];
    operators
        .iter()
        .any(|operator| factor.starts_with(operator))
}
