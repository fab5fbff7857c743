//! The ground of the landing area.

use crate::number::Numbers;
use crate::parameters::Setup;

/// Properties of the ground, and the moment of inertia of the ball.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turf<T> {
    /// e_g: restitution of a slow impact; `None` if the ball embeds.
    pub restitution: Option<T>,
    /// μ_g: coefficient of friction between the ball and the turf.
    pub friction: T,
    /// Compliance θ_g, rad: tilt of the crater after a landing at 18.6 m/s, 44.4° from the
    /// vertical.
    pub compliance: T,
    /// ρ_g: deceleration of a rolling ball on level ground, in units of gravity.
    pub rolling: T,
    /// β_z: slope downrange, rad.
    pub slope: T,
    /// β_y: slope to the right, rad.
    pub side_slope: T,
    /// I_b/(m R²): dimensionless moment of inertia of the ball.
    pub inertia: T,
}

impl<T: Numbers> Turf<T> {
    /// The turf of a setup.
    #[inline(always)]
    pub fn new(setup: &Setup<T>) -> Self {
        let (ground, ball) = (&setup.ground, &setup.ball);
        let inertia = match ball.inertia {
            Some(inertia) => inertia / (ball.mass * ball.radius * ball.radius),
            None => T::constant(0.4),
        };
        Self {
            restitution: ground.restitution,
            friction: ground.friction,
            compliance: ground.compliance,
            rolling: ground.rolling,
            slope: ground.slope,
            side_slope: ground.side_slope,
            inertia,
        }
    }

    /// k = I_b/(I_b + m R²): fraction of the slip that a sticking contact removes from the velocity
    /// of the ball's centre; 2/7 for a homogeneous ball.
    #[inline(always)]
    pub fn sticking_factor(&self) -> T {
        self.inertia / (self.inertia + 1.0)
    }
}
