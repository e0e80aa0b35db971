//! Rows of operands and operators, sorted out by precedence.

use super::problem::Problem;
use super::reader::Parsed;
use super::tree::{Comparison, Expression, ExpressionKind};
use crate::source::Span;

/// A row of operands and operators, folded by precedence: `or`, `and`, comparisons, sums, products,
/// signs, powers.
#[derive(Default)]
pub(super) struct Row {
    operands: Vec<Option<Expression>>,
    /// Signs before each operand: whether they are odd in minus, and where they start.
    signs: Vec<Option<(bool, Span)>>,
    pub(super) operators: Vec<(String, Span)>,
    pending: Option<(bool, Span)>,
}

impl Row {
    pub(super) fn sign(&mut self, minus: bool, span: Span) {
        self.pending = Some(match self.pending {
            None => (minus, span),
            Some((odd, first)) => (odd ^ minus, first),
        });
    }

    pub(super) fn operator(&mut self, text: &str, span: Span) {
        self.operators.push((text.to_owned(), span));
    }

    pub(super) fn operand(&mut self, operand: Expression) {
        self.operands.push(Some(operand));
        self.signs.push(self.pending.take());
    }

    pub(super) fn fold(mut self) -> Parsed<Expression> {
        self.alternatives(0, self.operands.len())
    }

    /// Ranges of operands between operators that `splits` accepts, with the operator before each.
    fn pieces(
        &self,
        from: usize,
        to: usize,
        splits: fn(&str) -> bool,
    ) -> Vec<(Option<usize>, usize, usize)> {
        let mut pieces = Vec::new();
        let mut start = (None, from);
        for index in from..to.saturating_sub(1) {
            if splits(&self.operators[index].0) {
                pieces.push((start.0, start.1, index + 1));
                start = (Some(index), index + 1);
            }
        }
        pieces.push((start.0, start.1, to));
        pieces
    }

    fn alternatives(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| operator == "or");
        let parts = pieces
            .iter()
            .map(|&(_, start, end)| self.conjunction(start, end))
            .collect::<Parsed<Vec<_>>>()?;
        Ok(joined(parts, ExpressionKind::Or))
    }

    fn conjunction(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| operator == "and");
        let parts = pieces
            .iter()
            .map(|&(_, start, end)| self.comparison(start, end))
            .collect::<Parsed<Vec<_>>>()?;
        Ok(joined(parts, ExpressionKind::And))
    }

    fn comparison(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| comparison(operator).is_some());
        match pieces.as_slice() {
            [_] => self.sum(from, to),
            [(_, a, b), (Some(operator), c, d)] => {
                let kind = comparison(&self.operators[*operator].0).expect("it splits");
                let (left, right) = (self.sum(*a, *b)?, self.sum(*c, *d)?);
                Ok(Expression {
                    span: left.span.to(right.span),
                    kind: ExpressionKind::Comparison(kind, Box::new((left, right))),
                })
            }
            _ => {
                let second = pieces[2]
                    .0
                    .expect("every piece but the first follows an operator");
                Err(Box::new(Problem::new(
                    "comparisons do not chain",
                    self.operators[second].1,
                    "write `a < b and b < c`",
                )))
            }
        }
    }

    fn sum(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| matches!(operator, "+" | "-"));
        let mut terms = Vec::with_capacity(pieces.len());
        for (before, start, end) in pieces {
            let minus = before.is_some_and(|index| self.operators[index].0 == "-");
            terms.push((minus, self.product(start, end)?));
        }
        Ok(joined_signed(terms, ExpressionKind::Sum))
    }

    fn product(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| matches!(operator, "*" | "/"));
        let mut factors = Vec::with_capacity(pieces.len());
        for (before, start, end) in pieces {
            let divides = before.is_some_and(|index| self.operators[index].0 == "/");
            factors.push((divides, self.power(start, end)?));
        }
        Ok(joined_signed(factors, ExpressionKind::Product))
    }

    /// Operands joined by `^`, from the right; a sign before the base is applied last.
    fn power(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        if to - from > super::split::DEEPEST {
            return Err(Box::new(Problem::new(
                "this tower of powers is too high",
                self.operators[from].1,
                "name parts of it with `let`",
            )));
        }
        let mut result: Option<Expression> = None;
        for index in (from..to).rev() {
            let operand = self.operands[index].take().expect("each is used once");
            let mut value = match result {
                None => operand,
                Some(exponent) => Expression {
                    span: operand.span.to(exponent.span),
                    kind: ExpressionKind::Power(Box::new((operand, exponent))),
                },
            };
            if let Some((minus, span)) = self.signs[index] {
                value.span = span.to(value.span);
                if minus {
                    value = Expression {
                        span: value.span,
                        kind: ExpressionKind::Negative(Box::new(value)),
                    };
                }
            }
            result = Some(value);
        }
        Ok(result.expect("a row has operands"))
    }
}

fn joined(mut parts: Vec<Expression>, make: fn(Vec<Expression>) -> ExpressionKind) -> Expression {
    if parts.len() == 1 {
        return parts.pop().expect("one part");
    }
    Expression {
        span: parts[0].span.to(parts[parts.len() - 1].span),
        kind: make(parts),
    }
}

fn joined_signed(
    mut parts: Vec<(bool, Expression)>,
    make: fn(Vec<(bool, Expression)>) -> ExpressionKind,
) -> Expression {
    if parts.len() == 1 {
        return parts.pop().expect("one part").1;
    }
    Expression {
        span: parts[0].1.span.to(parts[parts.len() - 1].1.span),
        kind: make(parts),
    }
}

fn comparison(operator: &str) -> Option<Comparison> {
    Some(match operator {
        "<" => Comparison::Less,
        "<=" => Comparison::LessOrEqual,
        ">" => Comparison::Greater,
        ">=" => Comparison::GreaterOrEqual,
        "==" => Comparison::Equal,
        "!=" => Comparison::NotEqual,
        _ => return None,
    })
}
