use super::estimate::{DerivativeEstimate, DifferenceQuotient, Side, estimate};

/// Values of k for the steps of a ladder. A step is 10^(-k/2) times the scale: from 1e-1 down to
/// 1e-13, two steps per decade.
pub const STEP_EXPONENTS: std::ops::RangeInclusive<i32> = 2..=26;

/// Values of k for expensive functions: steps from 1e-1 to 1e-5, and three small steps that measure
/// the rounding error.
pub const FEW_STEP_EXPONENTS: [i32; 12] = [2, 3, 4, 5, 6, 7, 8, 9, 10, 19, 20, 21];

/// Smallest step used in an extrapolation, relative to the scale. Features of a function within a
/// smaller interval, such as a rounded kink, are not resolved.
pub(super) const LEAST_STEP: f64 = 1e-6;

/// Smallest assumed size of a function, as a fraction of [`Ladder::rounding_size`]. If it were
/// smaller, the rounding error could exceed the largest tolerance of
/// [`Demand::FIRST`](super::Demand::FIRST).
const LEAST_RELATIVE_SIZE: f64 = 1e-5;

/// Range of steps, relative to the scale. These steps are so small that second differences consist
/// of rounding errors only.
const ROUNDING_ONLY: std::ops::Range<f64> = 1e-12..2e-9;

/// One step of a ladder with the function values on both sides. A value is `None` where the
/// function is undefined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rung {
    /// The step h.
    pub step: f64,
    /// f(x − h).
    pub below: Option<f64>,
    /// f(x + h).
    pub above: Option<f64>,
}

/// A function of one variable, sampled around a point at falling steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Ladder {
    /// Scale of the variable, the unit of the steps.
    pub scale: f64,
    /// f(x).
    pub centre: f64,
    /// Assumed size of f, at least |f(x)|.
    pub size: f64,
    /// Size of the terms in the formula of f, at least [`size`](Self::size). The rounding error of
    /// f is relative to this size.
    pub rounding_size: f64,
    /// Samples, the largest step first.
    pub rungs: Vec<Rung>,
}

impl Ladder {
    /// Samples several functions at once around `at`, at the steps 10^(-k/2) of the scale for each
    /// k of `steps` ([`STEP_EXPONENTS`] or [`FEW_STEP_EXPONENTS`]). Values that are missing or not
    /// finite become `None`.
    pub fn sample(
        at: f64,
        scale: f64,
        steps: impl IntoIterator<Item = i32>,
        f: &mut dyn FnMut(f64) -> Vec<f64>,
    ) -> Vec<Self> {
        let blank = |centre: f64| Self {
            scale,
            centre,
            size: centre.abs(),
            rounding_size: centre.abs(),
            rungs: vec![],
        };
        let mut ladders: Vec<Self> = f(at).into_iter().map(blank).collect();
        for k in steps {
            // the distance from `at` to the number nearest to `at + h`
            let step = (at + scale * 10.0_f64.powf(-0.5 * f64::from(k))) - at;
            if step <= 0.0 {
                break;
            }
            let [below, above] = [f(at - step), f(at + step)];
            let finite =
                |values: &[f64], i: usize| values.get(i).copied().filter(|value| value.is_finite());
            for (i, ladder) in ladders.iter_mut().enumerate() {
                ladder.rungs.push(Rung {
                    step,
                    below: finite(&below, i),
                    above: finite(&above, i),
                });
            }
        }
        ladders
    }

    /// Raises the assumed size of the function, and the size that determines its rounding, to at
    /// least `size`.
    #[must_use]
    pub fn with_least_size(self, size: f64) -> Self {
        Self {
            size: self.size.max(size),
            ..self
        }
        .with_rounding_size(size)
    }

    /// For a function that is a small difference of large numbers, such as spins that cancel:
    /// `size` is the size of these numbers, which determines the rounding error. The assumed size
    /// of the function becomes at least 1e-5 times `size`.
    #[must_use]
    pub fn with_rounding_size(self, size: f64) -> Self {
        Self {
            size: self.size.max(LEAST_RELATIVE_SIZE * size),
            rounding_size: self.rounding_size.max(size),
            ..self
        }
    }

    /// Rounding error of the function at the centre: half the largest second difference over steps
    /// so small that curvature has no effect. At the end of the variable's range, the second
    /// difference uses two steps on one side.
    pub fn rounding(&self) -> f64 {
        let small: Vec<&Rung> = self
            .rungs
            .iter()
            .filter(|rung| ROUNDING_ONLY.contains(&(rung.step / self.scale)))
            .collect();
        let central =
            |rung: &&Rung| Some((rung.above? + rung.below? - 2.0 * self.centre).abs() / 2.0);
        let one_sided = |pair: &[&Rung]| {
            let [long, short] = [pair[0], pair[1]];
            let ratio = long.step / short.step;
            let rise = |rung: &Rung| match (rung.above, rung.below) {
                (Some(value), None) | (None, Some(value)) => Some(value - self.centre),
                _ => None,
            };
            Some((rise(long)? - ratio * rise(short)?).abs() / (1.0 + ratio))
        };
        let second = small
            .iter()
            .filter_map(central)
            .chain(small.windows(2).filter_map(one_sided));
        second.fold(rounding_of(self.centre), f64::max)
    }

    /// Difference quotient at a step.
    pub(super) fn difference(&self, rung: &Rung, side: Side) -> Option<f64> {
        match side {
            Side::Both => Some((rung.above? - rung.below?) / (2.0 * rung.step)),
            Side::Above => Some((rung.above? - self.centre) / rung.step),
            Side::Below => Some((self.centre - rung.below?) / rung.step),
        }
    }

    /// Derivative from the differences on `side`, extrapolated to step 0. Larger steps are used
    /// only if small steps do not reach the uncertainty `enough`. `None` if there are too few
    /// values.
    pub fn slope(&self, side: Side, enough: f64) -> Option<DerivativeEstimate> {
        let is_wide = |rung: &&Rung| rung.step >= 0.999 * LEAST_STEP * self.scale;
        let rounding = self.rounding();
        let difference = |rung: &Rung| {
            let value = self.difference(rung, side)?;
            let largest = [rung.below, rung.above]
                .into_iter()
                .flatten()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            // a difference has the rounding errors of two values; a central difference divides them
            // by 2h, a one-sided difference by h
            let share = if side == Side::Both { 1.0 } else { 2.0 };
            Some(DifferenceQuotient {
                step: rung.step,
                value,
                rounding: share * rounding.max(rounding_of(largest)) / rung.step,
            })
        };
        estimate(
            &self
                .rungs
                .iter()
                .filter(is_wide)
                .map(difference)
                .collect::<Vec<_>>(),
            side,
            enough,
        )
    }
}

/// Minimum rounding error of a value: 4 machine epsilons.
pub(super) fn rounding_of(value: f64) -> f64 {
    4.0 * f64::EPSILON * value.abs()
}
