//! Bootstrap: confidence intervals from resamples of rows, drawn with replacement (Efron 1979).

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::RngCore;
use serde::Serialize;

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
