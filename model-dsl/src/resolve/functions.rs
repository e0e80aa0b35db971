//! Functions that expressions may use: mathematics, and formulas of parts.

use super::calls::{Given, Parameter, Signature, Takes, optional, required};
use super::expression::{Scalar, Scope};
use super::wanted;
use super::{Reported, Resolved, Resolver};
use crate::model::Condition;
use crate::parts::hinges::{self, CircularFormula};
use crate::source::Span;
use crate::symbolic::{Function, Rational};
use crate::syntax::tree::{Call, Expression};
use crate::units::Dimension;

/// How a mathematical function treats dimensions.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A number in, a number out.
    Plain,
    /// Anything in, the same out.
    Keeps,
    /// Anything in, a number out.
    Forgets,
}

const FUNCTIONS: &[(&str, Function, Kind)] = &[
    ("sin", Function::Sin, Kind::Plain),
    ("cos", Function::Cos, Kind::Plain),
    ("tan", Function::Tan, Kind::Plain),
    ("asin", Function::Asin, Kind::Plain),
    ("acos", Function::Acos, Kind::Plain),
    ("atan", Function::Atan, Kind::Plain),
    ("tanh", Function::Tanh, Kind::Plain),
    ("exp", Function::Exp, Kind::Plain),
    ("log", Function::Log, Kind::Plain),
    ("abs", Function::Abs, Kind::Keeps),
    ("sign", Function::Sign, Kind::Forgets),
    ("floor", Function::Floor, Kind::Plain),
    ("atan2", Function::Atan2, Kind::Forgets),
    ("min", Function::Min, Kind::Keeps),
    ("max", Function::Max, Kind::Keeps),
];

const CIRCULAR_HINGE: Signature = Signature {
    name: "circular_hinge",
    parameters: &[
        required("modulus", Takes::Quantity(wanted::MODULUS)),
        required("width", Takes::Quantity(wanted::LENGTH)),
        required("web", Takes::Quantity(wanted::LENGTH)),
        required("radius", Takes::Quantity(wanted::LENGTH)),
        required("formula", Takes::Word(&CircularFormula::NAMES)),
    ],
};

/// Words that build something only in one place of the language, with that place.
const ELSEWHERE: &[(&str, &str)] = &[
    ("rect", "a `section`"),
    ("circle", "a `section`"),
    ("polar", "a place, such as `com` or `point … at`"),
    ("lugre", "the `friction` of a contact"),
];

/// Whether a name is that of a function of expressions. Waveforms, sections and laws are called
/// only where nothing else can stand, so a slide may be called `table`.
pub(super) fn is_function(name: &str) -> bool {
    name == "sqrt"
        || name == CIRCULAR_HINGE.name
        || FUNCTIONS.iter().any(|(known, _, _)| *known == name)
}

fn names() -> Vec<String> {
    FUNCTIONS
        .iter()
        .map(|(name, _, _)| *name)
        .chain(["sqrt", CIRCULAR_HINGE.name])
        .map(str::to_owned)
        .collect()
}

