//! Checks the optimum of one drive: compares it with drives at sample points of the ranges. The
//! drives of the sample are computed without derivatives.

use super::problem::SearchProblem;
use crate::error::Result;
use crate::optimize::{Bounds, Solution, Status, starts};
use crate::statistics::{extent, largest_magnitude};
use serde::Serialize;

/// The comparison of an optimum with a sample of the ranges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Sample {
    /// The number of points: for up to 4 parameters the corners of their ranges, then a scrambled
    /// Sobol' sequence over the ranges.
    pub points: usize,
    /// The number of points whose drives fly and meet every constraint.
    pub feasible: usize,
    /// The number of points better than the optimum; for an infeasible optimum, points with a
    /// smaller violation.
    pub better: usize,
    /// True if a search from one of the points led to the optimum.
    pub improved: bool,
}

/// Number of points of a sample.
const POINTS: usize = 128;

/// Largest number of varied parameters for which a sample has the corners of the ranges: 16 of its
/// points.
const MOST_WITH_CORNERS: usize = 4;

/// Number of points of a batch. The interrupt flag is checked before each batch.
const AT_ONCE: usize = 16;

/// Largest number of searches from points of a sample.
const SEARCHES: usize = 3;

/// If a smaller fraction of the points is feasible, a search starts at the best point even if this
/// point is no better than the optimum. The feasible region may be disconnected.
const LEAST_FEASIBLE: f64 = 1.0 / 8.0;

/// Compares the end of a search with a sample of the ranges. `search` starts from the points that
/// are better than the best solution so far. If few points are feasible, it starts from the best
/// point in any case (see [`LEAST_FEASIBLE`]). `end` becomes the best solution. `None` if the
/// search was interrupted before all points were evaluated.
pub(super) fn compare_with_sample(
    problem: &SearchProblem,
    end: &mut Solution,
    mut search: impl FnMut(&[f64]) -> Result<Solution>,
) -> Result<Option<Sample>> {
    let Some(points) = fly(problem)? else {
        return Ok(None);
    };
    let scale = MeritScale::of(problem, &points);
    let mut ranked: Vec<_> = points
        .iter()
        .map(|point| (scale.of_point(point), point))
        .collect();
    ranked.sort_by(|(a, _), (b, _)| {
        a.violation
            .total_cmp(&b.violation)
            .then(a.objective.total_cmp(&b.objective))
    });

    let feasible = ranked.iter().filter(|(merit, _)| merit.is_feasible).count();
    let is_in_parts = feasible > 0 && (feasible as f64) < LEAST_FEASIBLE * POINTS as f64;
    let (mut best, mut improved) = (scale.of_solution(end), false);
    for (at, (merit, point)) in ranked.iter().take(SEARCHES).enumerate() {
        if !(scale.is_better(merit, &best) || is_in_parts && at == 0) {
            break;
        }
        let found = search(&point.x)?;
        let merit = scale.of_solution(&found);
        if scale.is_better(&merit, &best) {
            (best, *end, improved) = (merit, found, true);
        }
    }
    let better = ranked
        .iter()
        .filter(|(merit, _)| scale.is_better(merit, &best))
        .count();
    Ok(Some(Sample {
        points: POINTS,
        feasible,
        better,
        improved,
    }))
}

/// A point of a sample whose drive has every outcome.
struct SampledPoint {
    x: Vec<f64>,
    objective: f64,
    constraints: Vec<f64>,
}

