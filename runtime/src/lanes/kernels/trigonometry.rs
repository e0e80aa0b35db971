//! Sine, cosine and tangent.
//!
//! The angle is reduced to within π/4 ([`super::reduction`]); there sine and cosine are
//! polynomials of least relative error (2⁻⁵⁶ and 2⁻⁶¹, by Remez's algorithm).

use super::reduction::reduce;
use super::{Vector, line};

/// Sine and cosine of an angle in rad.
#[inline(always)]
pub(crate) fn sin_cos<V: Vector>(x: V) -> (V, V) {
    // Of the angle's size, so that a zero keeps its sign and sine is odd bit for bit.
    let reduced = reduce(x.abs());
    let (sin, cos) = within_quarter(reduced.angle, reduced.rest);
    let odd = reduced.quarters.odd();
    (
        V::choose(odd, cos, sin)
            .flip_by_second_bit(reduced.quarters)
            .flip(x),
        V::choose(odd, sin, cos).flip_by_second_bit(reduced.quarters + 1.0),
    )
}

/// Sine and cosine of `angle + rest`, |angle| ≤ π/4.
#[inline(always)]
fn within_quarter<V: Vector>(angle: V, rest: V) -> (V, V) {
    let square = angle * angle;
    let fourth = square * square;
    // (sin a - a) / a³ and (cos a - 1 + a²/2) / a⁴.
    let s0 = line(square, -0.16666666666666644, 0.008333333333323673);
    let s1 = line(square, -0.0001984126983015316, 2.7557313655144826e-06);
    let s2 = line(square, -2.5050735111716815e-08, 1.589474286750584e-10);
    let s = fourth.times_plus(fourth.times_plus(s2, s1), s0);
    let c0 = line(square, 0.04166666666666665, -0.0013888888888882846);
    let c1 = line(square, 2.480158729463349e-05, -2.7557315740672753e-07);
    let c2 = line(square, 2.087589807695097e-09, -1.1368002080963654e-11);
    let c = fourth.times_plus(fourth.times_plus(c2, c1), c0);
    // The larger terms last, with what is rounded off 1 - a²/2.
    let half = square * 0.5;
    let one = V::from_f64(1.0);
    let most = one - half;
    let rounded_off = (one - most) - half;
    let sin = angle + (angle * square).times_plus(s, rest * most);
    let cos = most + fourth.times_plus(c, rounded_off - angle * rest);
    (sin, cos)
}

/// Tangent of an angle in rad.
#[inline(always)]
pub(crate) fn tan<V: Vector>(x: V) -> V {
    let (sin, cos) = sin_cos(x);
    sin / cos
}
