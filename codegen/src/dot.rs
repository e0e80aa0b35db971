//! The right-hand side as a graph for Graphviz: which values are made of which, stage by stage.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::names::Described;
use crate::program::Program;
use crate::schedule::order;
use crate::values::{Node, Stage, Value};

/// The values that the right-hand side needs, in a box for each stage, with an arrow from each
/// operand to what is made of it; a dashed one from a closed form to its entry in a table.
pub fn dot(program: &Program) -> String {
    let values = &program.values;
    let described = Described::new(program);
    let tabulated: Vec<(Value, Value)> = program
        .configurations
        .iter()
        .flat_map(|c| c.functions.roots().zip(c.leaves.iter().copied()))
        .collect();
    let closed_forms = tabulated.iter().map(|(closed_form, _)| *closed_form);
    let roots = closed_forms.chain(program.rhs.roots());
    let computed = order(values, roots, |_| true);
    let mut all: BTreeSet<Value> = computed.iter().copied().collect();
    all.extend(computed.iter().flat_map(|value| values.operands(*value)));
    all.extend(program.rhs.roots());

    let mut text = String::new();
    let _ = writeln!(text, "digraph {} {{", quoted(&program.name));
    text.push_str("  rankdir=LR\n  node [shape=box, style=rounded, fontname=\"sans-serif\"]\n");
    for (stage, title) in [
        (Stage::Parameter, "parameter stage"),
        (Stage::Configuration, "configuration stage"),
        (Stage::State, "state stage"),
    ] {
        let _ = writeln!(
            text,
            "  subgraph {} {{",
            quoted(&format!("cluster {title}"))
        );
        let _ = writeln!(text, "    label={}", quoted(title));
        for value in all.iter().filter(|value| values.stage(**value) == stage) {
            let label = label(program, &described, *value);
            let _ = writeln!(text, "    v{} [label={}]", value.index(), quoted(&label));
        }
        text.push_str("  }\n");
    }
    for value in &computed {
        for operand in values.operands(*value) {
            // Numbers stand in the label.
            if values.as_constant(operand).is_none() {
                let _ = writeln!(text, "  v{} -> v{}", operand.index(), value.index());
            }
        }
    }
    for (closed_form, leaf) in tabulated {
        let (from, to) = (closed_form.index(), leaf.index());
        let _ = writeln!(text, "  v{from} -> v{to} [style=dashed]");
    }
    for (position, value) in &program.rhs.results {
        let row = program.states.get(*position as usize);
        let name = row.map_or("", |row| row.name.as_ref());
        let label = quoted(&format!("rate of {name}"));
        let _ = writeln!(text, "  rate{position} [label={label}, shape=plaintext]");
        if values.as_constant(*value).is_none() {
            let _ = writeln!(text, "  v{} -> rate{position}", value.index());
        }
    }
    text.push_str("}\n");
    text
}

/// What a value is, and what it is called.
fn label(program: &Program, described: &Described, value: Value) -> String {
    let values = &program.values;
    let name = program
        .names
        .get(&value)
        .map(|name| name.text.as_str())
        .or_else(|| described.name(value).filter(|_| !values.is_computed(value)));
    let operation = match values.node(value) {
        Node::Apply(operation, _) => {
            let numbers: Vec<String> = values
                .operands(value)
                .filter_map(|operand| values.as_constant(operand))
                .map(|number| format!(" {number:?}"))
                .collect();
            Some(format!("{}{}", operation.name(), numbers.concat()))
        }
        Node::Lookup(table, _) => Some(format!("table {}", table + 1)),
        Node::Tabulated(_) => Some("tabulated".to_owned()),
        _ => None,
    };
    match (name, operation) {
        (Some(name), Some(operation)) => format!("{name}\n{operation}"),
        (Some(name), None) => name.to_owned(),
        (None, operation) => operation.unwrap_or_default(),
    }
}

/// A string as Graphviz reads it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            _ => quoted.push(character),
        }
    }
    quoted.push('"');
    quoted
}
