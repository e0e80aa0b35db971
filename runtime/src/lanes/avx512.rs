//! eight numbers in a register of AVX-512.
//!
//! # Safety
//!
//! Every `unsafe` here calls an instruction of AVX-512 (F and DQ), and is sound because nothing that
//! holds or makes a [`F64x8`] runs on a machine without them: the type is private to
//! [`lanes`](super), where only [`dispatch`](super::dispatch) names it, as the argument of a task
//! that it has found the machine fit for. A task is generic over its lanes and cannot name it.

use std::arch::x86_64::*;
use std::mem::transmute;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::kernels::{ROOT_OF_HALF, Vector};
use super::{Lanes, real_by_kernels};
use crate::real::Real;

/// eight numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct F64x8(__m512d);

/// Calls functions that need the machine to have AVX-512.
macro_rules! here {
    ($call:expr) => {
        // SAFETY: this machine has the instructions, as the head of this file says.
        unsafe { $call }
    };
}

impl F64x8 {
    #[inline(always)]
    fn to_array(self) -> [f64; 8] {
        // SAFETY: a register of eight numbers is eight numbers, and any bits are a number.
        unsafe { transmute(self.0) }
    }

    #[inline(always)]
    fn from_array(array: [f64; 8]) -> Self {
        // SAFETY: eight numbers are a register of eight numbers.
        Self(unsafe { transmute::<[f64; 8], __m512d>(array) })
    }

    #[inline(always)]
    fn bits(self) -> __m512i {
        here!(_mm512_castpd_si512(self.0))
    }
}

impl Lanes for F64x8 {
    const COUNT: usize = 8;

    #[inline(always)]
    fn from_entries(entry: impl FnMut(usize) -> f64) -> Self {
        Self::from_array(std::array::from_fn(entry))
    }

    #[inline(always)]
    fn entry(self, index: usize) -> f64 {
        self.to_array()[index]
    }

    #[inline(always)]
    fn set_entry(&mut self, index: usize, value: f64) {
        let mut array = self.to_array();
        array[index] = value;
        *self = Self::from_array(array);
    }
}

impl Neg for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(here!(_mm512_xor_pd(self.0, _mm512_set1_pd(-0.0))))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $intrinsic:ident,)*) => {
        $(
            impl $operator for F64x8 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(here!($intrinsic(self.0, other.0)))
                }
            }
            impl $operator<f64> for F64x8 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    Self(here!($intrinsic(self.0, _mm512_set1_pd(other))))
                }
            }
        )*
    };
}

operators! {
    Add add _mm512_add_pd,
    Sub sub _mm512_sub_pd,
    Mul mul _mm512_mul_pd,
    Div div _mm512_div_pd,
}

impl Real for F64x8 {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(here!(_mm512_set1_pd(value)))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(here!(_mm512_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(here!(_mm512_abs_pd(self.0)))
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self(here!(_mm512_min_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(here!(_mm512_max_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        Self(here!(_mm512_fmadd_pd(self.0, factor.0, addend.0)))
    }
    #[inline(always)]
    fn all_positive(self) -> bool {
        Self::all(Self::from_f64(0.0).less(self))
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        Self::any(Self::from_f64(0.0).less(self))
    }
    #[inline(always)]
    fn lookup(self, table: &[f64]) -> Self {
        Self::from_entries(|i| self.entry(i).lookup(table))
    }
    real_by_kernels!();
}

impl Vector for F64x8 {
    type Mask = __mmask8;
    const FUSED: bool = true;

    #[inline(always)]
    fn less(self, other: Self) -> __mmask8 {
        here!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn both(one: __mmask8, other: __mmask8) -> __mmask8 {
        one & other
    }
    #[inline(always)]
    fn all(mask: __mmask8) -> bool {
        mask == u8::MAX
    }
    #[inline(always)]
    fn any(mask: __mmask8) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn choose(mask: __mmask8, yes: Self, no: Self) -> Self {
        Self(here!(_mm512_mask_blend_pd(mask, no.0, yes.0)))
    }
    #[inline(always)]
    fn negative(self) -> __mmask8 {
        here!(_mm512_movepi64_mask(self.bits()))
    }
    #[inline(always)]
    fn flip(self, sign: Self) -> Self {
        let sign = here!(_mm512_and_pd(sign.0, _mm512_set1_pd(-0.0)));
        Self(here!(_mm512_xor_pd(self.0, sign)))
    }
    #[inline(always)]
    fn odd(self) -> __mmask8 {
        here!(_mm512_test_epi64_mask(self.bits(), _mm512_set1_epi64(1)))
    }
    #[inline(always)]
    fn flip_by_second_bit(self, bits: Self) -> Self {
        let shifted = here!(_mm512_slli_epi64::<62>(bits.bits()));
        self.flip(Self(here!(_mm512_castsi512_pd(shifted))))
    }
    #[inline(always)]
    fn zero_where(self, mask: __mmask8) -> Self {
        Self(here!(_mm512_maskz_mov_pd(!mask, self.0)))
    }
    #[inline(always)]
    fn of_four(self, table: &[f64; 4]) -> Self {
        // Twice, for the lowest three bits count.
        let [a, b, c, d] = *table;
        let twice = Self::from_array([a, b, c, d, a, b, c, d]);
        Self(here!(_mm512_permutexvar_pd(self.bits(), twice.0)))
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        // What carries into the exponent is n.
        let root = here!(_mm512_set1_epi64(ROOT_OF_HALF));
        let n = here!(_mm512_srai_epi64::<52>(_mm512_sub_epi64(self.bits(), root)));
        let m = here!(_mm512_sub_epi64(self.bits(), _mm512_slli_epi64::<52>(n)));
        (
            Self(here!(_mm512_castsi512_pd(m))),
            Self(here!(_mm512_cvtepi64_pd(n))),
        )
    }
    #[inline(always)]
    fn raise(self, whole: Self) -> Self {
        let added = here!(_mm512_slli_epi64::<50>(whole.bits()));
        Self(here!(_mm512_castsi512_pd(_mm512_add_epi64(
            self.bits(),
            added
        ))))
    }
    #[inline(always)]
    fn nearest(self) -> Self {
        Self(here!(_mm512_roundscale_pd::<
            { _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC },
        >(self.0)))
    }
}
