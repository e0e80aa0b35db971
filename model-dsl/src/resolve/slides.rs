//! Slides: their guides and where they stand on them.

use super::expression::Scope;
use super::links::bodies;
use super::{Resolved, Resolver, wanted};
use crate::model::{BodyId, BodyKind, GROUND, Guess, Local, Slide};
use crate::syntax::tree::{self, File, ItemKind};

/// What a slide takes in braces.
const ENTRIES: &[&str] = &["mass", "com", "inertia", "at"];

impl Resolver<'_> {
    pub(super) fn slides(&mut self, file: &File) {
        for (body, item) in bodies(file) {
            if let ItemKind::Slide(slide) = item
                && let Ok(kind) = self.slide(body, slide)
            {
                self.model.bodies[body].kind = BodyKind::Slide(kind);
            }
        }
        self.carried_in_circles();
    }

    fn slide(&mut self, body: BodyId, slide: &tree::Slide) -> Resolved<Slide> {
        let name = &slide.name.text;
        let owner = format!("slide `{name}`");
        let entries = self.entries(&owner, &slide.entries, ENTRIES, &["at"], true);
        let carrier = match &slide.on {
            None => GROUND,
            Some(on) => self.body(on)?,
        };
        if carrier == body {
            let message = format!("`{name}` slides on itself");
            return Err(self.error(slide.name.span, message, "name another body after `on`"));
        }
        let Some(along) = &slide.along else {
            let message = format!("nothing says along which direction `{name}` slides");
            let hint = "write `along (1, 0)` for along x";
            return Err(self.error(slide.name.span, message, hint));
        };
        let direction = self.direction(along, "`along`");
        let zero = self.model.graph.zero();
        let (origin, located) = match (&slide.through, &slide.from) {
            (None, None) => (Ok(Local::Cartesian(zero, zero)), false),
            (Some(through), None) => (self.local(through, "`through`"), true),
            (None, Some(from)) => (self.guide_point(from, carrier, slide), true),
            (Some(_), Some(from)) => {
                let hint = "remove one of the two";
                let message = format!("`{name}` has both `through` and `from`");
                return Err(self.error(from.span, message, hint));
            }
        };
        let at = match entries.get("at") {
            None => Guess {
                value: None,
                exact: false,
                span: slide.name.span,
            },
            Some(entry) => {
                let what = format!("`at` of `{name}`");
                let value = self.quantity(&entry.value, wanted::LENGTH, &what, Scope::Params)?;
                Guess {
                    value: Some(value),
                    exact: entry.exact.is_some(),
                    span: entry.name.span,
                }
            }
        };
        Ok(Slide {
            carrier,
            direction: direction?,
            origin: origin?,
            located,
            at,
            traces: None,
        })
    }

    fn guide_point(
        &mut self,
        from: &tree::Path,
        carrier: BodyId,
        slide: &tree::Slide,
    ) -> Resolved<Local> {
        let point = match from.parts.as_slice() {
            [point] => point,
            [body, point] if self.body(body)? == carrier => point,
            _ => {
                let message = format!("`{}` is no point of the guide", from.text());
                let hint = "name a point of the body that carries the guide";
                return Err(self.error(from.span, message, hint));
            }
        };
        let place = self.places.iter().find(|place| place.name == point.text);
        if let Some(at) = self.on_body(&point.text, carrier) {
            return Ok(at);
        }
        // On ground a drawn point will do, whatever body has it.
        if let (GROUND, Some([x, y])) = (carrier, place.and_then(|place| place.drawn)) {
            return Ok(Local::Cartesian(x, y));
        }
        if place.is_none() {
            self.point(point)?;
        }
        let message = format!(
            "`{}` is not on `{}`, which carries the guide of `{}`",
            point.text,
            self.body_name(carrier),
            slide.name.text
        );
        let hint = "name a point of that body, or say `on BODY` for another guide";
        Err(self.error(point.span, message, hint))
    }

    /// Refuses slides that carry each other.
    fn carried_in_circles(&mut self) {
        for start in 1..self.model.bodies.len() {
            let mut body = start;
            for _ in 0..self.model.bodies.len() {
                match &self.model.bodies[body].kind {
                    BodyKind::Slide(slide) => body = slide.carrier,
                    BodyKind::Link(_) | BodyKind::Ground => break,
                }
                if body == start {
                    let name = self.model.bodies[start].name.clone();
                    let span = self.model.bodies[start].span;
                    let message = format!("`{name}` is carried by a slide that it carries itself");
                    self.error(span, message, "let one of them slide on another body");
                    return;
                }
            }
        }
    }
}
