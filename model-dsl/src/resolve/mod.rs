//! From the syntax tree to the [`Model`]: names are looked up, units checked, and every quantity
//! becomes an expression in SI units.
//!
//! ```text
//! declare names ─▶ quantities (params, inputs, lets) ─▶ bodies, points, pins ─▶ masses
//!   ─▶ hinges, contacts ─▶ drives ─▶ springs, loads ─▶ start, outputs, stops
//! ```
//!
//! Every step goes on after an error, so that a file's mistakes are reported together. What could
//! not be resolved keeps its name, so that one mistake does not give two messages.

mod arithmetic;
mod calls;
mod contacts;
mod dimensions;
mod drives;
mod entries;
mod expression;
mod functions;
mod given;
mod links;
mod loads;
mod masses;
mod measures;
mod names;
mod naming;
mod order;
mod points;
mod poses;
mod quantities;
mod results;
mod slides;
mod springs;
mod wanted;

use std::collections::{HashMap, HashSet};

use flexure_runtime::diagnostic::{Diagnostic, Severity, Site};

use crate::expand::expand;
use crate::model::{BodyId, Local, Measure, Model};
use crate::source::{Source, Span};
use crate::symbolic::{Expr, Symbol};
use crate::syntax;
use crate::syntax::tree::{File, ItemKind};
use names::Names;

/// Reads a model file. `files` gives the text of a file that the model names (a table of samples),
/// by the path as written, or says why it cannot.
///
/// Returns the model and warnings, or all errors (with the warnings found on the way), in the order
/// of the file.
pub fn resolve(
    mut source: Source,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<(Model, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (file, mut problems) = syntax::parse(&source.text, 0);
    let expanded = expand(file, &mut source, files);
    problems.extend(expanded.problems);
    let mut resolver = Resolver::new(source, files);
    resolver.model.files = expanded.files;
    for problem in problems {
        let mut diagnostic = Diagnostic::error(problem.message)
            .at(resolver.site(problem.span))
            .hint(problem.hint);
        for (span, label) in problem.related {
            diagnostic = diagnostic.related(resolver.site(span), label);
        }
        resolver.report(problem.span, diagnostic);
    }
    // A part that was not understood may have been one of it.
    let unused = if resolver.failed() {
        Vec::new()
    } else {
        expanded.unused
    };
    for name in unused {
        resolver.warning(
            name.span,
            format!(
                "no part is made of the component `{}`, so nothing in it is checked",
                name.text
            ),
            format!("write `part NAME = {}(…)`, or remove it", name.text),
        );
    }
    resolver.partial = resolver.failed();
    resolver.run(&expanded.file);
    resolver.finish()
}

/// Most diagnostics that are reported for one file.
const MOST_DIAGNOSTICS: usize = 50;

/// Something of the file that failed was reported; carry on without it.
struct Reported;

type Resolved<T> = Result<T, Reported>;

/// A point as declared: the bodies that have it.
struct Place {
    name: String,
    span: Span,
    /// Body, place in its frame, where it was said, whether as the end of a link.
    members: Vec<Member>,
    /// Drawn coordinates in the fixed frame.
    drawn: Option<[Expr; 2]>,
}

struct Member {
    body: BodyId,
    at: Local,
    span: Span,
    is_end: bool,
}

struct Resolver<'a> {
    model: Model,
    files: &'a dyn Fn(&str) -> Result<String, String>,
    diagnostics: Vec<(Span, Diagnostic)>,
    names: Names,
    places: Vec<Place>,
    /// Positions of places, of named points and of pins by name.
    place_index: HashMap<String, usize>,
    point_index: HashMap<String, usize>,
    pin_index: HashMap<String, usize>,
    /// Names of `let`s that were made on the way.
    derived: HashSet<String>,
    measures: HashMap<Measure, Symbol>,
    /// Whether items are missing because they could not be read: names may then be unknown for
    /// that reason alone.
    partial: bool,
    /// Written places of which a copy was reported, with the copy.
    reported: HashMap<(Span, Severity), usize>,
}

