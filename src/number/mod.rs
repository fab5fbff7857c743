//! The numbers the physics is written over.
//!
//! [`Number`] lists the few operations that a drive needs. It is implemented once, for every
//! [`num_dual::DualNum`] over `f64`: for `f64` itself (plain values) and for each of num-dual's dual
//! numbers (values with exact derivatives). A number type of our own implements the same trait and then
//! runs through the same physics.

mod differentiate;
mod jet;
mod linear;
mod seed;
mod taylor;
mod vector;

pub use differentiate::Order;
pub(crate) use differentiate::{Pairs, Seedable, first, second, values};
pub use jet::{Jet, Jet2};
pub(crate) use linear::solve;
pub(crate) use seed::Seeded;
pub use taylor::Taylor;
pub use vector::Vector;

use num_dual::DualNum;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The four operations with a right-hand side `R`.
pub trait Arithmetic<R>:
    Sized + Add<R, Output = Self> + Sub<R, Output = Self> + Mul<R, Output = Self> + Div<R, Output = Self>
{
}

impl<T, R> Arithmetic<R> for T where T: Add<R, Output = T> + Sub<R, Output = T> + Mul<R, Output = T> + Div<R, Output = T>
{}

/// A real number, possibly carrying derivatives.
///
/// Branches and iterations look at [`re`](Number::re) only, so that a drive takes the same path whatever
/// it is evaluated over.
///
/// ```
/// use longdrive::number::Number;
/// use num_dual::Dual64;
///
/// fn cube<T: Number>(x: T) -> T { x * x * x }
///
/// assert_eq!(cube(2.0), 8.0);
/// let at_two = cube(Dual64::from(2.0).derivative());
/// assert_eq!((at_two.re, at_two.eps), (8.0, 12.0)); // 3 x²
/// ```
pub trait Number: Copy + Debug + 'static + Neg<Output = Self> + Arithmetic<Self> + Arithmetic<f64> {
    /// The number with this value and no derivatives.
    fn constant(value: f64) -> Self;
    /// The value, without derivatives.
    fn re(self) -> f64;
    /// 1/x.
    fn recip(self) -> Self;
    /// √x.
    fn sqrt(self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// eˣ − 1, exact near 0.
    fn exp_m1(self) -> Self;
    /// ln x.
    fn ln(self) -> Self;
    /// ln(1 + x), exact near 0.
    fn ln_1p(self) -> Self;
    /// sin x and cos x.
    fn sin_cos(self) -> (Self, Self);
    /// arctan x.
    fn atan(self) -> Self;

    /// Zero.
    #[inline]
    fn zero() -> Self {
        Self::constant(0.0)
    }

    /// sin x.
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// cos x.
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// xⁿ, exact in every derivative also at 0.
    #[inline]
    fn powi(self, n: u32) -> Self {
        // by squaring: no division, and no logarithm of a negative number
        let (mut power, mut square, mut left) = (Self::constant(1.0), self, n);
        while left > 0 {
            if left % 2 == 1 {
                power = power * square;
            }
            square = square * square;
            left /= 2;
        }
        power
    }

    /// xᵃ for x > 0.
    #[inline]
    fn powf(self, a: f64) -> Self {
        (self.ln() * a).exp()
    }

    /// tanh x, finite for every x (sinh/cosh overflows).
    #[inline]
    fn tanh(self) -> Self {
        if self.re() < 0.0 {
            return -(-self).tanh();
        }
        let decay = (self * -2.0).exp_m1();
        -decay / (decay + 2.0)
    }

    /// The angle of the point (x, y), with `self` as y. The derivatives are exact in every direction, also
    /// along the axes: the point is turned onto the positive x-axis first. At the origin there is no angle.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let angle = self.re().atan2(x.re());
        let (sin, cos) = angle.sin_cos();
        let along = x * cos + self * sin;
        let across = self * cos - x * sin;
        (across / along).atan() + angle
    }
}

impl<D: DualNum<Primitive = f64> + Copy> Number for D {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        D::from(value)
    }
    #[inline(always)]
    fn re(self) -> f64 {
        num_dual::DualStruct::re(&self)
    }
    #[inline(always)]
    fn recip(self) -> Self {
        DualNum::recip(&self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        DualNum::exp(&self)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        DualNum::exp_m1(&self)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        DualNum::ln(&self)
    }
    #[inline(always)]
    fn ln_1p(self) -> Self {
        DualNum::ln_1p(&self)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }
    #[inline(always)]
    fn atan(self) -> Self {
        DualNum::atan(&self)
    }
}

#[cfg(test)]
mod tests {
    use super::Number;
    use num_dual::{Dual2_64, Dual64};

    #[test]
    fn exact_atan2_has_derivatives_in_every_direction() {
        // d/dt atan2(sin t, cos t) = 1, and its second derivative is 0
        for k in 0..16 {
            let t = Dual2_64::from(f64::from(k) * std::f64::consts::FRAC_PI_8 - 3.0).derivative();
            let (y, x) = Number::sin_cos(t);
            let angle = Number::atan2(y, x);
            assert!((angle.v1 - 1.0).abs() < 1e-14, "{angle:?}");
            assert!(angle.v2.abs() < 1e-14, "{angle:?}");
        }
        let vertical = Number::atan2(Dual64::from(1.0), Dual64::from(0.0).derivative());
        assert_eq!(vertical.eps, -1.0);
    }

    #[test]
    fn exact_tanh_is_finite_far_out_and_keeps_its_digits_near_zero() {
        assert_eq!(Number::tanh(Dual64::from(800.0).derivative()).re, 1.0);
        assert_eq!(Number::tanh(Dual64::from(-800.0).derivative()).eps, 0.0);
        let small = Number::tanh(Dual64::from(1e-9).derivative());
        assert!((small.re / 1e-9 - 1.0).abs() < 1e-15 && (small.eps - 1.0).abs() < 1e-15);
        assert!((Number::tanh(0.7_f64) - 0.7_f64.tanh()).abs() < 1e-16);
    }
}
