//! Friction contacts.

use super::calls::Given;
use super::expression::Scope;
use super::functions::LUGRE;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{BodyKind, Contact, ContactRole, End, Friction, NormalForce};
use crate::parts::friction::{LugreParameters, lugre};
use crate::symbolic::Expr;
use crate::syntax::tree::{self, Expression, ExpressionKind, File, ItemKind};

/// What a contact takes in braces.
const ENTRIES: &[&str] = &[
    "normal",
    "preload",
    "normal_stiffness",
    "normal_damping",
    "friction",
];

impl Resolver<'_> {
    pub(super) fn contacts(&mut self, file: &File) {
        let contacts: Vec<&tree::Contact> = file
            .items
            .iter()
            .filter_map(|item| match &item.kind {
                ItemKind::Contact(contact) => Some(contact),
                _ => None,
            })
            .collect();
        // A contact alone has the article's bare symbols, unless the user took one of them.
        let taken = |name: &str| self.model.graph.symbol_texts().any(|text| text == name);
        let is_alone =
            contacts.len() == 1 && !["v", "F_N", "F_S", "F_C", "z"].map(taken).contains(&true);
        for contact in contacts {
            let qualifier = if is_alone { "" } else { &contact.name.text };
            if let Ok(contact) = self.contact(contact, qualifier) {
                self.model.contacts.push(contact);
            }
        }
    }

    fn contact(&mut self, contact: &tree::Contact, qualifier: &str) -> Resolved<Contact> {
        let name = &contact.name;
        let owner = format!("contact `{}`", name.text);
        let entries = self.entries(&owner, &contact.entries, ENTRIES, &[], false);
        let ends = (self.end(&contact.first), self.end(&contact.second));
        let normal = match entries.value("normal") {
            None => None,
            Some(value) => Some(self.direction(value, "`normal`")?),
        };
        let force = |resolver: &mut Self, entry: &str, wanted| -> Resolved<Option<Expr>> {
            let Some(value) = entries.value(entry) else {
                return Ok(None);
            };
            let what = format!("`{entry}` of `{}`", name.text);
            let expr = resolver.quantity(value, wanted, &what, Scope::Params)?;
            resolver.not_negative(expr, value, &what)?;
            Ok(Some(expr))
        };
        let preload = force(self, "preload", wanted::FORCE);
        let stiffness = force(self, "normal_stiffness", wanted::STIFFNESS);
        let damping = force(self, "normal_damping", wanted::DAMPING);
        let (preload, stiffness, damping) = (preload?, stiffness?, damping?);
        let zero = self.model.graph.zero();
        let normal_force = match (preload, stiffness, damping) {
            (preload, Some(stiffness), damping) => NormalForce::Compliant {
                preload: preload.unwrap_or(zero),
                stiffness,
                damping: damping.unwrap_or(zero),
            },
            (_, None, Some(_)) => {
                let message = format!("`{}` has a normal damping, but no stiffness", name.text);
                let hint = "write `normal_stiffness = …` as well";
                return Err(self.error(name.span, message, hint));
            }
            (Some(preload), None, None) => NormalForce::Constant(preload),
            (None, None, None) if entries.misspelt("preload") => return Err(Reported),
            (None, None, None) => {
                let message = format!("nothing presses the two sides of `{}` together", name.text);
                let hint = "write `preload = …`, or `normal_stiffness = …`";
                return Err(self.error(name.span, message, hint));
            }
        };
        let Some(law) = entries.value("friction") else {
            if entries.misspelt("friction") {
                return Err(Reported);
            }
            let message = format!("`{}` has no friction law", name.text);
            let hint = format!("write `friction = {}`", LUGRE.form());
            return Err(self.error(name.span, message, hint));
        };
        let friction = self.friction(qualifier, law, &normal_force, preload);
        let (first, second) = (ends.0?, ends.1?);
        let guide = self.sliding_direction(contact, &first, &second)?;
        let on_link = [&first, &second]
            .iter()
            .any(|end| matches!(self.model.bodies[end.body].kind, BodyKind::Link(_)));
        if normal.is_none() && !entries.misspelt("normal") && (on_link || stiffness.is_some()) {
            let message = format!("nothing says which way `{}` presses", name.text);
            let hint = format!(
                "write `normal = (0, -1)` for a force on `{}` that points down",
                first.name
            );
            return Err(self.error(name.span, message, hint));
        }
        Ok(Contact {
            name: name.text.clone(),
            first,
            second,
            guide,
            normal,
            normal_force,
            friction: friction?,
            role: ContactRole::default(),
            span: name.span,
        })
    }

    /// The slide along whose guide the two ends slide: the second's, else the first's.
    fn sliding_direction(
        &mut self,
        contact: &tree::Contact,
        first: &End,
        second: &End,
    ) -> Resolved<usize> {
        if first.body == second.body {
            let message = format!("both sides of `{}` are on one body", contact.name.text);
            let hint = "name points of two bodies";
            return Err(self.error(contact.second.span, message, hint));
        }
        let is_slide = |end: &End| matches!(self.model.bodies[end.body].kind, BodyKind::Slide(_));
        if is_slide(second) {
            Ok(second.body)
        } else if is_slide(first) {
            Ok(first.body)
        } else if self.failed() {
            Err(Reported)
        } else {
            let message = format!("neither side of `{}` is a slide", contact.name.text);
            let hint = "a contact slides along the guide of a slide: name one as its second side";
            Err(self.error(contact.name.span, message, hint))
        }
    }

    fn friction(
        &mut self,
        contact: &str,
        law: &Expression,
        normal_force: &NormalForce,
        preload: Option<Expr>,
    ) -> Resolved<Friction> {
        let hint = format!("the laws are `{}`", LUGRE.form());
        let call = match &law.kind {
            ExpressionKind::Call(call) if call.name.text == LUGRE.name => call,
            ExpressionKind::Call(call) => {
                let message = format!("there is no friction law `{}`", call.name.text);
                return Err(self.error(call.name.span, message, hint));
            }
            _ => return Err(self.error(law.span, "this is no friction law", hint)),
        };
        let given = self.arguments(call, &LUGRE, Scope::Params)?;
        let value = |index: usize| given.get(index).and_then(Given::scalar).map(|s| s.expr);
        let parameters = LugreParameters {
            sigma0: value(0).ok_or(Reported)?,
            sigma1: value(1).ok_or(Reported)?,
            sigma2: value(2).ok_or(Reported)?,
            mu_s: value(3).ok_or(Reported)?,
            mu_c: value(4).ok_or(Reported)?,
            v_s: value(5).ok_or(Reported)?,
        };
        let reference = value(6);
        let unloaded = preload.is_none_or(|preload| self.model.graph.is_zero(preload));
        if unloaded && reference.is_none() {
            let message =
                "without a preload LuGre does not know at which force its bristles were measured";
            let hint = "add `reference = …` to `lugre(…)`: the normal force for which sigma0 holds";
            return Err(self.error(law.span, message, hint));
        }
        Ok(lugre(
            &mut self.model.graph,
            contact,
            parameters,
            normal_force,
            reference,
        ))
    }
}
