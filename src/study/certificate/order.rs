//! The order at which errors fall with the time step, and whether it is the one expected.
//!
//! ```text
//!   e(h) = d h^(p−1) + a h^p + b h^(p+1) + …        d must be 0
//! ```
//!
//! The slope of log |e| alone does not tell: where a and b h have opposite signs e passes through 0
//! at some step, and at the steps below it falls more slowly than h^p; what is read off one time
//! step (the apex) has factors that change with where in that step it lies. So the term of the
//! lower order is fitted to the errors with their signs, and must be as good as none.

use crate::derivative::check::line_slope;
use nalgebra::{DMatrix, DVector};

/// An order is measured over at least so many levels of steps.
pub(super) const MEASURED: usize = 3;

/// The term of the lower order is fitted to so many of the finest levels: coarser ones are not in
/// the range where few terms say it all.
const FITTED: usize = 4;

/// It is as good as none where it is at most this part of the error at the finest level; where the
/// order is lower it is nearly all of it …
const SHARE: f64 = 0.25;

/// … or at most so many of its standard errors, where errors scatter by where in a step something
/// lies.
const DEVIATIONS: f64 = 4.0;

/// The errors at one step, with their signs: of each entry of a gradient, or of one value.
#[derive(Clone, Debug)]
pub(super) struct Errors {
    /// The group of neighbouring steps that it belongs to, the coarsest 0.
    pub level: usize,
    /// The step.
    pub step: f64,
    /// The errors.
    pub errors: Vec<f64>,
}

impl Errors {
    /// The largest of them.
    pub fn largest(&self) -> f64 {
        self.errors
            .iter()
            .fold(0.0, |most, error| most.max(error.abs()))
    }
}

/// What errors tell of an order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Measured {
    /// The slope of the errors at the finest levels that stand out of the rounding.
    pub order: f64,
    /// Whether it falls short of what is expected: the slope is lower than it may be, and a term of
    /// the lower order explains it.
    pub falls_short: bool,
}

/// Measures the order of errors that stand out of the rounding, `floor`, and holds it against the
/// expected one; `None` where too few do.
pub(super) fn measure(
    samples: &[Errors],
    expected: u32,
    short_of: f64,
    floor: f64,
) -> Option<Measured> {
    let power = i32::try_from(expected).ok()?;
    let standing = standing(samples, power, floor)?;
    let first_fitted = standing.len().saturating_sub(FITTED);
    let order = line_slope(&standing[first_fitted..]);
    let fitted: Vec<&Errors> = samples
        .iter()
        .filter(|sample| (first_fitted..standing.len()).contains(&sample.level))
        .collect();
    let falls_short = order < f64::from(expected) - short_of && has_lower_term(&fitted, power);
    Some(Measured { order, falls_short })
}

/// As [`measure`], for errors that change their size and sign from step to step: no fit finds their
/// terms, and only the largest of a level falls with a power of the step. It falls short over all
/// levels and still over the finest two: at coarse steps, which cross several joins at once, it
/// falls more slowly.
pub(super) fn measure_largest(
    samples: &[Errors],
    expected: u32,
    short_of: f64,
    floor: f64,
) -> Option<Measured> {
    let standing = standing(samples, i32::try_from(expected).ok()?, floor)?;
    let order = line_slope(&standing);
    let of_finest = line_slope(&standing[standing.len() - 2..]);
    Some(Measured {
        order,
        falls_short: order.max(of_finest) < f64::from(expected) - short_of,
    })
}

/// Logarithms of step and largest error of each level whose errors stand out of the rounding;
/// `None` where there are too few.
fn standing(samples: &[Errors], power: i32, floor: f64) -> Option<Vec<(f64, f64)>> {
    let levels = samples.iter().map(|sample| sample.level).max()? + 1;
    let of_level = |level: usize| samples.iter().filter(move |sample| sample.level == level);
    // as if at the first step of the level: an error that happens to be 0 says nothing
    let level = |level: usize| {
        let first = of_level(level).next()?.step;
        let largest = of_level(level)
            .map(|it| it.largest() * (first / it.step).powi(power))
            .fold(0.0, f64::max);
        (largest > floor).then_some((first, largest))
    };
    let standing: Vec<(f64, f64)> = (0..levels)
        .map_while(level)
        .map(|(h, e)| (h.ln(), e.ln()))
        .collect();
    (standing.len() >= MEASURED).then_some(standing)
}

