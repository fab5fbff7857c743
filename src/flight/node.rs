use super::motion::{Motion, Rate};
use super::pace::Pace;
use super::shot::Shot;
use super::space::Space;
use super::surroundings::Surroundings;
use crate::number::{Number, Numbers, Vector};

/// The ball at one time.
#[derive(Clone, Copy)]
pub(super) struct State<T, S> {
    pub time: f64,
    pub position: S,
    pub velocity: S,
    /// |ω₀| exp(−δ t): the spin, apart from damping.
    pub faded: T,
    /// Way through the air, m; followed only where the spin depends on it.
    pub air_path: T,
}

/// The ball at the end of a step, with what moves it there: the first stage of the next step and, for the
/// landing, the second derivative of the path.
#[derive(Clone, Copy)]
pub(super) struct Node<T, S, M = ()> {
    pub state: State<T, S>,
    pub rate: Rate<T, S>,
    /// What is kept of its spin for a later one.
    pub memory: M,
}

/// What a step added, in the sums it was made of: multiplied out at the apex and the landing alone.
#[derive(Clone, Copy)]
pub(super) struct Added<T, S> {
    /// x − x₀ − h v₀ over h `weight`, before the sum rounded it.
    pub bent: S,
    /// v − v₀ over `weight`, but for the last stage.
    pub gained: S,
    pub last: Rate<T, S>,
    pub weight: f64,
}

impl<T: Numbers, S: Space<T>> Added<T, S> {
    /// x − x₀ − h v₀ and v − v₀, as computed, before the sums rounded them.
    #[inline(always)]
    pub fn sums<L: Surroundings<T>>(&self, motion: &Motion<T, S, L>, h: f64) -> [S; 2] {
        let gained = self.gained + motion.acceleration(&self.last);
        [self.bent.scaled(h * self.weight), gained.scaled(self.weight)]
    }
}

/// A method that takes a flight from node to node with a fixed step.
pub(super) trait Stepper<T: Numbers, S: Space<T>, C>: Copy {
    /// The method at this pace.
    fn new<L: Surroundings<T, Constant = C>>(motion: &Motion<T, S, L>, pace: &Pace) -> Self;
    /// The node one step on, at `time`, and what the step added.
    fn step<L: Surroundings<T, Constant = C>>(
        &self,
        motion: &Motion<T, S, L>,
        from: &Node<T, S, L::Memory>,
        time: f64,
    ) -> (Node<T, S, L::Memory>, Added<T, S>);
}

impl<T: Numbers, S: Space<T>> State<T, S> {
    /// `self` in the lanes where the mask holds, `other` in those where it does not; the time is the former's.
    #[inline(always)]
    pub fn blend(&self, other: &Self, mask: T::Mask) -> Self {
        Self {
            time: self.time,
            position: self.position.blend(other.position, mask),
            velocity: self.velocity.blend(other.velocity, mask),
            faded: self.faded.blend(other.faded, mask),
            air_path: self.air_path.blend(other.air_path, mask),
        }
    }
}

impl<T: Numbers, S: Space<T>, M: Copy> Node<T, S, M> {
    /// The ball on the tee, leaving.
    #[inline(always)]
    pub fn at_launch<L: Surroundings<T, Memory = M>>(motion: &Motion<T, S, L>, shot: &Shot<T>) -> Self {
        let zero = T::zero();
        let position = S::of(Vector::new(zero, zero, zero));
        let velocity = S::of(shot.velocity);
        Self::at(motion, State { time: 0.0, position, velocity, faded: motion.spin, air_path: zero })
    }

    /// The ball in a state, with what moves it there.
    #[inline(always)]
    pub fn at<L: Surroundings<T, Memory = M>>(motion: &Motion<T, S, L>, state: State<T, S>) -> Self {
        let State { position, velocity, faded, air_path, .. } = state;
        let spin = motion.spin(
            faded,
            #[inline(always)]
            || air_path,
        );
        let rate = motion.rate(
            &spin,
            velocity,
            #[inline(always)]
            || position.up(),
        );
        Self { state, rate, memory: spin.memory }
    }

    /// What is below 1 where drag and lift change the airspeed by less than half of it within a step. Beyond is far
    /// from where four stages follow them, and near where they make the ball run away.
    #[inline(always)]
    pub fn coarseness(&self, h: f64) -> T {
        self.rate.pull.square_plus(0.0) * (4.0 * h * h)
    }
}

impl<T: Number, S: Space<T>, M> Node<T, S, M> {
    /// Whether its numbers have overflowed.
    #[inline(always)]
    pub fn is_lost(&self) -> bool {
        let size = self.state.position.square_plus(0.0).re() + self.state.velocity.square_plus(0.0).re();
        !size.is_finite()
    }
}
