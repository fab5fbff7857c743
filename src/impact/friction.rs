use super::rigid_body::{Collision, ContactSystem, jammed};
use crate::error::Result;
use crate::number::{Mask, Number, Numbers, Vector};

/// State of the contact: sticking or slipping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// No limit to friction.
    Unlimited,
    /// The ball sticks. The number is the used fraction of the available friction, |J_t|/(μ J_n).
    Sticks(f64),
    /// The ball slips. The number is the friction that sticking would need, divided by the
    /// available friction: |J_t|/(μ J_n) > 1.
    Slips(f64),
}

/// Impulse under the limit of friction.
pub(super) struct LimitedImpulse<T: Numbers> {
    pub impulse: Vector<T>,
    /// |J_t|² that a sticking contact needs, N² s².
    needed_squared: T,
    /// Largest tangential impulse μ J_n, N s.
    limit: T,
    /// Lanes in which the ball slips.
    slips: T::Mask,
    /// n·K(n + μ t̂), 1/kg, with K of docs/model.md, eq. 9. If the ball slips, this must be above
    /// 0: otherwise the impulse does not separate the bodies.
    separating: T,
}

/// Impulse under Coulomb friction (docs/model.md, eq. 11). It is the `sticking` impulse J within
/// the friction cone. Outside of the cone it is j (n + μ t̂), where t̂ is the direction of the
/// tangential part J_t of the sticking impulse. At the limit of friction the impulse is continuous,
/// but its derivative is not.
#[inline(always)]
pub(super) fn limited<T: Numbers>(
    collision: &Collision<T>,
    system: &ContactSystem<T>,
    sticking: Vector<T>,
    friction: T,
) -> LimitedImpulse<T> {
    let normal = collision.normal;
    let push = sticking.dot(normal);
    let tangential = sticking - normal * push;
    let (needed_squared, limit) = (tangential.dot(tangential), friction * push);
    let slips = (limit * limit - needed_squared).below(0.0);
    if !slips.any() {
        return LimitedImpulse {
            impulse: sticking,
            needed_squared,
            limit,
            slips,
            separating: T::constant(1.0),
        };
    }
    let direction = normal + tangential * (friction / needed_squared.sqrt());
    let [x, y, z] = system.columns;
    let separating = normal.dot(x * direction.x + y * direction.y + z * direction.z);
    let size = collision.approach().dot(normal) * (collision.restitution + 1.0) / separating;
    let impulse = (direction * size).select(sticking, slips);
    LimitedImpulse {
        impulse,
        needed_squared,
        limit,
        slips,
        separating,
    }
}

impl<T: Numbers> LimitedImpulse<T> {
    /// Lanes in which the impulse separates the bodies. They include all lanes in which the ball
    /// sticks.
    #[inline(always)]
    pub fn separates(&self) -> T::Mask {
        !self.slips | (-self.separating).below(0.0)
    }
}

impl<T: Number> LimitedImpulse<T> {
    /// The impulse, and the state of the contact.
    ///
    /// # Errors
    /// [`Error::Jammed`](crate::error::Error::Jammed) if the impulse does not separate the bodies.
    pub fn checked(self, collision: &Collision<T>, friction: T) -> Result<(Vector<T>, Grip)> {
        let needed = self.needed_squared.re().sqrt();
        let used = if needed == 0.0 {
            0.0
        } else {
            needed / self.limit.re()
        };
        if !self.slips {
            return Ok((self.impulse, Grip::Sticks(used)));
        }
        if !self.separates() {
            return Err(jammed(&format!(
                "with impact.friction = {} the ball slips but n·K(n + μ t) = {} /kg, which must be \
                 above 0; check impact.friction, strike.high, strike.toe and club.inertia",
                friction.re(),
                self.separating.re()
            )));
        }
        Ok((collision.pushing(self.impulse)?, Grip::Slips(used)))
    }
}
