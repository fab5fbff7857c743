use crate::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use crate::number::{Factor, Numbers, inlined};
use crate::parameters::{Law, Robinson};

/// What the air does to a ball in flight: a law of drag and lift, with what is known beforehand about the air it holds in.
pub(super) trait Surroundings<T: Numbers>: Copy {
    /// Whether there is neither wind nor damping of the spin on the way: then no stage asks.
    const STILL: bool;
    /// What the constants of the flight are kept in.
    type Constant: Factor<T>;
    /// What is kept of one spin to be quicker about a later one.
    type Memory: Copy;

    /// What the air does in a stream.
    fn force(&self, stream: &Stream<T>) -> Force<T>;
    /// What it does at a spin, where it depends on the spin alone.
    fn force_by_spin(&self, spin: T) -> (Option<Force<T>>, Self::Memory);
    /// The same at a spin that another, of which something has been kept, has faded to in half a step.
    fn force_later(&self, spin: T, before: T, memory: Self::Memory) -> (Option<Force<T>>, Self::Memory);
}

/// Forces over the ball's mass and the square of its airspeed, 1/m.
#[derive(Clone, Copy)]
pub(super) struct Force<T> {
    /// ρ A/(2 m) C_L.
    pub lift: T,
    /// −ρ A/(2 m) C_D: along the motion.
    pub along: T,
}

/// Whichever law, in whatever air or, known beforehand (`STILL`), in still air.
#[derive(Clone, Copy)]
pub(super) struct AnyLaw<T, const STILL: bool> {
    law: Law<T>,
    /// ρ A/(2 m).
    force_per_mass: T,
}

/// Whichever law in whatever air.
pub(super) type Windy<T> = AnyLaw<T, false>;
/// Whichever law in still air.
pub(super) type Still<T> = AnyLaw<T, true>;

impl<T: Numbers, const STILL: bool> AnyLaw<T, STILL> {
    #[inline(always)]
    pub fn new(law: Law<T>, force_per_mass: T) -> Self {
        Self { law, force_per_mass }
    }

    #[inline(always)]
    fn of(&self, c: Coefficients<T>) -> Force<T> {
        Force { lift: self.force_per_mass * c.lift, along: -(self.force_per_mass * c.drag) }
    }
}

impl<T: Numbers, const STILL: bool> Surroundings<T> for AnyLaw<T, STILL> {
    const STILL: bool = STILL;
    type Constant = T;
    type Memory = ();

    #[inline(always)]
    fn force(&self, stream: &Stream<T>) -> Force<T> {
        self.of(self.law.coefficients(stream))
    }
    #[inline(always)]
    fn force_by_spin(&self, spin: T) -> (Option<Force<T>>, ()) {
        let force = self.law.by_spin_alone(spin).map(
            #[inline(always)]
            |c| self.of(c),
        );
        (force, ())
    }
    #[inline(always)]
    fn force_later(&self, spin: T, _before: T, _memory: ()) -> (Option<Force<T>>, ()) {
        self.force_by_spin(spin)
    }
}

/// The law whose coefficients change with the spin alone, as forces, in still air. The constants are of type `C`: numbers
/// without derivatives, where the flight is not differentiated by one of them.
///
/// What is kept of a spin is its lift: exp(−k ω) changes so little in half a step that a few terms of a series take it from
/// one to the next.
#[derive(Clone, Copy)]
pub(super) struct Spun<C, V> {
    /// The law with its coefficients as forces.
    law: Robinson<C>,
    /// `cl_rate`.
    rate: V,
}

impl<C, V> Spun<C, V> {
    /// The largest −d(k ω) in half a step: the terms of the series left out are then below 1e-17.
    pub const MOST_FADED: f64 = 0.01;

    /// The law times ρ A/(2 m).
    #[inline(always)]
    pub fn new<T: Numbers<Value = V>>(law: &Robinson<T>, force_per_mass: T) -> Self
    where
        C: Factor<T>,
        V: Factor<T>,
    {
        let Robinson { cd0, cd1, cl_max, cl_rate } = *law;
        let force = inlined(
            #[inline(always)]
            |coefficient: T| C::of(coefficient * force_per_mass),
        );
        let law = Robinson { cd0: force(-cd0), cd1: force(-cd1), cl_max: force(cl_max), cl_rate: C::of(cl_rate) };
        Self { law, rate: V::of(cl_rate) }
    }

    /// With the lift still missing, as Robinson's law has it.
    #[inline(always)]
    fn force_without<T: Numbers>(&self, spin: T, missing: T) -> Force<T>
    where
        C: Factor<T>,
    {
        let c = self.law.without(spin, missing);
        Force { lift: c.lift, along: c.drag }
    }
}

impl<T: Numbers, C: Factor<T>> Surroundings<T> for Spun<C, T::Value> {
    const STILL: bool = true;
    type Constant = C;
    /// exp(−k ω) − 1.
    type Memory = T::Value;

    #[inline(always)]
    fn force(&self, stream: &Stream<T>) -> Force<T> {
        self.force_without(stream.spin, self.law.exponent(stream.spin).exp_m1())
    }
    #[inline(always)]
    fn force_by_spin(&self, spin: T) -> (Option<Force<T>>, T::Value) {
        let missing = self.law.exponent(spin).exp_m1();
        (Some(self.force_without(spin, missing)), T::Value::of(missing))
    }
    #[inline(always)]
    fn force_later(&self, spin: T, before: T, memory: T::Value) -> (Option<Force<T>>, T::Value) {
        // eᵈ − 1 by its series up to d⁶
        let d = self.rate * (T::Value::of(before) - T::Value::of(spin));
        let growth = d.scale_add(1.0 / 720.0, T::Value::constant(1.0 / 120.0));
        let growth = growth.mul_add(d, T::Value::constant(1.0 / 24.0)).mul_add(d, T::Value::constant(1.0 / 6.0));
        let growth = growth.mul_add(d, T::Value::constant(0.5));
        let growth = growth.mul_add(d * d, d);
        let memory = (memory + 1.0).mul_add(growth, memory);
        (Some(self.force_without(spin, self.law.exponent(spin).known_exp_m1(memory))), memory)
    }
}
