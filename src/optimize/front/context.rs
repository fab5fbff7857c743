use super::result::{Front, FrontError, FrontPoint};
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::continuation::{RADIUS, relative_distance};
use crate::optimize::domain::Domain;
use crate::optimize::minimize::minimize_observed;
use crate::optimize::multistart::Observers;
use crate::optimize::options::Options;
use crate::optimize::problem::{Evaluation, Problem};
use crate::optimize::sensitivity::{ActiveSet, reduced_hessian};
use crate::optimize::solution::Solution;
use crate::optimize::status::Status;
use std::cell::Cell;

/// Tolerance within which two values of a function count as equal, relative to the size of the
/// function or to its change over the front.
pub(super) const SAME: f64 = 1e-9;
/// Tolerance of the lexicographic minimum. If the minimum of a function f is not isolated, the
/// other function is minimized subject to f ≤ min f + this fraction of the difference of f between
/// the ends of the front.
const LEXICOGRAPHIC_TOLERANCE: f64 = 1e-7;
/// A minimum is isolated if the ratio of the smallest to the largest curvature is above this limit.
const FLAT: f64 = 1e-9;
/// Message for an interrupted front.
pub(super) const PART_MISSING: &str = "interrupted: a part of the front is missing";

/// Problem made from another problem. Its two functions, the objective and the last constraint, are
/// replaced by weighted sums of both. The other constraints are kept.
pub(super) struct WeightedSums<'a> {
    pub problem: &'a dyn Problem,
    /// Value subtracted from each function before the weighting.
    pub zero: [f64; 2],
    /// Weights in the objective.
    pub objective: [f64; 2],
    /// Weights in the last constraint; if `None`, the last constraint is dropped.
    pub constraint: Option<[f64; 2]>,
}

impl<'a> WeightedSums<'a> {
    /// Problem that minimizes the sum with the weights `objective`, without the last constraint.
    pub fn minimized(problem: &'a dyn Problem, objective: [f64; 2]) -> Self {
        Self {
            problem,
            zero: [0.0; 2],
            objective,
            constraint: None,
        }
    }
}

impl Problem for WeightedSums<'_> {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        let functions = self.problem.evaluate(x)?;
        functions.check_dimensions(x.len(), functions.constraints.len())?;
        let Evaluation {
            objective,
            mut constraints,
        } = functions;
        let second = constraints
            .pop()
            .ok_or("the problem has no second function; return a constraint function")?;
        if objective.hessian.is_empty() != second.hessian.is_empty() {
            return Err(
                "only one of the two functions has a Hessian; give a Hessian for both functions or \
                 for neither"
                    .into(),
            );
        }
        let sum = |weights: [f64; 2]| {
            let mut sum = Taylor::sum([(&objective, weights[0]), (&second, weights[1])]);
            // subtract the zero points first, so that no digits are lost
            sum.value = weights[0] * (objective.value - self.zero[0])
                + weights[1] * (second.value - self.zero[1]);
            sum
        };
        constraints.extend(self.constraint.map(sum));
        Ok(Evaluation {
            objective: sum(self.objective),
            constraints,
        })
    }
}

/// Shared data of all searches of a front.
pub(super) struct FrontContext<'a> {
    pub problem: &'a dyn Problem,
    /// Domain without the limits of the second function.
    pub domain: Domain,
    pub options: &'a Options,
    pub observers: &'a Observers,
    pub searches: Cell<usize>,
}

