//! Rates of a loop's two unknowns by each coordinate, and the rates of those.
//!
//! The loop's derivative is linear in the rates: (what others move) + u̇ U + v̇ V = 0. The cross
//! product with V eliminates v̇, that with U eliminates u̇. The second rates follow from the
//! derivative of `denominator · rate = numerator`, never from the closed form of the values.

use crate::equations::{Line, Partial};
use crate::model::BodyId;
use crate::structure::turning_link;
use crate::symbolic::{Expr, Symbol};

use super::super::Derivation;
use super::super::names::subscript;
use super::super::turned::Turned;

impl Derivation<'_> {
    /// Defines the rates of both unknowns.
    pub(super) fn loop_rates(
        &mut self,
        sum: &[Turned],
        bodies: [BodyId; 2],
        lines: &mut Vec<Line>,
    ) {
        let own = bodies.map(|body| self.moved_by(sum, body));
        let others = self.moved_by_others(sum, &bodies);
        // A vector that stands alone eliminates as well without its length.
        let along = own.clone().map(|parts| match parts[..] {
            [single] => vec![Turned {
                magnitude: self.g.one(),
                slide: None,
                ..single
            }],
            _ => parts,
        });
        let denominators = [
            self.cross(&along[1], &own[0]),
            self.cross(&own[1], &along[0]),
        ];
        let mut made: Vec<(usize, Symbol, Expr)> = Vec::new();
        let mut meant: Vec<(BodyId, usize, Symbol)> = Vec::new();
        let heading = lines.len();
        for index in 0..self.coordinates.len() {
            let numerators = [0, 1].map(|i| {
                let mut terms = Vec::new();
                for part in &others {
                    let rate = self.variable(part.variable).rates[index];
                    if self.g.is_zero(rate) {
                        continue;
                    }
                    let cross = if i == 0 {
                        self.cross(&[part.vector], &along[1])
                    } else {
                        self.cross(&along[0], &[part.vector])
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
                let symbol = self.dependent_rate(bodies[i], index, value, lines);
                made.push((i, symbol, numerators[i]));
                meant.push((bodies[i], index, symbol));
            }
            for body in bodies {
                self.attach_rate(body, index);
            }
        }
        for &(i, symbol, numerator) in &made {
            for other in 0..self.coordinates.len() {
                let parts = self.along(&[numerator, denominators[i]], other);
                let rate = self.g.of(symbol);
                let shrink = self.g.mul(rate, parts[1]);
                let value = self.g.sub(parts[0], shrink);
                let value = self.g.div(value, denominators[i]);
                self.second_rate(symbol, other, value, lines);
            }
        }
        if !meant.is_empty() {
            lines.insert(heading, self.rates_line(&meant));
        }
    }

    /// `ω2 = dφ2/dφ1, ω3 = dφ3/dφ1`: what the rates mean.
    fn rates_line(&self, rates: &[(BodyId, usize, Symbol)]) -> Line {
        let (sign, sign_latex) = if self.several_lead {
            ("∂", "\\partial ")
        } else {
            ("d", "\\mathrm d")
        };
        let (mut text, mut latex) = (Vec::new(), Vec::new());
        for &(body, index, rate) in rates {
            let (of, by) = (self.variable(body).symbol, self.coordinates[index].symbol);
            text.push(format!(
                "{} = {sign}{}/{sign}{}",
                self.g.symbol_text(rate),
                self.g.symbol_text(of),
                self.g.symbol_text(by)
            ));
            latex.push(format!(
                "{} = \\frac{{{sign_latex}{}}}{{{sign_latex}{}}}",
                self.g.symbol_latex(rate),
                self.g.symbol_latex(of),
                self.g.symbol_latex(by)
            ));
        }
        if !self.several_lead
            && let Some(&(_, index, _)) = rates.first()
        {
            let by = self.coordinates[index].symbol;
            text.push(format!("' = d/d{}", self.g.symbol_text(by)));
            latex.push(format!(
                "{{}}' = \\frac{{\\mathrm d}}{{\\mathrm d{}}}",
                self.g.symbol_latex(by)
            ));
        }
        Line::Written {
            text: text.join(", "),
            latex: latex.join(",\\quad "),
        }
    }

    /// Names the rate of a variable by a coordinate.
    pub(super) fn dependent_rate(
        &mut self,
        body: BodyId,
        index: usize,
        value: Expr,
        lines: &mut Vec<Line>,
    ) -> Symbol {
        let name = self.variable_name(body);
        let symbol = self.rate_symbol(&name, index);
        let is_link = turning_link(self.model, body) == Some(body);
        let words = format!(
            "rate of the {} of `{}` per unit rate of `{}`",
            if is_link { "angle" } else { "position" },
            self.model.bodies[body].name,
            self.model.bodies[self.coordinates[index].body].name
        );
        self.define(symbol, value, words);
        self.equation_line(lines, symbol, value, "");
        let rate = self.g.of(symbol);
        if let Some(variable) = &mut self.variables[body] {
            variable.rates[index] = rate;
        }
        symbol
    }

    /// Names the derivative of a rate along a coordinate.
    pub(super) fn second_rate(
        &mut self,
        rate: Symbol,
        index: usize,
        value: Expr,
        lines: &mut Vec<Line>,
    ) {
        if self.g.is_zero(value) {
            return;
        }
        let second = self.second_rate_symbol(rate, index);
        self.define(second, value, "");
        self.equation_line(lines, second, value, "");
        let second = self.g.of(second);
        self.rates[index].insert(rate, second);
        let state = self.coordinates[index].symbol;
        self.partials.push(Partial {
            symbol: rate,
            state,
            value: second,
        });
    }

    /// ω2 for φ2, ω_ψ for ψ, or ω2_1 where loops follow several coordinates; for slides ν.
    fn rate_symbol(&mut self, variable: &str, index: usize) -> Symbol {
        let letter = if variable.starts_with('x') {
            "ν"
        } else {
            "ω"
        };
        let bare = subscript(variable).is_empty() || !variable.starts_with(['φ', 'x']);
        let sub = if bare { variable } else { subscript(variable) };
        let separator = if bare || variable.chars().nth(1) == Some('_') {
            "_"
        } else {
            ""
        };
        let name = if self.several_lead {
            format!("{letter}{separator}{sub}_{}", self.coordinate_label(index))
        } else {
            format!("{letter}{separator}{sub}")
        };
        self.names.symbol(&mut self.g, &name)
    }

    fn second_rate_symbol(&mut self, rate: Symbol, index: usize) -> Symbol {
        let (text, latex) = (
            self.g.symbol_text(rate).to_owned(),
            self.g.symbol_latex(rate).to_owned(),
        );
        let (text, latex) = if self.several_lead {
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
}
