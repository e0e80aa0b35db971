//! The cut: the functions of one coordinate that a right-hand side needs, to be tabulated.
//!
//! ```text
//! φ̈1 = (τ - P' - ½ A' φ̇1²) / A     ──▶     φ̈1 = c0(φ1) + c1(φ1) F_joint + c2(φ1) F_f + c3(φ1) φ̇1²
//! ```
//!
//! A rate is first written as a sum of coefficients that depend on one coordinate times what does
//! not: products are distributed over sums that nothing else uses, so that 1/A and its like go into
//! the coefficients. Then every value of one coordinate alone that something else is computed of
//! is a function of the cut, unless it costs no more than a table's entry does. Where there is a
//! table, what the end of a step needs of the same coordinate (turn references, closures) is in it
//! too. What is computed stays the same in closed form.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use flexure_runtime::tape::Operation;

use crate::names::identifier;
use crate::program::{Compiled, Configuration, Function, Name, Program};
use crate::schedule::order;
use crate::values::{Node, Stage, Value, Values};

/// A function that costs no more than this (in additions) is computed where it is needed.
const CHEAP: u32 = 8;
/// What a table costs besides its entries: to find the place in it.
const PLACE: u32 = 10;
/// What an entry of a table costs, side by side with others.
const ENTRY: u32 = 6;
/// More functions than this are not tabulated for one coordinate.
const MOST: usize = 24;

/// Takes the functions of one coordinate out of the rates of `program`, where it pays, and out of
/// what ends a step.
pub(crate) fn cut(program: &mut Program) {
    program.compiled = Compiled {
        rhs: program.rhs.clone(),
        accept: program.accept.clone(),
        closures: program.closures.clone(),
        curves: Vec::new(),
    };
    let plain = program.rhs.clone();
    let folded = Folding::new(program).fold();
    let count = |function: &Function| -> usize {
        let cuts = boundary(&program.values, function);
        cuts.values().map(BTreeSet::len).sum()
    };
    // A tie goes to the folded form: it leaves fewer operations.
    let rates = if count(&folded.rates) <= count(&plain) {
        folded.rates
    } else {
        plain
    };
    let known: Vec<usize> = program.coordinates().iter().map(|(q, _)| *q).collect();
    let paying: Vec<(u32, Vec<Value>)> = boundary(&program.values, &rates)
        .into_iter()
        .filter(|(coordinate, _)| known.contains(&(*coordinate as usize)))
        .map(|(coordinate, values)| (coordinate, values.into_iter().collect::<Vec<_>>()))
        .filter(|(_, values)| pays(&program.values, values))
        .collect();
    if paying.is_empty() {
        return;
    }
    program.names.extend(folded.names);
    let mut at_ends = [&program.accept, &program.closures].map(|f| boundary(&program.values, f));
    let mut leaves = HashMap::new();
    for (coordinate, mut values) in paying {
        let rates = values.len();
        for cuts in &mut at_ends {
            let others = cuts.remove(&coordinate).unwrap_or_default();
            for value in others {
                if values.len() < MOST && !values.contains(&value) {
                    values.push(value);
                }
            }
        }
        let mut configuration = Configuration {
            coordinate,
            rates,
            functions: Function::default(),
            leaves: Vec::with_capacity(values.len()),
        };
        for (position, value) in (0..).zip(values) {
            let index = u32::try_from(leaves.len()).unwrap_or(u32::MAX);
            let leaf = program
                .values
                .leaf(Node::Tabulated(index), Stage::Configuration, 0);
            leaves.insert(value, leaf);
            if let Some(name) = program.names.get(&value) {
                program.names.insert(leaf, name.clone());
            }
            configuration.functions.results.push((position, value));
            configuration.leaves.push(leaf);
        }
        program.configurations.push(configuration);
    }
    program.rhs = replaced(program, &rates, leaves.clone());
    program.compiled.rhs = program.rhs.clone();
    program.compiled.accept = replaced(program, &program.accept.clone(), leaves.clone());
    program.compiled.closures = replaced(program, &program.closures.clone(), leaves);
}

/// For each value that depends on nothing but params, turn references and at most one coordinate:
/// that coordinate, if there is one.
type Coordinates = Vec<Option<Option<u32>>>;

/// Extends `of` to all values.
fn extend(of: &mut Coordinates, values: &Values) {
    for index in of.len()..values.len() {
        let value = values.at(index);
        let is_moving = values.stage(value) >= Stage::State;
        let own = match values.node(value) {
            _ if is_moving => None,
            Node::State(coordinate) => Some(Some(coordinate)),
            Node::Tabulated(_) => None,
            _ => values
                .operands(value)
                .map(|operand| of[operand.index()])
                .try_fold(None, |so_far, operand| match (so_far, operand?) {
                    (None, one) | (one, None) => Some(one),
                    (Some(a), Some(b)) => (a == b).then_some(Some(a)),
                }),
        };
        of.push(own);
    }
}

