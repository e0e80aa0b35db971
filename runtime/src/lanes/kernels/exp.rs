//! The exponential function.

use super::{Vector, WHOLE, line};

/// ln 2 in two parts, the first so short that 11 bits times it are exact.
const LN_2: [f64; 2] = [0.6931471803691238, 1.9082149292705877e-10];

/// e to the power `x`.
///
/// x = n·ln 2 + r, |r| ≤ ln 2 / 2: a polynomial of least error (2⁻⁶⁰, by Remez's algorithm) in r,
/// times 2ⁿ.
#[inline(always)]
pub(crate) fn exp<V: Vector>(x: V) -> V {
    let (r, rest, whole) = reduce(x);
    (less_one(r, rest) + 1.0).scale(whole)
}

/// e to the power `x + rest`, the rest half a unit in the last place of `x` or little more.
#[inline(always)]
pub(super) fn exp_of_sum<V: Vector>(x: V, rest: V) -> V {
    let (r, own_rest, whole) = reduce(x);
    let rest = own_rest + rest;
    let sum = r + rest;
    (less_one(sum, (r - sum) + rest) + 1.0).scale(whole)
}

/// The exponent less n·ln 2, what is missing in that, and [`WHOLE`] plus n.
#[inline(always)]
fn reduce<V: Vector>(x: V) -> (V, V, V) {
    // Beyond, the result is zero or infinite anyway; not a number remains so.
    let x = V::from_f64(-746.0).larger(V::from_f64(710.0).smaller(x));
    let whole = x.times_plus(V::from_f64(std::f64::consts::LOG2_E), V::from_f64(WHOLE));
    let minus_n = V::from_f64(WHOLE) - whole;
    let first = minus_n.times_plus(V::from_f64(LN_2[0]), x);
    let second = minus_n * LN_2[1];
    let r = first + second;
    (r, (first - r) + second, whole)
}

/// e to the power `r + rest`, less one, for |r| ≤ ln 2 / 2.
#[inline(always)]
fn less_one<V: Vector>(r: V, rest: V) -> V {
    let square = r * r;
    let fourth = square * square;
    // (eʳ - 1 - r) / r².
    let p0 = line(r, 0.5, 0.16666666666666685);
    let p1 = line(r, 0.04166666666666673, 0.008333333333316751);
    let p2 = line(r, 0.0013888888888858569, 0.00019841269897026917);
    let p3 = line(r, 2.4801587373510926e-05, 2.755723426935916e-06);
    let p4 = line(r, 2.7557233545138986e-07, 2.5112228302308133e-08);
    let p5 = V::from_f64(2.0926888693560427e-09);
    let low = square.times_plus(p1, p0);
    let middle = square.times_plus(p3, p2);
    let high = square.times_plus(p5, p4);
    let p = fourth.times_plus(fourth.times_plus(high, middle), low);
    r + square.times_plus(p, rest)
}
