//! Writes every item as it stands in its scope.

use super::plan::{Given, Piece, Plan};
use super::scope::{Names, Scope};
use crate::syntax::Problem;
use crate::syntax::tree::{
    self, Argument, Call, Contact, Declaration, Entry, Expression, ExpressionKind, Hinge, Input,
    Item, ItemKind, Link, Name, Path, Point, Set, Slide, Spring, Torque,
};

/// Writes what was planned.
pub(super) fn write(plan: Plan<'_>) -> (Vec<Item>, Vec<Problem>) {
    let Plan {
        mut names, pieces, ..
    } = plan;
    let mut items = Vec::with_capacity(pieces.len());
    for piece in pieces {
        match piece {
            Piece::Item(scope, item) => {
                let span = item.span.shifted(scope.shift);
                let mut writer = Writer {
                    names: &mut names,
                    scope: &scope,
                };
                if let Some(kind) = writer.item(&item.kind) {
                    items.push(Item { kind, span });
                }
            }
            Piece::Argument(given) => argument(&mut names, &given, &mut items),
        }
    }
    names.check_claims(&items);
    (items, names.problems)
}

/// A parameter's value: checked, and a `let` unless it is another name of something.
fn argument(names: &mut Names<'_>, given: &Given<'_>, items: &mut Vec<Item>) {
    let mut writer = Writer {
        names,
        scope: &given.said,
    };
    let value = writer.expression(given.value);
    let parameter = &given.parameter.name;
    let span = parameter.span.shifted(given.inside.shift);
    let name = Name {
        text: format!("{}.{}", given.part, parameter.text),
        span,
    };
    let kind = tree::Given {
        part: given.part.clone(),
        parameter: parameter.clone(),
        kind: given.parameter.kind.clone(),
        value: value.clone(),
    };
    items.push(Item {
        span: value.span,
        kind: ItemKind::Given(kind),
    });
    if !given.alias {
        let declaration = Declaration {
            name,
            value,
            doc: String::new(),
        };
        items.push(Item {
            kind: ItemKind::Lets(vec![declaration]),
            span,
        });
    }
}

struct Writer<'n, 'a> {
    names: &'n mut Names<'a>,
    scope: &'n Scope,
}

impl Writer<'_, '_> {
    fn item(&mut self, kind: &ItemKind) -> Option<ItemKind> {
        Some(match kind {
            ItemKind::Model(name) => ItemKind::Model(name.clone()),
            ItemKind::Params(list) => ItemKind::Params(self.declarations(list)),
            ItemKind::Lets(list) => ItemKind::Lets(self.declarations(list)),
            ItemKind::Drives(list) => ItemKind::Drives(self.declarations(list)),
            ItemKind::Outputs(list) => ItemKind::Outputs(self.declarations(list)),
            ItemKind::Grounds(list) => ItemKind::Grounds(self.declarations(list)),
            ItemKind::DrawnPoints(list) => ItemKind::DrawnPoints(self.declarations(list)),
            ItemKind::Point(point) => ItemKind::Point(Point {
                name: self.declared(&point.name),
                on: self.body(&point.on),
                at: self.expression(&point.at),
            }),
            ItemKind::Input(input) => ItemKind::Input(Input {
                name: self.declared(&input.name),
                unit: input.unit.as_ref().map(|unit| self.shifted(unit)),
                value: self.expression(&input.value),
                doc: input.doc.clone(),
            }),
            ItemKind::Set(set) => ItemKind::Set(Set {
                name: set.name.clone(),
                doc: set.doc.clone(),
                entries: self.entries(&set.entries),
            }),
            ItemKind::Link(link) => ItemKind::Link(Link {
                name: self.declared(&link.name),
                from: self.place(&link.from),
                to: self.place(&link.to),
                entries: self.entries(&link.entries),
            }),
            ItemKind::Slide(slide) => ItemKind::Slide(Slide {
                name: self.declared(&slide.name),
                on: slide.on.as_ref().map(|on| self.body(on)),
                along: self.optional(slide.along.as_ref()),
                through: self.optional(slide.through.as_ref()),
                from: slide.from.as_ref().map(|from| self.path(from, true)),
                entries: self.entries(&slide.entries),
            }),
            ItemKind::Hinge(hinge) => ItemKind::Hinge(Hinge {
                at: self.place(&hinge.at),
                between: hinge
                    .between
                    .as_ref()
                    .map(|(a, b)| (self.body(a), self.body(b))),
                entries: self.entries(&hinge.entries),
            }),
            ItemKind::Spring(spring) => ItemKind::Spring(Spring {
                name: self.declared(&spring.name),
                first: self.path(&spring.first, true),
                second: self.path(&spring.second, true),
                along: self.optional(spring.along.as_ref()),
                entries: self.entries(&spring.entries),
                stack: spring.stack,
            }),
            ItemKind::Contact(contact) => ItemKind::Contact(Contact {
                name: self.declared(&contact.name),
                first: self.path(&contact.first, true),
                second: self.path(&contact.second, true),
                entries: self.entries(&contact.entries),
            }),
            ItemKind::Gravity(value) => ItemKind::Gravity(self.expression(value)),
            ItemKind::Force(on, value) => {
                ItemKind::Force(self.path(on, true), self.expression(value))
            }
            ItemKind::Torque(torque) => ItemKind::Torque(Torque {
                on: self.body(&torque.on),
                against: torque.against.as_ref().map(|body| self.body(body)),
                value: self.expression(&torque.value),
            }),
            ItemKind::Initials(list) => ItemKind::Initials(
                list.iter()
                    .map(|(path, value)| (self.path(path, false), self.expression(value)))
                    .collect(),
            ),
            // Its words are the language's own.
            ItemKind::Start(value) => ItemKind::Start(value.clone()),
            ItemKind::Coordinates(list) => {
                ItemKind::Coordinates(list.iter().map(|path| self.path(path, false)).collect())
            }
            ItemKind::Stop(condition, reason) => {
                ItemKind::Stop(self.expression(condition), reason.clone())
            }
            ItemKind::Component(_)
            | ItemKind::Repeat(_)
            | ItemKind::Part(_)
            | ItemKind::Use(_)
            | ItemKind::Constants(_)
            | ItemKind::Given(_) => return None,
        })
    }

