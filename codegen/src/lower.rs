//! From expressions to values.
//!
//! Sums become additions and subtractions, whole powers multiplications, negative powers
//! divisions. Each product is computed stage by stage, params first, so that nothing that depends
//! on params alone is left for later: `k ω x/m` is `((k/m)·ω)·x` with k/m prepared. Divisions by
//! one moving quantity that occur more than once share its reciprocal.

use std::collections::{HashMap, HashSet};

use flexure_model_dsl::symbolic::{Expr, Function, Graph, Node, Rational, Symbol};
use flexure_runtime::tape::Operation;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::program::Name;
use crate::values::{Stage, Value, Values};

/// What a symbol stands for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Binding {
    /// A value.
    Value(Value),
    /// An expression, under the symbol's name.
    Defined(Expr),
    /// Nothing: evaluates to not-a-number.
    Missing,
}

/// What lowering needs to know of the equations.
pub(crate) struct Context<'g> {
    pub(crate) graph: &'g Graph,
    /// Sines and cosines to compute otherwise.
    pub(crate) replacements: &'g HashMap<Expr, Expr>,
    /// Bases by which more than one product is divided.
    pub(crate) shared_divisors: HashSet<Expr>,
    /// The equations' words on defined symbols.
    pub(crate) meanings: &'g HashMap<Symbol, String>,
}

impl<'g> Context<'g> {
    pub(crate) fn new(
        graph: &'g Graph,
        replacements: &'g HashMap<Expr, Expr>,
        meanings: &'g HashMap<Symbol, String>,
        roots: &[Expr],
    ) -> Self {
        let mut seen = HashSet::new();
        let mut shared_divisors = HashSet::new();
        for expr in graph.reachable(roots) {
            if let Node::Product { factors, .. } = graph.node(expr) {
                for (base, exponent) in factors {
                    if exponent.is_negative() && !seen.insert(*base) {
                        shared_divisors.insert(*base);
                    }
                }
            }
        }
        Self {
            graph,
            replacements,
            shared_divisors,
            meanings,
        }
    }
}

/// Lowers expressions under one meaning of the symbols.
pub(crate) struct Lowering<'c, 'g> {
    context: &'c Context<'g>,
    bindings: Vec<Binding>,
    memo: HashMap<Expr, Value>,
}

/// A sum or product on the way: the value so far, and whether it counts negatively.
type Total = Option<(Value, bool)>;

impl<'c, 'g> Lowering<'c, 'g> {
    /// A lowering with one binding for each symbol of the graph.
    pub(crate) fn new(context: &'c Context<'g>, bindings: Vec<Binding>) -> Self {
        Self {
            context,
            bindings,
            memo: HashMap::new(),
        }
    }

    /// Gives a symbol a value from now on; it must not have been used yet.
    pub(crate) fn bind(&mut self, symbol: Symbol, value: Value) {
        self.bindings[symbol.index()] = Binding::Value(value);
    }

    /// The value of `expr`. Computed values of defined symbols are entered into `names`.
    pub(crate) fn value(
        &mut self,
        values: &mut Values,
        names: &mut std::collections::BTreeMap<Value, Name>,
        expr: Expr,
    ) -> Value {
        let mut stack = vec![expr];
        let mut waiting: HashSet<Expr> = HashSet::new();
        while let Some(&top) = stack.last() {
            if self.memo.contains_key(&top) {
                stack.pop();
                continue;
            }
            let mut missing = Vec::new();
            self.dependencies(top, |operand| {
                if !self.memo.contains_key(&operand) {
                    missing.push(operand);
                }
            });
            // What waits for itself has no value.
            let circular = missing.iter().any(|operand| waiting.contains(operand));
            if missing.is_empty() || circular {
                let value = if circular {
                    values.constant(f64::NAN)
                } else {
                    self.compute(values, top)
                };
                self.name(values, names, top, value);
                self.memo.insert(top, value);
                waiting.remove(&top);
                stack.pop();
            } else {
                waiting.insert(top);
                // The first operand is computed first.
                stack.extend(missing.into_iter().rev());
            }
        }
        self.memo[&expr]
    }