/// The points of the sample whose drives have every outcome; `None` if the search was interrupted
/// before all points of the sample were evaluated.
fn fly(problem: &SearchProblem) -> Result<Option<Vec<SampledPoint>>> {
    let mut sample = corners(&problem.domain.variables);
    let others = starts(&problem.domain, &problem.start(), 1 + POINTS - sample.len())?;
    // omit the first start, which is the setup's own
    sample.extend(others.into_iter().skip(1));
    let batch = problem.batch()?;
    let mut points = vec![];
    for some in sample.chunks(AT_ONCE) {
        if problem.is_stopped() {
            return Ok(None);
        }
        let block = batch.evaluate(0, some.concat());
        points.extend(some.iter().enumerate().filter_map(|(row, x)| {
            let outcomes = block.outcomes(row).collect::<Option<Vec<f64>>>()?;
            let mut values = problem.goals_of(x, outcomes);
            let constraints = values.split_off(1);
            Some(SampledPoint {
                x: x.clone(),
                objective: problem.search.sense.sign() * values[0],
                constraints,
            })
        }));
    }
    Ok(Some(points))
}

/// The corners of the ranges. They are outside a Sobol' sequence, and an optimum is often at one of
/// them. Empty for more than [`MOST_WITH_CORNERS`] parameters.
fn corners(ranges: &Bounds) -> Vec<Vec<f64>> {
    let varied = (0..ranges.dimension()).filter(|&i| !ranges.is_fixed(i));
    let varied: Vec<usize> = varied.collect();
    if varied.len() > MOST_WITH_CORNERS {
        return vec![];
    }
    let corner = |number: usize| {
        let mut x = ranges.low.clone();
        for (k, &i) in varied.iter().enumerate() {
            if (number >> k) & 1 == 1 {
                x[i] = ranges.high[i];
            }
        }
        x
    };
    (0..1 << varied.len()).map(corner).collect()
}

/// Rank of a point. Points are compared by constraint violation first, then by objective.
struct Merit {
    is_feasible: bool,
    /// The largest violation of a constraint, divided by the range of its goal over the sample.
    violation: f64,
    /// The objective times [`Sense::sign`](super::Sense::sign), which is minimized.
    objective: f64,
}

struct MeritScale<'a> {
    problem: &'a SearchProblem,
    /// The range of each limited goal over the sample.
    constraints: Vec<f64>,
    /// Rounding error of the objective.
    rounding: f64,
}

impl<'a> MeritScale<'a> {
    fn of(problem: &'a SearchProblem, points: &[SampledPoint]) -> Self {
        const ROUNDING: f64 = 1e-9;
        let spread = |j: usize| {
            let [low, high] = extent(points.iter().map(|point| point.constraints[j]));
            if high > low { high - low } else { 1.0 }
        };
        let largest = largest_magnitude(points.iter().map(|point| point.objective));
        let constraints = (0..problem.domain.constraints.dimension())
            .map(spread)
            .collect();
        Self {
            problem,
            constraints,
            rounding: ROUNDING * largest,
        }
    }

    fn of_point(&self, point: &SampledPoint) -> Merit {
        let violation = self.violation(point.constraints.iter().copied());
        Merit {
            is_feasible: violation == 0.0,
            violation,
            objective: point.objective,
        }
    }

    fn of_solution(&self, solution: &Solution) -> Merit {
        /// A violation up to this fraction of the goal's range counts as rounding.
        const MET: f64 = 1e-8;
        let Some(objective) = solution.value else {
            return Merit {
                is_feasible: false,
                violation: f64::INFINITY,
                objective: f64::INFINITY,
            };
        };
        let violation = self.violation(solution.constraints.iter().map(|at| at.value));
        Merit {
            is_feasible: solution.status != Status::Infeasible && violation <= MET,
            violation,
            objective,
        }
    }

    fn violation(&self, constraints: impl Iterator<Item = f64>) -> f64 {
        let limits = &self.problem.domain.constraints;
        let relative =
            |(j, (value, spread)): (usize, (f64, &f64))| limits.excess(j, value).abs() / spread;
        constraints
            .zip(&self.constraints)
            .enumerate()
            .map(relative)
            .fold(0.0, f64::max)
    }

    fn is_better(&self, one: &Merit, other: &Merit) -> bool {
        match (one.is_feasible, other.is_feasible) {
            (true, true) => one.objective < other.objective - self.rounding,
            (false, false) => one.violation < other.violation,
            (is_feasible, _) => is_feasible,
        }
    }
}
