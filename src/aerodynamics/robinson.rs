use super::{AerodynamicLaw, Coefficients, Stream};
use crate::number::{Factor, Numbers};
use crate::parameters::Robinson;

/// C_D = cd0 + cd1 |ω|, C_L = cl_max (1 − exp(−cl_rate |ω|)): Robinson & Robinson (2013) as the MAE 494
/// report uses it. C_D grows with |ω| on both sides of zero spin, so carry has a corner there.
impl<T: Numbers, C: Factor<T>> AerodynamicLaw<T> for Robinson<C> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        let spin = stream.spin;
        let missing = (-self.cl_rate).times(spin).exp_m1();
        Coefficients { drag: self.cd1.times_plus(spin, self.cd0.plus(T::zero())), lift: (-self.cl_max).times(missing) }
    }

    #[inline(always)]
    fn by_spin_alone(&self, spin: T) -> Option<Coefficients<T>> {
        let unused = T::zero();
        Some(self.coefficients(&Stream { spin, radius_per_speed: unused, speed: unused, reynolds_per_speed: unused }))
    }
}
