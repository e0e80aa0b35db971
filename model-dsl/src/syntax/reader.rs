//! Builds the tree from the pairs that the grammar gives.

use pest::iterators::Pair;

use super::grammar::Rule;
use super::problem::{Problem, word_of};
use super::row::Row;
use super::tree::*;
use crate::source::Span;

/// Something that was read, or what is wrong with it.
pub(super) type Parsed<T> = Result<T, Box<Problem>>;

/// Longest row of operators in one expression.
const LONGEST_CHAIN: usize = 1000;

/// What a pair is made of, without the words of the grammar.
fn inner(pair: Pair<'_, Rule>) -> impl Iterator<Item = Pair<'_, Rule>> {
    pair.into_inner()
        .filter(|part| word_of(part.as_rule()).is_none())
}

/// Builds the tree from pest's pairs.
pub(super) struct Reader {
    /// Where the item starts in the file.
    pub base: usize,
    /// Its keyword.
    pub keyword: &'static str,
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

    pub(super) fn item(&mut self, pair: Pair<'_, Rule>) -> Parsed<ItemKind> {
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
            Rule::component_item => ItemKind::Component(Component {
                name: self.name(&next()),
                parameters: match parts.next() {
                    Some(pair) => self.parameters(pair)?,
                    None => Vec::new(),
                },
                items: Vec::new(),
            }),
            Rule::repeat_item => ItemKind::Repeat(Repeat {
                counter: self.name(&next()),
                from: self.name(&next()),
                to: self.name(&next()),
                items: Vec::new(),
            }),
            Rule::part_item => self.part(parts)?,
            Rule::use_item => ItemKind::Use(UsedFile {
                path: doc.unwrap_or_default(),
            }),
            Rule::const_item => ItemKind::Constants(
                parts
                    .map(|constant| {
                        let mut inner = constant.into_inner();
                        let mut next = || self.name(&inner.next().expect("the grammar demands it"));
                        (next(), next())
                    })
                    .collect(),
            ),
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

    fn parameters(&mut self, pair: Pair<'_, Rule>) -> Parsed<Vec<Parameter>> {
        let mut parameters = Vec::new();
        for parameter in pair.into_inner() {
            let mut inner = parameter.into_inner();
            let mut next = || inner.next().expect("the grammar demands it");
            let (name, kind) = (self.name(&next()), self.name(&next()));
            let default = match inner.next() {
                Some(value) => Some(self.expression(value)?),
                None => None,
            };
            parameters.push(Parameter {
                name,
                kind,
                default,
            });
        }
        Ok(parameters)
    }

    fn part<'a>(&mut self, mut parts: impl Iterator<Item = Pair<'a, Rule>>) -> Parsed<ItemKind> {
        let mut next = || parts.next().expect("the grammar demands it");
        let mut part = Part {
            name: self.name(&next()),
            component: self.name(&next()),
            arguments: Vec::new(),
            bindings: Vec::new(),
        };
        for pair in parts {
            if pair.as_rule() == Rule::arguments {
                part.arguments = self.arguments(pair)?;
                continue;
            }
            for binding in inner(pair) {
                let mut inner = binding.into_inner();
                let mut next = || inner.next().expect("the grammar demands it");
                let point = self.name(&next());
                part.bindings.push((point, self.path(next())));
            }
        }
        Ok(ItemKind::Part(part))
    }

    fn clause(&mut self, pair: Pair<'_, Rule>) -> Parsed<Expression> {
        let value = inner(pair).next().expect("the grammar demands it");
        self.expression(value)
    }

    fn two_names(&self, pair: Pair<'_, Rule>) -> (Name, Name) {
        let mut names = pair
            .into_inner()
            .filter(|part| part.as_rule() == Rule::dotted);
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
                    Rule::label => name = Some(self.name(&part)),
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
