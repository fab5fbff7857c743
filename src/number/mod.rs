//! Number types of the physics: the physics is written once, generic over the number.
//!
//! [`Numbers`] declares the operations that a drive needs; [`Number`] is for types with a single
//! value, and adds access to it. One implementation covers every [`num_dual::DualNum`] over `f64`:
//! `f64` itself and num-dual's dual numbers. [`Jet`] (dual numbers with a fixed number of
//! directions; nested for second derivatives) and the lanes (SIMD registers, with one drive or one
//! direction per lane) have their own implementations.
//!
//! # Inlining
//!
//! A function is compiled for a vector unit only if it is inlined into a function that has the
//! `target_feature` of the unit. Everything from a `Task` down to the instructions is therefore
//! `#[inline(always)]`, and so are closures (macro `inlined!`: the attribute is allowed on an
//! argument, but not on the right side of a `let`). Code too large to inline at each use goes
//! through [`Numbers::not_inlined`], which calls a function compiled for the same instructions. Any
//! other code that is not inlined silently falls back to baseline instructions, which is several
//! times slower.
//!
//! # Pipelines
//!
//! The polynomials of eˣ and tanh are summed as a tree (Estrin's scheme): the dependency chain
//! grows with the logarithm of the degree. [`Numbers::sqrt_recip`] computes 1/√x as √x · (1/x),
//! because the quotient need not wait for the root. With AVX-512, an approximate 1/√x and one
//! iteration (11 operations) replace root and quotient. Root and quotient would occupy the divider
//! for 18 + 16 cycles, three times as long as the iteration occupies a multiplier.
//!
//! A flight is a chain of dependent operations: each stage needs the acceleration of the stage
//! before. The equation of motion (`flight/motion.rs`, `flight/step.rs`) is ordered for latency:
//!
//! - The operand that is ready last is used last. |v_r|² is summed in pairs. The wind is subtracted
//!   before the accelerations of the stages are added. Lift is computed before drag, because the
//!   coefficient of drag is ready later. The airspeed multiplies the sum of lift and drag, so that
//!   a law that depends on the spin only does not wait for the airspeed.
//! - The nodes at both ends of a step are swapped by reference. A copy would load data that was
//!   just stored in smaller pieces, and the processor cannot forward several stores to one load:
//!   copies take 16 to 24 % of a drive with rk4.
//! - Long functions that are called rarely, or at several places, are compiled once for each number
//!   type ([`Numbers::not_inlined`]). Two calls of one function are written as a loop, so that the
//!   function is inlined once.

mod compiled;
mod dual;
mod inlined;
mod jet;
mod lanes;
mod level;
mod mask;
mod smooth_clamp;
mod tanh;
mod taylor;
mod vector;

