//! Calls such as `sawtooth(stroke, frequency = f, rise = rise)`: what each takes, as a table, and
//! the one place that checks what was given against it.

use std::fmt::Write;

use super::expression::{Scalar, Scope};
use super::wanted::Wanted;
use super::{Reported, Resolved, Resolver};
use crate::suggest::closest;
use crate::syntax::tree::{Call, Expression, ExpressionKind, Name};

/// One parameter of something that can be called.
pub(super) struct Parameter {
    pub name: &'static str,
    pub takes: Takes,
    /// Whether it may be left out.
    pub optional: bool,
}

/// What a parameter takes.
#[derive(Clone, Copy)]
pub(super) enum Takes {
    /// A quantity of this dimension.
    Quantity(Wanted),
    /// A quantity of any dimension.
    Any,
    /// A quantity of the dimension of the first parameter.
    LikeFirst,
    /// One of some words.
    Word(&'static [&'static str]),
    /// Words in quotation marks.
    Text,
}

/// Something that can be called.
pub(super) struct Signature {
    pub name: &'static str,
    pub parameters: &'static [Parameter],
}

pub(super) const fn required(name: &'static str, takes: Takes) -> Parameter {
    Parameter {
        name,
        takes,
        optional: false,
    }
}

pub(super) const fn optional(name: &'static str, takes: Takes) -> Parameter {
    Parameter {
        name,
        takes,
        optional: true,
    }
}

/// What a parameter was given.
#[derive(Clone, Debug)]
pub(super) enum Given {
    Nothing,
    Scalar(Scalar),
    Word(&'static str),
    Text(String),
}

impl Given {
    /// The scalar, if one was given.
    pub(super) fn scalar(&self) -> Option<Scalar> {
        match self {
            Given::Scalar(scalar) => Some(*scalar),
            Given::Nothing | Given::Word(_) | Given::Text(_) => None,
        }
    }
}

impl Signature {
    /// How it is called: `sine(amplitude, frequency, phase =, offset =)`.
    pub(super) fn form(&self) -> String {
        let mut text = format!("{}(", self.name);
        for (index, parameter) in self.parameters.iter().enumerate() {
            let comma = if index == 0 { "" } else { ", " };
            let mark = if parameter.optional { "?" } else { "" };
            let _ = write!(text, "{comma}{}{mark}", parameter.name);
        }
        text.push(')');
        text
    }
}

impl Resolver<'_> {
    /// What each parameter of `signature` was given by `call`, in the signature's order.
    pub(super) fn arguments(
        &mut self,
        call: &Call,
        signature: &Signature,
        scope: Scope,
    ) -> Resolved<Vec<Given>> {
        let bound = self.bind(call, signature)?;
        let mut given: Vec<Given> = Vec::with_capacity(bound.len());
        let mut failed = false;
        for (parameter, argument) in signature.parameters.iter().zip(bound) {
            let value = match argument {
                None => Ok(Given::Nothing),
                Some(argument) => {
                    let first = given.first().and_then(Given::scalar);
                    self.argument(call, parameter, argument, first, scope)
                }
            };
            failed |= value.is_err();
            given.push(value.unwrap_or(Given::Nothing));
        }
        if failed { Err(Reported) } else { Ok(given) }
    }

    fn bind<'e>(
        &mut self,
        call: &'e Call,
        signature: &Signature,
    ) -> Resolved<Vec<Option<&'e Expression>>> {
        let form = format!("it is called as `{}`", signature.form());
        let mut bound: Vec<Option<&Expression>> = vec![None; signature.parameters.len()];
        let mut named_seen = false;
        for (position, argument) in call.arguments.iter().enumerate() {
            let index = match &argument.name {
                None if named_seen => {
                    let message = "an argument without a name follows one with a name";
                    let hint = "give it by name as well";
                    return Err(self.error(argument.value.span, message, hint));
                }
                None if position >= signature.parameters.len() => {
                    let message = format!(
                        "`{}` takes {} arguments at most",
                        signature.name,
                        signature.parameters.len()
                    );
                    return Err(self.error(argument.value.span, message, form));
                }
                None => position,
                Some(name) => {
                    named_seen = true;
                    self.parameter(name, signature, &form)?
                }
            };
            if bound[index].replace(&argument.value).is_some() {
                let message = format!("`{}` is given twice", signature.parameters[index].name);
                return Err(self.error(argument.value.span, message, "remove one of the two"));
            }
        }
        let missing: Vec<&str> = signature
            .parameters
            .iter()
            .zip(&bound)
            .filter(|(parameter, argument)| argument.is_none() && !parameter.optional)
            .map(|(parameter, _)| parameter.name)
            .collect();
        if missing.is_empty() {
            return Ok(bound);
        }
        let message = format!(
            "`{}` needs {}",
            signature.name,
            crate::syntax::listed(&missing)
        );
        let words = signature.parameters.iter().find_map(|parameter| {
            let Takes::Word(words) = parameter.takes else {
                return None;
            };
            missing.contains(&parameter.name).then(|| {
                format!(
                    "{form}; `{}` is one of {}",
                    parameter.name,
                    crate::syntax::listed(words)
                )
            })
        });
        Err(self.error(call.name.span, message, words.unwrap_or(form)))
    }

    fn parameter(&mut self, name: &Name, signature: &Signature, form: &str) -> Resolved<usize> {
        let names = signature.parameters.iter().map(|parameter| parameter.name);
        if let Some(index) = names.clone().position(|known| known == name.text) {
            return Ok(index);
        }
        let hint = match closest(&name.text, names) {
            Some(near) => format!("did you mean `{near}`?"),
            None => form.to_owned(),
        };
        let message = format!("`{}` takes no `{}`", signature.name, name.text);
        Err(self.error(name.span, message, hint))
    }

    fn argument(
        &mut self,
        call: &Call,
        parameter: &Parameter,
        argument: &Expression,
        first: Option<Scalar>,
        scope: Scope,
    ) -> Resolved<Given> {
        let what = format!("`{}` of `{}`", parameter.name, call.name.text);
        match parameter.takes {
            Takes::Quantity(wanted) => {
                let scalar = self.scalar(argument, scope)?;
                self.fits(scalar, wanted, &what, argument.span)?;
                Ok(Given::Scalar(scalar))
            }
            Takes::Any => Ok(Given::Scalar(self.scalar(argument, scope)?)),
            Takes::LikeFirst => {
                let scalar = self.scalar(argument, scope)?;
                if let Some(first) = first {
                    let span = call
                        .arguments
                        .first()
                        .map_or(call.name.span, |a| a.value.span);
                    self.together(first, span, scalar, argument.span)?;
                }
                Ok(Given::Scalar(scalar))
            }
            Takes::Word(words) => {
                let hint = format!("it is one of {}", crate::syntax::listed(words));
                let word = match &argument.kind {
                    ExpressionKind::Reference(path) => path.single(),
                    _ => None,
                };
                let Some(word) = word else {
                    return Err(self.error(argument.span, format!("{what} is a word"), hint));
                };
                match words.iter().find(|known| **known == word.text) {
                    Some(known) => Ok(Given::Word(known)),
                    None => {
                        let message = format!("{what} cannot be `{}`", word.text);
                        Err(self.error(argument.span, message, hint))
                    }
                }
            }
            Takes::Text => match &argument.kind {
                ExpressionKind::Text(text) => Ok(Given::Text(text.clone())),
                _ => Err(self.error(
                    argument.span,
                    format!("{what} stands in quotation marks"),
                    "write it as `\"file.csv\"`",
                )),
            },
        }
    }
}
