use super::rk4::Node;
use crate::number::{Number, Vector};

/// A coordinate between two nodes as a quintic in s = (t − t₀)/h with the position, velocity and acceleration
/// of both ends. Neighbouring quintics join C², which is what makes carry C² in the parameters: a cubic (no
/// acceleration) is C¹ and its Hessian jumps where the number of steps changes; a shortened last step is only
/// C⁰.
#[derive(Clone, Copy)]
pub(super) struct Quintic<T>([T; 6]);

impl<T: Number> Quintic<T> {
    /// From position, velocity and acceleration at the start, the acceleration at the end, and what the step
    /// added: x₁ − x₀ − h v₀ and v₁ − v₀. These are the step's own small numbers; differences of the sums would
    /// lose their digits, and with them those of landing speed and Hessian.
    fn new(h: f64, [x0, v0, a0]: [T; 3], a1: T, [bent, gained]: [T; 2]) -> Self {
        let gained = gained * h;
        let (a0, a1) = (a0 * (h * h), a1 * (h * h));
        Self([
            x0,
            v0 * h,
            a0 * 0.5,
            bent * 10.0 - gained * 4.0 - a0 * 1.5 + a1 * 0.5,
            bent * -15.0 + gained * 7.0 + a0 * 1.5 - a1,
            bent * 6.0 - gained * 3.0 - (a0 - a1) * 0.5,
        ])
    }

    /// The coordinate at s.
    pub fn value(&self, s: T) -> T {
        let Self([c0, c1, c2, c3, c4, c5]) = *self;
        ((((c5 * s + c4) * s + c3) * s + c2) * s + c1) * s + c0
    }

    /// d/ds.
    pub fn slope(&self, s: T) -> T {
        let Self([_, c1, c2, c3, c4, c5]) = *self;
        (((c5 * s * 5.0 + c4 * 4.0) * s + c3 * 3.0) * s + c2 * 2.0) * s + c1
    }

    /// d²/ds².
    pub fn curvature(&self, s: T) -> T {
        let Self([_, _, c2, c3, c4, c5]) = *self;
        ((c5 * s * 20.0 + c4 * 12.0) * s + c3 * 6.0) * s + c2 * 2.0
    }

    fn re(&self) -> Quintic<f64> {
        Quintic(self.0.map(T::re))
    }

    /// Where the coordinate falls to `level`, between `from` (where it is above) and the end (where it is not).
    ///
    /// Found in plain numbers, then lifted: each Newton step in T makes one more order of derivatives exact
    /// (the implicit function theorem), and two serve gradient and Hessian.
    pub fn falls_to(&self, level: T, from: f64) -> T {
        let (plain, target) = (self.re(), level.re());
        let found = falling_root(from, |s| (plain.value(s) - target, plain.slope(s)));
        lifted(found, |s| (self.value(s) - level) / self.slope(s))
    }

    /// Where the coordinate, rising at the start and not at the end, is highest.
    pub fn top(&self) -> T {
        let plain = self.re();
        let found = falling_root(0.0, |s| (plain.slope(s), plain.curvature(s)));
        lifted(found, |s| self.slope(s) / self.curvature(s))
    }
}

fn lifted<T: Number>(found: f64, newton_step: impl Fn(T) -> T) -> T {
    let s = T::constant(found);
    let s = s - newton_step(s);
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
pub(super) struct Segment<T> {
    start: f64,
    h: f64,
    up: Quintic<T>,
    right: Quintic<T>,
    downrange: Quintic<T>,
}

impl<T: Number> Segment<T> {
    pub fn new(from: &Node<T>, to: &Node<T>, h: f64) -> Self {
        let quintic = |c: fn(Vector<T>) -> T| {
            let start = [c(from.position), c(from.velocity), c(from.rate.acceleration)];
            Quintic::new(h, start, c(to.rate.acceleration), to.added.map(c))
        };
        Self { start: from.time, h, up: quintic(|v| v.x), right: quintic(|v| v.y), downrange: quintic(|v| v.z) }
    }

    pub fn height(&self) -> &Quintic<T> {
        &self.up
    }

    pub fn time(&self, s: T) -> T {
        s * self.h + self.start
    }

    pub fn position(&self, s: T) -> Vector<T> {
        Vector::new(self.up.value(s), self.right.value(s), self.downrange.value(s))
    }

    pub fn velocity(&self, s: T) -> Vector<T> {
        let per_second = T::constant(1.0 / self.h);
        Vector::new(self.up.slope(s), self.right.slope(s), self.downrange.slope(s)) * per_second
    }
}

#[cfg(test)]
mod tests {
    use super::{Quintic, falling_root};
    use num_dual::{Dual2_64, DualStruct};

    #[test]
    fn exact_quintic_reproduces_its_ends() {
        let q = Quintic::new(0.5, [1.0, 2.0, 3.0], 6.0, [4.0 - 1.0 - 0.5 * 2.0, 5.0 - 2.0]);
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
