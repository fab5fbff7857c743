//! The ground of the landing area.

/// Properties of the ground, and the inertia of the ball on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turf<T> {
    /// e_g: restitution of a slow impact; `None` if the ball embeds.
    pub restitution: Option<T>,
    /// μ_g.
    pub friction: T,
    /// θ_g, rad.
    pub compliance: T,
    /// ρ_g.
    pub rolling: T,
    /// β_z: slope downrange, rad.
    pub slope: T,
    /// β_y: slope to the right, rad.
    pub side_slope: T,
    /// I_b/(m R²) of the ball.
    pub inertia: T,
}