/// For each coordinate the functions of it alone that the rest of `function` is computed of.
fn boundary(values: &Values, function: &Function) -> BTreeMap<u32, BTreeSet<Value>> {
    let mut of = Coordinates::new();
    extend(&mut of, values);
    let alone = |value: Value| match of[value.index()] {
        Some(Some(coordinate)) if values.is_computed(value) => Some(coordinate),
        _ => None,
    };
    let rest = order(values, function.roots(), |value| alone(value).is_none());
    let mut cuts: BTreeMap<u32, BTreeSet<Value>> = BTreeMap::new();
    let needed = rest
        .iter()
        .filter(|value| values.stage(**value) >= Stage::Configuration)
        .flat_map(|value| values.operands(*value))
        .chain(function.roots());
    for value in needed {
        if let Some(coordinate) = alone(value)
            && cost(values, [value]) > CHEAP
        {
            cuts.entry(coordinate).or_default().insert(value);
        }
    }
    for cut in cuts.values_mut() {
        // What one operation makes of the others takes no entry.
        let all = cut.clone();
        cut.retain(|value| {
            let Node::Apply(operation, _) = values.node(*value) else {
                return true;
            };
            let mut operands = values.operands(*value);
            !(weight(operation) <= 1
                && operands.all(|operand| {
                    all.contains(&operand) || values.stage(operand) < Stage::Configuration
                }))
        });
    }
    cuts
}

/// What an operation costs, in additions.
fn weight(operation: Operation) -> u32 {
    match operation {
        Operation::Negate | Operation::Add | Operation::Subtract | Operation::Multiply => 1,
        Operation::Abs
        | Operation::Sign
        | Operation::Floor
        | Operation::Min
        | Operation::Max
        | Operation::IfPositive
        | Operation::Unwrap
        | Operation::Lookup => 2,
        Operation::Divide | Operation::Sqrt => 6,
        _ => 20,
    }
}

/// What values cost in closed form, what they share counted once.
fn cost(values: &Values, roots: impl IntoIterator<Item = Value>) -> u32 {
    let all = order(values, roots, |value| {
        values.stage(value) >= Stage::Configuration
    });
    let mut angles = BTreeSet::new();
    all.iter()
        .map(|value| match values.node(*value) {
            // Sine and cosine of one angle are computed together.
            Node::Apply(Operation::Sin | Operation::Cos, [angle, ..]) if !angles.insert(angle) => 2,
            Node::Apply(operation, _) => weight(operation),
            _ => 1,
        })
        .sum()
}

/// Whether a table costs less than half of the closed forms.
fn pays(values: &Values, functions: &[Value]) -> bool {
    let entries = u32::try_from(functions.len()).unwrap_or(u32::MAX);
    functions.len() <= MOST
        && 2 * (PLACE + ENTRY * entries) < cost(values, functions.iter().copied())
}

/// `function` with some values replaced, and what is computed of them computed anew under the names
/// that it had.
pub(crate) fn replaced(
    program: &mut Program,
    function: &Function,
    mut memo: HashMap<Value, Value>,
) -> Function {
    let kept: Vec<Value> = memo.keys().copied().collect();
    let moving = order(&program.values, function.roots(), |value| {
        program.values.stage(value) >= Stage::Configuration && !kept.contains(&value)
    });
    for value in moving {
        let of = |operand: Value| memo.get(&operand).copied().unwrap_or(operand);
        let new = match program.values.node(value) {
            Node::Apply(operation, operands) => {
                let operands = operands.map(of);
                program
                    .values
                    .apply(operation, &operands[..operation.arity()])
            }
            Node::Lookup(table, position) => program.values.lookup(table, of(position)),
            _ => value,
        };
        if new != value
            && let Some(name) = program.names.get(&value).cloned()
        {
            program.names.entry(new).or_insert(name);
        }
        memo.insert(value, new);
    }
    Function {
        results: function
            .results
            .iter()
            .map(|&(position, value)| (position, memo.get(&value).copied().unwrap_or(value)))
            .collect(),
    }
}

/// A coefficient of one coordinate or of params, times something else or nothing.
#[derive(Clone, Copy, Debug)]
struct Term {
    coefficient: Value,
    atom: Option<Value>,
}

/// Rates with their coefficients folded, and names for these.
struct Folded {
    rates: Function,
    names: BTreeMap<Value, Name>,
}

