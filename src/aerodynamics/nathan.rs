use super::origin::power;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above, smooth_clamp_below};
use crate::parameters::Nathan;

/// Interval of Re/10⁵ in which the drag coefficient without spin falls from cd_low to cd_high.
const FALLS: [f64; 2] = [0.5, 1.0];
/// Width of the rounded corners at both ends of `FALLS`, in Re/10⁵.
const ROUNDED: f64 = 0.05;

/// With r = Re/10⁵, C_D = cd_s s + c, where c is cd_low for r < 0.5, cd_high for r > 1, and linear
/// between. The corners of c are rounded over 0.05 in r. C_L = cl_amp s^cl_exp. The law is that of
/// Nathan's golf trajectory calculator, fitted to the averages of seven clubs.
impl<T: Numbers> AerodynamicLaw<T> for Nathan<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let [low, high] = FALLS;
            let half = 0.5 * ROUNDED;
            let r = smooth_clamp_above(
                smooth_clamp_below(stream.reynolds() * 1e-5, low + half, ROUNDED),
                high - half,
                ROUNDED,
            );
            let fallen = (r - low) * (1.0 / (high - low));
            let without_spin = fallen.mul_add(self.cd_high - self.cd_low, self.cd_low);
            let s = stream.spin_ratio();
            Coefficients {
                drag: self.cd_s.mul_add(s, without_spin),
                lift: power(self.cl_amp, self.cl_exp, s),
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Nathan",
                year: Some(2023),
                ball: Some("an average of several"),
                source: "TrajectoryCalculatorGolf-v2, a worksheet; transcribed by others, \
                         docs/sources.md",
            },
            // spin ratios of the seven clubs at launch
            fitted: Fitted {
                spin_ratio: Some([0.07, 0.2]),
                to: "the averages of seven clubs, driver to 5-iron",
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: true,
        }
    }
}