impl Resolver<'_> {
    /// The value of a call inside an expression.
    pub(super) fn function_call(
        &mut self,
        call: &Call,
        span: Span,
        scope: Scope,
    ) -> Resolved<Scalar> {
        let name = call.name.text.as_str();
        if name == CIRCULAR_HINGE.name {
            return self.circular_hinge(call, scope);
        }
        if name == "sqrt" {
            let [argument] = self.numbered(call, 1, 1)?[..] else {
                return Err(Reported);
            };
            let value = self.scalar(argument, scope)?;
            let half = Rational::new(1.into(), 2.into());
            return self.numeric_power(value, &half, span);
        }
        match FUNCTIONS.iter().find(|(known, _, _)| *known == name) {
            Some(&(_, function, kind)) => self.mathematics(call, function, kind, scope),
            None => Err(self.not_a_function(call)),
        }
    }

    fn not_a_function(&mut self, call: &Call) -> Reported {
        let name = &call.name;
        if super::drives::is_waveform(&name.text) {
            let message = format!("`{}` stands for a whole drive", name.text);
            let hint = format!(
                "declare `drive NAME = {}(…)` and use its name here",
                name.text
            );
            return self.error(name.span, message, hint);
        }
        if let Some((_, place)) = ELSEWHERE.iter().find(|(known, _)| *known == name.text) {
            let message = format!("`{}` belongs to {place}", name.text);
            return self.error(name.span, message, "write a value here");
        }
        if self.names.contains(&name.text) {
            let message = format!("`{}` is no function", name.text);
            let hint = format!("to multiply write `{} * (…)`", name.text);
            return self.error(name.span, message, hint);
        }
        if matches!(name.text.as_str(), "ln" | "log10" | "lg") {
            let message = format!("there is no function `{}`", name.text);
            return self.error(name.span, message, "the natural logarithm is `log`");
        }
        self.unknown(
            name.span,
            &name.text,
            "function",
            &names(),
            "the functions are sin, cos, tan, asin, acos, atan, atan2, tanh, exp, log, sqrt, abs, \
             sign, floor, min, max and circular_hinge",
        )
    }

    /// Arguments of a function, which have no names.
    fn numbered<'e>(
        &mut self,
        call: &'e Call,
        least: usize,
        most: usize,
    ) -> Resolved<Vec<&'e Expression>> {
        let name = &call.name;
        if let Some(named) = call.arguments.iter().find_map(|a| a.name.as_ref()) {
            let message = format!("`{}` takes its arguments without names", name.text);
            return Err(self.error(named.span, message, "write the values alone"));
        }
        let count = call.arguments.len();
        if count < least || count > most {
            let wants = match (least, most) {
                (1, 1) => "one argument".to_owned(),
                (2, 2) => "two arguments".to_owned(),
                _ => format!("at least {least} arguments"),
            };
            let message = format!("`{}` takes {wants}, not {count}", name.text);
            return Err(self.error(name.span, message, "separate arguments by commas"));
        }
        Ok(call.arguments.iter().map(|a| &a.value).collect())
    }

    fn mathematics(
        &mut self,
        call: &Call,
        function: Function,
        kind: Kind,
        scope: Scope,
    ) -> Resolved<Scalar> {
        let (least, most) = match function {
            Function::Min | Function::Max => (2, 64),
            _ => (function.arity(), function.arity()),
        };
        let arguments = self.numbered(call, least, most)?;
        let mut values = Vec::with_capacity(arguments.len());
        for argument in &arguments {
            let scalar = self.scalar(argument, scope)?;
            if kind == Kind::Plain {
                let what = format!("`{}`", call.name.text);
                self.fits(scalar, wanted::NUMBER, &what, argument.span)?;
            }
            values.push(scalar);
        }
        let mut common = values[0];
        for (value, argument) in values.iter().zip(&arguments).skip(1) {
            common = self.together(common, arguments[0].span, *value, argument.span)?;
        }
        let g = &mut self.model.graph;
        let expr = if arguments.len() > function.arity() {
            let mut folded = values[0].expr;
            for value in &values[1..] {
                folded = g.function(function, &[folded, value.expr]);
            }
            folded
        } else {
            let exprs: Vec<_> = values.iter().map(|value| value.expr).collect();
            g.function(function, &exprs)
        };
        Ok(Scalar {
            expr,
            dimension: match kind {
                Kind::Keeps => common.dimension,
                Kind::Plain | Kind::Forgets => Dimension::NONE,
            },
            zero: false,
        })
    }

    fn circular_hinge(&mut self, call: &Call, scope: Scope) -> Resolved<Scalar> {
        let given = self.arguments(call, &CIRCULAR_HINGE, scope)?;
        let [
            Given::Scalar(modulus),
            Given::Scalar(width),
            Given::Scalar(web),
            Given::Scalar(radius),
            Given::Word(formula),
        ] = given.as_slice()
        else {
            return Err(Reported);
        };
        let formula = CircularFormula::named(formula).ok_or(Reported)?;
        let units = [
            (modulus, "elastic modulus", "Pa"),
            (width, "width", "m"),
            (web, "web thickness", "m"),
            (radius, "radius", "m"),
        ];
        for (value, what, unit) in units {
            let name = format!("the {what} of a circular hinge");
            let condition = Condition::above_zero(value.expr, &name).in_unit(unit);
            self.model.conditions.push((condition, call.name.span));
        }
        let expr = hinges::circular(
            &mut self.model.graph,
            [modulus.expr, width.expr, web.expr, radius.expr],
            formula,
        );
        Ok(Scalar {
            expr,
            dimension: Dimension::TORQUE,
            zero: false,
        })
    }
}

/// `polar(r, angle)`: a place by its distance and direction.
pub(super) const POLAR: Signature = Signature {
    name: "polar",
    parameters: &[
        required("distance", Takes::Quantity(wanted::LENGTH)),
        required("angle", Takes::Quantity(wanted::ANGLE)),
    ],
};

/// `polar(r, angle)` as a vector of any dimension.
pub(super) const POLAR_VECTOR: Signature = Signature {
    name: "polar",
    parameters: &[
        Parameter {
            name: "magnitude",
            takes: Takes::Any,
            optional: false,
        },
        required("angle", Takes::Quantity(wanted::ANGLE)),
    ],
};

/// `rect(width, height)`: a section b wide out of plane and h high.
pub(super) const RECT: Signature = Signature {
    name: "rect",
    parameters: &[
        required("width", Takes::Quantity(wanted::LENGTH)),
        required("height", Takes::Quantity(wanted::LENGTH)),
    ],
};

/// `circle(diameter)`: a round section.
pub(super) const CIRCLE: Signature = Signature {
    name: "circle",
    parameters: &[required("diameter", Takes::Quantity(wanted::LENGTH))],
};

/// `lugre(…)`: the friction law of Canudas de Wit et al. 1995.
pub(super) const LUGRE: Signature = Signature {
    name: "lugre",
    parameters: &[
        required("sigma0", Takes::Quantity(wanted::STIFFNESS)),
        required("sigma1", Takes::Quantity(wanted::DAMPING)),
        required("sigma2", Takes::Quantity(wanted::DAMPING)),
        required("mu_s", Takes::Quantity(wanted::NUMBER)),
        required("mu_c", Takes::Quantity(wanted::NUMBER)),
        required("v_s", Takes::Quantity(wanted::VELOCITY)),
        optional("reference", Takes::Quantity(wanted::FORCE)),
    ],
};
