//! Hinges, gravity, written-out forces and torques.

use super::expression::Scope;
use super::naming::Owner;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{BodyId, GROUND, Hinge, Load};
use crate::source::Span;
use crate::syntax::tree::{self, File, ItemKind};
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn hinges(&mut self, file: &File) {
        for item in &file.items {
            if let ItemKind::Hinge(hinge) = &item.kind
                && let Ok(hinge) = self.hinge(hinge, item.span)
            {
                self.model.hinges.push(hinge);
            }
        }
    }

    fn hinge(&mut self, hinge: &tree::Hinge, span: Span) -> Resolved<Hinge> {
        let at = &hinge.at;
        let owner = format!("hinge at `{}`", at.text);
        let entries = self.entries(
            &owner,
            &hinge.entries,
            &["stiffness", "damping", "rest"],
            &[],
            false,
        );
        let (pin, bodies) = self.hinged(hinge)?;
        let name = if self.model.pins[pin].members.len() > 2 {
            let (first, second) = (self.body_name(bodies.0), self.body_name(bodies.1));
            format!("{}.{first}.{second}", at.text)
        } else {
            at.text.clone()
        };
        let same = |known: &&Hinge| {
            known.pin == pin && (known.bodies == bodies || known.bodies == (bodies.1, bodies.0))
        };
        if let Some(known) = self.model.hinges.iter().find(same) {
            let earlier = known.span;
            let message = format!("there are two hinges at `{name}` between the same bodies");
            let diagnostic = self
                .diagnostic(at.span, message)
                .hint("give one hinge the stiffness of both")
                .related(self.site(earlier), "declared here first");
            self.report(at.span, diagnostic);
            return Err(Reported);
        }
        let owner = Owner::of_name(&name, at.span);
        let what = |entry: &str| format!("`{entry}` of the hinge at `{}`", at.text);
        let mut given = |entry: &str, wanted, letter, dimension, meaning| {
            let Some(value) = entries.value(entry) else {
                return Ok(None);
            };
            let expr = self.quantity(value, wanted, &what(entry), Scope::Params)?;
            self.not_negative(expr, value, &what(entry))?;
            let named = self.name_quantity(letter, &owner, expr, dimension, meaning);
            Ok(Some(named))
        };
        let stiffness = given(
            "stiffness",
            wanted::TORSIONAL_STIFFNESS,
            "k",
            Dimension::TORQUE,
            "stiffness of the hinge",
        );
        let damping = given(
            "damping",
            wanted::TORSIONAL_DAMPING,
            "c",
            Dimension::ANGULAR_DAMPING,
            "damping of the hinge",
        );
        let rest = match entries.value("rest") {
            None => None,
            Some(value) => {
                Some(self.quantity(value, wanted::ANGLE, &what("rest"), Scope::Params)?)
            }
        };
        let (stiffness, damping) = (stiffness?, damping?);
        if stiffness.is_none() && damping.is_none() && !self.failed() {
            let message = format!(
                "the hinge at `{}` has neither stiffness nor damping",
                at.text
            );
            let hint = "write `{ stiffness = … }`; without a hinge the pin turns freely";
            return Err(self.error(at.span, message, hint));
        }
        Ok(Hinge {
            name,
            pin,
            bodies,
            stiffness,
            damping,
            rest,
            span,
        })
    }

    /// The pin of a hinge and the two bodies that it joins.
    fn hinged(&mut self, hinge: &tree::Hinge) -> Resolved<(usize, (BodyId, BodyId))> {
        let at = &hinge.at;
        let position = self.pin_index.get(&at.text).copied();
        let Some(pin) = position else {
            let point = self.point(at)?;
            if self.partial {
                return Err(Reported);
            }
            let body = self.model.points[point].body;
            let message = format!("no two bodies meet in `{}`", at.text);
            let hint = format!(
                "only `{}` has it; name it as the end of another link as well",
                self.body_name(body)
            );
            return Err(self.error(at.span, message, hint));
        };
        let members: Vec<BodyId> = self.model.pins[pin].members.iter().map(|m| m.0).collect();
        let names: Vec<String> = members
            .iter()
            .map(|&body| self.body_name(body).to_owned())
            .collect();
        let Some((first, second)) = &hinge.between else {
            return match members[..] {
                [first, second] => Ok((pin, (first, second))),
                _ => {
                    let message = format!("{} bodies meet in `{}`", members.len(), at.text);
                    let hint = format!(
                        "say which two the hinge joins: `hinge at {} between {}, {}`",
                        at.text, names[0], names[1]
                    );
                    Err(self.error(at.span, message, hint))
                }
            };
        };
        let bodies = (self.body(first)?, self.body(second)?);
        for (body, name) in [(bodies.0, first), (bodies.1, second)] {
            if !members.contains(&body) {
                let message = format!("`{}` does not meet the others in `{}`", name.text, at.text);
                let hint = format!("the bodies there are {}", crate::syntax::listed(&names));
                return Err(self.error(name.span, message, hint));
            }
        }
        if bodies.0 == bodies.1 {
            let message = format!("a hinge joins `{}` to itself", first.text);
            return Err(self.error(second.span, message, "name two bodies"));
        }
        Ok((pin, bodies))
    }

    /// Gravity, forces and torques.
    pub(super) fn loads(&mut self, file: &File) {
        let mut gravity: Option<Span> = None;
        for item in &file.items {
            match &item.kind {
                ItemKind::Gravity(value) => {
                    if let Some(earlier) = gravity.replace(item.span) {
                        let diagnostic = self
                            .diagnostic(item.span, "gravity is given twice")
                            .hint("remove one of the two")
                            .related(self.site(earlier), "given here first");
                        self.report(item.span, diagnostic);
                        continue;
                    }
                    let pair = self.pair(value, wanted::ACCELERATION, "`gravity`", Scope::Params);
                    self.model.gravity = pair.ok();
                }
                ItemKind::Force(on, value) => {
                    let what = format!("the force on `{}`", on.text());
                    let on = self.end(on);
                    let value = self.pair(value, wanted::FORCE, &what, Scope::Motion);
                    let (Ok(on), Ok(value)) = (on, value) else {
                        continue;
                    };
                    if on.body == GROUND {
                        let message = format!("the force on `{}` moves nothing", on.name);
                        self.error(on.span, message, "name a point of a body that moves");
                        continue;
                    }
                    self.model.loads.push(Load::Force {
                        on,
                        value,
                        span: item.span,
                    });
                }
                ItemKind::Torque(torque) => {
                    let _ = self.torque(torque, item.span);
                }
                _ => {}
            }
        }
    }

    fn torque(&mut self, torque: &tree::Torque, span: Span) -> Resolved<()> {
        let on = self.body(&torque.on);
        let against = match &torque.against {
            None => Ok(GROUND),
            Some(name) => self.body(name),
        };
        let what = format!("the torque on `{}`", torque.on.text);
        let value = self.quantity(&torque.value, wanted::TORQUE, &what, Scope::Motion);
        let (on, against, value) = (on?, against?, value?);
        if on == against {
            let message = format!(
                "the torque on `{}` has nothing to act against",
                torque.on.text
            );
            let hint = "name two different bodies, or one that moves";
            return Err(self.error(torque.on.span, message, hint));
        }
        self.model.loads.push(Load::Torque {
            on,
            against,
            value,
            span,
        });
        Ok(())
    }
}
