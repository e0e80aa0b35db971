//! Model files as text, and places in them.

use flexure_runtime::diagnostic::{Diagnostic, Site};

/// Parts inside parts that a message names, from the inside.
const MOST_LEVELS: usize = 6;

/// A stretch of a source: byte offsets, end exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The stretch from `start` up to `end`.
    pub fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The same stretch, `distance` bytes further on.
    pub fn shifted(self, distance: usize) -> Self {
        Self::new(self.start + distance, self.end + distance)
    }

    /// The shortest stretch that holds both.
    pub fn to(self, other: Span) -> Span {
        Span::new(self.start.min(other.start), self.end.max(other.end))
    }
}

/// A model file: its name as the user gave it, and its text; with the files that it uses.
///
/// Places count through all of it: the file itself first, then each file it uses, then every copy
/// of a stretch that stands for a part or a turn of a `repeat`. A place in a copy is shown where it
/// is written, and [`Source::within`] says which copy it is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// The name, for messages.
    pub name: String,
    /// The whole text.
    pub text: String,
    used: Vec<Used>,
    copies: Vec<Copied>,
}

/// A file that is used.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Used {
    start: usize,
    name: String,
    text: String,
}

/// A stretch that is written once and stands for something several times.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Copied {
    /// Where the copy's places start.
    start: usize,
    /// What is written.
    original: Span,
    /// What made the copy, and what it is called.
    reason: Span,
    label: String,
}

impl Source {
    /// A source of that name and text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
            used: Vec::new(),
            copies: Vec::new(),
        }
    }

    /// Adds a file that is used; returns where its places start.
    pub(crate) fn add_file(&mut self, name: &str, text: &str) -> usize {
        let start = self.end();
        self.used.push(Used {
            start,
            name: name.to_owned(),
            text: text.to_owned(),
        });
        start
    }

    /// Adds a copy of a written stretch; returns where its places start.
    pub(crate) fn add_copy(&mut self, original: Span, reason: Span, label: String) -> usize {
        let start = self.end();
        self.copies.push(Copied {
            start,
            original,
            reason,
            label,
        });
        start
    }

    /// Where the next places start: one past all others, so that ends do not meet starts.
    fn end(&self) -> usize {
        if let Some(copy) = self.copies.last() {
            return copy.start + (copy.original.end - copy.original.start) + 1;
        }
        match self.used.last() {
            Some(used) => used.start + used.text.len() + 1,
            None => self.text.len() + 1,
        }
    }

    fn copy_at(&self, place: usize) -> Option<&Copied> {
        let after = self.copies.partition_point(|copy| copy.start <= place);
        self.copies[..after].last()
    }

    /// Where what stands at `span` is written.
    pub fn written(&self, span: Span) -> Span {
        match self.copy_at(span.start) {
            None => span,
            Some(copy) => {
                let back = copy.start - copy.original.start;
                Span::new(span.start - back, span.end.saturating_sub(back))
            }
        }
    }

    /// Which copy `span` lies in.
    pub fn copy(&self, span: Span) -> Option<usize> {
        self.copy_at(span.start).map(|copy| copy.start)
    }

    /// What made the copies that `span` lies in, with what each is called, from the inside.
    pub fn within(&self, span: Span) -> Vec<(Span, String)> {
        let mut reasons = Vec::new();
        let mut place = span.start;
        while let Some(copy) = self.copy_at(place) {
            reasons.push((copy.reason, copy.label.clone()));
            place = copy.reason.start;
        }
        reasons
    }

    /// Places of the parts and turns of a `repeat` that bring `span`, each with what it is called,
    /// from the inside.
    pub fn origins(&self, span: Span) -> Vec<(Site, String)> {
        self.within(span)
            .into_iter()
            .take(MOST_LEVELS)
            .map(|(reason, label)| (self.site(reason), label))
            .collect()
    }

    /// The diagnostic at `span`, and at each part and turn of a `repeat` that brings it.
    pub fn blame(&self, span: Span, diagnostic: Diagnostic) -> Diagnostic {
        let mut diagnostic = diagnostic.at(self.site(span));
        diagnostic.related.extend(self.origins(span));
        diagnostic
    }

    /// The file in which a written stretch stands, its text, and the stretch in it.
    fn file(&self, span: Span) -> (&str, &str, Span) {
        let after = self.used.partition_point(|used| used.start <= span.start);
        match self.used[..after].last() {
            None => (&self.name, &self.text, span),
            Some(used) => {
                let start = span.start - used.start;
                let end = span.end.saturating_sub(used.start);
                (&used.name, &used.text, Span::new(start, end))
            }
        }
    }

    /// The text that stands at `span`.
    pub fn excerpt(&self, span: Span) -> &str {
        let (_, text, span) = self.file(self.written(span));
        text.get(span.start..span.end).unwrap_or("")
    }

    /// The place where `span` starts, with its line; the underline ends with the line.
    pub fn site(&self, span: Span) -> Site {
        let (name, text, span) = self.file(self.written(span));
        let mut start = span.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let excerpt = text[line_start..line_end].trim_end_matches('\r');
        let mut end = span.end.clamp(start, line_end);
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        Site {
            file: name.to_owned().into(),
            line: before.matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            width: text[start..end].chars().count().max(1),
            excerpt: excerpt.to_owned().into(),
        }
    }
}
