//! The graph against plain arithmetic: random expressions, evaluated as they were written down by
//! code that knows nothing of nodes, canonical form or rules of differentiation.

use std::collections::HashMap;

use num_bigint::BigInt;
use proptest::prelude::*;

use super::evaluate::to_f64;
use super::{Evaluator, Expr, Function, Graph, Node, Rational, Symbol};

/// An expression as written.
#[derive(Clone, Debug)]
enum Tree {
    Number(i64, i64),
    Pi,
    Symbol(usize),
    Sum(Box<Tree>, Box<Tree>),
    Difference(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    /// Exponent in halves.
    Power(Box<Tree>, i64),
    Negative(Box<Tree>),
    Function(Function, Vec<Tree>),
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        (-9i64..10, 1i64..5).prop_map(|(p, q)| Tree::Number(p, q)),
        Just(Tree::Pi),
        (0usize..3).prop_map(Tree::Symbol),
        (0usize..3).prop_map(Tree::Symbol),
    ];
    leaf.prop_recursive(5, 40, 3, |inner| {
        let boxed = inner.clone().prop_map(Box::new);
        let two = (boxed.clone(), boxed.clone());
        let function = (
            proptest::sample::select(&Function::ALL[..]),
            proptest::collection::vec(inner, 3),
        );
        prop_oneof![
            3 => two.clone().prop_map(|(a, b)| Tree::Sum(a, b)),
            3 => two.clone().prop_map(|(a, b)| Tree::Difference(a, b)),
            3 => two.clone().prop_map(|(a, b)| Tree::Product(a, b)),
            2 => two.prop_map(|(a, b)| Tree::Quotient(a, b)),
            2 => (boxed.clone(), -5i64..6).prop_map(|(a, halves)| Tree::Power(a, halves)),
            1 => boxed.prop_map(Tree::Negative),
            3 => function.prop_map(|(function, mut arguments)| {
                arguments.truncate(function.arity());
                Tree::Function(function, arguments)
            }),
        ]
    })
}

impl Tree {
    fn build(&self, g: &mut Graph, symbols: &[Symbol]) -> Expr {
        let mut of = |tree: &Tree| tree.build(g, symbols);
        match self {
            Tree::Number(p, q) => g.ratio(*p, *q),
            Tree::Pi => g.pi(),
            Tree::Symbol(index) => g.of(symbols[*index]),
            Tree::Sum(a, b) => {
                let (a, b) = (of(a), of(b));
                g.add(a, b)
            }
            Tree::Difference(a, b) => {
                let (a, b) = (of(a), of(b));
                g.sub(a, b)
            }
            Tree::Product(a, b) => {
                let (a, b) = (of(a), of(b));
                g.mul(a, b)
            }
            Tree::Quotient(a, b) => {
                let (a, b) = (of(a), of(b));
                g.div(a, b)
            }
            Tree::Power(a, halves) => {
                let a = of(a);
                g.powr(a, Rational::new((*halves).into(), 2.into()))
            }
            Tree::Negative(a) => {
                let a = of(a);
                g.neg(a)
            }
            Tree::Function(function, arguments) => {
                let arguments: Vec<Expr> = arguments.iter().map(of).collect();
                g.function(*function, &arguments)
            }
        }
    }

    /// The value with a bound of its rounding error.
    fn value(&self, x: &[f64]) -> Rounded {
        let of = |tree: &Tree| tree.value(x);
        match self {
            Tree::Number(p, q) => Rounded::new(*p as f64 / *q as f64),
            Tree::Pi => Rounded::new(std::f64::consts::PI),
            Tree::Symbol(index) => Rounded {
                value: x[*index],
                error: 0.0,
            },
            Tree::Sum(a, b) => Rounded::of(&[of(a), of(b)], |x| x[0] + x[1]),
            Tree::Difference(a, b) => Rounded::of(&[of(a), of(b)], |x| x[0] - x[1]),
            Tree::Product(a, b) => Rounded::of(&[of(a), of(b)], |x| x[0] * x[1]),
            Tree::Quotient(a, b) => Rounded::of(&[of(a), of(b)], |x| x[0] / x[1]),
            Tree::Power(a, halves) => Rounded::of(&[of(a)], |x| x[0].powf(*halves as f64 / 2.0)),
            Tree::Negative(a) => Rounded::of(&[of(a)], |x| -x[0]),
            Tree::Function(function, arguments) => {
                let arguments: Vec<Rounded> = arguments.iter().map(of).collect();
                Rounded::of(&arguments, |x| plain(*function, x))
            }
        }
    }
}

