//! Reads one item after another with the grammar and builds the tree.

use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};
use pest::iterators::Pair;

use super::grammar::{Grammar, Rule};
use super::split::split;
use super::tree::*;
use crate::source::Span;
use crate::suggest::closest;

/// Something that is wrong with the text.
#[derive(Clone, Debug)]
pub struct Problem {
    /// What.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What would mend it.
    pub hint: String,
    /// Other places.
    pub related: Vec<(Span, String)>,
}

impl Problem {
    /// A problem at a place.
    pub fn new(message: impl Into<String>, span: Span, hint: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            span,
            hint: hint.into(),
            related: Vec::new(),
        }
    }

    /// The same, with another place.
    pub fn related(mut self, span: Span, label: impl Into<String>) -> Self {
        self.related.push((span, label.into()));
        self
    }
}

/// The kinds of items: keyword, rule, how one is written.
const ITEMS: &[(&str, Rule, &str)] = &[
    ("model", Rule::model_item, "model NAME"),
    (
        "param",
        Rule::declarations,
        "param NAME = VALUE \"meaning\"",
    ),
    ("let", Rule::declarations, "let NAME = VALUE \"meaning\""),
    (
        "set",
        Rule::set_item,
        "set NAME \"meaning\" { PARAM = VALUE, … }",
    ),
    (
        "input",
        Rule::input_item,
        "input NAME: UNIT = VALUE \"meaning\"",
    ),
    ("drive", Rule::declarations, "drive NAME = VALUE"),
    ("ground", Rule::declarations, "ground NAME = (X, Y)"),
    (
        "point",
        Rule::point_item,
        "point NAME on BODY at (X, Y)`, or `point NAME = (X, Y)",
    ),
    (
        "link",
        Rule::link_item,
        "link NAME from POINT to POINT { … }",
    ),
    ("slide", Rule::slide_item, "slide NAME along (X, Y) { … }"),
    (
        "hinge",
        Rule::hinge_item,
        "hinge at POINT { stiffness = VALUE }",
    ),
    (
        "spring",
        Rule::spring_item,
        "spring NAME between END and END { stiffness = VALUE }",
    ),
    (
        "stack",
        Rule::spring_item,
        "stack NAME between END and END { stiffness = VALUE, expansion = DRIVE }",
    ),
    (
        "contact",
        Rule::contact_item,
        "contact NAME between END and END { preload = VALUE, friction = LAW }",
    ),
    ("gravity", Rule::assignment_item, "gravity = (X, Y)"),
    ("force", Rule::force_item, "force on POINT = (X, Y)"),
    (
        "torque",
        Rule::torque_item,
        "torque on BODY = VALUE`, or `torque between BODY and BODY = VALUE",
    ),
    ("initial", Rule::initial_item, "initial BODY.rate = VALUE"),
    (
        "start",
        Rule::assignment_item,
        "start = assembled`, or `start = equilibrium",
    ),
    ("coordinate", Rule::coordinate_item, "coordinate BODY.angle"),
    (
        "output",
        Rule::declarations,
        "output NAME = VALUE \"meaning\"",
    ),
    ("stop", Rule::stop_item, "stop when CONDITION \"reason\""),
];

/// The words that start items.
pub(super) const KEYWORDS: [&str; ITEMS.len()] = {
    let mut words = [""; ITEMS.len()];
    let mut at = 0;
    while at < ITEMS.len() {
        words[at] = ITEMS[at].0;
        at += 1;
    }
    words
};

/// Largest file that is read, in bytes.
const LARGEST_FILE: usize = 4 << 20;

/// Longest item that is read, in bytes.
const LONGEST_ITEM: usize = 256 << 10;

/// Longest row of operators in one expression.
const LONGEST_CHAIN: usize = 1000;

/// Most problems that are listed.
const MOST_PROBLEMS: usize = 50;

