//! [`Numbers`] for num-dual's types: `f64` and dual numbers.

use super::tanh::tanh;
use super::{Number, Numbers};
use num_dual::DualNum;

/// Implements functions by num-dual's functions of the same name.
macro_rules! num_dual_has {
    ($($function:ident)+) => {$(
        #[inline(always)]
        fn $function(self) -> Self {
            DualNum::$function(&self)
        }
    )+};
}

impl<D: DualNum<Primitive = f64> + Copy> Numbers for D {
    type Mask = bool;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        D::from(value)
    }
    num_dual_has! { recip sqrt exp exp_m1 ln atan }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }
    #[inline(always)]
    fn below(self, limit: f64) -> bool {
        num_dual::DualStruct::re(&self) < limit
    }
    #[inline(always)]
    fn select(self, other: Self, mask: bool) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn without_derivatives(self) -> Self {
        D::from(num_dual::DualStruct::re(&self))
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        num_dual::DualStruct::re(&self).is_finite()
    }
    #[inline(always)]
    fn gather<const N: usize>(
        self,
        other: Self,
        place: impl Fn(f64, f64) -> &'static [f64; N],
    ) -> [Self; N] {
        place(
            num_dual::DualStruct::re(&self),
            num_dual::DualStruct::re(&other),
        )
        .map(D::from)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        tanh(self)
    }
}

impl<D: DualNum<Primitive = f64> + Copy> Number for D {
    #[inline(always)]
    fn re(self) -> f64 {
        num_dual::DualStruct::re(&self)
    }
}