impl<'a> Resolver<'a> {
    fn new(source: Source, files: &'a dyn Fn(&str) -> Result<String, String>) -> Self {
        Self {
            model: Model::empty(source),
            files,
            diagnostics: Vec::new(),
            names: Names::default(),
            places: Vec::new(),
            place_index: HashMap::new(),
            point_index: HashMap::new(),
            pin_index: HashMap::new(),
            derived: HashSet::new(),
            measures: HashMap::new(),
            partial: false,
            reported: HashMap::new(),
        }
    }

    fn run(&mut self, file: &File) {
        self.model.doc.clone_from(&file.doc);
        self.model_name(file);
        self.declare(file);
        self.params(file);
        self.inputs(file);
        self.lets(file);
        self.sets(file);
        if self.parts_given(file).is_err() {
            return;
        }
        self.locate(file);
        self.links(file);
        self.points(file);
        self.slides(file);
        self.pins();
        self.masses(file);
        self.hinges(file);
        self.contacts(file);
        self.drives(file);
        self.springs(file);
        self.loads(file);
        self.results(file);
        self.free_bodies();
        self.unused(file);
    }

    fn model_name(&mut self, file: &File) {
        let mut first: Option<Span> = None;
        for item in &file.items {
            let ItemKind::Model(name) = &item.kind else {
                continue;
            };
            match first {
                None => self.model.name.clone_from(&name.text),
                Some(earlier) => {
                    let diagnostic = self
                        .diagnostic(name.span, "the model is named twice")
                        .hint("a file holds one model: remove one of the two lines")
                        .related(self.site(earlier), "named here first");
                    self.report(name.span, diagnostic);
                }
            }
            first = first.or(Some(name.span));
        }
        if first.is_none() && !self.partial {
            self.error(
                Span::default(),
                "the model has no name",
                "start the file with `model NAME`",
            );
        }
    }

    // ── Diagnostics ────────────────────────────────────────────────────────────────────────────

    fn diagnostic(&self, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(message).at(self.site(span))
    }

    /// The place of `span`; not looked up any more once there is more than enough to report.
    fn site(&self, span: Span) -> Site {
        if self.full() {
            return Source::default().site(Span::default());
        }
        self.model.source.site(span)
    }

    /// Whether there is more to report than anybody reads.
    fn full(&self) -> bool {
        self.diagnostics.len() > 2 * MOST_DIAGNOSTICS
    }

    /// Reports once what is wrong in the same way with several copies of one place, and says with
    /// which copy.
    fn report(&mut self, span: Span, mut diagnostic: Diagnostic) {
        if self.full() {
            return;
        }
        if let Some(copy) = self.model.source.copy(span) {
            let written = self.model.source.written(span);
            let key = (written, diagnostic.severity);
            if *self.reported.entry(key).or_insert(copy) != copy {
                return;
            }
        }
        diagnostic.related.extend(self.model.source.origins(span));
        self.diagnostics.push((span, diagnostic));
    }

    /// Reports an error; returns what stands for a failed result.
    fn error(
        &mut self,
        span: Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Reported {
        let diagnostic = self.diagnostic(span, message).hint(hint);
        self.report(span, diagnostic);
        Reported
    }

    fn warning(&mut self, span: Span, message: impl Into<String>, hint: impl Into<String>) {
        let diagnostic = Diagnostic::warning(message).at(self.site(span)).hint(hint);
        self.report(span, diagnostic);
    }

    fn failed(&self) -> bool {
        self.diagnostics
            .iter()
            .any(|(_, diagnostic)| diagnostic.severity == Severity::Error)
    }

    fn finish(mut self) -> Result<(Model, Vec<Diagnostic>), Vec<Diagnostic>> {
        let failed = self.failed();
        self.diagnostics.sort_by_key(|(span, _)| span.start);
        let mut diagnostics: Vec<Diagnostic> = Vec::new();
        for (_, diagnostic) in self.diagnostics {
            if diagnostics.len() == MOST_DIAGNOSTICS {
                let message = format!("there is more wrong than these {MOST_DIAGNOSTICS} places");
                diagnostics.push(Diagnostic::error(message).hint("mend these first"));
                break;
            }
            if diagnostics.last() != Some(&diagnostic) {
                diagnostics.push(diagnostic);
            }
        }
        if failed {
            Err(diagnostics)
        } else {
            Ok((self.model, diagnostics))
        }
    }

    /// The text that stands at `span`, blanks and line ends shortened.
    fn written(&self, span: Span) -> String {
        let text = self.model.source.excerpt(span);
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}
