//! Equation of motion, its derivative in time, and the decay of the spin (docs/model.md,
//! eqs. 12–14).
//!
//! The order of the operations is chosen for latency (`src/number/mod.rs`, "Pipelines").

use super::inputs::Inputs;
use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::number::{Numbers, Vector, inlined};

/// Smallest airspeed, m/s. Its square is added to |v_r|² (eq. 14), so that |v_r| has finite
/// derivatives at zero airspeed.
const LEAST_SPEED: f64 = 1e-6;
/// Half the interval of the central difference for the jerk, s. Truncation error:
/// 6.7e-9 s² d³a/dt³; rounding error: about 5e-12 m/s³.
const JERK_HALF_INTERVAL: f64 = 2e-4;

/// Rate of change of a ball's motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate<T> {
    /// Acceleration dv/dt, m/s².
    pub acceleration: Vector<T>,
    /// Airspeed |v_r| = dℓ/dt, m/s, with the distance ℓ through the air. The spin decays with ℓ
    /// (eq. 13).
    pub speed: T,
}

impl<T: Numbers> Rate<T> {
    /// All zeros, before the first evaluation.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            acceleration: Vector::zero(),
            speed: T::zero(),
        }
    }
}

/// State of the ball at a node of the integration, and its rate of change.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepNode<T> {
    /// Position, m.
    pub position: Vector<T>,
    /// Velocity, m/s.
    pub velocity: Vector<T>,
    /// Spin |ω|, rad/s.
    pub spin: T,
    /// Rate of change.
    pub rate: Rate<T>,
}

impl<T: Numbers, L: AerodynamicLaw<T>> Inputs<T, L> {
    /// Acceleration (eq. 12) and airspeed, for the velocity `v_r` through the air and the spin |ω|.
    /// Inlining into the loop over the stages saves 2 to 10 % of the time of a drive.
    #[inline(always)]
    pub(super) fn rate(&self, v_r: Vector<T>, spin: T) -> Rate<T> {
        // |v_r|² + (1e-6 m/s)² and |v_r|, eq. 14
        let least = T::constant(LEAST_SPEED * LEAST_SPEED);
        let square = v_r.x.mul_add(v_r.x, least) + v_r.y.mul_add(v_r.y, v_r.z * v_r.z);
        let (speed, _) = square.sqrt_recip();
        // C_D and C_L
        let c = self.law.coefficients(Stream {
            spin,
            speed,
            square,
            radius: self.radius,
            reynolds_per_speed: self.reynolds_per_speed,
        });
        // lift along (ω/|ω|) × v_r, drag along −v_r
        let (lift, drag) = (self.axis.cross(v_r), -v_r);
        let force = Vector::new(
            drag.x.mul_add(c.drag, lift.x * c.lift),
            drag.y.mul_add(c.drag, lift.y * c.lift),
            drag.z.mul_add(c.drag, lift.z * c.lift),
        );
        // dv/dt = ρ A |v_r|/(2 m) (−C_D v_r + C_L (ω/|ω|) × v_r) − g X, eq. 12
        let per_mass = self.force_per_mass * speed;
        let acceleration = Vector::new(
            force.x.mul_add(per_mass, -self.gravity),
            force.y * per_mass,
            force.z * per_mass,
        );
        Rate {
            acceleration,
            speed,
        }
    }

    /// Like [`rate`](Self::rate), for calls outside of the loop over the stages. The result is
    /// written in place, because copying a rate with many derivatives is slow.
    #[inline(always)]
    fn write_rate(&self, v_r: Vector<T>, spin: T, rate: &mut Rate<T>) {
        T::not_inlined(inlined!(|| *rate = self.rate(v_r, spin)));
    }

    /// The node at launch.
    #[inline(always)]
    pub(super) fn launch(&self) -> StepNode<T> {
        let mut node = StepNode {
            position: Vector::zero(),
            velocity: self.velocity,
            spin: self.spin,
            rate: Rate::zero(),
        };
        let v_r = self.velocity - self.wind.at(T::zero());
        self.write_rate(v_r, self.spin, &mut node.rate);
        node
    }

    /// Time derivative of the rate, d²v/dt² and d|v_r|/dt, as a central difference of the equation
    /// of motion along the path. It depends only on the node. Neighbouring steps share a node, so
    /// their interpolants join with three continuous derivatives (C³). A derivative by dual numbers
    /// would double the code size of a flight.
    #[inline(always)]
    pub(super) fn rate_per_time(&self, node: &StepNode<T>) -> Rate<T> {
        let Rate {
            acceleration,
            speed,
        } = node.rate;
        // dω/dt = −(δ + κ |v_r|/R) ω, eq. 13
        let decay_rate = match self.damping {
            None => self.decay,
            Some(damping) => damping.mul_add(speed, self.decay),
        };
        let spin_rate = -(decay_rate * node.spin);
        // a loop instead of two calls: the equation of motion is inlined only once
        let mut shifted = [node.rate; 2];
        for (rate, time) in shifted
            .iter_mut()
            .zip([-JERK_HALF_INTERVAL, JERK_HALF_INTERVAL])
        {
            let height = node.velocity.x.scale_add(time, node.position.x);
            let v_r = acceleration.scale_add(time, node.velocity - self.wind.at(height));
            self.write_rate(v_r, spin_rate.scale_add(time, node.spin), rate);
        }
        let [before, after] = shifted;
        let per_time = inlined!(|change: T| change * (0.5 / JERK_HALF_INTERVAL));
        Rate {
            acceleration: (after.acceleration - before.acceleration).map(per_time),
            speed: per_time(after.speed - before.speed),
        }
    }

    /// |ω| within a step at s = (t − t₀)/h (eq. 13). Without damping the value is exact. With
    /// damping, it is a Hermite polynomial of degree 5 through the spin and its first two
    /// derivatives at both ends of the step, which makes the spin C² over the flight.
    #[inline(always)]
    pub(super) fn spin_within(&self, [from, to]: [&StepNode<T>; 2], s: T) -> T {
        let Some(damping) = self.damping else {
            return T::not_inlined(inlined!(
                || from.spin * (-(self.decay * s * self.step)).exp()
            ));
        };
        let mut ends = [[s; 3]; 2];
        for (end, node) in ends.iter_mut().zip([from, to]) {
            *end = self.spin_and_derivatives(node, damping);
        }
        let [[p0, m0, c0], [p1, m1, c1]] = ends;
        // x, v, a: value and first two derivatives, at s = 1, of the spin minus the parabola
        // p0 + m0 s + c0 s²/2
        let x = p1 - p0 - m0 - c0 * 0.5;
        let v = m1 - m0 - c0;
        let a = c1 - c0;
        let third = x.scale_add(10.0, v.scale_add(-4.0, a * 0.5));
        let fourth = x.scale_add(-15.0, v.scale_add(7.0, -a));
        let fifth = x.scale_add(6.0, v.scale_add(-3.0, a * 0.5));
        p0 + (m0 + (c0 * 0.5 + (third + (fourth + fifth * s) * s) * s) * s) * s
    }

    /// The spin at a node with its first and second derivative by s.
    #[inline(always)]
    fn spin_and_derivatives(&self, node: &StepNode<T>, damping: T) -> [T; 3] {
        let (spin, h) = (node.spin, self.step);
        let decay_rate = damping.mul_add(node.rate.speed, self.decay);
        let decay_rate_change = damping * self.rate_per_time(node).speed;
        [
            spin,
            -(decay_rate * spin) * h,
            spin * (decay_rate * decay_rate - decay_rate_change) * (h * h),
        ]
    }
}