/// Folds coefficients of one coordinate.
struct Folding<'p> {
    program: &'p mut Program,
    of: Coordinates,
    uses: HashMap<Value, usize>,
}

impl<'p> Folding<'p> {
    fn new(program: &'p mut Program) -> Self {
        let mut uses = HashMap::new();
        let all = order(&program.values, program.rhs.roots(), |_| true);
        let used = all.iter().flat_map(|value| program.values.operands(*value));
        for value in used.chain(program.rhs.roots()) {
            *uses.entry(value).or_insert(0) += 1;
        }
        let mut of = Coordinates::new();
        extend(&mut of, &program.values);
        Self { program, of, uses }
    }

    fn fold(mut self) -> Folded {
        let plain = self.program.rhs.clone();
        let mut names = BTreeMap::new();
        let mut memo = HashMap::new();
        for &(_, root) in &plain.results {
            if !memo.contains_key(&root)
                && let Some(folded) = self.fold_root(root, &mut names)
            {
                memo.insert(root, folded);
            }
        }
        let rates = replaced(self.program, &plain, memo);
        Folded { rates, names }
    }

    /// A rate as a sum over its coefficients; `None` if there is nothing to fold.
    fn fold_root(&mut self, root: Value, names: &mut BTreeMap<Value, Name>) -> Option<Value> {
        if self.program.values.stage(root) < Stage::State {
            return None;
        }
        let terms = self.expand(root, true);
        let terms = self.collected(terms);
        let moving = terms.iter().filter(|term| self.is_moving(term.coefficient));
        if terms.len() < 2 || moving.count() == 0 {
            return None;
        }
        let name = self.program.names.get(&root).cloned();
        let mut total: Option<Value> = None;
        // What depends on the coordinate alone first.
        let (alone, others): (Vec<Term>, Vec<Term>) =
            terms.into_iter().partition(|term| term.atom.is_none());
        for term in alone.into_iter().chain(others) {
            if self.is_moving(term.coefficient) {
                self.name(term, name.as_ref(), names);
            }
            let value = match term.atom {
                Some(atom) => self.apply(Operation::Multiply, &[term.coefficient, atom]),
                None => term.coefficient,
            };
            total = Some(match total {
                Some(total) => self.apply(Operation::Add, &[total, value]),
                None => value,
            });
        }
        if let (Some(total), Some(name)) = (total, name) {
            names.insert(total, name);
        }
        total
    }

    /// Names a coefficient after the rate that it is part of.
    fn name(&self, term: Term, rate: Option<&Name>, names: &mut BTreeMap<Value, Name>) {
        let Some(rate) = rate else { return };
        let Some(coordinate) = self.of[term.coefficient.index()].flatten() else {
            return;
        };
        let coordinate = &self.program.symbols.states[coordinate as usize];
        let name = match term.atom {
            None => Name {
                text: format!("{} of {coordinate}", rate.text),
                meaning: format!(
                    "what {} is by `{}` alone",
                    rate.text,
                    identifier(coordinate)
                ),
            },
            Some(atom) => match self.text(atom) {
                Some(atom) => Name {
                    meaning: String::new(),
                    text: format!("{} per {atom}", rate.text),
                },
                None => return,
            },
        };
        names.insert(term.coefficient, name);
    }

    /// What is written for a value that has a name, or is a square of such.
    fn text(&self, value: Value) -> Option<String> {
        let symbols = &self.program.symbols;
        if let Some(name) = self.program.names.get(&value) {
            return Some(name.text.clone());
        }
        match self.program.values.node(value) {
            Node::State(index) => symbols.states.get(index as usize).cloned(),
            Node::Input(index) => symbols.inputs.get(index as usize).cloned(),
            Node::Apply(Operation::Multiply, [a, b, _]) if a == b => {
                Some(format!("{} squared", self.text(a)?))
            }
            _ => None,
        }
    }