/// The functions by their definitions.
fn plain(function: Function, x: &[f64]) -> f64 {
    use Function::*;
    match function {
        Sin => x[0].sin(),
        Cos => x[0].cos(),
        Tan => x[0].tan(),
        Asin => x[0].asin(),
        Acos => x[0].acos(),
        Atan => x[0].atan(),
        Tanh => x[0].tanh(),
        Exp => x[0].exp(),
        Log => x[0].ln(),
        Abs => x[0].abs(),
        Sign if x[0] == 0.0 => 0.0,
        Sign => x[0].signum(),
        Floor => x[0].floor(),
        Atan2 => x[0].atan2(x[1]),
        Min if x[0] < x[1] => x[0],
        Max if x[0] > x[1] => x[0],
        Min | Max => x[1],
        Power => x[0].powf(x[1]),
        CosDifference => x[0].cos() - x[1].cos(),
        SinDifference => x[0].sin() - x[1].sin(),
        Unwrap => {
            let turn = std::f64::consts::TAU;
            x[0] - turn * ((x[0] - x[1]) / turn).round()
        }
        IfPositive if x[0] > 0.0 => x[1],
        IfPositive => x[2],
        Lookup(_) => f64::NAN,
    }
}

/// A value and how far rounding may have led it astray.
#[derive(Clone, Copy, Debug)]
struct Rounded {
    value: f64,
    error: f64,
}

impl Rounded {
    fn new(value: f64) -> Self {
        Self {
            value,
            error: 2.0 * f64::EPSILON * value.abs(),
        }
    }

    /// Errors of the operands are passed on by trying them out.
    fn of(operands: &[Rounded], apply: impl Fn(&[f64]) -> f64) -> Self {
        let mut x: Vec<f64> = operands.iter().map(|operand| operand.value).collect();
        let value = apply(&x);
        // Angles of difference functions lose digits of what they are differences of.
        let mut error = 4.0 * f64::EPSILON * (value.abs() + 1.0);
        for (index, operand) in operands.iter().enumerate() {
            let shift = operand.error + f64::EPSILON * operand.value.abs();
            for moved in [operand.value + shift, operand.value - shift] {
                x[index] = moved;
                error += (apply(&x) - value).abs();
            }
            x[index] = operand.value;
        }
        Self { value, error }
    }

    fn is_well(&self) -> bool {
        self.value.is_finite() && self.error <= 1e-6 * (1.0 + self.value.abs())
    }
}

fn graph() -> (Graph, Vec<Symbol>) {
    let mut g = Graph::new();
    let symbols = ["x", "y", "z"].map(|name| g.symbol(name, name)).to_vec();
    (g, symbols)
}

