//! eˣ and eˣ − 1 without branches or calls, so that they stay in vector registers. Error below 2
//! ulp, measured against exact values.

use crate::number::{Numbers, inlined};

/// 1.5·2⁵². If x is added to this number, the low bits of the mantissa of the sum are x, rounded to
/// an integer.
pub(super) const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Leading digits of ln 2. There are so few digits that [`reduced`] multiplies them by k without
/// rounding (Cody & Waite 1980).
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
/// Remaining digits of ln 2.
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// Smallest x. A smaller x is clamped, because eˣ is then 0 for practical purposes.
const LEAST: f64 = -708.0;
/// Largest x. A larger x is clamped, because eˣ is then ∞ for practical purposes.
const GREATEST: f64 = 709.0;

/// Taylor coefficients 1/n!.
pub(super) const TAYLOR: [f64; 18] = {
    let (mut inverse, mut factorial, mut n) = ([1.0; 18], 1.0, 1);
    while n < inverse.len() {
        factorial *= n as f64;
        inverse[n] = 1.0 / factorial;
        n += 1;
    }
    inverse
};

/// Operations that the exponential needs in addition to those of [`Numbers`].
pub(super) trait Powers: Numbers {
    /// 2ᵏ for an integer k from −1022 to 1023. `rounded` is k + [`ROUNDER`].
    fn two_to(rounded: Self) -> Self;
    /// x clamped to an interval.
    fn clamped(self, low: f64, high: f64) -> Self;
}

/// Argument reduction x = k ln 2 + r, |r| ≤ ½ ln 2: returns 2ᵏ and eʳ − 1 by Taylor's polynomial of
/// degree 13.
#[inline(always)]
fn reduced<V: Powers>(x: V) -> (V, V) {
    let x = x.clamped(LEAST, GREATEST);
    let rounded = x.scale_add(std::f64::consts::LOG2_E, V::constant(ROUNDER));
    let k = rounded - ROUNDER;
    let r = k.scale_add(-LN_2_LOW, k.scale_add(-LN_2_HIGH, x));
    let r2 = r * r;
    let pair = inlined!(|n: usize| r.scale_add(TAYLOR[n + 1], V::constant(TAYLOR[n])));
    let r4 = r2 * r2;
    let low = pair(4).mul_add(r2, pair(2));
    let middle = pair(8).mul_add(r2, pair(6));
    let high = pair(12).mul_add(r2, pair(10));
    let tail = high.mul_add(r4, middle).mul_add(r4, low);
    (V::two_to(rounded), tail.mul_add(r2, r))
}

/// Exponential eˣ.
#[inline(always)]
pub(super) fn exp<V: Powers>(x: V) -> V {
    let (power, grown) = reduced(x);
    grown.mul_add(power, power)
}

/// Exponential eˣ − 1.
#[inline(always)]
pub(super) fn exp_m1<V: Powers>(x: V) -> V {
    let (power, grown) = reduced(x);
    grown.mul_add(power, power - 1.0)
}
