//! Canonical form: what makes equal expressions one node.
//!
//! Numbers fold, like terms and like factors meet, signs come out of odd functions; nothing is
//! multiplied out. Operands are older than what they make up, so one pass from the youngest part to
//! the oldest opens every nested sum or product exactly once.

use std::collections::BTreeMap;
use std::ops::Bound;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};

use super::{Expr, Function, Graph, Node, Rational};

/// Constants are folded only while they stay this small, so that no input can make them explode.
const FOLD_LIMIT_BITS: u64 = 2304;

/// Bits that are kept of a number beyond that size.
const ROUNDED_BITS: i64 = 512;

impl Graph {
    // ── Sums ───────────────────────────────────────────────────────────────────────────────────

    /// `constant + Σ coefficient·term`, in canonical form.
    pub fn linear(&mut self, constant: Rational, terms: &[(Expr, Rational)]) -> Expr {
        let mut total = constant;
        let mut collected: BTreeMap<Expr, Rational> = BTreeMap::new();
        for (term, coefficient) in terms {
            match self.node(*term) {
                Node::Number(value) => total = limited(total + value * coefficient),
                Node::Product {
                    coefficient: inner,
                    factors,
                } if !inner.is_one() => {
                    let scaled = inner * coefficient;
                    let factors = factors.clone();
                    // The bare product may be a sum: that in 2·(a + b).
                    let bare = self.powers(Rational::one(), &factors);
                    collect(&mut collected, bare, scaled);
                }
                Node::Pi
                | Node::Symbol(_)
                | Node::Sum { .. }
                | Node::Product { .. }
                | Node::Function(..) => collect(&mut collected, *term, coefficient.clone()),
            }
        }
        // Sums open up only where nothing has to be multiplied out, and only once it is known how
        // often they occur: S - ½ S is ½ S.
        let mut done = None;
        while let Some((sum, coefficient)) = next_below(&collected, done, |term, k| {
            k.abs().is_one() && matches!(self.node(term), Node::Sum { .. })
        }) {
            collected.remove(&sum);
            done = Some(sum);
            if let Node::Sum { constant, terms } = self.node(sum) {
                total = limited(total + constant * &coefficient);
                for (inner, inner_coefficient) in terms {
                    collect(&mut collected, *inner, inner_coefficient * &coefficient);
                }
            }
        }
        collected.retain(|_, coefficient| !coefficient.is_zero());
        if collected.is_empty() {
            return self.number(total);
        }
        if total.is_zero()
            && collected.len() == 1
            && let Some((term, coefficient)) = collected.pop_first()
        {
            return self.scale(term, coefficient);
        }
        self.intern(Node::Sum {
            constant: total,
            terms: collected.into_iter().collect(),
        })
    }

    // ── Products ───────────────────────────────────────────────────────────────────────────────

    /// `coefficient · Π factor^exponent`, in canonical form.
    pub fn powers(&mut self, coefficient: Rational, factors: &[(Expr, Rational)]) -> Expr {
        let mut total = limited(coefficient);
        let mut collected: BTreeMap<Expr, Rational> = BTreeMap::new();
        for (factor, exponent) in factors {
            if self.is_zero(*factor) && exponent.is_positive() {
                total = Rational::zero();
            }
            collect(&mut collected, *factor, exponent.clone());
        }
        // Products open up under whole powers; numbers join the coefficient.
        let mut done = None;
        while !total.is_zero()
            && let Some((factor, exponent)) = next_below(&collected, done, |_, _| true)
        {
            done = Some(factor);
            if exponent.is_zero() {
                collected.remove(&factor);
                continue;
            }
            match self.node(factor) {
                Node::Number(value) => {
                    // Of 2^(3/2), 2 joins and 2^(1/2) is left.
                    let whole = exponent.floor();
                    let rest = &exponent - &whole;
                    if let Some(folded) = joined(&total, value, &exponent) {
                        total = folded;
                        collected.remove(&factor);
                    } else if !whole.is_zero()
                        && !value.is_zero()
                        && let Some(folded) = joined(&total, value, &whole)
                    {
                        total = folded;
                        collected.insert(factor, rest);
                    }
                }
                Node::Product {
                    coefficient,
                    factors,
                } if exponent.is_integer() => {
                    if let Some(folded) = joined(&total, coefficient, &exponent) {
                        total = folded;
                        collected.remove(&factor);
                        for (inner, inner_exponent) in factors {
                            collect(&mut collected, *inner, inner_exponent * &exponent);
                        }
                    }
                }
                Node::Pi
                | Node::Symbol(_)
                | Node::Sum { .. }
                | Node::Product { .. }
                | Node::Function(..) => {}
            }
        }
        // (a - b)(c - d) is also (b - a)(d - c): the sign of each sum goes to the coefficient.
        let is_plain =
            collected.len() == 1 && total.abs().is_one() && collected.values().all(One::is_one);
        if !is_plain {
            let turned: Vec<(Expr, Rational)> = collected
                .iter()
                .filter(|(factor, exponent)| {
                    exponent.is_integer()
                        && exponent.numer().is_odd()
                        && matches!(self.node(**factor), Node::Sum { .. })
                        && self.is_written_negative(**factor)
                })
                .map(|(factor, exponent)| (*factor, exponent.clone()))
                .collect();
            for (factor, exponent) in turned {
                collected.remove(&factor);
                let opposite = self.neg(factor);
                collect(&mut collected, opposite, exponent);
                total = -total;
            }
            collected.retain(|_, exponent| !exponent.is_zero());
        }
        if collected.is_empty() || total.is_zero() {
            return self.number(total);
        }
        if collected.len() == 1
            && total.abs().is_one()
            && let Some((&factor, exponent)) = collected.first_key_value()
            && exponent.is_one()
        {
            if total.is_one() {
                return factor;
            }
            // -(a + b) is a sum like any other: -a - b.
            if matches!(self.node(factor), Node::Sum { .. }) {
                return self.linear(Rational::zero(), &[(factor, total)]);
            }
        }
        self.intern(Node::Product {
            coefficient: total,
            factors: collected.into_iter().collect(),
        })
    }

