//! Impact of a left-hander: a right-hander's impact with the same parameters, mirrored in the
//! vertical plane through the target line.

use super::Impact;
use crate::launch::Launch;
use crate::number::{Numbers, Vector};

/// Mirror image of a polar vector: velocity, impulse, direction or position.
#[inline(always)]
fn polar<T: Numbers>(v: Vector<T>) -> Vector<T> {
    Vector::new(v.x, -v.y, v.z)
}

/// Mirror image of an axial vector, such as angular velocity: the components in the mirror plane
/// change sign.
#[inline(always)]
fn axial<T: Numbers>(v: Vector<T>) -> Vector<T> {
    Vector::new(-v.x, v.y, -v.z)
}

impl<T: Numbers> Launch<T> {
    #[inline(always)]
    pub(super) fn mirrored(self) -> Self {
        Self {
            velocity: polar(self.velocity),
            spin: axial(self.spin),
        }
    }
}

impl<T: Numbers> Impact<T> {
    pub(super) fn mirrored(self) -> Self {
        Self {
            launch: self.launch.mirrored(),
            club_velocity: polar(self.club_velocity),
            club_spin: axial(self.club_spin),
            impulse: polar(self.impulse),
            face_normal: polar(self.face_normal),
            contact_point: polar(self.contact_point),
            ..self
        }
    }
}
