use crate::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use crate::number::Numbers;
use crate::parameters::Law;

/// A law of drag and lift, with what is known beforehand about the air it holds in.
pub(super) trait Surroundings<T: Numbers>: AerodynamicLaw<T> + Copy {
    /// Whether there is neither wind nor damping of the spin on the way: then no stage asks.
    const STILL: bool;
}

/// Whatever the law, whatever the air.
impl<T: Numbers> Surroundings<T> for Law<T> {
    const STILL: bool = false;
}

/// A law in still air.
#[derive(Clone, Copy)]
pub(super) struct Still<L>(pub L);

impl<T: Numbers, L: AerodynamicLaw<T>> AerodynamicLaw<T> for Still<L> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        self.0.coefficients(stream)
    }

    #[inline(always)]
    fn by_spin_alone(&self, spin: T) -> Option<Coefficients<T>> {
        self.0.by_spin_alone(spin)
    }
}

impl<T: Numbers, L: AerodynamicLaw<T> + Copy> Surroundings<T> for Still<L> {
    const STILL: bool = true;
}
