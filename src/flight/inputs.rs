use crate::atmosphere::{AirState, WindField};
use crate::ground::Turf;
use crate::launch::{LEAST_SPIN, Launch};
use crate::number::{Numbers, Vector, inlined};
use crate::parameters::{Law, Method, Setup};
use std::f64::consts::PI;

/// All that a flight depends on (docs/model.md, eqs. 12–15): a few quantities, into which whatever
/// made the launch enters only through these.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs<T> {
    /// Velocity at launch, m/s.
    pub velocity: Vector<T>,
    /// |ω₀| = √(ω₀·ω₀ + η²), rad/s.
    pub spin: T,
    /// ω₀/|ω₀|: the axis, which the spin keeps (and of no length without spin).
    pub axis: Vector<T>,
    /// ρ A/(2 m): deceleration per C_D |v|², 1/m.
    pub force_per_mass: T,
    /// g, m/s².
    pub gravity: T,
    /// R, m.
    pub radius: T,
    /// Re/|v|, s/m.
    pub reynolds_per_speed: T,
    /// δ, 1/s.
    pub decay: T,
    /// κ/R, 1/m, where spin is damped by the way through the air.
    pub damping: Option<T>,
    /// How the air moves.
    pub wind: WindField<T>,
    /// Height of the landing area, m.
    pub ground: T,
    /// Drag and lift.
    pub law: Law<T>,
    /// What the ball lands on, where its run is asked for.
    pub turf: Option<Turf<T>>,
    /// How the equation of motion is integrated.
    pub method: Method,
    /// h, s.
    pub step: f64,
    /// s.
    pub time_limit: f64,
}

impl<T: Numbers> Inputs<T> {
    /// What the flight of a ball depends on that leaves like this, in the air of a setup, and where
    /// it `runs` what its run does. Not inlined: there is one compiled copy for each number type.
    #[inline(always)]
    pub fn new(setup: &Setup<T>, launch: &Launch<T>, runs: bool) -> Self {
        T::outlined(inlined!(|| {
            let radius = setup.ball.radius;
            let AirState { density, viscosity } = AirState::of(&setup.air);
            let (spin, per_spin) =
                (launch.spin.dot(launch.spin) + LEAST_SPIN * LEAST_SPIN).sqrt_recip();
            Self {
                velocity: launch.velocity,
                spin,
                axis: launch.spin * per_spin,
                force_per_mass: density * radius * radius * (0.5 * PI) / setup.ball.mass,
                gravity: setup.flight.gravity,
                radius,
                reynolds_per_speed: density * radius * 2.0 / viscosity,
                decay: setup.aero.spin_decay,
                damping: setup
                    .aero
                    .spin_damping
                    .map(inlined!(|damping| damping / radius)),
                wind: WindField::new(&setup.wind, &setup.ground),
                ground: setup.ground.height,
                law: setup.law,
                turf: runs.then(inlined!(|| Turf::new(setup))),
                method: setup.method,
                step: setup.flight.step,
                time_limit: setup.flight.time_limit,
            }
        }))
    }

    /// Spin ratio, spin, Reynolds number and speed through the air as the ball leaves.
    #[inline(always)]
    pub fn stream(&self) -> [T; 4] {
        let speed = (self.velocity - self.wind.at(T::zero())).norm();
        [
            self.spin * self.radius / speed,
            self.spin,
            self.reynolds_per_speed * speed,
            speed,
        ]
    }
}
