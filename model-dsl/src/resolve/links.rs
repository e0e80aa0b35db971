//! Links: their ends, lengths and angles.

use super::expression::Scope;
use super::names::Named;
use super::naming::Owner;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{Body, BodyId, BodyKind, Guess, Link, Local};
use crate::symbolic::Expr;
use crate::syntax::tree::{self, Expression, ExpressionKind, File, ItemKind, Name};
use crate::units::Dimension;

/// What a link takes in braces.
const ENTRIES: &[&str] = &[
    "length", "angle", "mass", "com", "inertia", "section", "density", "symbol",
];

impl Resolver<'_> {
    /// Makes room for all bodies, then fills in the links.
    pub(super) fn links(&mut self, file: &File) {
        for item in &file.items {
            let name = match &item.kind {
                ItemKind::Link(link) => &link.name,
                ItemKind::Slide(slide) => &slide.name,
                _ => continue,
            };
            self.model.bodies.push(Body {
                name: name.text.clone(),
                kind: BodyKind::Ground,
                masses: Vec::new(),
                span: name.span,
            });
        }
        for (body, item) in bodies(file) {
            let ItemKind::Link(link) = item else {
                continue;
            };
            match self.link(body, link) {
                Ok(kind) => self.model.bodies[body].kind = BodyKind::Link(kind),
                // It still joins what it was meant to join.
                Err(Reported) if link.from.text == link.to.text => {}
                Err(Reported) => {
                    let zero = self.model.graph.zero();
                    for end in [&link.from, &link.to] {
                        if let Some(&place) = self.place_index.get(&end.text) {
                            let at = Local::Cartesian(zero, zero);
                            self.join(place, body, at, end.span, true);
                        }
                    }
                }
            }
        }
    }

    fn link(&mut self, body: BodyId, link: &tree::Link) -> Resolved<Link> {
        let name = &link.name.text;
        let owner = format!("link `{name}`");
        let entries = self.entries(&owner, &link.entries, ENTRIES, &["angle"], true);
        if link.from.text == link.to.text {
            let message = format!("both ends of `{name}` are `{}`", link.to.text);
            return Err(self.error(link.to.span, message, "a link joins two points"));
        }
        let ends = (self.place(&link.from), self.place(&link.to));
        let symbol = match entries.value("symbol") {
            Some(value) => Some(self.angle_symbol(value)?),
            None => None,
        };
        let (from, to) = (ends.0?, ends.1?);
        let drawn = match (self.places[from].drawn, self.places[to].drawn) {
            (Some(a), Some(b)) => Some([a, b]),
            _ => None,
        };
        let length = match (entries.value("length"), drawn) {
            (Some(given), None) => {
                let what = format!("`length` of `{name}`");
                let length = self.quantity(given, wanted::LENGTH, &what, Scope::Params)?;
                self.positive(length, given, "a link's length")?;
                length
            }
            (None, Some(ends)) => self.distance(ends, &link.to)?,
            (Some(given), Some(_)) => {
                let message = format!("both ends of `{name}` are drawn, which gives its length");
                let hint = "remove `length`, or one of the drawn points";
                return Err(self.error(given.span, message, hint));
            }
            (None, None) if entries.misspelt("length") => return Err(Reported),
            (None, None) => {
                let message = format!("the length of `{name}` is not given");
                let hint = "write `length = …` in braces, or draw both of its ends";
                return Err(self.error(link.name.span, message, hint));
            }
        };
        let angle = match (entries.get("angle"), drawn) {
            (Some(entry), None) => {
                let what = format!("`angle` of `{name}`");
                let value = self.quantity(&entry.value, wanted::ANGLE, &what, Scope::Params)?;
                Guess {
                    value: Some(value),
                    exact: entry.exact.is_some(),
                    span: entry.name.span,
                }
            }
            (None, Some([a, b])) => {
                let g = &mut self.model.graph;
                let (dx, dy) = (g.sub(b[0], a[0]), g.sub(b[1], a[1]));
                Guess {
                    value: Some(g.atan2(dy, dx)),
                    exact: false,
                    span: link.name.span,
                }
            }
            (Some(entry), Some(_)) => {
                let message = format!("both ends of `{name}` are drawn, which gives its angle");
                let hint = "remove `angle`, or one of the drawn points";
                return Err(self.error(entry.name.span, message, hint));
            }
            (None, None) if entries.misspelt("angle") => return Err(Reported),
            (None, None) => {
                let message = format!("nothing says which way `{name}` points");
                let hint = "give a guess, as in `angle = 30 deg`, or draw both of its ends";
                return Err(self.error(link.name.span, message, hint));
            }
        };
        let owner = Owner::of_link(name, symbol.as_deref(), link.name.span);
        let length = self.name_quantity("l", &owner, length, Dimension::LENGTH, "length");
        let zero = self.model.graph.zero();
        self.join(
            from,
            body,
            Local::Cartesian(zero, zero),
            link.from.span,
            true,
        );
        self.join(to, body, Local::Cartesian(length, zero), link.to.span, true);
        Ok(Link {
            symbol,
            length,
            angle,
            first: link.from.text.clone(),
            second: link.to.text.clone(),
        })
    }

    fn angle_symbol(&mut self, value: &Expression) -> Resolved<String> {
        match symbol_name(value) {
            // A name that was taken has been reported when names were declared.
            Some(name) => match self.names.get(&name.text) {
                Some(Named::Symbol) => Ok(name.text.clone()),
                _ => Err(Reported),
            },
            None => Err(self.error(
                value.span,
                "`symbol` is the name of the link's angle in equations",
                "write one word, such as `symbol = φ1`",
            )),
        }
    }

    fn distance(&mut self, [a, b]: [[Expr; 2]; 2], to: &Name) -> Resolved<Expr> {
        let g = &mut self.model.graph;
        let (dx, dy) = (g.sub(b[0], a[0]), g.sub(b[1], a[1]));
        let (dx2, dy2) = (g.powi(dx, 2), g.powi(dy, 2));
        let square = g.add(dx2, dy2);
        if g.is_zero(square) {
            let message = "both ends of this link are drawn at the same place";
            return Err(self.error(to.span, message, "a link has a length"));
        }
        let length = g.sqrt(square);
        self.checked(length, to.span)
    }

    /// Refuses numbers that are not positive; what depends on params is checked when they are set.
    pub(super) fn positive(
        &mut self,
        value: Expr,
        written: &Expression,
        what: &str,
    ) -> Resolved<()> {
        let number = self.model.graph.as_number(value);
        if number.is_none_or(num_traits::Signed::is_positive) {
            return Ok(());
        }
        let message = format!("{what} must be positive");
        Err(self.error(written.span, message, "check the sign and the value"))
    }

    /// Refuses negative numbers.
    pub(super) fn not_negative(
        &mut self,
        value: Expr,
        written: &Expression,
        what: &str,
    ) -> Resolved<()> {
        let number = self.model.graph.as_number(value);
        if !number.is_some_and(num_traits::Signed::is_negative) {
            return Ok(());
        }
        let message = format!("{what} cannot be negative");
        Err(self.error(written.span, message, "check the sign"))
    }
}

/// Links and slides with their positions among the bodies.
pub(super) fn bodies(file: &File) -> impl Iterator<Item = (BodyId, &ItemKind)> {
    file.items
        .iter()
        .map(|item| &item.kind)
        .filter(|kind| matches!(kind, ItemKind::Link(_) | ItemKind::Slide(_)))
        .enumerate()
        .map(|(index, kind)| (index + 1, kind))
}

/// The word after `symbol =`.
pub(super) fn symbol_name(value: &Expression) -> Option<&Name> {
    match &value.kind {
        ExpressionKind::Reference(path) => path.single(),
        _ => None,
    }
}
