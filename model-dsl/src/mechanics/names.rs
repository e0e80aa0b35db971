//! Names of derived quantities: as the article has them, unless the user took the name.

use std::collections::HashSet;

use crate::notation::latex_of;
use crate::symbolic::{Graph, Symbol};

/// Names in use.
#[derive(Clone, Debug)]
pub(crate) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// Names that the symbols of a graph use already.
    pub fn new(graph: &Graph) -> Self {
        let used = graph.symbol_texts().map(str::to_owned).collect();
        Self { used }
    }

    /// A name that nobody uses yet: the preferred one, or it with a number.
    pub fn free(&mut self, preferred: &str) -> String {
        let mut name = preferred.to_owned();
        let mut number = 2;
        while !self.used.insert(name.clone()) {
            name = format!("{preferred}_{number}");
            number += 1;
        }
        name
    }

    /// A new symbol by that name.
    pub fn symbol(&mut self, graph: &mut Graph, preferred: &str) -> Symbol {
        let name = self.free(preferred);
        let latex = latex_of(&name);
        graph.symbol(name, latex)
    }

    /// A new symbol with LaTeX of its own.
    pub fn symbol_with_latex(&mut self, graph: &mut Graph, preferred: &str, latex: &str) -> Symbol {
        let name = self.free(preferred);
        graph.symbol(name, latex)
    }
}

/// Letters that the first part of a name may have for a dot over the first to be read as the
/// dot over all: `ẋp` is, `ėxtension` is not.
const DOTTED: usize = 2;

/// `φ1` with `mark` over its first letter: dots for rates. A word gets `d(word)/dt` instead.
pub(crate) fn accented(name: &str, mark: char) -> String {
    let first = name.split('_').next().unwrap_or_default();
    if first.chars().filter(|c| c.is_alphabetic()).count() > DOTTED {
        let power = if mark == '\u{308}' { "²" } else { "" };
        return format!("d{power}({name})/dt{power}");
    }
    let mut letters = name.chars();
    match letters.next() {
        Some(first) => format!("{first}{mark}{}", letters.as_str()),
        None => String::new(),
    }
}

/// LaTeX of an accented name: `\dot{\varphi}_1`.
pub(crate) fn accented_latex(name: &str, accent: &str) -> String {
    let latex = latex_of(name);
    match latex.find('_') {
        Some(at) => format!("\\{accent}{{{}}}{}", &latex[..at], &latex[at..]),
        None => format!("\\{accent}{{{latex}}}"),
    }
}

/// What stands after the first letter of a symbol: `1` of `φ1`.
pub(crate) fn subscript(symbol: &str) -> &str {
    let mut letters = symbol.chars();
    letters.next();
    letters.as_str().trim_start_matches('_')
}
