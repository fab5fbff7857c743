use super::inputs::Inputs;
use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::number::{Numbers, Vector, inlined};

/// m/s: keeps |v_r| and its derivatives finite where the ball hangs still in the air.
const LEAST_SPEED: f64 = 1e-6;
/// Half of the interval of the central difference for the jerk, s. Truncation: 6.7e-9 s² d³a/dt³;
/// rounding: about 5e-12 m/s³.
const APART: f64 = 2e-4;

/// How a ball changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate<T> {
    /// dv/dt, m/s².
    pub acceleration: Vector<T>,
    /// |v_r|, the speed through the air, m/s: it damps the spin.
    pub speed: T,
}

impl<T: Numbers> Rate<T> {
    /// All zeros, before the first evaluation.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            acceleration: Vector::zero(),
            speed: T::zero(),
        }
    }
}

/// A ball at one time, a node of the integration: where it is, how it moves, how fast it spins
/// (about an axis that it keeps), and how that changes. x is up, y right and z downrange.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node<T> {
    /// m.
    pub position: Vector<T>,
    /// m/s.
    pub velocity: Vector<T>,
    /// |ω|, rad/s.
    pub spin: T,
    pub rate: Rate<T>,
}

impl<T: Numbers> Inputs<T> {
    /// The equation of motion of a ball with this velocity through the air, outside of the loop
    /// over the stages. Not inlined: there is one such copy for each number type. What it finds is
    /// written to its place, as a rate with many derivatives is long to copy.
    #[inline(always)]
    pub(super) fn find_rate(&self, air: Vector<T>, spin: T, rate: &mut Rate<T>) {
        T::outlined(inlined!(|| *rate = self.forces(air, spin)));
    }

    /// The equation of motion (docs/model.md, eqs. 12–15) of a ball with this velocity through the
    /// air. Inlined where a stage waits for it: a drive takes 2 to 10 % less.
    #[inline(always)]
    pub(super) fn forces(&self, air: Vector<T>, spin: T) -> Rate<T> {
        let least = T::constant(LEAST_SPEED * LEAST_SPEED);
        // summed in pairs: the next stage waits for it
        let square = air.x.mul_add(air.x, least) + air.y.mul_add(air.y, air.z * air.z);
        let (speed, _) = square.sqrt_recip();
        let Self {
            radius,
            reynolds_per_speed,
            ..
        } = *self;
        let stream = Stream {
            spin,
            speed,
            square,
            radius,
            reynolds_per_speed,
        };
        let c = self.law.coefficients(stream);
        // ρ A |v_r|/(2 m), 1/s
        let per_airspeed = self.force_per_mass * speed;
        // lift before drag, whose coefficient is ready last; the speed is multiplied in last, so
        // that laws by the spin alone do not wait for it
        let (across, against) = (self.axis.cross(air), -air);
        let pull = Vector::new(
            against.x.mul_add(c.drag, across.x * c.lift),
            against.y.mul_add(c.drag, across.y * c.lift),
            against.z.mul_add(c.drag, across.z * c.lift),
        );
        let acceleration = Vector::new(
            pull.x.mul_add(per_airspeed, -self.gravity),
            pull.y * per_airspeed,
            pull.z * per_airspeed,
        );
        Rate {
            acceleration,
            speed,
        }
    }

    /// The node where the flight begins.
    #[inline(always)]
    pub(super) fn launch(&self) -> Node<T> {
        let mut node = Node {
            position: Vector::zero(),
            velocity: self.velocity,
            spin: self.spin,
            rate: Rate::none(),
        };
        self.find_rate(
            self.velocity - self.wind.at(T::zero()),
            self.spin,
            &mut node.rate,
        );
        node
    }

    /// How the rate at a node changes with time, d²v/dt² and d|v_r|/dt: the central difference of
    /// the equation of motion along the path. It is a smooth function of the node alone, so that
    /// the paths of neighbouring steps join; over a dual number in time it would be twice the code
    /// of a flight.
    #[inline(always)]
    pub(super) fn rate_per_time(&self, node: &Node<T>) -> Rate<T> {
        let Node {
            position,
            velocity,
            spin,
            rate: Rate {
                acceleration,
                speed,
            },
        } = *node;
        let decay_rate = match self.damping {
            None => self.decay,
            Some(damping) => damping.mul_add(speed, self.decay),
        };
        let spin_rate = -(decay_rate * spin);
        // a loop, so that there is one call site
        let mut beside = [node.rate; 2];
        for (there, time) in beside.iter_mut().zip([-APART, APART]) {
            let wind = self.wind.at(velocity.x.scale_add(time, position.x));
            self.find_rate(
                acceleration.scale_add(time, velocity - wind),
                spin_rate.scale_add(time, spin),
                there,
            );
        }
        let per_time = inlined!(|change: T| change * (0.5 / APART));
        Rate {
            acceleration: (beside[1].acceleration - beside[0].acceleration).map(per_time),
            speed: per_time(beside[1].speed - beside[0].speed),
        }
    }
}
