use super::{AerodynamicLaw, Coefficients, Published, Stream};
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

    fn has_corner_at_zero_spin(&self) -> bool {
        false
    }

    fn published(&self) -> Published {
        Published {
            authors: "longdrive",
            year: None,
            ball: None,
            source: "round figures for teaching, fitted to nothing",
        }
    }
}