    // ── Functions ──────────────────────────────────────────────────────────────────────────────

    /// sin a
    pub fn sin(&mut self, a: Expr) -> Expr {
        self.function(Function::Sin, &[a])
    }

    /// cos a
    pub fn cos(&mut self, a: Expr) -> Expr {
        self.function(Function::Cos, &[a])
    }

    /// atan2(y, x): the direction of (x, y)
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        self.function(Function::Atan2, &[y, x])
    }

    /// A function applied to its arguments, folded where the result is exact.
    ///
    /// # Panics
    /// If the number of arguments is not the function's arity.
    pub fn function(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        use Function::*;
        assert_eq!(
            arguments.len(),
            function.arity(),
            "{} takes other arguments",
            function.name()
        );
        let a = arguments[0];
        match function {
            Sin | Cos | Tan => {
                if let Some(quarter) = self.quarter_turns(a) {
                    let (sin, cos) = [(0, 1), (1, 0), (0, -1), (-1, 0)][quarter];
                    match function {
                        Sin => return self.integer(sin),
                        Cos => return self.integer(cos),
                        _ if cos != 0 => return self.zero(),
                        _ => {}
                    }
                }
                if self.is_written_negative(a) {
                    let positive = self.neg(a);
                    let value = self.intern(Node::Function(function, vec![positive]));
                    return if function == Cos {
                        value
                    } else {
                        self.neg(value)
                    };
                }
            }
            Sign if self.as_number(a).is_some() => {
                let sign = self
                    .as_number(a)
                    .map_or_else(Rational::zero, Signed::signum);
                return self.number(sign);
            }
            Asin | Atan | Tanh | Floor if self.is_zero(a) => return self.zero(),
            Exp if self.is_zero(a) => return self.one(),
            Log if self.is_one(a) => return self.zero(),
            Abs => {
                if let Some(value) = self.as_number(a) {
                    let value = value.abs();
                    return self.number(value);
                }
                if self.is_written_negative(a) {
                    let positive = self.neg(a);
                    return self.intern(Node::Function(Abs, vec![positive]));
                }
            }
            CosDifference | SinDifference if a == arguments[1] => return self.zero(),
            Min | Max if a == arguments[1] => return a,
            Min | Max => {
                if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(arguments[1])) {
                    let first = if function == Min { x <= y } else { x >= y };
                    return if first { a } else { arguments[1] };
                }
            }
            Atan2
                if self.is_zero(a)
                    && self
                        .as_number(arguments[1])
                        .is_some_and(Signed::is_positive) =>
            {
                return self.zero();
            }
            Power => {
                if let Some(exponent) = self.as_number(arguments[1]).cloned() {
                    return self.powr(a, exponent);
                }
            }
            IfPositive => {
                if arguments[1] == arguments[2] {
                    return arguments[1];
                }
                if let Some(condition) = self.as_number(a) {
                    return if condition.is_positive() {
                        arguments[1]
                    } else {
                        arguments[2]
                    };
                }
            }
            _ => {}
        }
        self.intern(Node::Function(function, arguments.to_vec()))
    }

    /// Whether the expression is rather the negative of a positive one: more of its terms are
    /// subtracted than added. Of `a` and `-a` at most one is.
    pub fn is_written_negative(&self, a: Expr) -> bool {
        match self.node(a) {
            Node::Number(value) => value.is_negative(),
            Node::Product { coefficient, .. } => coefficient.is_negative(),
            Node::Sum { terms, .. } => {
                let negative = terms.iter().filter(|(_, k)| k.is_negative()).count();
                let positive = terms.len() - negative;
                negative > positive || (negative == positive && terms[0].1.is_negative())
            }
            Node::Pi | Node::Symbol(_) | Node::Function(..) => false,
        }
    }

    /// `a` in quarter turns modulo a full turn, if `a` is a whole number of them.
    fn quarter_turns(&self, a: Expr) -> Option<usize> {
        let multiple = match self.node(a) {
            Node::Number(value) if value.is_zero() => return Some(0),
            Node::Pi => Rational::one(),
            Node::Product {
                coefficient,
                factors,
            } if factors.len() == 1
                && factors[0].1.is_one()
                && matches!(self.node(factors[0].0), Node::Pi) =>
            {
                coefficient.clone()
            }
            _ => return None,
        };
        let quarters = multiple * BigRational::from_integer(2.into());
        if !quarters.is_integer() {
            return None;
        }
        let four = BigInt::from(4);
        let turns = ((quarters.to_integer() % &four) + &four) % &four;
        turns.to_usize()
    }
}

