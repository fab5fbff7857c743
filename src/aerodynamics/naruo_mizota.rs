use super::origin::{horner, polynomial};
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, RangeEnd, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above};
use crate::parameters::{LawVariable, NaruoMizota};

/// Spin ratios of the measurements. Below this range a cubic replaces the lift coefficient, because
/// the formula gives lift without spin.
const MEASURED: [f64; 2] = [0.03, 1.13];
/// Width of the upper clamp of the spin ratio. The clamp bounds the terms in s⁴.
const UPPER_CLAMP_WIDTH: f64 = 0.2;

/// C_D = cd0 + cd1 s + … + cd4 s⁴, C_L = cl0 + cl1 s + … + cl4 s⁴: Naruo, Mizota & Shimozono
/// (2004), wind tunnel, for 0.03 < s < 1.13 and Re > 7.1e4.
impl<T: Numbers> AerodynamicLaw<T> for NaruoMizota<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let [low, high] = MEASURED;
            let s = smooth_clamp_above(stream.spin_ratio(), high, UPPER_CLAMP_WIDTH);
            let drag = [self.cd0, self.cd1, self.cd2, self.cd3, self.cd4];
            let lift = [self.cl0, self.cl1, self.cl2, self.cl3, self.cl4];
            Coefficients {
                drag: horner(drag, s),
                lift: polynomial(lift, low, s),
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Naruo, Mizota & Shimozono",
                year: Some(2004),
                ball: Some("Bridgestone Skyway SD432"),
                source: "wind tunnel; the polynomials are transcribed by others, docs/sources.md",
            },
            fitted: Fitted {
                spin_ratio: Some(MEASURED),
                reynolds: Some([7.1e4, f64::INFINITY]),
                to: "a wind tunnel, Naruo, Mizota & Shimozono 2004",
                held: &[(LawVariable::SpinRatio, RangeEnd::High)],
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: true,
        }
    }
}
