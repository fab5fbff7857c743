//! Bounds that a constraint makes redundant. Suppose that the gradient of a constraint is almost
//! parallel to the normal of an active bound. With huge multipliers, the gradient and the normal
//! add up to any small vector, and so can balance a gradient of f along the constraint. The KKT
//! residual then vanishes, although f still falls along the constraint.

use super::least_squares;
use super::scaling::largest_scaled;
use super::state::{Evaluate, SearchState};
use argmin::core::Error;

/// Limit for a multiplier, relative to the gradient of f. If the KKT conditions hold only with a
/// larger multiplier, they do not prove an optimum.
const HUGE: f64 = 1e6;
/// Maximum number of attempts of a search to step across a redundant bound.
const MOST_CROSSINGS: u32 = 10;
/// Length of the first step along −∇f, in units of the variables' scale. Each further step is a
/// quarter of the previous step.
const FIRST_STEP: f64 = 0.25;
/// Maximum number of steps along −∇f in one attempt.
const STEP_LENGTHS: u32 = 8;

/// An active bound that a constraint makes redundant, and this constraint with its huge multiplier.
#[derive(Clone, Copy, Debug)]
pub(super) struct RedundantBound {
    pub variable: usize,
    pub constraint: usize,
    pub multiplier: f64,
}

impl SearchState {
    /// Finds the variable i on a bound and the constraint j with the largest scaled product |λⱼ
    /// ∂cⱼ/∂xᵢ|. `None` if no product exceeds [`HUGE`] times the scaled gradient of f.
    pub fn redundant_bound(&self) -> Option<RedundantBound> {
        let slope = largest_scaled(&self.point.f.objective.gradient, &self.scaling.scale);
        let most = HUGE * slope.max(self.scaling.initial_size.min(1.0) * f64::EPSILON);
        let scaled_product = |i: usize, j: usize| {
            let constraint = &self.point.f.constraints[j];
            (self.multipliers[j] * constraint.gradient[i] * self.scaling.scale[i]).abs()
        };
        let bounds =
            (0..self.point.x.len()).filter(|&i| self.scaling.is_at_a_bound(&self.point, i));
        let pairs = bounds.flat_map(|i| (0..self.multipliers.len()).map(move |j| (i, j)));
        let (variable, constraint) = pairs
            .filter(|&(i, j)| scaled_product(i, j) > most)
            .max_by(|a, b| scaled_product(a.0, a.1).total_cmp(&scaled_product(b.0, b.1)))?;
        Some(RedundantBound {
            variable,
            constraint,
            multiplier: self.multipliers[constraint],
        })
    }

    /// Moves all variables but the variable on the bound along −∇f, then moves back onto the
    /// constraints. If the objective is lower at the new point, restarts the search there and
    /// returns true.
    pub fn step_across_bound(
        &mut self,
        pair: &RedundantBound,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, Error> {
        if self.counters.redundant_bounds >= MOST_CROSSINGS {
            return Ok(false);
        }
        self.counters.redundant_bounds += 1;
        let slope = |i: usize| self.point.f.objective.gradient[i] * self.scaling.scale[i];
        let largest = largest_scaled(&self.point.f.objective.gradient, &self.scaling.scale);
        let direction: Vec<f64> = (0..self.point.x.len())
            .map(|i| {
                if i == pair.variable {
                    0.0
                } else {
                    -slope(i) / largest
                }
            })
            .collect();
        let (value, violation) = (self.point.f.objective.value, self.violation());
        let mut step = FIRST_STEP;
        for _ in 0..STEP_LENGTHS {
            let moved: Vec<f64> = self
                .point
                .x
                .iter()
                .enumerate()
                .map(|(i, x)| x + step * direction[i] * self.scaling.scale[i])
                .collect();
            let moved = self.scaling.domain.variables.project(&moved);
            let restored = self.minimize_violation(
                moved,
                least_squares::FitOptions::default().tolerance,
                evaluate,
            )?;
            if let Some((least, x)) = restored
                && least <= violation.max(1e-8)
                && let Some(point) = self.evaluate_at(x, evaluate)?
                && point.f.objective.value < value
            {
                self.restart_at(point, step);
                return Ok(true);
            }
            step *= 0.25;
        }
        Ok(false)
    }
}
