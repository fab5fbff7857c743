use super::delivery::Delivery;
use super::face::FacePoint;
use super::head::Head;
use super::linear::SymmetricFactors;
use crate::error::{Error, Result};
use crate::number::{Number, Numbers, Vector, inlined};
use crate::parameters::{Setup, SpeedOf};
use crate::units::significant;

/// Collision of two rigid bodies in the head frame: a moving head, and a ball at rest.
#[derive(Clone, Copy, Debug)]
pub struct Collision<T> {
    /// Mass M of the head, kg.
    pub club_mass: T,
    /// Inertia tensor I_c of the head, kg m².
    pub club_inertia: [[T; 3]; 3],
    /// Velocity of the head's centre of mass, m/s.
    pub club_velocity: Vector<T>,
    /// Angular velocity of the head, rad/s.
    pub club_spin: Vector<T>,
    /// Mass m of the ball, kg.
    pub ball_mass: T,
    /// Moment of inertia I_b of the ball, kg m².
    pub ball_inertia: T,
    /// Radius R of the ball, m.
    pub ball_radius: T,
    /// r_P: contact point relative to the head's centre of mass, m.
    pub contact: Vector<T>,
    /// n: unit normal of the face at the contact point, towards the ball.
    pub normal: Vector<T>,
    /// Normal coefficient of restitution e at the closing speed.
    pub restitution: T,
    /// Tangential coefficient of restitution e_t.
    pub tangential_restitution: T,
    /// Scale g of the gear effect; `None` means g = 1.
    pub gear_scale: Option<T>,
}

/// Closing speed v₁, m/s: 160 ft/s, the speed of the USGA's test of clubs. If the restitution
/// depends on the closing speed, the setup states its value at v₁ (docs/model.md, eq. 10a).
const REFERENCE_SPEED: f64 = 48.768;

/// The bodies after the collision.
#[derive(Clone, Copy, Debug)]
pub struct Rebound<T> {
    /// Impulse on the ball, N s.
    pub impulse: Vector<T>,
    /// Velocity of the ball, m/s.
    pub ball_velocity: Vector<T>,
    /// Angular velocity of the ball, rad/s.
    pub ball_spin: Vector<T>,
    /// Velocity of the head's centre of mass, m/s.
    pub club_velocity: Vector<T>,
    /// Angular velocity of the head, rad/s.
    pub club_spin: Vector<T>,
}

impl<T: Numbers> Collision<T> {
    /// The collision with impact point `face`.
    #[inline(always)]
    pub(super) fn at(
        setup: &Setup<T>,
        head: &Head<T>,
        delivery: &Delivery<T>,
        face: &FacePoint<T>,
    ) -> Self {
        let ball = &setup.ball;
        let mut collision = Self {
            club_mass: head.mass,
            club_inertia: head.inertia,
            club_velocity: delivery.to_head(delivery.velocity),
            club_spin: delivery.to_head(delivery.closure),
            ball_mass: ball.mass,
            ball_inertia: ball
                .inertia
                .unwrap_or_else(inlined!(|| ball.mass * ball.radius * ball.radius * 0.4)),
            ball_radius: ball.radius,
            contact: face.position,
            normal: face.normal,
            restitution: setup.impact.restitution,
            tangential_restitution: setup.impact.tangential_restitution,
            gear_scale: setup.impact.gear_scale,
        };
        if setup.speed_of == SpeedOf::FaceCentre {
            // v_c = v − ω_c × r_F (docs/model.md, eq. 1a)
            let turning = T::not_inlined(inlined!(|| collision
                .club_spin
                .cross(head.face_centre(setup.club.loft))));
            collision.club_velocity = collision.club_velocity - turning;
        }
        if let Some(slope) = setup.impact.restitution_slope {
            let closing = collision.approach().dot(collision.normal);
            collision.restitution = collision.restitution + (closing - REFERENCE_SPEED) * slope;
        }
        collision
    }

    /// Lanes whose coefficient of restitution at the closing speed is between 0 and 1.
    #[inline(always)]
    pub(super) fn has_restitution(&self) -> T::Mask {
        !self.restitution.below(0.0) & !(-self.restitution).below(-1.0)
    }

