//! What names mean inside a part and inside a turn of a repeat.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::files::Library;
use super::whole::indexed;
use crate::parts::hinges::CircularFormula;
use crate::source::Span;
use crate::syntax::Problem;
use crate::syntax::tree::{Item, ItemKind, Name, Path};

/// Longest row of parts that hand a point on to each other.
const LONGEST_ROW: usize = 1000;

/// Words that mean the same everywhere.
const EVERYWHERE: [&str; 5] = ["t", "pi", "ground", "energy", "power"];

/// A part, or the model itself.
#[derive(Default)]
pub(super) struct Instance {
    /// What its names start with: `left.`; nothing for the model.
    pub prefix: String,
    /// Where the part is named.
    pub span: Span,
    /// Names that stand for something outside.
    pub aliases: HashMap<String, Alias>,
}

/// What a name of a part stands for outside.
pub(super) struct Alias {
    /// The words of its name, indices evaluated.
    pub words: Vec<String>,
    /// The instance in which they are said.
    pub instance: usize,
    /// Where they are said.
    pub span: Span,
    /// Whether it is a point or body, not a quantity.
    pub point: bool,
}

/// Where items stand: in which instance, in which turns of repeats, and where their places are.
#[derive(Clone, Default)]
pub(super) struct Scope {
    /// The instance.
    pub instance: usize,
    /// Counters with their values, from the outside.
    pub counters: Vec<(String, i64, Span)>,
    /// What is added to written places.
    pub shift: usize,
}

/// All names.
pub(super) struct Names<'a> {
    pub library: &'a Library,
    /// The model first.
    pub instances: Vec<Instance>,
    /// Instances by the full name of the part.
    pub parts: BTreeMap<String, usize>,
    /// Bodies with points that they are said to have, and where.
    pub claims: Vec<(String, String, Span)>,
    pub problems: Vec<Problem>,
}

