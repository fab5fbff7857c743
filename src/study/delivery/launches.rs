//! The launches of swings that vary: as their straight line, and how they leave it.

use super::unknown::Unknown;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::Setup;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal};

/// So many swings are struck, each with its mirror image about the mean.
const PAIRS: u64 = 256;

/// The launches of swings N(mean, C): f(mean) + bend + slopes (x − mean) + a rest with the
/// covariance `beyond`. Parameters are in units of what was known before, outcomes in SI.
pub(super) struct Launches {
    /// f(mean).
    pub(super) at: Vec<f64>,
    pub(super) slopes: DMatrix<f64>,
    pub(super) bend: DVector<f64>,
    pub(super) beyond: DMatrix<f64>,
    /// The covariance of the outcomes themselves.
    pub(super) covariance: DMatrix<f64>,
}

/// The values of the unknowns, SI.
pub(super) fn values(unknowns: &[Unknown], scores: &DVector<f64>) -> Vec<f64> {
    unknowns
        .iter()
        .zip(scores.iter())
        .map(|(unknown, score)| unknown.before + unknown.sigma * score)
        .collect()
}

impl Launches {
    /// The impacts of swings spread over the distribution; values that no drive can have are left
    /// out.
    ///
    /// # Errors
    /// [`Error::Delivery`] where the mean swing is no strike, or more than half of the swings are
    /// none.
    pub(super) fn of(
        setup: &Setup<f64>,
        of: &[Outcome],
        unknowns: &[Unknown],
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
    ) -> Result<Self> {
        let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
        let (n, count) = (unknowns.len(), of.len());
        let straight =
            Evaluator::new(setup, of, &wrt, Order::First)?.at(&values(unknowns, mean))?;
        let slopes = DMatrix::from_fn(count, n, |k, i| straight[k].gradient[i] * unknowns[i].sigma);
        let strike = Evaluator::new(setup, of, &wrt, Order::Value)?;
        let eigen = covariance.clone().symmetric_eigen();
        let roots = DVector::from_iterator(
            n,
            eigen.eigenvalues.iter().map(|value| value.max(0.0).sqrt()),
        );
        let root = &eigen.eigenvectors * DMatrix::from_diagonal(&roots);
        let normal = Normal::standard();
        let struck: Vec<[DVector<f64>; 2]> = (0..2 * PAIRS)
            .filter_map(|k| {
                let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                // no share of 0, which has no score
                let share = |i| sobol::coordinate(k / 2, i, 0).clamp(1e-6, 1.0 - 1e-6);
                let off = &root * DVector::from_fn(n, |i, _| side * normal.inverse_cdf(share(i)));
                let found = strike.at(&values(unknowns, &(mean + &off))).ok()?;
                let changed = |k: usize| {
                    of[k].unwrap_angle(found[k].value, straight[k].value) - straight[k].value
                };
                let changed = DVector::from_fn(count, |k, _| changed(k));
                let rest = &changed - &slopes * off;
                Some([changed, rest])
            })
            .collect();
        if struck.len() < PAIRS as usize {
            let reason = "the swings behind the shots would vary so much that more than half of \
                          them are no strike; \
                 name fewer parameters (`vary`), or what is known of them (`sigma`)";
            return Err(Error::Delivery {
                reason: reason.into(),
            });
        }
        let [(_, all), (bend, beyond)] =
            [0, 1].map(|part| moments(struck.iter().map(|pair| &pair[part]), count));
        let at = straight.iter().map(|taylor| taylor.value).collect();
        Ok(Self {
            at,
            slopes,
            bend,
            beyond,
            covariance: all,
        })
    }
}

/// Mean and covariance.
pub(super) fn moments<'a>(
    of: impl Iterator<Item = &'a DVector<f64>> + Clone,
    size: usize,
) -> (DVector<f64>, DMatrix<f64>) {
    let count = of.clone().count().max(1) as f64;
    let mean = of.clone().fold(DVector::zeros(size), |sum, one| sum + one) / count;
    let mut covariance = DMatrix::zeros(size, size);
    for one in of {
        let off = one - &mean;
        for (mut column, other) in covariance.column_iter_mut().zip(off.iter()) {
            column
                .iter_mut()
                .zip(off.iter())
                .for_each(|(sum, one)| *sum += one * other / count);
        }
    }
    (mean, covariance)
}
