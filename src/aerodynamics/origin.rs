//! Lift near zero spin.

use crate::number::{Numbers, inlined};

/// Cubic that replaces C_L for spin ratios s < s₀, if the formula of a law has lift or an infinite
/// slope at zero spin: C_L = a u + b u² + c u³ with u = s/s₀. At s₀ it has the value, slope and
/// curvature of the formula, so C_L is C². At zero spin C_L is 0.
struct CubicOrigin<T> {
    /// s₀: spin ratio at which the cubic joins the formula.
    join: f64,
    /// C_L at s₀.
    value: T,
    /// s₀ dC_L/ds at s₀.
    slope: T,
    /// s₀² d²C_L/ds² at s₀.
    curvature: T,
}

impl<T: Numbers> CubicOrigin<T> {
    /// C_L at a spin ratio below s₀.
    #[inline(always)]
    fn lift(&self, spin_ratio: T) -> T {
        let u = spin_ratio / self.join;
        let rise = self.slope - self.value;
        let c = self.curvature * 0.5 - rise;
        let b = rise - c * 2.0;
        let a = self.value - b - c;
        (a + (b + c * u) * u) * u
    }
}

/// s₀ of the [`CubicOrigin`] of a power law, whose slope is infinite at zero spin.
const SMOOTH_BELOW: f64 = 0.001;

/// C_L = factor s^exponent, replaced by a [`CubicOrigin`] for s < 0.001.
#[inline(always)]
pub(super) fn power<T: Numbers>(factor: T, exponent: T, s: T) -> T {
    let smooth = inlined!(|| {
        let value = factor * (exponent * SMOOTH_BELOW.ln()).exp();
        let slope = value * exponent;
        let origin = CubicOrigin {
            join: SMOOTH_BELOW,
            value,
            slope,
            curvature: slope * (exponent - 1.0),
        };
        origin.lift(s)
    });
    T::select_lazily(
        s.below(SMOOTH_BELOW),
        smooth,
        inlined!(|| factor * (exponent * s.ln()).exp()),
    )
}

/// C_L = c₀ + c₁ s + c₂ s² …, replaced by a [`CubicOrigin`] for s < `join`, because the polynomial
/// gives lift without spin.
#[inline(always)]
pub(super) fn polynomial<T: Numbers, const N: usize>(c: [T; N], join: f64, s: T) -> T {
    let smooth = inlined!(|| {
        let mut origin = CubicOrigin {
            join,
            value: c[0],
            slope: T::zero(),
            curvature: T::zero(),
        };
        let (mut k, mut power) = (1, join);
        while k < N {
            let (term, of) = (c[k] * power, k as f64);
            origin.value = origin.value + term;
            origin.slope = origin.slope + term * of;
            origin.curvature = origin.curvature + term * (of * (of - 1.0));
            (k, power) = (k + 1, power * join);
        }
        origin.lift(s)
    });
    T::select_lazily(s.below(join), smooth, inlined!(|| horner(c, s)))
}

/// c₀ + c₁ s + c₂ s² ….
#[inline(always)]
pub(super) fn horner<T: Numbers, const N: usize>(c: [T; N], s: T) -> T {
    let (mut k, mut sum) = (N - 1, c[N - 1]);
    while k > 0 {
        k -= 1;
        sum = sum.mul_add(s, c[k]);
    }
    sum
}
