//! Which items are written, and in which scope: parts get instances, repeats get turns.

use std::collections::{HashMap, HashSet};

use super::files::Library;
use super::scope::{Alias, Instance, Names, Scope};
use super::whole::whole;
use crate::source::{Source, Span};
use crate::suggest::closest;
use crate::syntax::tree::{
    Argument, Component, Expression, ExpressionKind, File, Item, ItemKind, Name, Parameter, Part,
    Path, Repeat,
};
use crate::syntax::{Problem, listed};

/// Most parts and turns of repeats in a model.
const MOST_COPIES: usize = 10_000;

/// Longest text of all copies, in bytes.
const LONGEST_TEXT: usize = 8 << 20;

/// Deepest nesting of parts and repeats in each other.
const DEEPEST: usize = 40;

/// One thing that is written.
pub(super) enum Piece<'a> {
    /// An item in a scope.
    Item(Scope, &'a Item),
    /// What a part's parameter is given.
    Argument(Given<'a>),
}

/// What a part's parameter is given.
pub(super) struct Given<'a> {
    /// The scope of the part's inside.
    pub inside: Scope,
    pub part: String,
    pub parameter: &'a Parameter,
    /// The value and where it is said.
    pub value: &'a Expression,
    pub said: Scope,
    /// Whether the parameter is another name of something outside.
    pub alias: bool,
}

/// Everything that is written, in order.
pub(super) struct Plan<'a> {
    pub names: Names<'a>,
    pub pieces: Vec<Piece<'a>>,
    /// Names of the components of which there are parts.
    pub made: HashSet<&'a str>,
}

/// Plans what is written of `file`.
pub(super) fn plan<'a>(
    file: &'a File,
    library: &'a Library,
    source: &mut Source,
    problems: Vec<Problem>,
) -> Plan<'a> {
    let mut planner = Planner {
        source,
        plan: Plan {
            names: Names {
                library,
                instances: vec![Instance::default()],
                parts: std::collections::BTreeMap::new(),
                claims: Vec::new(),
                problems,
            },
            pieces: Vec::new(),
            made: HashSet::new(),
        },
        mentioned: HashMap::new(),
        inside: Vec::new(),
        copies: 0,
        length: 0,
        full: false,
    };
    planner.items(&file.items, &Scope::default(), None, 0);
    planner.plan
}

struct Planner<'a, 's> {
    source: &'s mut Source,
    plan: Plan<'a>,
    /// Names of points and bodies that components mention.
    mentioned: HashMap<&'a str, HashSet<&'a str>>,
    /// Components that the present items stand in, each with its part.
    inside: Vec<(&'a str, Span)>,
    copies: usize,
    length: usize,
    /// Whether the model has grown too large; nothing more is planned then.
    full: bool,
}

impl<'a> Planner<'a, '_> {
    fn problem(&mut self, problem: Problem) {
        self.plan.names.problems.push(problem);
    }

    fn items(
        &mut self,
        items: &'a [Item],
        scope: &Scope,
        component: Option<&'a Component>,
        depth: usize,
    ) {
        for item in items {
            if self.full {
                return;
            }
            if depth > 0 {
                self.length += item.span.end - item.span.start;
                if self.length > LONGEST_TEXT {
                    self.grown(item.span.shifted(scope.shift));
                    return;
                }
            }
            match &item.kind {
                ItemKind::Repeat(repeat) => self.repeat(item, repeat, scope, component, depth),
                ItemKind::Part(part) => self.part(part, scope, depth),
                kind => {
                    if let Some(word) = misplaced(kind, depth > 0, component.is_some()) {
                        self.misplaced(word, item.span.shifted(scope.shift), component);
                    } else if !matches!(
                        kind,
                        ItemKind::Component(_) | ItemKind::Constants(_) | ItemKind::Use(_)
                    ) {
                        self.plan.pieces.push(Piece::Item(scope.clone(), item));
                    }
                }
            }
        }
    }

    fn misplaced(&mut self, word: &str, span: Span, component: Option<&Component>) {
        let problem = match component {
            Some(component) => Problem::new(
                format!("`{word}` cannot stand in a component"),
                span,
                if word == "param" {
                    "a component takes its quantities in parentheses after its name"
                } else {
                    "move it out, into the file itself"
                },
            )
            .related(component.name.span, "in this component"),
            None => Problem::new(
                format!("`{word}` cannot stand in a `repeat`"),
                span,
                "move it out, into the file itself",
            ),
        };
        self.problem(problem);
    }

