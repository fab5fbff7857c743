use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, RangeEnd, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above};
use crate::parameters::{LawVariable, Lyu};

/// Spin ratios of the measurements.
const MEASURED: [f64; 2] = [0.045, 0.32];
/// Width of the upper clamp of the spin ratio. Without the clamp, the lift would be negative above
/// s = 0.61.
const UPPER_CLAMP_WIDTH: f64 = 0.04;

/// Centre of the transition between the two parabolas of the drag, in Re/10⁵. Both parabolas are
/// valid for 0.75 < Re/10⁵ < 1, where they differ by at most 0.02.
const BETWEEN: f64 = 0.875;
/// Width of the transition, in Re/10⁵: a quarter of the interval in which both parabolas are valid.
const WIDTH: f64 = 0.06;

/// With r = Re/10⁵ and σ = (1 + tanh((r − 0.875)/0.06))/2: C_D = (1 − σ)(cd_low0 + cd_low1 r +
/// cd_low2 r²) + σ (cd_high0 + cd_high1 r + cd_high2 r²), C_L = cl1 s + cl2 s². Lyu, Kensrud, Smith
/// & Tosaya (2018) shot balls through still air. The drag is that of one ball for 5.1e4 < Re < 2e5,
/// independent of the spin. The lift is the mean of 13 balls for 0.045 < s < 0.32.
impl<T: Numbers> AerodynamicLaw<T> for Lyu<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let r = stream.reynolds() * 1e-5;
            let low = self
                .cd_low2
                .mul_add(r, self.cd_low1)
                .mul_add(r, self.cd_low0);
            let high = self
                .cd_high2
                .mul_add(r, self.cd_high1)
                .mul_add(r, self.cd_high0);
            let part = ((r - BETWEEN) * (1.0 / WIDTH)).tanh() * 0.5 + 0.5;
            let s = smooth_clamp_above(stream.spin_ratio(), MEASURED[1], UPPER_CLAMP_WIDTH);
            Coefficients {
                drag: part.mul_add(high - low, low),
                lift: self.cl2.mul_add(s, self.cl1) * s,
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Lyu, Kensrud, Smith & Tosaya",
                year: Some(2018),
                ball: Some("lift: mean of 13 balls; drag: one of them (KK)"),
                source: "Proceedings 2(6), 238; transcribed by others, docs/sources.md",
            },
            fitted: Fitted {
                spin_ratio: Some(MEASURED),
                reynolds: Some([5.1e4, 2e5]),
                to: "balls shot through still air, Lyu, Kensrud, Smith & Tosaya 2018",
                held: &[(LawVariable::SpinRatio, RangeEnd::High)],
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: false,
        }
    }
}
