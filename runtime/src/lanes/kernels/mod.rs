//! Functions of numbers in lanes, each written once for every type of lanes.
//!
//! A kernel uses nothing but operations that round in the same way everywhere (IEEE 754 arithmetic,
//! square roots, bits), so that its results are the same on every platform: exactly the same among
//! the types that fuse a product with the sum that follows ([`Vector::FUSED`]), and among those
//! that do not. It has no branch on a value but the one to entries that are so rare (an angle of
//! more than a million rad, a vector with an infinite component) that they are seen to one by one.

pub(crate) mod atan;
pub(crate) mod exp;
pub(crate) mod log;
pub(crate) mod power;
pub(crate) mod reduction;
pub(crate) mod tanh;
pub(crate) mod trigonometry;

use super::Lanes;

/// 1.5·2⁵²: a number added to this is rounded to a whole one, which then stands in the lowest bits.
pub(super) const WHOLE: f64 = 6_755_399_441_055_744.0;

/// 2⁵²: from here on, every number is a whole one; one from zero to this, added to it, is rounded
/// to a whole one.
const LARGEST_FRACTION: f64 = 4_503_599_627_370_496.0;

/// Bits of √½.
pub(super) const ROOT_OF_HALF: i64 = 0x3fe6_a09e_667f_3bcd;

/// What kernels need of lanes beyond arithmetic: masks and bits.
pub(crate) trait Vector: Lanes {
    /// A choice for each entry.
    type Mask: Copy;

    /// Whether [`times_plus`](crate::real::Real::times_plus) rounds once.
    const FUSED: bool;

    /// Where this is less than `other`.
    fn less(self, other: Self) -> Self::Mask;

    /// Where both are true.
    fn both(one: Self::Mask, other: Self::Mask) -> Self::Mask;

    /// Whether it is true of every entry.
    fn all(mask: Self::Mask) -> bool;

    /// Whether it is true of any entry.
    fn any(mask: Self::Mask) -> bool;

    /// `yes` where `mask` is true, else `no`.
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Where the sign bit is set.
    fn negative(self) -> Self::Mask;

    /// This with its sign turned where the sign bit of `sign` is set.
    fn flip(self, sign: Self) -> Self;

    /// Where the lowest bit is set.
    fn odd(self) -> Self::Mask;

    /// This with its sign turned where the second lowest bit of `bits` is set.
    fn flip_by_second_bit(self, bits: Self) -> Self;

    /// This, but zero where `mask` is true.
    fn zero_where(self, mask: Self::Mask) -> Self;

    /// For `self = WHOLE + n`: entry n mod 4 of a table.
    fn of_four(self, table: &[f64; 4]) -> Self;

    /// This with n·2⁵⁰ added to its bits, for `whole = WHOLE + n`: where four divides n, times
    /// 2^(n/4).
    fn raise(self, whole: Self) -> Self;

    /// `(m, n)` of `self = m·2ⁿ` with √½ ≤ m < √2, for a positive normal number.
    fn split(self) -> (Self, Self);

    /// The nearest whole number, the even one of two; a zero keeps its sign.
    #[inline(always)]
    fn nearest(self) -> Self {
        let size = self.abs();
        let small = size.less(Self::from_f64(LARGEST_FRACTION));
        let rounded = (size + LARGEST_FRACTION) - LARGEST_FRACTION;
        Self::choose(small, rounded, size).flip(self)
    }
}

/// The largest whole number not above `x`.
#[inline(always)]
pub(crate) fn floor<V: Vector>(x: V) -> V {
    let nearest = x.nearest();
    let above = x.less(nearest);
    V::choose(above, nearest - 1.0, nearest)
}

/// -1, 0 or 1; a zero keeps its sign.
#[inline(always)]
pub(crate) fn sign<V: Vector>(x: V) -> V {
    let zero = V::from_f64(0.0);
    let below = V::choose(x.less(zero), V::from_f64(-1.0), x * 0.0);
    V::choose(zero.less(x), V::from_f64(1.0), below)
}

/// `angle` moved by whole turns to within half a turn of `reference`.
#[inline(always)]
pub(crate) fn unwrap_to<V: Vector>(angle: V, reference: V) -> V {
    const TURN: f64 = 2.0 * std::f64::consts::PI;
    let turns = ((angle - reference) / TURN).nearest();
    turns.times_plus(V::from_f64(-TURN), angle)
}

/// `a + b·x`.
#[inline(always)]
fn line<V: Vector>(x: V, a: f64, b: f64) -> V {
    x.times_plus(V::from_f64(b), V::from_f64(a))
}

/// Lanes of which some entries are replaced: `entry(i)` gives those that are.
#[inline(always)]
fn replaced<V: Vector>(lanes: V, entry: impl Fn(usize) -> Option<f64>) -> V {
    V::from_entries(|i| entry(i).unwrap_or(lanes.entry(i)))
}
