use crate::number::Numbers;
use crate::parameters::Setup;

/// The ground of the landing area.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turf<T> {
    /// e₀: the restitution of a slow impact; without one the ball embeds.
    pub restitution: Option<T>,
    /// μ_g.
    pub friction: T,
    /// θ_g, rad.
    pub compliance: T,
    /// ρ_g.
    pub rolling: T,
    /// How the ground rises downrange and to the right, rad.
    pub slope: T,
    pub side_slope: T,
    /// I_b/(m R²) of the ball.
    pub inertia: T,
}

impl<T: Numbers> Turf<T> {
    /// That of a setup.
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

    /// The part of a slip that the ball's centre loses where the contact sticks: 2/7 of it for a
    /// homogeneous ball.
    #[inline(always)]
    pub fn stuck(&self) -> T {
        self.inertia / (self.inertia + 1.0)
    }
}