fn evaluator<'g>(g: &'g Graph, symbols: &[Symbol], x: &[f64]) -> Evaluator<'g> {
    let mut evaluator = Evaluator::new(g);
    for (symbol, value) in symbols.iter().zip(x) {
        evaluator.set(*symbol, *value);
    }
    evaluator
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, max_global_rejects: 100_000, ..ProptestConfig::default() })]

    #[test]
    fn canonical_form_keeps_the_value(tree in tree(), x in prop::array::uniform3(-3.0..3.0f64)) {
        let (mut g, symbols) = graph();
        let expr = tree.build(&mut g, &symbols);
        let written = tree.value(&x);
        prop_assume!(written.is_well());
        let condition = evaluator(&g, &symbols, &x).condition(expr);
        // At a singular derivative, such as that of 0^π by its exponent, rounding has no bound.
        prop_assume!(condition.sum.is_finite());
        let bound = 100.0 * (written.error + f64::EPSILON * condition.sum);
        prop_assert!(
            (condition.value - written.value).abs() <= bound,
            "{} = {} instead of {written:?}", g.text(expr), condition.value,
        );
    }

    #[test]
    fn canonical_form_is_what_the_constructors_make_of_it(tree in tree()) {
        let (mut g, symbols) = graph();
        let expr = tree.build(&mut g, &symbols);
        let again = g.rebuild(&[expr], &mut |_, _| None)[0];
        prop_assert_eq!(expr, again, "{} and {}", g.text(expr), g.text(again));
    }

    #[test]
    fn canonical_form_knows_no_order(a in tree(), b in tree(), c in tree()) {
        let (mut g, symbols) = graph();
        let [a, b, c] = [a, b, c].map(|tree| tree.build(&mut g, &symbols));
        let (ab, ba) = (g.add(a, b), g.add(b, a));
        prop_assert_eq!(ab, ba);
        let (first, second) = (g.add(ab, c), g.sum(&[c, b, a]));
        prop_assert_eq!(g.text(first), g.text(second));
        let (ab, ba) = (g.mul(a, b), g.mul(b, a));
        prop_assert_eq!(ab, ba);
        let (minus, opposite) = (g.sub(a, b), g.sub(b, a));
        let negative = g.neg(opposite);
        prop_assert_eq!(minus, negative);
        let nothing = g.sub(minus, minus);
        prop_assert!(g.is_zero(nothing));
    }

    #[test]
    fn nodes_are_canonical(tree in tree()) {
        let (mut g, symbols) = graph();
        let expr = tree.build(&mut g, &symbols);
        for part in g.reachable(&[expr]) {
            match g.node(part) {
                Node::Sum { constant, terms } => {
                    prop_assert!(terms.len() + usize::from(*constant != zero()) >= 2);
                    prop_assert!(terms.iter().all(|(_, k)| *k != zero()));
                    prop_assert!(terms.windows(2).all(|pair| pair[0].0 < pair[1].0));
                    prop_assert!(terms.iter().all(|(term, _)| g.as_number(*term).is_none()));
                }
                Node::Product { coefficient, factors } => {
                    prop_assert!(*coefficient != zero());
                    prop_assert!(factors.iter().all(|(_, k)| *k != zero()));
                    prop_assert!(factors.windows(2).all(|pair| pair[0].0 < pair[1].0));
                }
                Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Function(..) => {}
            }
            g.operands(part, |operand| assert!(operand < part));
        }
    }

    #[test]
    fn derivatives_agree_with_differences(tree in tree(), x in prop::array::uniform3(-3.0..3.0f64)) {
        let (mut g, symbols) = graph();
        let expr = tree.build(&mut g, &symbols);
        let one = g.one();
        let derivative = g.derivative(expr, &HashMap::from([(symbols[0], one)]));
        // Central differences of two widths tell whether the function is smooth here.
        let difference = |h: f64| {
            let [high, low] = [h, -h].map(|h| tree.value(&[x[0] + h, x[1], x[2]]));
            ((high.value - low.value) / (2.0 * h), (high.error + low.error) / h)
        };
        let ((coarse, _), (fine, noise)) = (difference(2e-4), difference(1e-4));
        let extrapolated = fine + (fine - coarse) / 3.0;
        let truncation = (fine - coarse).abs();
        prop_assume!(extrapolated.is_finite() && noise.is_finite());
        let bound = 10.0 * noise + truncation + 1e-9 * extrapolated.abs();
        prop_assume!(bound <= 1e-3 * (1.0 + extrapolated.abs()));
        let mut evaluator = evaluator(&g, &symbols, &x);
        let condition = evaluator.condition(derivative);
        prop_assume!(condition.sum * f64::EPSILON <= 1e-6);
        prop_assert!(
            (condition.value - extrapolated).abs() <= bound + 1e-8,
            "d/dx {} = {} = {}, not {extrapolated} ± {bound}",
            g.text(expr), g.text(derivative), condition.value,
        );
    }

    #[test]
    fn every_finite_number_survives_being_written(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        let mut g = Graph::new();
        let expr = g.decimal(value).unwrap();
        prop_assert_eq!(to_f64(g.as_number(expr).unwrap()), value);
    }

    #[test]
    fn decimals_are_rounded_as_a_compiler_rounds_them(digits in "[1-9][0-9]{0,40}", exponent in -380i32..330) {
        let power = num_traits::pow(BigInt::from(10), exponent.unsigned_abs() as usize);
        let mantissa: BigInt = digits.parse().unwrap();
        let exact = if exponent < 0 {
            Rational::new(mantissa, power)
        } else {
            Rational::from_integer(mantissa * power)
        };
        let expected: f64 = format!("{digits}e{exponent}").parse().unwrap();
        prop_assert_eq!(to_f64(&exact), expected);
    }
}

fn zero() -> Rational {
    Rational::from_integer(0.into())
}

#[test]
fn halfway_cases_are_rounded_to_even() {
    let two = |power: usize| Rational::from_integer(BigInt::from(1) << power);
    let one = two(0);
    // 1 + 2^-53 lies between 1 and 1 + 2^-52.
    let halfway = &one + one.clone() / two(53);
    assert_eq!(to_f64(&halfway), 1.0);
    let above = &halfway + one.clone() / two(200);
    assert_eq!(to_f64(&above), 1.0 + f64::EPSILON);
    assert_eq!(to_f64(&-above), -1.0 - f64::EPSILON);
    // Half of the smallest number, and just more.
    let half = one.clone() / two(1075);
    assert_eq!(to_f64(&half), 0.0);
    let more = &half + one / two(1200);
    assert_eq!(to_f64(&more), f64::from_bits(1));
}