    fn grown(&mut self, span: Span) {
        if !self.full {
            self.full = true;
            let message = format!(
                "this model has more than {MOST_COPIES} parts and turns of `repeat`, or more \
                 than {} MiB of text when they are written out",
                LONGEST_TEXT >> 20
            );
            let hint = "repeat less often";
            self.problem(Problem::new(message, span, hint));
        }
    }

    /// Makes room for one more copy, if there is any.
    fn copy(&mut self, original: Span, reason: Span, label: String, depth: usize) -> Option<usize> {
        if depth >= DEEPEST {
            if !self.full {
                self.full = true;
                let message = format!(
                    "parts and repeats stand in each other more than {DEEPEST} levels deep"
                );
                let hint = "put fewer of them in each other";
                self.problem(Problem::new(message, reason, hint));
            }
            return None;
        }
        self.copies += 1;
        if self.copies > MOST_COPIES {
            self.grown(reason);
            return None;
        }
        let start = self.source.add_copy(original, reason, label);
        Some(start - original.start)
    }

    fn repeat(
        &mut self,
        item: &'a Item,
        repeat: &'a Repeat,
        scope: &Scope,
        component: Option<&'a Component>,
        depth: usize,
    ) {
        let counter = &repeat.counter;
        let place = counter.span.shifted(scope.shift);
        if self.plan.names.number(scope, &counter.text).is_some()
            || matches!(counter.text.as_str(), "t" | "pi")
        {
            let message = format!("`{}` cannot count turns: the name is taken", counter.text);
            self.problem(Problem::new(message, place, "choose another name"));
            return;
        }
        let (Some(from), Some(to)) = (
            self.bound(&repeat.from, scope),
            self.bound(&repeat.to, scope),
        ) else {
            return;
        };
        let mut value = from;
        while value <= to && !self.full {
            let label = format!("in the turn {} = {value}", counter.text);
            let Some(shift) = self.copy(item.span, place, label, depth) else {
                return;
            };
            let mut inner = scope.clone();
            inner.shift = shift;
            inner
                .counters
                .push((counter.text.clone(), value, counter.span));
            self.items(&repeat.items, &inner, component, depth + 1);
            let Some(next) = value.checked_add(1) else {
                return;
            };
            value = next;
        }
    }

    fn bound(&mut self, written: &Name, scope: &Scope) -> Option<i64> {
        let value = whole(&written.text, &|name| self.plan.names.number(scope, name));
        match value {
            Ok(value) => Some(value),
            Err(message) => {
                let hint = "a repeat counts from one whole number to another, made of digits, \
                            constants and counters; declare a constant with `const N = 40`";
                let span = written.span.shifted(scope.shift);
                self.problem(Problem::new(message, span, hint));
                None
            }
        }
    }

    fn part(&mut self, part: &'a Part, scope: &Scope, depth: usize) {
        self.plan.made.insert(&part.component.text);
        let library = self.plan.names.library;
        let Some((component, original)) = library.components.get(&part.component.text) else {
            let name = &part.component.text;
            let known: Vec<&str> = library.components.keys().map(String::as_str).collect();
            let hint = match closest(name, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None if known.is_empty() || known.len() > 12 => {
                    "declare it with `component NAME(…) { … }`, or `use` the file that does"
                        .to_owned()
                }
                None => format!("there are {}", listed(&known)),
            };
            let span = part.component.span.shifted(scope.shift);
            self.problem(Problem::new(
                format!("there is no component `{name}`"),
                span,
                hint,
            ));
            return;
        };
        let span = part.name.span.shifted(scope.shift);
        let name = self.plan.names.declared(&part.name, scope).text;
        if self.plan.names.parts.contains_key(&name) {
            return;
        }
        if let Some(&(_, outer)) = self
            .inside
            .iter()
            .find(|(known, _)| *known == name_of(component))
        {
            let message = format!("the component `{}` is made of itself", name_of(component));
            let hint = "a part cannot hold the component that it stands in";
            let problem = Problem::new(message, span, hint);
            self.problem(problem.related(outer, "this part is made of it"));
            return;
        }
        let label = format!("in the part `{name}`");
        let Some(shift) = self.copy(*original, span, label, depth) else {
            return;
        };
        let instance = self.plan.names.instances.len();
        self.plan.names.instances.push(Instance {
            prefix: format!("{name}."),
            span,
            aliases: HashMap::new(),
        });
        self.plan.names.parts.insert(name.clone(), instance);
        let inside = Scope {
            instance,
            counters: Vec::new(),
            shift,
        };
        self.arguments(part, component, &name, &inside, scope);
        self.bindings(part, component, instance, scope);
        self.inside.push((name_of(component), span));
        self.items(&component.items, &inside, Some(component), depth + 1);
        self.inside.pop();
    }

