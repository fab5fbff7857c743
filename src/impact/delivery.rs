use crate::number::{Numbers, Vector};
use crate::parameters::Swing;

/// The club just before impact: its motion in the ground frame, and the axes of the head frame.
#[derive(Clone, Copy, Debug)]
pub struct Delivery<T> {
    /// Velocity of the head's centre of mass, m/s.
    pub velocity: Vector<T>,
    /// Angular velocity of the head, rad/s.
    pub closure: Vector<T>,
    /// The head frame's axes X_h (up), Y_h (towards the toe), Z_h (forward) in the ground frame.
    pub axes: [Vector<T>; 3],
}

impl<T: Numbers> Delivery<T> {
    /// The delivery of a swing (docs/model.md, eqs. 1–2): the head is pitched by a = ε − σ, then yawed by ψ.
    #[inline(always)]
    pub fn new(swing: &Swing<T>) -> Self {
        let (sin_attack, cos_attack) = swing.attack_angle.sin_cos();
        let (sin_path, cos_path) = swing.path.sin_cos();
        let (sin_pitch, cos_pitch) = (swing.attack_angle - swing.shaft_lean).sin_cos();
        let (sin_yaw, cos_yaw) = swing.face_angle.sin_cos();
        let direction = Vector::new(sin_attack, cos_attack * sin_path, cos_attack * cos_path);
        Self {
            velocity: direction * swing.speed,
            closure: Vector::new(swing.closure_x, swing.closure_y, swing.closure_z),
            axes: [
                Vector::new(cos_pitch, -sin_pitch * sin_yaw, -sin_pitch * cos_yaw),
                Vector::new(T::zero(), cos_yaw, -sin_yaw),
                Vector::new(sin_pitch, cos_pitch * sin_yaw, cos_pitch * cos_yaw),
            ],
        }
    }

    /// A vector of the head frame, in the ground frame.
    #[inline(always)]
    pub fn to_ground(&self, v: Vector<T>) -> Vector<T> {
        let [x, y, z] = self.axes;
        x * v.x + y * v.y + z * v.z
    }

    /// A vector of the ground frame, in the head frame.
    #[inline(always)]
    pub fn to_head(&self, v: Vector<T>) -> Vector<T> {
        let [x, y, z] = self.axes;
        Vector::new(x.dot(v), y.dot(v), z.dot(v))
    }
}
