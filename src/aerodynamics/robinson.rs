use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::Robinson;

/// C_D = cd0 + cd1 |ω|, C_L = cl_max (1 − exp(−cl_rate |ω|)): Robinson & Robinson (2013) as the MAE
/// 494 report uses it. C_D grows with |ω| on both sides of zero spin, so carry has a corner there.
impl<T: Numbers> AerodynamicLaw<T> for Robinson<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        let missing = (-(self.cl_rate * stream.spin)).exp_m1();
        Coefficients {
            drag: self.cd1.mul_add(stream.spin, self.cd0),
            lift: -(self.cl_max * missing),
        }
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Robinson & Robinson",
                year: Some(2013),
                ball: None,
                source: "as the student report MAE 494 uses it",
            },
            fitted: Fitted::UNKNOWN,
            continuous_derivatives: None,
            has_corner_at_zero_spin: true,
        }
    }
}
