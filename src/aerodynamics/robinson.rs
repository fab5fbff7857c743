use super::{AerodynamicLaw, Coefficients, Stream};
use crate::number::{Factor, Numbers};
use crate::parameters::Robinson;

/// C_D = cd0 + cd1 |ω|, C_L = cl_max (1 − exp(−cl_rate |ω|)): Robinson & Robinson (2013) as the MAE 494
/// report uses it. C_D grows with |ω| on both sides of zero spin, so carry has a corner there.
impl<T: Numbers> AerodynamicLaw<T> for Robinson<T> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        self.without(stream.spin, self.exponent(stream.spin).exp_m1())
    }

    #[inline(always)]
    fn by_spin_alone(&self, spin: T) -> Option<Coefficients<T>> {
        Some(self.without(spin, self.exponent(spin).exp_m1()))
    }
}

impl<C> Robinson<C> {
    /// −cl_rate |ω|.
    #[inline(always)]
    pub(crate) fn exponent<T: Numbers>(&self, spin: T) -> T
    where
        C: Factor<T>,
    {
        (-self.cl_rate).times(spin)
    }

    /// The coefficients where exp(−cl_rate |ω|) − 1, what is missing of the lift, is known.
    #[inline(always)]
    pub(crate) fn without<T: Numbers>(&self, spin: T, missing: T) -> Coefficients<T>
    where
        C: Factor<T>,
    {
        Coefficients { drag: self.cd1.times_plus(spin, self.cd0.plus(T::zero())), lift: (-self.cl_max).times(missing) }
    }
}
