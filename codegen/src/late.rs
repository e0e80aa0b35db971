//! What is known late is used late.
//!
//! ```text
//! ż   = v - z|v| G                        ż   = v - (z|v|) G
//! F_f = σ0 z + σ1 ż + σ2 v      ──▶       ẍ   = (σ0 z + σ1 v + σ2 v)/m - (σ1 z|v|/m) G
//! ẍ   = F_f/m
//! ```
//!
//! For one trajectory, time is the longest chain of operations from the state to its rates. Most of
//! it leads to one value G, such as that of a friction law; where rates are linear in it, what G is
//! multiplied by and added to are computed while it is not known yet, and one fused operation
//! remains after it. In every sum, what is known last is added last.

use std::collections::HashMap;

use flexure_runtime::tape::Operation;

use crate::program::{Function, Name, Program};
use crate::schedule::order;
use crate::values::{Node, Stage, Value, Values};

/// What takes at least so long, in cycles, is waited for.
const LONG: u32 = 14;
/// More operations than this for a rate are not worth it.
const MORE: usize = 3;

/// Arranges the compiled rates of `program`.
pub(crate) fn arrange(program: &mut Program) {
    let rates = program.compiled.rhs.clone();
    let rates = match latest(&program.values, &rates) {
        Some(late) => split(program, &rates, late),
        None => rates,
    };
    program.compiled.rhs = in_order(program, &rates);
}

/// The same with the terms of every sum in the order in which they are known.
fn in_order(program: &mut Program, rates: &Function) -> Function {
    let arrivals = Arrivals::new(&program.values, rates.roots());
    let all = moving(&program.values, rates.roots());
    let mut uses: HashMap<Value, usize> = HashMap::new();
    let operands = all.iter().flat_map(|value| program.values.operands(*value));
    for value in operands.chain(rates.roots()) {
        *uses.entry(value).or_insert(0) += 1;
    }
    let mut sums: HashMap<Value, Vec<(Value, bool)>> = HashMap::new();
    for &value in &all {
        if !matches!(
            program.values.node(value),
            Node::Apply(Operation::Add | Operation::Subtract, _)
        ) {
            continue;
        }
        let is_inner = |value: Value| {
            uses.get(&value) == Some(&1)
                && !program.names.contains_key(&value)
                && program.values.stage(value) == Stage::State
        };
        let mut terms = Vec::new();
        collect(&program.values, value, false, &is_inner, &mut terms);
        // A product is not waited for: it is fused with its sum.
        let known = |(term, _): &(Value, bool)| match program.values.node(*term) {
            Node::Apply(Operation::Multiply, [a, b, _]) if is_inner(*term) => {
                arrivals.of(a).max(arrivals.of(b))
            }
            _ => arrivals.of(*term),
        };
        if terms.len() < 3 || terms.is_sorted_by_key(known) {
            continue;
        }
        terms.sort_by_key(known);
        // A sum reads best when it starts with a plus.
        if let Some(first) = terms.iter().position(|(_, negative)| !negative) {
            terms[..=first].rotate_right(1);
        }
        sums.insert(value, terms);
    }
    rearranged(program, rates, &sums)
}

/// The terms of a sum, each with whether it counts negatively.
fn collect(
    values: &Values,
    value: Value,
    negative: bool,
    is_inner: &dyn Fn(Value) -> bool,
    terms: &mut Vec<(Value, bool)>,
) {
    let Node::Apply(operation @ (Operation::Add | Operation::Subtract), [a, b, _]) =
        values.node(value)
    else {
        return terms.push((value, negative));
    };
    let minus = negative ^ (operation == Operation::Subtract);
    for (operand, negative) in [(a, negative), (b, minus)] {
        if is_inner(operand) {
            collect(values, operand, negative, is_inner, terms);
        } else {
            terms.push((operand, negative));
        }
    }
}