/// Reads a file: the items that could be read, and what is wrong with the others.
pub fn parse(text: &str) -> (File, Vec<Problem>) {
    if text.len() > LARGEST_FILE {
        let problem = Problem::new(
            format!("this file is larger than {} MiB", LARGEST_FILE >> 20),
            Span::default(),
            "a model file is a few pages; tables of data belong in a CSV file",
        );
        return (File::default(), vec![problem]);
    }
    let split = split(text);
    let mut file = File {
        doc: split.doc,
        items: Vec::with_capacity(split.pieces.len()),
    };
    let mut problems = split.problems;
    for piece in &split.pieces {
        if problems.len() >= MOST_PROBLEMS {
            break;
        }
        match item(&piece.text, piece.span) {
            Ok(item) => file.items.push(item),
            Err(problem) => problems.push(*problem),
        }
    }
    problems.sort_by_key(|problem| problem.span);
    problems.truncate(MOST_PROBLEMS);
    (file, problems)
}

type Parsed<T> = Result<T, Box<Problem>>;

fn item(text: &str, span: Span) -> Parsed<Item> {
    let word_end = text
        .find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len());
    let word = &text[..word_end];
    let word_span = Span::new(span.start, span.start + word_end.max(1));
    let Some(&(keyword, mut rule, mut form)) = ITEMS.iter().find(|(known, _, _)| *known == word)
    else {
        return Err(Box::new(unknown_item(text, word, word_span)));
    };
    // `point B = (x, y)` declares, `point A on crank at (x, y)` places.
    if keyword == "point" {
        let rest = text[word_end..].trim_start();
        let name_end = rest
            .find(|c: char| !c.is_alphanumeric() && c != '_')
            .unwrap_or(rest.len());
        if rest[name_end..].trim_start().starts_with('=') {
            rule = Rule::declarations;
            form = "point NAME = (X, Y)";
        }
    }
    if text.len() > LONGEST_ITEM {
        return Err(Box::new(Problem::new(
            format!("this item is longer than {} KiB", LONGEST_ITEM >> 10),
            word_span,
            "tables of data belong in a CSV file",
        )));
    }
    let pair = Grammar::parse(rule, text)
        .map_err(|error| Box::new(explain(error, text, span.start, keyword, form)))?
        .next()
        .expect("a rule that matched gives one pair");
    let mut reader = Reader {
        base: span.start,
        keyword,
    };
    let kind = reader.item(pair)?;
    Ok(Item { kind, span })
}

fn unknown_item(text: &str, word: &str, span: Span) -> Problem {
    let rest = text[word.len()..].trim_start();
    if word.is_empty() {
        return Problem::new(
            "an item starts with a word that says what it is",
            span,
            format!("the words are {}", listed(&KEYWORDS)),
        );
    }
    let hint = match closest(word, KEYWORDS.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if rest.starts_with('=') => format!(
            "to declare a quantity write `param {word} = …`, or `let {word} = …` if it follows from others"
        ),
        None => format!("an item starts with one of {}", listed(&KEYWORDS)),
    };
    Problem::new(format!("`{word}` starts no item"), span, hint)
}

/// Words in backticks with commas.
pub(crate) fn listed(words: &[impl AsRef<str>]) -> String {
    let quoted: Vec<String> = words
        .iter()
        .map(|word| format!("`{}`", word.as_ref()))
        .collect();
    quoted.join(", ")
}

/// Turns pest's error into one in the language's own words.
fn explain(
    error: pest::error::Error<Rule>,
    text: &str,
    base: usize,
    keyword: &str,
    form: &str,
) -> Problem {
    let (start, end) = match error.location {
        InputLocation::Pos(at) => (at, at),
        InputLocation::Span((start, end)) => (start, end),
    };
    let found: String = text[start..]
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    let width = found
        .len()
        .max(text[start..].chars().next().map_or(0, char::len_utf8));
    let span = Span::new(base + start, base + end.max(start + width));
    let next = text[start..].chars().next();
    let after_digit = text[..start].ends_with(|c: char| c.is_ascii_digit());
    if next == Some('.') && after_digit {
        let message = "a decimal point needs a digit after it";
        return Problem::new(message, span, "write `3` or `3.0`");
    }
    let found = match next {
        None | Some('\n') => "the end of the line".to_owned(),
        Some(c) if found.is_empty() => format!("`{c}`"),
        Some(_) => format!("`{found}`"),
    };
    let mut expected: Vec<&str> = match &error.variant {
        ErrorVariant::ParsingError { positives, .. } => positives
            .iter()
            .filter_map(|&rule| describe(rule))
            .collect(),
        ErrorVariant::CustomError { .. } => Vec::new(),
    };
    expected.sort_unstable();
    expected.dedup();
    let after_value = expected.contains(&"an operator");
    if after_value && next.is_some_and(|c| c.is_alphanumeric() || "_\"({°%".contains(c)) {
        return Problem::new(
            format!("something is missing before {found}"),
            span,
            format!("two values need an operator or a comma between them: `{form}`"),
        );
    }
    if expected.len() > 1 {
        expected.retain(|words| *words != "words in quotation marks");
    }
    let message = match expected.as_slice() {
        [] => format!("this `{keyword}` cannot be read from {found} on"),
        [one] => format!("{one} is expected here, not {found}"),
        [first @ .., last] => {
            format!(
                "{} or {last} is expected here, not {found}",
                first.join(", ")
            )
        }
    };
    Problem::new(message, span, format!("it is written `{form}`"))
}

