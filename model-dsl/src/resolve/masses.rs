//! Mass, centre of mass and moment of inertia of links and slides.

use super::calls::Given;
use super::expression::Scope;
use super::functions::{CIRCLE, RECT};
use super::links::bodies;
use super::naming::Owner;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{BodyId, BodyKind, Local, Mass, Note};
use crate::source::Span;
use crate::symbolic::{Expr, Rational};
use crate::syntax::tree::{Entry, Expression, ExpressionKind, File, ItemKind, Name};
use crate::units::Dimension;

/// Shape of a link's section.
#[derive(Clone, Copy)]
enum Section {
    /// Width out of plane and height in plane.
    Rect(Expr, Expr),
    /// Diameter.
    Circle(Expr),
}

impl Resolver<'_> {
    pub(super) fn masses(&mut self, file: &File) {
        for (body, item) in bodies(file) {
            let (name, entries, own) = match item {
                ItemKind::Link(link) => {
                    let own = self.link_mass(body, &link.name, &link.entries);
                    (&link.name, &link.entries, own)
                }
                ItemKind::Slide(slide) => {
                    let own = self.slide_mass(&slide.name, &slide.entries);
                    (&slide.name, &slide.entries, own)
                }
                _ => continue,
            };
            if let Ok(Some(mass)) = own {
                self.model.bodies[body].masses.push(mass);
            }
            for entry in entries {
                if let Some(place) = &entry.at
                    && entry.name.text == "mass"
                    && let Ok(mass) = self.point_mass(body, name, place, entry)
                {
                    self.model.bodies[body].masses.push(mass);
                }
            }
        }
    }

    fn link_mass(
        &mut self,
        body: BodyId,
        name: &Name,
        entries: &[Entry],
    ) -> Resolved<Option<Mass>> {
        let BodyKind::Link(link) = &self.model.bodies[body].kind else {
            return Err(Reported);
        };
        let length = link.length;
        let owner = Owner::of_link(&name.text, link.symbol.as_deref(), name.span);
        let section = match first(entries, "section") {
            Some(entry) => self.section(&entry.value).map(Some),
            None => Ok(None),
        };
        let given = self.given(name, entries, "mass", wanted::MASS);
        let inertia = self.given(name, entries, "inertia", wanted::INERTIA);
        let com = match first(entries, "com") {
            Some(entry) => self.local(&entry.value, "`com`").map(Some),
            None => Ok(None),
        };
        let (section, given, inertia, com) = (section?, given?, inertia?, com?);
        let mass = self.link_mass_value(name, entries, given, section, length)?;
        let Some((mass, span)) = mass else {
            if let Some(inertia) = inertia {
                let center = self.center(com, length, &owner);
                let inertia = self.name_inertia(inertia, &owner);
                let mass = self.model.graph.zero();
                return Ok(Some(Mass {
                    mass,
                    center,
                    inertia,
                    span: name.span,
                }));
            }
            if let Some(entry) = first(entries, "com") {
                let message = format!("`{}` has a centre of mass, but no mass", name.text);
                let hint = "write `mass = …`, or `section` and `density`";
                return Err(self.error(entry.name.span, message, hint));
            }
            return Ok(None);
        };
        let mass = self.name_quantity("m", &owner, mass, Dimension::MASS, "mass");
        let center = self.center(com, length, &owner);
        let inertia = match inertia {
            Some(inertia) => inertia,
            None => self.bar_inertia(mass, length, section),
        };
        if section.is_none() && first(entries, "inertia").is_none() {
            let at = if com.is_none() {
                ", with its centre at mid-length"
            } else {
                ""
            };
            self.model.notes.push(Note {
                subject: name.text.clone(),
                words: format!("has the inertia of a slender bar{at}"),
            });
        }
        let inertia = self.name_inertia(inertia, &owner);
        Ok(Some(Mass {
            mass,
            center,
            inertia,
            span,
        }))
    }

    fn name_inertia(&mut self, inertia: Expr, owner: &Owner) -> Expr {
        let meaning = "moment of inertia about the centre of mass";
        self.name_quantity("I", owner, inertia, Dimension::INERTIA, meaning)
    }

    /// The mass of a link: given, or of its section and density.
    fn link_mass_value(
        &mut self,
        name: &Name,
        entries: &[Entry],
        mass: Option<Expr>,
        section: Option<Section>,
        length: Expr,
    ) -> Resolved<Option<(Expr, Span)>> {
        let density = self.given(name, entries, "density", wanted::DENSITY)?;
        let span = |entry: &str| first(entries, entry).map_or(name.span, |e| e.name.span);
        match (mass, density, section) {
            (Some(mass), None, _) => Ok(Some((mass, span("mass")))),
            (None, None, _) => Ok(None),
            (None, Some(density), Some(section)) => {
                let area = self.area(section);
                let mass = self.model.graph.product(&[density, area, length]);
                Ok(Some((mass, span("density"))))
            }
            (None, Some(_), None) => {
                let message = format!("`{}` has a density, but no section", name.text);
                let hint = "write `section = rect(width, height)`, or give its `mass`";
                Err(self.error(span("density"), message, hint))
            }
            (Some(_), Some(_), _) => {
                let message = format!("`{}` has both a mass and a density", name.text);
                Err(self.error(span("density"), message, "remove one of the two"))
            }
        }
    }

    fn given(
        &mut self,
        owner: &Name,
        entries: &[Entry],
        name: &str,
        wanted: wanted::Wanted,
    ) -> Resolved<Option<Expr>> {
        let Some(entry) = first(entries, name) else {
            return Ok(None);
        };
        let what = format!("`{name}` of `{}`", owner.text);
        let value = self.quantity(&entry.value, wanted, &what, Scope::Params)?;
        self.not_negative(value, &entry.value, &what)?;
        Ok(Some(value))
    }

    /// Centre of mass: as given, else at mid-length.
    fn center(&mut self, given: Option<Local>, length: Expr, owner: &Owner) -> Local {
        let (distance, angle) = match given {
            Some(local @ (Local::Origin | Local::Cartesian(..))) => return local,
            Some(Local::Polar(distance, angle)) => (distance, angle),
            None => {
                let half = Rational::new(1.into(), 2.into());
                let g = &mut self.model.graph;
                (g.scale(length, half), g.zero())
            }
        };
        let meaning = "distance of the centre of mass from the first end";
        let distance = self.name_quantity("r", owner, distance, Dimension::LENGTH, meaning);
        let angle = if self.model.graph.is_zero(angle) {
            angle
        } else {
            let meaning = "direction of the centre of mass off the line";
            self.name_quantity("β", owner, angle, Dimension::NONE, meaning)
        };
        Local::Polar(distance, angle)
    }

    fn section(&mut self, value: &Expression) -> Resolved<Section> {
        if let ExpressionKind::Call(call) = &value.kind {
            let lengths = |given: &[Given]| -> Vec<Expr> {
                given
                    .iter()
                    .filter_map(|g| g.scalar().map(|scalar| scalar.expr))
                    .collect()
            };
            for signature in [RECT, CIRCLE] {
                if call.name.text != signature.name {
                    continue;
                }
                let given = self.arguments(call, &signature, Scope::Params)?;
                for (length, argument) in lengths(&given).iter().zip(&call.arguments) {
                    self.positive(*length, &argument.value, "a size of a section")?;
                }
                return match lengths(&given)[..] {
                    [width, height] => Ok(Section::Rect(width, height)),
                    [diameter] => Ok(Section::Circle(diameter)),
                    _ => Err(Reported),
                };
            }
        }
        Err(self.error(
            value.span,
            "this is no section",
            "a section is `rect(width, height)`, width out of plane, or `circle(diameter)`",
        ))
    }

    fn area(&mut self, section: Section) -> Expr {
        let g = &mut self.model.graph;
        match section {
            Section::Rect(width, height) => g.mul(width, height),
            Section::Circle(diameter) => {
                let (pi, square) = (g.pi(), g.powi(diameter, 2));
                let disc = g.mul(pi, square);
                g.scale(disc, Rational::new(1.into(), 4.into()))
            }
        }
    }

    /// Moment of inertia of a straight bar about its centre: m (l² + h²)/12 for a rectangular
    /// section of height h in plane, m (l²/12 + d²/16) for a round one, m l²/12 for a slender one.
    fn bar_inertia(&mut self, mass: Expr, length: Expr, section: Option<Section>) -> Expr {
        let g = &mut self.model.graph;
        let twelfth = Rational::new(1.into(), 12.into());
        let squares = match section {
            None => g.powi(length, 2),
            Some(Section::Rect(_, height)) => {
                let (l2, h2) = (g.powi(length, 2), g.powi(height, 2));
                g.add(l2, h2)
            }
            Some(Section::Circle(diameter)) => {
                let (l2, d2) = (g.powi(length, 2), g.powi(diameter, 2));
                let d2 = g.scale(d2, Rational::new(3.into(), 4.into()));
                g.add(l2, d2)
            }
        };
        let product = g.mul(mass, squares);
        g.scale(product, twelfth)
    }

    fn slide_mass(&mut self, name: &Name, entries: &[Entry]) -> Resolved<Option<Mass>> {
        let owner = Owner::of_name(&name.text, name.span);
        let mass = self.given(name, entries, "mass", wanted::MASS)?;
        let inertia = self.given(name, entries, "inertia", wanted::INERTIA)?;
        let zero = self.model.graph.zero();
        let center = match first(entries, "com") {
            Some(entry) => self.local(&entry.value, "`com`")?,
            None => Local::Cartesian(zero, zero),
        };
        if mass.is_none() && inertia.is_none() {
            return Ok(None);
        }
        let span = first(entries, "mass").map_or(name.span, |entry| entry.name.span);
        let mass = match mass {
            Some(mass) => self.name_quantity("m", &owner, mass, Dimension::MASS, "mass"),
            None => zero,
        };
        let inertia = match inertia {
            Some(inertia) => self.name_inertia(inertia, &owner),
            None => zero,
        };
        Ok(Some(Mass {
            mass,
            center,
            inertia,
            span,
        }))
    }

    fn point_mass(
        &mut self,
        body: BodyId,
        name: &Name,
        place: &Name,
        entry: &Entry,
    ) -> Resolved<Mass> {
        let what = format!("the mass at `{}`", place.text);
        let mass = self.quantity(&entry.value, wanted::MASS, &what, Scope::Params)?;
        self.not_negative(mass, &entry.value, &what)?;
        let Some(center) = self.on_body(&place.text, body) else {
            self.point(place)?;
            let message = format!("`{}` is not on `{}`", place.text, name.text);
            let hint = format!("name one of its ends, or a point placed `on {}`", name.text);
            return Err(self.error(place.span, message, hint));
        };
        let owner = Owner::of_name(&place.text, entry.name.span);
        let mass = self.name_quantity("m", &owner, mass, Dimension::MASS, "point mass");
        Ok(Mass {
            mass,
            center,
            inertia: self.model.graph.zero(),
            span: entry.name.span,
        })
    }
}

fn first<'e>(entries: &'e [Entry], name: &str) -> Option<&'e Entry> {
    entries
        .iter()
        .find(|entry| entry.name.text == name && entry.at.is_none())
}
