use super::origin::power;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::SmitsSmith;
use std::f64::consts::PI;

/// C_D = cd1 + cd2 s + cd3 sin(π (Re − re1)/re2), C_L = cl1 s^cl_exp: Smits & Smith (1994), fitted
/// for 7e4 < Re < 2.1e5 and 0.08 < s < 0.2.
impl<T: Numbers> AerodynamicLaw<T> for SmitsSmith<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        let s = stream.spin_ratio();
        let phase = (stream.reynolds() - self.re1) * PI / self.re2;
        let drag = self.cd1 + self.cd2 * s + self.cd3 * phase.sin();
        Coefficients {
            drag,
            lift: power(self.cl1, self.cl_exp, s),
        }
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Smits & Smith",
                year: Some(1994),
                ball: None,
                source: "wind tunnel; docs/sources.md",
            },
            fitted: Fitted {
                spin_ratio: Some([0.08, 0.2]),
                reynolds: Some([7e4, 2.1e5]),
                to: "a wind tunnel, Smits & Smith 1994",
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: true,
        }
    }
}
