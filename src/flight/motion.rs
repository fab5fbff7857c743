use super::shot::Shot;
use super::space::Space;
use super::surroundings::{Force, Surroundings};
use crate::aerodynamics::Stream;
use crate::atmosphere::WindField;
use crate::number::{Factor, Numbers, Vector};

/// m/s: keeps |v_r| and its derivatives finite where the ball hangs still in the air.
const LEAST_SPEED: f64 = 1e-6;

/// The equation of motion of one flight (docs/model.md, eqs. 12–15): what stays the same from launch to landing.
#[derive(Clone, Copy)]
pub(super) struct Motion<T: Numbers, S: Space<T>, L: Surroundings<T>> {
    law: L,
    air: Air<T, S>,
    pub gravity: L::Constant,
    radius: T,
    reynolds_per_speed: T,
    pub spin: T,
    axis: S::Axis,
    decay: L::Constant,
    damping: Option<T>,
}

/// How the air moves.
#[derive(Clone, Copy)]
enum Air<T, S> {
    Calm,
    Uniform(S),
    Profile(WindField<T>),
}

/// The spin at one time, with what follows from it alone.
#[derive(Clone, Copy)]
pub(super) struct SpinNow<T: Numbers, S: Space<T>, M> {
    /// |ω|, rad/s.
    size: T,
    forces: Option<Forces<T, S>>,
    /// What is kept of it for a later one.
    pub memory: M,
}

/// ρ A/(2 m) C_L along the axis, and −ρ A/(2 m) C_D.
#[derive(Clone, Copy)]
struct Forces<T: Numbers, S: Space<T>> {
    lift: S::Axis,
    along: T,
}

/// What moves the ball at one instant: the acceleration is |v_r| `pull` − g X. The two factors are kept apart
/// for numbers that wait for the root in |v_r|.
#[derive(Clone, Copy)]
pub(super) struct Rate<T, S> {
    /// |v_r|.
    pub airspeed: T,
    /// ρ A/(2 m) (C_L (ω/|ω|) × v_r − C_D v_r).
    pub pull: S,
    /// Their product, where derivatives have a shorter way to it; asked for its derivatives alone.
    pub push: S,
}

impl<T: Numbers, S: Space<T>, L: Surroundings<T>> Motion<T, S, L> {
    #[inline(always)]
    pub fn new(shot: &Shot<T>, law: L) -> Self {
        let air = match shot.wind.uniform() {
            None => Air::Profile(shot.wind),
            Some(_) if shot.wind.is_calm() => Air::Calm,
            Some(wind) => Air::Uniform(S::of(wind)),
        };
        Self {
            law,
            air,
            gravity: L::Constant::of(shot.gravity),
            radius: shot.radius,
            reynolds_per_speed: shot.reynolds_per_speed,
            spin: shot.spin,
            axis: S::axis(shot.axis),
            decay: L::Constant::of(shot.decay),
            damping: shot.damping,
        }
    }

    /// Whether the spin depends on the way through the air and not on the time alone.
    #[inline(always)]
    pub fn is_damped(&self) -> bool {
        !L::STILL && self.damping.is_some()
    }

    /// exp(−δ t): what is left of a spin after a time, apart from damping.
    #[inline(always)]
    pub fn fading(&self, time: f64) -> L::Constant {
        (self.decay * -time).exp()
    }

    /// The spin, with what follows from it, where it would be `faded` but for the way through the air so far:
    /// ω = ω₀ exp(−δ t − κ ℓ/R).
    #[inline(always)]
    pub fn spin(&self, faded: T, air_path: impl FnOnce() -> T) -> SpinNow<T, S, L::Memory> {
        let size = self.undamped(faded, air_path);
        self.with_force(size, self.law.force_by_spin(size))
    }

    /// The same, half a step after it was `before`, of which something has been kept.
    #[inline(always)]
    pub fn later_spin(
        &self,
        faded: T,
        (before, memory): (T, L::Memory),
        air_path: impl FnOnce() -> T,
    ) -> SpinNow<T, S, L::Memory> {
        let size = self.undamped(faded, air_path);
        self.with_force(size, self.law.force_later(size, before, memory))
    }

    #[inline(always)]
    fn with_force(&self, size: T, (force, memory): (Option<Force<T>>, L::Memory)) -> SpinNow<T, S, L::Memory> {
        let forces = force.map(
            #[inline(always)]
            |force| self.forces(force),
        );
        SpinNow { size, forces, memory }
    }

    #[inline(always)]
    fn undamped(&self, faded: T, air_path: impl FnOnce() -> T) -> T {
        match self.damping {
            _ if L::STILL => faded,
            None => faded,
            Some(damping) => {
                let path = air_path();
                T::outlined(
                    #[inline(always)]
                    || faded * (-(damping * path)).exp(),
                )
            }
        }
    }

    #[inline(always)]
    fn forces(&self, force: Force<T>) -> Forces<T, S> {
        Forces { lift: S::longer(self.axis, force.lift), along: force.along }
    }

    /// What moves the ball; `height` is asked only where the wind depends on it.
    #[inline(always)]
    pub fn rate(&self, spin: &SpinNow<T, S, L::Memory>, velocity: S, height: impl FnOnce() -> T) -> Rate<T, S> {
        let relative = match &self.air {
            _ if L::STILL => velocity,
            Air::Calm => velocity,
            Air::Uniform(wind) => velocity - *wind,
            Air::Profile(field) => velocity - S::of(field.at(height)),
        };
        let square = relative.square_plus(LEAST_SPEED * LEAST_SPEED);
        let (airspeed, inverse) = square.sqrt_recip();
        let forces = match spin.forces {
            Some(forces) => forces,
            None => {
                let stream = Stream {
                    spin: spin.size,
                    radius_per_speed: self.radius * inverse,
                    speed: airspeed,
                    reynolds_per_speed: self.reynolds_per_speed,
                };
                self.forces(self.law.force(&stream))
            }
        };
        let Forces { lift, along } = forces;
        Rate {
            airspeed,
            pull: relative.turned_and_pushed(lift, along),
            push: relative.turned_and_pushed_by_size(lift, along, airspeed, inverse),
        }
    }

    /// dv/dt.
    #[inline(always)]
    pub fn acceleration(&self, rate: &Rate<T, S>) -> S {
        let weight = S::of(Vector::zero()).raised(-self.gravity);
        let value = rate.pull.times_plus(rate.airspeed, weight);
        value.with_derivatives_of(rate.push.raised(-self.gravity))
    }

    /// A velocity, after as long a time at this rate.
    #[inline(always)]
    pub fn after(&self, rate: &Rate<T, S>, time: f64, velocity: S) -> S {
        if T::IS_LONE {
            // the root in |v_r| comes last: all else is ready when it is
            let value = rate.pull.scaled(time).times_plus(rate.airspeed, velocity.raised(self.gravity * -time));
            value.with_derivatives_of(self.acceleration(rate).along(time, velocity))
        } else {
            self.acceleration(rate).along(time, velocity)
        }
    }
}
