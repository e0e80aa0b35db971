//! What parts give to the parameters of their components.

use super::expression::Scope;
use super::names::Named;
use super::wanted::{self, Wanted};
use super::{Reported, Resolved, Resolver};
use crate::syntax::listed;
use crate::syntax::tree::{ExpressionKind, File, Given, ItemKind};

/// Kinds of quantities by the words of parameters.
const KINDS: [(&str, Wanted); 18] = [
    ("number", wanted::NUMBER),
    ("angle", wanted::ANGLE),
    ("length", wanted::LENGTH),
    ("mass", wanted::MASS),
    ("time", wanted::TIME),
    ("inertia", wanted::INERTIA),
    ("density", wanted::DENSITY),
    ("force", wanted::FORCE),
    ("torque", wanted::TORQUE),
    ("stiffness", wanted::STIFFNESS),
    ("damping", wanted::DAMPING),
    ("torsional_stiffness", wanted::TORSIONAL_STIFFNESS),
    ("torsional_damping", wanted::TORSIONAL_DAMPING),
    ("velocity", wanted::VELOCITY),
    ("acceleration", wanted::ACCELERATION),
    ("frequency", wanted::FREQUENCY),
    ("rate", wanted::ANGULAR_RATE),
    ("modulus", wanted::MODULUS),
];

impl Resolver<'_> {
    /// Checks all values that parts give; if one does not fit, what follows from it is not worth
    /// reporting.
    pub(super) fn parts_given(&mut self, file: &File) -> Resolved<()> {
        let mut result = Ok(());
        for item in &file.items {
            if let ItemKind::Given(given) = &item.kind
                && self.fits_parameter(given).is_err()
            {
                result = Err(Reported);
            }
        }
        result
    }

    fn fits_parameter(&mut self, given: &Given) -> Resolved<()> {
        let value = &given.value;
        if let ExpressionKind::Reference(path) = &value.kind
            && let Some(name) = path.single()
            && matches!(self.names.get(&name.text), Some(Named::Pending("a drive")))
        {
            // Drives are resolved later, and checked where the component uses them.
            return Ok(());
        }
        let kind = KINDS.iter().find(|(word, _)| *word == given.kind.text);
        let (dimension, words) = match kind {
            Some((_, wanted)) => (wanted.dimension, wanted.words.to_owned()),
            None => match crate::units::Unit::parse(&given.kind.text) {
                Ok(unit) => (unit.dimension, unit.dimension.described()),
                Err(_) => {
                    let words: Vec<&str> = KINDS.iter().map(|(word, _)| *word).collect();
                    return Err(self.error(
                        given.kind.span,
                        format!("`{}` is no kind of quantity", given.kind.text),
                        format!("write a unit, or one of {}", listed(&words)),
                    ));
                }
            },
        };
        let scalar = self.scalar(value, Scope::Motion)?;
        if scalar.zero || scalar.dimension.same_units(dimension) {
            return Ok(());
        }
        let parameter = &given.parameter;
        let message = format!(
            "`{}` of the part `{}` wants {words}, not {}",
            parameter.text,
            given.part,
            scalar.dimension.described()
        );
        let diagnostic = self
            .diagnostic(value.span, message)
            .hint("check the value and its unit")
            .related(self.site(parameter.span), "it is asked for here");
        self.report(value.span, diagnostic);
        Err(Reported)
    }
}
