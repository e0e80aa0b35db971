//! The variables of the mechanism: symbols for coordinates and for what loops determine.

use crate::equations::Partial;
use crate::model::{BodyId, BodyKind, Guess, Link, Slide};
use crate::symbolic::{Expr, Symbol};

use super::super::names::{accented, accented_latex};
use super::super::{Coordinate, Derivation, Variable};

/// What kind of quantity a variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The angle of a link.
    Angle,
    /// The position of a slide.
    Position,
}

/// A variable that a loop determines, with its symbols.
#[derive(Clone, Debug)]
pub(super) struct Dependent {
    pub body: BodyId,
    pub kind: Kind,
    pub name: String,
    pub symbol: Symbol,
    pub assembled: Symbol,
    pub shift: Symbol,
}

impl Derivation<'_> {
    /// Makes the symbols of the independent coordinates.
    pub(in super::super) fn name_coordinates(&mut self) {
        for (index, &body) in self.structure.coordinates.clone().iter().enumerate() {
            let name = self.variable_name(body);
            let symbol = self.names.symbol(&mut self.g, &name);
            let value = self.g.of(symbol);
            let assembled = match &self.model.bodies[body].kind {
                BodyKind::Link(link) => {
                    let assembled = self.assembled_symbol(&name);
                    let start = link.angle.value.unwrap_or_else(|| self.g.zero());
                    let words = format!("angle of `{}` as assembled", self.model.bodies[body].name);
                    self.define(assembled, start, words);
                    self.g.of(assembled)
                }
                BodyKind::Slide(slide) => slide.at.value.unwrap_or_else(|| self.g.zero()),
                BodyKind::Ground => continue,
            };
            let [rate, acceleration] =
                [('\u{307}', "dot"), ('\u{308}', "ddot")].map(|(mark, accent)| {
                    self.names.symbol_with_latex(
                        &mut self.g,
                        &accented(&name, mark),
                        &accented_latex(&name, accent),
                    )
                });
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

    /// Makes the symbols of a variable that a loop determines.
    pub(super) fn dependent(&mut self, body: BodyId) -> Dependent {
        let name = self.variable_name(body);
        let kind = match &self.model.bodies[body].kind {
            BodyKind::Slide(_) => Kind::Position,
            BodyKind::Link(_) | BodyKind::Ground => Kind::Angle,
        };
        let symbol = self.names.symbol(&mut self.g, &name);
        let assembled = self.assembled_symbol(&name);
        let text = format!(
            "{} - {}",
            self.g.symbol_text(symbol),
            self.g.symbol_text(assembled)
        );
        let latex = format!(
            "{} - {}",
            self.g.symbol_latex(symbol),
            self.g.symbol_latex(assembled)
        );
        let shift = self.g.symbol_written_as_sum(text, latex);
        for varying in [symbol, shift] {
            self.g.mark_varying(varying);
        }
        let zero = self.g.zero();
        self.variables[body] = Some(Variable {
            symbol,
            value: self.g.of(symbol),
            assembled: self.g.of(assembled),
            shift: self.g.of(shift),
            rates: vec![zero; self.coordinates.len()],
            coordinate: None,
        });
        Dependent {
            body,
            kind,
            name,
            symbol,
            assembled,
            shift,
        }
    }

    /// `φ1` as the user wants it, else `φ_crank`; `x_stage`.
    pub(super) fn variable_name(&self, body: BodyId) -> String {
        let name = &self.model.bodies[body].name;
        match &self.model.bodies[body].kind {
            BodyKind::Link(Link {
                symbol: Some(symbol),
                ..
            }) => symbol.clone(),
            BodyKind::Link(_) => format!("φ_{name}"),
            BodyKind::Slide(Slide {
                traces: Some((point, axis)),
                ..
            }) => format!("{}_{}", ["x", "y"][*axis], self.model.points[*point].name),
            BodyKind::Slide(_) | BodyKind::Ground => format!("x_{name}"),
        }
    }

    pub(super) fn assembled_symbol(&mut self, name: &str) -> Symbol {
        let latex = format!("{}^0", crate::notation::latex_of(name));
        self.names
            .symbol_with_latex(&mut self.g, &format!("{name}⁰"), &latex)
    }

    /// What the user said of a variable as assembled: a link's angle, a slide's position.
    pub(in super::super) fn guess(&self, body: BodyId) -> Guess {
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

    /// Tells how symbols of a dependent variable change with coordinate `index`.
    pub(super) fn attach_rate(&mut self, body: BodyId, index: usize) {
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
        if let Some(direction) = direction {
            let turned = self.g.mul(direction.sin, rate);
            facts.push((direction.cos, self.g.neg(turned)));
            facts.push((direction.sin, self.g.mul(direction.cos, rate)));
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
}
