use super::motion::{Motion, Rate};
use crate::launch::Launch;
use crate::number::{Number, Vector};

/// The ball at the end of a step, with its acceleration there: the first stage of the next step and, for the
/// landing, the second derivative of the path.
#[derive(Clone, Copy)]
pub(super) struct Node<T> {
    pub time: f64,
    pub position: Vector<T>,
    pub velocity: Vector<T>,
    pub rate: Rate<T>,
    /// What the step here added: x − x₀ − h v₀, and v − v₀, as computed, before the sums rounded them.
    pub added: [Vector<T>; 2],
    /// Way through the air, m; followed only where the spin depends on it.
    air_path: T,
}

impl<T: Number> Node<T> {
    /// The ball on the tee, leaving.
    pub fn at_launch(motion: &Motion<T>, launch: &Launch<T>) -> Self {
        let zero = T::zero();
        let rate = motion.rate(&motion.spin_at(0.0, zero), launch.velocity, || zero);
        let added = [Vector::zero(); 2];
        Self { time: 0.0, position: Vector::zero(), velocity: launch.velocity, rate, added, air_path: zero }
    }

    /// One step of length `h` of the classical fourth-order Runge–Kutta method (Kutta 1901), to time `end`.
    ///
    /// For x″ = a(t, x, x′) its position update Σ bᵢ vᵢ is h v + h²/6 (a₁ + a₂ + a₃), and the stages' positions
    /// are wanted only where the wind depends on height.
    #[inline]
    pub fn step(&self, motion: &Motion<T>, h: f64, end: f64) -> Self {
        let half = 0.5 * h;
        let middle = self.time + half;
        let (x, v, first) = (self.position, self.velocity, self.rate);
        let scaled = |a: Vector<T>, factor: f64| Vector::new(a.x * factor, a.y * factor, a.z * factor);
        let path_after = |time: f64, airspeed: T| self.air_path + airspeed * time;

        let spin = motion.spin_at(middle, path_after(half, first.airspeed));
        let second = motion.rate(&spin, v + scaled(first.acceleration, half), || x.x + v.x * half);

        let spin = if motion.is_damped() { motion.spin_at(middle, path_after(half, second.airspeed)) } else { spin };
        let third = motion.rate(&spin, v + scaled(second.acceleration, half), || {
            x.x + v.x * half + first.acceleration.x * (half * half)
        });

        let spin = motion.spin_at(end, path_after(h, third.airspeed));
        let fourth = motion
            .rate(&spin, v + scaled(third.acceleration, h), || x.x + v.x * h + second.acceleration.x * (half * h));

        let inner = second.acceleration + third.acceleration;
        let bent = scaled(first.acceleration + inner, h * h / 6.0);
        let gained = scaled(first.acceleration + inner + inner + fourth.acceleration, h / 6.0);
        let (position, velocity) = (x + scaled(v, h) + bent, v + gained);
        let inner_speed = second.airspeed + third.airspeed;
        let air_path = path_after(h / 6.0, first.airspeed + inner_speed + inner_speed + fourth.airspeed);
        let spin = if motion.is_damped() { motion.spin_at(end, air_path) } else { spin };
        let rate = motion.rate(&spin, velocity, || position.x);
        Self { time: end, position, velocity, rate, added: [bent, gained], air_path }
    }

    /// Whether drag and lift change the airspeed by more than half of it within a step: far beyond where four stages
    /// follow them, and near where they make the ball run away.
    #[inline]
    pub fn is_coarse(&self, h: f64, gravity: f64) -> bool {
        let mut aerodynamic = self.rate.acceleration.re();
        aerodynamic.x += gravity;
        let (change, half) = (aerodynamic.dot(aerodynamic) * h * h, 0.5 * self.rate.airspeed.re());
        change > half * half
    }

    pub fn is_finite(&self) -> bool {
        let (x, v) = (self.position.re(), self.velocity.re());
        (x.dot(x) + v.dot(v)).is_finite()
    }
}