    /// u⁻: velocity of the club's contact point relative to the contact point of the ball, before
    /// impact, m/s (eq. 8).
    #[inline(always)]
    pub fn approach(&self) -> Vector<T> {
        self.club_velocity + self.club_spin.cross(self.contact)
    }

    /// Matrix K of the contact (eq. 9), and factorizations of K and of the inertia tensor I_c.
    #[inline(always)]
    pub(super) fn contact_system(&self) -> ContactSystem<T> {
        let [[xx, ..], [xy, yy, _], [xz, yz, zz]] = self.club_inertia;
        let inertia = SymmetricFactors::new([xx, xy, yy, xz, yz, zz]);
        let columns = self.columns(&inertia);
        let [x, y, z] = columns;
        ContactSystem {
            inertia,
            columns,
            compliance: SymmetricFactors::new([x.x, x.y, y.y, x.z, y.z, z.z]),
        }
    }

    /// Impulse on a ball that sticks to the face (eq. 10):
    /// K J = u⁻ + e (n·u⁻) n + e_t (u⁻ − (n·u⁻) n).
    #[inline(always)]
    pub(super) fn sticking(&self, system: &ContactSystem<T>) -> Vector<T> {
        let approach = self.approach();
        let closing = self.normal * approach.dot(self.normal);
        let change = approach
            + closing * self.restitution
            + (approach - closing) * self.tangential_restitution;
        Vector::from_array(system.compliance.solve(change.to_array()))
    }

    /// Motion of the bodies after the impulse J on the ball (eq. 10).
    #[inline(always)]
    pub(super) fn after(&self, impulse: Vector<T>, system: &ContactSystem<T>) -> Rebound<T> {
        let turned =
            Vector::from_array(system.inertia.solve(self.contact.cross(impulse).to_array()));
        Rebound {
            impulse,
            ball_velocity: impulse * self.ball_mass.recip(),
            ball_spin: impulse.cross(self.normal) * (self.ball_radius / self.ball_inertia),
            club_velocity: self.club_velocity - impulse * self.club_mass.recip(),
            club_spin: self.club_spin - turned,
        }
    }

    /// Columns of K (eqs. 9, 9a). An impulse e decreases the relative velocity of the contact
    /// points by K e = (1/M + 1/m) e − r_P × I_c⁻¹ (r_P × e) − (R²/I_b) n × (n × e).
    #[inline(always)]
    fn columns(&self, inertia: &SymmetricFactors<T>) -> [Vector<T>; 3] {
        let inverse_mass = self.club_mass.recip() + self.ball_mass.recip();
        let rolling = self.ball_radius * self.ball_radius / self.ball_inertia;
        let (arm, n, zero) = (self.contact, self.normal, T::zero());
        // r_P × e for the unit vectors e; and n × (n × e) = n (n·e) − (n·n) e
        let arm_crosses = [
            [zero, arm.z, -arm.y],
            [-arm.z, zero, arm.x],
            [arm.y, -arm.x, zero],
        ];
        let mut columns = [n; 3];
        // a loop instead of three copies, so that the called functions are inlined only once
        for (column, (arm_cross_e, along)) in columns
            .iter_mut()
            .zip(arm_crosses.into_iter().zip(n.to_array()))
        {
            let turned = Vector::from_array(inertia.solve(arm_cross_e));
            *column = turned.cross(arm) - n * (along * rolling);
        }
        let squared = n.dot(n) * rolling + inverse_mass;
        columns[0].x = columns[0].x + squared;
        columns[1].y = columns[1].y + squared;
        columns[2].z = columns[2].z + squared;
        if let Some(scale) = self.gear_scale {
            // K + (g − 1)(w nᵀ + n wᵀ), eq. 9a
            let (more, w) = (scale - 1.0, self.gear_velocity(&columns));
            for ((column, n_e), w_e) in columns.iter_mut().zip(n.to_array()).zip(w.to_array()) {
                *column = *column + (w * n_e + n * w_e) * more;
            }
        }
        columns
    }

