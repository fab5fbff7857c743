//! Path within a step: a polynomial of degree 7 in each coordinate (docs/model.md, eq. 17), its
//! crossing of a height and its maximum (eq. 18).

use super::inputs::Inputs;
use super::step::Step;
use crate::aerodynamics::AerodynamicLaw;
use crate::number::{Mask, Numbers, Vector, inlined};

/// Hermite polynomial of degree 7 of one coordinate within a step, in s = (t − t₀)/h, through
/// position, velocity, acceleration and jerk at both ends. The path of several steps is therefore
/// C³, and the velocity at landing is C² in the parameters even where the number of steps changes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Septic<T>([T; 8]);

/// k!/(k − m)! for m from 0 to 2 and k from 0 to 7: factor of s^(k − m) in the m-th derivative of
/// sᵏ.
const FACTORS: [[f64; 8]; 3] = [
    [1.0; 8],
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0],
    [0.0, 0.0, 2.0, 6.0, 12.0, 20.0, 30.0, 42.0],
];

impl<T: Numbers> Septic<T> {
    /// Builds the polynomial of the coordinate that `coordinate` selects. The increments of
    /// position and velocity over the step are read from `step`: differences of the positions or
    /// velocities at both ends would lose digits by cancellation.
    #[inline(always)]
    fn new(
        step: &Step<'_, T>,
        jerks: &[Vector<T>; 2],
        h: f64,
        coordinate: impl Fn(&Vector<T>) -> T,
    ) -> Self {
        let (h2, h3) = (h * h, h * h * h);
        let [a0, a1] = [
            coordinate(&step.from.rate.acceleration) * h2,
            coordinate(&step.to.rate.acceleration) * h2,
        ];
        let [j0, j1] = [coordinate(&jerks[0]) * h3, coordinate(&jerks[1]) * h3];
        // x, v, a, j: value and first three derivatives by s, at s = 1, of the coordinate minus its
        // Taylor cubic at the start of the step
        let (half, sixth) = (a0 * 0.5, j0 * (1.0 / 6.0));
        let x = coordinate(&step.position_increment) - half - sixth;
        let v = coordinate(&step.velocity_increment) * h - a0 - j0 * 0.5;
        let a = a1 - a0 - j0;
        let j = j1 - j0;
        let sum =
            inlined!(|[wx, wv, wa, wj]: [f64; 4]| x
                .scale_add(wx, v.scale_add(wv, a.scale_add(wa, j * wj))));
        Self([
            coordinate(&step.from.position),
            coordinate(&step.from.velocity) * h,
            half,
            sixth,
            sum([35.0, -15.0, 2.5, -1.0 / 6.0]),
            sum([-84.0, 39.0, -7.0, 0.5]),
            sum([70.0, -34.0, 6.5, -0.5]),
            sum([-20.0, 10.0, -2.0, 1.0 / 6.0]),
        ])
    }

    /// The derivative of order `ORDER` by s.
    #[inline(always)]
    fn derivative_of_order<const ORDER: usize>(&self, s: T) -> T {
        let mut value = self.0[7] * FACTORS[ORDER][7];
        let mut k = 7;
        while k > ORDER {
            k -= 1;
            value = value.mul_add(s, self.0[k] * FACTORS[ORDER][k]);
        }
        value
    }

    /// Value at s.
    #[inline(always)]
    pub fn value(&self, s: T) -> T {
        self.derivative_of_order::<0>(s)
    }

    /// First derivative by s.
    #[inline(always)]
    pub fn derivative(&self, s: T) -> T {
        self.derivative_of_order::<1>(s)
    }

    /// Second derivative by s.
    #[inline(always)]
    pub fn second_derivative(&self, s: T) -> T {
        self.derivative_of_order::<2>(s)
    }

    /// The position s within the step at which the coordinate falls to `level`, in `lanes`. The
    /// coordinate must be above `level` at s = `from`, and at or below `level` at the end of the
    /// step.
    #[inline(always)]
    pub fn find_crossing(&self, level: T, from: T, lanes: T::Mask) -> T {
        falling_root(
            from,
            lanes,
            inlined!(|s| (self.value(s) - level, self.derivative(s))),
        )
    }