/// Whether e/h^p = d/h + a + b h + c h² has a d that matters, for any entry: one that also explains
/// the errors better than a further term in h does, for at coarse steps these matter too, and have
/// no place in the fit.
fn has_lower_term(samples: &[&Errors], power: i32) -> bool {
    let Some(last) = samples.last() else {
        return false;
    };
    let finest = samples
        .iter()
        .map(|it| it.step)
        .fold(f64::INFINITY, f64::min);
    let scaled = |it: &Errors, entry: usize| it.errors[entry] / (it.step / finest).powi(power);
    let entries = last.errors.len();
    let at_finest = samples
        .iter()
        .filter(|it| it.level == last.level)
        .flat_map(|it| (0..entries).map(move |entry| scaled(it, entry).abs()))
        .fold(0.0, f64::max);
    // one term fewer where there are only three levels
    let terms = if samples.iter().any(|it| it.level + MEASURED <= last.level) {
        4
    } else {
        3
    };
    let powers = |first: i32| {
        let x = DMatrix::from_fn(samples.len(), terms, |row, term| {
            (samples[row].step / finest).powi(term as i32 + first)
        });
        let inverse = (x.transpose() * &x).try_inverse()?;
        Some((x, inverse))
    };
    let (Some(lower), Some(higher)) = (powers(-1), powers(0)) else {
        return false;
    };
    let fit = |(x, inverse): &(DMatrix<f64>, DMatrix<f64>), e: &DVector<f64>| {
        let coefficients = inverse * (x.transpose() * e);
        let left = (e - x * &coefficients).norm_squared();
        (coefficients[0], left)
    };
    let is_lower = |entry: usize| {
        let e = DVector::from_fn(samples.len(), |row, _| scaled(samples[row], entry));
        let ((d, left), (_, left_without)) = (fit(&lower, &e), fit(&higher, &e));
        let freedom = samples.len().saturating_sub(terms).max(1) as f64;
        let deviation = (lower.1[(0, 0)].max(0.0) * left / freedom).sqrt();
        left < left_without && d.abs() > (SHARE * at_finest).max(DEVIATIONS * deviation)
    };
    (0..entries).any(is_lower)
}

#[cfg(test)]
mod tests {
    use super::super::convergence::LEVELS_ACROSS_JOINS;
    use super::{Errors, measure, measure_largest};

    const LEVELS: [[u32; 3]; 6] = [
        [16, 17, 19],
        [32, 35, 38],
        [64, 70, 76],
        [128, 139, 151],
        [256, 277, 301],
        [512, 554, 601],
    ];

    fn samples(e: impl Fn(f64) -> f64) -> Vec<Errors> {
        let steps = LEVELS
            .iter()
            .enumerate()
            .flat_map(|(level, steps)| steps.map(|n| (level, 1.0 / f64::from(n))));
        steps
            .map(|(level, step)| Errors {
                level,
                step,
                errors: vec![e(step)],
            })
            .collect()
    }

    fn falls_short(e: impl Fn(f64) -> f64, expected: u32) -> bool {
        measure(&samples(e), expected, 0.75, 1e-13)
            .unwrap()
            .falls_short
    }

    /// An error of order 5 whose next terms are as large at the coarse steps, and which is rounding
    /// at all but three levels.
    #[test]
    fn higher_order_terms_at_coarse_steps_are_no_lower_order() {
        let e = |h: f64| h.powi(5) * (1.1 - 15.0 * h - 80.0 * h * h);
        let coarse: Vec<_> = samples(e)
            .into_iter()
            .filter(|sample| sample.level < 3)
            .collect();
        let measured = measure(&coarse, 5, 0.75, 0.0).unwrap();
        assert!(
            measured.order < 4.25 && !measured.falls_short,
            "{measured:?}"
        );
        let lower = |h: f64| e(h) + 0.2 * h.powi(4);
        let coarse: Vec<_> = samples(lower)
            .into_iter()
            .filter(|sample| sample.level < 3)
            .collect();
        assert!(measure(&coarse, 5, 0.75, 0.0).unwrap().falls_short);
    }

