use crate::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use crate::atmosphere::WindField;
use crate::launch::{LEAST_SPIN, Launch};
use crate::number::{Number, Vector};
use crate::parameters::{Law, Setup};
use std::f64::consts::PI;

/// m/s: keeps |v_r| and its derivatives finite where the ball hangs still in the air.
const LEAST_SPEED: f64 = 1e-6;

/// The equation of motion of one flight (docs/model.md, eqs. 12–15): what stays the same from launch to landing.
pub(super) struct Motion<T> {
    law: Law<T>,
    wind: WindField<T>,
    /// ρ A/(2 m): deceleration per C_D |v|², 1/m.
    force_per_mass: T,
    gravity: T,
    radius: T,
    reynolds_per_speed: T,
    /// |ω₀| = √(ω₀·ω₀ + η²), and ω₀/|ω₀|: the axis, which the spin keeps (and of no length without spin).
    spin: T,
    axis: Vector<T>,
    /// δ, and κ/R where spin is damped by the way through the air.
    decay: T,
    damping: Option<T>,
}

/// The spin at one time, with what follows from it alone.
#[derive(Clone, Copy)]
pub(super) struct SpinNow<T> {
    /// |ω|, rad/s.
    size: T,
    coefficients: Option<Coefficients<T>>,
}

/// What moves the ball at one instant.
#[derive(Clone, Copy)]
pub(super) struct Rate<T> {
    pub acceleration: Vector<T>,
    /// |v_r|.
    pub airspeed: T,
}

impl<T: Number> Motion<T> {
    pub fn new(setup: &Setup<T>, launch: &Launch<T>) -> Self {
        let radius = setup.ball.radius;
        let density = setup.air.density;
        let spin = (launch.spin.dot(launch.spin) + LEAST_SPIN * LEAST_SPIN).sqrt();
        Self {
            law: setup.law,
            wind: WindField::new(&setup.wind, &setup.ground),
            force_per_mass: density * radius * radius * (0.5 * PI) / setup.ball.mass,
            gravity: setup.flight.gravity,
            radius,
            reynolds_per_speed: density * radius * 2.0 / setup.air.viscosity,
            spin,
            axis: launch.spin * spin.recip(),
            decay: setup.aero.spin_decay,
            damping: setup.aero.spin_damping.map(|damping| damping / radius),
        }
    }

    /// Whether the spin depends on the way through the air and not on the time alone.
    #[inline]
    pub fn is_damped(&self) -> bool {
        self.damping.is_some()
    }

    /// The spin after `time` and a way `air_path` through the air: ω = ω₀ exp(−δ t − κ ℓ/R).
    #[inline]
    pub fn spin_at(&self, time: f64, air_path: T) -> SpinNow<T> {
        let mut exponent = self.decay * -time;
        if let Some(damping) = self.damping {
            exponent = exponent - damping * air_path;
        }
        let size = self.spin * exponent.exp();
        SpinNow { size, coefficients: self.law.by_spin_alone(size) }
    }

    /// dv/dt = k |v_r| (C_L (ω/|ω|) × v_r − C_D v_r) − g I with k = ρ A/(2 m); `height` is asked
    /// only where the wind depends on it.
    #[inline]
    pub fn rate(&self, spin: &SpinNow<T>, velocity: Vector<T>, height: impl FnOnce() -> T) -> Rate<T> {
        let relative = velocity - self.wind.at(height);
        let airspeed = (relative.dot(relative) + LEAST_SPEED * LEAST_SPEED).sqrt();
        let coefficients = spin.coefficients.unwrap_or_else(|| {
            self.law.coefficients(&Stream {
                spin: spin.size,
                radius_per_speed: self.radius / airspeed,
                speed: airspeed,
                reynolds_per_speed: self.reynolds_per_speed,
            })
        });
        let pressure = self.force_per_mass * airspeed;
        let lift = self.axis.cross(relative) * (pressure * coefficients.lift);
        let mut acceleration = lift - relative * (pressure * coefficients.drag);
        acceleration.x = acceleration.x - self.gravity;
        Rate { acceleration, airspeed }
    }
}
