//! What stands in braces: entries by name, each at most once.

use super::{Resolved, Resolver};
use crate::suggest::closest;
use crate::syntax::tree::{Entry, Expression};

/// Entries of one item, looked up by name.
pub(super) struct Entries<'e> {
    found: Vec<&'e Entry>,
    /// Known names that misspelt entries may have meant.
    meant: Vec<String>,
    /// Entries of the form `mass at P = …`.
    pub point_masses: Vec<&'e Entry>,
}

impl<'e> Entries<'e> {
    pub(super) fn get(&self, name: &str) -> Option<&'e Entry> {
        self.found
            .iter()
            .copied()
            .find(|entry| entry.name.text == name)
    }

    /// Whether an entry that is missing was probably given under a wrong name.
    pub(super) fn misspelt(&self, name: &str) -> bool {
        self.meant.iter().any(|meant| meant == name)
    }

    pub(super) fn value(&self, name: &str) -> Option<&'e Expression> {
        self.get(name).map(|entry| &entry.value)
    }
}

impl Resolver<'_> {
    /// Checks entries against the names that `owner` knows: `known` for all, of which those in
    /// `exact` may be exact.
    pub(super) fn entries<'e>(
        &mut self,
        owner: &str,
        entries: &'e [Entry],
        known: &[&str],
        may_be_exact: &[&str],
        takes_point_masses: bool,
    ) -> Entries<'e> {
        let mut result = Entries {
            found: Vec::new(),
            meant: Vec::new(),
            point_masses: Vec::new(),
        };
        for entry in entries {
            let name = entry.name.text.as_str();
            if entry.at.is_some() && name == "mass" && takes_point_masses {
                if let Some(span) = entry.exact {
                    let hint = "remove `exact`";
                    self.error(span, "every mass is exact", hint);
                }
                result.point_masses.push(entry);
                continue;
            }
            if !known.contains(&name) {
                let hint = match closest(name, known.iter().copied()) {
                    Some(near) => {
                        result.meant.push(near.to_owned());
                        format!("did you mean `{near}`?")
                    }
                    None if known.is_empty() => "it takes nothing in braces".to_owned(),
                    None => format!("it takes {}", crate::syntax::listed(known)),
                };
                self.error(entry.name.span, format!("{owner} has no `{name}`"), hint);
                continue;
            }
            if self.no_place(entry).is_err() {
                continue;
            }
            if let Some(span) = entry.exact
                && !may_be_exact.contains(&name)
            {
                let hint = match may_be_exact {
                    [] => "remove `exact`".to_owned(),
                    _ => format!(
                        "only {} may be a guess or exact",
                        crate::syntax::listed(may_be_exact)
                    ),
                };
                self.error(span, format!("`{name}` is exact as it is"), hint);
            }
            if let Some(earlier) = result.get(name) {
                let diagnostic = self
                    .diagnostic(entry.name.span, format!("`{name}` is given twice"))
                    .hint("remove one of the two")
                    .related(self.site(earlier.name.span), "given here first");
                self.report(entry.name.span, diagnostic);
                continue;
            }
            result.found.push(entry);
        }
        result
    }

    /// Checks that an entry says no `at`.
    pub(super) fn no_place(&mut self, entry: &Entry) -> Resolved<()> {
        match &entry.at {
            None => Ok(()),
            Some(place) => {
                let message = format!("`{}` has no place", entry.name.text);
                let hint = "only `mass at POINT = …` of a link or slide names one";
                Err(self.error(place.span, message, hint))
            }
        }
    }
}