    fn dependencies(&self, expr: Expr, mut visit: impl FnMut(Expr)) {
        if let Some(&replacement) = self.context.replacements.get(&expr) {
            return visit(replacement);
        }
        let graph = self.context.graph;
        match graph.node(expr) {
            Node::Number(_) | Node::Pi => {}
            Node::Symbol(symbol) => {
                if let Binding::Defined(definition) = self.bindings[symbol.index()] {
                    visit(definition);
                }
            }
            Node::Sum { terms, .. } => {
                for (term, _) in terms {
                    match graph.node(*term) {
                        // A product among terms is computed with its coefficient.
                        Node::Product { factors, .. } => {
                            factors.iter().for_each(|(base, _)| visit(*base));
                        }
                        _ => visit(*term),
                    }
                }
            }
            Node::Product { factors, .. } => factors.iter().for_each(|(base, _)| visit(*base)),
            Node::Function(_, arguments) => arguments.iter().copied().for_each(visit),
        }
    }

    fn name(
        &self,
        values: &Values,
        names: &mut std::collections::BTreeMap<Value, Name>,
        expr: Expr,
        value: Value,
    ) {
        let graph = self.context.graph;
        if let Some(symbol) = graph.as_symbol(expr)
            && matches!(self.bindings[symbol.index()], Binding::Defined(_))
            && values.is_computed(value)
        {
            names.entry(value).or_insert_with(|| Name {
                text: graph.symbol_text(symbol).to_owned(),
                meaning: self
                    .context
                    .meanings
                    .get(&symbol)
                    .cloned()
                    .unwrap_or_default(),
            });
        }
    }

    fn compute(&self, values: &mut Values, expr: Expr) -> Value {
        if let Some(replacement) = self.context.replacements.get(&expr) {
            return self.memo[replacement];
        }
        match self.context.graph.node(expr) {
            Node::Number(number) => values.constant(to_f64(number)),
            Node::Pi => values.constant(std::f64::consts::PI),
            Node::Symbol(symbol) => match self.bindings[symbol.index()] {
                Binding::Value(value) => value,
                Binding::Defined(definition) => self.memo[&definition],
                Binding::Missing => values.constant(f64::NAN),
            },
            Node::Sum { constant, terms } => self.sum(values, constant, terms),
            Node::Product {
                coefficient,
                factors,
            } => {
                let (value, negative) = self.product(values, coefficient, factors);
                if negative {
                    values.apply(Operation::Negate, &[value])
                } else {
                    value
                }
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<Value> = arguments.iter().map(|a| self.memo[a]).collect();
                apply_function(values, *function, &arguments)
            }
        }
    }

    /// Adds up stage by stage, so that what params alone decide is one prepared value.
    fn sum(&self, values: &mut Values, constant: &Rational, terms: &[(Expr, Rational)]) -> Value {
        let mut parts: Vec<(Value, bool)> = Vec::with_capacity(terms.len() + 1);
        if !constant.is_zero() {
            let size = values.constant(to_f64(&constant.abs()));
            parts.push((size, constant.is_negative()));
        }
        parts.extend(self.terms(values, terms));
        let mut total: Total = None;
        for stages in [
            &[Stage::Constant, Stage::Parameter][..],
            &[Stage::Configuration],
            &[Stage::State],
        ] {
            let mut group: Vec<(Value, bool)> = parts
                .iter()
                .copied()
                .filter(|(value, _)| stages.contains(&values.stage(*value)))
                .collect();
            // A sum reads best when it starts with a plus.
            if total.is_none_or(|(_, negative)| negative)
                && let Some(first) = group.iter().position(|(_, negative)| !negative)
            {
                group[..=first].rotate_right(1);
            }
            for (value, negative) in group {
                total = Some(match total {
                    None => (value, negative),
                    Some((so_far, minus)) if minus == negative => {
                        (values.apply(Operation::Add, &[so_far, value]), minus)
                    }
                    Some((so_far, false)) => {
                        (values.apply(Operation::Subtract, &[so_far, value]), false)
                    }
                    Some((so_far, true)) => {
                        (values.apply(Operation::Subtract, &[value, so_far]), false)
                    }
                });
            }
        }
        match total {
            None => values.constant(0.0),
            Some((value, false)) => value,
            Some((value, true)) => values.apply(Operation::Negate, &[value]),
        }
    }

