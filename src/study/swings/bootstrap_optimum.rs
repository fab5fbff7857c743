use crate::error::Result;
use crate::json::by_name;
use crate::optimize::{Observer, Status, minimize_observed};
use crate::parameters::{Parameter, Setup};
use crate::statistics::Moments;
use crate::study::Optimum;
use crate::study::problem::SearchProblem;
use crate::study::uncertainty::Interval;
use crate::study::uncertainty::bootstrap::{resampled_rows, small_sample_interval};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The optima of resamples of recorded swings.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ResampledReport"))]
pub struct BootstrapOptimum {
    /// The interval of about 95 % of each varied parameter, within its range.
    #[serde(rename = "optimum", serialize_with = "by_name")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, Interval>"))]
    pub design: Vec<(&'static Parameter, Interval)>,
    /// The interval of about 95 % of the objective.
    #[serde(rename = "value")]
    pub goal: Interval,
    /// The number of resamples whose search converged.
    pub rounds: usize,
    /// The interval of about 95 % of the gain over the design before the search; `null` if the ball
    /// does not fly in one of the swings.
    #[serde(rename = "better_than_set_up")]
    pub gain: Option<Interval>,
    /// The number of swings needed to distinguish the best design from the design before the
    /// search; `null` if the gain is unknown or not positive.
    // at a confidence of 95 % and a power of 80 %
    #[serde(rename = "swings_to_tell")]
    pub swings_needed: Option<u64>,
}

/// z₀.₉₇₅ + z₀.₈, normal quantiles for a confidence of 95 % and a power of 80 %.
const POWER: f64 = 1.959_963_985 + 0.841_621_234;

/// Confidence intervals of the optimum `best` by the bootstrap: searches over `rounds` resamples of
/// its recorded swings, drawn with replacement. `None` if fewer than half of the searches
/// converged, if all swings are equal, or if `stop` became true before the end.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn bootstrap_optimum(
    setup: &Setup<f64>,
    best: &Optimum,
    rounds: usize,
    seed: u64,
    stop: &Arc<AtomicBool>,
) -> Result<Option<BootstrapOptimum>> {
    let points = &best.search.scenarios.points;
    if points.iter().all(|point| *point == points[0]) {
        return Ok(None);
    }
    let is_stopped = || stop.load(Ordering::Relaxed);
    let problem = match SearchProblem::new(setup, best.search.clone(), stop) {
        Err(_) if is_stopped() => return Ok(None),
        problem => problem?,
    };
    let round = |stream: u64| {
        if is_stopped() {
            return None;
        }
        search_resample(&problem, best, resample(points.len(), seed, stream), stop)
    };
    let found: Vec<Round> = (0..rounds as u64)
        .into_par_iter()
        .filter_map(round)
        .collect();
    let Some(value) = best.value().filter(|_| found.len() >= (rounds / 2).max(2)) else {
        return Ok(None);
    };
    let varied = best.search.vary.iter().zip(&best.solution.x).enumerate();
    let design = varied.map(|(i, (vary, x))| {
        let resamples = found.iter().map(|round| round.x[i]).collect();
        let interval = small_sample_interval(*x, resamples, points.len());
        (vary.parameter, interval.clipped([vary.low, vary.high]))
    });
    let values = found.iter().filter_map(|round| round.value).collect();
    let goal = small_sample_interval(value, values, points.len()).clipped(best.search.of.range());
    let gains: Vec<f64> = found.iter().filter_map(|round| round.gain).collect();
    let own = problem.goals_as_set_up().ok().filter(|_| gains.len() >= 2);
    let mean = own.map(|own| -best.search.sense.sign() * (value - own[0]));
    if is_stopped() {
        return Ok(None);
    }
    Ok(Some(BootstrapOptimum {
        design: design.collect(),
        goal,
        rounds: found.len(),
        swings_needed: mean.and_then(|mean| swings_needed(mean, &gains, points.len())),
        gain: mean.map(|mean| small_sample_interval(mean, gains, points.len())),
    }))
}

/// The weights of a resample of n swings, drawn with replacement.
fn resample(n: usize, seed: u64, stream: u64) -> Vec<f64> {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(
        seed.wrapping_add(stream.wrapping_mul(0x9e37_79b9_7f4a_7c15)),
    );
    let mut weights = vec![0.0; n];
    for row in resampled_rows(&mut random, n) {
        weights[row] += 1.0 / n as f64;
    }
    weights
}

/// The optimum of a resample.
struct Round {
    x: Vec<f64>,
    /// Value of the objective at this optimum, with the swings of the resample; `None` if the ball
    /// does not fly in one of the swings.
    value: Option<f64>,
    /// Gain of the objective from the setup's design to the best design for all swings. It is
    /// computed with the swings of the resample; `None` if the ball does not fly in one of these
    /// swings.
    gain: Option<f64>,
}

/// Searches over the resample with these weights, starting at the best design for all swings.
/// `None` if the search does not converge.
fn search_resample(
    problem: &SearchProblem,
    best: &Optimum,
    weights: Vec<f64>,
    stop: &Arc<AtomicBool>,
) -> Option<Round> {
    let x = &best.solution.x;
    let objective = |goals: Result<Vec<f64>>| Some(goals.ok()?[0]);
    let value = |x: &[f64]| {
        let setup = problem.setup_at(x).ok()?;
        objective(problem.goals_with_weights(&setup, x, &weights))
    };
    let own = objective(problem.goals_with_weights(
        &problem.as_given,
        &problem.design_as_set_up(),
        &weights,
    ));
    let sign = best.search.sense.sign();
    let gain = value(x).zip(own).map(|(best, own)| -sign * (best - own));
    let weighted = |x: &[f64]| problem.weighted(x, &weights);
    let observer = Observer {
        interrupt: Arc::clone(stop),
        ..Observer::default()
    };
    let options = &best.search.options;
    let found = minimize_observed(&weighted, &problem.domain, x, options, observer).ok()?;
    (found.status == Status::Converged).then(|| Round {
        value: value(&found.x),
        x: found.x,
        gain,
    })
}

/// The number of swings from which the gain `mean` differs significantly from 0. `gains` are the
/// gains in resamples of n swings. `None` if `mean` is not positive.
fn swings_needed(mean: f64, gains: &[f64], n: usize) -> Option<u64> {
    let moments = Moments::of(gains.iter().copied());
    let deviation = moments.deviation().unwrap_or(f64::NAN);
    // the standard error decreases with the root of the number of swings
    let swings = (POWER * deviation / mean).powi(2) * n as f64;
    (mean > 0.0 && swings.is_finite()).then(|| swings.ceil() as u64)
}
