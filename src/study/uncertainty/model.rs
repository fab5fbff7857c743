//! Statistics of a function of independent random variables: moments, and Sobol' indices with
//! confidence intervals.

use super::Distribution;
use super::bootstrap::{Interval, bootstrap_interval, quantile, resampled_rows};
use crate::error::Result;
use crate::statistics::{Moments, extent};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;
use serde::{Serialize, Serializer};

/// Size and seed of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplePlan {
    /// Number of points N of each of the sets A and B of a [`SaltelliDesign`]. A function of d
    /// variables is evaluated at N (d + 2) points. `longdrive uncertainty` takes 4096.
    pub samples: usize,
    /// Seed of the random numbers; equal seeds give bitwise equal results.
    pub seed: u64,
}

/// Minimum number of points for intervals, quantiles and Sobol' indices. Bootstrap intervals and
/// outer quantiles of fewer values are too narrow.
pub const LEAST_POINTS: usize = 100;

/// Number of bootstrap resamples for a confidence interval.
const RESAMPLES: usize = 400;

/// Sobol' indices of a variable: shares of the output's variance (Sobol' 1993; Homma & Saltelli
/// 1996). Sampling noise can make an estimate negative or larger than 1. If there is only one
/// variable, both of its indices are 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indices {
    /// First-order index: mean share of the variance that knowledge of this variable removes.
    pub first: Interval,
    /// Total index: mean share of the variance that is left if all other variables are known.
    pub total: Interval,
}

/// An estimate from a sample, with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SampleEstimate {
    /// The estimate.
    pub value: f64,
    /// Lower end; `null` for a sample of fewer than 100 points.
    pub low: Option<f64>,
    /// Upper end; `null` for a sample of fewer than 100 points.
    pub high: Option<f64>,
}

impl SampleEstimate {
    /// The 95 % interval, if there is one.
    pub fn interval(&self) -> Option<Interval> {
        Some(Interval {
            value: self.value,
            low: self.low?,
            high: self.high?,
        })
    }
}

/// The statistics of an outcome over the sample.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "SampledReport"))]
pub struct Statistics {
    /// The mean, SI.
    pub mean: SampleEstimate,
    /// The standard deviation, SI.
    // 0 if the outcome varies only by rounding
    pub standard_uncertainty: SampleEstimate,
    /// The quantiles at 2.5, 50 and 97.5 %, SI; `null` for a sample of fewer than 100 points.
    #[serde(serialize_with = "by_level")]
    #[cfg_attr(
        test,
        schemars(with = "Option<std::collections::BTreeMap<String, f64>>")
    )]
    pub quantiles: Option<[f64; 3]>,
    /// Indices of each variable, in order. A row consists of one point of each set, and is complete
    /// if the outcome exists at all its points. `None` if the outcome does not vary, or if there
    /// are fewer than `LEAST_POINTS` complete rows.
    #[serde(skip)]
    pub indices: Vec<Option<Indices>>,
    /// Number of points that are omitted because one of their drives does not have the outcome.
    // the indices also omit these points
    pub rows_left_out: usize,
}

fn by_level<S: Serializer>(
    quantiles: &Option<[f64; 3]>,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    match quantiles {
        Some(all) => serializer.collect_map(["2.5 %", "50 %", "97.5 %"].into_iter().zip(all)),
        None => serializer.serialize_none(),
    }
}

/// Sample of Saltelli's design: two independent sets A and B, and for each variable a copy of A
/// with this variable from B.
#[derive(Clone, Debug)]
pub struct SaltelliDesign {
    /// The sets of points: A, B, A with variable 1 from B, A with variable 2 from B, …. A point has
    /// a value of each variable.
    pub points: Vec<Vec<Vec<f64>>>,
    seed: u64,
}

