use super::origin::polynomial;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above, smooth_clamp_below};
use crate::parameters::UsgaItr;

/// Lowest spin ratio of the measured shots. Below this spin ratio a cubic replaces the lift
/// coefficient, because the formula gives lift without spin.
const SMOOTH_BELOW: f64 = 0.042;
/// Start of the upper clamp of the spin ratio. The clamp bounds the term in s² of the drag. The
/// formula is valid for s < 0.3.
const UPPER_CLAMP_START: f64 = 0.3;
/// Width of the upper clamp of the spin ratio.
const UPPER_CLAMP_WIDTH: f64 = 0.1;
/// Start of the lower clamp of r = Re/10⁵. At lower r the term in 1/r² would make the lift
/// negative. The slowest measured shots have r = 0.8.
const LOWER_CLAMP_START: f64 = 0.6;
/// Width of the lower clamp of Re/10⁵.
const LOWER_CLAMP_WIDTH: f64 = 0.2;

/// With r = Re/10⁵: C_D = cd0 + cd1 s + cd2 s² + cd_re r, C_L = cl0 + cl1 s + cl2 s² + cl_re/r².
/// The USGA fits this form to the shots of a ball in its Indoor Test Range. The coefficients are
/// for the test ball of US patent 6186002.
impl<T: Numbers> AerodynamicLaw<T> for UsgaItr<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let s = smooth_clamp_above(stream.spin_ratio(), UPPER_CLAMP_START, UPPER_CLAMP_WIDTH);
            let r = smooth_clamp_below(
                stream.reynolds() * 1e-5,
                LOWER_CLAMP_START,
                LOWER_CLAMP_WIDTH,
            );
            let drag = self
                .cd2
                .mul_add(s, self.cd1)
                .mul_add(s, self.cd_re.mul_add(r, self.cd0));
            let without_spin = self.cl_re.mul_add((r * r).recip(), self.cl0);
            Coefficients {
                drag,
                lift: polynomial([without_spin, self.cl1, self.cl2], SMOOTH_BELOW, s),
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "USGA, Indoor Test Range",
                year: Some(2001),
                ball: Some("the test ball of the patent"),
                source: "US patent 6186002; fit to its table as transcribed by others, docs/sources.md",
            },
            fitted: Fitted {
                spin_ratio: Some([0.042, 0.22]),
                reynolds: Some([8e4, 2e5]),
                to: "42 shots in the USGA's Indoor Test Range",
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: true,
        }
    }
}
