//! Angles less the whole quarter turns in them.
//!
//! Up to [`LARGEST`] by Cody and Waite's method (Software Manual for the Elementary Functions,
//! 1980): π/2 in parts so short that a whole number of each is exact. With fused products longer
//! parts are. Beyond, by Payne and Hanek's (ACM SIGNUM Newsletter 18, 1983): of 2/π just those
//! digits that decide the place in the turn.

use super::{Vector, WHOLE, replaced};

/// Largest angle in rad, in size, that is reduced in all lanes at once.
pub(super) const LARGEST: f64 = 1e6;

/// An angle within a quarter turn about zero, and the quarter turns taken off.
pub(super) struct Reduced<V> {
    /// The angle, |angle| ≤ π/4.
    pub angle: V,
    /// What is missing in `angle`; a few units in its last place at most.
    pub rest: V,
    /// [`WHOLE`] plus the number of quarter turns.
    pub quarters: V,
}

/// Reduces angles that are not negative.
#[inline(always)]
pub(super) fn reduce<V: Vector>(x: V) -> Reduced<V> {
    let quarters = x.times_plus(V::from_f64(std::f64::consts::FRAC_2_PI), V::from_f64(WHOLE));
    let minus_n = V::from_f64(WHOLE) - quarters;
    let (angle, rest) = if V::FUSED {
        fused(x, minus_n)
    } else {
        in_short_parts(x, minus_n)
    };
    if V::all(x.less(V::from_f64(LARGEST))) {
        Reduced {
            angle,
            rest,
            quarters,
        }
    } else {
        let Reduced {
            angle,
            rest,
            quarters,
        } = beyond(x, angle, rest, quarters);
        Reduced {
            angle,
            rest,
            quarters,
        }
    }
}

/// `x` less `n` quarter turns, where a product is exact until something is added.
#[inline(always)]
fn fused<V: Vector>(x: V, minus_n: V) -> (V, V) {
    // π/2 = A + B + C: exact to 2⁻¹⁶³.
    const A: f64 = std::f64::consts::FRAC_PI_2;
    const B: f64 = 6.123233995736766e-17;
    const C: f64 = -1.4973849048591698e-33;
    let first = minus_n.times_plus(V::from_f64(A), x);
    let second = minus_n * B;
    let second_rest = minus_n.times_plus(V::from_f64(B), -second);
    let (angle, rest) = sum(first, second);
    (
        angle,
        rest + minus_n.times_plus(V::from_f64(C), second_rest),
    )
}

/// The same with products of 20 bits by 33, which are exact.
#[inline(always)]
fn in_short_parts<V: Vector>(x: V, minus_n: V) -> (V, V) {
    // π/2 = A + B + C + D: exact to 2⁻¹⁵⁶.
    const A: f64 = 1.5707963267341256;
    const B: f64 = 6.077100506303966e-11;
    const C: f64 = 2.0222662487111665e-21;
    const D: f64 = 8.4784276603689e-32;
    let (first, first_rest) = sum(x + minus_n * A, minus_n * B);
    let (angle, second_rest) = sum(first, minus_n * C);
    (angle, first_rest + second_rest + minus_n * D)
}

/// The sum and what was rounded off it (Knuth's TwoSum).
#[inline(always)]
fn sum<V: Vector>(a: V, b: V) -> (V, V) {
    let sum = a + b;
    let b_in_it = sum - a;
    (sum, (a - (sum - b_in_it)) + (b - b_in_it))
}

/// Replaces the entries that are too large for either method. (Arguments are single numbers, which
/// stay in registers where this is not called.)
#[cold]
#[inline(never)]
fn beyond<V: Vector>(x: V, angle: V, rest: V, quarters: V) -> Reduced<V> {
    let entry = |i: usize| {
        let x = x.entry(i);
        (x >= LARGEST || x.is_nan()).then(|| reduce_large(x))
    };
    Reduced {
        angle: replaced(angle, |i| entry(i).map(|r| r.angle)),
        rest: replaced(rest, |i| entry(i).map(|r| r.rest)),
        quarters: replaced(quarters, |i| entry(i).map(|r| r.quarters)),
    }
}

/// The first 1280 binary digits of 2/π after the point.
const TWO_PER_PI: [u64; 20] = [
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
    0xf0cfbc209af4361d,
];

/// Reduces a number of at least 1; what is not finite becomes not a number.
fn reduce_large(x: f64) -> Reduced<f64> {
    if !x.is_finite() {
        return Reduced {
            angle: f64::NAN,
            rest: f64::NAN,
            quarters: WHOLE,
        };
    }
    // x = mantissa · 2^shift.
    let bits = x.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let shift = (bits >> 52) as i64 - 1075;
    // Digits of 2/π from the one of weight 2^(1 - shift) on: those before it count whole turns.
    let start = shift - 2;
    let digits = [0, 1, 2].map(|word| digits(start + 64 * word));
    // mantissa · digits · 2^(2 - 192) without whole turns: quarters are in the two first bits. Of
    // the last 64 digits just the carry counts.
    let product = |word: usize| u128::from(mantissa) * u128::from(digits[word]);
    let middle = product(1) + (product(2) >> 64);
    let high = product(0) + (middle >> 64);
    let turns = (high << 64) | (middle & u128::from(u64::MAX));
    // To the nearest quarter: what remains is between -1/2 and 1/2 of one, in units of 2⁻¹²⁸.
    let quarters = (turns.wrapping_add(1 << 125) >> 126) as u32;
    let fraction = (turns << 2) as i128;
    let (angle, rest) = of_quarter(fraction.unsigned_abs());
    let sign = if fraction < 0 { -1.0 } else { 1.0 };
    Reduced {
        angle: sign * angle,
        rest: sign * rest,
        quarters: WHOLE + f64::from(quarters),
    }
}

/// The angle that is `fraction`·2⁻¹²⁸ of a quarter turn, and what was rounded off it.
fn of_quarter(fraction: u128) -> (f64, f64) {
    // π/2 · 2¹²⁶.
    const HALF_PI: u128 = 0x6487_ed51_10b4_611a_6263_3145_c06e_0e68;
    let shift = fraction.leading_zeros().min(127);
    let product = high_half(fraction << shift, HALF_PI);
    let angle = product as f64;
    let rest = (product as i128 - angle as i128) as f64;
    let unit = f64::from_bits(u64::from(1023 - 126 - shift) << 52);
    (angle * unit, rest * unit)
}

/// The product divided by 2¹²⁸, to the whole number below or the next one.
fn high_half(a: u128, b: u128) -> u128 {
    const LOW: u128 = u64::MAX as u128;
    let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let middle = a1 * b0 + ((a0 * b0) >> 64);
    a1 * b1 + (middle >> 64) + ((a0 * b1 + (middle & LOW)) >> 64)
}

/// 64 binary digits of 2/π, the first of them that of weight 2^-(start + 1).
fn digits(start: i64) -> u64 {
    let word = |index: i64| {
        usize::try_from(index)
            .ok()
            .and_then(|index| TWO_PER_PI.get(index))
            .copied()
            .unwrap_or(0)
    };
    let (index, offset) = (start.div_euclid(64), start.rem_euclid(64));
    if offset == 0 {
        word(index)
    } else {
        (word(index) << offset) | (word(index + 1) >> (64 - offset))
    }
}
