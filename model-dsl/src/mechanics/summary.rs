//! Summary: what `check` tells about a mechanism.

use crate::equations::{Fact, ShownUnit};
use crate::model::{BodyId, BodyKind, Guess};
use crate::structure::held_parallel;

use super::Derivation;
use super::inertia::Inertia;

impl Derivation<'_> {
    /// Bodies, joints, loops, degrees of freedom, coordinates, closed angles.
    pub(super) fn summary(&mut self, inertia: &Inertia) -> Vec<Fact> {
        let mut facts = Vec::new();
        let mut fact = |subject: &str, words: String, values| {
            facts.push(Fact {
                subject: subject.to_owned(),
                words,
                values,
            });
        };
        let list = |names: Vec<String>| {
            if names.is_empty() {
                "none".to_owned()
            } else {
                names.join(", ")
            }
        };
        let links = self.bodies(|kind| matches!(kind, BodyKind::Link(_)));
        let slides = self.bodies(|kind| matches!(kind, BodyKind::Slide(_)));
        fact(
            "links",
            format!("{}: {}", links.len(), list(links)),
            Vec::new(),
        );
        fact(
            "slides",
            format!("{}: {}", slides.len(), list(slides)),
            Vec::new(),
        );
        let pins: Vec<String> = self
            .model
            .pins
            .iter()
            .map(|pin| {
                let members: Vec<&str> = pin
                    .members
                    .iter()
                    .filter(|(body, _)| !self.model.is_traced(*body))
                    .map(|(body, _)| self.model.bodies[*body].name.as_str())
                    .collect();
                (pin, members)
            })
            .filter(|(_, members)| members.len() > 1)
            .map(|(pin, members)| format!("{} ({})", pin.name, members.join(", ")))
            .collect();
        fact(
            "pins",
            format!("{}: {}", pins.len(), list(pins)),
            Vec::new(),
        );
        let loops: Vec<String> = self
            .structure
            .steps
            .iter()
            .flat_map(|step| step.ways())
            .map(|way| self.way_name(way))
            .collect();
        fact(
            "loops",
            format!("{}: {}", loops.len(), list(loops)),
            Vec::new(),
        );
        let freedom = self.coordinates.len();
        fact("degrees of freedom", freedom.to_string(), Vec::new());
        let parallel = held_parallel(self.model);
        for (index, coordinate) in self.coordinates.iter().enumerate() {
            let body = &self.model.bodies[coordinate.body];
            let reason = if self.structure.asked[index] {
                "as asked"
            } else if self.structure.in_loop(coordinate.body) {
                let is_passed = |body: BodyId| parallel[body] && self.structure.in_loop(body);
                let passed = !parallel[coordinate.body] && (1..coordinate.body).any(is_passed);
                match (self.structure.is_closed_form(), passed) {
                    (true, false) => {
                        "the first in the file with which every loop closes in closed form"
                    }
                    (true, true) => {
                        "the first in the file that is not held parallel and with which every loop closes in closed form"
                    }
                    (false, false) => "the first of its loops in the file",
                    (false, true) => "the first of its loops in the file that is not held parallel",
                }
            } else {
                "moves on its own"
            };
            let start = self.variable(coordinate.body).assembled;
            let (unit, held) = match &body.kind {
                BodyKind::Link(link) => (ShownUnit::Degree, held(link.angle)),
                BodyKind::Slide(slide) => (ShownUnit::Metre, held(slide.at)),
                BodyKind::Ground => (ShownUnit::Metre, "assembled"),
            };
            let [name, _] = self.model.coordinate_names(coordinate.body);
            fact(
                "coordinate",
                format!("{name} ({reason}), {held} at {{0}}"),
                vec![(start, unit)],
            );
        }
        let blocks: Vec<String> = inertia
            .blocks
            .iter()
            .map(|block| {
                let names: Vec<&str> = block
                    .iter()
                    .map(|&i| self.model.bodies[self.coordinates[i].body].name.as_str())
                    .collect();
                format!("[{}]", names.join(", "))
            })
            .collect();
        fact(
            "blocks coupled by inertia",
            format!("{}: {}", blocks.len(), blocks.join(" ")),
            Vec::new(),
        );
        let mut closed = Vec::new();
        for body in self.structure.steps.iter().flat_map(|step| step.unknowns()) {
            let assembled = self.variable(body).assembled;
            let (what, unit, guess) = match &self.model.bodies[body].kind {
                BodyKind::Link(link) => ("angle", ShownUnit::Degree, link.angle.value),
                BodyKind::Slide(slide) => ("position", ShownUnit::Metre, slide.at.value),
                BodyKind::Ground => continue,
            };
            let [name, _] = self.model.coordinate_names(body);
            let mut words = format!("{name} closes at {{0}}");
            let mut values = vec![(assembled, unit)];
            if let Some(guess) = guess {
                let off = self.g.sub(assembled, guess);
                words.push_str(&format!(", {{1}} from the drawn {what}"));
                values.push((off, unit));
            }
            closed.push(Fact {
                subject: format!("closed {what}"),
                words,
                values,
            });
        }
        facts.extend(closed);
        for note in &self.model.notes {
            facts.push(Fact {
                subject: "assumed".to_owned(),
                words: format!("`{}` {}", note.subject, note.words),
                values: Vec::new(),
            });
        }
        for kink in self.kinks.iter().filter(|kink| kink.jumps) {
            facts.push(Fact {
                subject: "note".to_owned(),
                words: format!(
                    "the drive `{}` may jump; a jump gives no impulse, dampers do not see it",
                    kink.name
                ),
                values: Vec::new(),
            });
        }
        facts
    }

    fn bodies(&self, wanted: impl Fn(&BodyKind) -> bool) -> Vec<String> {
        let bodies = self.model.bodies.iter().enumerate();
        bodies
            .filter(|(id, body)| wanted(&body.kind) && !self.model.is_traced(*id))
            .map(|(_, body)| body.name.clone())
            .collect()
    }
}

/// Where a coordinate is as assembled: nothing but its own value says it.
fn held(guess: Guess) -> &'static str {
    match (guess.value, guess.exact) {
        (Some(_), true) => "exact",
        (Some(_), false) => "not exact, so held as guessed",
        (None, _) => "assembled",
    }
}
