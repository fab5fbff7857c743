//! Impact of the club head and the ball (docs/model.md, eqs. 1–11): rigid bodies in three
//! dimensions, an ellipsoidal face, after Winfield & Tan (1994) eqs. 1–20.
//!
//! The collision is solved in the head frame (X up, Y towards the toe, Z forward), because the
//! inertia tensor is given in this frame. The result is transformed to the ground frame.

mod delivery;
mod face;
mod friction;
mod head;
mod linear;
mod mirror;
mod rigid_body;

pub use delivery::Delivery;
pub use face::FacePoint;
pub use friction::Grip;
pub use head::Head;
pub use rigid_body::{Collision, Rebound};

use crate::error::{Error, Result};
use crate::launch::Launch;
use crate::number::{Mask, Number, Numbers, Vector, inlined};
use crate::parameters::{Golfer, Setup};

/// Result of an impact, in the ground frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact<T> {
    /// Launch of the ball.
    pub launch: Launch<T>,
    /// Speed of the head before impact, m/s.
    pub club_speed: T,
    /// The head with its movable weights.
    pub head: Head<T>,
    /// Velocity of the head's centre of mass after impact, m/s.
    pub club_velocity: Vector<T>,
    /// Angular velocity of the head after impact, rad/s.
    pub club_spin: Vector<T>,
    /// Impulse on the ball, N s.
    pub impulse: Vector<T>,
    /// Unit normal of the face at the impact point.
    pub face_normal: Vector<T>,
    /// Impact point from the head's centre of mass, m.
    pub contact_point: Vector<T>,
    /// State of the contact: sticking or slipping.
    pub grip: Grip,
}

/// The impact of a setup.
///
/// # Errors
/// [`Error::OffFace`] if the strike is beyond the ellipsoid of the face, [`Error::NoStrike`] if the
/// face does not move towards the ball, and [`Error::Jammed`] if the impact has no solution.
pub fn strike<T: Number>(setup: &Setup<T>) -> Result<Impact<T>> {
    let delivery = Delivery::new(&setup.swing);
    let collision = Collision::new(setup, &delivery)?;
    let approach = collision.approach().dot(collision.normal).re();
    if approach <= 0.0 || approach.is_nan() {
        return Err(Error::NoStrike { approach });
    }
    let system = collision.checked_system()?;
    let sticking = collision.pushing(collision.sticking(&system))?;
    let (impulse, grip) = match setup.impact.friction {
        None => (sticking, Grip::Unlimited),
        Some(friction) => friction::limited(&collision, &system, sticking, friction)
            .checked(&collision, friction)?,
    };
    let rebound = collision.after(impulse, &system);
    let ground = inlined!(|v| delivery.to_ground(v));
    let impact = Impact {
        launch: Launch {
            velocity: ground(rebound.ball_velocity),
            spin: ground(rebound.ball_spin),
        },
        club_speed: setup.swing.speed,
        head: Head::new(&setup.club),
        club_velocity: ground(rebound.club_velocity),
        club_spin: ground(rebound.club_spin),
        impulse: ground(rebound.impulse),
        face_normal: ground(collision.normal),
        contact_point: ground(collision.contact),
        grip,
    };
    Ok(match setup.golfer {
        Golfer::Right => impact,
        Golfer::Left => impact.mirrored(),
    })
}

/// Launch of the ball in each lane: the part of a drive before the flight.
pub(crate) struct LaunchState<T: Numbers> {
    pub launch: Launch<T>,
    /// Speed of the head, m/s, if a club strikes the ball.
    pub club_speed: Option<T>,
    /// Lanes with a valid launch: [`strike`] returns it without an error, or the setup gives it.
    pub is_valid: T::Mask,
}

impl<T: Numbers> LaunchState<T> {
    /// The launch that the setup gives; without a given launch, the launch after the impact.
    #[inline(always)]
    pub fn new(setup: &Setup<T>) -> Self {
        T::not_inlined(inlined!(|| match Launch::given(setup) {
            Some(launch) => Self {
                launch,
                club_speed: None,
                is_valid: T::Mask::first(usize::MAX),
            },
            None => Self::of_impact(setup),
        }))
    }

    /// The launch after an impact, computed without branches in all lanes.
    #[inline(always)]
    fn of_impact(setup: &Setup<T>) -> Self {
        let delivery = Delivery::new(&setup.swing);
        let head = Head::new(&setup.club);
        let (face, q) = FacePoint::unchecked(&head, &setup.club, &setup.strike);
        let collision = Collision::at(setup, &head, &delivery, &face);
        let system = collision.contact_system();
        let sticking = collision.sticking(&system);
        let above_zero = inlined!(|x: T| (-x).below(0.0));
        let mut is_valid = q.below(1.0)
            & above_zero(collision.approach().dot(collision.normal))
            & system.inertia.is_positive()
            & system.compliance.is_positive()
            & above_zero(sticking.dot(collision.normal));
        if setup.impact.restitution_slope.is_some() {
            is_valid = is_valid & collision.has_restitution();
        }
        let impulse = match setup.impact.friction {
            None => sticking,
            Some(friction) => {
                let limited = friction::limited(&collision, &system, sticking, friction);
                is_valid = is_valid
                    & limited.separates()
                    & above_zero(limited.impulse.dot(collision.normal));
                limited.impulse
            }
        };
        let rebound = collision.after(impulse, &system);
        let (velocity, spin) = (
            delivery.to_ground(rebound.ball_velocity),
            delivery.to_ground(rebound.ball_spin),
        );
        // a comparison with NaN is false, so a launch with an overflow is not valid
        let size = velocity.dot(velocity) + spin.dot(spin);
        let launch = Launch { velocity, spin };
        let launch = match setup.golfer {
            Golfer::Right => launch,
            Golfer::Left => launch.mirrored(),
        };
        Self {
            launch,
            club_speed: Some(setup.swing.speed),
            is_valid: is_valid & size.below(f64::MAX),
        }
    }
}
