//! Compromises, which are the points of a front, and the step from one compromise to the next.

use super::context::{FrontContext, WeightedSums, with_limit};
use super::result::{FrontEvent, FrontPoint};
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::continuation::predicted;
use crate::optimize::problem::Evaluation;
use crate::optimize::sensitivity::{ActiveSet, OptimumResponse, first_event, response};
use crate::optimize::solution::Solution;
use crate::optimize::status::Status;

/// Limit of the front's slope. A larger slope counts as infinite, and a slope below the inverse of
/// the limit counts as zero, because rounding dominates both.
const STEEPEST: f64 = 1e8;

/// A compromise, with its derivatives along the front.
#[derive(Clone)]
pub(super) struct Compromise {
    /// Position along the front, s = a − b, with the scaled functions a and b of [`FrontPlane`].
    pub at: f64,
    /// Sum a + b.
    pub sum: f64,
    /// The point of the front. Unknown derivatives dx/ds are set to zero; the predicted point is
    /// then this point.
    pub point: FrontPoint,
    /// Solution of the corrector with its derivatives by s; `None` if they are unknown.
    pub derivatives: Option<(Solution, OptimumResponse)>,
}

impl Compromise {
    pub fn is_jump(&self) -> bool {
        self.point.event == Some(FrontEvent::Jump)
    }

    /// True for a point between the ends at which both functions rise along the front, or both
    /// fall: a weight of the Lagrangian (1 + μ) a + (1 − μ) b is negative. A neighbour on the same
    /// branch dominates this point, so it is no point of the front.
    pub fn is_turned_back(&self) -> bool {
        self.at.abs() < 1.0 && self.point.slope.is_some_and(|slope| slope > 0.0)
    }
}

/// Plane of the two functions a and b, each scaled to 0 at its own minimum and to 1 at the other
/// function's minimum.
pub(super) struct FrontPlane<'a> {
    pub context: &'a FrontContext<'a>,
    /// Minimum of each function.
    pub zero: [f64; 2],
    /// Increase of each function from its own minimum to the other function's minimum.
    pub span: [f64; 2],
}

impl FrontPlane<'_> {
    /// The problem that minimizes the sum of the two functions, each relative to its span, and
    /// optionally constrains their difference.
    fn combined(&self, is_constrained: bool) -> WeightedSums<'_> {
        let [a, b] = self.span.map(|span| 1.0 / span);
        WeightedSums {
            problem: self.context.problem,
            zero: self.zero,
            objective: [a, b],
            constraint: is_constrained.then_some([a, -b]),
        }
    }

    /// Compromise at the minimum of function k.
    pub fn end(&self, k: usize, end: &Solution, values: [f64; 2]) -> Compromise {
        let at = if k == 0 { -1.0 } else { 1.0 };
        let context = self.context;
        let mut compromise = Compromise {
            at,
            sum: 1.0,
            point: context.end(end, values),
            derivatives: None,
        };
        // a corrector search at this end gives the derivatives along the front
        if let Ok(place) = self.solve_at(at, &end.x)
            && context.distance(&place.point.x, &end.x) < 1e-4
        {
            compromise.point = FrontPoint {
                x: compromise.point.x,
                values,
                ..place.point
            };
            compromise.derivatives = place.derivatives;
        }
        compromise
    }

    /// Corrector: computes the compromise at s = `at`, from the nearby point `from`.
    pub fn solve_at(&self, at: f64, from: &[f64]) -> Result<Compromise> {
        let domain = with_limit(&self.context.domain, at, at);
        let solution =
            self.context
                .search(&self.combined(true), &domain, from, &self.context.near())?;
        if solution.status != Status::Converged {
            let message = solution.message.clone().into();
            return Err(Error::NotConverged {
                status: solution.status.name(),
                message,
            });
        }
        let mut active_set = ActiveSet::new(&solution, &domain);
        active_set.constraints.pop();
        let response = response(&solution, &domain, &derivatives_by_s(&solution)).ok();
        let sum = solution.value.unwrap_or(f64::NAN);
        let (difference, multiplier) = solution
            .constraints
            .last()
            .map_or((at, 0.0), |last| (last.value, last.multiplier));
        let [a, b] = [0.5 * (sum + difference), 0.5 * (sum - difference)];
        let slope = match (1.0 - multiplier) / (1.0 + multiplier) {
            slope if slope.abs() < STEEPEST.recip() => Some(0.0),
            slope => Some(-slope).filter(|slope| slope.abs() < STEEPEST),
        };
        let point = FrontPoint {
            x: solution.x.clone(),
            values: [
                self.zero[0] + a * self.span[0],
                self.zero[1] + b * self.span[1],
            ],
            // an optimum that is not isolated has no unique multipliers
            slope: response
                .as_ref()
                .and(slope)
                .map(|slope| slope * self.span[0] / self.span[1]),
            rates: response.as_ref().map_or_else(
                || vec![0.0; solution.x.len()],
                |response| response.x.clone(),
            ),
            active_set,
            event: None,
        };
        Ok(Compromise {
            at,
            sum,
            point,
            derivatives: response.map(|response| (solution, response)),
        })
    }

    /// Computes the compromise at s = `to`. Also returns its distance from the prediction, in units
    /// of the variables' ranges.
    pub fn next(&self, here: &Compromise, to: f64) -> Result<(Compromise, f64)> {
        let bounds = &self.context.domain.variables;
        let predicted = predicted(&here.point.x, &here.point.rates, to - here.at, bounds);
        let found = self.solve_at(to, &predicted)?;
        let distance = self.context.distance(&found.point.x, &predicted);
        Ok((found, distance))
    }

    /// Predicts, to first order, the s between `here` and `to` at which the active set changes.
    /// `None` if no change is predicted.
    pub fn expected_event(&self, here: &Compromise, to: f64) -> Option<f64> {
        let (solution, response) = here.derivatives.as_ref()?;
        let domain = with_limit(&self.context.domain, here.at, here.at);
        let (part, _) = first_event(solution, &domain, response, to - here.at)?;
        Some(here.at + part * (to - here.at))
    }

    /// Computes the knee near a compromise: the minimum of a + b.
    pub fn knee(&self, near: &Compromise) -> Result<Compromise> {
        let context = self.context;
        let found = context.search(
            &self.combined(false),
            &context.domain,
            &near.point.x,
            &context.near(),
        )?;
        let values = context.values(&found.x)?;
        let [a, b]: [f64; 2] = std::array::from_fn(|k| (values[k] - self.zero[k]) / self.span[k]);
        self.solve_at(a - b, &found.x)
    }
}

/// Derivatives by s of the functions minus their limits. Only the last constraint depends on s,
/// because its limit is s.
fn derivatives_by_s(solution: &Solution) -> Evaluation {
    let n = solution.x.len();
    let mut hessian = vec![vec![]; n];
    hessian.push(vec![0.0; n + 1]);
    let constant = Taylor {
        value: 0.0,
        gradient: vec![0.0; n + 1],
        hessian,
    };
    let mut constraints = vec![constant.clone(); solution.constraints.len()];
    if let Some(last) = constraints.last_mut() {
        last.gradient[n] = -1.0;
    }
    Evaluation {
        objective: constant,
        constraints,
    }
}
