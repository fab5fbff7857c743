use crate::number::{Numbers, Vector, inlined};
use crate::parameters::Swing;

/// The club just before impact: its motion in the ground frame, and the axes of the head frame.
#[derive(Clone, Copy, Debug)]
pub struct Delivery<T> {
    /// Velocity of the head's centre of mass, or of the centre of its face, whichever the swing
    /// states, m/s.
    pub velocity: Vector<T>,
    /// Angular velocity of the head, rad/s.
    pub closure: Vector<T>,
    /// The head frame's axes X_h (up), Y_h (towards the toe), Z_h (forward) in the ground frame.
    pub axes: [Vector<T>; 3],
}

/// The head speed at which bend and droop of the shaft are stated: 100 mph, m/s.
const SPEED_OF_BEND: f64 = 44.704;

/// What the shaft adds to the attitude of the head (docs/model.md, eq. 2a), rad.
#[derive(Clone, Copy)]
struct Bent<T> {
    forward: Option<T>,
    down: Option<T>,
}

impl<T: Numbers> Bent<T> {
    #[inline(always)]
    fn new(swing: &Swing<T>) -> Self {
        let (mut forward, mut down) = (swing.shaft_bend, swing.shaft_droop);
        if let Some(power) = swing.shaft_growth
            && (forward.is_some() || down.is_some())
        {
            let growth = ((swing.speed * (1.0 / SPEED_OF_BEND)).ln() * power).exp();
            let grown = inlined!(|angle: T| angle * growth);
            (forward, down) = (forward.map(grown), down.map(grown));
        }
        Self { forward, down }
    }
}

impl<T: Numbers> Delivery<T> {
    /// The delivery of a swing (docs/model.md, eqs. 1–2b): the head is turned toe down by the
    /// droop, pitched by a = ε − σ and the bend, then yawed by ψ.
    #[inline(always)]
    pub fn new(swing: &Swing<T>) -> Self {
        let (sin_attack, cos_attack) = swing.attack_angle.sin_cos();
        let (sin_path, cos_path) = swing.path.sin_cos();
        let bent = Bent::new(swing);
        let pitch = swing.attack_angle - swing.shaft_lean;
        let (sin_pitch, cos_pitch) = bent
            .forward
            .map_or(pitch, inlined!(|bend| pitch + bend))
            .sin_cos();
        let (sin_yaw, cos_yaw) = swing.face_angle.sin_cos();
        let direction = Vector::new(sin_attack, cos_attack * sin_path, cos_attack * cos_path);
        let up = Vector::new(cos_pitch, -sin_pitch * sin_yaw, -sin_pitch * cos_yaw);
        let toe = Vector::new(T::zero(), cos_yaw, -sin_yaw);
        let forward = Vector::new(sin_pitch, cos_pitch * sin_yaw, cos_pitch * cos_yaw);
        let axes = match bent.down {
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
