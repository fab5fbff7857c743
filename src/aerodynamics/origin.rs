use crate::number::{Numbers, inlined};

/// A lift coefficient that is replaced near zero spin, where its formula has no lift-free limit or
/// an infinite slope: for s < s₀ it is the cubic C_L = a u + b u² + c u³ in u = s/s₀ that joins the formula at s₀
/// with the same value, slope and curvature. Lift then vanishes with the spin, and C_L is C² throughout.
pub(super) struct CubicOrigin<T> {
    /// s₀: where the formula takes over.
    pub join: f64,
    /// C_L at s₀.
    pub value: T,
    /// s₀ dC_L/ds at s₀.
    pub slope: T,
    /// s₀² d²C_L/ds² at s₀.
    pub curvature: T,
}

impl<T: Numbers> CubicOrigin<T> {
    /// C_L at a spin ratio below the join.
    #[inline(always)]
    pub fn lift(&self, spin_ratio: T) -> T {
        let u = spin_ratio / self.join;
        let rise = self.slope - self.value;
        let c = self.curvature * 0.5 - rise;
        let b = rise - c * 2.0;
        let a = self.value - b - c;
        (a + (b + c * u) * u) * u
    }
}

/// The spin ratio below which a power of it is replaced: its slope grows without end towards 0.
const SMOOTH_BELOW: f64 = 0.001;

/// C_L = factor s^exponent, replaced by the cubic for s < 0.001.
#[inline(always)]
pub(super) fn power<T: Numbers>(factor: T, exponent: T, s: T) -> T {
    let smooth = inlined!(|| {
        let value = factor * (exponent * SMOOTH_BELOW.ln()).exp();
        let slope = value * exponent;
        let origin = CubicOrigin { join: SMOOTH_BELOW, value, slope, curvature: slope * (exponent - 1.0) };
        origin.lift(s)
    });
    T::choose(s.below(SMOOTH_BELOW), smooth, inlined!(|| factor * (exponent * s.ln()).exp()))
}
