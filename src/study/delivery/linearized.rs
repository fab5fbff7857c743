//! Linearized launches of a distribution of swings, with the moments of the linearization error.

use super::unknown::Unknown;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::Setup;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal};

/// Number of pairs of sampled swings: a swing and its mirror image about the mean.
const PAIRS: u64 = 256;

/// Linear model of the launches f of swings x ~ N(mean, C):
///
/// ```text
///   f(x) = f(mean) + bias + slopes (x − mean) + e
/// ```
///
/// The error e has mean 0 and covariance `nonlinear`. Parameters are in prior standard
/// uncertainties, outcomes in SI.
pub(super) struct LinearizedLaunches {
    /// f(mean).
    pub(super) at: Vec<f64>,
    pub(super) slopes: DMatrix<f64>,
    pub(super) bias: DVector<f64>,
    pub(super) nonlinear: DMatrix<f64>,
    /// Covariance of the outcomes.
    pub(super) covariance: DMatrix<f64>,
}

/// Values of `unknowns`, SI. `scores` are the distances of these values from the prior means, in
/// prior standard uncertainties.
pub(super) fn swing_at(unknowns: &[Unknown], scores: &DVector<f64>) -> Vec<f64> {
    unknowns
        .iter()
        .zip(scores.iter())
        .map(|(unknown, score)| unknown.prior + unknown.sigma * score)
        .collect()
}

impl LinearizedLaunches {
    /// Samples the impact over the distribution. Samples outside the range of a parameter are
    /// ignored, and samples that do not strike the ball.
    ///
    /// # Errors
    /// The errors of [`Evaluator::at`] if the mean swing does not strike the ball;
    /// [`Error::Delivery`] if more than half of the samples are ignored.
    pub(super) fn of(
        setup: &Setup<f64>,
        of: &[Outcome],
        unknowns: &[Unknown],
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
    ) -> Result<Self> {
        let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
        let (n, count) = (unknowns.len(), of.len());
        let at_mean =
            Evaluator::new(setup, of, &wrt, Order::First)?.at(&swing_at(unknowns, mean))?;
        let slopes = DMatrix::from_fn(count, n, |k, i| at_mean[k].gradient[i] * unknowns[i].sigma);
        let strike = Evaluator::new(setup, of, &wrt, Order::Value)?;
        let eigen = covariance.clone().symmetric_eigen();
        let roots = DVector::from_iterator(
            n,
            eigen.eigenvalues.iter().map(|value| value.max(0.0).sqrt()),
        );
        // The symmetric square root is unique. Eigenvectors of equal eigenvalues are arbitrary: with
        // the root V √Λ, the sampled swings would jump between iterations.
        let root =
            &eigen.eigenvectors * DMatrix::from_diagonal(&roots) * eigen.eigenvectors.transpose();
        let normal = Normal::standard();
        let samples: Vec<[DVector<f64>; 2]> = (0..2 * PAIRS)
            .filter_map(|k| {
                let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                // the normal quantile of 0 is infinite
                let quantile = |i| sobol::coordinate(k / 2, i, 0).clamp(1e-6, 1.0 - 1e-6);
                let change =
                    &root * DVector::from_fn(n, |i, _| side * normal.inverse_cdf(quantile(i)));
                let found = strike.at(&swing_at(unknowns, &(mean + &change))).ok()?;
                let changed = |k: usize| of[k].change(at_mean[k].value, found[k].value);
                let changed = DVector::from_fn(count, |k, _| changed(k));
                let rest = &changed - &slopes * change;
                Some([changed, rest])
            })
            .collect();
        if samples.len() < PAIRS as usize {
            let reason = "the swings behind the shots would vary so much that more than half of \
                          them would not strike the ball; give fewer parameters (`vary`), or \
                          smaller uncertainties (`sigma`)";
            return Err(Error::Delivery {
                reason: reason.into(),
            });
        }
        let [(_, all), (bias, nonlinear)] =
            [0, 1].map(|part| moments(samples.iter().map(|pair| &pair[part]), count));
        let at = at_mean.iter().map(|taylor| taylor.value).collect();
        Ok(Self {
            at,
            slopes,
            bias,
            nonlinear,
            covariance: all,
        })
    }
}

/// Mean and covariance of a sample. The covariance has the divisor n − 1, because the mean is
/// estimated from the same n values.
pub(super) fn moments<'a>(
    of: impl Iterator<Item = &'a DVector<f64>> + Clone,
    size: usize,
) -> (DVector<f64>, DMatrix<f64>) {
    let count = of.clone().count().max(1);
    let mean = of.clone().fold(DVector::zeros(size), |sum, one| sum + one) / count as f64;
    let freedom = (count - 1).max(1) as f64;
    let mut covariance = DMatrix::zeros(size, size);
    for one in of {
        let deviation = one - &mean;
        for (mut column, other) in covariance.column_iter_mut().zip(deviation.iter()) {
            column
                .iter_mut()
                .zip(deviation.iter())
                .for_each(|(sum, one)| *sum += one * other / freedom);
        }
    }
    (mean, covariance)
}