pub(crate) use compiled::{MOST_PER_LANE, OverNumbers, over_directions, over_drives};
pub(crate) use inlined::inlined;
pub(crate) use jet::Derivatives;
pub use jet::{Jet, Mixed};
pub(crate) use lanes::Lanes;
pub use level::Level;
pub(crate) use level::Task;
pub use mask::Mask;
pub(crate) use smooth_clamp::{smooth_clamp_above, smooth_clamp_below, smooth_step};
pub use taylor::Taylor;
pub use vector::Vector;

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number with optional derivatives, or several such numbers in lanes.
///
/// A formula with cases must not branch, because the lanes may need different cases. It compares
/// numbers by [`below`](Numbers::below), and [`select_lazily`](Numbers::select_lazily) selects the
/// case of each lane.
pub trait Numbers:
    Copy
    + Debug
    + 'static
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// Result of a comparison: `bool`, or one bit per lane.
    type Mask: Mask;

    /// Number with this value and zero derivatives.
    fn constant(value: f64) -> Self;
    /// 1/x.
    fn recip(self) -> Self;
    /// √x.
    fn sqrt(self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// eˣ − 1, accurate also near 0.
    fn exp_m1(self) -> Self;
    /// ln x.
    fn ln(self) -> Self;
    /// sin x and cos x.
    fn sin_cos(self) -> (Self, Self);
    /// arctan x.
    fn atan(self) -> Self;
    /// Comparison x < limit, by value.
    fn below(self, limit: f64) -> Self::Mask;
    /// Selects lanes: `self` where the mask is true, `other` elsewhere.
    fn select(self, other: Self, mask: Self::Mask) -> Self;
    /// The value with zero derivatives. Computations with such numbers cost no more than with plain
    /// numbers.
    fn without_derivatives(self) -> Self;
    /// True where the value is finite.
    fn is_finite(self) -> Self::Mask;
    /// Gathers `N` constants from a table, for each lane separately: `place` returns the constants
    /// for the values of `self` and `other` in a lane. The result has zero derivatives.
    fn gather<const N: usize>(
        self,
        other: Self,
        place: impl Fn(f64, f64) -> &'static [f64; N],
    ) -> [Self; N];

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::constant(0.0)
    }

    /// x a + b, fused (rounded once) if the fused operation is as fast.
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// x a + b, with a factor a that has no derivatives.
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        self * a + b
    }

    /// √x and 1/√x.
    #[inline(always)]
    fn sqrt_recip(self) -> (Self, Self) {
        let (root, inverse) = (self.sqrt(), self.recip());
        (root, root * inverse)
    }

    /// Selects between two cases, `yes()` where the mask is true and `no()` elsewhere. A case that
    /// no lane needs is not computed.
    #[inline(always)]
    fn select_lazily(mask: Self::Mask, yes: impl Fn() -> Self, no: impl Fn() -> Self) -> Self {
        if mask.all() {
            yes()
        } else if !mask.any() {
            no()
        } else {
            yes().select(no(), mask)
        }
    }

    /// Runs `work` in a function that is not inlined and is compiled for the instruction set of
    /// this number type. `work` is `FnMut`, because a `FnOnce` would be called through a shim that
    /// is compiled without this instruction set.
    #[inline(always)]
    fn not_inlined<R>(work: impl FnMut() -> R) -> R {
        inlined::plain::not_inlined(work)
    }

    /// Sine sin x.
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine cos x.
    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// xⁿ, with exact derivatives of any order, also at 0.
    #[inline]
    fn powi(self, n: u32) -> Self {
        // repeated squaring: no division, and no logarithm of a negative number
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

    /// xᵃ, with exact derivatives where they exist.
    ///
    /// - integer a: [`powi`](Numbers::powi) with |a|, for any x; for a < 0 the reciprocal of that
    ///   power, infinite at 0.
    /// - non-integer a > 0: 0 at 0, with derivatives up to order ⌊a⌋; the next derivative is
    ///   infinite. NaN for x < 0.
    /// - non-integer a < 0: infinite at 0, NaN for x < 0.
    #[inline(always)]
    fn powf(self, a: f64) -> Self {
        if a.fract() == 0.0 && a.abs() <= f64::from(u32::MAX) {
            let power = self.powi(a.abs() as u32);
            return if a < 0.0 { power.recip() } else { power };
        }
        let power = inlined!(|| (self.ln() * a).exp());
        if a < 0.0 {
            return power();
        }
        let is_nonzero = self.below(0.0) | (-self).below(0.0);
        // at 0: with n = ⌈a⌉, xⁿ and its first n − 1 derivatives are 0; the factor makes the n-th
        // derivative infinite
        Self::select_lazily(
            is_nonzero,
            power,
            inlined!(|| self.powi(a.ceil() as u32) * f64::MAX * 2.0),
        )
    }

    /// Hyperbolic tangent tanh x, finite for every x (sinh/cosh overflows).
    fn tanh(self) -> Self;
}

/// A single real number with optional derivatives.
///
/// Branches and iterations depend on [`re`](Number::re) only, so that a drive takes the same path
/// for every number type.
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
pub trait Number: Numbers<Mask = bool> {
    /// Value without derivatives.
    fn re(self) -> f64;

    /// Angle of the point (x, y), with y = `self`; undefined at the origin. Derivatives are exact
    /// at all other points, also on the axes, because the point is first rotated onto the positive
    /// x-axis.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let angle = self.re().atan2(x.re());
        let (sin, cos) = angle.sin_cos();
        let along = x * cos + self * sin;
        let across = self * cos - x * sin;
        (across / along).atan() + angle
    }
}
