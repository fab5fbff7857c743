use super::pace::Pace;
use super::surroundings::Spun;
use crate::atmosphere::WindField;
use crate::launch::{LEAST_SPIN, Launch};
use crate::number::{Factor, Mask, Numbers, Vector};
use crate::parameters::{Law, Method, Setup};
use std::f64::consts::PI;

/// All that a flight depends on (docs/model.md, eqs. 12–15): a few quantities, into which whatever made the launch enters
/// only through these. Derivatives of the flight are taken by them and chained with theirs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shot<T> {
    /// Velocity at launch.
    pub velocity: Vector<T>,
    /// |ω₀| = √(ω₀·ω₀ + η²), and ω₀/|ω₀|: the axis, which the spin keeps (and of no length without spin).
    pub spin: T,
    pub axis: Vector<T>,
    /// ρ A/(2 m): deceleration per C_D |v|², 1/m.
    pub force_per_mass: T,
    pub gravity: T,
    pub radius: T,
    pub reynolds_per_speed: T,
    /// δ, and κ/R where spin is damped by the way through the air.
    pub decay: T,
    pub damping: Option<T>,
    pub wind: WindField<T>,
    /// Height of the landing area.
    pub ground: T,
    pub law: Law<T>,
}

impl<T: Numbers> Shot<T> {
    /// Spin ratio, Reynolds number and speed through the air as the ball leaves.
    #[inline(always)]
    pub fn stream(&self) -> [T; 3] {
        let wind = self.wind.at(
            #[inline(always)]
            || T::constant(0.0),
        );
        let speed = (self.velocity - wind).norm();
        [self.spin * self.radius / speed, self.reynolds_per_speed * speed, speed]
    }

    /// The flight of a ball that leaves like this, in the air of a setup.
    #[inline(always)]
    pub fn new(setup: &Setup<T>, launch: &Launch<T>) -> Self {
        let radius = setup.ball.radius;
        let density = setup.air.density;
        let (spin, per_spin) = (launch.spin.dot(launch.spin) + LEAST_SPIN * LEAST_SPIN).sqrt_recip();
        Self {
            velocity: launch.velocity,
            spin,
            axis: launch.spin * per_spin,
            force_per_mass: density * radius * radius * (0.5 * PI) / setup.ball.mass,
            gravity: setup.flight.gravity,
            radius,
            reynolds_per_speed: density * radius * 2.0 / setup.air.viscosity,
            decay: setup.aero.spin_decay,
            damping: setup.aero.spin_damping.map(
                #[inline(always)]
                |damping| damping / radius,
            ),
            wind: WindField::new(&setup.wind, &setup.ground),
            ground: setup.ground.height,
            law: setup.law,
        }
    }

    /// The same over another number: `f` makes it from each quantity, always in the same order.
    #[inline(always)]
    pub fn map<U>(&self, mut f: impl FnMut(T) -> U) -> Shot<U> {
        let f = &mut f;
        Shot {
            velocity: self.velocity.map(&mut *f),
            spin: f(self.spin),
            axis: self.axis.map(&mut *f),
            force_per_mass: f(self.force_per_mass),
            gravity: f(self.gravity),
            radius: f(self.radius),
            reynolds_per_speed: f(self.reynolds_per_speed),
            decay: f(self.decay),
            damping: self.damping.map(&mut *f),
            wind: self.wind.map(f),
            ground: f(self.ground),
            law: self.law.map(&mut |_, value| f(value)),
        }
    }

    /// Whether there is neither wind nor damping of the spin on the way, to the derivatives carried.
    #[inline(always)]
    pub fn is_in_still_air(&self) -> bool {
        self.damping.is_none() && self.wind.is_calm()
    }

    /// Whether the quantities that stay the same in calm air can be of this type: whether it carries derivatives, or they
    /// carry none.
    #[inline(always)]
    pub fn has_constants<C: Factor<T>>(&self) -> bool {
        let mut are_plain = self.force_per_mass.is_constant() & self.gravity.is_constant() & self.decay.is_constant();
        self.law.map(&mut |_, value| are_plain &= value.is_constant());
        C::HAS_DERIVATIVES || are_plain
    }

    /// The law that depends on the spin alone, where it is one, its constants can be of type `C` and the spin fades as slowly
    /// as its steps need.
    #[inline(always)]
    pub(super) fn spun<C: Factor<T>>(&self, pace: &Pace) -> Option<Spun<C, T::Value>> {
        let Law::Robinson(law) = self.law else { return None };
        let faded = law.cl_rate * self.spin * (self.decay * (-0.5 * pace.step)).exp_m1();
        let most = Spun::<C, T::Value>::MOST_FADED;
        let is_slow = faded.below(most).all() && (-faded).below(most).all();
        let fades_well = is_slow || pace.method != Method::Rk4;
        (fades_well && self.has_constants::<C>()).then(|| Spun::new(&law, self.force_per_mass))
    }

    /// Whether nothing about a flight in calm air leaves the vertical plane of the target line, to the derivatives carried.
    #[inline(always)]
    pub fn is_plane(&self) -> bool {
        let Self { velocity, axis, wind, .. } = self;
        velocity.y.is_zero() && axis.x.is_zero() && axis.z.is_zero() && wind.is_calm()
    }
}
