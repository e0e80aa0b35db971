//! Values of expressions, with their dimensions checked on the way.

use num_traits::{ToPrimitive, Zero};

use super::names::{Named, Varies};
use super::wanted::Wanted;
use super::{Reported, Resolved, Resolver};
use crate::source::Span;
use crate::suggest::closest;
use crate::symbolic::{Expr, Function, Node, Rational};
use crate::syntax::tree::{Expression, ExpressionKind, Name, Path};
use crate::units::{Dimension, Unit, exact_decimal};

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
