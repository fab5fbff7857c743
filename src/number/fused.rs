use super::exponential::{self, Powers};
use super::{Number, Numbers};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A plain number whose products and sums round once, as processors with fused multiply–add do in one instruction.
/// On others [`mul_add`](Numbers::mul_add) is a slow call: `f64` is the number for these.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Fused(pub f64);

macro_rules! operator {
    ($Operator:ident, $operation:ident) => {
        impl $Operator for Fused {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: Self) -> Self {
                Self(self.0.$operation(other.0))
            }
        }

        impl $Operator<f64> for Fused {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: f64) -> Self {
                Self(self.0.$operation(other))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Powers for Fused {
    #[inline(always)]
    fn two_to(rounded: Self) -> Self {
        Self(f64::from_bits(rounded.0.to_bits().wrapping_add(1023) << 52))
    }
    #[inline(always)]
    fn clamped(self, low: f64, high: f64) -> Self {
        // NaN stays: each comparison with it is false
        let above = if self.0 < low { low } else { self.0 };
        Self(if above > high { high } else { above })
    }
}

impl Numbers for Fused {
    type Mask = bool;
    type Value = Self;
    const IS_LONE: bool = true;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self(value)
    }
    #[inline(always)]
    fn recip(self) -> Self {
        Self(self.0.recip())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
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
    fn known_exp_m1(self, value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
    #[inline(always)]
    fn ln_1p(self) -> Self {
        Self(self.0.ln_1p())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
    #[inline(always)]
    fn atan(self) -> Self {
        Self(self.0.atan())
    }
    #[inline(always)]
    fn below(self, limit: f64) -> bool {
        self.0 < limit
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: bool) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.0 == 0.0
    }
    #[inline(always)]
    fn is_constant(self) -> bool {
        true
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline(always)]
    #[cfg(target_arch = "x86_64")]
    #[allow(unsafe_code)]
    fn outlined<R>(work: impl FnOnce() -> R) -> R {
        // SAFETY: fused numbers are used at the levels from four on, which have asked the processor
        unsafe { super::outlined::fused::outlined(work) }
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.mul_add(a.0, b.0))
    }
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        Self(self.0.mul_add(a, b.0))
    }
}

impl Number for Fused {
    #[inline(always)]
    fn re(self) -> f64 {
        self.0
    }
}