/// What a rule is called in messages; `None` for rules that would not help.
fn describe(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::name | Rule::path | Rule::keyword | Rule::entry_at => "a name",
        Rule::text | Rule::words => "words in quotation marks",
        Rule::literal
        | Rule::number
        | Rule::expression
        | Rule::conditional
        | Rule::reference
        | Rule::parentheses
        | Rule::argument
        | Rule::sign => "a value",
        Rule::operator => "an operator",
        Rule::unit | Rule::input_unit | Rule::not_a_unit => "a unit",
        Rule::arguments => return None,
        Rule::entries => "`{`",
        Rule::entry => "an entry `NAME = VALUE`",
        Rule::declaration | Rule::initial => "`NAME = VALUE`",
        Rule::on_clause => "`on`",
        Rule::along_clause => "`along`",
        Rule::through_clause => "`through`",
        Rule::from_clause => "`from`",
        Rule::two_paths | Rule::two_names => "two names joined by `and`",
        Rule::EOI => "the end of the item",
        Rule::kw_exact | Rule::kw_and | Rule::kw_or => return None,
        rule => return word_of(rule).filter(|word| !word.is_empty()),
    })
}

/// What a pair is made of, without the words of the grammar.
fn inner(pair: Pair<'_, Rule>) -> impl Iterator<Item = Pair<'_, Rule>> {
    pair.into_inner()
        .filter(|part| word_of(part.as_rule()).is_none())
}

/// The word of the grammar that a rule is.
fn word_of(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::kw_on => "`on`",
        Rule::kw_at => "`at`",
        Rule::kw_to => "`to`",
        Rule::kw_from => "`from`",
        Rule::kw_along => "`along`",
        Rule::kw_through => "`through`",
        Rule::kw_between => "`between`",
        Rule::kw_when => "`when`",
        Rule::kw_if => "`if`",
        Rule::kw_then => "`then`",
        Rule::kw_else => "`else`",
        Rule::kw_and | Rule::kw_or | Rule::keyword | Rule::EOI => "",
        _ => return None,
    })
}

/// Builds the tree from pest's pairs.
struct Reader {
    base: usize,
    keyword: &'static str,
}

impl Reader {
    fn span(&self, pair: &Pair<'_, Rule>) -> Span {
        let span = pair.as_span();
        let trimmed = span.as_str().trim_end().len();
        Span::new(self.base + span.start(), self.base + span.start() + trimmed)
    }

    fn name(&self, pair: &Pair<'_, Rule>) -> Name {
        Name {
            text: pair.as_str().trim().to_owned(),
            span: self.span(pair),
        }
    }

    fn path(&self, pair: Pair<'_, Rule>) -> Path {
        Path {
            span: self.span(&pair),
            parts: pair.into_inner().map(|part| self.name(&part)).collect(),
        }
    }

    fn text(&self, pair: Pair<'_, Rule>) -> String {
        let words = pair.into_inner().next().map_or("", |inner| inner.as_str());
        let mut text = String::with_capacity(words.len());
        let mut characters = words.chars();
        while let Some(c) = characters.next() {
            text.extend(if c == '\\' {
                characters.next()
            } else {
                Some(c)
            });
        }
        text
    }

