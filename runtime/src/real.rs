//! The number type of generated right-hand sides: [`f64`], and whatever computes like it.
//!
//! Generated code is generic over [`Real`], so that one text serves plain numbers, dual numbers
//! ([`Dual`](crate::dual::Dual)) and lanes. Nothing here branches on a value: choices are made by
//! [`Real::if_positive`], which a lane can make for each of its entries.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::lanes::real_by_kernels;

/// A number that equations of motion can be evaluated with.
///
/// Every function agrees to rounding with [`impl Real for f64`](#impl-Real-for-f64), whose functions
/// are the same to the last bit on every machine; [`lanes`](crate::lanes) says how exact they are.
/// For plain numbers they are to be called as `Real::sin(x)`: `x.sin()` is the platform's.
pub trait Real:
    Copy
    + Debug
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The number as a constant.
    fn from_f64(value: f64) -> Self;
    /// One divided by this.
    fn recip(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine of an angle in rad.
    fn sin(self) -> Self;
    /// Cosine of an angle in rad.
    fn cos(self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    /// Tangent of an angle in rad.
    fn tan(self) -> Self;
    /// Angle in rad whose sine this is.
    fn asin(self) -> Self;
    /// Angle in rad whose cosine this is.
    fn acos(self) -> Self;
    /// Angle in rad whose tangent this is.
    fn atan(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// e to this power; zero where that is not a normal number any more.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// -1, 0 or 1.
    fn sign(self) -> Self;
    /// Largest whole number not above this.
    fn floor(self) -> Self;
    /// Direction in rad of the vector (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// The smaller one; `other` if either is not a number.
    fn smaller(self, other: Self) -> Self;
    /// The larger one; `other` if either is not a number.
    fn larger(self, other: Self) -> Self;
    /// This to the power `exponent`.
    fn power(self, exponent: Self) -> Self;
    /// This angle in rad, moved by whole turns to within half a turn of `reference`.
    fn unwrap_to(self, reference: Self) -> Self;
    /// `yes` where this is positive, else `no`.
    fn if_positive(self, yes: Self, no: Self) -> Self;
    /// The entry of `table` at this position, the nearest one outside its range.
    fn lookup(self, table: &[f64]) -> Self;
    /// This times `factor` plus `addend`, rounded once where that costs nothing.
    fn times_plus(self, factor: Self, addend: Self) -> Self;
    /// This plus the product of two factors, rounded once where that costs nothing.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        a.times_plus(b, self)
    }
    /// This minus the product of two factors, rounded once where that costs nothing.
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        (-a).times_plus(b, self)
    }
    /// The plain number that this is; `None` for lanes and for numbers that carry more.
    #[inline(always)]
    fn plain(self) -> Option<f64> {
        None
    }
    /// Whether this is positive, in every lane.
    fn all_positive(self) -> bool;
    /// Whether this is positive, in any lane.
    fn any_positive(self) -> bool;
}

impl Real for f64 {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn lookup(self, table: &[f64]) -> Self {
        let last = table.len().saturating_sub(1);
        let position = (f64::max(self, 0.0) as usize).min(last);
        table.get(position).copied().unwrap_or(f64::NAN)
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    #[inline(always)]
    fn plain(self) -> Option<f64> {
        Some(self)
    }
    #[inline(always)]
    fn all_positive(self) -> bool {
        self > 0.0
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        self > 0.0
    }
    real_by_kernels!();
}