    fn arguments(
        &mut self,
        part: &'a Part,
        component: &'a Component,
        name: &str,
        inside: &Scope,
        said: &Scope,
    ) {
        let parameters = &component.parameters;
        let mut given: Vec<Option<&'a Expression>> = vec![None; parameters.len()];
        for (position, argument) in part.arguments.iter().enumerate() {
            match self.parameter(part, component, argument, position, said) {
                Some(index) if given[index].is_none() => given[index] = Some(&argument.value),
                Some(index) => {
                    let message = format!("`{}` is given twice", parameters[index].name.text);
                    let span = argument.value.span.shifted(said.shift);
                    self.problem(Problem::new(message, span, "remove one of the two"));
                }
                None => {}
            }
        }
        for (parameter, given) in parameters.iter().zip(given) {
            let (value, scope) = match (given, &parameter.default) {
                (Some(value), _) => (value, said),
                (None, Some(default)) => (default, inside),
                (None, None) => {
                    let message = format!(
                        "the part `{name}` does not say `{}` of `{}`",
                        parameter.name.text, component.name.text
                    );
                    let hint = format!(
                        "write `{} = {}(…, {} = …)`",
                        part.name.text, component.name.text, parameter.name.text
                    );
                    let span = part.name.span.shifted(said.shift);
                    let problem = Problem::new(message, span, hint);
                    self.problem(problem.related(parameter.name.span, "it is asked for here"));
                    continue;
                }
            };
            let alias = self.alias(value, scope);
            if let Some(words) = &alias {
                self.plan.names.instances[inside.instance].aliases.insert(
                    parameter.name.text.clone(),
                    Alias {
                        words: words.clone(),
                        instance: scope.instance,
                        span: value.span.shifted(scope.shift),
                        point: false,
                    },
                );
            }
            self.plan.pieces.push(Piece::Argument(Given {
                inside: inside.clone(),
                part: name.to_owned(),
                parameter,
                value,
                said: scope.clone(),
                alias: alias.is_some(),
            }));
        }
    }

    fn parameter(
        &mut self,
        part: &Part,
        component: &'a Component,
        argument: &Argument,
        position: usize,
        said: &Scope,
    ) -> Option<usize> {
        let parameters = &component.parameters;
        let known: Vec<&str> = parameters.iter().map(|p| p.name.text.as_str()).collect();
        let found = match &argument.name {
            Some(name) => known.iter().position(|known| *known == name.text),
            None => {
                let after_name = part.arguments[..position].iter().any(|a| a.name.is_some());
                (position < known.len() && !after_name).then_some(position)
            }
        };
        if found.is_none() {
            let component_name = &component.name.text;
            let (message, span) = match &argument.name {
                Some(name) => (
                    format!("`{component_name}` takes no `{}`", name.text),
                    name.span,
                ),
                None if position < known.len() => (
                    "an argument without a name follows one with a name".to_owned(),
                    argument.value.span,
                ),
                None => (
                    format!("`{component_name}` takes {} arguments at most", known.len()),
                    argument.value.span,
                ),
            };
            let near = argument
                .name
                .as_ref()
                .and_then(|name| closest(&name.text, known.iter().copied()));
            let hint = match near {
                Some(near) => format!("did you mean `{near}`?"),
                None if known.is_empty() => "remove it".to_owned(),
                None => format!("it takes {}", listed(&known)),
            };
            let problem = Problem::new(message, span.shifted(said.shift), hint);
            self.problem(problem.related(component.name.span, "the component is declared here"));
        }
        found
    }

    /// The words of a value that is only a name.
    fn alias(&mut self, value: &Expression, scope: &Scope) -> Option<Vec<String>> {
        let ExpressionKind::Reference(path) = &value.kind else {
            return None;
        };
        let first = path.single()?;
        if matches!(first.text.as_str(), "t" | "pi")
            || self.plan.names.number(scope, &first.text).is_some()
        {
            return None;
        }
        Some(vec![self.plan.names.word(&first.text, first.span, scope)])
    }

