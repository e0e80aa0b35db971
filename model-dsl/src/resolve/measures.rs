//! Quantities of the moving mechanism by their names: `stage.v`, `coupler.C.x`, `energy.total`.

use super::expression::{Scalar, Scope};
use super::names::{Named, there_is};
use super::{Reported, Resolved, Resolver};
use crate::model::{BodyId, BodyKind, EnergyKind, Measure, MeasureUse};
use crate::notation::latex_of;
use crate::source::Span;
use crate::suggest::closest;
use crate::syntax::tree::{Name, Path};
use crate::units::Dimension;

const ENERGIES: &[(&str, &str, EnergyKind, Dimension)] = &[
    ("energy", "kinetic", EnergyKind::Kinetic, Dimension::ENERGY),
    (
        "energy",
        "potential",
        EnergyKind::Potential,
        Dimension::ENERGY,
    ),
    ("energy", "total", EnergyKind::Total, Dimension::ENERGY),
    (
        "energy",
        "dissipated",
        EnergyKind::Dissipated,
        Dimension::ENERGY,
    ),
    (
        "energy",
        "supplied",
        EnergyKind::Supplied,
        Dimension::ENERGY,
    ),
    (
        "power",
        "dissipated",
        EnergyKind::DissipatedPower,
        Dimension::POWER,
    ),
    (
        "power",
        "supplied",
        EnergyKind::SuppliedPower,
        Dimension::POWER,
    ),
];

type Found = (Measure, Dimension);

