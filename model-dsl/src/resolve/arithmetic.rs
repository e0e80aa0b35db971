//! Sums, products, powers, choices and conditions.

use num_traits::{Signed, ToPrimitive, Zero};

use super::expression::{Condition, Scalar, Scope};
use super::{Reported, Resolved, Resolver, wanted};
use crate::source::Span;
use crate::symbolic::{Expr, Function, Graph, Rational};
use crate::syntax::tree::{Comparison, Expression};
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn sum(&mut self, terms: &[(bool, Expression)], scope: Scope) -> Resolved<Scalar> {
        let mut values = Vec::with_capacity(terms.len());
        let mut failed = false;
        let mut total: Option<(Scalar, Span)> = None;
        for (minus, term) in terms {
            let Ok(scalar) = self.scalar(term, scope) else {
                failed = true;
                continue;
            };
            let g = &mut self.model.graph;
            values.push(if *minus {
                g.neg(scalar.expr)
            } else {
                scalar.expr
            });
            total = Some(match total {
                None => (scalar, term.span),
                Some((so_far, first)) => match self.together(so_far, first, scalar, term.span) {
                    Ok(merged) => (merged, if so_far.zero { term.span } else { first }),
                    Err(Reported) => return Err(Reported),
                },
            });
        }
        match (failed, total) {
            (false, Some((scalar, first))) => Ok(Scalar {
                expr: self.folded(values, first, Graph::add)?,
                ..scalar
            }),
            _ => Err(Reported),
        }
    }

    /// Adds or multiplies a row of values in a balanced tree, so that no constant grows unseen and
    /// long rows stay cheap.
    fn folded(
        &mut self,
        mut values: Vec<Expr>,
        span: Span,
        join: fn(&mut Graph, Expr, Expr) -> Expr,
    ) -> Resolved<Expr> {
        while values.len() > 1 {
            let mut halved = Vec::with_capacity(values.len().div_ceil(2));
            for pair in values.chunks(2) {
                halved.push(match *pair {
                    [a, b] => {
                        let joined = join(&mut self.model.graph, a, b);
                        self.checked(joined, span)?
                    }
                    _ => pair[0],
                });
            }
            values = halved;
        }
        values.pop().ok_or(Reported)
    }

    pub(super) fn product(
        &mut self,
        factors: &[(bool, Expression)],
        scope: Scope,
    ) -> Resolved<Scalar> {
        let mut values = Vec::with_capacity(factors.len());
        let mut dimension = Dimension::NONE;
        let mut failed = false;
        for (divides, factor) in factors {
            let Ok(scalar) = self.scalar(factor, scope) else {
                failed = true;
                continue;
            };
            let combined = if *divides {
                if self.model.graph.is_zero(scalar.expr) {
                    let hint = "a quotient needs a divisor that is not zero";
                    return Err(self.error(factor.span, "this divides by zero", hint));
                }
                values.push(self.model.graph.powi(scalar.expr, -1));
                dimension.over(scalar.dimension)
            } else {
                values.push(scalar.expr);
                dimension.times(scalar.dimension)
            };
            dimension = match combined {
                Some(dimension) => dimension,
                None => return Err(self.no_dimension(factor.span)),
            };
        }
        if failed {
            return Err(Reported);
        }
        let span = factors[0].1.span;
        Ok(Scalar {
            expr: self.folded(values, span, Graph::mul)?,
            dimension,
            zero: false,
        })
    }

    fn no_dimension(&mut self, span: Span) -> Reported {
        self.error(
            span,
            "this power of units is beyond all physical meaning",
            "check the exponents",
        )
    }

    pub(super) fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        scope: Scope,
    ) -> Resolved<Scalar> {
        let value = self.scalar(base, scope)?;
        let power = self.quantity(exponent, wanted::NUMBER, "an exponent", scope)?;
        let Some(number) = self.model.graph.as_number(power).cloned() else {
            if !value.dimension.is_none() {
                let message = format!(
                    "the base is {}, so its exponent must be a plain number",
                    value.dimension.described()
                );
                let hint = "divide the base by a quantity of its own kind first";
                return Err(self.error(exponent.span, message, hint));
            }
            return Ok(Scalar {
                expr: self
                    .model
                    .graph
                    .function(Function::Power, &[value.expr, power]),
                dimension: Dimension::NONE,
                zero: false,
            });
        };
        self.numeric_power(value, &number, base.span.to(exponent.span))
    }

    /// A value to a power that is a known number.
    pub(super) fn numeric_power(
        &mut self,
        value: Scalar,
        exponent: &Rational,
        span: Span,
    ) -> Resolved<Scalar> {
        let g = &mut self.model.graph;
        if let Some(base) = g.as_number(value.expr).cloned() {
            let negative_root = base.is_negative() && !exponent.is_integer();
            let pole = base.is_zero() && !exponent.is_positive();
            let approximate = base
                .to_f64()
                .unwrap_or(f64::INFINITY)
                .powf(exponent.to_f64().unwrap_or(f64::INFINITY));
            if negative_root || pole {
                let hint = "roots want a base that is not negative, quotients one that is not zero";
                return Err(self.error(span, "this power has no value", hint));
            }
            if approximate.is_infinite() {
                let message = "this value is too large: its magnitude may reach 1.79e308";
                return Err(self.error(span, message, "check the exponent"));
            }
        }
        let Some(dimension) = value.dimension.power(exponent) else {
            return Err(self.no_dimension(span));
        };
        let g = &mut self.model.graph;
        let small = exponent.numer().bits() <= 24 && exponent.denom().bits() <= 24;
        let expr = if small {
            g.powr(value.expr, exponent.clone())
        } else {
            let exponent = g.number(exponent.clone());
            g.function(Function::Power, &[value.expr, exponent])
        };
        Ok(Scalar {
            expr,
            dimension,
            zero: false,
        })
    }

    pub(super) fn conditional(
        &mut self,
        condition: &Expression,
        positive: &Expression,
        negative: &Expression,
        scope: Scope,
    ) -> Resolved<Scalar> {
        let condition = self.condition(condition, scope);
        let (a, b) = (self.scalar(positive, scope), self.scalar(negative, scope));
        let (condition, a, b) = (condition?, a?, b?);
        let common = self.together(a, positive.span, b, negative.span)?;
        let g = &mut self.model.graph;
        // A margin that may be zero is turned about, as the function asks for a positive one.
        let expr = if condition.holds_at_zero {
            let below = g.neg(condition.margin);
            g.function(Function::IfPositive, &[below, b.expr, a.expr])
        } else {
            g.function(Function::IfPositive, &[condition.margin, a.expr, b.expr])
        };
        Ok(Scalar {
            expr,
            dimension: common.dimension,
            zero: a.zero && b.zero,
        })
    }

    pub(super) fn comparison(
        &mut self,
        comparison: Comparison,
        left: &Expression,
        right: &Expression,
        scope: Scope,
        span: Span,
    ) -> Resolved<Condition> {
        let (a, b) = (self.scalar(left, scope), self.scalar(right, scope));
        let (a, b) = (a?, b?);
        self.together(a, left.span, b, right.span)?;
        let g = &mut self.model.graph;
        let (margin, holds_at_zero) = match comparison {
            Comparison::Greater => (g.sub(a.expr, b.expr), false),
            Comparison::GreaterOrEqual => (g.sub(a.expr, b.expr), true),
            Comparison::Less => (g.sub(b.expr, a.expr), false),
            Comparison::LessOrEqual => (g.sub(b.expr, a.expr), true),
            Comparison::Equal | Comparison::NotEqual => {
                let hint = "compare with `<`, `<=`, `>` or `>=`";
                let message = "measured quantities are never exactly equal";
                return Err(self.error(span, message, hint));
            }
        };
        Ok(Condition {
            margin: self.checked(margin, span)?,
            holds_at_zero,
        })
    }

    pub(super) fn combined(
        &mut self,
        parts: &[Expression],
        by: Function,
        scope: Scope,
    ) -> Resolved<Condition> {
        let mut result: Option<Condition> = None;
        for part in parts {
            let condition = self.condition(part, scope)?;
            result = Some(match result {
                None => condition,
                Some(so_far) => Condition {
                    margin: self
                        .model
                        .graph
                        .function(by, &[so_far.margin, condition.margin]),
                    holds_at_zero: if by == Function::Min {
                        so_far.holds_at_zero && condition.holds_at_zero
                    } else {
                        so_far.holds_at_zero || condition.holds_at_zero
                    },
                },
            });
        }
        result.ok_or(Reported)
    }
}
