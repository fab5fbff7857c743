use super::{AerodynamicLaw, Coefficients, Stream};
use crate::number::Number;
use crate::parameters::Robinson;

/// C_D = cd0 + cd1 |ω|, C_L = cl_max (1 − exp(−cl_rate |ω|)): Robinson & Robinson (2013) as the MAE 494
/// report uses it. C_D grows with |ω| on both sides of zero spin, so carry has a corner there.
impl<T: Number> AerodynamicLaw<T> for Robinson<T> {
    #[inline]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        let spin = stream.spin;
        let exponent = -(self.cl_rate * spin);
        // eˣ − 1 keeps its digits near 0 and costs twice as much
        let missing = if exponent.re() > -1e-3 { exponent.exp_m1() } else { exponent.exp() - 1.0 };
        Coefficients { drag: self.cd0 + self.cd1 * spin, lift: -(self.cl_max * missing) }
    }

    #[inline]
    fn by_spin_alone(&self, spin: T) -> Option<Coefficients<T>> {
        let unused = T::zero();
        Some(self.coefficients(&Stream { spin, radius_per_speed: unused, speed: unused, reynolds_per_speed: unused }))
    }
}
