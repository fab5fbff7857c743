//! Feasibility restoration from other points of the box.
//!
//! A search may come to a point where neither a step of the quadratic program nor a direction of
//! negative curvature reduces the violation. This point may be a local minimum of the violation, or
//! a point where gradient and curvature of the violation vanish together. Neither proves that the
//! constraints are inconsistent. Before the search ends as infeasible, the violation is therefore
//! minimized from other points.

use super::domain::Domain;
use super::least_squares::{self, Rows};
use super::options::Options;
use super::scaling::norm;
use super::start::low_discrepancy_point;
use super::state::{Evaluate, SearchState};
use std::cell::RefCell;

/// Number of starting points of one restoration.
const STARTS: u32 = 32;
/// Maximum number of iterations from each starting point.
const ITERATIONS: u64 = 50;
/// [Convergence tolerance](least_squares::FitOptions::tolerance) from each starting point. It is
/// large because the iterations converge slowly where the least violation is above 0; the search
/// polishes the best result afterwards.
const TOLERANCE: f64 = 1e-4;
/// Maximum number of restorations in a search.
const MAX_RESTORATIONS: u32 = 3;
/// The search continues from the result of a restoration if the violation there is below this
/// fraction of the violation at the iterate.
const CONTINUE_BELOW: f64 = 0.99;
/// An infeasible search moves to a new point before it ends, if the violation there is below this
/// fraction of the violation at the iterate. A smaller reduction is rounding.
const MOVE_BELOW: f64 = 1.0 - 1e-6;

impl SearchState {
    /// Minimizes the violation by least squares from several points of the box, and stops at the
    /// first feasible result. If the best violation is below [`CONTINUE_BELOW`] times the violation
    /// of the iterate, restarts the search there and returns true.
    pub fn restore(
        &mut self,
        options: &Options,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        if self.counters.restorations >= MAX_RESTORATIONS {
            return Ok(false);
        }
        self.counters.restorations += 1;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for trial in 0..STARTS {
            let start = low_discrepancy_point(&self.scaling.domain.variables, &self.point.x, trial);
            let Some((violation, x)) = self.minimize_violation(start, TOLERANCE, evaluate)? else {
                continue;
            };
            if violation
                < best
                    .as_ref()
                    .map_or(CONTINUE_BELOW * self.violation(), |(least, _)| *least)
            {
                best = Some((violation, x));
            }
            if violation <= options.kkt_tolerance {
                break;
            }
        }
        let Some((violation, x)) = best else {
            return Ok(false);
        };
        let first_point =
            |from: &[f64]| low_discrepancy_point(&self.scaling.domain.variables, from, 0);
        if violation > options.kkt_tolerance && first_point(&x) == first_point(&self.point.x) {
            // the starting points did not change with the iterate: another restoration would repeat
            // this one
            self.counters.restorations = MAX_RESTORATIONS;
        }
        let Some(point) = self.evaluate_at(x, evaluate)? else {
            return Ok(false);
        };
        self.restart_at(point, options.initial_radius);
        Ok(true)
    }

    /// Minimizes the violation from the current iterate and from the first iterate, and moves an
    /// infeasible search to the result. The merit function does not lead there, because it balances
    /// violation and objective. Returns true if the search moved.
    pub fn move_to_least_violation(
        &mut self,
        initial_point: &[f64],
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        let mut is_moved = false;
        for start in [self.point.x.clone(), initial_point.to_vec()] {
            let tolerance = least_squares::FitOptions::default().tolerance;
            let Some((violation, x)) = self.minimize_violation(start, tolerance, evaluate)? else {
                continue;
            };
            if violation >= MOVE_BELOW * self.violation() {
                continue;
            }
            if let Some(point) = self.evaluate_at(x, evaluate)? {
                self.restart_at(point, self.radius);
                is_moved = true;
            }
        }
        Ok(is_moved)
    }

    /// Minimizes the violation ‖v‖₂ of the constraints from a start. Returns the violation and the
    /// point; `None` if the functions are undefined at the start.
    pub(super) fn minimize_violation(
        &mut self,
        start: Vec<f64>,
        tolerance: f64,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Option<(f64, Vec<f64>)>, argmin::core::Error> {
        let failure = RefCell::new(None);
        let evaluate = RefCell::new(evaluate);
        let scaling = &self.scaling;
        let violations = |x: &[f64]| {
            let f = (evaluate.borrow_mut())(x).unwrap_or_else(|error| {
                *failure.borrow_mut() = Some(error);
                Err("the evaluation failed".into())
            })?;
            let residuals: Vec<f64> = scaling.violations(&f).collect();
            let row = |(j, violation): (usize, &f64)| match violation {
                0.0 => vec![0.0; x.len()],
                _ => f.constraints[j]
                    .gradient
                    .iter()
                    .map(|slope| slope / scaling.gamma[j])
                    .collect(),
            };
            let jacobian = residuals.iter().enumerate().map(row).collect();
            Ok(Rows {
                residuals,
                jacobian,
            })
        };
        let options = least_squares::FitOptions {
            max_iterations: ITERATIONS,
            tolerance,
            ..least_squares::FitOptions::default()
        };
        let variables = scaling.domain.variables.clone();
        let bounds = Domain {
            variables,
            ..Domain::default()
        };
        let found = least_squares::fit(&violations, &bounds, &start, &options);
        if let Some(failure) = failure.into_inner() {
            return Err(failure);
        }
        let found = found.map_err(|error| argmin::core::Error::msg(error.to_string()))?;
        self.effort.evaluations += found.evaluations;
        Ok((!found.rows.residuals.is_empty()).then(|| (norm(found.rows.residuals), found.x)))
    }
}