    /// A value as a sum of terms, as far down as products of coefficients over sums go.
    fn expand(&mut self, value: Value, is_root: bool) -> Vec<Term> {
        let one = self.program.values.constant(1.0);
        let whole = vec![Term {
            coefficient: one,
            atom: Some(value),
        }];
        if self.is_coefficient(value) {
            return vec![Term {
                coefficient: value,
                atom: None,
            }];
        }
        let Node::Apply(operation, [a, b, _]) = self.program.values.node(value) else {
            return whole;
        };
        if !is_root && self.uses.get(&value) != Some(&1) {
            return whole;
        }
        let terms = match operation {
            Operation::Negate => {
                let terms = self.expand(a, false);
                self.negated(terms)
            }
            Operation::Add | Operation::Subtract => {
                let mut terms = self.expand(a, false);
                let others = self.expand(b, false);
                terms.extend(match operation {
                    Operation::Add => others,
                    _ => self.negated(others),
                });
                terms
            }
            Operation::Multiply if self.is_coefficient(a) => self.scaled(a, b),
            Operation::Multiply if self.is_coefficient(b) => self.scaled(b, a),
            Operation::Divide if self.is_coefficient(b) => {
                let per = self.apply(Operation::Divide, &[one, b]);
                self.scaled(per, a)
            }
            _ => return whole,
        };
        let is_folded = terms.iter().any(|term| self.is_moving(term.coefficient));
        match terms[..] {
            _ if is_folded => terms,
            // A param in front is a coefficient too.
            [Term { atom: Some(_), .. }] => terms,
            _ => whole,
        }
    }

    /// `coefficient` times `value`: what only params weigh in it stays together, and by params alone
    /// nothing is taken apart.
    fn scaled(&mut self, coefficient: Value, value: Value) -> Vec<Term> {
        let terms = self.expand(value, false);
        let terms = self.collected(terms);
        let (own, rest): (Vec<Term>, Vec<Term>) = terms
            .into_iter()
            .partition(|term| term.atom.is_none() || self.is_moving(term.coefficient));
        if !rest.is_empty() && !own.is_empty() && !self.is_moving(coefficient) {
            return Vec::new();
        }
        let mut scaled: Vec<Term> = own
            .into_iter()
            .map(|term| Term {
                coefficient: self.apply(Operation::Multiply, &[coefficient, term.coefficient]),
                atom: term.atom,
            })
            .collect();
        if let [term] = rest[..] {
            scaled.push(Term {
                coefficient: self.apply(Operation::Multiply, &[coefficient, term.coefficient]),
                atom: term.atom,
            });
            return scaled;
        }
        let together = if scaled.is_empty() {
            Some(value)
        } else {
            rest.into_iter().fold(None, |sum: Option<Value>, term| {
                let atom = term.atom.unwrap_or(term.coefficient);
                let part = self.apply(Operation::Multiply, &[term.coefficient, atom]);
                Some(match sum {
                    Some(sum) => self.apply(Operation::Add, &[sum, part]),
                    None => part,
                })
            })
        };
        scaled.extend(together.map(|atom| Term {
            coefficient,
            atom: Some(atom),
        }));
        scaled
    }

    fn negated(&mut self, terms: Vec<Term>) -> Vec<Term> {
        terms
            .into_iter()
            .map(|term| Term {
                coefficient: self.negative(term.coefficient),
                atom: term.atom,
            })
            .collect()
    }

    /// Minus a coefficient, with the sign as far inside as it takes no more operations, so that a
    /// function of the cut has its own sign.
    fn negative(&mut self, value: Value) -> Value {
        if let Node::Apply(Operation::Multiply, [a, b, _]) = self.program.values.node(value)
            && let Node::Apply(operation, [c, d, _]) = self.program.values.node(b)
        {
            let inner = match operation {
                // What is used elsewhere stays as it is.
                Operation::Add if !self.uses.contains_key(&b) => {
                    let c = self.negative(c);
                    self.apply(Operation::Subtract, &[c, d])
                }
                Operation::Negate | Operation::Subtract | Operation::Multiply => self.negative(b),
                _ => return self.apply(Operation::Negate, &[value]),
            };
            return self.apply(Operation::Multiply, &[a, inner]);
        }
        self.apply(Operation::Negate, &[value])
    }

    /// Terms with one atom are one term.
    fn collected(&mut self, terms: Vec<Term>) -> Vec<Term> {
        let mut collected: Vec<Term> = Vec::with_capacity(terms.len());
        for term in terms {
            match collected.iter().position(|other| other.atom == term.atom) {
                Some(place) => {
                    let both = [collected[place].coefficient, term.coefficient];
                    collected[place].coefficient = self.apply(Operation::Add, &both);
                }
                None => collected.push(term),
            }
        }
        collected
    }

    fn apply(&mut self, operation: Operation, operands: &[Value]) -> Value {
        let value = self.program.values.apply(operation, operands);
        extend(&mut self.of, &self.program.values);
        value
    }

    /// Whether a value depends on one coordinate at most.
    fn is_coefficient(&self, value: Value) -> bool {
        self.of.get(value.index()).is_some_and(Option::is_some)
    }

    /// Whether a value depends on a coordinate, and on nothing else that moves.
    fn is_moving(&self, value: Value) -> bool {
        self.of
            .get(value.index())
            .copied()
            .flatten()
            .flatten()
            .is_some()
    }
}
