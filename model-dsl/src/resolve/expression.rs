//! Values of expressions, with their dimensions checked on the way.

use num_traits::{Signed, ToPrimitive, Zero};

use super::names::{Named, Varies};
use super::wanted::Wanted;
use super::{Reported, Resolved, Resolver};
use crate::source::Span;
use crate::suggest::closest;
use crate::symbolic::{Expr, Function, Node, Rational};
use crate::syntax::tree::{Comparison, Expression, ExpressionKind, Name, Path};
use crate::units::{Dimension, Mark, Unit, exact_decimal};

/// What an expression may refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Scope {
    /// Numbers only.
    Constants,
    /// Params and `let`s as well.
    Params,
    /// Time, inputs, drives and measures as well.
    Motion,
    /// Energies and powers of the whole mechanism as well.
    Results,
}

/// A number, angle or physical quantity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scalar {
    pub expr: Expr,
    pub dimension: Dimension,
    /// Whether it is the literal 0, which fits every dimension.
    pub zero: bool,
}

/// A condition: it holds where `margin` is positive, or also zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Condition {
    pub margin: Expr,
    pub holds_at_zero: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Scalar(Scalar),
    Condition(Condition),
}

/// Constants stay exact while they are this short.
const LONGEST_CONSTANT_BITS: u64 = 4096;

