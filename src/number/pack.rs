//! Vector registers as numbers: lanes of drives side by side, or partial derivatives of one.
//!
//! The one place that names instructions. A register type is used only inside a [`Task`](super::Task) that runs on the
//! [`Level`](super::Level) it belongs to, which asks the processor first; that is what each `unsafe` here relies on.
#![allow(unsafe_code)]

use super::Numbers;
use super::bits::Bits;
use super::exponential::{self, Powers};
use super::lanes::Lanes;
use super::sine;
use super::tanh::tanh;
use std::arch::x86_64::*;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A register type with its operators, as lanes.
macro_rules! pack {
    (
        $( $(#[doc = $doc:literal])+ $Pack:ident outlined $outlined:ident, )+
        as $Register:ident of $width:literal, $instructions:tt
    ) => {
        $( pack! { type $(#[doc = $doc])+ $Pack($Register) of $width outlined $outlined, $instructions } )+
    };

    (
        type $(#[doc = $doc:literal])+ $Pack:ident($Register:ident) of $width:literal outlined $outlined:ident,
        {
            operators $add:ident $sub:ident $mul:ident $div:ident,
            spread $set:ident, fused $mul_add:ident, root $sqrt:ident, least $min:ident $max:ident,
            power |$rounded:ident| $power:expr, below |$x:ident, $limit:ident| $below:expr,
            blend |$yes:ident, $no:ident, $mask:ident| $blend:expr, root and inverse |$square:ident| $sqrt_recip:expr
        }
    ) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy)]
        pub(crate) struct $Pack($Register);

        impl $Pack {
            #[inline(always)]
            fn spread(value: f64) -> Self {
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            pub fn from_array(values: [f64; $width]) -> Self {
                // SAFETY: the register is as many numbers in a row
                Self(unsafe { std::mem::transmute::<[f64; $width], $Register>(values) })
            }
            #[inline(always)]
            pub fn to_array(self) -> [f64; $width] {
                // SAFETY: as above
                unsafe { std::mem::transmute::<$Register, [f64; $width]>(self.0) }
            }
            #[inline(always)]
            fn each(self, f: impl Fn(f64) -> f64) -> Self {
                Self::from_array(self.to_array().map(f))
            }
        }

        impl fmt::Debug for $Pack {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.to_array().fmt(f)
            }
        }

        pack!(operator $Pack Add add $add);
        pack!(operator $Pack Sub sub $sub);
        pack!(operator $Pack Mul mul $mul);
        pack!(operator $Pack Div div $div);

        impl Neg for $Pack {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::spread(-0.0) - self
            }
        }

        impl Powers for $Pack {
            #[inline(always)]
            fn two_to(rounded: Self) -> Self {
                let $rounded = rounded.0;
                Self(unsafe { $power })
            }
            #[inline(always)]
            fn clamped(self, low: f64, high: f64) -> Self {
                // the second operand is taken where one is NaN: it stays
                Self(unsafe { $min($set(high), $max($set(low), self.0)) })
            }
        }

        impl Numbers for $Pack {
            type Mask = Bits<$width>;

            #[inline(always)]
            fn constant(value: f64) -> Self {
                Self::spread(value)
            }
            #[inline(always)]
            fn recip(self) -> Self {
                Self::spread(1.0) / self
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }
            #[inline(always)]
            fn sqrt_recip(self) -> (Self, Self) {
                let $square = self;
                $sqrt_recip
            }
            #[inline(always)]
            fn exp(self) -> Self {
                exponential::exp(self)
            }
            #[inline(always)]
            fn exp_m1(self) -> Self {
                exponential::exp_m1(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                Self::outlined(
                    #[inline(always)]
                    || self.each(f64::ln),
                )
            }
            #[inline(always)]
            fn ln_1p(self) -> Self {
                Self::outlined(
                    #[inline(always)]
                    || self.each(f64::ln_1p),
                )
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                // not inlined: an impact has six of them
                Self::outlined(
                    #[inline(always)]
                    || {
                        sine::sin_cos(
                            self,
                            #[inline(always)]
                            |x| (x.each(f64::sin), x.each(f64::cos)),
                        )
                    },
                )
            }
            #[inline(always)]
            fn atan(self) -> Self {
                Self::outlined(
                    #[inline(always)]
                    || self.each(f64::atan),
                )
            }
            #[inline(always)]
            fn tanh(self) -> Self {
                tanh(self)
            }
            #[inline(always)]
            fn below(self, limit: f64) -> Bits<$width> {
                let ($x, $limit) = (self.0, Self::spread(limit).0);
                Bits(unsafe { $below } as u8)
            }
            #[inline(always)]
            fn blend(self, other: Self, mask: Bits<$width>) -> Self {
                let ($yes, $no, $mask) = (self.0, other.0, mask.0);
                Self(unsafe { $blend })
            }
            #[inline(always)]
            fn without_derivatives(self) -> Self {
                self
            }
            #[inline(always)]
            fn is_finite(self) -> Bits<$width> {
                // x − x is 0 where x is finite and NaN, below nothing, where it is not
                (self - self).below(1.0)
            }
            #[inline(always)]
            fn looked_up<const N: usize>(self, other: Self, place: impl Fn(f64, f64) -> &'static [f64; N]) -> [Self; N] {
                let (x, y) = (self.to_array(), other.to_array());
                let mut lanes = [[0.0; $width]; N];
                let mut lane = 0;
                while lane < $width {
                    let (found, mut i) = (place(x[lane], y[lane]), 0);
                    while i < N {
                        lanes[i][lane] = found[i];
                        i += 1;
                    }
                    lane += 1;
                }
                let (mut all, mut i) = ([Self::spread(0.0); N], 0);
                while i < N {
                    all[i] = Self::from_array(lanes[i]);
                    i += 1;
                }
                all
            }
            #[inline(always)]
            fn outlined<R>(work: impl FnMut() -> R) -> R {
                unsafe { super::outlined::$outlined::outlined(work) }
            }
            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                Self(unsafe { $mul_add(self.0, a.0, b.0) })
            }
            #[inline(always)]
            fn scale_add(self, a: f64, b: Self) -> Self {
                self.mul_add(Self::spread(a), b)
            }
        }

        impl Lanes for $Pack {
            const WIDTH: usize = $width;
            type Lane = f64;

            #[inline(always)]
            fn lane(self, i: usize) -> f64 {
                self.to_array()[i]
            }
            #[inline(always)]
            fn with_values(f: impl FnMut(usize) -> f64) -> Self {
                Self::from_array(std::array::from_fn(f))
            }
            #[inline(always)]
            fn seeded(self, _: &impl Fn(usize) -> Self::Mask, _: usize) -> Self {
                self
            }
        }

    };

    (operator $Pack:ident $Operator:ident $operation:ident $instruction:ident) => {
        impl $Operator for $Pack {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: Self) -> Self {
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }

        impl $Operator<f64> for $Pack {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: f64) -> Self {
                self.$operation(Self::spread(other))
            }
        }
    };
}

pack! {
    /// Four numbers (AVX2 with FMA).
    Pack4 outlined avx2,
    as __m256d of 4,
    {
        operators _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd,
        spread _mm256_set1_pd, fused _mm256_fmadd_pd, root _mm256_sqrt_pd, least _mm256_min_pd _mm256_max_pd,
        power |k| _mm256_castsi256_pd(
            _mm256_slli_epi64::<52>(_mm256_add_epi64(_mm256_castpd_si256(k), _mm256_set1_epi64x(1023)))
        ),
        below |x, limit| _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(x, limit)),
        blend |yes, no, mask| {
            let bit = _mm256_set_epi64x(8, 4, 2, 1);
            let set = _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(i64::from(mask)), bit), bit);
            _mm256_blendv_pd(no, yes, _mm256_castsi256_pd(set))
        },
        root and inverse |x| { let (root, inverse) = (x.sqrt(), x.recip()); (root, root * inverse) }
    }
}

