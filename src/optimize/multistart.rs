//! Local searches from many starts: the local optima they end at, best first.

use super::checkpoint::{Checkpoint, Run};
use super::domain::Domain;
use super::minimize::{minimize_observed, other_problem};
use super::observer::Observer;
use super::options::Options;
use super::problem::Problem;
use super::sobol;
use super::solution::{Iteration, Solution};
use super::status::Status;
use crate::error::{Error, Result};
use crate::units::counted;
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A local optimum, and how many starts lead to it.
#[derive(Clone, Debug)]
pub struct Local {
    /// The optimum.
    pub solution: Solution,
    /// The starts that ended here, by number; those that were stopped before they had a value are
    /// together.
    pub starts: Vec<usize>,
}

/// Shows something of the search of this number.
pub type Shown<T> = Arc<dyn Fn(usize, &T) + Send + Sync>;

/// Who follows searches that run side by side.
#[derive(Clone, Default)]
pub struct Follow {
    /// Is shown every iteration, with the start's number.
    pub iteration: Option<Shown<Iteration>>,
    /// Is shown the end of every search, with the start's number.
    pub end: Option<Shown<Solution>>,
    /// Ends all searches, with the best points so far, once it is true.
    pub interrupt: Arc<AtomicBool>,
    /// Keeps the searches, and knows those that were kept before.
    pub checkpoint: Option<Arc<Checkpoint>>,
}

/// Optima closer than this in every variable, in units of its scale, are one.
const SAME: f64 = 1e-6;

