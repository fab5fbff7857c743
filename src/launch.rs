//! Launch of the ball, and the launch conditions that a launch monitor reports.

use crate::number::{Number, Numbers, Vector};
use crate::parameters::Setup;

/// η, rad/s: a smaller spin counts as zero. In flight |ω| is √(ω·ω + η²), which has derivatives at
/// zero spin (docs/model.md, eq. 14).
pub const LEAST_SPIN: f64 = 1e-6;

/// Velocity and angular velocity of the ball at launch, in the ground frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Launch<T> {
    /// Velocity, m/s.
    pub velocity: Vector<T>,
    /// Angular velocity, rad/s; backspin is along +Y.
    pub spin: Vector<T>,
}

impl<T> Launch<T> {
    /// Converts the number type.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U + Copy) -> Launch<U>
    where
        T: Copy,
    {
        Launch {
            velocity: self.velocity.map(f),
            spin: self.spin.map(f),
        }
    }
}

impl<T: Numbers> Launch<T> {
    /// The launch that a setup gives (`launch.*`); `None` if a club strikes the ball.
    #[inline(always)]
    pub fn given(setup: &Setup<T>) -> Option<Self> {
        let given = &setup.launch;
        let (speed, angle) = (given.ball_speed?, given.launch_angle?);
        let or_zero = |value: Option<T>| value.unwrap_or_else(T::zero);
        let (back, side) = match given.spin {
            Some(spin) => {
                let (sin, cos) = or_zero(given.spin_axis).sin_cos();
                (spin * cos, spin * sin)
            }
            None => (or_zero(given.backspin), or_zero(given.sidespin)),
        };
        let direction = or_zero(given.launch_direction);
        let ((rise, run), (right, ahead)) = (angle.sin_cos(), direction.sin_cos());
        let velocity = Vector::new(rise, run * right, run * ahead) * speed;
        let back_axis = Vector::new(T::zero(), ahead, -right);
        let side_axis = Vector::new(-run, rise * right, rise * ahead);
        Some(Self {
            velocity,
            spin: back_axis * back + side_axis * side,
        })
    }
}

impl<T: Number> Launch<T> {
    /// |v|, m/s.
    pub fn ball_speed(&self) -> T {
        self.velocity.norm()
    }

    /// Angle of the velocity above horizontal, rad.
    pub fn launch_angle(&self) -> T {
        self.velocity.x.atan2(self.horizontal_speed())
    }

    /// Horizontal direction of the velocity, + right of the target line, rad.
    pub fn launch_direction(&self) -> T {
        self.velocity.y.atan2(self.velocity.z)
    }

    /// |ω| as ω·ω/√(ω·ω + η²), rad/s: exactly 0 at zero spin, with finite derivatives there.
    pub fn total_spin(&self) -> T {
        let squared = self.spin.dot(self.spin);
        squared / (squared + LEAST_SPIN * LEAST_SPIN).sqrt()
    }

    /// Spin about the horizontal axis perpendicular to the launch direction, rad/s; + lifts the
    /// ball.
    pub fn backspin(&self) -> T {
        let v = self.velocity;
        (self.spin.y * v.z - self.spin.z * v.y) / self.horizontal_speed()
    }

    /// Spin about the axis that lies in the vertical plane of the velocity and is perpendicular to
    /// the velocity, rad/s; + curves right.
    pub fn sidespin(&self) -> T {
        let (v, horizontal) = (self.velocity, self.horizontal_speed());
        let along = (self.spin.y * v.y + self.spin.z * v.z) / horizontal;
        (v.x * along - self.spin.x * horizontal) / self.ball_speed()
    }

    /// Tilt of the spin axis, atan2(sidespin, backspin), rad; + curves right. NaN if |ω| < η.
    pub fn spin_axis(&self) -> T {
        if self.spin.dot(self.spin).re() < LEAST_SPIN * LEAST_SPIN {
            return T::constant(f64::NAN);
        }
        self.sidespin().atan2(self.backspin())
    }

    fn horizontal_speed(&self) -> T {
        let v = self.velocity;
        (v.y * v.y + v.z * v.z).sqrt()
    }
}