    fn item(&mut self, pair: Pair<'_, Rule>) -> Parsed<ItemKind> {
        let rule = pair.as_rule();
        let mut parts: Vec<Pair<'_, Rule>> = inner(pair).collect();
        if rule == Rule::declarations {
            return self.declarations(parts);
        }
        let entries = match parts.last().map(Pair::as_rule) {
            Some(Rule::entries) => {
                let pair = parts.pop().expect("there is a last");
                self.entries(pair)?
            }
            _ => Vec::new(),
        };
        let doc = match parts.last().map(Pair::as_rule) {
            Some(Rule::text) => Some(self.text(parts.pop().expect("there is a last"))),
            _ => None,
        };
        let mut parts = parts.into_iter();
        let mut next = || parts.next().expect("the grammar demands it");
        Ok(match rule {
            Rule::model_item => ItemKind::Model(self.name(&next())),
            Rule::input_item => {
                let name = self.name(&next());
                let second = next();
                let (unit, value) = match second.as_rule() {
                    Rule::expression => (None, second),
                    _ => (Some(self.name(&second)), next()),
                };
                ItemKind::Input(Input {
                    name,
                    unit,
                    value: self.expression(value)?,
                    doc: doc.unwrap_or_default(),
                })
            }
            Rule::set_item => ItemKind::Set(Set {
                name: self.name(&next()),
                doc: doc.unwrap_or_default(),
                entries,
            }),
            Rule::point_item => ItemKind::Point(Point {
                name: self.name(&next()),
                on: self.name(&next()),
                at: self.expression(next())?,
            }),
            Rule::link_item => ItemKind::Link(Link {
                name: self.name(&next()),
                from: self.name(&next()),
                to: self.name(&next()),
                entries,
            }),
            Rule::slide_item => ItemKind::Slide(self.slide(parts, entries)?),
            Rule::hinge_item => ItemKind::Hinge(Hinge {
                at: self.name(&next()),
                between: parts.next().map(|pair| self.two_names(pair)),
                entries,
            }),
            Rule::spring_item => {
                let name = self.name(&next());
                let (first, second) = self.two_paths(next());
                let along = match parts.next() {
                    Some(clause) => Some(self.clause(clause)?),
                    None => None,
                };
                ItemKind::Spring(Spring {
                    name,
                    first,
                    second,
                    along,
                    entries,
                    stack: self.keyword == "stack",
                })
            }
            Rule::contact_item => {
                let name = self.name(&next());
                let (first, second) = self.two_paths(next());
                ItemKind::Contact(Contact {
                    name,
                    first,
                    second,
                    entries,
                })
            }
            Rule::assignment_item => {
                let value = self.expression(next())?;
                match self.keyword {
                    "start" => ItemKind::Start(value),
                    _ => ItemKind::Gravity(value),
                }
            }
            Rule::force_item => {
                let on = self.path(next());
                ItemKind::Force(on, self.expression(next())?)
            }
            Rule::torque_item => {
                let target = next();
                let (on, against) = match target.as_rule() {
                    Rule::two_names => {
                        let (first, second) = self.two_names(target);
                        (second, Some(first))
                    }
                    _ => (self.name(&target), None),
                };
                ItemKind::Torque(Torque {
                    on,
                    against,
                    value: self.expression(next())?,
                })
            }
            Rule::initial_item => {
                let mut initials = Vec::new();
                for initial in parts {
                    let mut parts = inner(initial);
                    let mut next = || parts.next().expect("the grammar demands it");
                    initials.push((self.path(next()), self.expression(next())?));
                }
                ItemKind::Initials(initials)
            }
            Rule::coordinate_item => {
                ItemKind::Coordinates(parts.map(|pair| self.path(pair)).collect())
            }
            _ => ItemKind::Stop(self.expression(next())?, doc),
        })
    }