impl Names<'_> {
    /// The value of a counter or constant.
    pub fn number(&self, scope: &Scope, name: &str) -> Option<i64> {
        let counter = scope.counters.iter().rev().find(|(word, ..)| word == name);
        counter.map(|&(_, value, _)| value).or_else(|| {
            let constant = self.library.constants.get(name);
            constant.map(|&(value, _)| value)
        })
    }

    /// One word with its indices evaluated.
    pub fn word(&mut self, text: &str, span: Span, scope: &Scope) -> String {
        if !text.contains('[') {
            return text.to_owned();
        }
        match indexed(text, &|name| self.number(scope, name)) {
            Ok(word) => word,
            Err(message) => {
                let hint = "an index is a whole number of 0 or more, made of counters of `repeat`, \
                            constants and digits";
                let span = span.shifted(scope.shift);
                self.problems.push(Problem::new(message, span, hint));
                text.split('[').next().unwrap_or_default().to_owned()
            }
        }
    }

    /// The words of a name with dots, indices evaluated.
    pub fn words(&mut self, name: &Name, scope: &Scope) -> Vec<String> {
        let labels = name.text.split('.');
        labels
            .map(|label| self.word(label, name.span, scope))
            .collect()
    }

    /// A name that an item gives to something that it makes.
    pub fn declared(&mut self, name: &Name, scope: &Scope) -> Name {
        let word = self.word(&name.text, name.span, scope);
        let span = name.span.shifted(scope.shift);
        let counter = scope.counters.iter().find(|(known, ..)| *known == word);
        let constant = self.library.constants.get(&word);
        let number = counter.map(|(_, _, place)| (*place, "the counter of a `repeat`"));
        if let Some((place, what)) = number.or(constant.map(|(_, place)| (*place, "a constant"))) {
            self.taken(&word, span, what, place);
        }
        let instance = &self.instances[scope.instance];
        let text = match instance.aliases.get(&word) {
            Some(alias) if alias.point => {
                let (words, owner) = (alias.words.clone(), alias.instance);
                self.last(words, owner, span)
            }
            _ => format!("{}{word}", instance.prefix),
        };
        if let Some(&part) = self.parts.get(&text) {
            let earlier = self.instances[part].span;
            self.taken(&text, span, "a part", earlier);
        }
        Name { text, span }
    }

    fn taken(&mut self, word: &str, span: Span, what: &str, earlier: Span) {
        let message = format!("`{word}` is already {what}");
        let problem = Problem::new(message, span, "give one of the two another name");
        self.problems
            .push(problem.related(earlier, "declared here"));
    }

    /// The one word of a place: `left.B`, or `B` for `crank.B`.
    pub fn place(&mut self, name: &Name, scope: &Scope) -> Name {
        let words = self.words(name, scope);
        let span = name.span.shifted(scope.shift);
        Name {
            text: self.last(words, scope.instance, span),
            span,
        }
    }

    fn last(&mut self, words: Vec<String>, instance: usize, span: Span) -> String {
        // What is wrong with a point that a part was given is wrong where it was given.
        let aliases = &self.instances[instance].aliases;
        let given = words.first().and_then(|first| aliases.get(first));
        let span = given.map_or(span, |alias| alias.span);
        let mut words = self.whole_words(words, instance, true, span);
        if words.len() > 2 {
            let message = format!("`{}` is no point", words.join("."));
            let hint = "name a point, or a point of a part";
            self.problems.push(Problem::new(message, span, hint));
        }
        let point = words.pop().unwrap_or_default();
        if let Some(body) = words.pop() {
            self.claims.push((body, point.clone(), span));
        }
        point
    }

    /// Refuses points that bodies do not have, now that all items are written.
    pub fn check_claims(&mut self, items: &[Item]) {
        let mut had: HashSet<(&str, &str)> = HashSet::new();
        for item in items {
            match &item.kind {
                ItemKind::Link(link) => {
                    had.insert((&link.name.text, &link.from.text));
                    had.insert((&link.name.text, &link.to.text));
                }
                ItemKind::Point(point) => {
                    had.insert((&point.on.text, &point.name.text));
                }
                ItemKind::Grounds(list) => {
                    had.extend(list.iter().map(|point| ("ground", &*point.name.text)));
                }
                _ => {}
            }
        }
        for (body, point, span) in &self.claims {
            if !had.contains(&(body.as_str(), point.as_str())) {
                let message = format!("`{body}` has no point `{point}`");
                let hint = match (body.rsplit_once('.'), point.rsplit_once('.')) {
                    (Some((part, inner)), Some((_, point))) => format!(
                        "the component of `{part}` has to place it with `point {point} on {inner} \
                         at (X, Y)`"
                    ),
                    _ => format!("place it with `point {point} on {body} at (X, Y)`"),
                };
                self.problems.push(Problem::new(message, *span, hint));
            }
        }
    }

    /// The one word of a body.
    pub fn body(&mut self, name: &Name, scope: &Scope) -> Name {
        let words = self.words(name, scope);
        let span = name.span.shifted(scope.shift);
        let words = self.whole_words(words, scope.instance, true, span);
        if words.len() > 1 {
            let message = format!("`{}` is no body", words.join("."));
            let hint = "name a link or a slide, or one of a part";
            self.problems.push(Problem::new(message, span, hint));
        }
        Name {
            text: words.into_iter().next().unwrap_or_default(),
            span,
        }
    }

    /// A name with dots; of a place its last word is a point, of a value it is what is measured.
    pub fn path(&mut self, path: &Path, scope: &Scope, place: bool) -> Path {
        let mut words = Vec::with_capacity(path.parts.len());
        for part in &path.parts {
            words.push(self.word(&part.text, part.span, scope));
        }
        let span = path.span.shifted(scope.shift);
        let given = words.len();
        let words = self.whole_words(words, scope.instance, place, span);
        // Words that were joined have the place of all of them.
        let same = words.len() == given;
        let parts = words.into_iter().enumerate();
        let parts = parts.map(|(index, text)| Name {
            text,
            span: if same {
                path.parts[index].span.shifted(scope.shift)
            } else {
                span
            },
        });
        Path {
            parts: parts.collect(),
            span,
        }
    }

    /// Words as they are outside of all parts: `web.angle` in the part `left` is `left.web`,
    /// `angle`.
    fn whole_words(
        &mut self,
        mut words: Vec<String>,
        mut instance: usize,
        place: bool,
        span: Span,
    ) -> Vec<String> {
        for _ in 0..LONGEST_ROW {
            let Some(first) = words.first() else {
                return words;
            };
            let known = &self.instances[instance];
            if let Some(alias) = known.aliases.get(first) {
                instance = alias.instance;
                words.splice(..1, alias.words.iter().cloned());
                continue;
            }
            if EVERYWHERE.contains(&first.as_str())
                || CircularFormula::NAMES.contains(&first.as_str())
            {
                return words;
            }
            let full = format!("{}{first}", known.prefix);
            if words.len() > 1
                && let Some(&part) = self.parts.get(&full)
            {
                instance = part;
                words.remove(0);
                continue;
            }
            words[0] = full;
            let end = words.len() - usize::from(!place).min(words.len() - 1);
            for word in &mut words[1..end] {
                match known.aliases.get(word) {
                    Some(alias) => {
                        let (inner, owner) = (alias.words.clone(), alias.instance);
                        *word = self.outermost(inner, owner);
                    }
                    None => *word = format!("{}{word}", known.prefix),
                }
            }
            return words;
        }
        let message = "these points of parts stand for each other";
        let hint = "one of the parts needs a point of its own";
        self.problems.push(Problem::new(message, span, hint));
        Vec::new()
    }

    /// The point that words of a part stand for.
    fn outermost(&self, mut words: Vec<String>, mut instance: usize) -> String {
        for _ in 0..LONGEST_ROW {
            let Some(first) = words.first() else {
                break;
            };
            let known = &self.instances[instance];
            if let Some(alias) = known.aliases.get(first) {
                instance = alias.instance;
                words.splice(..1, alias.words.iter().cloned());
                continue;
            }
            let full = format!("{}{first}", known.prefix);
            match self.parts.get(&full) {
                Some(&part) if words.len() > 1 => {
                    instance = part;
                    words.remove(0);
                }
                _ => {
                    let last = words.pop().unwrap_or_default();
                    return format!("{}{last}", known.prefix);
                }
            }
        }
        String::new()
    }
}