/// `function` with some sums made of other terms, and what is computed of them computed anew.
fn rearranged(
    program: &mut Program,
    function: &Function,
    sums: &HashMap<Value, Vec<(Value, bool)>>,
) -> Function {
    let mut memo: HashMap<Value, Value> = HashMap::new();
    for value in moving(&program.values, function.roots()) {
        let of = |operand: Value| memo.get(&operand).copied().unwrap_or(operand);
        let new = match (sums.get(&value), program.values.node(value)) {
            (Some(terms), _) => {
                let terms: Vec<(Value, bool)> = terms
                    .iter()
                    .map(|(term, negative)| (of(*term), *negative))
                    .collect();
                added(&mut program.values, &terms)
            }
            (None, Node::Apply(operation, operands)) => {
                let operands = operands.map(of);
                let operands = &operands[..operation.arity()];
                program.values.apply(operation, operands)
            }
            (None, Node::Lookup(table, position)) => program.values.lookup(table, of(position)),
            (None, Node::Curve(index, pivot)) => program.values.curve(index, of(pivot)),
            _ => value,
        };
        if new != value
            && let Some(name) = program.names.get(&value).cloned()
        {
            program.names.entry(new).or_insert(name);
        }
        memo.insert(value, new);
    }
    let results = function.results.iter();
    Function {
        results: results
            .map(|&(position, value)| (position, memo.get(&value).copied().unwrap_or(value)))
            .collect(),
    }
}

/// The sum of terms in their order.
fn added(values: &mut Values, terms: &[(Value, bool)]) -> Value {
    let mut total: Option<Value> = None;
    for &(term, negative) in terms {
        total = Some(match (total, negative) {
            (None, false) => term,
            (None, true) => values.apply(Operation::Negate, &[term]),
            (Some(total), false) => values.apply(Operation::Add, &[total, term]),
            (Some(total), true) => values.apply(Operation::Subtract, &[total, term]),
        });
    }
    total.unwrap_or_else(|| values.constant(0.0))
}

/// About how many cycles an operation takes.
fn latency(values: &Values, value: Value) -> u32 {
    match values.node(value) {
        Node::Curve(..) => 28,
        Node::Apply(operation, _) => match operation {
            Operation::Negate | Operation::Abs => 1,
            Operation::Add
            | Operation::Subtract
            | Operation::Multiply
            | Operation::Min
            | Operation::Max
            | Operation::Sign
            | Operation::IfPositive => 4,
            Operation::Floor | Operation::Lookup | Operation::Unwrap => 8,
            Operation::Divide => LONG,
            Operation::Sqrt => 18,
            _ => 45,
        },
        Node::Lookup(..) => 8,
        _ => 0,
    }
}

/// When values of the state stage are known, in cycles from the start of a function. What depends on
/// coordinates, time and inputs alone is known then: coordinates follow from the rates of the stage
/// before.
struct Arrivals(HashMap<Value, u32>);

impl Arrivals {
    fn new(values: &Values, roots: impl IntoIterator<Item = Value>) -> Self {
        let mut arrivals = Self(HashMap::new());
        for value in moving(values, roots) {
            let mut latest = None;
            for operand in values.operands(value) {
                let is_rate = matches!(values.node(operand), Node::State(_))
                    && values.stage(operand) == Stage::State;
                latest = latest.max(if is_rate {
                    Some(0)
                } else {
                    arrivals.own(operand)
                });
            }
            if let Some(latest) = latest {
                arrivals.0.insert(value, latest + latency(values, value));
            }
        }
        arrivals
    }

    /// `None` if the value is known from the start.
    fn own(&self, value: Value) -> Option<u32> {
        self.0.get(&value).copied()
    }

    fn of(&self, value: Value) -> u32 {
        self.own(value).unwrap_or(0)
    }
}

/// Values of the state stage.
fn moving(values: &Values, roots: impl IntoIterator<Item = Value>) -> Vec<Value> {
    order(values, roots, |value| values.stage(value) == Stage::State)
}