    fn declarations(&mut self, parts: Vec<Pair<'_, Rule>>) -> Parsed<ItemKind> {
        let mut declarations = Vec::with_capacity(parts.len());
        for part in parts {
            let mut inner = part.into_inner();
            let mut next = || inner.next().expect("the grammar demands it");
            let name = self.name(&next());
            let value = self.value(next())?;
            let doc = inner.next().map(|pair| self.text(pair));
            declarations.push(Declaration {
                name,
                value,
                doc: doc.unwrap_or_default(),
            });
        }
        let common = declarations
            .last()
            .map_or(String::new(), |last| last.doc.clone());
        for declaration in &mut declarations {
            if declaration.doc.is_empty() {
                declaration.doc.clone_from(&common);
            }
        }
        Ok(match self.keyword {
            "param" => ItemKind::Params(declarations),
            "let" => ItemKind::Lets(declarations),
            "drive" => ItemKind::Drives(declarations),
            "ground" => ItemKind::Grounds(declarations),
            "point" => ItemKind::DrawnPoints(declarations),
            _ => ItemKind::Outputs(declarations),
        })
    }

    fn slide<'a>(
        &mut self,
        mut parts: impl Iterator<Item = Pair<'a, Rule>>,
        entries: Vec<Entry>,
    ) -> Parsed<Slide> {
        let mut slide = Slide {
            name: self.name(&parts.next().expect("the grammar demands it")),
            on: None,
            along: None,
            through: None,
            from: None,
            entries,
        };
        for clause in parts {
            let span = self.span(&clause);
            let repeated = match clause.as_rule() {
                Rule::on_clause => {
                    let inner = inner(clause).next().expect("the grammar demands it");
                    slide.on.replace(self.name(&inner)).is_some()
                }
                Rule::from_clause => {
                    let inner = inner(clause).next().expect("the grammar demands it");
                    slide.from.replace(self.path(inner)).is_some()
                }
                Rule::along_clause => slide.along.replace(self.clause(clause)?).is_some(),
                _ => slide.through.replace(self.clause(clause)?).is_some(),
            };
            if repeated {
                return Err(Box::new(Problem::new(
                    format!("`{}` says the same thing twice", slide.name.text),
                    span,
                    "remove one of the two",
                )));
            }
        }
        Ok(slide)
    }

    fn clause(&mut self, pair: Pair<'_, Rule>) -> Parsed<Expression> {
        let value = inner(pair).next().expect("the grammar demands it");
        self.expression(value)
    }

    fn two_names(&self, pair: Pair<'_, Rule>) -> (Name, Name) {
        let mut names = pair
            .into_inner()
            .filter(|part| part.as_rule() == Rule::name);
        let mut next = || self.name(&names.next().expect("the grammar demands it"));
        (next(), next())
    }

    fn two_paths(&self, pair: Pair<'_, Rule>) -> (Path, Path) {
        let mut paths = pair
            .into_inner()
            .filter(|part| part.as_rule() == Rule::path);
        let mut next = || self.path(paths.next().expect("the grammar demands it"));
        (next(), next())
    }

    fn entries(&mut self, pair: Pair<'_, Rule>) -> Parsed<Vec<Entry>> {
        let mut entries = Vec::new();
        for entry in pair.into_inner() {
            let mut name = None;
            let mut at = None;
            let mut value = None;
            let mut exact = None;
            for part in inner(entry) {
                match part.as_rule() {
                    Rule::name => name = Some(self.name(&part)),
                    Rule::entry_at => at = Some(self.name(&part)),
                    Rule::kw_exact => exact = Some(self.span(&part)),
                    _ => value = Some(self.value(part)?),
                }
            }
            entries.push(Entry {
                name: name.expect("the grammar demands it"),
                at,
                value: value.expect("the grammar demands it"),
                exact,
            });
        }
        Ok(entries)
    }

    fn value(&mut self, pair: Pair<'_, Rule>) -> Parsed<Expression> {
        match pair.as_rule() {
            Rule::text => Ok(Expression {
                span: self.span(&pair),
                kind: ExpressionKind::Text(self.text(pair)),
            }),
            _ => self.expression(pair),
        }
    }

    fn expression(&mut self, pair: Pair<'_, Rule>) -> Parsed<Expression> {
        let span = self.span(&pair);
        let mut row = Row::default();
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::conditional => {
                    let mut parts = inner(part);
                    let mut next = || parts.next().expect("the grammar demands it");
                    let condition = self.expression(next())?;
                    let positive = self.expression(next())?;
                    let negative = self.expression(next())?;
                    return Ok(Expression {
                        kind: ExpressionKind::Conditional(Box::new((
                            condition, positive, negative,
                        ))),
                        span,
                    });
                }
                Rule::sign => row.sign(part.as_str().starts_with('-'), self.span(&part)),
                Rule::operator => row.operator(part.as_str().trim(), self.span(&part)),
                _ => {
                    let operand = self.operand(part)?;
                    row.operand(operand);
                }
            }
            if row.operators.len() > LONGEST_CHAIN {
                return Err(Box::new(Problem::new(
                    format!("this expression has more than {LONGEST_CHAIN} operators"),
                    span,
                    "name parts of it with `let`",
                )));
            }
        }
        row.fold()
    }

    fn operand(&mut self, pair: Pair<'_, Rule>) -> Parsed<Expression> {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::literal => {
                let mut inner = pair.into_inner();
                let number = inner.next().expect("the grammar demands it");
                ExpressionKind::Literal {
                    number: number.as_str().to_owned(),
                    unit: inner.next().map(|unit| self.name(&unit)),
                }
            }
            Rule::reference => {
                let mut inner = pair.into_inner();
                let path = self.path(inner.next().expect("the grammar demands it"));
                match inner.next() {
                    None => ExpressionKind::Reference(path),
                    Some(arguments) => ExpressionKind::Call(Call {
                        name: Name {
                            text: path.text(),
                            span: path.span,
                        },
                        arguments: self.arguments(arguments)?,
                    }),
                }
            }
            _ => {
                let mut inner = pair.into_inner();
                let first = self.expression(inner.next().expect("the grammar demands it"))?;
                match inner.next() {
                    // Parentheses around one value only group; the span grows with them.
                    None => first.kind,
                    Some(second) => {
                        ExpressionKind::Pair(Box::new((first, self.expression(second)?)))
                    }
                }
            }
        };
        Ok(Expression { kind, span })
    }

    fn arguments(&mut self, pair: Pair<'_, Rule>) -> Parsed<Vec<Argument>> {
        let mut arguments = Vec::new();
        for argument in pair.into_inner() {
            let mut name = None;
            let mut value = None;
            for part in argument.into_inner() {
                match part.as_rule() {
                    Rule::name => name = Some(self.name(&part)),
                    _ => value = Some(self.value(part)?),
                }
            }
            arguments.push(Argument {
                name,
                value: value.expect("the grammar demands it"),
            });
        }
        Ok(arguments)
    }
}

