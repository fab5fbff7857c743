//! Looking elsewhere for a point that meets the constraints.
//!
//! Where the linearised constraints show no step that lowers the violation, and its curvature shows
//! none either, that may be a minimum of the violation, or a place where slope and curvature vanish
//! together. Neither says that the constraints contradict each other: a minimum of the violation
//! may be a local one. So the violation is minimised from other points too before that is said.

use super::domain::Domain;
use super::least_squares::{self, Rows};
use super::options::Options;
use super::scaling::{Point, norm};
use super::start::spread;
use super::state::{Evaluate, State};
use std::cell::RefCell;

/// Points of the box from which the violation is minimised.
const TRIALS: u32 = 32;
/// Iterations for each of them.
const ITERATIONS: u64 = 50;
/// Times that a search looks elsewhere.
const MOST: u32 = 3;
/// The violation must fall to this part of what it is here for the search to go on from there.
const BETTER: f64 = 0.99;
/// The same for the search to end there: less is rounding.
const LESS: f64 = 1.0 - 1e-6;

impl State {
    /// Goes on from a point that meets the constraints better, if one is found: by least squares on
    /// the violations from points spread over the box, up to the first that meets them all, or else
    /// the best. Whether there was one.
    pub fn restore(
        &mut self,
        options: &Options,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        if self.counters.restorations >= MOST {
            return Ok(false);
        }
        self.counters.restorations += 1;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for trial in 0..TRIALS {
            let start = spread(&self.scaling.domain.variables, &self.point.x, trial);
            let Some((violation, x)) = self.least_violated(start, evaluate)? else {
                continue;
            };
            if violation
                < best
                    .as_ref()
                    .map_or(BETTER * self.violation(), |(least, _)| *least)
            {
                best = Some((violation, x));
            }
            if violation <= options.kkt_tolerance {
                break;
            }
        }
        let Some((_, x)) = best else { return Ok(false) };
        self.effort.evaluations += 1;
        let Ok(f) = evaluate(&x)? else {
            return Ok(false);
        };
        self.restart_at(Point { x, f }, options.initial_radius);
        Ok(true)
    }

    /// Where the constraints cannot all be met, the search weighs what is left of them against the
    /// objective: it ends where they are violated least, near here or near where it began. Whether
    /// that is another point.
    pub fn settle(
        &mut self,
        begun_at: &[f64],
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        let mut is_moved = false;
        for start in [self.point.x.clone(), begun_at.to_vec()] {
            let Some((violation, x)) = self.least_violated(start, evaluate)? else {
                continue;
            };
            if violation >= LESS * self.violation() {
                continue;
            }
            self.effort.evaluations += 1;
            if let Ok(f) = evaluate(&x)? {
                self.restart_at(Point { x, f }, self.radius);
                is_moved = true;
            }
        }
        Ok(is_moved)
    }

    /// Where the violation is least near a point, and what it is there.
    pub(super) fn least_violated(
        &mut self,
        start: Vec<f64>,
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
        let options = least_squares::Options {
            max_iterations: ITERATIONS,
            ..least_squares::Options::default()
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
