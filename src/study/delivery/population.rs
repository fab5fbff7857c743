use super::expectation_maximization::{SwingInformation, positive_definite};
use super::linearized::{LinearizedLaunches, moments};
use super::result::Delivered;
use super::shots::{ShotDelivery, setup_of_shots};
use super::unknown::Unknown;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::study::calibrate::Measurement;
use crate::units::counted;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// The population of swings behind the shots of a table.
// a joint normal distribution, without the measurement errors of the launch monitor
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "PopulationReport"))]
pub struct Population {
    /// Number of shots, at least 10.
    pub shots: usize,
    /// Factor, 0 to 1, by which the prior deviation is multiplied along the directions that the
    /// shots do not identify.
    #[serde(rename = "kept")]
    pub prior_factor: f64,
    /// True if mean and covariance of the swings converged.
    #[serde(skip)]
    pub is_converged: bool,
    /// The launch outcomes, measured and computed from the distribution.
    #[serde(rename = "launches")]
    pub predicted: Vec<PredictedOutcome>,
    /// The distribution of each parameter.
    #[serde(rename = "spread")]
    pub spreads: Vec<Recovered>,
    /// The correlations of the parameters, −1 to 1, in the order of `spread`.
    pub correlations: Vec<Vec<f64>>,
}

/// Distribution of one parameter over the swings, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Recovered {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Mean over the swings.
    pub mean: f64,
    /// Standard deviation over the swings.
    pub deviation: f64,
    /// Fraction of the prior variance that one shot removes, if the shot has the mean swing. The
    /// rest of the variance is as the prior assumes.
    #[serde(rename = "told")]
    pub variance_removed: f64,
    /// Standard uncertainty of the mean.
    #[serde(rename = "mean_standard_uncertainty")]
    pub mean_error: f64,
    /// Standard uncertainty of the standard deviation.
    #[serde(rename = "deviation_standard_uncertainty")]
    pub deviation_error: f64,
}

/// Moments of an outcome: those of the measured shots, and those that the estimated distribution
/// of deliveries gives.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LaunchMoments"))]
pub struct PredictedOutcome {
    /// The outcome.
    pub of: Outcome,
    /// Mean and standard deviation of the measured launches.
    pub measured: MeanAndDeviation,
    /// Mean and standard deviation of launches that are computed from the distribution, with the
    /// measurement errors of the launch monitor.
    pub recovered: MeanAndDeviation,
}

/// A mean with a standard deviation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MeanAndDeviation {
    /// The mean, SI.
    pub mean: f64,
    /// The standard deviation, SI.
    pub deviation: f64,
}

/// Minimum number of shots for a distribution.
pub const LEAST_SHOTS: usize = 10;
/// Factors by which the prior deviation is multiplied along unidentified directions. They are tried
/// in this order.
const PRIOR_FACTORS: [f64; 4] = [1.0, 0.5, 0.25, 0.125];
/// Maximum number of times that the launches are linearized about a new mean.
const ITERATIONS: u32 = 30;
/// Stopping tolerance of mean and covariance, in prior standard uncertainties.
const TOLERANCE: f64 = 1e-5;
/// Distance from the end of the iterations that counts as converged: of the mean, in prior standard
/// uncertainties; of the covariance, in their squares.
const NEGLIGIBLE: f64 = 0.01;
/// Largest acceptable [discrepancy](PredictedOutcome::discrepancy) of an outcome.
const ACCEPTED_DISCREPANCY: f64 = 0.25;

impl PredictedOutcome {
    /// The difference of the means or the difference of the standard deviations, whichever is
    /// larger, divided by the measured standard deviation.
    pub fn discrepancy(&self) -> f64 {
        let (measured, recovered) = (self.measured, self.recovered);
        let of_mean = (recovered.mean - measured.mean).abs();
        let of_deviation = (recovered.deviation - measured.deviation).abs();
        of_mean.max(of_deviation) / measured.deviation
    }
}

