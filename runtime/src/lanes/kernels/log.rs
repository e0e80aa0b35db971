//! The natural logarithm, entry by entry.

use super::super::Lanes;

/// x = m·2ⁿ with √½ ≤ m < √2: `(m, n)`. For positive finite numbers.
pub(super) fn split(x: f64) -> (f64, f64) {
    // A subnormal number has no exponent of its own.
    let (x, lifted) = if x < f64::MIN_POSITIVE {
        (x * 18_014_398_509_481_984.0, -54)
    } else {
        (x, 0)
    };
    // Bits less those of √½: what carries into the exponent is n.
    let above = x.to_bits().wrapping_sub(0x3fe6_a09e_667f_3bcd) as i64;
    let n = above >> 52;
    let m = f64::from_bits(x.to_bits().wrapping_sub((n << 52) as u64));
    (m, (n + lifted) as f64)
}

/// Natural logarithm of each entry.
#[inline(always)]
pub(crate) fn ln<L: Lanes>(x: L) -> L {
    L::from_entries(|i| ln_of_one(x.entry(i)))
}

/// Natural logarithm: with s = (m - 1) / (m + 1), ln m = 2 artanh s, and that by a polynomial of
/// least error (2⁻⁶², by Remez's algorithm).
fn ln_of_one(x: f64) -> f64 {
    /// ln 2 in two parts, the first so short that 11 bits times it are exact.
    const LN_2: [f64; 2] = [0.6931471803691238, 1.9082149292705877e-10];
    if x == 0.0 {
        return f64::NEG_INFINITY;
    }
    if x.is_nan() || x < 0.0 {
        return f64::NAN;
    }
    if x == f64::INFINITY {
        return x;
    }
    let (m, n) = split(x);
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let square = s * s;
    let fourth = square * square;
    // 2 artanh s = 2 s + s · r.
    let r0 = 0.6666666666666666 + square * 0.40000000000004776;
    let r1 = 0.28571428569371504 + square * 0.22222222623588989;
    let r2 = 0.18181776371086494 + square * 0.15387097140081776;
    let r3 = 0.1324934451245636 + square * 0.13262705858940596;
    let r = square * (r0 + fourth * (r1 + fourth * (r2 + fourth * r3)));
    // 2 s = f - f²/2 + s · f²/2: f itself is exact.
    let half = 0.5 * f * f;
    n * LN_2[0] - ((half - (s * (half + r) + n * LN_2[1])) - f)
}
