use super::motion::Motion;
use super::node::{Added, Node};
use super::space::{Linear, Space};
use super::surroundings::Surroundings;
use crate::number::{Number, Numbers, Vector, inlined};

/// A coordinate, or all of them, between two nodes as a quintic in s = (t − t₀)/h with the position, velocity and
/// acceleration of both ends. Neighbouring quintics join C², which is what makes carry C² in the parameters: a cubic (no
/// acceleration) is C¹ and its Hessian jumps where the number of steps changes; a shortened last step is only
/// C⁰.
#[derive(Clone, Copy)]
pub(super) struct Quintic<C>([C; 6]);

impl<C: Copy> Quintic<C> {
    /// From position, velocity and acceleration at the start, the acceleration at the end, and what the step
    /// added: x₁ − x₀ − h v₀ and v₁ − v₀. These are the step's own small numbers; differences of the sums would
    /// lose their digits, and with them those of landing speed and Hessian.
    #[inline(always)]
    fn new<T>(h: f64, [x0, v0, a0]: [C; 3], a1: C, [bent, gained]: [C; 2]) -> Self
    where
        C: Linear<T>,
    {
        let gained = gained.scaled(h);
        let (a0, a1) = (a0.scaled(h * h), a1.scaled(h * h));
        let half = inlined(
            #[inline(always)]
            |a: C| a.scaled(0.5),
        );
        Self([
            x0,
            v0.scaled(h),
            half(a0),
            gained.along(-4.0, a0.along(-1.5, bent.along(10.0, half(a1)))),
            gained.along(7.0, a0.along(1.5, bent.scaled(-15.0) - a1)),
            gained.along(-3.0, bent.along(6.0, half(a1 - a0))),
        ])
    }

    /// The coordinate at s.
    #[inline(always)]
    pub fn value<T: Copy>(&self, s: T) -> C
    where
        C: Linear<T>,
    {
        let Self([c0, c1, c2, c3, c4, c5]) = *self;
        c5.times_plus(s, c4).times_plus(s, c3).times_plus(s, c2).times_plus(s, c1).times_plus(s, c0)
    }

    /// d/ds.
    #[inline(always)]
    pub fn slope<T: Copy>(&self, s: T) -> C
    where
        C: Linear<T>,
    {
        let Self([_, c1, c2, c3, c4, c5]) = *self;
        let upper = c5.scaled(5.0).times_plus(s, c4.scaled(4.0)).times_plus(s, c3.scaled(3.0));
        upper.times_plus(s, c2.scaled(2.0)).times_plus(s, c1)
    }

    /// d²/ds².
    #[inline(always)]
    pub fn curvature<T: Copy>(&self, s: T) -> C
    where
        C: Linear<T>,
    {
        let Self([_, _, c2, c3, c4, c5]) = *self;
        let upper = c5.scaled(20.0).times_plus(s, c4.scaled(12.0));
        upper.times_plus(s, c3.scaled(6.0)).times_plus(s, c2.scaled(2.0))
    }
}

impl<T: Number> Quintic<T> {
    #[inline(always)]
    fn re(&self) -> Quintic<f64> {
        Quintic(self.0.map(T::re))
    }

    /// Where the coordinate falls to `level`, between `from` (where it is above) and the end (where it is not).
    ///
    /// Found in plain numbers, then lifted: each Newton step in T makes one more order of derivatives exact
    /// (the implicit function theorem), and two serve gradient and Hessian.
    #[inline(always)]
    pub fn falls_to(&self, level: T, from: f64) -> T {
        let (plain, target) = (self.re(), level.re());
        let found = falling_root(
            from,
            #[inline(always)]
            |s| (plain.value(s) - target, plain.slope(s)),
        );
        self.lifted_fall(level, T::constant(found))
    }

    /// Where the coordinate, rising at the start and not at the end, is highest.
    #[inline(always)]
    pub fn top(&self) -> T {
        let plain = self.re();
        let found = falling_root(
            0.0,
            #[inline(always)]
            |s| (plain.slope(s), plain.curvature(s)),
        );
        self.lifted_top(T::constant(found))
    }
}

impl<T: Numbers> Quintic<T> {
    /// The fall to a level from where it is known without derivatives.
    #[inline(always)]
    pub fn lifted_fall(&self, level: T, found: T) -> T {
        lifted(
            found,
            #[inline(always)]
            |s| (self.value(s) - level) / self.slope(s),
        )
    }

