//! Curves: expensive functions of one quantity of the state stage, for one trajectory at a time.
//!
//! ```text
//! v ──▶ v/v_s ──▶ exp ──▶ g ──▶ 1/g ──▶ ż, F_f, …      ──▶      v ──curve──▶ 1/g ──▶ ż, F_f, …
//! ```
//!
//! From each transcendental function the way down leads to the quantity that it depends on alone,
//! and up from there to the last values of which that is still true: these are the curves.

use std::collections::{BTreeSet, HashMap, HashSet};

use flexure_runtime::tape::Operation;

use crate::cut::replaced;
use crate::program::{Curve, Program};
use crate::schedule::order;
use crate::values::{Node, Stage, Value, Values};

/// More curves than this would take each other's place in the cache.
const MOST: usize = 3;

/// Takes the curves out of the compiled rates of `program`.
pub(crate) fn take_out(program: &mut Program) {
    let rates = program.compiled.rhs.clone();
    let mut memo = HashMap::new();
    for (pivot, closed_form) in find(&program.values, &rates.roots().collect::<Vec<_>>()) {
        let index = u32::try_from(program.compiled.curves.len()).unwrap_or(u32::MAX);
        let value = program.values.curve(index, pivot);
        if let Some(name) = program.names.get(&closed_form) {
            program.names.insert(value, name.clone());
        }
        memo.insert(closed_form, value);
        program.compiled.curves.push(Curve { pivot, closed_form });
    }
    program.compiled.rhs = replaced(program, &rates, memo);
}

/// Whether an operation is worth a curve.
fn is_expensive(values: &Values, value: Value) -> bool {
    let Node::Apply(operation, _) = values.node(value) else {
        return false;
    };
    matches!(
        operation,
        Operation::Sin
            | Operation::Cos
            | Operation::Tan
            | Operation::Asin
            | Operation::Acos
            | Operation::Atan
            | Operation::Tanh
            | Operation::Exp
            | Operation::Log
            | Operation::Atan2
            | Operation::Power
    )
}

/// Different operands that change from one evaluation to the next.
fn moving(values: &Values, value: Value) -> BTreeSet<Value> {
    let operands = values.operands(value);
    let moving = operands.filter(|operand| values.stage(*operand) >= Stage::Configuration);
    moving.collect()
}

/// What an expensive value is a function of: as far down as there is one quantity, if that is of the
/// state stage.
fn pivot(values: &Values, expensive: Value) -> Option<Value> {
    let only = |value: Value| {
        let moving = moving(values, value);
        moving.first().copied().filter(|_| moving.len() == 1)
    };
    let mut pivot = only(expensive)?;
    while let Some(below) = only(pivot) {
        pivot = below;
    }
    let is_given = matches!(values.node(pivot), Node::State(_));
    let is_of_state = values.stage(pivot) == Stage::State;
    (is_of_state && (is_given || values.is_computed(pivot))).then_some(pivot)
}

/// Curves among the values that `roots` need: what each is a function of, and its closed form.
fn find(values: &Values, roots: &[Value]) -> Vec<(Value, Value)> {
    let all = order(values, roots.iter().copied(), |value| {
        values.stage(value) == Stage::State
    });
    let mut with_expensive: HashSet<Value> = HashSet::new();
    for &value in &all {
        let mut operands = values.operands(value);
        if is_expensive(values, value) || operands.any(|o| with_expensive.contains(&o)) {
            with_expensive.insert(value);
        }
    }
    let mut pivots: Vec<Value> = Vec::new();
    for &value in &all {
        // One curve does not wait for another.
        if is_expensive(values, value)
            && let Some(pivot) = pivot(values, value)
            && !with_expensive.contains(&pivot)
            && !pivots.contains(&pivot)
        {
            pivots.push(pivot);
        }
    }
    let mut found = Vec::new();
    for pivot in pivots {
        let mut of_pivot: HashSet<Value> = HashSet::from([pivot]);
        for &value in &all {
            let moving = moving(values, value);
            if !moving.is_empty() && moving.iter().all(|operand| of_pivot.contains(operand)) {
                of_pivot.insert(value);
            }
        }
        let users = all.iter().filter(|value| !of_pivot.contains(value));
        let used: HashSet<Value> = users
            .flat_map(|value| values.operands(*value))
            .chain(roots.iter().copied())
            .collect();
        let ends = all.iter().copied().filter(|value| {
            of_pivot.contains(value) && used.contains(value) && with_expensive.contains(value)
        });
        found.extend(ends.map(|end| (pivot, end)));
    }
    found.truncate(MOST);
    found
}
