//! Statistics of any function of uncertain numbers: moments, and the share of each in the variance,
//! with confidence intervals.

use super::Distribution;
use crate::error::Result;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;

/// How a sample is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Points of the base sample, N; N (d + 2) evaluations for d uncertain numbers.
    pub samples: usize,
    /// Another seed, other points; the same one, the same to the last bit.
    pub seed: u64,
}

/// Resamples of the bootstrap that intervals are read from.
const RESAMPLES: usize = 400;

/// A number with its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The estimate.
    pub value: f64,
    /// The interval's lower end.
    pub low: f64,
    /// The interval's upper end.
    pub high: f64,
}

impl Interval {
    /// Whether a number lies in it.
    pub fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// The shares of an uncertain number in the variance of an output (Sobol' 1993; Homma & Saltelli
/// 1996). They are estimates with the scatter of the sample, so that one may lie below 0 or above
/// 1; of a single uncertain number both are 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indices {
    /// What of the variance goes on average once this number is known.
    pub first: Interval,
    /// What of it is left on average once all others are.
    pub total: Interval,
}

/// What a sample tells of an output.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// The mean.
    pub mean: Interval,
    /// The standard deviation; 0 where the output is the same at every point but for rounding.
    pub deviation: Interval,
    /// The values below which 2.5, 50 and 97.5 % of the sample lie.
    pub quantiles: [f64; 3],
    /// The shares of each uncertain number, in order; `None` where the output does not vary.
    pub indices: Vec<Option<Indices>>,
    /// Rows of the sample without a value somewhere, which the shares are taken without.
    pub left_out: usize,
}

/// The sample: two independent sets of points, A and B, and for each uncertain number A with that
/// number from B.
#[derive(Clone, Debug)]
pub struct Design {
    /// A, B, then A with the first number from B, A with the second …; a row is a point.
    pub points: Vec<Vec<Vec<f64>>>,
    seed: u64,
}

