use super::exponential::{Powers, TAYLOR};
use crate::number::{Mask, inlined};

/// Largest x² at which Taylor's polynomials of degrees 17 (sine) and 16 (cosine) are exact to
/// rounding: x = 46°. The usual angles of drivers and launches are smaller.
const MOST_SQUARED: f64 = 0.64;

/// sin x and cos x: by polynomials if all lanes are within 46°, else by `large`.
#[inline(always)]
pub(super) fn sin_cos<V: Powers>(x: V, large: impl Fn(V) -> (V, V)) -> (V, V) {
    let y = x * x;
    if !y.below(MOST_SQUARED).all() {
        return large(x);
    }
    // Horner's scheme for the sum of (−y)ᵏ⁻¹/(2k + first)! over k from 1 to 8
    let series = inlined!(|first: usize| {
        let mut sum = V::constant(TAYLOR[first + 16]);
        let mut k = 8;
        while k > 1 {
            k -= 1;
            sum = (-y).mul_add(sum, V::constant(TAYLOR[first + 2 * k]));
        }
        sum
    });
    (
        (-(x * y)).mul_add(series(1), x),
        (-y).mul_add(series(0), V::constant(1.0)),
    )
}
