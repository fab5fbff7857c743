//! Multistart: local searches from many starting points, and the distinct local optima.

use super::checkpoint::{Checkpoint, SavedSearch};
use super::domain::{Domain, scaled_distance};
use super::iteration::Iteration;
use super::minimize::{minimize_observed, other_problem};
use super::observer::Observer;
use super::options::Options;
use super::problem::Problem;
use super::scaling::largest_scaled;
use super::sobol;
use super::solution::Solution;
use super::status::Status;
use crate::error::{Error, Result};
use crate::units::counted;
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A local optimum, and the starts whose searches ended there.
#[derive(Clone, Debug)]
pub struct LocalMinimum {
    /// Result of the search.
    pub solution: Solution,
    /// Indices of the starts whose searches ended here. All searches that were interrupted before
    /// they found a point with defined functions form one group.
    pub starts: Vec<usize>,
}

/// Callback that receives the number of a search, and its [`Iteration`] or [`Solution`].
pub type Callback<T> = Arc<dyn Fn(usize, &T) + Send + Sync>;

/// Callbacks, interrupt flag and checkpoint of searches that run in parallel.
#[derive(Clone, Default)]
pub struct Observers {
    /// Called at the start (iteration 0) and after every iteration, with the number of the start.
    pub iteration: Option<Callback<Iteration>>,
    /// Called at the end of every search, with the number of the start.
    pub end: Option<Callback<Solution>>,
    /// Interrupt flag: once true, all searches end with their best points so far.
    pub interrupt: Arc<AtomicBool>,
    /// Checkpoint in which the searches are saved, and from which they resume.
    pub checkpoint: Option<Arc<Checkpoint>>,
    /// True if every iteration contains its quadratic model, as in
    /// [`Observer::models`](super::Observer::models).
    pub models: bool,
}

impl Observers {
    /// The observer of search `number`: its callback, its models and the interrupt flag, without
    /// the checkpoint.
    pub(crate) fn of_search(&self, number: usize) -> Observer {
        let mut observer = Observer {
            interrupt: self.interrupt.clone(),
            models: self.models,
            ..Observer::default()
        };
        if let Some(show) = self.iteration.clone() {
            observer.iteration = Box::new(move |iteration| show(number, iteration));
        }
        observer
    }
}

/// Two optima count as equal if each variable differs by at most this fraction of its scale.
const SAME: f64 = 1e-6;

/// Starts spread evenly over the bounds: the given start, then points of the scrambled Sobol
/// sequence (Owen 1995; Burley 2020). On a side without a bound, the starts of a variable extend
/// one scale length from the given start.
///
/// # Errors
/// [`Error::Optimizer`] if `count` or the number of variables exceeds the limit of the sequence, or
/// if the domain or the start is invalid.
pub fn starts(domain: &Domain, start: &[f64], count: usize) -> Result<Vec<Vec<f64>>> {
    domain.check(start)?;
    let (bounds, scale) = (&domain.variables, domain.variables.scale(start));
    let most = sobol::LENGTH as usize;
    if count > most || start.len() > sobol::MOST_VARIABLES {
        return Err(Error::Optimizer(format!(
            "cannot spread {} over {}; give at most {most} starts and {} variables",
            counted(count as u64, "start"),
            counted(start.len() as u64, "variable"),
            sobol::MOST_VARIABLES
        )));
    }
    let coordinate = |index: usize, i: usize| {
        let end = |bound: f64, beyond: f64| {
            if bound.is_finite() {
                bound
            } else {
                start[i] + beyond
            }
        };
        let (low, high) = (end(bounds.low[i], -scale[i]), end(bounds.high[i], scale[i]));
        low + sobol::coordinate(index as u64, i, 0) * (high - low)
    };
    let spread = |index: usize| (0..start.len()).map(|i| coordinate(index, i)).collect();
    Ok(std::iter::once(bounds.project(start))
        .chain((0..count.saturating_sub(1)).map(spread))
        .collect())
}

/// Searches from every start in parallel. Returns the distinct local optima, best first, then the
/// results of searches that found no optimum. The order does not depend on the number of threads.
///
/// # Errors
/// Errors of [`minimize`](super::minimize()), and [`Error::Optimizer`] if there are no starts, or
/// if the checkpoint belongs to another problem.
pub fn minimize_from(
    problem: &(dyn Problem + Sync),
    domain: &Domain,
    starts: &[Vec<f64>],
    options: &Options,
    observers: &Observers,
) -> Result<Vec<LocalMinimum>> {
    if starts.is_empty() {
        return Err(Error::Optimizer(
            "there are no starts to search from".into(),
        ));
    }
    let search = |(number, start): (usize, &Vec<f64>)| {
        search_from(problem, domain, start, options, observers, number)
    };
    let solutions = match starts {
        // a single search starts no threads
        [only] => vec![search((0, only))?],
        _ => starts
            .par_iter()
            .enumerate()
            .map(search)
            .collect::<Result<Vec<_>>>()?,
    };
    Ok(distinct_optima(domain, solutions))
}