impl Design {
    /// The points of a plan.
    ///
    /// # Errors
    /// As [`Distribution::check`].
    pub fn new(inputs: &[Distribution], plan: Plan) -> Result<Self> {
        inputs.iter().try_for_each(Distribution::check)?;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(plan.seed);
        // the middle of one of 2⁵³ cells: never 0 or 1
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

    /// The statistics of an output from its values at the points, in the same order; `None` with
    /// fewer than two values. A value that is not finite is none.
    ///
    /// # Panics
    /// Where there are not as many values as points, set by set.
    pub fn statistics(&self, values: &[Vec<Option<f64>>]) -> Option<Statistics> {
        let lengths = |sets: &mut dyn Iterator<Item = usize>| sets.collect::<Vec<_>>();
        let [asked, given] = [
            lengths(&mut self.points.iter().map(Vec::len)),
            lengths(&mut values.iter().map(Vec::len)),
        ];
        assert!(
            asked == given,
            "the sets of the design have {asked:?} points, and there are {given:?} values"
        );
        let is_finite = |value: &f64| value.is_finite();
        // moments of every value of A and B, which are independent
        let mut all: Vec<f64> = values[..2]
            .iter()
            .flatten()
            .flatten()
            .copied()
            .filter(is_finite)
            .collect();
        if all.len() < 2 {
            return None;
        }
        let varies = varies(&all);
        if !varies {
            // what is left of a constant is rounding, and no number's share in it means anything
            let constant = all[0];
            all.fill(constant);
        }
        let (mean, deviation) = mean_and_deviation(&all);
        let resample = |stream: u64| {
            let mut random = self.random(stream);
            let drawn: Vec<f64> = (0..all.len())
                .map(|_| all[index(&mut random, all.len())])
                .collect();
            mean_and_deviation(&drawn)
        };
        let (means, deviations): (Vec<f64>, Vec<f64>) =
            (0..RESAMPLES as u64).into_par_iter().map(resample).unzip();
        // rows that have every value, centred: an offset would add to the noise of the products
        let rows: Vec<Vec<f64>> = (0..values[0].len())
            .filter_map(|row| {
                values
                    .iter()
                    .map(|column| column[row].filter(is_finite).map(|value| value - mean))
                    .collect()
            })
            .collect();
        let left_out = values[0].len() - rows.len();
        let inputs = values.len() - 2;
        let of_rows: Vec<f64> = rows
            .iter()
            .flat_map(|row| [row[0] + mean, row[1] + mean])
            .collect();
        let has_shares = varies && rows.len() >= 2 && self::varies(&of_rows);
        let indices = if has_shares {
            self.indices(&rows, inputs)
        } else {
            vec![None; inputs]
        };
        all.sort_by(f64::total_cmp);
        Some(Statistics {
            mean: interval(mean, means),
            deviation: interval(deviation, deviations),
            quantiles: [0.025, 0.5, 0.975].map(|p| quantile(&all, p)),
            indices,
            left_out,
        })
    }

    /// The mean of each of these numbers over the points of A, in units of the variance of an
    /// output with these values, and the intervals: mean and variance are of the same resamples.
    /// `None` where a number has no value, or the output does not vary.
    pub fn means_by_variance(
        &self,
        values: &[Vec<Option<f64>>],
        at_a: &[Vec<Option<f64>>],
    ) -> Vec<Option<Interval>> {
        let outputs = |row: usize| [values[0][row], values[1][row]].into_iter().flatten();
        let every: Vec<usize> = (0..values[0].len()).collect();
        let all: Vec<f64> = every.iter().flat_map(|row| outputs(*row)).collect();
        if all.len() < 2 || !varies(&all) {
            return vec![None; at_a.len()];
        }
        let ratios = |drawn: &[usize]| -> Vec<f64> {
            let drawn_outputs: Vec<f64> = drawn.iter().flat_map(|row| outputs(*row)).collect();
            let variance = if drawn_outputs.len() < 2 {
                f64::NAN
            } else {
                mean_and_deviation(&drawn_outputs).1.powi(2)
            };
            let ratio = |column: &Vec<Option<f64>>| {
                let (mut sum, mut count) = (0.0, 0.0);
                drawn
                    .iter()
                    .filter_map(|row| column[*row])
                    .for_each(|value| {
                        sum += value;
                        count += 1.0;
                    });
                sum / count / variance
            };
            at_a.iter().map(ratio).collect()
        };
        let estimates = ratios(&every);
        let resample = |stream: u64| {
            let mut random = self.random(stream);
            ratios(
                &every
                    .iter()
                    .map(|_| index(&mut random, every.len()))
                    .collect::<Vec<_>>(),
            )
        };
        let drawn: Vec<Vec<f64>> = (0..RESAMPLES as u64)
            .into_par_iter()
            .map(resample)
            .collect();
        let one = |(i, value): (usize, f64)| {
            value
                .is_finite()
                .then(|| interval(value, drawn.iter().map(|ratios| ratios[i]).collect()))
        };
        estimates.into_iter().enumerate().map(one).collect()
    }

    fn indices(&self, rows: &[Vec<f64>], inputs: usize) -> Vec<Option<Indices>> {
        if inputs == 1 {
            // all variance is of the one number, whatever the function: nothing is to be estimated
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
        let every: Vec<usize> = (0..rows.len()).collect();
        let estimates = shares(rows, &every, inputs);
        let resample = |stream: u64| {
            let mut random = self.random(stream);
            let drawn: Vec<usize> = every
                .iter()
                .map(|_| index(&mut random, rows.len()))
                .collect();
            shares(rows, &drawn, inputs)
        };
        let drawn: Vec<Vec<[f64; 2]>> = (0..RESAMPLES as u64)
            .into_par_iter()
            .map(resample)
            .collect();
        let both = |i: usize| {
            let of = |which: usize| {
                interval(
                    estimates[i][which],
                    drawn.iter().map(|shares| shares[i][which]).collect(),
                )
            };
            let indices = Indices {
                first: of(0),
                total: of(1),
            };
            (indices.first.value.is_finite() && indices.total.value.is_finite()).then_some(indices)
        };
        (0..inputs).map(both).collect()
    }

    /// A stream of random numbers of its own for each resample, whatever thread it runs on.
    fn random(&self, stream: u64) -> Xoshiro256PlusPlus {
        Xoshiro256PlusPlus::seed_from_u64(
            self.seed ^ (stream + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
        )
    }
}

/// The first-order and total shares of each number from some of the rows: f_A, f_B, f_AB1 … The
/// first after Saltelli et al. (2010), table 2 (b), the second after Jansen (1999), (f).
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

fn index(random: &mut Xoshiro256PlusPlus, below: usize) -> usize {
    // the high half of a product: as even as 2⁶⁴ allows
    ((u128::from(random.next_u64()) * below as u128) >> 64) as usize
}

/// Values that differ by no more than this, relative to the largest, are one number with its
/// rounding.
const SAME: f64 = 64.0 * f64::EPSILON;

/// Whether values differ by more than rounding.
fn varies(values: &[f64]) -> bool {
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| {
            (low.min(v), high.max(v))
        });
    high - low > SAME * low.abs().max(high.abs())
}

pub(super) fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let (n, one) = (values.len() as f64, values[0]);
    // the mean of equal numbers is that number, to the last bit
    let mean = one + values.iter().map(|value| value - one).sum::<f64>() / n;
    let squares: f64 = values
        .iter()
        .map(|value| (value - mean) * (value - mean))
        .sum();
    (mean, (squares / (n - 1.0)).sqrt())
}

/// The value below which a share of sorted values lies.
fn quantile(sorted: &[f64], p: f64) -> f64 {
    let place = p * (sorted.len() - 1) as f64;
    let (below, part) = (place.floor() as usize, place.fract());
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + part * (sorted[above] - sorted[below])
}

/// The 95 % interval of an estimate from those of the resamples, as wide as they scatter.
fn interval(value: f64, mut drawn: Vec<f64>) -> Interval {
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
