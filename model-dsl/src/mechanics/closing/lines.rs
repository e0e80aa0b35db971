//! Loops as lines of the report.

use crate::equations::Line;
use crate::symbolic::{Expr, Node, Symbol};

use super::super::Derivation;
use super::super::turned::Turned;

impl Derivation<'_> {
    /// `φ2 = atan2(s2, c2), φ3 = atan2(s3, c3)`, where no jump by a turn is meant.
    pub(super) fn angles_line(&self, symbols: &[Symbol]) -> Line {
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
            text: format!(
                "{}, continuous over many turns; ⁰: as assembled",
                text.join(", ")
            ),
            latex: format!(
                "{} \\quad\\text{{(continuous over many turns; ${{}}^0$: as assembled)}}",
                latex.join(",\\quad ")
            ),
        }
    }

    /// `l1 e^{iφ1} + l2 e^{iφ2} - l3 e^{iφ3} - l4 = 0`.
    pub(super) fn loop_line(&mut self, sum: &[Turned]) -> Line {
        let mut parts = sum.to_vec();
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
            let magnitude = self.scale(&Turned { magnitude, ..part });
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
        let sum = matches!(self.g.node(expr), Node::Sum { .. });
        if sum {
            (format!("({text})"), format!("\\left({latex}\\right)"))
        } else {
            (text, latex)
        }
    }

    /// `symbol = value` as a line of the report.
    pub(in super::super) fn equation_line(
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