pack! {
    /// Eight numbers (AVX-512).
    Pack8 outlined avx512,
    as __m512d of 8,
    {
        operators _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd,
        spread _mm512_set1_pd, fused _mm512_fmadd_pd, root _mm512_sqrt_pd, least _mm512_min_pd _mm512_max_pd,
        power |k| _mm512_castsi512_pd(
            _mm512_slli_epi64::<52>(_mm512_add_epi64(_mm512_castpd_si512(k), _mm512_set1_epi64(1023)))
        ),
        below |x, limit| _mm512_cmp_pd_mask::<_CMP_LT_OQ>(x, limit),
        blend |yes, no, mask| _mm512_mask_blend_pd(mask, no, yes),
        root and inverse |x| {
            // 14 bits from a table, 70 by one step of fourth order: the divider is busy three times as long with a root and
            // a quotient. Both are reached by the shortest chain; a rounding of the first is halved in them
            let guess = Self(unsafe { _mm512_rsqrt14_pd(x.0) });
            let first = x * guess;
            let error = -first.mul_add(guess, Self::spread(-1.0));
            let high = error.scale_add(35.0 / 128.0, Self::spread(0.3125));
            let series = high.mul_add(error * error, error.scale_add(0.375, Self::spread(0.5)));
            ((first * error).mul_add(series, first), (guess * error).mul_add(series, guess))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Lanes, Level, Task};

    /// The largest errors of root, inverse root and exponential over many numbers, in units of the last place.
    struct Worst;

    impl Task for Worst {
        type Output = [f64; 3];

        #[inline(always)]
        fn run<P: Lanes<Lane = f64>>(self) -> [f64; 3] {
            let mut worst = [0.0_f64; 3];
            for i in 0..40_000 {
                // 1e-12 to 1e12, each lane another
                let x: P =
                    P::with_values(|lane| 10_f64.powf(-12.0 + 24.0 * f64::from(i) / 4e4) * (1.0 + 0.37 * lane as f64));
                let (root, inverse) = x.sqrt_recip();
                let exponent = (root * 1e-6).exp();
                for lane in 0..P::WIDTH {
                    let (exact, small) = (x.lane(lane).sqrt(), root.lane(lane) * 1e-6);
                    let pairs = [(root, exact), (inverse, 1.0 / exact), (exponent, small.exp())];
                    for (most, (found, exact)) in worst.iter_mut().zip(pairs) {
                        *most = most.max((found.lane(lane) - exact).abs() / (exact.abs() * f64::EPSILON));
                    }
                }
            }
            worst
        }
    }

    #[test]
    fn measured_vector_functions_are_within_two_units_of_the_libm_ones() {
        for worst in [Level::Avx2, Level::Avx512].map(|level| level.run(Worst)) {
            assert!(worst.iter().all(|most| *most <= 2.0), "{worst:?}");
        }
    }
}