impl Population {
    /// Estimates the normal distribution of a golfer's swings from the shots for which a delivery
    /// was found, by maximum likelihood with n − 1 in place of the number of shots n.
    ///
    /// In directions of the unknowns that the launches do not determine, the swings have their
    /// prior distribution. The launches predicted from this distribution may scatter more than the
    /// shots, because an impact is nonlinear. The prior deviation in these directions is then
    /// reduced.
    ///
    /// A club value that was measured with a shot counts as a measurement of its swing. A prior
    /// that holds for all shots does not count as a measurement. The swings are those with the
    /// [setup of the shots](setup_of_shots).
    ///
    /// # Errors
    /// [`Error::Delivery`] for fewer than [`LEAST_SHOTS`] shots, and if most swings of the
    /// distribution are not strikes; the errors of
    /// [`Evaluator::at`](crate::derivative::Evaluator::at) if the mean swing is not a strike.
    pub fn of(setup: &Setup<f64>, all: &[ShotDelivery], unknowns: &[Unknown]) -> Result<Self> {
        let shots: Vec<&Delivered> = all.iter().filter_map(ShotDelivery::explained).collect();
        if shots.len() < LEAST_SHOTS {
            let least = counted(LEAST_SHOTS as u64, "shot");
            let reason = format!(
                "a distribution needs {least} whose delivery is found, and there are {}",
                shots.len()
            );
            return Err(Error::Delivery { reason });
        }
        let setup = setup_of_shots(setup, all)?;
        let mut best: Option<(f64, Self)> = None;
        for prior_factor in PRIOR_FACTORS {
            let found = iterate(&setup, &shots, unknowns, prior_factor);
            let found = match (found, &best) {
                (Ok(found), _) => found,
                (Err(error), None) if prior_factor == PRIOR_FACTORS[PRIOR_FACTORS.len() - 1] => {
                    return Err(error);
                }
                (Err(_), _) => continue,
            };
            let discrepancy = found
                .predicted
                .iter()
                .map(PredictedOutcome::discrepancy)
                .fold(0.0, f64::max);
            if best.as_ref().is_none_or(|(least, _)| discrepancy < *least) {
                best = Some((discrepancy, found));
            }
            if discrepancy <= ACCEPTED_DISCREPANCY {
                break;
            }
        }
        let refuse = || Error::Delivery {
            reason: "no distribution of swings was found".into(),
        };
        best.map(|(_, found)| found).ok_or_else(refuse)
    }

    /// Launch outcomes with a [discrepancy](PredictedOutcome::discrepancy) above 0.25: the
    /// prediction disagrees with the measurement.
    pub fn mispredicted(&self) -> impl Iterator<Item = &PredictedOutcome> {
        self.predicted
            .iter()
            .filter(|predicted| predicted.discrepancy() > ACCEPTED_DISCREPANCY)
    }
}

/// The distribution at the end of the iterations, in prior standard uncertainties.
struct ConvergedDistribution {
    mean: DVector<f64>,
    covariance: DMatrix<f64>,
    /// Launches linearized about the mean.
    launches: LinearizedLaunches,
    information: SwingInformation,
    prior_factor: f64,
    is_converged: bool,
}

/// Computes the distribution of the swings. Along unidentified directions, the prior's standard
/// deviations are multiplied by `prior_factor`. Linearizes the launches about the mean, and
/// maximizes the likelihood. Repeats both until mean and covariance no longer change, at most
/// [`ITERATIONS`] times.
fn iterate(
    setup: &Setup<f64>,
    shots: &[&Delivered],
    unknowns: &[Unknown],
    prior_factor: f64,
) -> Result<Population> {
    let n = unknowns.len();
    let mut of: Vec<Outcome> = vec![];
    for one in shots.iter().flat_map(|shot| &shot.explained) {
        if !of.contains(&one.measured.outcome) {
            of.push(one.measured.outcome);
        }
    }
    let (mut mean, mut covariance) = (DVector::zeros(n), DMatrix::zeros(n, n));
    let mut iteration = 0;
    loop {
        let launches = LinearizedLaunches::of(setup, &of, unknowns, &mean, &covariance)?;
        let information = SwingInformation::new(shots, &of, unknowns, &mean, &launches)?;
        let (along, unidentified) = (&information.identified, &information.unidentified);
        let fixed_covariance = unidentified * (prior_factor * prior_factor);
        let fixed_mean = -(unidentified * &mean);
        let initial_covariance = match iteration {
            0 => DMatrix::identity(along.ncols(), along.ncols()),
            _ => along.transpose() * &covariance * along,
        };
        let (centre, spread) =
            information.maximize_likelihood(&fixed_covariance, &fixed_mean, initial_covariance);
        let found = along * &spread * along.transpose();
        let next = (
            &mean + along * centre + fixed_mean,
            &found + &fixed_covariance,
        );
        let change = (&next.0 - &mean).amax().max((&next.1 - &covariance).amax());
        iteration += 1;
        let is_at_end = change < TOLERANCE;
        if iteration < ITERATIONS && !is_at_end {
            (mean, covariance) = next;
            continue;
        }
        // a variance that falls to 0 does so as 1/iteration: its changes, which fall as
        // 1/iteration², then add up to iteration × change
        let is_converged = is_at_end || f64::from(iteration) * change < NEGLIGIBLE;
        let solution = ConvergedDistribution {
            mean,
            covariance,
            launches,
            information,
            prior_factor,
            is_converged,
        };
        return solution.population(shots, &of, unknowns);
    }
}

