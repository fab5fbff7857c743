use super::inputs::Inputs;
use super::step::Step;
use crate::number::{Mask, Numbers, Vector, inlined};

/// One coordinate within a step as a polynomial of degree 7 in s = (t − t₀)/h, with the position,
/// velocity, acceleration and jerk of both ends. Neighbouring ones join C³: velocity at landing is
/// C² in the parameters, whatever the number of steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Septic<T>([T; 8]);

/// k!/(k − m)!: the factor of s^(k − m) in derivative m.
const FACTORS: [[f64; 8]; 3] = [
    [1.0; 8],
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0],
    [0.0, 0.0, 2.0, 6.0, 12.0, 20.0, 30.0, 42.0],
];

impl<T: Numbers> Septic<T> {
    /// From the position, velocity, acceleration and jerk at both ends of a step, of which `of`
    /// takes this coordinate. Ends enter by what the step added: differences of the sums would lose
    /// their digits.
    #[inline(always)]
    fn new(
        step: &Step<'_, T>,
        jerks: &[Vector<T>; 2],
        h: f64,
        of: impl Fn(&Vector<T>) -> T,
    ) -> Self {
        let (h2, h3) = (h * h, h * h * h);
        let [a0, a1] = [
            of(&step.from.rate.acceleration) * h2,
            of(&step.to.rate.acceleration) * h2,
        ];
        let [j0, j1] = [of(&jerks[0]) * h3, of(&jerks[1]) * h3];
        // what the cubic from the start leaves over at the end
        let (half, sixth) = (a0 * 0.5, j0 * (1.0 / 6.0));
        let x = of(&step.deflection) - half - sixth;
        let v = of(&step.gained) * h - a0 - j0 * 0.5;
        let a = a1 - a0 - j0;
        let j = j1 - j0;
        let sum =
            inlined!(|[wx, wv, wa, wj]: [f64; 4]| x
                .scale_add(wx, v.scale_add(wv, a.scale_add(wa, j * wj))));
        Self([
            of(&step.from.position),
            of(&step.from.velocity) * h,
            half,
            sixth,
            sum([35.0, -15.0, 2.5, -1.0 / 6.0]),
            sum([-84.0, 39.0, -7.0, 0.5]),
            sum([70.0, -34.0, 6.5, -0.5]),
            sum([-20.0, 10.0, -2.0, 1.0 / 6.0]),
        ])
    }

    /// The `ORDER`-th derivative by s.
    #[inline(always)]
    fn derivative<const ORDER: usize>(&self, s: T) -> T {
        let mut value = self.0[7] * FACTORS[ORDER][7];
        let mut k = 7;
        while k > ORDER {
            k -= 1;
            value = value.mul_add(s, self.0[k] * FACTORS[ORDER][k]);
        }
        value
    }

    /// The coordinate at s.
    #[inline(always)]
    pub fn value(&self, s: T) -> T {
        self.derivative::<0>(s)
    }

    /// d/ds.
    #[inline(always)]
    pub fn slope(&self, s: T) -> T {
        self.derivative::<1>(s)
    }

    /// d²/ds².
    #[inline(always)]
    pub fn bend(&self, s: T) -> T {
        self.derivative::<2>(s)
    }

    /// Where the coordinate falls to `level`, between `from` (where it is above) and the end (where
    /// it is not), in the lanes of a mask.
    #[inline(always)]
    pub fn falls_to(&self, level: T, from: T, lanes: T::Mask) -> T {
        falling_root(
            from,
            lanes,
            inlined!(|s| (self.value(s) - level, self.slope(s))),
        )
    }

    /// Where the coordinate, rising at the start and not at the end, is highest, in the lanes of a
    /// mask.
    #[inline(always)]
    pub fn top(&self, lanes: T::Mask) -> T {
        falling_root(
            T::zero(),
            lanes,
            inlined!(|s| (self.slope(s), self.bend(s))),
        )
    }
}

/// The root in [low, 1] of a function that is positive at `low` and not at 1, given with its slope:
/// Newton's method kept inside a bracket. It goes without derivatives until the value has settled.
/// Of the two steps that follow with them, the first makes first derivatives exact, the second also
/// second ones (the implicit function theorem). A root that does not settle has no derivatives.
#[inline(always)]
fn falling_root<T: Numbers>(low: T, lanes: T::Mask, f: impl Fn(T) -> (T, T)) -> T {
    // bisection alone needs 53
    const MOST_STEPS: usize = 60;
    const DERIVATIVE_STEPS: usize = 2;
    let (mut low, mut high) = (low.without_derivatives(), T::constant(1.0));
    let mut s = high;
    let (mut steps_left, mut is_settled) = (MOST_STEPS, false);
    while steps_left > 0 {
        steps_left -= 1;
        let (value, slope) = f(s);
        let newton = s - value / slope;
        if is_settled {
            s = newton;
            continue;
        }
        let newton = newton.without_derivatives();
        let is_before = (-value).below(0.0);
        low = s.blend(low, is_before);
        high = high.blend(s, is_before);
        let is_inside = (low - newton).below(0.0) & (newton - high).below(0.0);
        // where Newton's method has settled, its last step may leave the bracket by rounding
        let is_short = inlined!(|step: T| (step * step).below(1e-18));
        let next = newton.blend((low + high) * 0.5, is_inside | is_short(newton - s));
        if !(lanes & !is_short(next - s)).any() {
            (steps_left, is_settled) = (DERIVATIVE_STEPS, true);
        }
        s = next;
    }
    s
}

/// The path of a step.
pub(super) struct Path<T> {
    h: f64,
    pub up: Septic<T>,
    right: Septic<T>,
    downrange: Septic<T>,
}

impl<T: Numbers> Path<T> {
    /// The path of a step.
    #[inline(always)]
    pub fn new(inputs: &Inputs<T>, step: &Step<'_, T>, h: f64) -> Self {
        // a loop, so that there is one call site
        let mut jerks = [step.gained; 2];
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

    /// The position at s.
    #[inline(always)]
    pub fn position(&self, s: T) -> Vector<T> {
        Vector::new(
            self.up.value(s),
            self.right.value(s),
            self.downrange.value(s),
        )
    }

    /// The velocity at s.
    #[inline(always)]
    pub fn velocity(&self, s: T) -> Vector<T> {
        let per_time = 1.0 / self.h;
        Vector::new(
            self.up.slope(s) * per_time,
            self.right.slope(s) * per_time,
            self.downrange.slope(s) * per_time,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::falling_root;
    use std::cell::Cell;

    /// Newton's method from s = 1 converges quadratically for these cubics: in eight steps at most,
    /// and the two with derivatives.
    #[test]
    fn exact_roots_in_the_number_of_steps_of_newtons_method() {
        for i in 1..1000 {
            let (root, bend) = (f64::from(i) * 1e-3, f64::from(i % 7));
            let steps = Cell::new(0);
            let found = falling_root(0.0, true, |s| {
                steps.set(steps.get() + 1);
                (
                    root - s + bend * (root.powi(3) - s.powi(3)),
                    -1.0 - 3.0 * bend * s * s,
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