/// Runs search `number`. If the checkpoint contains this search, resumes it from there.
fn search_from(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    observers: &Observers,
    number: usize,
) -> Result<Solution> {
    let saved = observers
        .checkpoint
        .as_ref()
        .and_then(|checkpoint| checkpoint.saved(number));
    let resume = match saved {
        Some(SavedSearch::Done(solution)) if !solution.fits(domain) => return Err(other_problem()),
        Some(SavedSearch::Done(solution)) => {
            if let Some(end) = &observers.end {
                end(number, &solution);
            }
            return Ok(*solution);
        }
        Some(SavedSearch::Unfinished(snapshot)) => Some(*snapshot),
        None => None,
    };
    if observers.interrupt.load(Ordering::Relaxed) {
        let message = "stopped before it began".into();
        let found = Solution::without_point(domain, Status::Interrupted, message, start.to_vec());
        return Ok(found);
    }
    let mut observer = Observer {
        resume,
        ..observers.of_search(number)
    };
    if let Some(checkpoint) = observers.checkpoint.clone() {
        observer.save = Some(Box::new(move |snapshot| {
            checkpoint.save(number, SavedSearch::Unfinished(Box::new(snapshot.clone())))
        }));
    }
    let solution = minimize_observed(problem, domain, start, options, observer)?;
    if let Some(checkpoint) = &observers.checkpoint
        && !matches!(
            solution.status,
            Status::Interrupted | Status::IterationLimit
        )
    {
        checkpoint.save(number, SavedSearch::Done(Box::new(solution.clone())))?;
    }
    if let Some(end) = &observers.end {
        end(number, &solution);
    }
    Ok(solution)
}

/// Groups equal results and sorts them, best first.
fn distinct_optima(domain: &Domain, solutions: Vec<Solution>) -> Vec<LocalMinimum> {
    let mut locals: Vec<LocalMinimum> = vec![];
    for (number, solution) in solutions.into_iter().enumerate() {
        let scale = domain.variables.scale(&solution.x);
        let is_same = |local: &LocalMinimum| {
            // interrupted searches without a point at which f is defined form one group
            if solution.value.is_none() && solution.status == Status::Interrupted {
                return local.solution.value.is_none()
                    && local.solution.status == Status::Interrupted;
            }
            local.solution.status == solution.status
                && scaled_distance(&local.solution.x, &solution.x, &scale) <= SAME
        };
        match locals.iter_mut().find(|local| is_same(local)) {
            Some(local) => {
                local.starts.push(number);
                // keep the more accurate of two equal optima
                if solution.residual.largest() < local.solution.residual.largest() {
                    local.solution = solution;
                }
            }
            None => locals.push(LocalMinimum {
                solution,
                starts: vec![number],
            }),
        }
    }
    let rank = |local: &LocalMinimum| match local.solution.status {
        Status::Converged | Status::StalledAtKink => 0,
        Status::Stalled | Status::IterationLimit | Status::Interrupted => 1,
        Status::Infeasible => 2,
        Status::Unbounded => 3,
        Status::Undefined => 4,
    };
    let value = |local: &LocalMinimum| local.solution.value.unwrap_or(f64::MAX);
    let units = constraint_units(domain, &locals);
    // sort infeasible points by their sum of squared violations, smallest first
    let violation = |local: &LocalMinimum| -> f64 {
        if local.solution.status != Status::Infeasible {
            return 0.0;
        }
        let constraints = local.solution.constraints.iter().zip(&units);
        constraints
            .map(|(constraint, unit)| (constraint.violation / unit).powi(2))
            .sum()
    };
    let order = |a: &LocalMinimum, b: &LocalMinimum| {
        let by_violation = || violation(a).total_cmp(&violation(b));
        rank(a)
            .cmp(&rank(b))
            .then_with(by_violation)
            .then(value(a).total_cmp(&value(b)))
    };
    locals.sort_by(order);
    locals
}

/// Unit for the violations of each constraint, the same for all searches: the largest scaled
/// derivative of the constraint at the results, or 1 if this derivative is 0 or unknown. The scale
/// γ of one search cannot be the unit, because it depends on the start.
fn constraint_units(domain: &Domain, locals: &[LocalMinimum]) -> Vec<f64> {
    let mut largest = vec![0.0_f64; domain.constraints.dimension()];
    for LocalMinimum { solution, .. } in locals {
        let scale = domain.variables.scale(&solution.x);
        for (most, row) in largest.iter_mut().zip(&solution.jacobian) {
            *most = most.max(largest_scaled(row, &scale));
        }
    }
    largest
        .iter()
        .map(|most| if *most > 0.0 { *most } else { 1.0 })
        .collect()
}
