//! The one space of names: quantities, bodies, points, springs, contacts.

use std::collections::BTreeMap;

use super::links::symbol_name;
use super::{Reported, Resolved, Resolver};
use crate::model::{BodyId, GROUND};
use crate::source::Span;
use crate::suggest::closest;
use crate::symbolic::Symbol;
use crate::syntax::tree::{File, ItemKind, Name};
use crate::units::Dimension;

/// What a name stands for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Named {
    /// A quantity that was resolved; the words say what kind it is.
    Quantity(Symbol, Dimension, Varies, &'static str),
    /// A quantity that is not resolved (yet): what kind it is.
    Pending(&'static str),
    /// A link.
    Link(BodyId),
    /// A slide.
    Slide(BodyId),
    /// A point.
    Point,
    /// A spring or stack.
    Spring(usize),
    /// A contact.
    Contact(usize),
    /// The name of a link's angle in equations.
    Symbol,
}

/// What makes a quantity change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Varies {
    /// Nothing but its setting: a param or `let`.
    Params,
    /// Time, motion or a signal from outside.
    Motion,
}

impl Named {
    /// What kind of thing it is, in words.
    pub(super) fn kind(self) -> &'static str {
        match self {
            Named::Quantity(_, _, _, kind) | Named::Pending(kind) => kind,
            Named::Link(_) => "a link",
            Named::Slide(_) => "a slide",
            Named::Point => "a point",
            Named::Spring(_) => "a spring",
            Named::Contact(_) => "a contact",
            Named::Symbol => "the symbol of a link's angle",
        }
    }
}

/// Names with what they stand for and where they were declared.
#[derive(Default)]
pub(super) struct Names {
    known: BTreeMap<String, (Named, Span)>,
}

impl Names {
    pub(super) fn get(&self, name: &str) -> Option<Named> {
        self.known.get(name).map(|&(named, _)| named)
    }

    pub(super) fn contains(&self, name: &str) -> bool {
        self.known.contains_key(name)
    }

    pub(super) fn set(&mut self, name: &str, named: Named, span: Span) {
        self.known.insert(name.to_owned(), (named, span));
    }

    fn span(&self, name: &str) -> Option<Span> {
        self.known.get(name).map(|&(_, span)| span)
    }

    /// Names of things that `wanted` accepts.
    pub(super) fn of_kind(&self, wanted: impl Fn(Named) -> bool) -> impl Iterator<Item = &str> {
        self.known
            .iter()
            .filter(move |(_, (named, _))| wanted(*named))
            .map(|(name, _)| name.as_str())
    }
}

/// Words that cannot be names of anything.
const RESERVED: &[&str] = &[
    "t", "pi", "if", "then", "else", "and", "or", "exact", "ground", "energy", "power",
];