/// Starts spread evenly over the bounds: the one given, then points of Sobol's sequence, scrambled
/// (Owen 1995; Burley 2020). Where a variable has no end, the spread reaches as far from the start
/// as its scale.
///
/// # Errors
/// [`Error::Optimizer`] for more starts or variables than the sequence has, and for a domain or a
/// start that makes no sense.
pub fn starts(domain: &Domain, start: &[f64], count: usize) -> Result<Vec<Vec<f64>>> {
    domain.check(start)?;
    let (bounds, scale) = (&domain.variables, domain.variables.scale(start));
    let most = 1 << 16;
    if count > most || start.len() > sobol::MOST_VARIABLES {
        return Err(Error::Optimizer(format!(
            "{} in {} cannot be spread; at most {most} starts in {} variables can",
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

/// Searches from every start, side by side; the local optima found, best first, then what ended
/// otherwise. The order does not depend on how many threads there are.
///
/// # Errors
/// As [`minimize`](super::minimize()); [`Error::Optimizer`] without starts, and for a checkpoint of
/// another problem.
pub fn minimize_from(
    problem: &(dyn Problem + Sync),
    domain: &Domain,
    starts: &[Vec<f64>],
    options: &Options,
    follow: &Follow,
) -> Result<Vec<Local>> {
    if starts.is_empty() {
        return Err(Error::Optimizer(
            "there are no starts to search from".into(),
        ));
    }
    let search =
        |(number, start): (usize, &Vec<f64>)| one(problem, domain, start, options, follow, number);
    let solutions = match starts {
        // nothing to share: no threads are started
        [only] => vec![search((0, only))?],
        _ => starts
            .par_iter()
            .enumerate()
            .map(search)
            .collect::<Result<Vec<_>>>()?,
    };
    Ok(collected(domain, solutions))
}

fn one(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    follow: &Follow,
    number: usize,
) -> Result<Solution> {
    let kept = follow
        .checkpoint
        .as_ref()
        .and_then(|checkpoint| checkpoint.run(number));
    let resume = match kept {
        Some(Run::Done(solution)) if !solution.is_of(domain) => return Err(other_problem()),
        Some(Run::Done(solution)) => {
            if let Some(end) = &follow.end {
                end(number, &solution);
            }
            return Ok(*solution);
        }
        Some(Run::Going(snapshot)) => Some(*snapshot),
        None => None,
    };
    if follow.interrupt.load(Ordering::Relaxed) {
        return Ok(Solution::not_begun(domain, start.to_vec()));
    }
    let mut observer = Observer {
        interrupt: follow.interrupt.clone(),
        resume,
        ..Observer::default()
    };
    if let Some(show) = follow.iteration.clone() {
        observer.iteration = Box::new(move |iteration| show(number, iteration));
    }
    if let Some(checkpoint) = follow.checkpoint.clone() {
        observer.keep = Some(Box::new(move |snapshot| {
            checkpoint.keep(number, Run::Going(Box::new(snapshot.clone())))
        }));
    }
    let solution = minimize_observed(problem, domain, start, options, observer)?;
    if let Some(checkpoint) = &follow.checkpoint
        && !matches!(
            solution.status,
            Status::Interrupted | Status::IterationLimit
        )
    {
        checkpoint.keep(number, Run::Done(Box::new(solution.clone())))?;
    }
    if let Some(end) = &follow.end {
        end(number, &solution);
    }
    Ok(solution)
}

/// The distinct ends of searches, best first.
fn collected(domain: &Domain, solutions: Vec<Solution>) -> Vec<Local> {
    let mut locals: Vec<Local> = vec![];
    for (number, solution) in solutions.into_iter().enumerate() {
        let scale = domain.variables.scale(&solution.x);
        let is_same = |local: &Local| {
            // of what was stopped before it had a value nothing is known to tell it apart by
            if solution.value.is_none() && solution.status == Status::Interrupted {
                return local.solution.value.is_none()
                    && local.solution.status == Status::Interrupted;
            }
            let mut apart = local
                .solution
                .x
                .iter()
                .zip(&solution.x)
                .zip(&scale)
                .map(|((a, b), s)| ((a - b) / s).abs());
            local.solution.status == solution.status && apart.all(|apart| apart <= SAME)
        };
        match locals.iter_mut().find(|local| is_same(local)) {
            Some(local) => {
                local.starts.push(number);
                // of the same optimum, the sharper
                if solution.kkt_residual < local.solution.kkt_residual {
                    local.solution = solution;
                }
            }
            None => locals.push(Local {
                solution,
                starts: vec![number],
            }),
        }
    }
    let rank = |local: &Local| match local.solution.status {
        Status::Converged | Status::StalledAtKink => 0,
        Status::Stalled | Status::IterationLimit | Status::Interrupted => 1,
        Status::Infeasible => 2,
        Status::Unbounded => 3,
        Status::Undefined => 4,
    };
    let value = |local: &Local| local.solution.value.unwrap_or(f64::MAX);
    let steepest = steepest(domain, &locals);
    // of points that do not meet the constraints, the nearest to it
    let missed = |local: &Local| match local.solution.status {
        Status::Infeasible => missed_by(&local.solution, &steepest),
        _ => 0.0,
    };
    let order = |a: &Local, b: &Local| {
        let nearer = || missed(a).total_cmp(&missed(b));
        rank(a)
            .cmp(&rank(b))
            .then_with(nearer)
            .then(value(a).total_cmp(&value(b)))
    };
    locals.sort_by(order);
    locals
}

/// The steepest slope of each constraint at the ends of all searches, over the scales of the
/// variables: each search measures by the slopes at its own start, which cannot be compared. 1
/// where none is known.
fn steepest(domain: &Domain, locals: &[Local]) -> Vec<f64> {
    let mut steepest = vec![0.0_f64; domain.constraints.dimension()];
    for Local { solution, .. } in locals {
        let scale = domain.variables.scale(&solution.x);
        for (most, row) in steepest.iter_mut().zip(&solution.jacobian) {
            *most = row.iter().zip(&scale).fold(*most, |most, (slope, scale)| {
                most.max((slope * scale).abs())
            });
        }
    }
    steepest
        .iter()
        .map(|most| if *most > 0.0 { *most } else { 1.0 })
        .collect()
}

/// How far a solution is from meeting its constraints, each over a size of its own.
fn missed_by(solution: &Solution, sizes: &[f64]) -> f64 {
    solution
        .constraints
        .iter()
        .zip(sizes)
        .map(|(constrained, size)| (constrained.violation / size).powi(2))
        .sum()
}