/// A row of operands and operators, folded by precedence: `or`, `and`, comparisons, sums, products,
/// signs, powers.
#[derive(Default)]
struct Row {
    operands: Vec<Option<Expression>>,
    /// Signs before each operand: whether they are odd in minus, and where they start.
    signs: Vec<Option<(bool, Span)>>,
    operators: Vec<(String, Span)>,
    pending: Option<(bool, Span)>,
}

impl Row {
    fn sign(&mut self, minus: bool, span: Span) {
        self.pending = Some(match self.pending {
            None => (minus, span),
            Some((odd, first)) => (odd ^ minus, first),
        });
    }

    fn operator(&mut self, text: &str, span: Span) {
        self.operators.push((text.to_owned(), span));
    }

    fn operand(&mut self, operand: Expression) {
        self.operands.push(Some(operand));
        self.signs.push(self.pending.take());
    }

    fn fold(mut self) -> Parsed<Expression> {
        self.alternatives(0, self.operands.len())
    }

    /// Ranges of operands between operators that `splits` accepts, with the operator before each.
    fn pieces(
        &self,
        from: usize,
        to: usize,
        splits: fn(&str) -> bool,
    ) -> Vec<(Option<usize>, usize, usize)> {
        let mut pieces = Vec::new();
        let mut start = (None, from);
        for index in from..to.saturating_sub(1) {
            if splits(&self.operators[index].0) {
                pieces.push((start.0, start.1, index + 1));
                start = (Some(index), index + 1);
            }
        }
        pieces.push((start.0, start.1, to));
        pieces
    }

