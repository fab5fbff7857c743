use super::objective::CarryObjective;
use argmin::core::{CostFunction, Error, Executor, Gradient};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use std::cell::RefCell;

/// Number of stored steps and gradients.
const MEMORY: usize = 7;

const ITERATIONS: u64 = 200;

/// Minimizes with argmin's L-BFGS from `start`: returns the best point and the termination message.
///
/// argmin's L-BFGS has no bounds. The substitution x = middle + half the width · sin u removes the
/// bounds of the problem. L-BFGS also fails where the function is undefined. A drive whose ball
/// does not fly therefore has carry 0.
pub(super) fn search_by_lbfgs(objective: &CarryObjective, start: &[f64]) -> (Vec<f64>, String) {
    let bounds = &objective.domain.variables;
    let half = |i: usize| 0.5 * (bounds.high[i] - bounds.low[i]);
    let begin = (0..start.len()).map(|i| {
        ((start[i] - bounds.low[i]) / half(i) - 1.0)
            .clamp(-1.0, 1.0)
            .asin()
    });
    let best = RefCell::new((f64::INFINITY, start.to_vec()));
    let solver = LBFGS::new(MoreThuenteLineSearch::new(), MEMORY);
    let ended = Executor::new(
        Unbounded {
            objective,
            best: &best,
        },
        solver,
    )
    .configure(|state| state.param(begin.collect()).max_iters(ITERATIONS))
    .timer(false)
    .run();
    let message = match ended {
        Ok(ended) => ended.state.termination_status.to_string(),
        Err(error) => format!("failed: {error}"),
    };
    (best.into_inner().1, message)
}

/// Returns `without` in place of the error for a ball that does not fly.
fn flown<T>(found: Result<T, crate::Error>, without: T) -> Result<T, crate::Error> {
    match found {
        Err(crate::Error::NoFlight { .. }) => Ok(without),
        found => found,
    }
}

/// The problem in the unbounded variables u.
struct Unbounded<'a, 'b> {
    objective: &'a CarryObjective<'b>,
    /// The smallest value so far, and the point x with this value.
    best: &'a RefCell<(f64, Vec<f64>)>,
}

impl Unbounded<'_, '_> {
    fn bounded(&self, u: &[f64]) -> Vec<f64> {
        let bounds = &self.objective.domain.variables;
        let x = |(i, u): (usize, &f64)| {
            let (low, high) = (bounds.low[i], bounds.high[i]);
            (0.5 * (low + high) + 0.5 * (high - low) * u.sin()).clamp(low, high)
        };
        u.iter().enumerate().map(x).collect()
    }
}

impl CostFunction for Unbounded<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, u: &Vec<f64>) -> Result<f64, Error> {
        let x = self.bounded(u);
        let value = flown(self.objective.value(&x), 0.0)?;
        let mut best = self.best.borrow_mut();
        if value < best.0 {
            *best = (value, x);
        }
        Ok(value)
    }
}

impl Gradient for Unbounded<'_, '_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, u: &Vec<f64>) -> Result<Vec<f64>, Error> {
        let bounds = &self.objective.domain.variables;
        let by_x = flown(
            self.objective
                .taylor(&self.bounded(u))
                .map(|taylor| taylor.gradient),
            vec![0.0; u.len()],
        )?;
        Ok((0..u.len())
            .map(|i| by_x[i] * 0.5 * (bounds.high[i] - bounds.low[i]) * u[i].cos())
            .collect())
    }
}
