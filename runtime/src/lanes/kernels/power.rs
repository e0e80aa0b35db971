//! Powers, entry by entry.

use super::super::Lanes;
use super::exp::exp_of_sum;
use super::log::split;

/// Each entry of `x` to the power of that of `exponent`.
#[inline(always)]
pub(crate) fn power<L: Lanes>(x: L, exponent: L) -> L {
    L::from_entries(|i| power_of_one(x.entry(i), exponent.entry(i)))
}

/// `x` to the power `y`, with the exceptions of C's `pow`.
fn power_of_one(x: f64, y: f64) -> f64 {
    if y == 0.0 || x == 1.0 {
        return 1.0;
    }
    if x.is_nan() || y.is_nan() {
        return f64::NAN;
    }
    let (whole, odd) = parity(y);
    let size = x.abs();
    let result = if y.is_infinite() && size == 1.0 {
        1.0
    } else if y.is_infinite() || size == 0.0 || size == f64::INFINITY {
        if (size > 1.0) == (y > 0.0) {
            f64::INFINITY
        } else {
            0.0
        }
    } else if x < 0.0 && !whole {
        f64::NAN
    } else {
        ordinary(size, y)
    };
    if x.is_sign_negative() && odd {
        -result
    } else {
        result
    }
}

/// Whether a number is whole, and whether it is odd.
fn parity(y: f64) -> (bool, bool) {
    let size = y.abs();
    if size >= 9_007_199_254_740_992.0 {
        return (true, false);
    }
    let whole = size as u64;
    let is_whole = whole as f64 == size;
    (is_whole, is_whole && whole % 2 == 1)
}

/// Powers of positive finite numbers: exp(y · ln x) with the logarithm to 2⁻⁶⁴.
fn ordinary(x: f64, y: f64) -> f64 {
    let (high, low) = ln(x);
    if (y * high).abs() > 800.0 {
        return if y * high > 0.0 { f64::INFINITY } else { 0.0 };
    }
    // Where y is huge the logarithm is tiny: near 1 their halves do not overflow.
    let (y, high, low) = if y.abs() > 1e100 {
        (y / SCALE, high * SCALE, low * SCALE)
    } else {
        (y, high, low)
    };
    let (product, rest) = exact_product(y, high);
    exp_of_sum(product, rest + y * low)
}

/// 2³⁰⁰.
const SCALE: f64 = 2.037035976334486e90;

/// ln x in two parts.
fn ln(x: f64) -> (f64, f64) {
    /// ln 2 in two parts, the first so short that 11 bits times it are exact.
    const LN_2: [f64; 2] = [0.6931471805592082, 7.371002565167799e-13];
    const TWO_THIRDS: [f64; 2] = [0.6666666666666666, 3.700743415417188e-17];
    let (m, n) = split(x);
    // s = f / (2 + f) and z = s², each with what is missing in it.
    let f = m - 1.0;
    let (divisor, divisor_rest) = exact_sum(2.0, f);
    let s = f / divisor;
    let (back, back_rest) = exact_product(s, divisor);
    let s_rest = ((f - back) - back_rest - s * divisor_rest) / divisor;
    let (z, z_rest) = exact_product(s, s);
    let z_rest = z_rest + 2.0 * s * s_rest;
    // 2 artanh s = 2 s + s · (⅔ z + z² · t), t a polynomial of least error.
    let fourth = z * z;
    let t0 = 0.40000000000000385 + z * 0.28571428570998686;
    let t1 = 0.22222222363555613 + z * 0.1818179747038001;
    let t2 = 0.15386185372823216 + z * 0.13269355574811095;
    let t = t0 + fourth * (t1 + fourth * (t2 + fourth * 0.1308721985133064));
    let (first, first_rest) = exact_product(TWO_THIRDS[0], z);
    let (series, series_rest) = exact_sum(first, fourth * t);
    let series_rest = series_rest + first_rest + TWO_THIRDS[0] * z_rest + TWO_THIRDS[1] * z;
    let (curved, curved_rest) = exact_product(s, series);
    let curved_rest = curved_rest + s * series_rest + s_rest * series;
    let (straight, straight_rest) = exact_sum(n * LN_2[0], 2.0 * s);
    let (high, high_rest) = exact_sum(straight, curved);
    let low = straight_rest + high_rest + curved_rest + 2.0 * s_rest + n * LN_2[1];
    let ln = high + low;
    (ln, (high - ln) + low)
}

/// The sum and what was rounded off it (Knuth's TwoSum).
fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_in_it = sum - a;
    (sum, (a - (sum - b_in_it)) + (b - b_in_it))
}

/// The product and what was rounded off it (Dekker's, Numerische Mathematik 18, 1971).
fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let halves = |x: f64| {
        let lifted = 134_217_729.0 * x;
        let high = lifted - (lifted - x);
        (high, x - high)
    };
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    let product = a * b;
    (
        product,
        a0 * b0 - (((product - a1 * b1) - a0 * b1) - a1 * b0),
    )
}
