use super::Numbers;
use std::fmt::Debug;
use std::ops::{Add, Neg, Sub};

/// What a [`Jet`](super::Jet) keeps beside its value: a partial derivative, or as many as a vector register holds. It is
/// multiplied by values and added.
pub trait Partial<B: Numbers>:
    Copy + Debug + 'static + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// No change.
    fn none() -> Self;
    /// d b.
    fn times(self, b: B) -> Self;
    /// d b + other.
    fn times_plus(self, b: B, other: Self) -> Self;
    /// d b with a plain factor.
    fn scaled(self, b: f64) -> Self;
    /// d b + other with a plain factor.
    fn scaled_plus(self, b: f64, other: Self) -> Self;
    /// `self` where the mask holds, `other` where it does not.
    fn either(self, other: Self, mask: B::Mask) -> Self;
    /// Whether it is 0 throughout.
    fn vanishes(self) -> bool;
    /// As [`Numbers::outlined`].
    fn outlined<R>(work: impl FnOnce() -> R) -> R;
}

/// A number is a partial derivative itself.
impl<B: Numbers> Partial<B> for B {
    #[inline(always)]
    fn none() -> Self {
        B::zero()
    }
    #[inline(always)]
    fn times(self, b: B) -> Self {
        self * b
    }
    #[inline(always)]
    fn times_plus(self, b: B, other: Self) -> Self {
        self.mul_add(b, other)
    }
    #[inline(always)]
    fn scaled(self, b: f64) -> Self {
        self * b
    }
    #[inline(always)]
    fn scaled_plus(self, b: f64, other: Self) -> Self {
        self.scale_add(b, other)
    }
    #[inline(always)]
    fn either(self, other: Self, mask: B::Mask) -> Self {
        self.blend(other, mask)
    }
    #[inline(always)]
    fn vanishes(self) -> bool {
        self.is_zero()
    }
    #[inline(always)]
    fn outlined<R>(work: impl FnOnce() -> R) -> R {
        B::outlined(work)
    }
}