    /// The position s within the step at which the coordinate has its maximum, in `lanes`. The
    /// coordinate must rise at the start of the step, and must not rise at the end.
    #[inline(always)]
    pub fn find_maximum(&self, lanes: T::Mask) -> T {
        falling_root(
            T::zero(),
            lanes,
            inlined!(|s| (self.derivative(s), self.second_derivative(s))),
        )
    }
}

/// Root in [low, 1] of a function that is positive at `low` and not positive at 1; `f` returns its
/// value and derivative. Newton's method first runs without derivatives of the root. A Newton step
/// out of the bracket is replaced by a bisection. After convergence, two more Newton steps add the
/// derivatives: the first makes first derivatives exact, the second also second derivatives
/// (implicit function theorem). Without convergence, the root has no derivatives.
#[inline(always)]
fn falling_root<T: Numbers>(low: T, lanes: T::Mask, f: impl Fn(T) -> (T, T)) -> T {
    // bisection alone needs 53 steps
    const MOST_STEPS: usize = 60;
    const DERIVATIVE_STEPS: usize = 2;
    let (mut low, mut high) = (low.without_derivatives(), T::constant(1.0));
    let mut s = high;
    let (mut steps_left, mut has_converged) = (MOST_STEPS, false);
    while steps_left > 0 {
        steps_left -= 1;
        let (value, derivative) = f(s);
        let newton = s - value / derivative;
        if has_converged {
            s = newton;
            continue;
        }
        let newton = newton.without_derivatives();
        let is_before = (-value).below(0.0);
        low = s.select(low, is_before);
        high = high.select(s, is_before);
        let is_inside = (low - newton).below(0.0) & (newton - high).below(0.0);
        // after convergence, rounding may put the last Newton step outside of the bracket
        let is_short = inlined!(|step: T| (step * step).below(1e-18));
        let next = newton.select((low + high) * 0.5, is_inside | is_short(newton - s));
        if !(lanes & !is_short(next - s)).any() {
            (steps_left, has_converged) = (DERIVATIVE_STEPS, true);
        }
        s = next;
    }
    s
}

/// Path of the ball within a step.
pub(super) struct StepPath<T> {
    /// Step, s.
    h: f64,
    pub up: Septic<T>,
    right: Septic<T>,
    downrange: Septic<T>,
}

impl<T: Numbers> StepPath<T> {
    /// The path within a step.
    #[inline(always)]
    pub fn new<L: AerodynamicLaw<T>>(inputs: &Inputs<T, L>, step: &Step<'_, T>) -> Self {
        let h = inputs.step;
        // a loop instead of two calls: the equation of motion is inlined only once
        let mut jerks = [step.velocity_increment; 2];
        for (jerk, node) in jerks.iter_mut().zip([&*step.from, &*step.to]) {
            *jerk = inputs.rate_per_time(node).acceleration;
        }
        Self {
            h,
            up: Septic::new(step, &jerks, h, inlined!(|v: &Vector<T>| v.x)),
            right: Septic::new(step, &jerks, h, inlined!(|v: &Vector<T>| v.y)),
            downrange: Septic::new(step, &jerks, h, inlined!(|v: &Vector<T>| v.z)),
        }
    }

    /// Position at s, m.
    #[inline(always)]
    pub fn position(&self, s: T) -> Vector<T> {
        Vector::new(
            self.up.value(s),
            self.right.value(s),
            self.downrange.value(s),
        )
    }

    /// Velocity at s, m/s.
    #[inline(always)]
    pub fn velocity(&self, s: T) -> Vector<T> {
        let per_time = 1.0 / self.h;
        Vector::new(
            self.up.derivative(s) * per_time,
            self.right.derivative(s) * per_time,
            self.downrange.derivative(s) * per_time,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::falling_root;
    use std::cell::Cell;

    /// Newton's method from s = 1 converges quadratically for these cubics: at most eight steps in
    /// values and two with derivatives.
    #[test]
    fn exact_roots_in_the_number_of_steps_of_newtons_method() {
        for i in 1..1000 {
            let (root, cubic) = (f64::from(i) * 1e-3, f64::from(i % 7));
            let steps = Cell::new(0);
            let found = falling_root(0.0, true, |s| {
                steps.set(steps.get() + 1);
                (
                    root - s + cubic * (root.powi(3) - s.powi(3)),
                    -1.0 - 3.0 * cubic * s * s,
                )
            });
            assert!(
                (found - root).abs() < 1e-15 && steps.get() <= 10,
                "{found} in {} steps",
                steps.get()
            );
        }
    }
}
