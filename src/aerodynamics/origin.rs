//! Lift near zero spin.

use crate::number::{Numbers, inlined};

/// Cubic C_L = a u + b u² + c u³ with u = s/s₀, which replaces the formula of a law for spin ratios
/// s < s₀. It is needed if the formula gives lift, or an infinite slope, at zero spin. The cubic is
/// 0 at zero spin. At s₀ it has the C_L, the slope s₀ dC_L/ds and the curvature s₀² d²C_L/ds² of
/// the formula, so C_L is C².
#[inline(always)]
fn cubic_origin<T: Numbers>(value: T, slope: T, curvature: T, u: T) -> T {
    let rise = slope - value;
    let c = curvature * 0.5 - rise;
    let b = rise - c * 2.0;
    let a = value - b - c;
    (a + (b + c * u) * u) * u
}

/// Spin ratio s₀ below which a [`cubic_origin`] replaces a power law, because the slope of the
/// power law is infinite at zero spin.
const SMOOTH_BELOW: f64 = 0.001;

/// C_L = factor s^exponent, replaced by a [`cubic_origin`] for s < 0.001.
#[inline(always)]
pub(super) fn power<T: Numbers>(factor: T, exponent: T, s: T) -> T {
    let smooth = inlined!(|| {
        let value = factor * (exponent * SMOOTH_BELOW.ln()).exp();
        let slope = value * exponent;
        cubic_origin(value, slope, slope * (exponent - 1.0), s / SMOOTH_BELOW)
    });
    T::select_lazily(
        s.below(SMOOTH_BELOW),
        smooth,
        inlined!(|| factor * (exponent * s.ln()).exp()),
    )
}

/// C_L = c₀ + c₁ s + c₂ s² …, replaced by a [`cubic_origin`] for s < `join`, because the polynomial
/// gives lift without spin.
#[inline(always)]
pub(super) fn polynomial<T: Numbers, const N: usize>(c: [T; N], join: f64, s: T) -> T {
    let smooth = inlined!(|| {
        let (mut value, mut slope, mut curvature) = (c[0], T::zero(), T::zero());
        let (mut k, mut power) = (1, join);
        while k < N {
            let (term, of) = (c[k] * power, k as f64);
            value = value + term;
            slope = slope + term * of;
            curvature = curvature + term * (of * (of - 1.0));
            (k, power) = (k + 1, power * join);
        }
        cubic_origin(value, slope, curvature, s / join)
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
