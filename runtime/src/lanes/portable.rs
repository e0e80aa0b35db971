//! Lanes of plain numbers, for machines without wider instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Lanes;
use crate::real::Real;

/// `N` plain numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portable<const N: usize>([f64; N]);

impl<const N: usize> Portable<N> {
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline(always)]
    fn pair(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Lanes for Portable<N> {
    const COUNT: usize = N;

    #[inline(always)]
    fn from_entries(entry: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(entry))
    }

    #[inline(always)]
    fn entry(self, index: usize) -> f64 {
        self.0[index]
    }

    #[inline(always)]
    fn set_entry(&mut self, index: usize, value: f64) {
        self.0[index] = value;
    }
}

impl<const N: usize> Neg for Portable<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|a| -a)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $symbol:tt,)*) => {
        $(
            impl<const N: usize> $operator for Portable<N> {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    self.pair(other, |a, b| a $symbol b)
                }
            }
            impl<const N: usize> $operator<f64> for Portable<N> {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    self.each(|a| a $symbol other)
                }
            }
        )*
    };
}

operators! {
    Add add +,
    Sub sub -,
    Mul mul *,
    Div div /,
}

macro_rules! entry_by_entry {
    ($($name:ident,)*) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                self.each(Real::$name)
            }
        )*
    };
}

impl<const N: usize> Real for Portable<N> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self([value; N])
    }
    entry_by_entry! {
        recip, sqrt, sin, cos, tan, asin, acos, atan, tanh, exp, ln, abs, sign, floor,
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let both = self.0.map(Real::sin_cos);
        (Self(both.map(|b| b.0)), Self(both.map(|b| b.1)))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.pair(x, Real::atan2)
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        self.pair(other, Real::smaller)
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.pair(other, Real::larger)
    }
    #[inline(always)]
    fn power(self, exponent: Self) -> Self {
        self.pair(exponent, Real::power)
    }
    #[inline(always)]
    fn unwrap_to(self, reference: Self) -> Self {
        self.pair(reference, Real::unwrap_to)
    }
    #[inline(always)]
    fn if_positive(self, yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].if_positive(yes.0[i], no.0[i])
        }))
    }
    #[inline(always)]
    fn lookup(self, table: &[f64]) -> Self {
        self.each(|a| a.lookup(table))
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    #[inline(always)]
    fn all_positive(self) -> bool {
        self.0.iter().all(|a| *a > 0.0)
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        self.0.iter().any(|a| *a > 0.0)
    }
}
