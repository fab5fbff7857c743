use super::bootstrap_optimum::BootstrapOptimum;
use super::golfer::Swings;
use super::measure::Measure;
use super::scenarios::{Rule, Scenarios};
use crate::error::Result;
use crate::optimize::{Observer, Status, minimize_observed};
use crate::parameters::Setup;
use crate::statistics::Moments;
use crate::study::problem::SearchProblem;
use crate::study::uncertainty::Interval;
use crate::study::{Goal, Optimum, Search};
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Results of a search over swings in addition to the optimum: the best design for the mean swing,
/// the errors of the goals, and the optima of resamples.
#[derive(Clone, Debug)]
pub struct SwingsAnalysis {
    /// The best design for the mean swing, or in plain words the reason why it is not known.
    pub nominal: std::result::Result<Nominal, String>,
    /// The error of each goal at the best design for all swings: first the objective, then the
    /// limited goals. The errors are estimated from other scenarios of the same distributions.
    /// Empty for recorded swings, which have no other scenarios, and if the goals have no value.
    pub errors: Vec<GoalError>,
    /// The optima of resamples of recorded swings, from
    /// [`bootstrap_optimum`](super::bootstrap_optimum); `None` unless they were computed.
    pub resampled: Option<BootstrapOptimum>,
}

impl SwingsAnalysis {
    /// The error of the objective; `None` if [`errors`](Self::errors) is empty.
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
    pub for_mean_swing: Vec<f64>,
    /// The values of the goals at this design over all swings; `None` if the ball does not fly in
    /// one of the swings.
    pub over_swings: Option<Vec<f64>>,
}

/// The error of a goal, estimated from other scenarios with the same design.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalError {
    /// The error of the quadrature, SI: twice the change of the goal with 1.5 times as many nodes
    /// for each parameter.
    Quadrature(f64),
    /// The sampling error of a Sobol' sequence of swings.
    Sampling(SamplingError),
    /// The reason why the error is unknown, for example that the ball does not fly in a swing of
    /// the other scenarios.
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

/// Cumulative probability of Student's t distribution at the upper end of a 99 % interval.
const QUANTILE: f64 = 0.995;
/// Safety factor of the quadrature error, because the finer rule has an error too.
const SAFETY: f64 = 2.0;

/// Computes the best design for the mean swing, and the errors of the goals at the optimum `best`
/// over `swings`. `None` if `stop` became true before the end.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn analyse_over_swings(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<Option<SwingsAnalysis>> {
    let found = analysed(setup, swings, best, stop);
    if stop.load(Ordering::Relaxed) {
        Ok(None)
    } else {
        found.map(Some)
    }
}

