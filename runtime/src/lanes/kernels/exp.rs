//! The exponential function.

use super::{Vector, WHOLE, line};

/// Exponents below this have a result that is not a normal number.
const LEAST: f64 = -708.396;

/// Up to this exponent powers of two are not infinite.
const ORDINARY: f64 = 709.0;

/// 2^(j/4), less j·2⁵⁰ in its bits.
const ROOTS: [f64; 4] = [
    f64::from_bits(0x3ff0000000000000),
    f64::from_bits(0x3fef06fe0a31b715),
    f64::from_bits(0x3feea09e667f3bcd),
    f64::from_bits(0x3feee89f995ad3ad),
];

/// What is rounded off 2^(j/4), relative to it.
const RESTS: [f64; 4] = [
    0.0,
    3.3484623336251524e-17,
    -6.835808657661922e-17,
    4.875160526227062e-17,
];

/// e to the power `x`; zero below e^-708.396, where normal numbers end.
///
/// x = n·ln 2 / 4 + r, |r| ≤ ln 2 / 8: of the fourth parts of n the whole ones are an exponent, the
/// others are looked up, and eʳ is a polynomial of least error (2⁻⁵⁷, by Remez's algorithm).
///
/// Friction asks for exponents of -1000 most of the time, and passes through those of subnormal
/// results every time that it comes to rest. To compute with these takes processors a hundred times
/// as long: they are zero instead.
#[inline(always)]
pub(crate) fn exp<V: Vector>(x: V) -> V {
    let vanishes = x.less(V::from_f64(LEAST));
    if V::COUNT == 1 && V::any(vanishes) {
        return V::from_f64(0.0);
    }
    if V::any(V::from_f64(ORDINARY).less(x)) {
        return of_any(x);
    }
    let (r, whole) = reduce(if V::COUNT > 1 {
        x.zero_where(vanishes)
    } else {
        x
    });
    of_reduced(r, whole).zero_where(vanishes)
}

#[cold]
#[inline(never)]
fn of_any<V: Vector>(x: V) -> V {
    exp_of_sum(x, V::from_f64(0.0)).zero_where(x.less(V::from_f64(LEAST)))
}

/// e to the power `x + rest`, the rest half a unit in the last place of `x` or little more; results
/// may be subnormal.
#[inline(always)]
pub(super) fn exp_of_sum<V: Vector>(x: V, rest: V) -> V {
    // Beyond this range the result is zero or infinite anyway; not a number remains so.
    let x = V::from_f64(-746.0).larger(V::from_f64(710.0).smaller(x));
    let (r, whole) = reduce(x);
    // Half of the exponents there are at first, the others when all digits are there.
    let below = x.less(V::from_f64(0.0));
    let half = V::choose(below, V::from_f64(-512.0), V::from_f64(512.0));
    let power = V::choose(
        below,
        V::from_f64(7.458340731200207e-155),
        V::from_f64(1.3407807929942597e154),
    );
    of_reduced(r + rest, whole - half * 4.0) * power
}

/// The exponent less n·ln 2 / 4, and [`WHOLE`] plus n.
#[inline(always)]
fn reduce<V: Vector>(x: V) -> (V, V) {
    /// ln 2 / 4 in two parts, the first so short that 13 bits times it are exact.
    const LN_2_4: [f64; 2] = [0.17328679513957468, 4.1164873957242706e-13];
    let whole = x.times_plus(
        V::from_f64(4.0 * std::f64::consts::LOG2_E),
        V::from_f64(WHOLE),
    );
    let minus_n = V::from_f64(WHOLE) - whole;
    let first = minus_n.times_plus(V::from_f64(LN_2_4[0]), x);
    let r = minus_n.times_plus(V::from_f64(LN_2_4[1]), first);
    (r, whole)
}

/// e to the power `r`, |r| ≤ ln 2 / 8, times 2^(n/4) for `whole = WHOLE + n`.
#[inline(always)]
fn of_reduced<V: Vector>(r: V, whole: V) -> V {
    let square = r * r;
    let fourth = square * square;
    // (eʳ - 1 - r) / r².
    let p0 = line(r, 0.5, 0.16666666666695873);
    let p1 = line(r, 0.04166666666676107, 0.008333333130432653);
    let p2 = line(r, 0.0013888888528399853, 0.0001984551124401846);
    let low = square.times_plus(p1, p0);
    let high = square.times_plus(V::from_f64(2.4806955929267685e-05), p2);
    let p = fourth.times_plus(high, low);
    let more = square.times_plus(p, r + whole.of_four(&RESTS));
    let root = whole.of_four(&ROOTS).raise(whole);
    root.times_plus(more, root)
}