impl Resolver<'_> {
    /// A measure as a value in an expression.
    pub(super) fn measure_value(&mut self, path: &Path, scope: Scope) -> Resolved<Scalar> {
        let (measure, dimension) = self.measure(path)?;
        let name = path.text();
        if matches!(measure, Measure::Energy(_)) {
            let reason = format!("`{name}` is of the whole mechanism");
            self.allow(scope, Scope::Results, path.span, &reason)?;
        } else {
            let reason = format!("`{name}` changes as the mechanism moves");
            self.allow(scope, Scope::Motion, path.span, &reason)?;
        }
        let symbol = match self.measures.get(&measure) {
            Some(&symbol) => symbol,
            None => {
                let symbol = self.model.graph.symbol(name.as_str(), latex_of(&name));
                self.measures.insert(measure, symbol);
                self.model.measures.push(MeasureUse {
                    symbol,
                    measure,
                    name,
                    span: path.span,
                });
                symbol
            }
        };
        Ok(Scalar {
            expr: self.model.graph.of(symbol),
            dimension,
            zero: false,
        })
    }

    /// What a name with dots stands for.
    pub(super) fn measure(&mut self, path: &Path) -> Resolved<Found> {
        let (first, rest) = path.parts.split_first().ok_or(Reported)?;
        if matches!(first.text.as_str(), "energy" | "power") {
            return self.energy(first, rest, path.span);
        }
        match (self.names.get(&first.text), rest) {
            (Some(Named::Link(body) | Named::Slide(body)), [last]) => {
                self.body_measure(body, first, last)
            }
            (Some(Named::Link(body) | Named::Slide(body)), [point, last]) => {
                if self.on_body(&point.text, body).is_none() {
                    let message = format!("`{}` has no point `{}`", first.text, point.text);
                    let places = self.points_of(body);
                    let hint = match closest(&point.text, places.iter().map(String::as_str)) {
                        Some(near) => format!("did you mean `{near}`?"),
                        None => format!("its points are {}", crate::syntax::listed(&places)),
                    };
                    return Err(self.error(point.span, message, hint));
                }
                self.point_measure(point, last)
            }
            (Some(Named::Point), [last]) => self.point_measure(first, last),
            (Some(Named::Point), [.., last]) => self.hinge_measure(path, first, last),
            (Some(Named::Spring(spring)), [last]) => {
                let names = [
                    (
                        "extension",
                        Measure::SpringExtension(spring),
                        Dimension::LENGTH,
                    ),
                    ("force", Measure::SpringForce(spring), Dimension::FORCE),
                ];
                self.one_of(first, last, &names)
            }
            (Some(Named::Contact(contact)), [last]) => self.contact_measure(contact, first, last),
            (Some(Named::Quantity(..) | Named::Pending(_) | Named::Symbol), [last, ..]) => {
                let message = format!("`{}` has no quantities of its own", first.text);
                let hint = format!("write `{}` alone", first.text);
                Err(self.error(last.span, message, hint))
            }
            (Some(_), _) => {
                let message = format!("`{}` is no quantity", path.text());
                Err(self.error(path.span, message, "remove a part of the name"))
            }
            (None, _) => {
                let mut candidates =
                    self.names_where(|named| !matches!(named, Named::Quantity(..)));
                candidates.extend(["energy".to_owned(), "power".to_owned()]);
                let what = "body, point, spring or contact";
                let hint = "declare it first";
                Err(self.unknown(first.span, &first.text, what, &candidates, hint))
            }
        }
    }

    /// One of named measures of `owner`, with a suggestion.
    fn one_of(
        &mut self,
        owner: &Name,
        last: &Name,
        names: &[(&str, Measure, Dimension)],
    ) -> Resolved<Found> {
        if let Some(&(_, measure, dimension)) = names.iter().find(|(name, _, _)| *name == last.text)
        {
            return Ok((measure, dimension));
        }
        let known: Vec<&str> = names.iter().map(|(name, _, _)| *name).collect();
        Err(self.no_measure(owner, last, &known))
    }

    fn no_measure(&mut self, owner: &Name, last: &Name, known: &[&str]) -> Reported {
        let paths: Vec<String> = known
            .iter()
            .map(|name| format!("{}.{name}", owner.text))
            .collect();
        let hint = match closest(&last.text, known.iter().copied()) {
            Some(near) => format!("did you mean `{}.{near}`?", owner.text),
            None => there_is(&paths),
        };
        let message = format!("`{}` has no `{}`", owner.text, last.text);
        self.error(last.span, message, hint)
    }

    fn energy(&mut self, first: &Name, rest: &[Name], span: Span) -> Resolved<Found> {
        let [last] = rest else {
            let message = format!("`{}` alone is no quantity", first.text);
            return Err(self.error(span, message, "write `energy.total`"));
        };
        let found = ENERGIES
            .iter()
            .find(|(owner, name, _, _)| *owner == first.text && *name == last.text);
        match found {
            Some(&(_, _, kind, dimension)) => Ok((Measure::Energy(kind), dimension)),
            None => {
                let known: Vec<&str> = ENERGIES
                    .iter()
                    .filter(|(owner, ..)| *owner == first.text)
                    .map(|(_, name, _, _)| *name)
                    .collect();
                Err(self.no_measure(first, last, &known))
            }
        }
    }

    fn body_measure(&mut self, body: BodyId, name: &Name, last: &Name) -> Resolved<Found> {
        match self.names.get(&name.text) {
            Some(Named::Slide(_)) => {
                let names = [
                    ("x", Measure::Position(body), Dimension::LENGTH),
                    ("travel", Measure::Travel(body), Dimension::LENGTH),
                    ("v", Measure::Velocity(body), Dimension::VELOCITY),
                ];
                self.one_of(name, last, &names)
            }
            _ => {
                let names = [
                    ("angle", Measure::Angle(body), Dimension::NONE),
                    ("rate", Measure::AngleRate(body), Dimension::ANGULAR_RATE),
                ];
                if self.on_body(&last.text, body).is_some() {
                    let message = format!("`{}.{}` is a point, not a value", name.text, last.text);
                    let hint = format!("write `{}.{}.x`", name.text, last.text);
                    return Err(self.error(last.span, message, hint));
                }
                self.one_of(name, last, &names)
            }
        }
    }

    fn point_measure(&mut self, name: &Name, last: &Name) -> Resolved<Found> {
        let point = self.point(name)?;
        let components = [
            ("x", Measure::PointPosition(point, 0), Dimension::LENGTH),
            ("y", Measure::PointPosition(point, 1), Dimension::LENGTH),
            ("vx", Measure::PointVelocity(point, 0), Dimension::VELOCITY),
            ("vy", Measure::PointVelocity(point, 1), Dimension::VELOCITY),
        ];
        let hinges: Vec<usize> = self
            .model
            .hinges
            .iter()
            .enumerate()
            .filter(|(_, hinge)| self.model.pins[hinge.pin].name == name.text)
            .map(|(index, _)| index)
            .collect();
        if !matches!(last.text.as_str(), "torque" | "deflection") {
            let mut known = components.to_vec();
            if let [hinge] = hinges[..] {
                known.push(("torque", Measure::HingeTorque(hinge), Dimension::TORQUE));
                known.push(("deflection", Measure::HingeAngle(hinge), Dimension::NONE));
            }
            return self.one_of(name, last, &known);
        }
        match hinges[..] {
            [hinge] if last.text == "torque" => {
                Ok((Measure::HingeTorque(hinge), Dimension::TORQUE))
            }
            [hinge] => Ok((Measure::HingeAngle(hinge), Dimension::NONE)),
            [] if self.failed() => Err(Reported),
            [] => {
                let message = format!("there is no hinge at `{}`", name.text);
                let hint = format!("declare it with `hinge at {} {{ … }}`", name.text);
                Err(self.error(last.span, message, hint))
            }
            [first, ..] => {
                let message = format!("there are several hinges at `{}`", name.text);
                let hint = format!(
                    "say which: `{}.{}`",
                    self.model.hinges[first].name, last.text
                );
                Err(self.error(last.span, message, hint))
            }
        }
    }

    /// `B.crank.coupler.torque`: a hinge where more than two bodies meet.
    fn hinge_measure(&mut self, path: &Path, first: &Name, last: &Name) -> Resolved<Found> {
        let parts = &path.parts[..path.parts.len() - 1];
        let words: Vec<&str> = parts.iter().map(|part| part.text.as_str()).collect();
        let name = words.join(".");
        let found = self
            .model
            .hinges
            .iter()
            .position(|hinge| hinge.name == name);
        match found {
            Some(hinge) => {
                let names = [
                    ("torque", Measure::HingeTorque(hinge), Dimension::TORQUE),
                    ("deflection", Measure::HingeAngle(hinge), Dimension::NONE),
                ];
                self.one_of(first, last, &names)
            }
            None => {
                let known: Vec<String> = self
                    .model
                    .hinges
                    .iter()
                    .filter(|hinge| hinge.name.starts_with(&format!("{}.", first.text)))
                    .map(|hinge| hinge.name.clone())
                    .collect();
                let hint = if known.is_empty() {
                    "declare it with `hinge at POINT between BODY, BODY`".to_owned()
                } else {
                    there_is(&known)
                };
                Err(self.error(path.span, format!("there is no hinge `{name}`"), hint))
            }
        }
    }

    fn contact_measure(&mut self, contact: usize, name: &Name, last: &Name) -> Resolved<Found> {
        let mut names = vec![
            (
                "friction".to_owned(),
                Measure::ContactFriction(contact),
                Dimension::FORCE,
            ),
            (
                "normal".to_owned(),
                Measure::ContactNormal(contact),
                Dimension::FORCE,
            ),
            (
                "slip".to_owned(),
                Measure::ContactSlip(contact),
                Dimension::VELOCITY,
            ),
        ];
        let known = self
            .model
            .contacts
            .iter()
            .find(|known| known.name == name.text);
        match known {
            None if self.failed() => {}
            None => return Err(Reported),
            Some(known) => {
                for (index, state) in known.friction.states.iter().enumerate() {
                    let measure = Measure::ContactState(contact, index);
                    names.push((state.name.clone(), measure, state.dimension));
                }
            }
        }
        let names: Vec<(&str, Measure, Dimension)> =
            names.iter().map(|(n, m, d)| (n.as_str(), *m, *d)).collect();
        if known_missing(&names, last) && self.failed() {
            return Err(Reported);
        }
        self.one_of(name, last, &names)
    }

    /// Names of the points that a body has.
    fn points_of(&self, body: BodyId) -> Vec<String> {
        self.places
            .iter()
            .filter(|place| place.members.iter().any(|member| member.body == body))
            .map(|place| place.name.clone())
            .collect()
    }

    /// The body whose coordinate a measure is, if it is one.
    pub(super) fn coordinate_body(&self, measure: Measure) -> Option<BodyId> {
        match measure {
            Measure::Angle(body) | Measure::Travel(body) | Measure::Position(body) => {
                (!matches!(self.model.bodies[body].kind, BodyKind::Ground)).then_some(body)
            }
            _ => None,
        }
    }
}

fn known_missing(names: &[(&str, Measure, Dimension)], last: &Name) -> bool {
    names.iter().all(|(name, _, _)| *name != last.text)
}
