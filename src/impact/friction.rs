use super::rigid_body::{Collision, Factors, Rebound, jammed};
use crate::error::Result;
use crate::number::Number;

/// Where a contact stands against the limit of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// No limit to friction.
    Unlimited,
    /// The ball sticks, with |J_t|/(μ J_n) of the friction used.
    Sticks(f64),
    /// The ball slips; sticking would have needed |J_t|/(μ J_n) of the friction.
    Slips(f64),
}

/// The rebound under Coulomb friction (docs/model.md, eq. 11), and whether the ball slips: where the sticking
/// impulse lies outside the friction cone, J = j (n + μ t̂) with t̂ the direction of the sticking J_t. It
/// joins the sticking rebound continuously; its slope does not.
///
/// # Errors
/// [`Error::Jammed`](crate::error::Error::Jammed) where such an impulse cannot separate the bodies.
#[inline]
pub(super) fn limited<T: Number>(
    collision: &Collision<T>,
    factors: &Factors<T>,
    sticking: Rebound<T>,
    friction: Option<T>,
) -> Result<(Rebound<T>, Grip)> {
    let Some(friction) = friction else { return Ok((sticking, Grip::Unlimited)) };
    let normal = collision.normal;
    let push = sticking.impulse.dot(normal);
    let tangential = sticking.impulse - normal * push;
    let (needed, limit) = (tangential.re().norm(), (friction * push).re());
    let used = if needed == 0.0 { 0.0 } else { needed / limit };
    if needed <= limit {
        return Ok((sticking, Grip::Sticks(used)));
    }
    let direction = normal + tangential * (friction / tangential.norm());
    let [x, y, z] = collision.columns(&factors.inertia);
    let separating = normal.dot(x * direction.x + y * direction.y + z * direction.z);
    if separating.re() <= 0.0 || separating.re().is_nan() {
        return Err(jammed(&format!(
            "with impact.friction = {} the ball slips but n·K(n + μ t) = {} /kg, which must be above 0",
            friction.re(),
            separating.re()
        )));
    }
    let size = collision.approach().dot(normal) * (collision.restitution + 1.0) / separating;
    let slipping = collision.checked(collision.after(direction * size, factors))?;
    Ok((slipping, Grip::Slips(used)))
}