impl Resolver<'_> {
    /// The value of `expression` in SI, which must have the wanted dimension; `what` names it in
    /// messages.
    pub(super) fn quantity(
        &mut self,
        expression: &Expression,
        wanted: Wanted,
        what: &str,
        scope: Scope,
    ) -> Resolved<Expr> {
        let scalar = self.scalar(expression, scope)?;
        self.fits(scalar, wanted, what, expression.span)?;
        Ok(scalar.expr)
    }

    /// Checks that a value has the wanted dimension.
    pub(super) fn fits(
        &mut self,
        scalar: Scalar,
        wanted: Wanted,
        what: &str,
        span: Span,
    ) -> Resolved<()> {
        if scalar.zero {
            return Ok(());
        }
        let (have, want) = (scalar.dimension, wanted.dimension);
        if !have.same_units(want) {
            let is_number = self.model.graph.as_number(scalar.expr).is_some();
            let (found, hint) = match (have.is_none(), is_number) {
                (true, true) => (
                    "a number without a unit".to_owned(),
                    format!("write it in `{}`", unit_of(wanted)),
                ),
                (false, true) if !want.is_none() => (
                    have.described(),
                    format!("write it in `{}`", unit_of(wanted)),
                ),
                _ => (
                    have.described(),
                    "check the dimensions of what it is made of".to_owned(),
                ),
            };
            let message = format!("{what} wants {}, not {found}", wanted.words);
            return Err(self.error(span, message, hint));
        }
        match (have.mark(), want.mark()) {
            (Mark::Frequency, Mark::AngularRate) => Err(self.error(
                span,
                format!("{what} wants {}, not a frequency in Hz", wanted.words),
                "a frequency f turns at `2*pi*f`; write the rate in rad/s or deg/s",
            )),
            (Mark::AngularRate, Mark::Frequency) => Err(self.error(
                span,
                format!(
                    "{what} wants {}, not an angular rate in rad/s",
                    wanted.words
                ),
                "an angular rate w repeats `w/(2*pi)` times per second; write the frequency in Hz",
            )),
            _ => Ok(()),
        }
    }

    pub(super) fn scalar(&mut self, expression: &Expression, scope: Scope) -> Resolved<Scalar> {
        match self.value(expression, scope)? {
            Value::Scalar(scalar) => Ok(scalar),
            Value::Condition(_) => Err(self.error(
                expression.span,
                "a condition stands where a value is wanted",
                "choose between values with `if … then … else …`",
            )),
        }
    }

    pub(super) fn condition(
        &mut self,
        expression: &Expression,
        scope: Scope,
    ) -> Resolved<Condition> {
        match self.value(expression, scope)? {
            Value::Condition(condition) => Ok(condition),
            Value::Scalar(_) => Err(self.error(
                expression.span,
                "a value stands where a condition is wanted",
                "compare it with something, as in `stage.x > 1 mm`",
            )),
        }
    }

    fn value(&mut self, expression: &Expression, scope: Scope) -> Resolved<Value> {
        let span = expression.span;
        let scalar = match &expression.kind {
            ExpressionKind::Literal { number, unit } => {
                self.literal(number, unit.as_ref(), span)?
            }
            ExpressionKind::Reference(path) => self.reference(path, scope)?,
            ExpressionKind::Call(call) => self.function_call(call, span, scope)?,
            ExpressionKind::Sum(terms) => self.sum(terms, scope)?,
            ExpressionKind::Product(factors) => self.product(factors, scope)?,
            ExpressionKind::Negative(inner) => {
                let inner = self.scalar(inner, scope)?;
                Scalar {
                    expr: self.model.graph.neg(inner.expr),
                    ..inner
                }
            }
            ExpressionKind::Power(operands) => self.power(&operands.0, &operands.1, scope)?,
            ExpressionKind::Conditional(parts) => {
                let (condition, positive, negative) = &**parts;
                self.conditional(condition, positive, negative, scope)?
            }
            ExpressionKind::Comparison(comparison, sides) => {
                let condition = self.comparison(*comparison, &sides.0, &sides.1, scope, span)?;
                return Ok(Value::Condition(condition));
            }
            ExpressionKind::And(parts) => {
                return self
                    .combined(parts, Function::Min, scope)
                    .map(Value::Condition);
            }
            ExpressionKind::Or(parts) => {
                return self
                    .combined(parts, Function::Max, scope)
                    .map(Value::Condition);
            }
            ExpressionKind::Text(_) => {
                return Err(self.error(
                    span,
                    "words stand where a value is wanted",
                    "only `table(\"file.csv\")` takes words in quotation marks",
                ));
            }
            ExpressionKind::Pair(_) => {
                return Err(self.error(
                    span,
                    "a pair stands where a single value is wanted",
                    "write one value without the comma",
                ));
            }
        };
        let expr = self.checked(scalar.expr, span)?;
        Ok(Value::Scalar(Scalar { expr, ..scalar }))
    }

    /// Refuses constants that no double can hold or that grow without bound.
    pub(super) fn checked(&mut self, expr: Expr, span: Span) -> Resolved<Expr> {
        let too_long =
            |value: &Rational| value.numer().bits() + value.denom().bits() > LONGEST_CONSTANT_BITS;
        let (large, long) = match self.model.graph.node(expr) {
            Node::Number(value) => (value.to_f64().is_none_or(f64::is_infinite), too_long(value)),
            Node::Sum { constant, terms } => (
                false,
                too_long(constant) || terms.iter().any(|(_, k)| too_long(k)),
            ),
            Node::Product {
                coefficient,
                factors,
            } => (
                false,
                too_long(coefficient) || factors.iter().any(|(_, k)| too_long(k)),
            ),
            Node::Pi | Node::Symbol(_) | Node::Function(..) => (false, false),
        };
        if large {
            let message = "this value is too large: its magnitude may reach 1.79e308";
            return Err(self.error(span, message, "check the numbers and units it is made of"));
        }
        if long {
            let message = "the constants in this expression need too many digits to stay exact";
            return Err(self.error(span, message, "write the value as a decimal number"));
        }
        Ok(expr)
    }

    fn literal(&mut self, number: &str, unit: Option<&Name>, span: Span) -> Resolved<Scalar> {
        let value = match exact_decimal(number) {
            Ok(value) => value,
            Err(error) => {
                let hint = "check the power of ten";
                return Err(self.error(span, error.to_string(), hint));
            }
        };
        let Some(unit) = unit else {
            let zero = value.is_zero();
            return Ok(Scalar {
                expr: self.model.graph.number(value),
                dimension: Dimension::NONE,
                zero,
            });
        };
        let unit = self.unit(unit)?;
        let g = &mut self.model.graph;
        let scaled = g.number(value * &unit.factor);
        let pi = g.pi();
        let pi = g.powi(pi, i64::from(unit.pi_power));
        Ok(Scalar {
            expr: g.mul(scaled, pi),
            dimension: unit.dimension,
            zero: false,
        })
    }

    pub(super) fn unit(&mut self, unit: &Name) -> Resolved<Unit> {
        Unit::parse(&unit.text).map_err(|part| {
            let hint = match part.as_str() {
                "min" | "h" | "d" => "times are in s, with prefixes: `60 s`".to_owned(),
                "t" => "masses are in g, with prefixes: `1 Mg` is a tonne".to_owned(),
                "e" | "E" => "a power of ten has its exponent next to it: `3e6`".to_owned(),
                "rpm" => "write a rate in rad/s or deg/s, a frequency in Hz".to_owned(),
                "in" | "inch" | "ft" | "lbf" | "psi" | "lb" => "units are those of SI".to_owned(),
                _ => {
                    let spellings: Vec<String> = Unit::spellings().collect();
                    match closest(&part, spellings.iter().map(String::as_str)) {
                        Some(near) if part.chars().count() > 1 => format!(
                            "did you mean `{near}`? To multiply by a quantity write `*` between"
                        ),
                        _ => "a product needs a `*`; units are m, g, s, A, K, N, Pa, J, W, V, \
                              C, F, ohm, H, T, Wb, Hz with SI prefixes, and rad, deg, %"
                            .to_owned(),
                    }
                }
            };
            self.error(unit.span, format!("`{part}` is no unit"), hint)
        })
    }

    fn reference(&mut self, path: &Path, scope: Scope) -> Resolved<Scalar> {
        let Some(name) = path.single() else {
            return self.measure_value(path, scope);
        };
        let value = |expr, dimension| Scalar {
            expr,
            dimension,
            zero: false,
        };
        match name.text.as_str() {
            "pi" => return Ok(value(self.model.graph.pi(), Dimension::NONE)),
            "t" => {
                self.allow(scope, Scope::Motion, name.span, "`t` is time")?;
                let time = self.model.time;
                return Ok(value(self.model.graph.of(time), Dimension::TIME));
            }
            _ => {}
        }
        match self.names.get(&name.text) {
            Some(Named::Quantity(symbol, dimension, varies, kind)) => {
                let needed = match varies {
                    Varies::Params => Scope::Params,
                    Varies::Motion => Scope::Motion,
                };
                let reason = match varies {
                    Varies::Params => format!("`{}` is {kind}", name.text),
                    Varies::Motion => format!("`{}` changes with time", name.text),
                };
                self.allow(scope, needed, name.span, &reason)?;
                Ok(value(self.model.graph.of(symbol), dimension))
            }
            Some(Named::Pending(_)) if scope >= Scope::Params => Err(Reported),
            Some(Named::Pending(kind)) => {
                let reason = format!("`{}` is {kind}", name.text);
                Err(self
                    .allow(scope, Scope::Params, name.span, &reason)
                    .err()
                    .unwrap_or(Reported))
            }
            Some(other) => Err(self.error(
                name.span,
                format!("`{}` is {}, not a value", name.text, other.kind()),
                measure_hint(&name.text, other),
            )),
            None => {
                let candidates = self
                    .names_where(|named| matches!(named, Named::Quantity(..) | Named::Pending(_)));
                Err(self.unknown(
                    name.span,
                    &name.text,
                    "quantity",
                    &candidates,
                    "declare it with `param` or `let`",
                ))
            }
        }
    }

    /// Checks that `scope` reaches as far as `needed`.
    pub(super) fn allow(
        &mut self,
        scope: Scope,
        needed: Scope,
        span: Span,
        reason: &str,
    ) -> Resolved<()> {
        if scope >= needed {
            return Ok(());
        }
        let (message, hint) = match scope {
            Scope::Constants => (
                format!("{reason}; this value is written in numbers and units alone"),
                "what follows from other quantities is a `let`",
            ),
            Scope::Params => (
                format!(
                    "{reason}; this value is fixed for a run and can use only params and `let`s"
                ),
                "what changes during a run may stand in drives, expansions, forces, torques, \
                 outputs and stops",
            ),
            Scope::Motion | Scope::Results => (
                format!("{reason}; no force or drive can depend on it"),
                "energies and powers may stand in outputs and stops",
            ),
        };
        Err(self.error(span, message, hint))
    }

    fn sum(&mut self, terms: &[(bool, Expression)], scope: Scope) -> Resolved<Scalar> {
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
                expr: self.folded(values, first, crate::symbolic::Graph::add)?,
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
        join: fn(&mut crate::symbolic::Graph, Expr, Expr) -> Expr,
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

    /// The common dimension of two values that are added, compared or chosen from.
    pub(super) fn together(
        &mut self,
        a: Scalar,
        a_span: Span,
        b: Scalar,
        b_span: Span,
    ) -> Resolved<Scalar> {
        if a.zero {
            return Ok(b);
        }
        if b.zero {
            return Ok(a);
        }
        let mismatch = !a.dimension.same_units(b.dimension);
        let marks = (a.dimension.mark(), b.dimension.mark());
        let mixed = matches!(
            marks,
            (Mark::Frequency, Mark::AngularRate) | (Mark::AngularRate, Mark::Frequency)
        );
        if mismatch || mixed {
            let (first, second) = (a.dimension.described(), b.dimension.described());
            let hint = if mixed {
                "a frequency f is an angular rate of `2*pi*f`"
            } else {
                "only quantities of one kind can be added, compared or chosen from"
            };
            let diagnostic = self
                .diagnostic(b_span, format!("this is {second}, beside {first}"))
                .hint(hint)
                .related(self.site(a_span), first);
            self.report(b_span, diagnostic);
            return Err(Reported);
        }
        Ok(if marks.0 == Mark::Plain { b } else { a })
    }

    fn product(&mut self, factors: &[(bool, Expression)], scope: Scope) -> Resolved<Scalar> {
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
            expr: self.folded(values, span, crate::symbolic::Graph::mul)?,
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

    fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        scope: Scope,
    ) -> Resolved<Scalar> {
        let value = self.scalar(base, scope)?;
        let power = self.quantity(exponent, super::wanted::NUMBER, "an exponent", scope)?;
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

    fn conditional(
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

    fn comparison(
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

    fn combined(
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

/// The unit in the words of what is wanted.
fn unit_of(wanted: Wanted) -> &'static str {
    wanted
        .words
        .rsplit_once('(')
        .map_or("m", |(_, unit)| unit.trim_end_matches(')'))
}

fn measure_hint(name: &str, named: Named) -> String {
    let examples: &[&str] = match named {
        Named::Link(_) => &["angle", "rate"],
        Named::Slide(_) => &["x", "travel", "v"],
        Named::Point => &["x", "y", "vx", "vy"],
        Named::Spring(_) => &["extension", "force"],
        Named::Contact(_) => &["friction", "normal", "slip"],
        Named::Symbol => {
            return "in a model file the angle goes by its link: `crank.angle`".to_owned();
        }
        Named::Quantity(..) | Named::Pending(_) => &[],
    };
    let paths: Vec<String> = examples
        .iter()
        .map(|last| format!("{name}.{last}"))
        .collect();
    format!(
        "name one of its quantities: {}",
        crate::syntax::listed(&paths)
    )
}
