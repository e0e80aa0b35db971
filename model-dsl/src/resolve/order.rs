//! The order in which declarations that use each other are resolved.

use std::collections::HashMap;

use crate::syntax::tree::{Declaration, Expression, ExpressionKind, ItemKind};

/// Positions of declarations, each after those it uses; or a circle of them.
pub(super) fn by_use(declarations: &[&Declaration]) -> Result<Vec<usize>, Vec<usize>> {
    let positions: HashMap<&str, usize> = declarations
        .iter()
        .enumerate()
        .map(|(index, declaration)| (declaration.name.text.as_str(), index))
        .collect();
    let uses: Vec<Vec<usize>> = declarations
        .iter()
        .map(|declaration| {
            let mut used = Vec::new();
            names_in(&declaration.value, &mut |name| {
                used.extend(positions.get(name));
            });
            used
        })
        .collect();
    let mut state = vec![State::New; declarations.len()];
    let mut order = Vec::with_capacity(declarations.len());
    for root in 0..declarations.len() {
        // Each entry of the path is a declaration and how many of its uses were followed.
        let mut path = vec![(root, 0)];
        while let Some((index, followed)) = path.last_mut() {
            let index = *index;
            if *followed == 0 {
                if state[index] == State::Done {
                    path.pop();
                    continue;
                }
                state[index] = State::Open;
            }
            match uses[index].get(*followed) {
                None => {
                    state[index] = State::Done;
                    order.push(index);
                    path.pop();
                }
                Some(&used) => {
                    *followed += 1;
                    match state[used] {
                        State::Done => {}
                        State::New => path.push((used, 0)),
                        State::Open => {
                            let circle = path.iter().map(|&(index, _)| index);
                            return Err(circle.skip_while(|&index| index != used).collect());
                        }
                    }
                }
            }
        }
    }
    Ok(order)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    Open,
    Done,
}

/// Calls `visit` for every name without a dot in `expression`.
pub(super) fn names_in<'e>(expression: &'e Expression, visit: &mut dyn FnMut(&'e str)) {
    match &expression.kind {
        ExpressionKind::Literal { .. } | ExpressionKind::Text(_) => {}
        ExpressionKind::Reference(path) => {
            if let Some(name) = path.single() {
                visit(&name.text);
            }
        }
        ExpressionKind::Call(call) => {
            for argument in &call.arguments {
                names_in(&argument.value, visit);
            }
        }
        ExpressionKind::Sum(parts) | ExpressionKind::Product(parts) => {
            for (_, part) in parts {
                names_in(part, visit);
            }
        }
        ExpressionKind::Negative(inner) => names_in(inner, visit),
        ExpressionKind::Power(pair)
        | ExpressionKind::Comparison(_, pair)
        | ExpressionKind::Pair(pair) => {
            names_in(&pair.0, visit);
            names_in(&pair.1, visit);
        }
        ExpressionKind::And(parts) | ExpressionKind::Or(parts) => {
            for part in parts {
                names_in(part, visit);
            }
        }
        ExpressionKind::Conditional(parts) => {
            names_in(&parts.0, visit);
            names_in(&parts.1, visit);
            names_in(&parts.2, visit);
        }
    }
}

/// Calls `visit` for every name without a dot that an item uses.
pub(super) fn names_in_item<'e>(item: &'e ItemKind, visit: &mut dyn FnMut(&'e str)) {
    let mut expressions: Vec<&'e Expression> = Vec::new();
    match item {
        ItemKind::Model(_)
        | ItemKind::Coordinates(_)
        | ItemKind::Set(_)
        | ItemKind::Component(_)
        | ItemKind::Repeat(_)
        | ItemKind::Part(_)
        | ItemKind::Use(_)
        | ItemKind::Constants(_)
        | ItemKind::Given(_) => {}
        ItemKind::Params(list)
        | ItemKind::Lets(list)
        | ItemKind::Drives(list)
        | ItemKind::Outputs(list)
        | ItemKind::Grounds(list)
        | ItemKind::DrawnPoints(list) => expressions.extend(list.iter().map(|d| &d.value)),
        ItemKind::Point(point) => expressions.push(&point.at),
        ItemKind::Input(input) => expressions.push(&input.value),
        ItemKind::Link(link) => expressions.extend(link.entries.iter().map(|e| &e.value)),
        ItemKind::Slide(slide) => {
            expressions.extend(slide.entries.iter().map(|e| &e.value));
            expressions.extend(slide.along.iter().chain(&slide.through));
        }
        ItemKind::Hinge(hinge) => expressions.extend(hinge.entries.iter().map(|e| &e.value)),
        ItemKind::Spring(spring) => {
            expressions.extend(spring.entries.iter().map(|e| &e.value));
            expressions.extend(&spring.along);
        }
        ItemKind::Contact(contact) => {
            expressions.extend(contact.entries.iter().map(|e| &e.value));
        }
        ItemKind::Gravity(value) | ItemKind::Force(_, value) | ItemKind::Start(value) => {
            expressions.push(value);
        }
        ItemKind::Torque(torque) => expressions.push(&torque.value),
        ItemKind::Initials(initials) => expressions.extend(initials.iter().map(|(_, v)| v)),
        ItemKind::Stop(condition, _) => expressions.push(condition),
    }
    for expression in expressions {
        names_in(expression, visit);
    }
}
