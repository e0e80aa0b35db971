//! four numbers in a register of AVX2 with FMA.
//!
//! # Safety
//!
//! Every `unsafe` here calls an instruction of AVX2 with FMA, and is sound because nothing that
//! holds or makes a [`F64x4`] runs on a machine without them: the type is private to
//! [`lanes`](super), where only [`dispatch`](super::dispatch) names it, as the argument of a task
//! that it has found the machine fit for. A task is generic over its lanes and cannot name it.

use std::arch::x86_64::*;
use std::mem::transmute;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::kernels::{ROOT_OF_HALF, Vector, WHOLE};
use super::{Lanes, real_by_kernels};
use crate::real::Real;

/// four numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct F64x4(__m256d);

/// Calls functions that need the machine to have AVX2 with FMA.
macro_rules! here {
    ($call:expr) => {
        // SAFETY: this machine has the instructions, as the head of this file says.
        unsafe { $call }
    };
}

impl F64x4 {
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        // SAFETY: a register of four numbers is four numbers, and any bits are a number.
        unsafe { transmute(self.0) }
    }

    #[inline(always)]
    fn from_array(array: [f64; 4]) -> Self {
        // SAFETY: four numbers are a register of four numbers.
        Self(unsafe { transmute::<[f64; 4], __m256d>(array) })
    }

    #[inline(always)]
    fn bits(self) -> __m256i {
        here!(_mm256_castpd_si256(self.0))
    }
}

impl Lanes for F64x4 {
    const COUNT: usize = 4;

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

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(here!(_mm256_xor_pd(self.0, _mm256_set1_pd(-0.0))))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $intrinsic:ident,)*) => {
        $(
            impl $operator for F64x4 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(here!($intrinsic(self.0, other.0)))
                }
            }
            impl $operator<f64> for F64x4 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    Self(here!($intrinsic(self.0, _mm256_set1_pd(other))))
                }
            }
        )*
    };
}

operators! {
    Add add _mm256_add_pd,
    Sub sub _mm256_sub_pd,
    Mul mul _mm256_mul_pd,
    Div div _mm256_div_pd,
}

impl Real for F64x4 {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(here!(_mm256_set1_pd(value)))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(here!(_mm256_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(here!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)))
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self(here!(_mm256_min_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(here!(_mm256_max_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        Self(here!(_mm256_fmadd_pd(self.0, factor.0, addend.0)))
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

impl Vector for F64x4 {
    type Mask = __m256d;
    const FUSED: bool = true;

    #[inline(always)]
    fn less(self, other: Self) -> __m256d {
        here!(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn both(one: __m256d, other: __m256d) -> __m256d {
        here!(_mm256_and_pd(one, other))
    }
    #[inline(always)]
    fn all(mask: __m256d) -> bool {
        here!(_mm256_movemask_pd(mask)) == 0b1111
    }
    #[inline(always)]
    fn any(mask: __m256d) -> bool {
        here!(_mm256_movemask_pd(mask)) != 0
    }
    #[inline(always)]
    fn choose(mask: __m256d, yes: Self, no: Self) -> Self {
        Self(here!(_mm256_blendv_pd(no.0, yes.0, mask)))
    }
    #[inline(always)]
    fn negative(self) -> __m256d {
        self.0
    }
    #[inline(always)]
    fn flip(self, sign: Self) -> Self {
        let sign = here!(_mm256_and_pd(sign.0, _mm256_set1_pd(-0.0)));
        Self(here!(_mm256_xor_pd(self.0, sign)))
    }
    #[inline(always)]
    fn odd(self) -> __m256d {
        here!(_mm256_castsi256_pd(_mm256_slli_epi64::<63>(self.bits())))
    }
    #[inline(always)]
    fn flip_by_second_bit(self, bits: Self) -> Self {
        let shifted = here!(_mm256_slli_epi64::<62>(bits.bits()));
        self.flip(Self(here!(_mm256_castsi256_pd(shifted))))
    }
    #[inline(always)]
    fn zero_where(self, mask: __m256d) -> Self {
        Self(here!(_mm256_andnot_pd(mask, self.0)))
    }
    #[inline(always)]
    fn of_four(self, table: &[f64; 4]) -> Self {
        // The two halves of entry n are halves 2n and 2n + 1; bits above the lowest three do not
        // count.
        let twice = here!(_mm256_castsi256_ps(_mm256_add_epi64(
            self.bits(),
            self.bits()
        )));
        let halves = here!(_mm256_or_si256(
            _mm256_castps_si256(_mm256_moveldup_ps(twice)),
            _mm256_set1_epi64x(1 << 32)
        ));
        let table = here!(_mm256_castpd_ps(Self::from_array(*table).0));
        Self(here!(_mm256_castps_pd(_mm256_permutevar8x32_ps(
            table, halves
        ))))
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        // What carries into the exponent is n; with 1024 added it is not negative. It is made a number
        // as the lowest bits of one.
        let above = here!(_mm256_sub_epi64(
            self.bits(),
            _mm256_set1_epi64x(ROOT_OF_HALF - (1024 << 52))
        ));
        let n = here!(_mm256_srli_epi64::<52>(above));
        let shifted = here!(_mm256_sub_epi64(n, _mm256_set1_epi64x(1024)));
        let m = here!(_mm256_sub_epi64(
            self.bits(),
            _mm256_slli_epi64::<52>(shifted)
        ));
        let whole = here!(_mm256_add_epi64(
            shifted,
            _mm256_set1_epi64x(WHOLE.to_bits() as i64)
        ));
        (
            Self(here!(_mm256_castsi256_pd(m))),
            Self(here!(_mm256_castsi256_pd(whole))) - WHOLE,
        )
    }
    #[inline(always)]
    fn raise(self, whole: Self) -> Self {
        let added = here!(_mm256_slli_epi64::<50>(whole.bits()));
        Self(here!(_mm256_castsi256_pd(_mm256_add_epi64(
            self.bits(),
            added
        ))))
    }
    #[inline(always)]
    fn nearest(self) -> Self {
        Self(here!(_mm256_round_pd::<
            { _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC },
        >(self.0)))
    }
}