    /// The terms of a sum. Different quantities may have one value, as those of equal bodies do:
    /// what occurs several times is written once, times a number.
    fn terms(&self, values: &mut Values, terms: &[(Expr, Rational)]) -> Vec<(Value, bool)> {
        let mut different: Vec<(usize, (Value, bool), i64)> = Vec::with_capacity(terms.len());
        let mut positions: HashMap<Value, usize> = HashMap::with_capacity(terms.len());
        for (index, term) in terms.iter().enumerate() {
            let part = self.term(values, term, 1);
            let position = *positions.entry(part.0).or_insert(different.len());
            if position == different.len() {
                different.push((index, part, 0));
            }
            let (_, first, count) = &mut different[position];
            *count += if *first == part { 1 } else { -1 };
        }
        different.retain(|(_, _, count)| *count != 0);
        different
            .into_iter()
            .map(|(index, part, count)| match count {
                1 => part,
                _ => self.term(values, &terms[index], count),
            })
            .collect()
    }

    /// `count` times a term of a sum.
    fn term(
        &self,
        values: &mut Values,
        (term, coefficient): &(Expr, Rational),
        count: i64,
    ) -> (Value, bool) {
        let coefficient = coefficient * Rational::from_integer(count.into());
        match self.context.graph.node(*term) {
            Node::Product {
                coefficient: inner,
                factors,
            } => self.product(values, &(inner * coefficient), factors),
            _ => self.product(values, &coefficient, &[(*term, Rational::one())]),
        }
    }

    /// Multiplies stage by stage; returns the size and whether it counts negatively.
    fn product(
        &self,
        values: &mut Values,
        coefficient: &Rational,
        factors: &[(Expr, Rational)],
    ) -> (Value, bool) {
        let mut above: Vec<Value> = Vec::new();
        let mut below: Vec<Value> = Vec::new();
        let mut negative = coefficient.is_negative();
        let mut size = to_f64(&coefficient.abs());
        for (base, exponent) in factors {
            let mut value = self.memo[base];
            // A named quantity keeps its own sign, so that emitted code has ω2 and not -ω2.
            let is_named = self.context.graph.as_symbol(*base).is_some();
            if let crate::values::Node::Apply(Operation::Negate, [inner, ..]) = values.node(value)
                && exponent.is_integer()
                && !is_named
            {
                value = inner;
                negative ^= is_odd(exponent);
            }
            let power = power(values, value, &exponent.abs());
            if let Some(number) = values.as_constant(power) {
                negative ^= number.is_sign_negative();
                size = if exponent.is_negative() {
                    size / number.abs()
                } else {
                    size * number.abs()
                };
            } else if !exponent.is_negative() {
                above.push(power);
            } else if values.stage(power) >= Stage::Configuration
                && self.context.shared_divisors.contains(base)
            {
                let one = values.constant(1.0);
                above.push(values.apply(Operation::Divide, &[one, power]));
            } else {
                below.push(power);
            }
        }
        let mut total: Option<Value> = (size != 1.0).then(|| values.constant(size));
        for stages in [
            &[Stage::Constant, Stage::Parameter][..],
            &[Stage::Configuration],
            &[Stage::State],
        ] {
            let mut group = |list: &[Value]| {
                list.iter()
                    .copied()
                    .filter(|value| stages.contains(&values.stage(*value)))
                    .collect::<Vec<_>>()
                    .into_iter()
                    .reduce(|a, b| values.apply(Operation::Multiply, &[a, b]))
            };
            let (over, under) = (group(&above), group(&below));
            if let Some(over) = over {
                total = Some(match total {
                    None => over,
                    Some(so_far) => values.apply(Operation::Multiply, &[so_far, over]),
                });
            }
            if let Some(under) = under {
                let so_far = total.unwrap_or_else(|| values.constant(1.0));
                total = Some(values.apply(Operation::Divide, &[so_far, under]));
            }
        }
        (total.unwrap_or_else(|| values.constant(1.0)), negative)
    }
}

