//! Values of a staged program: an arena of operations with sharing.
//!
//! Equal operations on equal operands are one value. What is constant is computed on the way in;
//! what remains knows its [`Stage`], the latest of its operands' stages.

use std::collections::HashMap;

use flexure_runtime::tape::Operation;

/// A value: an index into [`Values`]. Operands have smaller indices than what is computed of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(u32);

impl Value {
    /// Position in the arena.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// When a value is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// When the model is compiled.
    Constant,
    /// Once for a parameter set.
    Parameter,
    /// Whenever the configuration changes: of coordinates, and of what only accepted steps change.
    Configuration,
    /// In every evaluation: of rates, time, inputs and internal states.
    State,
}

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number, by its bits.
    Constant(u64),
    /// A param.
    Param(u32),
    /// An unknown of a Newton block, counted over all blocks.
    Unknown(u32),
    /// Time.
    Time,
    /// A continuous state.
    State(u32),
    /// A discrete state.
    Discrete(u32),
    /// An input.
    Input(u32),
    /// A function of one coordinate that a table gives, counted over all coordinates.
    Tabulated(u32),
    /// An operation; operands beyond its arity repeat the first.
    Apply(Operation, [Value; 3]),
    /// An entry of a table.
    Lookup(u32, Value),
    /// A function of a value that a curve gives, counted over all curves.
    Curve(u32, Value),
}

#[derive(Clone, Debug)]
struct Entry {
    node: Node,
    stage: Stage,
    level: u32,
}

/// The arena.
#[derive(Clone, Debug, Default)]
pub struct Values {
    entries: Vec<Entry>,
    index: HashMap<Node, Value>,
}

impl Values {
    /// Number of values.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The value at a position below [`Values::len`].
    pub fn at(&self, index: usize) -> Value {
        debug_assert!(index < self.entries.len());
        Value(u32::try_from(index).expect("fewer than 2^32 values"))
    }

    /// Where `value` comes from.
    pub fn node(&self, value: Value) -> Node {
        self.entries[value.index()].node
    }

    /// When `value` is computed.
    pub fn stage(&self, value: Value) -> Stage {
        self.entries[value.index()].stage
    }

    /// Number of Newton blocks that come before `value` can be computed.
    pub fn level(&self, value: Value) -> u32 {
        self.entries[value.index()].level
    }

    /// The number that `value` is, if it is one.
    pub fn as_constant(&self, value: Value) -> Option<f64> {
        match self.node(value) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Operands of `value`.
    pub fn operands(&self, value: Value) -> impl Iterator<Item = Value> + use<> {
        let (operands, count) = match self.node(value) {
            Node::Apply(operation, operands) => (operands, operation.arity()),
            Node::Lookup(_, position) | Node::Curve(_, position) => ([position; 3], 1),
            _ => ([value; 3], 0),
        };
        operands.into_iter().take(count)
    }

    /// Whether `value` is computed, rather than given.
    pub fn is_computed(&self, value: Value) -> bool {
        matches!(
            self.node(value),
            Node::Apply(..) | Node::Lookup(..) | Node::Curve(..)
        )
    }

    /// A number.
    pub fn constant(&mut self, value: f64) -> Value {
        self.leaf(Node::Constant(value.to_bits()), Stage::Constant, 0)
    }

    /// A value that is given: at `stage`, after `level` Newton blocks.
    pub fn leaf(&mut self, node: Node, stage: Stage, level: u32) -> Value {
        if let Some(&value) = self.index.get(&node) {
            return value;
        }
        let value = Value(u32::try_from(self.entries.len()).expect("fewer than 2^32 values"));
        self.entries.push(Entry { node, stage, level });
        self.index.insert(node, value);
        value
    }

    /// An operation on as many operands as it takes.
    pub fn apply(&mut self, operation: Operation, operands: &[Value]) -> Value {
        let pick = |index: usize| operands.get(index).copied().unwrap_or(operands[0]);
        let operands = [pick(0), pick(1), pick(2)];
        if let Some(simple) = self.simplified(operation, operands) {
            return simple;
        }
        let operands = match operation {
            // a + b and b + a are shared, as whichever of them was made first.
            Operation::Add | Operation::Multiply => {
                let turned = [operands[1], operands[0], operands[1]];
                if self.index.contains_key(&Node::Apply(operation, turned)) {
                    turned
                } else {
                    [operands[0], operands[1], operands[0]]
                }
            }
            _ => operands,
        };
        let stage = operands.iter().map(|v| self.stage(*v)).max();
        let level = operands.iter().map(|v| self.level(*v)).max();
        self.leaf(
            Node::Apply(operation, operands),
            stage.unwrap_or(Stage::Constant),
            level.unwrap_or(0),
        )
    }

    /// An entry of a table.
    pub fn lookup(&mut self, table: u32, position: Value) -> Value {
        let (stage, level) = (self.stage(position), self.level(position));
        // A table is not known here, so that even a constant position is looked up when prepared.
        self.leaf(
            Node::Lookup(table, position),
            stage.max(Stage::Parameter),
            level,
        )
    }

    /// What a curve gives at `pivot`.
    pub fn curve(&mut self, index: u32, pivot: Value) -> Value {
        let (stage, level) = (self.stage(pivot), self.level(pivot));
        self.leaf(Node::Curve(index, pivot), stage, level)
    }

    fn simplified(&mut self, operation: Operation, operands: [Value; 3]) -> Option<Value> {
        let constants = operands.map(|operand| self.as_constant(operand));
        let arity = operation.arity();
        if let [Some(a), Some(b), Some(c)] = constants
            && operation != Operation::Lookup
        {
            return Some(self.constant(operation.apply(a, || b, || c, || &[])));
        }
        let [a, b, c] = operands;
        let negated = |value: Value| match self.node(value) {
            Node::Apply(Operation::Negate, [inner, ..]) => Some(inner),
            _ => None,
        };
        match operation {
            Operation::Add => {
                if let Some(b) = negated(b) {
                    return Some(self.apply(Operation::Subtract, &[a, b]));
                }
                if let Some(a) = negated(a) {
                    return Some(self.apply(Operation::Subtract, &[b, a]));
                }
            }
            Operation::Subtract => {
                if let Some(b) = negated(b) {
                    return Some(self.apply(Operation::Add, &[a, b]));
                }
            }
            _ => {}
        }
        let is = |index: usize, number: f64| index < arity && constants[index] == Some(number);
        match operation {
            Operation::Negate => match self.node(a) {
                Node::Apply(Operation::Negate, [inner, ..]) => Some(inner),
                Node::Apply(Operation::Subtract, [from, what, _]) => {
                    Some(self.apply(Operation::Subtract, &[what, from]))
                }
                _ => None,
            },
            Operation::Add if is(0, 0.0) => Some(b),
            Operation::Add | Operation::Subtract if is(1, 0.0) => Some(a),
            Operation::Subtract if is(0, 0.0) => Some(self.apply(Operation::Negate, &[b])),
            Operation::Multiply if is(0, 1.0) => Some(b),
            Operation::Multiply | Operation::Divide if is(1, 1.0) => Some(a),
            Operation::Multiply if is(0, -1.0) => Some(self.apply(Operation::Negate, &[b])),
            Operation::Multiply if is(1, -1.0) => Some(self.apply(Operation::Negate, &[a])),
            Operation::IfPositive if b == c => Some(b),
            _ => None,
        }
    }
}
