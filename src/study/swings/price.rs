use super::golfer::Swings;
use super::measure::Measure;
use super::scenarios::Scenarios;
use crate::error::Result;
use crate::optimize::{Observer, minimize_observed};
use crate::parameters::Setup;
use crate::statistics::Moments;
use crate::study::problem::SearchProblem;
use crate::study::uncertainty::Interval;
use crate::study::{Goal, Optimum, Search};
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Loss of a design that is optimized for the mean swing only, and the accuracy of the goals.
#[derive(Clone, Debug)]
pub struct Price {
    /// The best design for the mean swing, or the reason why it was not found.
    pub nominal: std::result::Result<Nominal, String>,
    /// The error of each goal at the best design (first the objective, then the limited goals),
    /// estimated by other scenarios of the same swings. Empty without other scenarios.
    pub errors: Vec<GoalError>,
}

impl Price {
    /// The error of the objective; `None` without other scenarios.
    pub fn error(&self) -> Option<&GoalError> {
        self.errors.first()
    }
}

/// The best design for the mean swing.
#[derive(Clone, Debug, PartialEq)]
pub struct Nominal {
    /// The design.
    pub design: Vec<f64>,
    /// The values of the goals at this design for the mean swing.
    pub promised: Vec<f64>,
    /// The values of the goals at this design over all swings; `None` if the ball does not fly in
    /// one of the swings.
    pub kept: Option<Vec<f64>>,
}

/// The error of a goal, estimated by other scenarios with the same design.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalError {
    /// The error of the quadrature: twice the change of the goal with 1.5 times as many nodes.
    Quadrature(f64),
    /// The error of a sequence of swings.
    Sampling(SamplingError),
    /// Unknown, because the ball does not fly in a swing of the other scenarios. The text names the
    /// swing and the reason.
    Unknown(String),
}

/// A confidence interval of the objective, from independent sequences of swings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "SamplingReport"))]
pub struct SamplingError {
    /// The 99 % interval, extended to the reported `value` if this lies outside.
    pub interval: Interval,
    /// The number of sequences.
    pub sequences: usize,
}

/// The quantile of Student's distribution for an interval of 99 %.
const QUANTILE: f64 = 0.995;

/// Computes the best design for the mean swing and the errors of the goals. If the mean swing or
/// another scenario does not fly, the corresponding field contains the reason.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn price(setup: &Setup<f64>, swings: &Swings, best: &Optimum) -> Result<Price> {
    computed(setup, swings, best, &Arc::default())
}

/// Like [`price`]; `None` if `stop` became true before the end.
///
/// # Errors
/// The errors of [`price`].
pub fn price_until(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<Option<Price>> {
    let found = computed(setup, swings, best, stop);
    if stop.load(Ordering::Relaxed) {
        Ok(None)
    } else {
        found.map(Some)
    }
}

/// Computes [`price`]; the result is incomplete once `stop` is true.
fn computed(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<Price> {
    let search = &best.search;
    let mean_swing = over(search, Scenarios::mean(swings));
    let alone = SearchProblem::new(setup, mean_swing, stop)?;
    let observer = Observer {
        interrupt: Arc::clone(stop),
        ..Observer::default()
    };
    let design = minimize_observed(
        &alone,
        &alone.domain,
        &alone.start(),
        &search.options,
        observer,
    )?
    .x;
    let kept = SearchProblem::new(setup, search.clone(), stop)?
        .values(&design)
        .ok();
    let nominal = alone.values(&design).map(|promised| Nominal {
        design,
        promised,
        kept,
    });
    let nominal = nominal.map_err(|error| error.to_string());
    let errors = match best.goals.as_deref() {
        Some(goals) => errors_of(setup, swings, best, goals, stop)
            .unwrap_or_else(|error| vec![GoalError::Unknown(error.to_string()); goals.len()]),
        None => vec![],
    };
    Ok(Price { nominal, errors })
}

/// `search` with other scenarios.
fn over(search: &Search, scenarios: Scenarios) -> Search {
    Search {
        scenarios,
        ..search.clone()
    }
}

/// The quadrature or sampling error of each goal at the best design.
fn errors_of(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &Optimum,
    goals: &[f64],
    stop: &Arc<AtomicBool>,
) -> Result<Vec<GoalError>> {
    let (search, x) = (&best.search, &best.solution.x);
    let of: Vec<&Goal> = search.goals().collect();
    let finer = match best
        .search
        .scenarios
        .rule
        .finer()
        .filter(|_| !of.iter().all(|goal| goal.has_edge()))
    {
        Some(rule) => {
            let finer = over(search, Scenarios::new(swings, rule)?);
            Some(SearchProblem::new(setup, finer, stop)?.values(x)?)
        }
        None => None,
    };
    let replications = match finer.is_none() || of.iter().any(|goal| goal.has_edge()) {
        true => SearchProblem::new(setup, search.clone(), stop)?.replications(x)?,
        false => vec![],
    };
    let error = |(k, (goal, value)): (usize, (&&Goal, &f64))| match &finer {
        // neglect the error of the finer rule
        Some(finer) if !goal.has_edge() => GoalError::Quadrature(2.0 * (finer[k] - value).abs()),
        _ => {
            let others: Vec<f64> = replications.iter().map(|values| values[k]).collect();
            GoalError::Sampling(SamplingError {
                interval: interval(goal, *value, &others),
                sequences: others.len(),
            })
        }
    };
    if finer.is_none() && replications.is_empty() {
        return Ok(vec![]);
    }
    Ok(of.iter().zip(goals).enumerate().map(error).collect())
}

/// The 99 % interval of a goal from independent estimates: Student's interval about the mean of the
/// estimates, extended to the reported value.
fn interval(goal: &Goal, value: f64, others: &[f64]) -> Interval {
    let n = others.len() as f64;
    let moments = Moments::of(others.iter().copied());
    let [mean, deviation] =
        [moments.mean(), moments.deviation()].map(|number| number.unwrap_or(f64::NAN));
    let quantile = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(QUANTILE));
    let reach = quantile * deviation / n.sqrt();
    let (mut low, mut high) = (value.min(mean - reach), value.max(mean + reach));
    if let [(1.0, Measure::Within(..))] = goal.terms.as_slice() {
        (low, high) = (low.max(0.0), high.min(1.0));
    }
    Interval { value, low, high }
}
