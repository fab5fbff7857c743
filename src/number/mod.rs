//! The numbers the physics is written over.
//!
//! [`Numbers`] lists the few operations that a drive needs, [`Number`] adds that there is one value
//! to look at. One implementation is for every [`num_dual::DualNum`] over `f64`: for `f64` itself
//! (plain values) and for each of num-dual's dual numbers (values with exact derivatives). [`Jet`],
//! which carries derivatives and, over itself, second derivatives, and the lanes, which hold
//! several drives, or several directions of one, side by side, have implementations of their own.
//!
//! # Pipelines
//!
//! A flight is a chain of dependent operations: each stage needs the acceleration of the stage
//! before. The equation of motion (`flight/motion.rs`, `flight/step.rs`) is ordered for latency:
//!
//! - The operand that is ready last enters last. |v_r|² is summed in pairs; the wind is subtracted
//!   before the accelerations of the stages are added; lift is computed before drag, whose
//!   coefficient is ready later; the airspeed multiplies their sum, so that laws that depend on the
//!   spin only do not wait for it.
//! - The nodes at both ends of a step swap places by reference. A copy would load what was just
//!   stored in smaller pieces, which the processor cannot forward: 16 to 24 % of a drive with rk4.
//! - Long functions that are called rarely, or at several places, are compiled once for each number
//!   type ([`Numbers::outlined`]). A loop over two evaluations has one call site instead of two.

mod compiled;
mod derivatives;
mod dual;
mod held;
mod inlined;
mod jet;
mod lanes;
mod level;
mod mask;
mod outlined;
mod tanh;
mod taylor;
mod vector;

pub(crate) use compiled::{MOST_PER_LANE, OverNumbers, over_directions, over_drives};
pub(crate) use derivatives::Derivatives;
pub(crate) use held::{held_above, held_below, smooth_step};
pub(crate) use inlined::inlined;
pub use jet::{Jet, Mixed};
pub(crate) use lanes::{Lanes, in_lane};
pub use level::Level;
pub(crate) use level::Task;
pub use mask::Mask;
pub use taylor::Taylor;
pub use vector::Vector;

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The four operations with a right-hand side `R`.
pub trait Arithmetic<R>:
    Sized
    + Add<R, Output = Self>
    + Sub<R, Output = Self>
    + Mul<R, Output = Self>
    + Div<R, Output = Self>
{
}

impl<T, R> Arithmetic<R> for T where
    T: Add<R, Output = T> + Sub<R, Output = T> + Mul<R, Output = T> + Div<R, Output = T>
{
}

/// A real number, possibly carrying derivatives, or several of them side by side.
///
/// Where there may be several, there is no one value to branch on: a formula that changes its form
/// asks [`below`](Numbers::below) and [`choose`](Numbers::choose)s.
pub trait Numbers:
    Copy + Debug + 'static + Neg<Output = Self> + Arithmetic<Self> + Arithmetic<f64>
{
    /// The answer to a comparison: `bool`, or one for each of several.
    type Mask: Mask;

    /// The number with this value and no derivatives.
    fn constant(value: f64) -> Self;
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
    /// sin x and cos x.
    fn sin_cos(self) -> (Self, Self);
    /// arctan x.
    fn atan(self) -> Self;
    /// Whether the value is below a limit.
    fn below(self, limit: f64) -> Self::Mask;
    /// `self` where the mask holds, `other` where it does not.
    fn blend(self, other: Self, mask: Self::Mask) -> Self;
    /// The value without its derivatives: what is not to be differentiated costs no more than over
    /// plain numbers.
    fn without_derivatives(self) -> Self;
    /// Whether the value, and that of each of several, is finite.
    fn is_finite(self) -> Self::Mask;
    /// The constants of a table at (`self`, `other`), looked up lane by lane; they have no
    /// derivatives.
    fn looked_up<const N: usize>(
        self,
        other: Self,
        place: impl Fn(f64, f64) -> &'static [f64; N],
    ) -> [Self; N];

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::constant(0.0)
    }

    /// x a + b, rounded once where that is as fast.
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// x a + b with a plain factor.
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        self * a + b
    }

    /// √x and 1/√x.
    #[inline(always)]
    fn sqrt_recip(self) -> (Self, Self) {
        // the quotient does not wait for the root
        let (root, inverse) = (self.sqrt(), self.recip());
        (root, root * inverse)
    }

    /// `yes()` where the mask holds, `no()` where it does not; what no one needs is not computed.
    #[inline(always)]
    fn choose(mask: Self::Mask, yes: impl Fn() -> Self, no: impl Fn() -> Self) -> Self {
        if mask.all() {
            yes()
        } else if !mask.any() {
            no()
        } else {
            yes().blend(no(), mask)
        }
    }

    /// Does `work` in a function of its own, compiled for the instructions of this number: for code
    /// too large to inline at each use. (`FnMut`, since a `FnOnce` is called through a function
    /// that no attribute reaches.)
    #[inline(always)]
    fn outlined<R>(work: impl FnMut() -> R) -> R {
        outlined::plain::outlined(work)
    }

    /// sin x.
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// cos x.
    #[inline(always)]
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

    /// xᵃ, exact in every derivative that exists.
    ///
    /// - a whole: [`powi`](Numbers::powi), so any x; for a < 0 its reciprocal, infinite at 0.
    /// - a > 0, not whole: 0 at 0, with derivatives up to the order ⌊a⌋; the next is infinite.
    /// - a < 0, not whole: infinite at 0. For x < 0 NaN, as for every a that is not whole.
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
        // 2 f64::MAX is infinite, but 0 times each factor is 0
        Self::choose(
            is_nonzero,
            power,
            inlined!(|| self.powi(a.ceil() as u32) * f64::MAX * 2.0),
        )
    }

    /// tanh x, finite for every x (sinh/cosh overflows).
    fn tanh(self) -> Self;
}

/// A real number, possibly carrying derivatives, with one value to look at.
///
/// Branches and iterations look at [`re`](Number::re) only, so that a drive takes the same path
/// whatever it is evaluated over.
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
    /// The value, without derivatives.
    fn re(self) -> f64;

    /// The angle of the point (x, y), with `self` as y. The derivatives are exact in every
    /// direction, also along the axes: the point is turned onto the positive x-axis first. At the
    /// origin there is no angle.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let angle = self.re().atan2(x.re());
        let (sin, cos) = angle.sin_cos();
        let along = x * cos + self * sin;
        let across = self * cos - x * sin;
        (across / along).atan() + angle
    }
}
