use crate::aerodynamics::Stream;
use crate::atmosphere::{AirState, WindField};
use crate::ground::Turf;
use crate::launch::{LEAST_SPIN, Launch};
use crate::number::{Numbers, Vector, inlined};
use crate::parameters::{Law, Method, Setup};
use std::f64::consts::PI;

/// Everything that a flight depends on (docs/model.md, eqs. 12–15). The impact affects the flight
/// only through velocity, spin and spin axis at launch. `L` is the law of drag and lift.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs<T, L = Law<T>> {
    /// Velocity at launch, m/s.
    pub velocity: Vector<T>,
    /// Spin at launch |ω₀| = √(ω₀·ω₀ + η²), rad/s, with η = [`LEAST_SPIN`].
    pub spin: T,
    /// Spin axis ω₀/|ω₀|, constant during the flight. As the spin tends to 0, the length of this
    /// vector tends to 0.
    pub axis: Vector<T>,
    /// ρ A/(2 m), 1/m. The deceleration by drag is this factor times C_D |v_r|².
    pub force_per_mass: T,
    /// Acceleration of gravity g, m/s².
    pub gravity: T,
    /// Radius R of the ball, m.
    pub radius: T,
    /// Reynolds number per airspeed, Re/|v_r|, s/m.
    pub reynolds_per_speed: T,
    /// δ, 1/s: decay rate of the spin with time.
    pub decay: T,
    /// κ/R, 1/m: decay rate of the spin with the distance travelled through the air; `None` without
    /// damping.
    pub damping: Option<T>,
    /// Velocity of the air.
    pub wind: WindField<T>,
    /// Height of the landing area above the tee, m.
    pub ground: T,
    /// Law of drag and lift.
    pub law: L,
    /// Turf of the landing area.
    pub turf: Turf<T>,
    /// Runge–Kutta method.
    pub method: Method,
    /// Step h, s.
    pub step: f64,
    /// Longest flight time, s.
    pub time_limit: f64,
}

impl<T: Numbers> Inputs<T> {
    /// The inputs of a flight with this launch, and with air, ball, law, ground and step of the
    /// setup.
    #[inline(always)]
    pub fn new(setup: &Setup<T>, launch: &Launch<T>) -> Self {
        T::not_inlined(inlined!(|| {
            let radius = setup.ball.radius;
            let air = AirState::of(&setup.air);
            let (spin, per_spin) =
                (launch.spin.dot(launch.spin) + LEAST_SPIN * LEAST_SPIN).sqrt_recip();
            Self {
                velocity: launch.velocity,
                spin,
                axis: launch.spin * per_spin,
                force_per_mass: air.density * radius * radius * (0.5 * PI) / setup.ball.mass,
                gravity: setup.flight.gravity,
                radius,
                reynolds_per_speed: air.reynolds_per_speed(radius),
                decay: setup.aero.spin_decay,
                damping: setup
                    .aero
                    .spin_damping
                    .map(inlined!(|damping| damping / radius)),
                wind: WindField::new(&setup.wind, &setup.ground),
                ground: setup.ground.height,
                law: setup.law,
                turf: Turf::new(setup),
                method: setup.method,
                step: setup.flight.step,
                time_limit: setup.flight.time_limit,
            }
        }))
    }

    /// These inputs with another law of drag and lift.
    pub fn with_law<L>(self, law: L) -> Inputs<T, L> {
        Inputs {
            velocity: self.velocity,
            spin: self.spin,
            axis: self.axis,
            force_per_mass: self.force_per_mass,
            gravity: self.gravity,
            radius: self.radius,
            reynolds_per_speed: self.reynolds_per_speed,
            decay: self.decay,
            damping: self.damping,
            wind: self.wind,
            ground: self.ground,
            law,
            turf: self.turf,
            method: self.method,
            step: self.step,
            time_limit: self.time_limit,
        }
    }

    /// Flow of the air past the ball at launch.
    #[inline(always)]
    pub fn launch_stream(&self) -> Stream<T> {
        let speed = (self.velocity - self.wind.at(T::zero())).norm();
        Stream::new(self.spin, speed, self.radius, self.reynolds_per_speed)
    }
}
