//! The most likely spread of swings about a mean, by expectation and maximization (Dempster, Laird
//! & Rubin 1977).

use super::found::Delivered;
use super::launches::{Launches, moments, values};
use super::unknown::Unknown;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use nalgebra::{DMatrix, DVector};

/// The rounds of the search at most.
const ROUNDS: usize = 100;
/// A round that changes mean and spread by less than this part of what was known before is the
/// last.
const SETTLED: f64 = 1e-7;

/// Shots that tell the same of their swings: Λ, and for each shot Λ times the swing it tells, from
/// the mean on.
struct Alike {
    information: DMatrix<f64>,
    scores: Vec<DVector<f64>>,
}

/// What shots tell of their swings about a mean swing, each parameter in units of what was known
/// before.
pub(super) struct Told {
    alike: Vec<Alike>,
    /// Λ of a shot in the mean over all, by the errors of the instruments alone.
    pub(super) information: DMatrix<f64>,
    /// Measured − computed at the mean swing, SI, of each shot with the outcomes it has: the place
    /// of each among `of`.
    pub(super) off: Vec<Vec<(usize, f64)>>,
    count: f64,
}

impl Told {
    /// # Errors
    /// As [`Evaluator::at`], where the mean swing is no strike with the club of a shot.
    pub(super) fn new(
        shots: &[&Delivered],
        of: &[Outcome],
        unknowns: &[Unknown],
        is_measured: &impl Fn(&'static Parameter) -> bool,
        mean: &DVector<f64>,
        launches: &Launches,
    ) -> Result<Self> {
        let n = unknowns.len();
        let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
        let (at, count) = (values(unknowns, mean), shots.len() as f64);
        let mut told = Self {
            alike: vec![],
            information: DMatrix::zeros(n, n),
            off: vec![],
            count,
        };
        for shot in shots {
            let own: Vec<Outcome> = shot
                .explained
                .iter()
                .map(|one| one.measured.outcome)
                .collect();
            let places: Vec<usize> = own
                .iter()
                .filter_map(|one| of.iter().position(|other| other == one))
                .collect();
            let computed = Evaluator::new(&shot.setup, &own, &wrt, Order::Value)?.at(&at)?;
            let off: Vec<f64> = shot
                .explained
                .iter()
                .zip(&computed)
                .map(|(one, taylor)| {
                    one.measured.value
                        - one
                            .measured
                            .outcome
                            .unwrap_angle(taylor.value, one.measured.value)
                })
                .collect();
            let size = own.len();
            let sigma = |k: usize| shot.explained[k].measured.sigma;
            let slopes =
                DMatrix::from_fn(size, n, |k, i| launches.slopes[(places[k], i)] / sigma(k));
            let errors = DMatrix::from_fn(size, size, |k, l| {
                let beyond = launches.beyond[(places[k], places[l])] / (sigma(k) * sigma(l));
                if k == l { 1.0 + beyond } else { beyond }
            });
            let residuals =
                DVector::from_fn(size, |k, _| (off[k] - launches.bend[places[k]]) / sigma(k));
            // positive definite: ones and a covariance
            let weighted = errors.try_inverse().map_or_else(
                || slopes.transpose(),
                |inverse| slopes.transpose() * inverse,
            );
            let mut information = &weighted * &slopes;
            let mut score = weighted * residuals;
            told.information += slopes.transpose() * slopes / count;
            for (i, (known, unknown)) in shot.known.iter().zip(unknowns).enumerate() {
                if is_measured(unknown.parameter) {
                    let weight = (unknown.sigma / known.unknown.sigma).powi(2);
                    information[(i, i)] += weight;
                    told.information[(i, i)] += weight / count;
                    score[i] += weight * (known.unknown.before - at[i]) / unknown.sigma;
                }
            }
            told.off.push(places.into_iter().zip(off).collect());
            match told
                .alike
                .iter_mut()
                .find(|other| other.information == information)
            {
                Some(other) => other.scores.push(score),
                None => told.alike.push(Alike {
                    information,
                    scores: vec![score],
                }),
            }
        }
        Ok(told)
    }

    /// Λ of a shot in the mean over all, by the errors of the instruments and by how launches leave
    /// their straight line.
    pub(super) fn information_beyond(&self) -> DMatrix<f64> {
        let n = self.information.nrows();
        let weighted = |sum: DMatrix<f64>, one: &Alike| {
            sum + &one.information * (one.scores.len() as f64 / self.count)
        };
        self.alike.iter().fold(DMatrix::zeros(n, n), weighted)
    }

    /// How far the mean swing is from the mean, and the spread along the directions `along`, from a
    /// spread to begin with; the other directions have the spread `assumed`, and their mean is
    /// `moved`.
    pub(super) fn most_likely(
        &self,
        along: &DMatrix<f64>,
        assumed: &DMatrix<f64>,
        moved: &DVector<f64>,
        begin: DMatrix<f64>,
    ) -> (DVector<f64>, DMatrix<f64>) {
        let ((n, size), back) = (along.shape(), along.transpose());
        let (mut mean, mut spread) = (DVector::zeros(size), begin);
        for _ in 0..ROUNDS {
            let covariance = along * &spread * &back + assumed;
            let centre = along * &mean + moved;
            let mut swings = vec![];
            let mut left = DMatrix::zeros(size, size);
            for Alike {
                information,
                scores,
            } in &self.alike
            {
                // (Λ + S⁻¹)⁻¹ without S⁻¹, which need not exist
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
            // symmetric to the last bit
            let wider = (&wider + wider.transpose()) * 0.5;
            let change = (&middle - &mean)
                .iter()
                .chain((&wider - &spread).iter())
                .fold(0.0, |most: f64, x| most.max(x.abs()));
            (mean, spread) = (middle, wider);
            if change < SETTLED {
                break;
            }
        }
        (mean, spread)
    }
}