/// The result of [`analyse_over_swings`], which is incomplete if `stop` became true.
fn analysed(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<SwingsAnalysis> {
    let search = &best.search;
    let for_mean_swing = Search {
        scenarios: Scenarios::mean(swings),
        ..search.clone()
    };
    let mean_swing = SearchProblem::new(setup, for_mean_swing, stop)?;
    let all_swings = SearchProblem::new(setup, search.clone(), stop)?;
    let observer = Observer {
        interrupt: Arc::clone(stop),
        ..Observer::default()
    };
    let found = minimize_observed(
        &mean_swing,
        &mean_swing.domain,
        &mean_swing.start(),
        &search.options,
        observer,
    )?;
    let nominal = match found.status {
        Status::Converged => mean_swing
            .goals_at(&found.x, stop)
            .map_err(|error| error.to_string())
            .map(|for_mean_swing| Nominal {
                for_mean_swing,
                over_swings: all_swings.goals_at(&found.x, stop).ok(),
                design: found.x,
            }),
        status => Err(why_no_design(status, &search.of)),
    };
    Ok(SwingsAnalysis {
        nominal,
        errors: match best.goals.as_deref() {
            Some(goals) => goal_errors(&all_swings, swings, &best.solution.x, goals),
            None => vec![],
        },
        resampled: None,
    })
}

/// Why a search for the mean swing that ended with `status` found no best design.
fn why_no_design(status: Status, goal: &Goal) -> String {
    let root_mean_square = goal.terms.iter().find_map(|(_, measure)| match measure {
        Measure::RootMeanSquare(of) => Some(of.name()),
        _ => None,
    });
    match (status, root_mean_square) {
        // of one swing the root mean square of an outcome is its absolute value
        (Status::StalledAtKink, Some(of)) => {
            format!(
                "for a single swing rms({of}) is |{of}|, which has a corner at 0; the search stopped \
                 at a corner"
            )
        }
        (Status::StalledAtKink, None) => {
            format!("its search stopped at a corner of {}", goal.expression)
        }
        (Status::Infeasible, _) => {
            "no design was found that meets the limits with this swing".into()
        }
        (Status::Undefined, _) => {
            "the ball of this swing flies with no design that was tried".into()
        }
        (status, _) => format!("its search ended before an optimum ({})", status.name()),
    }
}

/// The error of each goal at the best design `x`, where the goals have the values `goals`. With
/// Gauss's rule, a smooth goal is compared with a finer rule. Every other goal is compared with
/// independent Sobol' sequences. If the ball does not fly in a swing of the finer rule, the errors
/// of the smooth goals are unknown. If it does not fly in a swing of the sequences, the errors of
/// the other goals are unknown. Empty without distributions.
fn goal_errors(
    problem: &SearchProblem,
    swings: &Swings,
    x: &[f64],
    goals: &[f64],
) -> Vec<GoalError> {
    let search = &problem.search;
    let of: Vec<&Goal> = search.goals().collect();
    let has_smooth_goal = !of.iter().all(|goal| goal.has_edge());
    let finer = match search.scenarios.rule {
        Rule::Quadrature(nodes) if has_smooth_goal => {
            // 1.5 times as many nodes, and at least one more
            let rule = Rule::Quadrature(nodes + (nodes / 2).max(1));
            let scenarios = Scenarios::new(swings, rule);
            let problem = scenarios.and_then(|scenarios| {
                let search = Search {
                    scenarios,
                    ..search.clone()
                };
                SearchProblem::new(&problem.as_given, search, &problem.stop)
            });
            Some(problem.and_then(|problem| problem.goals_at(x, &problem.stop)))
        }
        _ => None,
    };
    let replications = match finer.is_none() || of.iter().any(|goal| goal.has_edge()) {
        true => problem.replications(x),
        false => Ok(vec![]),
    };
    if finer.is_none() && replications.as_ref().is_ok_and(Vec::is_empty) {
        return vec![];
    }
    let error = |(k, (goal, value)): (usize, (&&Goal, &f64))| match (&finer, &replications) {
        (Some(Ok(finer)), _) if !goal.has_edge() => {
            GoalError::Quadrature(SAFETY * (finer[k] - value).abs())
        }
        (Some(Err(error)), _) if !goal.has_edge() => GoalError::Unknown(error.to_string()),
        (_, Err(error)) => GoalError::Unknown(error.to_string()),
        (_, Ok(replications)) => {
            let others: Vec<f64> = replications.iter().map(|values| values[k]).collect();
            GoalError::Sampling(SamplingError {
                interval: interval(goal, *value, &others),
                sequences: others.len(),
            })
        }
    };
    of.iter().zip(goals).enumerate().map(error).collect()
}

/// The 99 % interval of a goal from independent estimates: Student's interval about the mean of the
/// estimates, extended until it contains the reported value.
fn interval(goal: &Goal, value: f64, others: &[f64]) -> Interval {
    let n = others.len() as f64;
    let moments = Moments::of(others.iter().copied());
    let [mean, deviation] =
        [moments.mean, moments.deviation()].map(|number| number.unwrap_or(f64::NAN));
    let quantile = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(QUANTILE));
    let reach = quantile * deviation / n.sqrt();
    let interval = Interval {
        value,
        low: value.min(mean - reach),
        high: value.max(mean + reach),
    };
    interval.clipped(goal.range())
}