#[test]
fn condition_sums_count_every_value_once() {
    let (mut g, symbols) = graph();
    let (x, y) = (g.of(symbols[0]), g.of(symbols[1]));
    let x_value = 3.0;
    let y_value = 2.5;
    let check = |g: &Graph, expr: Expr, value: f64, sum: f64| {
        let condition = evaluator(g, &symbols, &[x_value, y_value]).condition(expr);
        assert!((condition.value - value).abs() < 1e-14 * value.abs());
        assert!(
            (condition.sum - sum).abs() < 1e-13 * sum,
            "{}",
            condition.sum
        );
    };
    let difference = g.sub(x, y);
    check(&g, difference, 0.5, 0.5 + 3.0 + 2.5);
    let product = g.mul(x, y);
    check(&g, product, 7.5, 3.0 * 7.5);
    let exponential = g.function(Function::Exp, &[x]);
    let e = x_value.exp();
    check(&g, exponential, e, e + 3.0 * e);
    // Shared: the sine is one value, however often it is used.
    let sine = g.sin(x);
    let tanh = g.function(Function::Tanh, &[sine]);
    let shared = g.mul(sine, tanh);
    let (s, c) = x_value.sin_cos();
    let t = s.tanh();
    let slope = (t + s * (1.0 - t * t)).abs();
    let sum = s * t + s * t + slope * s + (slope * c).abs() * 3.0;
    check(&g, shared, s * t, sum);
}

#[test]
fn like_terms_meet_wherever_they_stand() {
    let (mut g, symbols) = graph();
    let [x, y, z] = [0, 1, 2].map(|index| g.of(symbols[index]));
    let s = g.add(x, y);
    let half = g.scale(s, Rational::new(1.into(), 2.into()));
    let rest = g.sub(s, half);
    assert_eq!(rest, half);
    let twice = g.scale(s, Rational::from_integer(2.into()));
    let all = [twice, z];
    let all = g.sum(&all);
    let opened = g.sub(all, s);
    let expected = g.sum(&[x, y, z]);
    assert_eq!(opened, expected);
}

#[test]
fn powers_follow_their_rules() {
    let (mut g, symbols) = graph();
    let x = g.of(symbols[0]);
    let square = g.powi(x, 2);
    // The root of a square is no x: x may be negative.
    let root = g.sqrt(square);
    assert_ne!(root, x);
    let magnitude = evaluator(&g, &symbols, &[-3.0]).value(root);
    assert_eq!(magnitude, 3.0);
    let again = g.powi(root, 2);
    assert_eq!(again, square);
    let root = g.sqrt(x);
    let whole = g.mul(root, root);
    assert_eq!(whole, x);
    // Numbers under roots: 8^(1/2) · 2^(1/2) = 4, and 2^(3/2) keeps a 2 outside.
    let (two, eight) = (g.integer(2), g.integer(8));
    let (root2, root8) = (g.sqrt(two), g.sqrt(eight));
    let cube = g.powi(root2, 3);
    let expected = g.mul(two, root2);
    assert_eq!(cube, expected);
    let four = g.mul(root2, root8);
    let value = evaluator(&g, &symbols, &[]).value(four);
    assert!((value - 4.0).abs() < 1e-15);
    // A division by zero stays one.
    let zero = g.zero();
    let infinite = g.div(x, zero);
    assert_eq!(
        evaluator(&g, &symbols, &[3.0]).value(infinite),
        f64::INFINITY
    );
    let one = g.powi(zero, 0);
    assert!(g.is_one(one));
}

#[test]
fn numbers_do_not_grow_without_bound() {
    let (mut g, symbols) = graph();
    let x = g.of(symbols[0]);
    let mut sum = g.zero();
    let mut scaled = x;
    let mut expected = 0.0;
    for index in 0..300i64 {
        let odd = 2 * index + 1_000_001;
        let fraction = g.ratio(1, odd);
        sum = g.add(sum, fraction);
        expected += 1.0 / odd as f64;
        let part = g.mul(x, fraction);
        scaled = g.add(scaled, part);
    }
    let value = g.as_number(sum).unwrap();
    assert!(value.numer().bits() + value.denom().bits() < 20_000);
    assert!((to_f64(value) - expected).abs() < 1e-12 * expected);
    let value = evaluator(&g, &symbols, &[2.0]).value(scaled);
    assert!((value - 2.0 * (1.0 + expected)).abs() < 1e-12);
    let mut tower = g.integer(3);
    for _ in 0..60 {
        tower = g.powi(tower, 1_000_000_007);
    }
    assert!(g.text(tower).len() < 2000);
}