    fn bindings(
        &mut self,
        part: &'a Part,
        component: &'a Component,
        instance: usize,
        said: &Scope,
    ) {
        let mentioned = self
            .mentioned
            .entry(component.name.text.as_str())
            .or_insert_with(|| {
                let mut points = HashSet::new();
                points_in(&component.items, &mut points);
                points
            });
        let mut problems = Vec::new();
        for (point, _) in &part.bindings {
            if !mentioned.contains(point.text.as_str()) {
                let mut known: Vec<&str> = mentioned.iter().copied().collect();
                known.sort_unstable();
                let hint = match closest(&point.text, known.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("it has {}", listed(&known)),
                };
                let message = format!(
                    "the component `{}` has no point or body `{}`",
                    component.name.text, point.text
                );
                let problem = Problem::new(message, point.span.shifted(said.shift), hint);
                problems
                    .push(problem.related(component.name.span, "the component is declared here"));
            }
        }
        self.plan.names.problems.extend(problems);
        for (point, place) in &part.bindings {
            let words = self.path_words(place, said);
            let alias = Alias {
                words,
                instance: said.instance,
                span: place.span.shifted(said.shift),
                point: true,
            };
            let aliases = &mut self.plan.names.instances[instance].aliases;
            if aliases.insert(point.text.clone(), alias).is_some() {
                let message = format!("`{}` is given twice", point.text);
                let span = point.span.shifted(said.shift);
                self.problem(Problem::new(message, span, "remove one of the two"));
            }
        }
    }

    fn path_words(&mut self, path: &Path, scope: &Scope) -> Vec<String> {
        let names = &mut self.plan.names;
        let parts = path.parts.iter();
        parts
            .map(|part| names.word(&part.text, part.span, scope))
            .collect()
    }
}

fn name_of(component: &Component) -> &str {
    &component.name.text
}

/// The keyword of an item that cannot stand where it does.
fn misplaced(kind: &ItemKind, inner: bool, in_component: bool) -> Option<&'static str> {
    let word = match kind {
        ItemKind::Model(_) => "model",
        ItemKind::Set(_) => "set",
        ItemKind::Gravity(_) => "gravity",
        ItemKind::Start(_) => "start",
        ItemKind::Component(_) => "component",
        ItemKind::Use(_) => "use",
        ItemKind::Constants(_) => "const",
        ItemKind::Params(_) if in_component => "param",
        _ => return None,
    };
    inner.then_some(word)
}

/// Names of points and bodies that items mention.
fn points_in<'a>(items: &'a [Item], points: &mut HashSet<&'a str>) {
    // Blocks nest only as deep as they are read.
    for item in items {
        match &item.kind {
            ItemKind::Repeat(repeat) => points_in(&repeat.items, points),
            ItemKind::Grounds(list) | ItemKind::DrawnPoints(list) => {
                points.extend(
                    list.iter()
                        .map(|declaration| declaration.name.text.as_str()),
                );
            }
            ItemKind::Point(point) => {
                points.extend([&*point.name.text, &*point.on.text]);
            }
            ItemKind::Link(link) => points.extend([&*link.from.text, &*link.to.text]),
            ItemKind::Hinge(hinge) => {
                points.insert(&hinge.at.text);
                let bodies = hinge.between.iter().flat_map(|(a, b)| [a, b]);
                points.extend(bodies.map(|body| body.text.as_str()));
            }
            ItemKind::Torque(torque) => {
                points.insert(&torque.on.text);
                points.extend(torque.against.iter().map(|body| body.text.as_str()));
            }
            ItemKind::Spring(spring) => {
                points.extend([&spring.first, &spring.second].map(first_word));
            }
            ItemKind::Contact(contact) => {
                points.extend([&contact.first, &contact.second].map(first_word));
            }
            ItemKind::Force(on, _) => {
                points.insert(first_word(on));
            }
            ItemKind::Part(part) => {
                points.extend(part.bindings.iter().map(|(_, place)| first_word(place)));
            }
            ItemKind::Slide(slide) => {
                points.extend(slide.from.iter().map(first_word));
                points.extend(slide.on.iter().map(|body| body.text.as_str()));
            }
            _ => {}
        }
    }
}

fn first_word(path: &Path) -> &str {
    path.parts.first().map_or("", |part| part.text.as_str())
}
