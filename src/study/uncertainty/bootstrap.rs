//! Bootstrap: confidence intervals from resamples of rows, drawn with replacement (Efron 1979).

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::RngCore;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// A number with its confidence interval: 95 % unless stated otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Interval {
    /// The estimate.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Interval {
    /// Reports whether the interval contains a value.
    pub fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// The part of the interval between two limits, extended to contain `value`.
    pub(in crate::study) fn clipped(self, [low, high]: [f64; 2]) -> Self {
        Self {
            low: self.low.max(low).min(self.value),
            high: self.high.min(high).max(self.value),
            ..self
        }
    }
}

/// Indices of the rows of a resample: as many as `rows`, drawn with replacement.
pub(in crate::study) fn resampled_rows(random: &mut Xoshiro256PlusPlus, rows: usize) -> Vec<usize> {
    // multiply-shift method: uniform with an error of 2⁻⁶⁴
    let mut row = |_| ((u128::from(random.next_u64()) * rows as u128) >> 64) as usize;
    (0..rows).map(&mut row).collect()
}

/// Quantile of sorted values by linear interpolation.
pub(super) fn quantile(sorted: &[f64], p: f64) -> f64 {
    let place = p * (sorted.len() - 1) as f64;
    let (below, part) = (place.floor() as usize, place.fract());
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + part * (sorted[above] - sorted[below])
}

/// 95 % interval of the estimate `value`: from the 2.5 % to the 97.5 % quantile of the estimates
/// `drawn` from resamples, extended to contain `value`. Both ends are `value` if no drawn estimate
/// is finite.
pub(in crate::study) fn bootstrap_interval(value: f64, mut drawn: Vec<f64>) -> Interval {
    drawn.retain(|value| value.is_finite());
    if drawn.is_empty() {
        return Interval {
            value,
            low: value,
            high: value,
        };
    }
    drawn.sort_by(f64::total_cmp);
    Interval {
        value,
        low: quantile(&drawn, 0.025).min(value),
        high: quantile(&drawn, 0.975).max(value),
    }
}

/// Interval of about 95 % of the estimate `value` from a small sample of `n` rows: symmetric, with
/// the half-width d t √(n/(n − 1))/z. d is the larger distance from `value` to an end of
/// [`bootstrap_interval`]; t and z are the 97.5 % quantiles of Student's distribution with n − 1
/// degrees of freedom and of the normal distribution.
///
/// The percentile interval of a small sample is too narrow (Hesterberg 2015, The American
/// Statistician 69, 371; this is his expanded interval without its outer percentiles, which need
/// thousands of resamples). If the estimate is skewed, it is also too short on one side.
pub(in crate::study) fn small_sample_interval(value: f64, drawn: Vec<f64>, n: usize) -> Interval {
    const PROBABILITY: f64 = 0.975;
    let percentile = bootstrap_interval(value, drawn);
    let distance = (value - percentile.low).max(percentile.high - value);
    let n = n as f64;
    let student = StudentsT::new(0.0, 1.0, n - 1.0)
        .map_or(f64::INFINITY, |student| student.inverse_cdf(PROBABILITY));
    let normal = Normal::standard().inverse_cdf(PROBABILITY);
    let half_width = distance * student * (n / (n - 1.0)).sqrt() / normal;
    Interval {
        value,
        low: value - half_width,
        high: value + half_width,
    }
}