fn is_odd(exponent: &Rational) -> bool {
    exponent.numer().bit(0)
}

/// Whole powers beyond this go to the library.
const LARGEST_POWER: u32 = 64;

/// `base^exponent` for a positive exponent: squarings, a root for halves, else the library.
fn power(values: &mut Values, base: Value, exponent: &Rational) -> Value {
    let half = *exponent.denom() == 2.into();
    match exponent.numer().to_u32() {
        Some(count) if count <= LARGEST_POWER && (exponent.is_integer() || half) => {
            let base = if half {
                values.apply(Operation::Sqrt, &[base])
            } else {
                base
            };
            whole_power(values, base, count)
        }
        _ => {
            let exponent = values.constant(to_f64(exponent));
            values.apply(Operation::Power, &[base, exponent])
        }
    }
}

fn whole_power(values: &mut Values, base: Value, count: u32) -> Value {
    let mut square = base;
    let mut rest = count;
    let mut total: Option<Value> = None;
    while rest > 0 {
        if rest & 1 == 1 {
            total = Some(match total {
                None => square,
                Some(so_far) => values.apply(Operation::Multiply, &[so_far, square]),
            });
        }
        rest >>= 1;
        if rest > 0 {
            square = values.apply(Operation::Multiply, &[square, square]);
        }
    }
    total.unwrap_or_else(|| values.constant(1.0))
}

fn apply_function(values: &mut Values, function: Function, arguments: &[Value]) -> Value {
    let operation = match function {
        Function::Sin => Operation::Sin,
        Function::Cos => Operation::Cos,
        Function::Tan => Operation::Tan,
        Function::Asin => Operation::Asin,
        Function::Acos => Operation::Acos,
        Function::Atan => Operation::Atan,
        Function::Tanh => Operation::Tanh,
        Function::Exp => Operation::Exp,
        Function::Log => Operation::Log,
        Function::Abs => Operation::Abs,
        Function::Sign => Operation::Sign,
        Function::Floor => Operation::Floor,
        Function::Atan2 => Operation::Atan2,
        Function::Min => Operation::Min,
        Function::Max => Operation::Max,
        Function::Power => Operation::Power,
        Function::Unwrap => Operation::Unwrap,
        Function::IfPositive => Operation::IfPositive,
        Function::CosDifference | Function::SinDifference => {
            return difference(values, function, arguments);
        }
        Function::Lookup(table) => return values.lookup(table, arguments[0]),
    };
    values.apply(operation, arguments)
}

/// cos a - cos b = -2 sin((a + b)/2) sin((a - b)/2), sin a - sin b = 2 cos((a + b)/2) sin((a - b)/2).
fn difference(values: &mut Values, function: Function, arguments: &[Value]) -> Value {
    let half = values.constant(0.5);
    let sum = values.apply(Operation::Add, arguments);
    let mean = values.apply(Operation::Multiply, &[half, sum]);
    let (a, b) = (arguments[0], arguments[1]);
    let (factor, of_mean, half_difference) = if function == Function::CosDifference {
        let difference = values.apply(Operation::Subtract, &[b, a]);
        (2.0, Operation::Sin, difference)
    } else {
        let difference = values.apply(Operation::Subtract, &[a, b]);
        (2.0, Operation::Cos, difference)
    };
    let half_difference = values.apply(Operation::Multiply, &[half, half_difference]);
    let of_mean = values.apply(of_mean, &[mean]);
    let of_difference = values.apply(Operation::Sin, &[half_difference]);
    let factor = values.constant(factor);
    let product = values.apply(Operation::Multiply, &[of_mean, of_difference]);
    values.apply(Operation::Multiply, &[factor, product])
}

/// The nearest f64.
pub(crate) fn to_f64(value: &Rational) -> f64 {
    value.to_f64().unwrap_or(if value.is_negative() {
        f64::MIN
    } else {
        f64::MAX
    })
}
