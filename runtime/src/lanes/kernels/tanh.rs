//! The hyperbolic tangent.

use super::exp::exp;
use super::{Vector, line};

/// Hyperbolic tangent of `x`: a polynomial of least error (2⁻⁵⁷, by Remez's algorithm) up to 5/8,
/// by e²ˣ from there on.
#[inline(always)]
pub(crate) fn tanh<V: Vector>(x: V) -> V {
    let size = x.abs();
    let far = -(V::from_f64(2.0) / (exp(size * 2.0) + 1.0)) + 1.0;
    let near = of_small(size);
    V::choose(V::from_f64(0.625).less(size), far, near).flip(x)
}

/// Hyperbolic tangent of 0 ≤ `x` ≤ 5/8.
#[inline(always)]
fn of_small<V: Vector>(x: V) -> V {
    let square = x * x;
    let fourth = square * square;
    let eighth = fourth * fourth;
    // (tanh x - x) / x³.
    let p0 = line(square, -0.33333333333333326, 0.1333333333333115);
    let p1 = line(square, -0.05396825396664263, 0.021869488480632887);
    let p2 = line(square, -0.00886323445062796, 0.003592114967968201);
    let p3 = line(square, -0.0014557301196805592, 0.0005894623686144822);
    let p4 = line(square, -0.00023702453070392578, 9.155609900935352e-05);
    let p5 = line(square, -3.0163490551864923e-05, 6.023931885553195e-06);
    let low = fourth.times_plus(p1, p0);
    let middle = fourth.times_plus(p3, p2);
    let high = fourth.times_plus(p5, p4);
    let p = eighth.times_plus(eighth.times_plus(high, middle), low);
    (x * square).times_plus(p, x)
}
