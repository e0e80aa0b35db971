//! Directions of vectors: the inverse of sine and cosine.

use super::{Vector, line, replaced};

/// Components between these are divided as they are.
const ORDINARY: [f64; 2] = [1e-290, 1e300];

/// Direction in rad of the vector (`x`, `y`).
///
/// Where the smaller component is more than half the larger one, the vector is first turned by
/// -π/4, which loses nothing: their difference is exact. Of the quotient, the angle is a polynomial
/// of least error (2⁻⁵⁷, by Remez's algorithm). Signs of zeros count as in C's `atan2`.
#[inline(always)]
pub(crate) fn atan2<V: Vector>(y: V, x: V) -> V {
    let (a, b) = (y.abs(), x.abs());
    let steep = b.less(a);
    let larger = V::choose(steep, a, b);
    let smaller = V::choose(steep, b, a);
    let (smaller, larger) = if V::all(V::both(
        V::from_f64(ORDINARY[0]).less(larger),
        larger.less(V::from_f64(ORDINARY[1])),
    )) {
        (smaller, larger)
    } else {
        ordinary(smaller, larger)
    };
    // The angle is eighths · π/4 + turned.
    let turn = (larger * 0.5).less(smaller);
    let quotient =
        V::choose(turn, smaller - larger, smaller) / V::choose(turn, smaller + larger, larger);
    let eighths = V::choose(turn, V::from_f64(1.0), V::from_f64(0.0));
    let turned = of_small(quotient);
    let eighths = V::choose(steep, -eighths + 2.0, eighths);
    let turned = V::choose(steep, -turned, turned);
    let eighths = V::choose(x.negative(), -eighths + 4.0, eighths);
    let turned = turned.flip(x);
    // π/4 in two parts, the first so short that three bits times it are exact.
    const PI_4: [f64; 2] = [std::f64::consts::FRAC_PI_4, 3.061616997868383e-17];
    let angle = eighths * PI_4[0] + (eighths * PI_4[1] + turned);
    angle.flip(y)
}

/// Angle whose tangent is `q`, |q| ≤ 1/2.
#[inline(always)]
fn of_small<V: Vector>(q: V) -> V {
    let square = q * q;
    let fourth = square * square;
    let eighth = fourth * fourth;
    // (atan q - q) / q³.
    let p0 = line(square, -0.33333333333333176, 0.1999999999993913);
    let p1 = line(square, -0.14285714278687195, 0.11111110731555018);
    let p2 = line(square, -0.09090897509709353, 0.0769208717949821);
    let p3 = line(square, -0.06663893300568466, 0.05858572834111996);
    let p4 = line(square, -0.0512220024772796, 0.0418471883744199);
    let p5 = line(square, -0.02737569026044691, 0.010057758245358563);
    let low = fourth.times_plus(p1, p0);
    let middle = fourth.times_plus(p3, p2);
    let high = fourth.times_plus(p5, p4);
    let p = eighth.times_plus(eighth.times_plus(high, middle), low);
    (q * square).times_plus(p, q)
}

/// Replaces components that are too large or too small to be divided, infinite or both zero by
/// others in the same proportion.
#[cold]
#[inline(never)]
fn ordinary<V: Vector>(smaller: V, larger: V) -> (V, V) {
    let entry = |i: usize| in_proportion(smaller.entry(i), larger.entry(i));
    (
        replaced(smaller, |i| Some(entry(i).0)),
        replaced(larger, |i| Some(entry(i).1)),
    )
}

fn in_proportion(smaller: f64, larger: f64) -> (f64, f64) {
    /// 2³⁰⁰.
    const SCALE: f64 = 2.037035976334486e90;
    if larger == 0.0 {
        (0.0, 1.0)
    } else if larger == f64::INFINITY {
        let both = smaller == f64::INFINITY;
        (if both { 1.0 } else { smaller * 0.0 }, 1.0)
    } else if larger >= ORDINARY[1] {
        (smaller / SCALE, larger / SCALE)
    } else if larger <= ORDINARY[0] {
        (smaller * SCALE, larger * SCALE)
    } else {
        (smaller, larger)
    }
}

/// Angle in rad whose tangent is `x`.
#[inline(always)]
pub(crate) fn atan<V: Vector>(x: V) -> V {
    atan2(x, V::from_f64(1.0))
}

/// Angle in rad whose sine is `x`.
#[inline(always)]
pub(crate) fn asin<V: Vector>(x: V) -> V {
    atan2(x, other_leg(x))
}

/// Angle in rad whose cosine is `x`.
#[inline(always)]
pub(crate) fn acos<V: Vector>(x: V) -> V {
    atan2(other_leg(x), x)
}

/// √(1 - x²) without loss of digits near ±1.
#[inline(always)]
fn other_leg<V: Vector>(x: V) -> V {
    ((-x + 1.0) * (x + 1.0)).sqrt()
}