    #[test]
    fn order_of_pure_powers_is_exact() {
        for p in 1..7 {
            let measured = measure(&samples(|h| 3.0 * h.powi(p)), p as u32, 0.75, 0.0).unwrap();
            assert!(
                (measured.order - f64::from(p)).abs() < 1e-12 && !measured.falls_short,
                "{p}: {measured:?}"
            );
            assert!(
                falls_short(|h| 3.0 * h.powi(p), p as u32 + 1) || p > 5,
                "{p} is not {}",
                p + 1
            );
        }
        assert!(measure(&samples(|_| 1e-14), 4, 0.75, 1e-13).is_none());
    }

    #[test]
    fn order_of_an_error_that_passes_through_zero() {
        // h⁴ (1 − h/h₀), with its zero anywhere from far above the steps to far below them
        for k in 0..60 {
            let zero = 10.0_f64.powf(-3.0 + 0.05 * f64::from(k));
            assert!(!falls_short(|h| h.powi(4) * (1.0 - h / zero), 4), "{zero}");
            assert!(
                !falls_short(|h| h.powi(4) * (1.0 - (h / zero).powi(2)), 4),
                "{zero}"
            );
            assert!(
                !falls_short(|h| h.powi(4) * (1.0 - h / zero) * (1.0 - 3.0 * h / zero), 4),
                "{zero}"
            );
            // one order lower
            for size in [1.0, 10.0] {
                assert!(
                    falls_short(
                        |h| size * h.powi(3) + h.powi(4) * (1.0 - h / zero.max(0.01)),
                        4
                    ),
                    "{size} {zero}"
                );
            }
        }
    }

    /// Error of Simpson's rule over a step of 1 for (t − θ)³/6 from θ on: its Peano kernel, and
    /// that of one continuous derivative less.
    fn kernels(theta: f64) -> [f64; 2] {
        let (left, half) = (1.0 - theta, (0.5 - theta).max(0.0));
        [
            left.powi(4) / 24.0 - (4.0 * half.powi(3) + left.powi(3)) / 36.0,
            left.powi(3) / 6.0 - (4.0 * half.powi(2) + left.powi(2)) / 12.0,
        ]
    }

    /// Joins of two continuous derivatives keep order 4; those of one, order 3, are found short of
    /// 4 by about half of the sets of joins.
    #[test]
    fn order_of_the_largest_errors_across_joins() {
        let mut found = 0;
        for set in 1..=200_u32 {
            let joins = 1 + set % 20;
            let part = |k: u32| {
                (f64::from(set) * 0.754_877_666 + f64::from(k * k) * 0.569_840_291).fract()
            };
            let size = |k: u32| (f64::from(k + set) * 2.3).sin();
            let samples = |which: usize| -> Vec<Errors> {
                let error = |h: f64| {
                    let of_join = |k: u32| size(k) * kernels((part(k) / h).fract())[which];
                    (0..joins).map(of_join).sum::<f64>() * h.powi(4 - which as i32)
                };
                let at = |level: usize, steps: u32| {
                    let step = 1.0 / (f64::from(steps) - 0.5);
                    Errors {
                        level,
                        step,
                        errors: vec![error(step)],
                    }
                };
                let levels = 0..LEVELS_ACROSS_JOINS.count;
                levels
                    .flat_map(|level| {
                        LEVELS_ACROSS_JOINS
                            .steps(level)
                            .map(move |steps| at(level, steps))
                    })
                    .collect()
            };
            let falls_short = |which: usize| {
                measure_largest(&samples(which), 4, 0.75, 0.0)
                    .unwrap()
                    .falls_short
            };
            assert!(!falls_short(0), "set {set}");
            found += usize::from(falls_short(1));
        }
        assert!(found > 90, "{found} of 200");
    }
}
