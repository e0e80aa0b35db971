//! In which order values are computed.

use crate::program::{Function, Program};
use crate::values::{Stage, Value, Values};

/// Every computed value that `roots` need and `keep` admits, each after its operands, shortly
/// before its first use.
pub(crate) fn order(
    values: &Values,
    roots: impl IntoIterator<Item = Value>,
    keep: impl Fn(Value) -> bool,
) -> Vec<Value> {
    let mut done = vec![false; values.len()];
    let mut order = Vec::new();
    let mut stack: Vec<(Value, bool)> = Vec::new();
    for root in roots {
        stack.push((root, false));
        while let Some((value, expanded)) = stack.pop() {
            if done[value.index()] || !values.is_computed(value) || !keep(value) {
                continue;
            }
            if expanded {
                done[value.index()] = true;
                order.push(value);
                continue;
            }
            stack.push((value, true));
            let operands: Vec<Value> = values.operands(value).collect();
            stack.extend(operands.into_iter().rev().map(|operand| (operand, false)));
        }
    }
    order
}

/// What a function computes itself: configuration first, then state.
pub(crate) fn moving_order(values: &Values, roots: impl IntoIterator<Item = Value>) -> Vec<Value> {
    let mut order = order(values, roots, |value| {
        values.stage(value) >= Stage::Configuration
    });
    order.sort_by_key(|value| values.stage(*value));
    order
}

/// Values of the parameter stage that a function reads: operands and results.
pub(crate) fn prepared_operands(
    values: &Values,
    order: &[Value],
    roots: impl IntoIterator<Item = Value>,
) -> Vec<Value> {
    let mut seen = std::collections::BTreeSet::new();
    let used = order
        .iter()
        .flat_map(|value| values.operands(*value))
        .chain(roots);
    used.filter(|value| values.stage(*value) == Stage::Parameter && seen.insert(*value))
        .collect()
}

/// All values of the parameter stage that any function of the program reads, in order of making.
pub(crate) fn prepared(program: &Program) -> Vec<Value> {
    prepared_for(&program.values, program.functions())
}

/// The same for compiled code.
pub(crate) fn prepared_compiled(program: &Program) -> Vec<Value> {
    prepared_for(&program.values, &program.compiled_functions())
}

fn prepared_for<'f>(
    values: &Values,
    functions: impl IntoIterator<Item = &'f Function>,
) -> Vec<Value> {
    let mut all = std::collections::BTreeSet::new();
    for function in functions {
        let order = moving_order(values, function.roots());
        all.extend(prepared_operands(values, &order, function.roots()));
    }
    all.into_iter().collect()
}
