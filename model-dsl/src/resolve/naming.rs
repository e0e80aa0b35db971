//! Names for quantities that a model file gives as expressions, so that equations read `I1`, `r1`,
//! `l1` rather than what these are made of.

use super::Resolver;
use crate::model::Let;
use crate::notation::latex_of;
use crate::source::Span;
use crate::symbolic::Expr;
use crate::units::Dimension;

/// What a quantity belongs to.
pub(super) struct Owner {
    /// What is put behind the letter: `1` for a link whose angle is φ1, else `_crank`.
    suffix: String,
    /// The owner's name.
    name: String,
    span: Span,
}

impl Owner {
    /// An owner that is called by its name.
    pub(super) fn of_name(name: &str, span: Span) -> Self {
        Self {
            suffix: format!("_{}", name.replace('.', "_")),
            name: name.to_owned(),
            span,
        }
    }

    /// A link, called by the number or subscript of its angle's symbol if that has one.
    pub(super) fn of_link(name: &str, symbol: Option<&str>, span: Span) -> Self {
        let suffix = symbol.and_then(|symbol| {
            let start = match symbol.find('_') {
                Some(underscore) => underscore,
                None => symbol.trim_end_matches(|c: char| c.is_ascii_digit()).len(),
            };
            (start > 0 && start < symbol.len()).then(|| symbol[start..].to_owned())
        });
        Self {
            suffix: suffix.unwrap_or_else(|| format!("_{name}")),
            name: name.to_owned(),
            span,
        }
    }
}

impl Resolver<'_> {
    /// `value` as a symbol: itself if it is one already, else a new `let` named by `letter` and the
    /// owner.
    pub(super) fn name_quantity(
        &mut self,
        letter: &str,
        owner: &Owner,
        value: Expr,
        dimension: Dimension,
        meaning: &str,
    ) -> Expr {
        if self.model.graph.as_symbol(value).is_some() {
            return value;
        }
        let name = self.free_name(letter, owner);
        self.derived.insert(name.clone());
        let symbol = self.model.graph.symbol(name.as_str(), latex_of(&name));
        self.model.lets.push(Let {
            name,
            symbol,
            value,
            dimension,
            doc: format!("{meaning} of {}", owner.name),
            span: owner.span,
        });
        self.model.graph.of(symbol)
    }

    /// A name that neither the user nor another quantity has.
    fn free_name(&self, letter: &str, owner: &Owner) -> String {
        let taken = |name: &str| self.names.contains(name) || self.derived.contains(name);
        let short = format!("{letter}{}", owner.suffix);
        if !taken(&short) {
            return short;
        }
        let long = format!("{letter}_{}", owner.name.replace('.', "_"));
        if !taken(&long) {
            return long;
        }
        (2..)
            .map(|number| format!("{long}_{number}"))
            .find(|name| !taken(name))
            .unwrap_or(long)
    }
}