impl FrontContext<'_> {
    pub fn search(
        &self,
        problem: &dyn Problem,
        domain: &Domain,
        from: &[f64],
        options: &Options,
    ) -> Result<Solution> {
        let number = self.searches.replace(self.searches.get() + 1);
        let observer = self.observers.of_search(number);
        minimize_observed(problem, domain, from, options, observer)
    }

    /// Minimizes one function and ignores the other. Returns the best end of the searches from
    /// `starts`.
    ///
    /// # Errors
    /// [`FrontError::NoEnd`] with the first end, if no search converges; [`FrontError::Refused`]
    /// without starts.
    pub fn minimum_of(&self, function: usize, starts: &[Vec<f64>]) -> Result<Solution, FrontError> {
        let problem = WeightedSums::minimized(self.problem, weights_of(function));
        let ends = starts
            .iter()
            .map(|start| self.search(&problem, &self.domain, start, self.options))
            .collect::<Result<Vec<_>>>()?;
        let value = |end: &Solution| match end.status {
            Status::Converged => end.value.unwrap_or(f64::INFINITY),
            _ => f64::INFINITY,
        };
        let best = ends
            .into_iter()
            .min_by(|a, b| value(a).total_cmp(&value(b)));
        let found = best.ok_or(Error::Nothing {
            doing: "search from",
            what: "start",
        })?;
        match found.status {
            Status::Converged => Ok(found),
            _ => Err(FrontError::NoEnd {
                function,
                found: Box::new(found),
            }),
        }
    }

    /// Values of the two functions at a point.
    pub fn values(&self, x: &[f64]) -> Result<[f64; 2]> {
        let undefined = |reason: String| {
            let status = if self.is_interrupted() {
                Status::Interrupted
            } else {
                Status::Undefined
            };
            Error::NotConverged {
                status: status.name(),
                message: reason.into(),
            }
        };
        let at = self.problem.evaluate(x).map_err(undefined)?;
        Ok([
            at.objective.value,
            at.constraints
                .last()
                .map_or(f64::NAN, |second| second.value),
        ])
    }

    /// Returns the front as a single point, if one point minimizes both functions.
    pub fn common_minimum(&self, ends: &[Solution; 2], values: [[f64; 2]; 2]) -> Option<Front> {
        let size = |k: usize| values[0][k].abs().max(values[1][k].abs());
        let is_minimal_at_both = |k: &usize| span_of(values, *k) <= SAME * size(*k);
        let end = 1 - (0..2).find(is_minimal_at_both)?;
        Some(Front {
            points: vec![self.end(&ends[end], values[end])],
            ..Front::default()
        })
    }

    /// Front point at the minimum of one function.
    pub fn end(&self, end: &Solution, values: [f64; 2]) -> FrontPoint {
        FrontPoint {
            x: end.x.clone(),
            values,
            slope: None,
            rates: vec![0.0; end.x.len()],
            active_set: ActiveSet::new(end, &self.domain),
            event: None,
        }
    }

    /// Front of an interrupted computation, with the ends found so far.
    pub fn ends_only(&self, ends: impl IntoIterator<Item = (Solution, [f64; 2])>) -> Front {
        Front {
            points: ends
                .into_iter()
                .map(|(end, values)| self.end(&end, values))
                .collect(),
            ended: Some(PART_MISSING.into()),
            interrupted: true,
            ..Front::default()
        }
    }

    /// Returns `end` if the minimum of function `k` is isolated. Otherwise, for example if a
    /// variable has no effect, returns the minimum at which the other function is smallest.
    pub fn isolated_minimum(
        &self,
        k: usize,
        end: Solution,
        values: [[f64; 2]; 2],
    ) -> Result<Solution> {
        if end.hessian.len() != end.x.len() {
            return Ok(end);
        }
        let (_, curvatures) = reduced_hessian(&end, &self.domain);
        if curvatures.is_empty() {
            return Ok(end);
        }
        let curvatures = curvatures.symmetric_eigenvalues();
        let largest = curvatures
            .iter()
            .fold(0.0_f64, |largest, curvature| largest.max(curvature.abs()));
        if curvatures
            .iter()
            .all(|curvature| *curvature > FLAT * largest)
        {
            return Ok(end);
        }
        let most = values[k][k] + LEXICOGRAPHIC_TOLERANCE * span_of(values, k);
        let mut domain = self.domain.clone();
        // variables on active bounds stay there
        for (i, _) in ActiveSet::new(&end, &self.domain)
            .variables
            .iter()
            .enumerate()
            .filter(|(_, is_active)| **is_active)
        {
            (domain.variables.low[i], domain.variables.high[i]) = (end.x[i], end.x[i]);
        }
        // the first search is without the limit on function `k`, which is not needed if active
        // bounds determine the minimum
        let other = WeightedSums::minimized(self.problem, weights_of(1 - k));
        let limited = WeightedSums {
            constraint: Some(weights_of(k)),
            ..WeightedSums::minimized(self.problem, weights_of(1 - k))
        };
        let within = with_limit(&domain, f64::NEG_INFINITY, most);
        for (problem, domain) in [(&other, &domain), (&limited, &within)] {
            let mut found = self.search(problem, domain, &end.x, self.options)?;
            let at = self.values(&found.x)?;
            if found.status == Status::Converged && at[k] <= most && at[1 - k] < values[k][1 - k] {
                let count = self.domain.constraints.dimension();
                found.constraints.truncate(count);
                found.jacobian.truncate(count);
                return Ok(found);
            }
        }
        Ok(end)
    }

    pub fn is_interrupted(&self) -> bool {
        self.observers
            .interrupt
            .load(std::sync::atomic::Ordering::Relaxed)
    }

    /// Options of a corrector search. The small radius keeps the search near its start.
    pub fn near(&self) -> Options {
        Options {
            initial_radius: RADIUS,
            ..self.options.clone()
        }
    }

    pub fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        relative_distance(a, b, &self.domain.variables)
    }
}

/// Weights (1, 0) or (0, 1) that select one function.
pub(super) fn weights_of(k: usize) -> [f64; 2] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

/// Increase of a function from its own minimum to the other function's minimum.
pub(super) fn span_of(values: [[f64; 2]; 2], k: usize) -> f64 {
    values[1 - k][k] - values[k][k]
}

/// Adds a constraint's limits to a domain.
pub(super) fn with_limit(domain: &Domain, low: f64, high: f64) -> Domain {
    let mut limited = domain.clone();
    limited.constraints.low.push(low);
    limited.constraints.high.push(high);
    limited
}
