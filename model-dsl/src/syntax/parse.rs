//! Reads one item after another with the grammar and builds the tree.

use pest::Parser;

use super::grammar::{Grammar, Rule};
use super::problem::{Problem, explain, unknown_item};
use super::reader::{Parsed, Reader};
use super::split::{DEEPEST_BLOCK, Role, split};
use super::tree::{Component, File, Item, ItemKind, Repeat};
use crate::source::Span;

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
    (
        "component",
        Rule::component_item,
        "component NAME(PARAMETER: KIND, …) { … }",
    ),
    (
        "repeat",
        Rule::repeat_item,
        "repeat NAME from WHOLE NUMBER to WHOLE NUMBER { … }",
    ),
    (
        "part",
        Rule::part_item,
        "part NAME = COMPONENT(PARAMETER = VALUE, …) at POINT = PLACE, …",
    ),
    ("use", Rule::use_item, "use \"FILE.flex\""),
    ("const", Rule::const_item, "const NAME = WHOLE NUMBER"),
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

/// Most problems that are listed.
const MOST_PROBLEMS: usize = 50;

/// Reads a file: the items that could be read, and what is wrong with the others. Places count from
/// `base`.
pub fn parse(text: &str, base: usize) -> (File, Vec<Problem>) {
    if text.len() > LARGEST_FILE {
        let problem = Problem::new(
            format!("this file is larger than {} MiB", LARGEST_FILE >> 20),
            Span::new(base, base),
            "a model file is a few pages; tables of data belong in a CSV file",
        );
        return (File::default(), vec![problem]);
    }
    let split = split(text);
    let mut problems: Vec<Problem> = split.problems;
    for problem in &mut problems {
        problem.span = problem.span.shifted(base);
        for (span, _) in &mut problem.related {
            *span = span.shifted(base);
        }
    }
    // Items that hold items, with what they hold so far; the file itself comes first. One that
    // could not be read is dropped with its contents.
    let mut open: Vec<(Option<Item>, Vec<Item>)> = vec![(None, Vec::new())];
    for piece in &split.pieces {
        let span = piece.span.shifted(base);
        if piece.role == Role::Closes {
            let (Some((header, items)), Some((_, outer))) = closed(&mut open) else {
                continue;
            };
            outer.extend(header.map(|header| with_items(header, items, span.end)));
            continue;
        }
        let read = if problems.len() >= MOST_PROBLEMS {
            None
        } else {
            match item(&piece.text, span, piece.role) {
                Ok(item) => Some(item),
                Err(problem) => {
                    problems.push(*problem);
                    None
                }
            }
        };
        match (piece.role, open.last_mut()) {
            (Role::Opens, _) => open.push((read.filter(|_| open.len() <= DEEPEST_BLOCK), vec![])),
            (_, Some((_, items))) => items.extend(read),
            (_, None) => {}
        }
    }
    problems.sort_by_key(|problem| problem.span);
    problems.truncate(MOST_PROBLEMS);
    let file = File {
        doc: split.doc,
        items: open.into_iter().next().unwrap_or_default().1,
    };
    (file, problems)
}

type Open = (Option<Item>, Vec<Item>);

/// The innermost open item, taken, and the one that holds it.
fn closed(open: &mut Vec<Open>) -> (Option<Open>, Option<&mut Open>) {
    let last = if open.len() > 1 { open.pop() } else { None };
    (last, open.last_mut())
}

fn with_items(mut header: Item, inner: Vec<Item>, end: usize) -> Item {
    match &mut header.kind {
        ItemKind::Component(Component { items, .. }) | ItemKind::Repeat(Repeat { items, .. }) => {
            *items = inner;
        }
        _ => {}
    }
    header.span.end = end;
    header
}

fn item(text: &str, span: Span, role: Role) -> Parsed<Item> {
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
    if role == Role::Item && matches!(keyword, "component" | "repeat") {
        return Err(Box::new(Problem::new(
            format!("this `{keyword}` has no braces"),
            word_span,
            format!("it is written `{form}`"),
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
