//! The exponential function.

use super::{Vector, WHOLE, line};

/// ln 2 in two parts, the first so short that 11 bits times it are exact.
const LN_2: [f64; 2] = [0.6931471803691238, 1.9082149292705877e-10];

/// Exponents between these make powers of two that are neither subnormal nor infinite.
const ORDINARY: [f64; 2] = [-708.0, 709.0];

/// e to the power `x`.
///
/// x = n·ln 2 + r, |r| ≤ ln 2 / 2: a polynomial of least error (2⁻⁶⁰, by Remez's algorithm) in r,
/// times 2ⁿ.
#[inline(always)]
pub(crate) fn exp<V: Vector>(x: V) -> V {
    if V::COUNT > 1 {
        return of_any(x);
    }
    // The same bits without what only the largest exponents need: one number is waited for.
    let above = V::from_f64(ORDINARY[0]).less(x);
    let below = x.less(V::from_f64(ORDINARY[1]));
    if V::all(V::both(above, below)) {
        let (r, rest, whole) = reduce(x);
        of_reduced(r, rest) * whole.power_of_two()
    } else {
        of_large(x)
    }
}

#[cold]
#[inline(never)]
fn of_large<V: Vector>(x: V) -> V {
    of_any(x)
}

#[inline(always)]
fn of_any<V: Vector>(x: V) -> V {
    let (r, rest, whole) = reduce(within_range(x));
    of_reduced(r, rest).scale(whole)
}

/// e to the power `x + rest`, the rest half a unit in the last place of `x` or little more.
#[inline(always)]
pub(super) fn exp_of_sum<V: Vector>(x: V, rest: V) -> V {
    let (r, own_rest, whole) = reduce(within_range(x));
    let rest = own_rest + rest;
    let sum = r + rest;
    of_reduced(sum, (r - sum) + rest).scale(whole)
}

/// Beyond this range the result is zero or infinite anyway; not a number remains so.
#[inline(always)]
fn within_range<V: Vector>(x: V) -> V {
    V::from_f64(-746.0).larger(V::from_f64(710.0).smaller(x))
}

/// The exponent less n·ln 2, what is missing in that, and [`WHOLE`] plus n.
#[inline(always)]
fn reduce<V: Vector>(x: V) -> (V, V, V) {
    let whole = x.times_plus(V::from_f64(std::f64::consts::LOG2_E), V::from_f64(WHOLE));
    let minus_n = V::from_f64(WHOLE) - whole;
    let first = minus_n.times_plus(V::from_f64(LN_2[0]), x);
    let second = minus_n * LN_2[1];
    let r = first + second;
    (r, (first - r) + second, whole)
}

/// e to the power `r + rest`, for |r| ≤ ln 2 / 2.
#[inline(always)]
fn of_reduced<V: Vector>(r: V, rest: V) -> V {
    let one = V::from_f64(1.0);
    let most = r + one;
    let rounded_off = (one - most) + r;
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
    most + square.times_plus(p, rounded_off + rest)
}