/// Adds to the number that stands at `expr`.
fn collect(collected: &mut BTreeMap<Expr, Rational>, expr: Expr, number: Rational) {
    let entry = collected.entry(expr).or_insert_with(Rational::zero);
    let sum = &*entry + number;
    *entry = limited(sum);
}

/// The youngest entry that is older than `done` and has what is wanted.
fn next_below(
    collected: &BTreeMap<Expr, Rational>,
    done: Option<Expr>,
    wanted: impl Fn(Expr, &Rational) -> bool,
) -> Option<(Expr, Rational)> {
    let end = done.map_or(Bound::Unbounded, Bound::Excluded);
    collected
        .range((Bound::Unbounded, end))
        .rev()
        .find(|(expr, number)| wanted(**expr, number))
        .map(|(expr, number)| (*expr, number.clone()))
}

/// `total · value^exponent` where that is an exact number of reasonable size.
fn joined(total: &Rational, value: &Rational, exponent: &Rational) -> Option<Rational> {
    let power = fold_power(value, exponent)?;
    (bits(total) + bits(&power) <= FOLD_LIMIT_BITS).then(|| total * power)
}

/// The number itself while it is of reasonable size, else rounded to far more digits than anybody
/// computes with: a long sum of odd fractions must not grow without bound.
fn limited(value: Rational) -> Rational {
    if bits(&value) <= FOLD_LIMIT_BITS {
        return value;
    }
    let exponent = value.numer().bits() as i64 - value.denom().bits() as i64;
    let shift = ROUNDED_BITS - exponent;
    let places = shift.unsigned_abs();
    if shift >= 0 {
        let mantissa = (value.numer() << places) / value.denom();
        BigRational::new(mantissa, BigInt::one() << places)
    } else {
        let mantissa = value.numer() / (value.denom() << places);
        BigRational::from_integer(mantissa << places)
    }
}

fn bits(value: &Rational) -> u64 {
    value.numer().bits() + value.denom().bits()
}

/// `value^exponent` where that is an exact number of reasonable size.
fn fold_power(value: &Rational, exponent: &Rational) -> Option<Rational> {
    if exponent.is_one() || value.is_one() {
        return Some(value.clone());
    }
    let numerator = exponent.numer().to_i32()?;
    let denominator = exponent.denom().to_u32()?;
    if value.is_zero() {
        return (numerator > 0).then(Rational::zero);
    }
    let root = if denominator == 1 {
        value.clone()
    } else {
        if value.is_negative() || denominator > 8 || bits(value) > 256 {
            return None;
        }
        let root = BigRational::new(
            value.numer().nth_root(denominator),
            value.denom().nth_root(denominator),
        );
        if Pow::pow(&root, denominator) != *value {
            return None;
        }
        root
    };
    if bits(&root).saturating_mul(u64::from(numerator.unsigned_abs())) > FOLD_LIMIT_BITS {
        return None;
    }
    Some(Pow::pow(&root, numerator))
}
