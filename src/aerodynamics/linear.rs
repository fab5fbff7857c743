use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::Linear;

/// C_D = cd, C_L = cl_slope s.
impl<T: Numbers> AerodynamicLaw<T> for Linear<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        Coefficients {
            drag: self.cd,
            lift: self.cl_slope * stream.spin_ratio(),
        }
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "longdrive",
                year: None,
                ball: None,
                source: "round figures for teaching, fitted to nothing",
            },
            fitted: Fitted::UNKNOWN,
            continuous_derivatives: None,
            has_corner_at_zero_spin: false,
        }
    }
}
