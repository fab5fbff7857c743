use crate::number::{Numbers, Vector, inlined};
use crate::parameters::Swing;

/// Motion of the club head at impact in the ground frame, and the axes of the head frame.
#[derive(Clone, Copy, Debug)]
pub struct Delivery<T> {
    /// Velocity, m/s, of the point of the head that `speed_of` names: the centre of mass or the
    /// centre of the face.
    pub velocity: Vector<T>,
    /// Angular velocity of the head, rad/s.
    pub closure: Vector<T>,
    /// The head frame's axes X_h (up), Y_h (towards the toe), Z_h (forward) in the ground frame.
    pub axes: [Vector<T>; 3],
}

/// V₁, m/s: 100 mph. At this head speed the shaft has the bend and the droop that the setup states.
const REFERENCE_SPEED: f64 = 44.704;

impl<T: Numbers> Delivery<T> {
    /// Delivery of a swing (docs/model.md, eqs. 1–2b). The head is first turned toe down by the
    /// shaft droop, then pitched up by attack angle − shaft lean + shaft bend, then yawed by the
    /// face angle.
    #[inline(always)]
    pub fn new(swing: &Swing<T>) -> Self {
        let (sin_attack, cos_attack) = swing.attack_angle.sin_cos();
        let (sin_path, cos_path) = swing.path.sin_cos();
        // eq. 2a: bend and droop of the shaft at the speed of this swing
        let (mut bend, mut droop) = (swing.shaft_bend, swing.shaft_droop);
        if let Some(power) = swing.shaft_growth
            && (bend.is_some() || droop.is_some())
        {
            // (V/V₁)^p_s
            let growth = ((swing.speed * (1.0 / REFERENCE_SPEED)).ln() * power).exp();
            let grown = inlined!(|angle: T| angle * growth);
            (bend, droop) = (bend.map(grown), droop.map(grown));
        }
        let pitch = swing.attack_angle - swing.shaft_lean;
        let (sin_pitch, cos_pitch) = bend.map_or(pitch, inlined!(|bend| pitch + bend)).sin_cos();
        let (sin_yaw, cos_yaw) = swing.face_angle.sin_cos();
        // eq. 1
        let direction = Vector::new(sin_attack, cos_attack * sin_path, cos_attack * cos_path);
        // eq. 2
        let up = Vector::new(cos_pitch, -sin_pitch * sin_yaw, -sin_pitch * cos_yaw);
        let toe = Vector::new(T::zero(), cos_yaw, -sin_yaw);
        let forward = Vector::new(sin_pitch, cos_pitch * sin_yaw, cos_pitch * cos_yaw);
        // eq. 2b
        let axes = match droop {
            None => [up, toe, forward],
            Some(droop) => {
                let (sin, cos) = droop.sin_cos();
                [up * cos + toe * sin, toe * cos - up * sin, forward]
            }
        };
        Self {
            velocity: direction * swing.speed,
            closure: Vector::new(swing.closure_x, swing.closure_y, swing.closure_z),
            axes,
        }
    }

    /// Transforms a vector from the head frame to the ground frame.
    #[inline(always)]
    pub fn to_ground(&self, v: Vector<T>) -> Vector<T> {
        let [x, y, z] = self.axes;
        x * v.x + y * v.y + z * v.z
    }

    /// Transforms a vector from the ground frame to the head frame.
    #[inline(always)]
    pub fn to_head(&self, v: Vector<T>) -> Vector<T> {
        let [x, y, z] = self.axes;
        Vector::new(x.dot(v), y.dot(v), z.dot(v))
    }
}
