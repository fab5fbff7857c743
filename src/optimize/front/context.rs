use super::combined::Combined;
use super::found::{Front, FrontPoint};
use crate::error::{Error, Result};
use crate::optimize::continuation::{RADIUS, apart};
use crate::optimize::domain::{Bounds, Domain};
use crate::optimize::minimize::minimize_observed;
use crate::optimize::multistart::Follow;
use crate::optimize::observer::Observer;
use crate::optimize::options::Options;
use crate::optimize::problem::Problem;
use crate::optimize::sensitivity::{Held, reduced_hessian};
use crate::optimize::solution::{Iteration, Solution};
use crate::optimize::status::Status;
use std::cell::Cell;

/// Functions nearer to their least value than this part of it are there.
pub(super) const SAME: f64 = 1e-9;
/// How much of the way between its ends a function may lose where that makes its minimum one point.
const GIVEN_UP: f64 = 1e-7;
/// A minimum whose least curvature is below this part of its greatest is not one point.
const FLAT: f64 = 1e-9;
/// Why a front that was stopped has not all of its points.
pub(super) const PART_MISSING: &str = "interrupted: a part of the front is missing";
/// A front that bends less than this off a straight line, as a part of its length, has no knee.
pub(super) const STRAIGHT: f64 = 0.01;

/// What all searches of a front share.
pub(super) struct FrontContext<'a> {
    pub problem: &'a dyn Problem,
    /// Without the second function.
    pub domain: Domain,
    pub options: &'a Options,
    pub follow: &'a Follow,
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
        let mut observer = Observer {
            interrupt: self.follow.interrupt.clone(),
            ..Observer::default()
        };
        if let Some(show) = self.follow.iteration.clone() {
            observer.iteration = Box::new(move |iteration: &Iteration| show(number, iteration));
        }
        minimize_observed(problem, domain, from, options, observer)
    }

    /// The two functions at a point.
    pub fn values(&self, x: &[f64]) -> Result<[f64; 2]> {
        let none = |reason: String| {
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
        let at = self.problem.evaluate(x).map_err(none)?;
        Ok([
            at.objective.value,
            at.constraints
                .last()
                .map_or(f64::NAN, |second| second.value),
        ])
    }

    pub fn ends(&self, ends: &[Solution; 2]) -> Result<[[f64; 2]; 2]> {
        Ok([self.values(&ends[0].x)?, self.values(&ends[1].x)?])
    }

    /// Where a function gives up nothing at the minimum of the other, that is best for both: there
    /// is no front, but one point.
    pub fn best_for_both(&self, ends: &[Solution; 2], values: [[f64; 2]; 2]) -> Option<Front> {
        let size = |k: usize| values[0][k].abs().max(values[1][k].abs());
        let gives_up_nothing = |k: &usize| given_up(values, *k) <= SAME * size(*k);
        let end = 1 - (0..2).find(gives_up_nothing)?;
        let points = vec![self.end(&ends[end], values[end])];
        Some(Front {
            points,
            knee: None,
            bend: 0.0,
            dominated: 0,
            ended: None,
            interrupted: false,
        })
    }

    /// The minimum of one function, as a point of the front.
    fn end(&self, end: &Solution, values: [f64; 2]) -> FrontPoint {
        let held = Held::new(end, &self.domain);
        FrontPoint {
            x: end.x.clone(),
            values,
            slope: None,
            rates: vec![0.0; end.x.len()],
            held,
            event: None,
        }
    }

    /// What there is of a front that was stopped before it was followed.
    pub fn ends_alone(&self, ends: impl IntoIterator<Item = (Solution, [f64; 2])>) -> Front {
        let points = ends
            .into_iter()
            .map(|(end, values)| self.end(&end, values))
            .collect();
        let ended = Some(PART_MISSING.into());
        Front {
            points,
            knee: None,
            bend: 0.0,
            dominated: 0,
            ended,
            interrupted: true,
        }
    }

    /// A minimum that is not one point, as where a function does not depend on a variable: of all
    /// that are as good, the one that is best for the other function.
    pub fn one_point(&self, k: usize, end: Solution, values: [[f64; 2]; 2]) -> Result<Solution> {
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
        let most = values[k][k] + GIVEN_UP * given_up(values, k);
        let mut domain = self.domain.clone();
        // what a bound holds stays there
        for (i, _) in Held::new(&end, &self.domain)
            .variables
            .iter()
            .enumerate()
            .filter(|(_, is_held)| **is_held)
        {
            (domain.variables.low[i], domain.variables.high[i]) = (end.x[i], end.x[i]);
        }
        // where that is all that makes the minimum, nothing else needs a limit
        let other = Combined::of(self.problem, of(1 - k));
        let limited = Combined {
            held: Some(of(k)),
            ..Combined::of(self.problem, of(1 - k))
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
        self.follow
            .interrupt
            .load(std::sync::atomic::Ordering::Relaxed)
    }

    /// The settings of a search that stays with what it follows.
    pub fn near(&self) -> Options {
        Options {
            initial_radius: RADIUS,
            ..self.options.clone()
        }
    }

    pub fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        apart(a, b, &self.domain.variables)
    }
}

/// The weights of one function alone.
pub(super) fn of(k: usize) -> [f64; 2] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

/// What a function gives up at the minimum of the other.
pub(super) fn given_up(values: [[f64; 2]; 2], k: usize) -> f64 {
    values[1 - k][k] - values[k][k]
}

/// A domain with one more limit.
pub(super) fn with_limit(domain: &Domain, low: f64, high: f64) -> Domain {
    let Bounds {
        low: mut lows,
        high: mut highs,
    } = domain.constraints.clone();
    lows.push(low);
    highs.push(high);
    Domain {
        constraints: Bounds {
            low: lows,
            high: highs,
        },
        ..domain.clone()
    }
}
