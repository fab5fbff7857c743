//! What a left-hander's impact is beside the same numbers of a right-hander: its mirror image in
//! the vertical plane of the target line.

use super::Impact;
use crate::launch::Launch;
use crate::number::{Numbers, Vector};

/// Of a velocity, an impulse, a direction or a place.
#[inline(always)]
fn polar<T: Numbers>(v: Vector<T>) -> Vector<T> {
    Vector::new(v.x, -v.y, v.z)
}

/// Of an angular velocity: a mirror turns it the other way about all that lies in it.
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
            grip: self.grip,
        }
    }
}