impl Resolver<'_> {
    /// Declares the names of everything but points, which bodies share.
    pub(super) fn declare(&mut self, file: &File) {
        let (mut bodies, mut springs, mut contacts) = (GROUND, 0, 0);
        for item in &file.items {
            match &item.kind {
                ItemKind::Params(list) => {
                    for declaration in list {
                        self.declare_name(&declaration.name, Named::Pending("a param"));
                    }
                }
                ItemKind::Lets(list) => {
                    for declaration in list {
                        self.declare_name(&declaration.name, Named::Pending("a `let`"));
                    }
                }
                ItemKind::Drives(list) => {
                    for declaration in list {
                        self.declare_name(&declaration.name, Named::Pending("a drive"));
                    }
                }
                ItemKind::Input(input) => {
                    self.declare_name(&input.name, Named::Pending("an input"));
                }
                ItemKind::Link(link) => {
                    bodies += 1;
                    self.declare_name(&link.name, Named::Link(bodies));
                    for entry in &link.entries {
                        if entry.name.text == "symbol"
                            && let Some(name) = symbol_name(&entry.value)
                        {
                            self.declare_name(name, Named::Symbol);
                        }
                    }
                }
                ItemKind::Slide(slide) => {
                    bodies += 1;
                    self.declare_name(&slide.name, Named::Slide(bodies));
                }
                ItemKind::Spring(spring) => {
                    self.declare_name(&spring.name, Named::Spring(springs));
                    springs += 1;
                }
                ItemKind::Contact(contact) => {
                    self.declare_name(&contact.name, Named::Contact(contacts));
                    contacts += 1;
                }
                ItemKind::Model(_)
                | ItemKind::Outputs(_)
                | ItemKind::Grounds(_)
                | ItemKind::DrawnPoints(_)
                | ItemKind::Point(_)
                | ItemKind::Set(_)
                | ItemKind::Hinge(_)
                | ItemKind::Gravity(_)
                | ItemKind::Force(..)
                | ItemKind::Torque(_)
                | ItemKind::Initials(_)
                | ItemKind::Start(_)
                | ItemKind::Coordinates(_)
                | ItemKind::Stop(..)
                | ItemKind::Component(_)
                | ItemKind::Repeat(_)
                | ItemKind::Part(_)
                | ItemKind::Use(_)
                | ItemKind::Constants(_)
                | ItemKind::Given(_) => {}
            }
        }
    }

    /// Declares one name; a name that is taken keeps its first meaning.
    pub(super) fn declare_name(&mut self, name: &Name, named: Named) {
        if self.check_reserved(name).is_err() {
            return;
        }
        match self.names.span(&name.text) {
            None => self.names.set(&name.text, named, name.span),
            Some(earlier) => {
                let _ = self.taken(name, earlier);
            }
        }
    }

    /// Reports that a name is taken.
    pub(super) fn taken(&mut self, name: &Name, earlier: Span) -> Reported {
        let what = self
            .names
            .get(&name.text)
            .map_or("something else", Named::kind);
        let diagnostic = self
            .diagnostic(name.span, format!("`{}` is already {what}", name.text))
            .hint("give one of the two another name: all things in a model share one list of names")
            .related(self.site(earlier), "declared here");
        self.report(name.span, diagnostic);
        Reported
    }

    pub(super) fn check_reserved(&mut self, name: &Name) -> Resolved<()> {
        let function = super::functions::is_function(&name.text);
        if !function && !RESERVED.contains(&name.text.as_str()) {
            return Ok(());
        }
        let what = match name.text.as_str() {
            "t" => "time",
            "pi" => "the circle constant",
            "ground" => "the body that never moves",
            "energy" | "power" => "the energies and powers of the whole mechanism",
            _ if function => "a function",
            _ => "a word of the language",
        };
        let message = format!("`{}` is {what} and cannot name anything else", name.text);
        Err(self.error(name.span, message, "choose another name"))
    }

    /// Reports an unknown name, with a suggestion among `candidates`.
    pub(super) fn unknown(
        &mut self,
        span: Span,
        text: &str,
        what: &str,
        candidates: &[String],
        otherwise: &str,
    ) -> Reported {
        let hint = match closest(text, candidates.iter().map(String::as_str)) {
            Some(near) => format!("did you mean `{near}`?"),
            None if candidates.is_empty() || candidates.len() > 12 => otherwise.to_owned(),
            None => there_is(candidates),
        };
        let inner = self.model.source.within(span);
        let hint = match text.rsplit_once('.') {
            Some((part, word)) if !inner.is_empty() && self.names.contains(word) => format!(
                "a component sees only what it declares: give `{word}` to `{part}` as an argument"
            ),
            _ => hint,
        };
        if self.partial && (!hint.starts_with("did you mean") || !inner.is_empty()) {
            // It may be declared by an item that could not be read.
            return Reported;
        }
        self.error(span, format!("there is no {what} `{text}`"), hint)
    }

    /// The body of that name; `ground` included.
    pub(super) fn body(&mut self, name: &Name) -> Resolved<BodyId> {
        if name.text == "ground" {
            return Ok(GROUND);
        }
        match self.names.get(&name.text) {
            Some(Named::Link(body) | Named::Slide(body)) => Ok(body),
            Some(other) => {
                let message = format!("`{}` is {}, not a body", name.text, other.kind());
                Err(self.error(name.span, message, "name a link, a slide or `ground`"))
            }
            None => {
                let candidates =
                    self.names_where(|named| matches!(named, Named::Link(_) | Named::Slide(_)));
                Err(self.unknown(
                    name.span,
                    &name.text,
                    "body",
                    &candidates,
                    "declare it with `link` or `slide`",
                ))
            }
        }
    }

    pub(super) fn names_where(&self, wanted: impl Fn(Named) -> bool) -> Vec<String> {
        if self.full() {
            return Vec::new();
        }
        self.names.of_kind(wanted).map(str::to_owned).collect()
    }

    /// Name of a body.
    pub(super) fn body_name(&self, body: BodyId) -> &str {
        &self.model.bodies[body].name
    }
}

/// What there is instead.
pub(super) fn there_is(names: &[String]) -> String {
    let verb = if names.len() == 1 { "is" } else { "are" };
    format!("there {verb} {}", crate::syntax::listed(names))
}