    /// w = K n − (n·K n) n (eq. 9a). A unit impulse along the face normal turns the head. This turn
    /// decreases the relative velocity along the face by w: the gear effect.
    #[inline(always)]
    fn gear_velocity(&self, [x, y, z]: &[Vector<T>; 3]) -> Vector<T> {
        let n = self.normal;
        let pushed = *x * n.x + *y * n.y + *z * n.z;
        pushed - n * n.dot(pushed)
    }
}

/// The inertia tensor I_c of the head and the matrix K of the contact (docs/model.md, eq. 9).
pub(super) struct ContactSystem<T> {
    /// Factorization of I_c.
    pub inertia: SymmetricFactors<T>,
    /// Columns of K.
    pub columns: [Vector<T>; 3],
    /// Factorization of K.
    pub compliance: SymmetricFactors<T>,
}

impl<T: Number> Collision<T> {
    /// The collision of a setup with this delivery.
    ///
    /// # Errors
    /// [`Error::OffFace`] if the strike is beyond the ellipsoid of the face, and [`Error::Jammed`]
    /// if the restitution at this speed is not between 0 and 1.
    #[inline]
    pub fn new(setup: &Setup<T>, delivery: &Delivery<T>) -> Result<Self> {
        let (head, face) = (
            Head::new(&setup.club),
            FacePoint::new(&setup.club, &setup.strike)?,
        );
        let collision = Self::at(setup, &head, delivery, &face);
        if setup.impact.restitution_slope.is_some() && !collision.has_restitution() {
            return Err(jammed(&format!(
                "the restitution at the closing speed of {:.3} m/s would be {:.5}, which must be \
                 between 0 and 1; check impact.restitution, impact.restitution_slope and swing.speed",
                collision.approach().dot(collision.normal).re(),
                collision.restitution.re()
            )));
        }
        Ok(collision)
    }

    /// Motion of the bodies after a collision in which the ball sticks to the face, from the 3
    /// equations for the impulse (docs/model.md, eqs. 8–10).
    ///
    /// # Errors
    /// [`Error::Jammed`] if the impulse would pull the bodies together.
    #[inline]
    pub fn by_impulse(&self) -> Result<Rebound<T>> {
        let system = self.checked_system()?;
        Ok(self.after(self.pushing(self.sticking(&system))?, &system))
    }

    /// Columns of K (docs/model.md, eq. 9): an impulse e decreases the relative velocity of the
    /// contact points by K e.
    ///
    /// # Errors
    /// [`Error::Jammed`] if the head's inertia tensor is not positive definite.
    pub fn compliance(&self) -> Result<[Vector<T>; 3]> {
        Ok(self.checked_system()?.columns)
    }

    /// The contact system, if its matrices are positive definite.
    ///
    /// # Errors
    /// [`Error::Jammed`] if one of its matrices is not positive definite.
    #[inline]
    pub(super) fn checked_system(&self) -> Result<ContactSystem<T>> {
        let system = self.contact_system();
        if !system.inertia.is_positive() {
            return Err(jammed(
                "the head's inertia tensor is not positive definite; check club.inertia",
            ));
        }
        if !system.compliance.is_positive() {
            return Err(jammed(
                "the contact's 3 × 3 system is singular; check club.mass, club.inertia, ball.mass, \
                 ball.radius and ball.inertia",
            ));
        }
        Ok(system)
    }

    /// The impulse, if it pushes the bodies apart.
    ///
    /// # Errors
    /// [`Error::Jammed`] if it pulls them together.
    #[inline]
    pub(super) fn pushing(&self, impulse: Vector<T>) -> Result<Vector<T>> {
        let push = impulse.dot(self.normal).re();
        if push <= 0.0 || push.is_nan() {
            return Err(jammed(&format!(
                "the impulse along the face normal would be {} N s, which must be above 0; check \
                 strike.high, strike.toe, club.inertia and impact.tangential_restitution",
                significant(push, 3)
            )));
        }
        Ok(impulse)
    }
}

pub(super) fn jammed(reason: &str) -> Error {
    Error::Jammed {
        reason: reason.into(),
    }
}
