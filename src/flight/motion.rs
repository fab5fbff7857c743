use super::inputs::Inputs;
use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::number::{Jet, Numbers, Vector, inlined};

/// m/s: keeps |v_r| and its derivatives finite where the ball hangs still in the air.
pub(super) const LEAST_SPEED: f64 = 1e-6;

/// The ball at one time: where it is, how it moves and how fast it spins (about an axis that it keeps).
#[derive(Clone, Copy, Debug)]
pub(crate) struct State<T> {
    /// m.
    pub position: Vector<T>,
    /// m/s.
    pub velocity: Vector<T>,
    /// |ω|, rad/s.
    pub spin: T,
}

/// How the state changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate<T> {
    /// dv/dt, m/s².
    pub acceleration: Vector<T>,
    /// |v_r|, the speed through the air, m/s: it damps the spin.
    pub speed: T,
}

/// A ball in a state, with how it changes there: a node of the integration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node<T> {
    pub state: State<T>,
    pub rate: Rate<T>,
}

impl<T: Numbers> Inputs<T> {
    /// The equation of motion (docs/model.md, eqs. 12–15).
    #[inline(always)]
    pub(super) fn rate(&self, velocity: Vector<T>, spin: T, height: T) -> Rate<T> {
        let air = velocity - self.wind.at(height);
        let (speed, per_speed) = (air.dot(air) + LEAST_SPEED * LEAST_SPEED).sqrt_recip();
        let stream = Stream {
            spin,
            spin_ratio: self.radius * spin * per_speed,
            speed,
            reynolds: self.reynolds_per_speed * speed,
        };
        let c = self.law.coefficients(&stream);
        let force = self.force_per_mass * speed;
        let (drag, lift) = (-(force * c.drag), self.axis * (force * c.lift));
        // drag is what is known last
        let acceleration = Vector::new(
            air.x.mul_add(drag, air.z.mul_add(lift.y, -air.y.mul_add(lift.z, self.gravity))),
            air.y.mul_add(drag, air.x.mul_add(lift.z, -(air.z * lift.x))),
            air.z.mul_add(drag, air.y.mul_add(lift.x, -(air.x * lift.y))),
        );
        Rate { acceleration, speed }
    }

    /// The node of a state.
    #[inline(always)]
    pub(super) fn node(&self, state: State<T>) -> Node<T> {
        Node { state, rate: self.rate(state.velocity, state.spin, state.position.x) }
    }

    /// d²v/dt² at a node: the equation of motion over a dual number whose direction is time.
    #[inline(always)]
    pub(super) fn jerk(&self, node: &Node<T>) -> Vector<T> {
        let Node { state, rate } = node;
        let in_time = inlined(
            #[inline(always)]
            |value: T, slope: T| Jet::<1, T> { re: value, gradient: [slope] },
        );
        let (v, a) = (state.velocity, rate.acceleration);
        let velocity = Vector::new(in_time(v.x, a.x), in_time(v.y, a.y), in_time(v.z, a.z));
        let fading = match self.damping {
            None => self.decay,
            Some(damping) => damping.mul_add(rate.speed, self.decay),
        };
        let spin = in_time(state.spin, -(fading * state.spin));
        let constant = self.map(
            #[inline(always)]
            |value| in_time(value, T::zero()),
        );
        let rate = constant.rate(velocity, spin, in_time(state.position.x, v.x));
        rate.acceleration.map(
            #[inline(always)]
            |a| a.gradient[0],
        )
    }
}
