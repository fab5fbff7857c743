//! Mean and covariance of swings by expectation maximization (Dempster, Laird & Rubin 1977). The
//! covariance between the swings has the divisor n − 1. For shots with equal information, this is
//! restricted maximum likelihood (Patterson & Thompson 1971).

use super::linearized::{LinearizedLaunches, moments, swing_at};
use super::result::{Delivered, Explained};
use super::unknown::Unknown;
use crate::derivative::{Evaluator, Order, Taylor};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::study::calibrate::Measurement;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// A direction of parameter space is identified if the information of a shot along it exceeds this
/// multiple of the prior's information. The shot then removes more than half of the prior variance
/// along the direction.
const IDENTIFIED: f64 = 1.0;
/// Maximum number of iterations.
const ITERATIONS: usize = 100;
/// Stopping tolerance of mean and covariance, in prior standard uncertainties.
const TOLERANCE: f64 = 1e-7;

/// Shots with the same information matrix Λ. The score of a shot is the gradient of its
/// log-likelihood by the swing, at the mean swing.
struct ShotGroup {
    information: DMatrix<f64>,
    scores: Vec<DVector<f64>>,
}

/// Measured − computed outcomes of a shot at a swing, SI.
fn differences(
    shot: &Delivered,
    own: &[Outcome],
    unknowns: &[Unknown],
    at: &[f64],
) -> Result<Vec<f64>> {
    let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
    let computed = Evaluator::new(&shot.setup, own, &wrt, Order::Value)?.at(at)?;
    let difference = |(one, taylor): (&Explained, &Taylor)| {
        let Measurement { outcome, value, .. } = one.measured;
        -outcome.change(value, taylor.value)
    };
    Ok(shot
        .explained
        .iter()
        .zip(&computed)
        .map(difference)
        .collect())
}

/// Cholesky factorization of a matrix that is positive definite unless an element is not finite.
///
/// # Errors
/// [`Error::Delivery`] if it is not positive definite.
pub(super) fn positive_definite(matrix: DMatrix<f64>) -> Result<Cholesky<f64, Dyn>> {
    matrix.cholesky().ok_or_else(|| Error::Delivery {
        reason: "the launches have no finite derivatives by the mean swing".into(),
    })
}

/// Information that the shots contain about their swings, linearized about a mean swing, in units
/// of the prior standard uncertainties.
pub(super) struct SwingInformation {
    groups: Vec<ShotGroup>,
    /// Mean of the information matrix over the shots, from the instrument errors alone. It neglects
    /// the nonlinearity of the impact.
    pub(super) information: DMatrix<f64>,
    /// Orthonormal basis of the identified directions of parameter space, one direction per column.
    pub(super) identified: DMatrix<f64>,
    /// Projector on the unidentified directions.
    pub(super) unidentified: DMatrix<f64>,
    /// For each shot: its outcomes, each as an index and the difference measured − computed at the
    /// mean swing, SI.
    pub(super) differences: Vec<Vec<(usize, f64)>>,
    count: f64,
}

impl SwingInformation {
    /// Information in `shots` about their swings, linearized about the swing `mean`.
    ///
    /// # Errors
    /// The errors of [`Evaluator::at`] if the mean swing, with the club of a shot, does not strike
    /// the ball; [`Error::Delivery`] if a derivative is not finite.
    pub(super) fn new(
        shots: &[&Delivered],
        of: &[Outcome],
        unknowns: &[Unknown],
        mean: &DVector<f64>,
        launches: &LinearizedLaunches,
    ) -> Result<Self> {
        let n = unknowns.len();
        let (at, count) = (swing_at(unknowns, mean), shots.len() as f64);
        let mut all = Self {
            groups: vec![],
            information: DMatrix::zeros(n, n),
            identified: DMatrix::zeros(n, 0),
            unidentified: DMatrix::zeros(n, n),
            differences: vec![],
            count,
        };
        for shot in shots {
            all.add(shot, of, unknowns, &at, launches)?;
        }
        let eigen = all.information.clone().symmetric_eigen();
        let basis = |is_identified: bool| {
            let columns: Vec<_> = (0..n)
                .filter(|&k| (eigen.eigenvalues[k] > IDENTIFIED) == is_identified)
                .collect();
            DMatrix::from_fn(n, columns.len(), |i, k| eigen.eigenvectors[(i, columns[k])])
        };
        all.identified = basis(true);
        let unidentified = basis(false);
        all.unidentified = &unidentified * unidentified.transpose();
        Ok(all)
    }

