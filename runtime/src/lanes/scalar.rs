//! One number as lanes: plain, and with products fused with the sums that follow.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::kernels::{ROOT_OF_HALF, Vector};
use super::{Lanes, real_by_kernels};
use crate::real::Real;

const SIGN: u64 = 1 << 63;

macro_rules! vector_of_one {
    ($type:ty, $fused:literal, $wrap:expr, $unwrap:expr) => {
        impl Vector for $type {
            type Mask = bool;
            const FUSED: bool = $fused;

            #[inline(always)]
            fn less(self, other: Self) -> bool {
                $unwrap(self) < $unwrap(other)
            }
            #[inline(always)]
            fn both(one: bool, other: bool) -> bool {
                one & other
            }
            #[inline(always)]
            fn all(mask: bool) -> bool {
                mask
            }
            #[inline(always)]
            fn any(mask: bool) -> bool {
                mask
            }
            #[inline(always)]
            fn choose(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn negative(self) -> bool {
                $unwrap(self).is_sign_negative()
            }
            #[inline(always)]
            fn flip(self, sign: Self) -> Self {
                let bits = $unwrap(self).to_bits() ^ ($unwrap(sign).to_bits() & SIGN);
                $wrap(f64::from_bits(bits))
            }
            #[inline(always)]
            fn odd(self) -> bool {
                $unwrap(self).to_bits() & 1 != 0
            }
            #[inline(always)]
            fn flip_by_second_bit(self, bits: Self) -> Self {
                let sign = ($unwrap(bits).to_bits() << 62) & SIGN;
                $wrap(f64::from_bits($unwrap(self).to_bits() ^ sign))
            }
            #[inline(always)]
            fn zero_where(self, mask: bool) -> Self {
                if mask { $wrap(0.0) } else { self }
            }
            #[inline(always)]
            fn of_four(self, table: &[f64; 4]) -> Self {
                $wrap(table[($unwrap(self).to_bits() & 3) as usize])
            }
            #[inline(always)]
            fn split(self) -> (Self, Self) {
                let bits = $unwrap(self).to_bits() as i64;
                // What carries into the exponent is n.
                let n = bits.wrapping_sub(ROOT_OF_HALF) >> 52;
                let m = f64::from_bits(bits.wrapping_sub(n << 52) as u64);
                ($wrap(m), $wrap(n as f64))
            }
            #[inline(always)]
            fn raise(self, whole: Self) -> Self {
                let bits = $unwrap(self).to_bits();
                $wrap(f64::from_bits(
                    bits.wrapping_add($unwrap(whole).to_bits() << 50),
                ))
            }
        }
    };
}

vector_of_one!(f64, false, |x: f64| x, |x: f64| x);

impl Lanes for f64 {
    const COUNT: usize = 1;

    #[inline(always)]
    fn from_entries(mut entry: impl FnMut(usize) -> f64) -> Self {
        entry(0)
    }

    #[inline(always)]
    fn entry(self, _: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn set_entry(&mut self, _: usize, value: f64) {
        *self = value;
    }
}

/// One number whose kernels fuse a product with the sum that follows, as those of vectors do.
///
/// Right on any machine, and fast where there is an instruction for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fused(f64);

vector_of_one!(Fused, true, Fused, |x: Fused| x.0);

impl Lanes for Fused {
    const COUNT: usize = 1;

    #[inline(always)]
    fn from_entries(mut entry: impl FnMut(usize) -> f64) -> Self {
        Self(entry(0))
    }

    #[inline(always)]
    fn entry(self, _: usize) -> f64 {
        self.0
    }

    #[inline(always)]
    fn set_entry(&mut self, _: usize, value: f64) {
        self.0 = value;
    }
}

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $symbol:tt,)*) => {
        $(
            impl $operator for Fused {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(self.0 $symbol other.0)
                }
            }
            impl $operator<f64> for Fused {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    Self(self.0 $symbol other)
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

impl Real for Fused {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self(Real::smaller(self.0, other.0))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(Real::larger(self.0, other.0))
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        Self(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(always)]
    fn plain(self) -> Option<f64> {
        Some(self.0)
    }
    #[inline(always)]
    fn all_positive(self) -> bool {
        self.0 > 0.0
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        self.0 > 0.0
    }
    #[inline(always)]
    fn lookup(self, table: &[f64]) -> Self {
        Self(self.0.lookup(table))
    }
    real_by_kernels!();
}
