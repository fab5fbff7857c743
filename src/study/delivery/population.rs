use super::found::Delivered;
use super::launches::{Launches, moments};
use super::likely::Told;
use super::shots::Delivery;
use super::unknown::Unknown;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::study::calibrate::Measurement;
use crate::units::counted;
use nalgebra::{DMatrix, DVector};

/// How the swings behind many shots are spread: a joint normal distribution, without what the
/// launch monitor's errors add to the scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct Population {
    /// The parameters that were sought.
    pub spreads: Vec<Recovered>,
    /// Their correlations, a row for each.
    pub correlations: Vec<Vec<f64>>,
    /// The shots it was found from.
    pub shots: usize,
    /// What part of the deviation assumed before is kept where the shots do not tell one.
    pub kept: f64,
    /// The measured outcomes of the launch beside those of swings so distributed.
    pub returned: Vec<Returned>,
}

/// A parameter over the swings, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recovered {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The mean over the swings.
    pub mean: f64,
    /// The standard deviation from swing to swing.
    pub deviation: f64,
    /// What part of the variance before a single shot removes at the mean swing, 0 to 1; the rest
    /// is what was known before.
    pub told: f64,
    /// The standard uncertainty of the mean.
    pub mean_error: f64,
    /// The standard uncertainty of the standard deviation.
    pub deviation_error: f64,
}

/// Means and standard deviations of an outcome of the launch, measured and of the swings recovered,
/// SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Returned {
    /// The outcome.
    pub of: Outcome,
    /// Mean and standard deviation over the shots.
    pub measured: [f64; 2],
    /// The same of the swings recovered, with the errors of the launch monitor.
    pub recovered: [f64; 2],
}

/// Fewer shots than this tell no distribution.
pub const LEAST_SHOTS: usize = 10;
/// A change of parameters together is told where a shot removes more than half of its variance:
/// where its information is above this, in units of what was known before.
const TOLD: f64 = 1.0;
/// The parts of the deviation assumed that are tried where the shots do not tell one.
const KEPT: [f64; 4] = [1.0, 0.5, 0.25, 0.125];
/// The mean swings at most at which impacts are looked at.
const ROUNDS: usize = 30;
/// A round that changes mean and covariance by less than this part of what was known before is the
/// last.
const SETTLED: f64 = 1e-5;
/// Launches are given back where mean and deviation are off by less than this part of the measured
/// deviation.
const GIVEN_BACK: f64 = 0.25;

impl Returned {
    /// The larger one of the differences of mean and deviation, in parts of the measured deviation.
    pub fn off(&self) -> f64 {
        let ([mean, deviation], [found, spread]) = (self.measured, self.recovered);
        (found - mean).abs().max((spread - deviation).abs()) / deviation
    }
}