    fn shifted(&self, name: &Name) -> Name {
        Name {
            text: name.text.clone(),
            span: name.span.shifted(self.scope.shift),
        }
    }

    fn declared(&mut self, name: &Name) -> Name {
        self.names.declared(name, self.scope)
    }

    fn place(&mut self, name: &Name) -> Name {
        self.names.place(name, self.scope)
    }

    fn body(&mut self, name: &Name) -> Name {
        self.names.body(name, self.scope)
    }

    fn path(&mut self, path: &Path, place: bool) -> Path {
        self.names.path(path, self.scope, place)
    }

    fn declarations(&mut self, list: &[Declaration]) -> Vec<Declaration> {
        list.iter()
            .map(|declaration| Declaration {
                name: self.declared(&declaration.name),
                value: self.expression(&declaration.value),
                doc: declaration.doc.clone(),
            })
            .collect()
    }

    fn entries(&mut self, entries: &[Entry]) -> Vec<Entry> {
        entries
            .iter()
            .map(|entry| Entry {
                name: Name {
                    text: self
                        .names
                        .word(&entry.name.text, entry.name.span, self.scope),
                    span: entry.name.span.shifted(self.scope.shift),
                },
                at: entry.at.as_ref().map(|at| self.place(at)),
                value: self.expression(&entry.value),
                exact: entry.exact.map(|span| span.shifted(self.scope.shift)),
            })
            .collect()
    }

    fn optional(&mut self, value: Option<&Expression>) -> Option<Expression> {
        value.map(|value| self.expression(value))
    }

    /// The same expression in its scope; as deep as the parser lets it be.
    fn expression(&mut self, expression: &Expression) -> Expression {
        let kind = match &expression.kind {
            ExpressionKind::Literal { number, unit } => ExpressionKind::Literal {
                number: number.clone(),
                unit: unit.as_ref().map(|unit| self.shifted(unit)),
            },
            ExpressionKind::Text(text) => ExpressionKind::Text(text.clone()),
            ExpressionKind::Reference(path) => self.reference(path),
            ExpressionKind::Call(call) => ExpressionKind::Call(Call {
                name: self.shifted(&call.name),
                arguments: call
                    .arguments
                    .iter()
                    .map(|argument| Argument {
                        name: argument.name.as_ref().map(|name| self.shifted(name)),
                        value: self.expression(&argument.value),
                    })
                    .collect(),
            }),
            ExpressionKind::Sum(parts) => ExpressionKind::Sum(self.signed(parts)),
            ExpressionKind::Product(parts) => ExpressionKind::Product(self.signed(parts)),
            ExpressionKind::Negative(inner) => {
                ExpressionKind::Negative(Box::new(self.expression(inner)))
            }
            ExpressionKind::Power(pair) => ExpressionKind::Power(self.two(pair)),
            ExpressionKind::Comparison(comparison, pair) => {
                ExpressionKind::Comparison(*comparison, self.two(pair))
            }
            ExpressionKind::Pair(pair) => ExpressionKind::Pair(self.two(pair)),
            ExpressionKind::And(parts) => ExpressionKind::And(self.all(parts)),
            ExpressionKind::Or(parts) => ExpressionKind::Or(self.all(parts)),
            ExpressionKind::Conditional(parts) => ExpressionKind::Conditional(Box::new((
                self.expression(&parts.0),
                self.expression(&parts.1),
                self.expression(&parts.2),
            ))),
        };
        Expression {
            kind,
            span: expression.span.shifted(self.scope.shift),
        }
    }

    /// A counter or constant as its number, any other name made whole.
    fn reference(&mut self, path: &Path) -> ExpressionKind {
        let number = path
            .single()
            .and_then(|name| self.names.number(self.scope, &name.text));
        let Some(number) = number else {
            return ExpressionKind::Reference(self.path(path, false));
        };
        let literal = ExpressionKind::Literal {
            number: number.unsigned_abs().to_string(),
            unit: None,
        };
        if number >= 0 {
            return literal;
        }
        ExpressionKind::Negative(Box::new(Expression {
            kind: literal,
            span: path.span.shifted(self.scope.shift),
        }))
    }

    fn two(&mut self, pair: &(Expression, Expression)) -> Box<(Expression, Expression)> {
        Box::new((self.expression(&pair.0), self.expression(&pair.1)))
    }

    fn all(&mut self, parts: &[Expression]) -> Vec<Expression> {
        parts.iter().map(|part| self.expression(part)).collect()
    }

    fn signed(&mut self, parts: &[(bool, Expression)]) -> Vec<(bool, Expression)> {
        parts
            .iter()
            .map(|(sign, part)| (*sign, self.expression(part)))
            .collect()
    }
}