/// The value that is known last of those that take long and that nothing else that takes long is
/// computed of.
fn latest(values: &Values, function: &Function) -> Option<Value> {
    let all = moving(values, function.roots());
    let arrivals = Arrivals::new(values, function.roots());
    let is_long = |value: Value| latency(values, value) >= LONG && arrivals.own(value).is_some();
    let mut is_waited_for: HashMap<Value, bool> = HashMap::new();
    for &value in all.iter().rev() {
        let waited = is_waited_for.get(&value).copied().unwrap_or(false);
        for operand in values.operands(value) {
            *is_waited_for.entry(operand).or_insert(false) |= waited || is_long(value);
        }
    }
    all.iter()
        .copied()
        .filter(|value| is_long(*value) && !is_waited_for.get(value).copied().unwrap_or(false))
        .max_by_key(|value| (arrivals.of(*value), std::cmp::Reverse(*value)))
}

/// A value as `rest` + `factor` times the late one, if there is a factor.
#[derive(Clone, Copy)]
struct Parts {
    rest: Option<Value>,
    factor: Option<Factor>,
}

/// A factor, and whether it counts negatively.
#[derive(Clone, Copy)]
struct Factor {
    size: Value,
    negative: bool,
}

/// The rates with those that are linear in `late` in two parts; all as they are if that takes many
/// more operations.
fn split(program: &mut Program, rates: &Function, late: Value) -> Function {
    let before = moving(&program.values, rates.roots()).len();
    let mut linear = Linear::new(program, rates, late);
    let mut memo: HashMap<Value, Value> = HashMap::new();
    for root in rates.roots() {
        if let Some(Parts {
            rest,
            factor: Some(factor),
        }) = linear.parts(root)
        {
            let together = linear.together(rest, factor);
            memo.insert(root, together);
        }
    }
    for (old, new) in &memo {
        if let Some(name) = program.names.get(old).cloned() {
            program.names.entry(*new).or_insert(name);
        }
    }
    let results = rates.results.iter();
    let arranged = Function {
        results: results
            .map(|&(position, value)| (position, memo.get(&value).copied().unwrap_or(value)))
            .collect(),
    };
    let after = moving(&program.values, arranged.roots()).len();
    if after <= before + MORE * memo.len() {
        arranged
    } else {
        rates.clone()
    }
}

/// Values as linear functions of the late one.
struct Linear<'p> {
    program: &'p mut Program,
    late: Value,
    /// Of every value that depends on the late one: its parts, if it is linear.
    parts: HashMap<Value, Option<Parts>>,
}

impl<'p> Linear<'p> {
    fn new(program: &'p mut Program, rates: &Function, late: Value) -> Self {
        let mut linear = Self {
            program,
            late,
            parts: HashMap::new(),
        };
        for value in moving(&linear.program.values, rates.roots()) {
            let mut operands = linear.program.values.operands(value);
            if value == late {
                let one = linear.program.values.constant(1.0);
                let factor = Factor {
                    size: one,
                    negative: false,
                };
                let parts = Parts {
                    rest: None,
                    factor: Some(factor),
                };
                linear.parts.insert(value, Some(parts));
            } else if operands.any(|operand| linear.parts.contains_key(&operand)) {
                let parts = linear.of_operation(value);
                if let Some(Parts {
                    rest: Some(rest), ..
                }) = parts
                    && !rates.roots().any(|root| root == value)
                {
                    linear.name(value, rest);
                }
                linear.parts.insert(value, parts);
            }
        }
        linear
    }

    /// Parts of any value; `None` if it is not linear.
    fn parts(&self, value: Value) -> Option<Parts> {
        let early = Some(Parts {
            rest: Some(value),
            factor: None,
        });
        self.parts.get(&value).copied().unwrap_or(early)
    }