impl Population {
    /// The most likely normal distribution of the swings behind shots whose delivery was found.
    /// Changes of several parameters that leave the launch nearly as it is stay as they were known
    /// before. Where launches would scatter more than the shots by it, as an impact is no straight
    /// line, less of that spread is kept. `is_measured` says which parameters the rows state; these
    /// are known by a measurement, the others by the swings alone.
    ///
    /// # Errors
    /// [`Error::Delivery`] of fewer than [`LEAST_SHOTS`] shots, and where most of such swings would
    /// be no strike.
    pub fn of(
        setup: &Setup<f64>,
        all: &[Delivery],
        unknowns: &[Unknown],
        is_measured: impl Fn(&'static Parameter) -> bool,
    ) -> Result<Self> {
        let shots: Vec<&Delivered> = all.iter().filter_map(Delivery::explained).collect();
        if shots.len() < LEAST_SHOTS {
            let least = counted(LEAST_SHOTS as u64, "shot");
            let reason = format!(
                "it takes {least} whose delivery is found, and there are {}",
                shots.len()
            );
            return Err(Error::Delivery { reason });
        }
        let mut best: Option<(f64, Self)> = None;
        for kept in KEPT {
            let found = settled(setup, &shots, unknowns, &is_measured, kept);
            let found = match (found, &best) {
                (Ok(found), _) => found,
                (Err(error), None) if kept == KEPT[KEPT.len() - 1] => return Err(error),
                (Err(_), _) => continue,
            };
            let off = found.returned.iter().map(Returned::off).fold(0.0, f64::max);
            if best.as_ref().is_none_or(|(least, _)| off < *least) {
                best = Some((off, found));
            }
            if off <= GIVEN_BACK {
                break;
            }
        }
        let refuse = || Error::Delivery {
            reason: "no distribution of swings was found".into(),
        };
        best.map(|(_, found)| found).ok_or_else(refuse)
    }

    /// The outcomes of the launch that swings so distributed do not give back: off by more than a
    /// quarter of their scatter.
    pub fn not_returned(&self) -> impl Iterator<Item = &Returned> {
        self.returned
            .iter()
            .filter(|returned| returned.off() > GIVEN_BACK)
    }
}

/// The distribution with a part of the spread that was assumed, looked at from its own mean.
fn settled(
    setup: &Setup<f64>,
    shots: &[&Delivered],
    unknowns: &[Unknown],
    is_measured: &impl Fn(&'static Parameter) -> bool,
    kept: f64,
) -> Result<Population> {
    let n = unknowns.len();
    let mut of: Vec<Outcome> = vec![];
    for one in shots.iter().flat_map(|shot| &shot.explained) {
        if !of.contains(&one.measured.outcome) {
            of.push(one.measured.outcome);
        }
    }
    let (mut mean, mut covariance) = (DVector::zeros(n), DMatrix::zeros(n, n));
    let mut round = 0;
    loop {
        let launches = Launches::of(setup, &of, unknowns, &mean, &covariance)?;
        let told = Told::new(shots, &of, unknowns, is_measured, &mean, &launches)?;
        let eigen = told.information.clone().symmetric_eigen();
        let directions = |is_told: bool| {
            let columns: Vec<_> = (0..n)
                .filter(|&k| (eigen.eigenvalues[k] > TOLD) == is_told)
                .collect();
            DMatrix::from_fn(n, columns.len(), |i, k| eigen.eigenvectors[(i, columns[k])])
        };
        let (along, untold) = (directions(true), directions(false));
        let untold = &untold * untold.transpose();
        let assumed = &untold * (kept * kept);
        let moved = -(&untold * &mean);
        let begin = match round {
            0 => DMatrix::identity(along.ncols(), along.ncols()),
            _ => along.transpose() * &covariance * &along,
        };
        let (centre, spread) = told.most_likely(&along, &assumed, &moved, begin);
        let found = &along * &spread * along.transpose();
        let next = (&mean + &along * centre + moved, &found + &assumed);
        let change = (&next.0 - &mean).amax().max((&next.1 - &covariance).amax());
        round += 1;
        if round < ROUNDS && change >= SETTLED {
            (mean, covariance) = next;
            continue;
        }
        let errors = errors(&told, &along, &spread, shots.len() as f64);
        let left = (DMatrix::identity(n, n) + &told.information).try_inverse();
        let left = left.unwrap_or_else(|| DMatrix::zeros(n, n));
        let deviation = |i: usize| covariance[(i, i)].max(0.0).sqrt();
        let one = |(i, unknown): (usize, &Unknown)| {
            let variance = covariance[(i, i)];
            // what is assumed of the mean may be off by itself, and what is assumed of the
            // deviation may be there or not
            let by_deviation = (variance + errors[i][1]).max(0.0).sqrt() - variance.max(0.0).sqrt();
            Recovered {
                parameter: unknown.parameter,
                mean: unknown.before + unknown.sigma * mean[i],
                deviation: unknown.sigma * deviation(i),
                told: (1.0 - left[(i, i)]).clamp(0.0, 1.0),
                mean_error: unknown.sigma * (errors[i][0] + untold[(i, i)]).max(0.0).sqrt(),
                deviation_error: unknown.sigma
                    * (by_deviation * by_deviation + untold[(i, i)].max(0.0)).sqrt(),
            }
        };
        let correlation = |i: usize, j: usize| match i == j {
            true => 1.0,
            false => covariance[(i, j)] / (deviation(i) * deviation(j)),
        };
        return Ok(Population {
            spreads: unknowns.iter().enumerate().map(one).collect(),
            correlations: (0..n)
                .map(|i| (0..n).map(|j| correlation(i, j)).collect())
                .collect(),
            shots: shots.len(),
            kept: if untold.amax() > 0.0 { kept } else { 1.0 },
            returned: returned(shots, &of, &told, &launches),
        });
    }
}

/// The variance of the mean and the standard uncertainty of the variance that so many shots leave
/// along what they tell, of each parameter.
fn errors(told: &Told, along: &DMatrix<f64>, spread: &DMatrix<f64>, count: f64) -> Vec<[f64; 2]> {
    let of_instruments = (along.transpose() * told.information_beyond() * along).try_inverse();
    let of_instruments =
        of_instruments.unwrap_or_else(|| DMatrix::zeros(spread.nrows(), spread.ncols()));
    let seen = along * (spread + of_instruments) * along.transpose();
    // of a variance over so many (Wishart)
    (0..along.nrows())
        .map(|i| {
            [
                seen[(i, i)] / count,
                seen[(i, i)] * (2.0 / (count - 1.0)).sqrt(),
            ]
        })
        .collect()
}

/// Each outcome as measured, and as the swings give it.
fn returned(
    shots: &[&Delivered],
    of: &[Outcome],
    told: &Told,
    launches: &Launches,
) -> Vec<Returned> {
    let one = |(place, of): (usize, &Outcome)| {
        let mut rows = vec![];
        for (shot, off) in shots.iter().zip(&told.off) {
            for (explained, (at, off)) in shot.explained.iter().zip(off) {
                if *at == place {
                    let Measurement { value, sigma, .. } = explained.measured;
                    // of a direction all within half a turn of the mean swing's
                    let computed = of.unwrap_angle(value - off, launches.at[place]);
                    rows.push(DVector::from_vec(vec![
                        computed + off,
                        off - launches.bend[place],
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
        Returned {
            of: *of,
            measured: [mean[0], deviation],
            recovered: [mean[0] - mean[1], spread],
        }
    };
    of.iter().enumerate().map(one).collect()
}