impl ConvergedDistribution {
    fn population(
        &self,
        shots: &[&Delivered],
        of: &[Outcome],
        unknowns: &[Unknown],
    ) -> Result<Population> {
        let n = unknowns.len();
        let (covariance, unidentified) = (&self.covariance, &self.information.unidentified);
        let (count, sampling) = (shots.len() as f64, self.sampling_variances()?);
        let posterior = DMatrix::identity(n, n) + &self.information.information;
        let left = positive_definite(posterior)?.inverse();
        let deviation = |i: usize| covariance[(i, i)].max(0.0).sqrt();
        let one = |(i, unknown): (usize, &Unknown)| {
            let variance = covariance[(i, i)];
            let of_mean = sampling[i] / count;
            // standard uncertainty of a sample variance (Wishart distribution)
            let of_variance = sampling[i] * (2.0 / (count - 1.0)).sqrt();
            // both uncertainties include the prior variance along unidentified directions, where
            // the prior mean may be wrong and the swings may scatter less than the prior
            let by_deviation = (variance + of_variance).max(0.0).sqrt() - variance.max(0.0).sqrt();
            Recovered {
                parameter: unknown.parameter,
                mean: unknown.prior + unknown.sigma * self.mean[i],
                deviation: unknown.sigma * deviation(i),
                variance_removed: (1.0 - left[(i, i)]).clamp(0.0, 1.0),
                mean_error: unknown.sigma * (of_mean + unidentified[(i, i)]).max(0.0).sqrt(),
                deviation_error: unknown.sigma
                    * (by_deviation * by_deviation + unidentified[(i, i)].max(0.0)).sqrt(),
            }
        };
        let correlation = |i: usize, j: usize| match i == j {
            true => 1.0,
            false => covariance[(i, j)] / (deviation(i) * deviation(j)),
        };
        Ok(Population {
            spreads: unknowns.iter().enumerate().map(one).collect(),
            correlations: (0..n)
                .map(|i| (0..n).map(|j| correlation(i, j)).collect())
                .collect(),
            shots: shots.len(),
            prior_factor: if unidentified.amax() > 0.0 {
                self.prior_factor
            } else {
                1.0
            },
            is_converged: self.is_converged,
            predicted: predicted(shots, of, &self.information, &self.launches),
        })
    }

    /// For each parameter, the variance of the estimates from single shots, along the identified
    /// directions. It is the variance of the swings plus the variance from the launch monitor's
    /// errors.
    fn sampling_variances(&self) -> Result<DVector<f64>> {
        let along = &self.information.identified;
        let information = along.transpose() * self.information.mean_information() * along;
        let of_instruments = positive_definite(information)?.inverse();
        let of_swings = along.transpose() * &self.covariance * along;
        Ok((along * (of_swings + of_instruments) * along.transpose()).diagonal())
    }
}

/// Measured and predicted moments of each outcome.
fn predicted(
    shots: &[&Delivered],
    of: &[Outcome],
    information: &SwingInformation,
    launches: &LinearizedLaunches,
) -> Vec<PredictedOutcome> {
    let one = |(place, of): (usize, &Outcome)| {
        let mut rows = vec![];
        for (shot, differences) in shots.iter().zip(&information.differences) {
            for (explained, (at, difference)) in shot.explained.iter().zip(differences) {
                if *at == place {
                    let Measurement { value, sigma, .. } = explained.measured;
                    // unwrap angles to within half a turn of the angle for the mean swing
                    let computed = of.unwrap_angle(value - difference, launches.at[place]);
                    rows.push(DVector::from_vec(vec![
                        computed + difference,
                        difference - launches.bias[place],
                        sigma * sigma,
                    ]));
                }
            }
        }
        let (mean, covariance) = moments(rows.iter(), 3);
        let deviation = covariance[(0, 0)].max(0.0).sqrt();
        let spread = (launches.covariance[(place, place)] + mean[2])
            .max(0.0)
            .sqrt();
        PredictedOutcome {
            of: *of,
            measured: MeanAndDeviation {
                mean: mean[0],
                deviation,
            },
            recovered: MeanAndDeviation {
                mean: mean[0] - mean[1],
                deviation: spread,
            },
        }
    };
    of.iter().enumerate().map(one).collect()
}
