//! Two registers as one number.
//!
//! Every operation is done on one half and then on the other: the second is under way while a chain
//! of operations on one register would wait for the first.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::kernels::Vector;
use super::{Lanes, real_by_kernels};
use crate::real::Real;

/// The entries of one number, then those of another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<V>(V, V);

impl<V: Vector> Lanes for Pair<V> {
    const COUNT: usize = 2 * V::COUNT;

    #[inline(always)]
    fn from_entries(mut entry: impl FnMut(usize) -> f64) -> Self {
        let first = V::from_entries(&mut entry);
        Self(first, V::from_entries(|i| entry(V::COUNT + i)))
    }

    #[inline(always)]
    fn entry(self, index: usize) -> f64 {
        if index < V::COUNT {
            self.0.entry(index)
        } else {
            self.1.entry(index - V::COUNT)
        }
    }

    #[inline(always)]
    fn set_entry(&mut self, index: usize, value: f64) {
        if index < V::COUNT {
            self.0.set_entry(index, value);
        } else {
            self.1.set_entry(index - V::COUNT, value);
        }
    }
}

impl<V: Vector> Neg for Pair<V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $symbol:tt,)*) => {
        $(
            impl<V: Vector> $operator for Pair<V> {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(self.0 $symbol other.0, self.1 $symbol other.1)
                }
            }
            impl<V: Vector> $operator<f64> for Pair<V> {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    Self(self.0 $symbol other, self.1 $symbol other)
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

/// Functions of one number or two that are those of the halves.
macro_rules! half_by_half {
    ($($name:ident($($other:ident)?),)*) => {
        $(
            #[inline(always)]
            fn $name(self $(, $other: Self)?) -> Self {
                Self(self.0.$name($($other.0)?), self.1.$name($($other.1)?))
            }
        )*
    };
}

impl<V: Vector> Real for Pair<V> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(V::from_f64(value), V::from_f64(value))
    }
    half_by_half! {
        sqrt(),
        abs(),
        smaller(other),
        larger(other),
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        Self(
            self.0.times_plus(factor.0, addend.0),
            self.1.times_plus(factor.1, addend.1),
        )
    }
    #[inline(always)]
    fn all_positive(self) -> bool {
        self.0.all_positive() & self.1.all_positive()
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        self.0.any_positive() | self.1.any_positive()
    }
    #[inline(always)]
    fn lookup(self, table: &[f64]) -> Self {
        Self(self.0.lookup(table), self.1.lookup(table))
    }
    real_by_kernels!();
}

impl<V: Vector> Vector for Pair<V> {
    type Mask = (V::Mask, V::Mask);
    const FUSED: bool = V::FUSED;

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        (self.0.less(other.0), self.1.less(other.1))
    }
    #[inline(always)]
    fn both(one: Self::Mask, other: Self::Mask) -> Self::Mask {
        (V::both(one.0, other.0), V::both(one.1, other.1))
    }
    #[inline(always)]
    fn all(mask: Self::Mask) -> bool {
        V::all(V::both(mask.0, mask.1))
    }
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        V::any(mask.0) | V::any(mask.1)
    }
    #[inline(always)]
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(
            V::choose(mask.0, yes.0, no.0),
            V::choose(mask.1, yes.1, no.1),
        )
    }
    #[inline(always)]
    fn negative(self) -> Self::Mask {
        (self.0.negative(), self.1.negative())
    }
    #[inline(always)]
    fn odd(self) -> Self::Mask {
        (self.0.odd(), self.1.odd())
    }
    #[inline(always)]
    fn zero_where(self, mask: Self::Mask) -> Self {
        Self(self.0.zero_where(mask.0), self.1.zero_where(mask.1))
    }
    #[inline(always)]
    fn of_four(self, table: &[f64; 4]) -> Self {
        Self(self.0.of_four(table), self.1.of_four(table))
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let (first, second) = (self.0.split(), self.1.split());
        (Self(first.0, second.0), Self(first.1, second.1))
    }
    half_by_half! {
        flip(sign),
        flip_by_second_bit(bits),
        raise(whole),
        nearest(),
    }
}
