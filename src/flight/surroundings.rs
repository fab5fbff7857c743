use crate::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use crate::number::{Factor, Numbers};
use crate::parameters::{Law, Robinson};

/// A law of drag and lift, with what is known beforehand about the air it holds in.
pub(super) trait Surroundings<T: Numbers>: AerodynamicLaw<T> + Copy {
    /// Whether there is neither wind nor damping of the spin on the way: then no stage asks.
    const STILL: bool;
    /// Whether the coefficients are forces already: C_D and C_L times ρ A/(2 m).
    const FORCES: bool = false;
    /// What the constants of the flight are kept in.
    type Constant: Factor<T>;
}

/// Whatever the law, whatever the air.
impl<T: Numbers> Surroundings<T> for Law<T> {
    const STILL: bool = false;
    type Constant = T;
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
    type Constant = T;
}

/// The law whose coefficients change with the spin alone, as forces, in still air. The constants are of type `C`: numbers
/// without derivatives, where the flight is not differentiated by one of them.
#[derive(Clone, Copy)]
pub(super) struct Spun<C>(Robinson<C>);

impl<C> Spun<C> {
    /// The law times ρ A/(2 m).
    #[inline(always)]
    pub fn new<T: Numbers>(law: &Robinson<T>, force_per_mass: T) -> Self
    where
        C: Factor<T>,
    {
        let Robinson { cd0, cd1, cl_max, cl_rate } = *law;
        let force = crate::number::inlined(
            #[inline(always)]
            |coefficient: T| C::of(coefficient * force_per_mass),
        );
        Self(Robinson { cd0: force(cd0), cd1: force(cd1), cl_max: force(cl_max), cl_rate: C::of(cl_rate) })
    }
}

impl<T: Numbers, C: Factor<T>> AerodynamicLaw<T> for Spun<C> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        self.0.coefficients(stream)
    }

    #[inline(always)]
    fn by_spin_alone(&self, spin: T) -> Option<Coefficients<T>> {
        self.0.by_spin_alone(spin)
    }
}

impl<T: Numbers, C: Factor<T>> Surroundings<T> for Spun<C> {
    const STILL: bool = true;
    const FORCES: bool = true;
    type Constant = C;
}
