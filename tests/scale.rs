//! Scale: what a window more in a chain of four-bars costs does not depend on how many there are.
//!
//! Rates of later windows follow from those of earlier ones; were they expanded instead of shared,
//! each window would cost more than the one before.

mod support;

use std::collections::HashSet;

use flexure_codegen::{Program, Stage, Texts, report};
use quote::quote;
use support::compile;
use support::windows::{Lengths, windows};

/// What a model costs.
#[derive(Clone, Copy, Debug)]
struct Cost {
    /// Operations of one evaluation of the right-hand side.
    operations: usize,
    /// Lines of the whole tape, an instruction each.
    tape: usize,
    /// Lines of the emitted Rust.
    lines: usize,
}

/// The operations that the right-hand side computes in each evaluation, its functions of one
/// coordinate in closed form.
fn operations(program: &Program) -> usize {
    let values = &program.values;
    let mut seen = HashSet::new();
    let configurations = program.configurations.iter();
    let closed_forms = configurations.flat_map(|configuration| configuration.functions.roots());
    let mut stack: Vec<_> = program.rhs.roots().chain(closed_forms).collect();
    while let Some(value) = stack.pop() {
        let is_moving = values.stage(value) >= Stage::Configuration;
        if values.is_computed(value) && is_moving && seen.insert(value) {
            stack.extend(values.operands(value));
        }
    }
    seen.len()
}

fn cost(count: usize, lengths: Lengths) -> Cost {
    let equations = compile("windows.flex", &windows(count, lengths))
        .oracle
        .equations;
    let program = flexure_codegen::program(&equations);
    let tape = flexure_codegen::tape(&program);
    let texts = Texts {
        equations: &report::text(&equations),
        latex: &report::latex(&equations),
    };
    let source = flexure_codegen::rust_source(&program, texts, &quote!(::flexure_runtime));
    Cost {
        operations: operations(&program),
        tape: flexure_codegen::tape_listing(&tape).lines().count(),
        lines: source.lines().count(),
    }
}

fn compare(lengths: Lengths) {
    let counts = [1, 2, 5, 10, 20, 40];
    let costs = counts.map(|count| cost(count, lengths));
    println!("{lengths:?} lengths");
    println!("windows  operations    tape  lines of Rust");
    for (count, cost) in counts.iter().zip(&costs) {
        let Cost {
            operations,
            tape,
            lines,
        } = cost;
        println!("{count:7}  {operations:10}  {tape:6}  {lines:13}");
    }
    let [.., ten, twenty, forty] = costs.map(|cost| [cost.operations, cost.tape, cost.lines]);
    let names = ["operations", "lines of the tape", "lines of Rust"];
    for (index, what) in names.into_iter().enumerate() {
        let first = (twenty[index] - ten[index]) as f64 / 10.0;
        let second = (forty[index] - twenty[index]) as f64 / 20.0;
        println!("{what} for each window from 10 to 20: {first}, from 20 to 40: {second}");
        assert!(
            second <= 1.1 * first,
            "{lengths:?} lengths: {what} for each window grow from {first} to {second}"
        );
    }
}

#[test]
fn windows_of_equal_lengths_add_up() {
    compare(Lengths::Equal);
    // They are one body in translation: the equation of motion does not grow at all.
    let [one, many] = [2, 40].map(|count| cost(count, Lengths::Equal));
    assert_eq!(one.operations, many.operations);
}

#[test]
fn windows_of_unequal_lengths_add_up() {
    compare(Lengths::Unequal);
}
