//! The natural logarithm.

use super::{Vector, line, replaced};

/// ln 2 in two parts, the first so short that 11 bits times it are exact.
const LN_2: [f64; 2] = [0.6931471803691238, 1.9082149292705877e-10];

/// x = m·2ⁿ with √½ ≤ m < √2: `(m, n)`. For positive finite numbers.
pub(super) fn split(x: f64) -> (f64, f64) {
    if x < f64::MIN_POSITIVE {
        // A subnormal number has no exponent of its own.
        let (m, n) = Vector::split(x * 18_014_398_509_481_984.0);
        (m, n - 54.0)
    } else {
        Vector::split(x)
    }
}

/// Natural logarithm of each entry.
#[inline(always)]
pub(crate) fn ln<V: Vector>(x: V) -> V {
    let (m, n) = Vector::split(x);
    let result = of_split(m, n);
    let least = V::from_f64(f64::MIN_POSITIVE);
    let most = V::from_f64(f64::INFINITY);
    if V::any(x.less(least)) || !V::all(x.less(most)) {
        return beyond(x, result);
    }
    result
}

/// ln (m·2ⁿ): with s = (m - 1) / (m + 1), ln m = 2 artanh s, and that by a polynomial of least error
/// (2⁻⁶², by Remez's algorithm).
#[inline(always)]
fn of_split<V: Vector>(m: V, n: V) -> V {
    let f = m - 1.0;
    let s = f / (f + 2.0);
    let square = s * s;
    let fourth = square * square;
    // 2 artanh s = 2 s + s · r.
    let r0 = line(square, 0.6666666666666666, 0.40000000000004776);
    let r1 = line(square, 0.28571428569371504, 0.22222222623588989);
    let r2 = line(square, 0.18181776371086494, 0.15387097140081776);
    let r3 = line(square, 0.1324934451245636, 0.13262705858940596);
    let low = fourth.times_plus(r1, r0);
    let high = fourth.times_plus(r3, r2);
    let r = square * (fourth * fourth).times_plus(high, low);
    // 2 s = f - f²/2 + s · f²/2: f itself is exact.
    let half = f * f * 0.5;
    let small = s.times_plus(half + r, n * LN_2[1]);
    n * LN_2[0] - ((half - small) - f)
}

/// Replaces the entries that are not positive normal numbers.
#[cold]
#[inline(never)]
fn beyond<V: Vector>(x: V, result: V) -> V {
    replaced(result, |i| {
        let x = x.entry(i);
        if x == 0.0 {
            Some(f64::NEG_INFINITY)
        } else if x.is_nan() || x < 0.0 {
            Some(f64::NAN)
        } else if x == f64::INFINITY {
            Some(x)
        } else if x < f64::MIN_POSITIVE {
            let (m, n) = split(x);
            Some(of_split(m, n))
        } else {
            None
        }
    })
}