impl SaltelliDesign {
    /// Samples the points.
    ///
    /// # Errors
    /// The errors of [`Distribution::check`].
    pub fn new(inputs: &[Distribution], plan: SamplePlan) -> Result<Self> {
        inputs.iter().try_for_each(Distribution::check)?;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(plan.seed);
        // a random number in (0, 1): the midpoint of one of 2⁵³ cells, never 0 or 1
        let mut unit = || ((random.next_u64() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64;
        let mut set = || -> Vec<Vec<f64>> {
            let mut point = || inputs.iter().map(|input| input.quantile(unit())).collect();
            (0..plan.samples).map(|_| point()).collect()
        };
        let (a, b) = (set(), set());
        let crossed = |i: usize| -> Vec<Vec<f64>> {
            let cross = |(a, b): (&Vec<f64>, &Vec<f64>)| {
                let mut point = a.clone();
                point[i] = b[i];
                point
            };
            a.iter().zip(&b).map(cross).collect()
        };
        let crosses: Vec<_> = (0..inputs.len()).map(crossed).collect();
        Ok(Self {
            points: [vec![a, b], crosses].concat(),
            seed: plan.seed,
        })
    }

    /// Statistics of an output. `values` contains the output at each of [`points`](Self::points),
    /// in the same order; `None` if the output does not exist there. The result is `None` if the
    /// sets A and B together have fewer than two finite values.
    ///
    /// # Panics
    /// If the number of values differs from the number of points in a set.
    pub fn statistics(&self, values: &[Vec<Option<f64>>]) -> Option<Statistics> {
        let requested: Vec<usize> = self.points.iter().map(Vec::len).collect();
        let given: Vec<usize> = values.iter().map(Vec::len).collect();
        assert!(
            requested == given,
            "the sets of the design have {requested:?} points, and there are {given:?} values"
        );
        // A and B are independent: use all their values for the moments
        let mut all: Vec<f64> = values[..2]
            .iter()
            .flatten()
            .flatten()
            .copied()
            .filter(|value| value.is_finite())
            .collect();
        if all.len() < 2 {
            return None;
        }
        let varies = varies(&all);
        if !varies {
            // a constant varies only by rounding, and has no meaningful indices
            let constant = all[0];
            all.fill(constant);
        }
        // `all` has up to two values for each point: one of set A and one of set B
        let is_enough = all.len() >= 2 * LEAST_POINTS;
        let moments = self.bootstrap(all.len(), |drawn| {
            let moments = Moments::of(drawn.iter().map(|row| all[*row]));
            let numbers = [moments.mean, moments.deviation()];
            numbers.map(|number| number.unwrap_or(f64::NAN)).to_vec()
        });
        let [mean, standard_uncertainty] = [0, 1].map(|i| SampleEstimate {
            value: moments[i].value,
            low: is_enough.then_some(moments[i].low),
            high: is_enough.then_some(moments[i].high),
        });
        let rows = complete_rows(values, mean.value);
        let of_rows: Vec<f64> = rows
            .iter()
            .flat_map(|row| [row[0] + mean.value, row[1] + mean.value])
            .collect();
        let has_shares = varies && rows.len() >= LEAST_POINTS && self::varies(&of_rows);
        let inputs = values.len() - 2;
        let indices = if has_shares {
            self.indices(&rows, inputs)
        } else {
            vec![None; inputs]
        };
        all.sort_by(f64::total_cmp);
        Some(Statistics {
            mean,
            standard_uncertainty,
            quantiles: is_enough.then(|| [0.025, 0.5, 0.975].map(|p| quantile(&all, p))),
            indices,
            rows_left_out: values[0].len() - rows.len(),
        })
    }

    /// Evaluates `estimate` for all rows. Each of its numbers gets a bootstrap interval. `estimate`
    /// takes row indices.
    fn bootstrap(
        &self,
        rows: usize,
        estimate: impl Fn(&[usize]) -> Vec<f64> + Sync,
    ) -> Vec<Interval> {
        let resample = |stream: u64| {
            // independent of the thread
            let seed = self.seed ^ (stream + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
            estimate(&resampled_rows(&mut random, rows))
        };
        let drawn: Vec<Vec<f64>> = (0..RESAMPLES as u64)
            .into_par_iter()
            .map(resample)
            .collect();
        let every: Vec<usize> = (0..rows).collect();
        let with_interval = |(i, value): (usize, f64)| {
            bootstrap_interval(value, drawn.iter().map(|estimates| estimates[i]).collect())
        };
        estimate(&every)
            .into_iter()
            .enumerate()
            .map(with_interval)
            .collect()
    }

    /// For each column of `at_a`: the mean of the column over the points of A, divided by the
    /// variance of `values`. Each bootstrap resample recomputes both. `None` if the output does not
    /// vary, if the column has no values, and for fewer than `LEAST_POINTS` points.
    pub fn means_by_variance(
        &self,
        values: &[Vec<Option<f64>>],
        at_a: &[Vec<Option<f64>>],
    ) -> Vec<Option<Interval>> {
        let rows = values[0].len();
        let outputs = |row: usize| [values[0][row], values[1][row]].into_iter().flatten();
        let all: Vec<f64> = (0..rows).flat_map(outputs).collect();
        if all.len() < 2 * LEAST_POINTS || !varies(&all) {
            return vec![None; at_a.len()];
        }
        let ratios = |drawn: &[usize]| -> Vec<f64> {
            let moments = Moments::of(drawn.iter().flat_map(|row| outputs(*row)));
            let variance = moments.deviation().unwrap_or(f64::NAN).powi(2);
            at_a.iter()
                .map(|column| mean(drawn.iter().map(|row| column[*row])) / variance)
                .collect()
        };
        let finite = |ratio: Interval| ratio.value.is_finite().then_some(ratio);
        self.bootstrap(rows, ratios)
            .into_iter()
            .map(finite)
            .collect()
    }

    fn indices(&self, rows: &[Vec<f64>], inputs: usize) -> Vec<Option<Indices>> {
        if inputs == 1 {
            // a single variable causes the whole variance
            let whole = Interval {
                value: 1.0,
                low: 1.0,
                high: 1.0,
            };
            return vec![Some(Indices {
                first: whole,
                total: whole,
            })];
        }
        let indices = self.bootstrap(rows.len(), |drawn| shares(rows, drawn, inputs).concat());
        let both = |pair: &[Interval]| {
            let [first, total] = [pair[0], pair[1]];
            let exist = first.value.is_finite() && total.value.is_finite();
            exist.then_some(Indices { first, total })
        };
        indices.chunks_exact(2).map(both).collect()
    }
}

/// Complete rows of values f_A, f_B, f_AB1 …, minus the mean. An offset would add noise to the
/// products in [`shares`]. Rows with a value that is missing or not finite are omitted.
fn complete_rows(values: &[Vec<Option<f64>>], mean: f64) -> Vec<Vec<f64>> {
    let centred = |value: f64| value.is_finite().then_some(value - mean);
    (0..values[0].len())
        .filter_map(|row| {
            values
                .iter()
                .map(|column| column[row].and_then(centred))
                .collect()
        })
        .collect()
}

/// First-order and total index of each variable, from the rows of values f_A, f_B, f_AB1 … whose
/// numbers are in `drawn`. Estimators (b) and (f) of table 2 in Saltelli et al. (2010); (f) is from
/// Jansen (1999).
fn shares(rows: &[Vec<f64>], drawn: &[usize], inputs: usize) -> Vec<[f64; 2]> {
    let n = drawn.len() as f64;
    let (mut sum, mut squares) = (0.0, 0.0);
    let mut sums = vec![[0.0, 0.0]; inputs];
    for row in drawn.iter().map(|row| &rows[*row]) {
        let (a, b) = (row[0], row[1]);
        sum += a + b;
        squares += a * a + b * b;
        for (share, ab) in sums.iter_mut().zip(&row[2..]) {
            share[0] += b * (ab - a);
            share[1] += 0.5 * (a - ab) * (a - ab);
        }
    }
    let mean = sum / (2.0 * n);
    let variance = squares / (2.0 * n) - mean * mean;
    sums.into_iter()
        .map(|share| share.map(|sum| sum / n / variance))
        .collect()
}

/// Mean of the values that exist; NaN if there are none.
pub(super) fn mean(values: impl Iterator<Item = Option<f64>>) -> f64 {
    let (sum, count) = values
        .flatten()
        .fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// Relative tolerance: values that differ by less than this fraction of the largest value are equal
/// up to rounding.
const SAME: f64 = 64.0 * f64::EPSILON;

/// True if the values differ by more than rounding.
pub(in crate::study) fn varies(values: &[f64]) -> bool {
    let [low, high] = extent(values.iter().copied());
    high - low > SAME * low.abs().max(high.abs())
}