    fn alternatives(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| operator == "or");
        let parts = pieces
            .iter()
            .map(|&(_, start, end)| self.conjunction(start, end))
            .collect::<Parsed<Vec<_>>>()?;
        Ok(joined(parts, ExpressionKind::Or))
    }

    fn conjunction(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| operator == "and");
        let parts = pieces
            .iter()
            .map(|&(_, start, end)| self.comparison(start, end))
            .collect::<Parsed<Vec<_>>>()?;
        Ok(joined(parts, ExpressionKind::And))
    }

    fn comparison(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| comparison(operator).is_some());
        match pieces.as_slice() {
            [_] => self.sum(from, to),
            [(_, a, b), (Some(operator), c, d)] => {
                let kind = comparison(&self.operators[*operator].0).expect("it splits");
                let (left, right) = (self.sum(*a, *b)?, self.sum(*c, *d)?);
                Ok(Expression {
                    span: left.span.to(right.span),
                    kind: ExpressionKind::Comparison(kind, Box::new((left, right))),
                })
            }
            _ => {
                let second = pieces[2]
                    .0
                    .expect("every piece but the first follows an operator");
                Err(Box::new(Problem::new(
                    "comparisons do not chain",
                    self.operators[second].1,
                    "write `a < b and b < c`",
                )))
            }
        }
    }

    fn sum(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| matches!(operator, "+" | "-"));
        let mut terms = Vec::with_capacity(pieces.len());
        for (before, start, end) in pieces {
            let minus = before.is_some_and(|index| self.operators[index].0 == "-");
            terms.push((minus, self.product(start, end)?));
        }
        Ok(joined_signed(terms, ExpressionKind::Sum))
    }

    fn product(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        let pieces = self.pieces(from, to, |operator| matches!(operator, "*" | "/"));
        let mut factors = Vec::with_capacity(pieces.len());
        for (before, start, end) in pieces {
            let divides = before.is_some_and(|index| self.operators[index].0 == "/");
            factors.push((divides, self.power(start, end)?));
        }
        Ok(joined_signed(factors, ExpressionKind::Product))
    }

    /// Operands joined by `^`, from the right; a sign before the base is applied last.
    fn power(&mut self, from: usize, to: usize) -> Parsed<Expression> {
        if to - from > super::split::DEEPEST {
            return Err(Box::new(Problem::new(
                "this tower of powers is too high",
                self.operators[from].1,
                "name parts of it with `let`",
            )));
        }
        let mut result: Option<Expression> = None;
        for index in (from..to).rev() {
            let operand = self.operands[index].take().expect("each is used once");
            let mut value = match result {
                None => operand,
                Some(exponent) => Expression {
                    span: operand.span.to(exponent.span),
                    kind: ExpressionKind::Power(Box::new((operand, exponent))),
                },
            };
            if let Some((minus, span)) = self.signs[index] {
                value.span = span.to(value.span);
                if minus {
                    value = Expression {
                        span: value.span,
                        kind: ExpressionKind::Negative(Box::new(value)),
                    };
                }
            }
            result = Some(value);
        }
        Ok(result.expect("a row has operands"))
    }
}

fn joined(mut parts: Vec<Expression>, make: fn(Vec<Expression>) -> ExpressionKind) -> Expression {
    if parts.len() == 1 {
        return parts.pop().expect("one part");
    }
    Expression {
        span: parts[0].span.to(parts[parts.len() - 1].span),
        kind: make(parts),
    }
}

fn joined_signed(
    mut parts: Vec<(bool, Expression)>,
    make: fn(Vec<(bool, Expression)>) -> ExpressionKind,
) -> Expression {
    if parts.len() == 1 {
        return parts.pop().expect("one part").1;
    }
    Expression {
        span: parts[0].1.span.to(parts[parts.len() - 1].1.span),
        kind: make(parts),
    }
}

fn comparison(operator: &str) -> Option<Comparison> {
    Some(match operator {
        "<" => Comparison::Less,
        "<=" => Comparison::LessOrEqual,
        ">" => Comparison::Greater,
        ">=" => Comparison::GreaterOrEqual,
        "==" => Comparison::Equal,
        "!=" => Comparison::NotEqual,
        _ => return None,
    })
}
