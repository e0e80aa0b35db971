//! Springs, dampers and piezo stacks.

use super::expression::Scope;
use super::naming::Owner;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{Axis, BodyKind, End, GROUND, Local, Mass, Spring};
use crate::symbolic::{Expr, Rational};
use crate::syntax::tree::{self, Expression, File, ItemKind};
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn springs(&mut self, file: &File) {
        for item in &file.items {
            if let ItemKind::Spring(spring) = &item.kind
                && let Ok(spring) = self.spring(spring)
            {
                self.model.springs.push(spring);
            }
        }
    }

    fn spring(&mut self, spring: &tree::Spring) -> Resolved<Spring> {
        let name = &spring.name;
        let kind = if spring.stack { "stack" } else { "spring" };
        let known: &[&str] = if spring.stack {
            &["stiffness", "damping", "length", "expansion", "mass"]
        } else {
            &["stiffness", "damping", "length", "expansion"]
        };
        let owner = format!("{kind} `{}`", name.text);
        let entries = self.entries(&owner, &spring.entries, known, &[], false);
        let ends = (self.end(&spring.first), self.end(&spring.second));
        let owner = Owner::of_name(&name.text, name.span);
        let given = |resolver: &mut Self, entry: &str, wanted, scope| -> Resolved<Option<Expr>> {
            let Some(value) = entries.value(entry) else {
                return Ok(None);
            };
            let what = format!("`{entry}` of `{}`", name.text);
            let expr = resolver.quantity(value, wanted, &what, scope)?;
            if entry != "expansion" {
                resolver.not_negative(expr, value, &what)?;
            }
            Ok(Some(expr))
        };
        let stiffness = given(self, "stiffness", wanted::STIFFNESS, Scope::Params);
        let damping = given(self, "damping", wanted::DAMPING, Scope::Params);
        let length = given(self, "length", wanted::LENGTH, Scope::Params);
        let expansion = given(self, "expansion", wanted::LENGTH, Scope::Motion);
        let mass = given(self, "mass", wanted::MASS, Scope::Params);
        let (first, second) = (ends.0?, ends.1?);
        let axis = self.axis(spring, &first, &second)?;
        let (stiffness, damping) = (stiffness?, damping?);
        if stiffness.is_none() && damping.is_none() && !self.failed() {
            let message = format!("`{}` has neither stiffness nor damping", name.text);
            return Err(self.error(name.span, message, "write `{ stiffness = … }`"));
        }
        let mut named = |letter, value: Option<Expr>, dimension, meaning| {
            value.map(|value| self.name_quantity(letter, &owner, value, dimension, meaning))
        };
        let stiffness = named("k", stiffness, Dimension::STIFFNESS, "stiffness");
        let damping = named("c", damping, Dimension::DAMPING, "damping");
        let length = named("l", length?, Dimension::LENGTH, "free length");
        if let Some(mass) = mass? {
            let mass = named("m", Some(mass), Dimension::MASS, "mass").ok_or(Reported)?;
            self.halve_mass(mass, [&first, &second]);
        }
        Ok(Spring {
            name: name.text.clone(),
            first,
            second,
            axis,
            stiffness,
            damping,
            length,
            expansion: expansion?,
            stack: spring.stack,
            span: name.span,
        })
    }

    /// Half the mass of a stack goes with each of its ends.
    fn halve_mass(&mut self, mass: Expr, ends: [&End; 2]) {
        let half = self
            .model
            .graph
            .scale(mass, Rational::new(1.into(), 2.into()));
        let zero = self.model.graph.zero();
        for end in ends {
            if end.body != GROUND {
                self.model.bodies[end.body].masses.push(Mass {
                    mass: half,
                    center: end.at.unwrap_or(Local::Cartesian(zero, zero)),
                    inertia: zero,
                    span: end.span,
                });
            }
        }
    }

    /// The direction in which a spring acts: as written, else that of a slide whose other end is
    /// ground or a slide, else along the line between its ends.
    fn axis(&mut self, spring: &tree::Spring, first: &End, second: &End) -> Resolved<Axis> {
        let name = &spring.name;
        if first.body == second.body {
            let message = format!(
                "both ends of `{}` are on `{}`",
                name.text,
                self.body_name(first.body)
            );
            let hint = "a spring acts between two bodies";
            return Err(self.error(spring.second.span, message, hint));
        }
        if let Some(along) = &spring.along {
            return Ok(Axis::Fixed(self.direction(along, "`along`")?));
        }
        let is_slide = |end: &End, path: &tree::Path| {
            path.single().is_some()
                && matches!(self.model.bodies[end.body].kind, BodyKind::Slide(_))
                && end.name == self.model.bodies[end.body].name
        };
        let slides = (
            is_slide(first, &spring.first),
            is_slide(second, &spring.second),
        );
        match slides {
            (true, true) => return Ok(Axis::Guide(second.body)),
            (true, false) if second.body == GROUND => return Ok(Axis::Guide(first.body)),
            (false, true) if first.body == GROUND => return Ok(Axis::Guide(second.body)),
            _ => {}
        }
        for end in [first, second] {
            if end.at.is_none() {
                if self.failed() {
                    return Err(Reported);
                }
                let message = format!("`{}` ends on ground, but where?", name.text);
                let hint = "name a point of ground, declared with `ground NAME = (X, Y)`, or a \
                            direction with `along (X, Y)`";
                return Err(self.error(end.span, message, hint));
            }
        }
        Ok(Axis::Line)
    }

    /// The value of an entry of any kind that is fixed for a run.
    pub(super) fn fixed(
        &mut self,
        value: &Expression,
        wanted: wanted::Wanted,
        what: &str,
    ) -> Resolved<Expr> {
        self.quantity(value, wanted, what, Scope::Params)
    }
}