    fn of_operation(&mut self, value: Value) -> Option<Parts> {
        let Node::Apply(operation, [a, b, _]) = self.program.values.node(value) else {
            return None;
        };
        let of_a = self.parts(a)?;
        Some(match operation {
            Operation::Negate => self.negated(of_a),
            Operation::Add => {
                let of_b = self.parts(b)?;
                self.sum(of_a, of_b)
            }
            Operation::Subtract => {
                let of_b = self.parts(b)?;
                self.difference(of_a, of_b)
            }
            Operation::Multiply => match (of_a.factor, self.parts(b)?) {
                (None, of_b) => self.scaled(of_b, a),
                (Some(_), Parts { factor: None, .. }) => self.scaled(of_a, b),
                _ => return None,
            },
            _ => return None,
        })
    }

    /// Names the rest of a value after it.
    fn name(&mut self, value: Value, rest: Value) {
        let names = &mut self.program.names;
        if let Some(name) = names.get(&value)
            && self.program.values.is_computed(rest)
            && !names.contains_key(&rest)
        {
            let name = Name {
                text: format!("{} so far", name.text),
                meaning: match name.meaning.as_str() {
                    "" => String::new(),
                    meaning => format!("{meaning}, without what is known last"),
                },
            };
            names.insert(rest, name);
        }
    }

    fn apply(&mut self, operation: Operation, operands: &[Value]) -> Value {
        self.program.values.apply(operation, operands)
    }

    fn negated(&mut self, parts: Parts) -> Parts {
        Parts {
            rest: parts
                .rest
                .map(|rest| self.apply(Operation::Negate, &[rest])),
            factor: parts.factor.map(|factor| Factor {
                negative: !factor.negative,
                ..factor
            }),
        }
    }

    fn sum(&mut self, a: Parts, b: Parts) -> Parts {
        let rest = match (a.rest, b.rest) {
            (Some(a), Some(b)) => Some(self.apply(Operation::Add, &[a, b])),
            (one, None) | (None, one) => one,
        };
        let factor = self.factors(a.factor, b.factor);
        Parts { rest, factor }
    }

    fn difference(&mut self, a: Parts, b: Parts) -> Parts {
        let rest = match (a.rest, b.rest) {
            (Some(a), Some(b)) => Some(self.apply(Operation::Subtract, &[a, b])),
            (None, Some(b)) => Some(self.apply(Operation::Negate, &[b])),
            (one, None) => one,
        };
        let minus_b = b.factor.map(|factor| Factor {
            negative: !factor.negative,
            ..factor
        });
        let factor = self.factors(a.factor, minus_b);
        Parts { rest, factor }
    }

    fn factors(&mut self, a: Option<Factor>, b: Option<Factor>) -> Option<Factor> {
        let (Some(a), Some(b)) = (a, b) else {
            return a.or(b);
        };
        let (plus, minus) = if a.negative { (b, a) } else { (a, b) };
        Some(if plus.negative == minus.negative {
            Factor {
                size: self.apply(Operation::Add, &[a.size, b.size]),
                negative: a.negative,
            }
        } else {
            Factor {
                size: self.apply(Operation::Subtract, &[plus.size, minus.size]),
                negative: false,
            }
        })
    }

    fn scaled(&mut self, parts: Parts, by: Value) -> Parts {
        Parts {
            rest: parts
                .rest
                .map(|rest| self.apply(Operation::Multiply, &[by, rest])),
            factor: parts.factor.map(|factor| Factor {
                size: self.apply(Operation::Multiply, &[by, factor.size]),
                ..factor
            }),
        }
    }

    /// The value of both parts.
    fn together(&mut self, rest: Option<Value>, factor: Factor) -> Value {
        let product = self.apply(Operation::Multiply, &[factor.size, self.late]);
        match (rest, factor.negative) {
            (Some(rest), true) => self.apply(Operation::Subtract, &[rest, product]),
            (Some(rest), false) => self.apply(Operation::Add, &[rest, product]),
            (None, true) => self.apply(Operation::Negate, &[product]),
            (None, false) => product,
        }
    }
}
