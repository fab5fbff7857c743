use crate::error::Result;
use crate::optimize::{Observer, Status, minimize_observed};
use crate::parameters::Setup;
use crate::study::Optimum;
use crate::study::problem::SearchProblem;
use crate::study::uncertainty::Interval;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bootstrap intervals of the best design: the search repeated over resamples of recorded swings.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampled {
    /// The 95 % interval of each varied parameter.
    pub design: Vec<Interval>,
    /// The 95 % interval of the objective.
    pub goal: Interval,
    /// The number of resamples whose search converged.
    pub rounds: usize,
    /// The best design compared with the setup's own.
    pub significance: Option<Significance>,
}

/// Significance of the gain of the best design over the setup's own, by recorded swings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Significance {
    /// The gain of the objective: its 95 % interval.
    pub better: Interval,
    /// The number of swings like these for a significant gain: at a confidence of 95 % with a power
    /// of 80 %.
    pub swings: Option<u64>,
}

/// z₀.₉₇₅ + z₀.₈.
const POWER: f64 = 1.959_963_985 + 0.841_621_234;

/// The optima of resamples of recorded swings. `None` if fewer than half of the searches converged,
/// if all swings are equal, and if `stop` became true before the end.
///
/// # Errors
/// As [`optimum`](crate::study::optimum).
pub fn resampled(
    setup: &Setup<f64>,
    best: &Optimum,
    rounds: usize,
    seed: u64,
    stop: &Arc<AtomicBool>,
) -> Result<Option<Resampled>> {
    let points = &best.search.scenarios.points;
    if points.iter().all(|point| *point == points[0]) {
        return Ok(None);
    }
    let is_stopped = || stop.load(Ordering::Relaxed);
    let problem = match SearchProblem::new(setup, &best.search, stop) {
        Err(_) if is_stopped() => return Ok(None),
        problem => problem?,
    };
    let n = best.search.scenarios.points.len();
    let sign = best.search.sense.sign();
    let round = |stream: u64| {
        if is_stopped() {
            return None;
        }
        let observer = Observer {
            interrupt: Arc::clone(stop),
            ..Observer::default()
        };
        let mut random = Xoshiro256PlusPlus::seed_from_u64(
            seed.wrapping_add(stream.wrapping_mul(0x9e37_79b9_7f4a_7c15)),
        );
        let mut weights = vec![0.0; n];
        for _ in 0..n {
            // the bias of the remainder is below n/2⁶⁴
            weights[(random.next_u64() % n as u64) as usize] += 1.0 / n as f64;
        }
        let value = |x: &[f64]| {
            problem
                .weighted_values(x, &weights)
                .ok()
                .map(|goals| goals[0])
        };
        let own = problem
            .weighted_as_set_up(&weights)
            .ok()
            .map(|goals| goals[0]);
        let gain = value(&best.solution.x)
            .zip(own)
            .map(|(best, own)| -sign * (best - own));
        let (weighted, domain, options) = (
            problem.weighted(weights.clone()),
            &problem.domain,
            &best.search.options,
        );
        let found = minimize_observed(&weighted, domain, &best.solution.x, options, observer);
        found
            .ok()
            .filter(|found| found.status == Status::Converged)
            .map(|found| (value(&found.x), found.x, gain))
    };
    let found: Vec<_> = (0..rounds as u64)
        .into_par_iter()
        .filter_map(round)
        .collect();
    let Some(value) = best.value().filter(|_| found.len() >= (rounds / 2).max(2)) else {
        return Ok(None);
    };
    let design = (0..best.solution.x.len())
        .map(|i| {
            interval(
                best.solution.x[i],
                found.iter().map(|(_, x, _)| x[i]).collect(),
            )
        })
        .collect();
    let goal = interval(
        value,
        found.iter().filter_map(|(value, ..)| *value).collect(),
    );
    let gains: Vec<f64> = found.iter().filter_map(|(.., gain)| *gain).collect();
    let significance = problem
        .as_set_up()
        .ok()
        .filter(|_| gains.len() >= 2)
        .map(|own| {
            let mean = -sign * (value - own[0]);
            let better = interval(mean, gains.clone());
            // the standard error falls as the root of the number of swings
            let centre = gains.iter().sum::<f64>() / gains.len() as f64;
            let variance = gains
                .iter()
                .map(|gain| (gain - centre).powi(2))
                .sum::<f64>()
                / (gains.len() as f64 - 1.0);
            let swings = (POWER / mean).powi(2) * variance * n as f64;
            Significance {
                better,
                swings: (mean > 0.0 && swings.is_finite()).then(|| swings.ceil() as u64),
            }
        });
    if is_stopped() {
        return Ok(None);
    }
    Ok(Some(Resampled {
        design,
        goal,
        rounds: found.len(),
        significance,
    }))
}

/// The 95 % interval of an estimate by the quantiles of its resamples.
fn interval(value: f64, mut resamples: Vec<f64>) -> Interval {
    resamples.sort_by(f64::total_cmp);
    let last = resamples.len().saturating_sub(1) as f64;
    let at = |share: f64| {
        resamples
            .get((share * last).round() as usize)
            .copied()
            .unwrap_or(f64::NAN)
    };
    Interval {
        value,
        low: at(0.025),
        high: at(0.975),
    }
}