    /// Adds a shot; `at` is the mean swing, SI.
    fn add(
        &mut self,
        shot: &Delivered,
        of: &[Outcome],
        unknowns: &[Unknown],
        at: &[f64],
        launches: &LinearizedLaunches,
    ) -> Result<()> {
        let own: Vec<Outcome> = shot
            .explained
            .iter()
            .map(|one| one.measured.outcome)
            .collect();
        let places: Vec<usize> = own
            .iter()
            .filter_map(|one| of.iter().position(|other| other == one))
            .collect();
        let differences = differences(shot, &own, unknowns, at)?;
        let (size, n) = (own.len(), unknowns.len());
        let sigma = |k: usize| shot.explained[k].measured.sigma;
        let slopes = DMatrix::from_fn(size, n, |k, i| launches.slopes[(places[k], i)] / sigma(k));
        let errors = DMatrix::from_fn(size, size, |k, l| {
            let nonlinear = launches.nonlinear[(places[k], places[l])] / (sigma(k) * sigma(l));
            if k == l { 1.0 + nonlinear } else { nonlinear }
        });
        let residuals = DVector::from_fn(size, |k, _| {
            (differences[k] - launches.bias[places[k]]) / sigma(k)
        });
        // positive definite, because `errors` is the identity plus a covariance
        let weighted = positive_definite(errors)?.solve(&slopes).transpose();
        let mut information = &weighted * &slopes;
        let mut score = weighted * residuals;
        self.information += slopes.transpose() * slopes / self.count;
        for (i, (posterior, unknown)) in shot.posteriors.iter().zip(unknowns).enumerate() {
            if shot.measured.contains(&unknown.parameter) {
                let prior = posterior.unknown;
                let weight = (unknown.sigma / prior.sigma).powi(2);
                information[(i, i)] += weight;
                self.information[(i, i)] += weight / self.count;
                score[i] += weight * (prior.prior - at[i]) / unknown.sigma;
            }
        }
        self.differences
            .push(places.into_iter().zip(differences).collect());
        match self
            .groups
            .iter_mut()
            .find(|other| other.information == information)
        {
            Some(other) => other.scores.push(score),
            None => self.groups.push(ShotGroup {
                information,
                scores: vec![score],
            }),
        }
        Ok(())
    }

    /// Mean of Λ over the shots. Λ accounts for instrument errors and for the nonlinearity of the
    /// impact.
    pub(super) fn mean_information(&self) -> DMatrix<f64> {
        let n = self.information.nrows();
        let weighted = |sum: DMatrix<f64>, one: &ShotGroup| {
            sum + &one.information * (one.scores.len() as f64 / self.count)
        };
        self.groups.iter().fold(DMatrix::zeros(n, n), weighted)
    }

    /// Mean and covariance of the swings. Along the identified directions, both are iterated from
    /// `initial_covariance`. Along the unidentified directions, the mean is `fixed_mean` and the
    /// covariance is `fixed_covariance`. Means are relative to the mean swing of the linearization.
    pub(super) fn maximize_likelihood(
        &self,
        fixed_covariance: &DMatrix<f64>,
        fixed_mean: &DVector<f64>,
        initial_covariance: DMatrix<f64>,
    ) -> (DVector<f64>, DMatrix<f64>) {
        let along = &self.identified;
        let ((n, size), back) = (along.shape(), along.transpose());
        let (mut mean, mut spread) = (DVector::zeros(size), initial_covariance);
        for _ in 0..ITERATIONS {
            let covariance = along * &spread * &back + fixed_covariance;
            let centre = along * &mean + fixed_mean;
            let mut swings = vec![];
            let mut left = DMatrix::zeros(size, size);
            for ShotGroup {
                information,
                scores,
            } in &self.groups
            {
                // (Λ + S⁻¹)⁻¹ with the covariance S, computed without S⁻¹ because S may be singular
                let Some(inverse) =
                    (DMatrix::identity(n, n) + &covariance * information).try_inverse()
                else {
                    continue;
                };
                let after = inverse * &covariance;
                left += &back * &after * along * (scores.len() as f64 / self.count);
                let expected = information * &centre;
                let swing = |score: &DVector<f64>| &back * (&centre + &after * (score - &expected));
                swings.extend(scores.iter().map(swing));
            }
            let (middle, between) = moments(swings.iter(), size);
            let wider = left + between;
            // remove the asymmetry that rounding causes
            let wider = (&wider + wider.transpose()) * 0.5;
            let change = (&middle - &mean).amax().max((&wider - &spread).amax());
            (mean, spread) = (middle, wider);
            if change < TOLERANCE {
                break;
            }
        }
        (mean, spread)
    }
}