    /// The top from where it is known without derivatives.
    #[inline(always)]
    pub fn lifted_top(&self, found: T) -> T {
        lifted(
            found,
            #[inline(always)]
            |s| self.slope(s) / self.curvature(s),
        )
    }
}

#[inline(always)]
fn lifted<T: Numbers>(found: T, newton_step: impl Fn(T) -> T) -> T {
    let s = found - newton_step(found);
    s - newton_step(s)
}

/// The root in [low, 1] of a function that is positive at `low` and not at 1, given with its slope: Newton's
/// method kept inside a bracket.
fn falling_root(mut low: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut high = 1.0;
    let mut s = high;
    // bisection alone needs 53
    for _ in 0..100 {
        let (value, slope) = f(s);
        if value == 0.0 {
            break;
        }
        if value > 0.0 {
            low = s
        } else {
            high = s
        }
        let newton = s - value / slope;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= f64::EPSILON {
            return next;
        }
        s = next;
    }
    s
}

/// The path between two nodes.
pub(super) struct Segment<S> {
    start: f64,
    h: f64,
    path: Quintic<S>,
}

impl<S: Copy> Segment<S> {
    /// The path of the step that leads from one node to the other.
    #[inline(always)]
    pub fn new<T: Numbers, L: Surroundings<T>>(
        motion: &Motion<T, S, L>,
        from: &Node<T, S, L::Memory>,
        to: &Node<T, S, L::Memory>,
        added: &Added<T, S>,
        h: f64,
    ) -> Self
    where
        S: Space<T>,
    {
        let start = [from.state.position, from.state.velocity, motion.acceleration(&from.rate)];
        let path = Quintic::new::<T>(h, start, motion.acceleration(&to.rate), added.sums(motion, h));
        Self { start: from.state.time, h, path }
    }

    #[inline(always)]
    pub fn height<T: Numbers>(&self) -> Quintic<T>
    where
        S: Space<T>,
    {
        Quintic(self.path.0.map(S::up))
    }

    #[inline(always)]
    pub fn time<T: Numbers>(&self, s: T) -> T {
        s * self.h + self.start
    }

    #[inline(always)]
    pub fn position<T: Numbers>(&self, s: T) -> Vector<T>
    where
        S: Space<T>,
    {
        self.path.value(s).in_space()
    }

    #[inline(always)]
    pub fn velocity<T: Numbers>(&self, s: T) -> Vector<T>
    where
        S: Space<T>,
    {
        self.path.slope(s).scaled(1.0 / self.h).in_space()
    }
}

#[cfg(test)]
mod tests {
    use super::{Quintic, falling_root};
    use num_dual::{Dual2_64, DualStruct};

    #[test]
    fn exact_quintic_reproduces_its_ends() {
        let q = Quintic::new::<f64>(0.5, [1.0, 2.0, 3.0], 6.0, [4.0 - 1.0 - 0.5 * 2.0, 5.0 - 2.0]);
        for (s, [x, v, a]) in [(0.0_f64, [1.0_f64, 2.0, 3.0]), (1.0, [4.0, 5.0, 6.0])] {
            let ends: [f64; 3] = [q.value(s), q.slope(s) / 0.5, q.curvature(s) / 0.25];
            for (got, expected) in ends.iter().zip([x, v, a]) {
                assert!((got - expected).abs() < 1e-13, "{ends:?}");
            }
        }
    }

    #[test]
    fn exact_derivatives_of_a_root_come_from_the_implicit_function() {
        // p − s² falls to 0 at s = √p: s′ = 1/(2√p), s″ = −1/(4 p√p)
        let p = Dual2_64::from(0.49).derivative();
        let zero = Dual2_64::from(0.0);
        let q = Quintic([p, zero, Dual2_64::from(-1.0), zero, zero, zero]);
        let s = q.falls_to(zero, 0.0);
        assert!((s.re() - 0.7).abs() < 1e-15);
        assert!((s.v1 - 1.0 / 1.4).abs() < 1e-15 && (s.v2 + 1.0 / (4.0 * 0.343)).abs() < 1e-14);
    }

    #[test]
    fn roots_are_found_where_newton_alone_would_leave_the_bracket() {
        let s = falling_root(0.0, |s| ((0.3 - s).cbrt(), -(0.3 - s).cbrt().powi(-2) / 3.0));
        assert!((s - 0.3).abs() < 1e-15);
    }
}
