//! Reads one item after another with the grammar and builds the tree.

use pest::Parser;

use super::grammar::{Grammar, Rule};
use super::problem::{Problem, explain, unknown_item};
use super::reader::{Parsed, Reader};
use super::split::split;
use super::tree::{File, Item};
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
