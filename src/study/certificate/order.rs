//! Measures the order of convergence and compares it with the expected order p.
//!
//! ```text
//!   e(h) = d h^(p−1) + a h^p + b h^(p+1) + …        d must be 0
//! ```
//!
//! The slope of log |e| is not sufficient. If a and b h have opposite signs, e passes through 0 at
//! some step, and decreases more slowly than h^p at smaller steps. For the apex, which is
//! interpolated within one step, the coefficient a varies with the position of the apex in the
//! step. Therefore the lower-order term d is fitted to the signed errors, and must be negligible.

use crate::derivative::check::line_slope;
use crate::statistics::largest_magnitude;
use nalgebra::{DMatrix, DVector};

/// Minimum number of levels from which an order is measured.
pub(super) const MEASURED: usize = 3;

/// Number of the finest levels to which the lower-order term is fitted. Coarser levels would need
/// more terms.
const FITTED: usize = 4;

/// The lower-order term counts as negligible up to this fraction of the error at the finest level.
/// If the method has a lower order, the fraction is near 1.
const SHARE: f64 = 0.25;

/// The lower-order term also counts as negligible up to this multiple of its standard error, which
/// follows from the scatter of the errors.
const DEVIATIONS: f64 = 4.0;

/// Largest deficit of the slope of the errors from the expected order. With a larger deficit,
/// [`measure`] fits a lower-order term. A mistake in a method gives a deficit of 1. The next term
/// of the error gives a deficit below this limit.
const ALLOWED_DEFICIT: f64 = 0.75;

/// Signed errors at one step size: the error of a value, or the error of each entry of a gradient.
#[derive(Clone, Debug)]
pub(super) struct Errors {
    /// Level (group of neighbouring steps); 0 is the coarsest.
    pub level: usize,
    /// Step, s.
    pub step: f64,
    pub errors: Vec<f64>,
}

/// A measured order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MeasuredOrder {
    /// Slope of log |error| against log step, over levels with errors above rounding.
    pub order: f64,
    /// True if the order is lower than expected. [`measure`] also requires a lower-order term that
    /// explains the low slope.
    pub falls_short: bool,
}

/// Measures the order from the levels whose error is above `floor` (rounding); `None` if there are
/// too few such levels.
pub(super) fn measure(samples: &[Errors], expected: u32, floor: f64) -> Option<MeasuredOrder> {
    let power = i32::try_from(expected).ok()?;
    let levels = levels_above_rounding(samples, power, floor)?;
    let first_fitted = levels.len().saturating_sub(FITTED);
    let order = line_slope(&levels[first_fitted..]);
    let fitted: Vec<&Errors> = samples
        .iter()
        .filter(|sample| (first_fitted..levels.len()).contains(&sample.level))
        .collect();
    let falls_short =
        order < f64::from(expected) - ALLOWED_DEFICIT && has_lower_term(&fitted, power);
    Some(MeasuredOrder { order, falls_short })
}

/// Measures the order of irregular errors, for which no fit works: only the largest error of a
/// level decreases with a power of the step. The order falls short only if it is too low over all
/// levels and also over the finest two. Coarse steps cross several joins at once, so their errors
/// decrease more slowly.
pub(super) fn measure_largest(
    samples: &[Errors],
    expected: u32,
    floor: f64,
) -> Option<MeasuredOrder> {
    let levels = levels_above_rounding(samples, i32::try_from(expected).ok()?, floor)?;
    let order = line_slope(&levels);
    let of_finest = line_slope(&levels[levels.len() - 2..]);
    Some(MeasuredOrder {
        order,
        falls_short: order.max(of_finest) < f64::from(expected) - ALLOWED_DEFICIT,
    })
}

/// Logarithms of step and largest error of the levels whose error is above `floor` (rounding);
/// `None` if there are too few such levels.
fn levels_above_rounding(samples: &[Errors], power: i32, floor: f64) -> Option<Vec<(f64, f64)>> {
    let count = samples.iter().map(|sample| sample.level).max()? + 1;
    let of_level = |level: usize| samples.iter().filter(move |sample| sample.level == level);
    // take the largest error of the level, because a single error may be 0 by chance; each error is
    // scaled with h^`power` to the first step of the level
    let level = |level: usize| {
        let first = of_level(level).next()?.step;
        let largest = of_level(level)
            .map(|it| largest_magnitude(&it.errors) * (first / it.step).powi(power))
            .fold(0.0, f64::max);
        (largest > floor).then_some((first, largest))
    };
    let levels: Vec<(f64, f64)> = (0..count)
        .map_while(level)
        .map(|(h, e)| (h.ln(), e.ln()))
        .collect();
    (levels.len() >= MEASURED).then_some(levels)
}

/// Fits e/h^p = d/h + a + b h + c h² and tests d for each entry. If a fit with h³ in place of 1/h
/// leaves smaller residuals, the omitted higher powers explain the errors, and d does not count.
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
    let finest_samples = samples.iter().filter(|it| it.level == last.level);
    let at_finest = largest_magnitude(
        finest_samples.flat_map(|it| (0..entries).map(move |entry| scaled(it, entry))),
    );
    // omit one term if there are only three levels
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
        measure(&samples(e), expected, 1e-13).unwrap().falls_short
    }

    /// An error of order 5 at the three coarsest levels, where its next terms dominate.
    #[test]
    fn higher_order_terms_at_coarse_steps_are_no_lower_order() {
        let e = |h: f64| h.powi(5) * (1.1 - 15.0 * h - 80.0 * h * h);
        let coarse: Vec<_> = samples(e)
            .into_iter()
            .filter(|sample| sample.level < 3)
            .collect();
        let measured = measure(&coarse, 5, 0.0).unwrap();
        assert!(
            measured.order < 4.25 && !measured.falls_short,
            "{measured:?}"
        );
        let lower = |h: f64| e(h) + 0.2 * h.powi(4);
        let coarse: Vec<_> = samples(lower)
            .into_iter()
            .filter(|sample| sample.level < 3)
            .collect();
        assert!(measure(&coarse, 5, 0.0).unwrap().falls_short);
    }

    #[test]
    fn order_of_pure_powers_is_exact() {
        for p in 1..7 {
            let measured = measure(&samples(|h| 3.0 * h.powi(p)), p as u32, 0.0).unwrap();
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
        assert!(measure(&samples(|_| 1e-14), 4, 1e-13).is_none());
    }

    #[test]
    fn order_of_an_error_that_passes_through_zero() {
        // this error is 0 at h = h₀ (`zero`), which runs from below all steps to above them
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
            // with a term h³ the order is 3
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

    /// Errors of Simpson's rule over a unit step for two integrands with a join at θ: (t − θ)₊³/6
    /// and (t − θ)₊²/2.
    fn kernels(theta: f64) -> [f64; 2] {
        let (left, half) = (1.0 - theta, (0.5 - theta).max(0.0));
        [
            left.powi(4) / 24.0 - (4.0 * half.powi(3) + left.powi(3)) / 36.0,
            left.powi(3) / 6.0 - (4.0 * half.powi(2) + left.powi(2)) / 12.0,
        ]
    }

    /// Joins with two continuous derivatives keep order 4. Joins with one continuous derivative
    /// give order 3; the test detects this in about half of the sets.
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
                measure_largest(&samples(which), 4, 0.0)
                    .unwrap()
                    .falls_short
            };
            assert!(!falls_short(0), "set {set}");
            found += usize::from(falls_short(1));
        }
        assert!(found > 90, "{found} of 200");
    }
}
