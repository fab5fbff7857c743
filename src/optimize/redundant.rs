//! Bounds that a constraint makes redundant. Where the gradient of a constraint is parallel to that
//! of an active bound, huge multipliers of both can balance any slope of f: the KKT residual
//! vanishes, and yet f falls along the constraint.

use super::state::{Evaluate, State};
use argmin::core::Error;

/// A multiplier above so many slopes of f says nothing of a KKT point.
const HUGE: f64 = 1e6;
/// Redundant bounds crossed before a search ends at one.
const MOST_CROSSINGS: u32 = 10;
/// Steps along the constraint, in units of the scale: from the first on, each a quarter of the one
/// before.
const FIRST_STEP: f64 = 0.25;
const STEPS: u32 = 8;

/// An active bound and the constraint whose huge multiplier balances its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct RedundantBound {
    pub variable: usize,
    pub constraint: usize,
    pub multiplier: f64,
}

impl State {
    /// A constraint with a huge multiplier, and the active bound that takes most of its pull.
    pub fn redundant_bound(&self) -> Option<RedundantBound> {
        let slope = self
            .scaling
            .largest(self.point.f.objective.gradient.iter().copied());
        let most = HUGE * slope.max(self.scaling.first_size.min(1.0) * f64::EPSILON);
        let pull = |i: usize, j: usize| {
            let constraint = &self.point.f.constraints[j];
            (self.multipliers[j] * constraint.gradient[i] * self.scaling.scale[i]).abs()
        };
        let bounds =
            (0..self.point.x.len()).filter(|&i| self.scaling.is_at_a_bound(&self.point, i));
        let pairs = bounds.flat_map(|i| (0..self.multipliers.len()).map(move |j| (i, j)));
        let (variable, constraint) = pairs
            .filter(|&(i, j)| pull(i, j) > most)
            .max_by(|a, b| pull(a.0, a.1).total_cmp(&pull(b.0, b.1)))?;
        Some(RedundantBound {
            variable,
            constraint,
            multiplier: self.multipliers[constraint],
        })
    }

    /// Goes on from a lower point across the bound's contact: down the slope of f in the other
    /// variables, then back onto the constraints. Whether there is one.
    pub fn cross_redundant_bound(
        &mut self,
        pair: &RedundantBound,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, Error> {
        if self.counters.redundant_bounds >= MOST_CROSSINGS {
            return Ok(false);
        }
        self.counters.redundant_bounds += 1;
        let slope = |i: usize| self.point.f.objective.gradient[i] * self.scaling.scale[i];
        let largest = self
            .scaling
            .largest(self.point.f.objective.gradient.iter().copied());
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
        for _ in 0..STEPS {
            let moved: Vec<f64> = self
                .point
                .x
                .iter()
                .enumerate()
                .map(|(i, x)| x + step * direction[i] * self.scaling.scale[i])
                .collect();
            let moved = self.scaling.domain.variables.project(&moved);
            let restored = self.least_violated(moved, evaluate)?;
            if let Some((least, x)) = restored
                && least <= violation.max(1e-8)
                && let Some(point) = self.evaluated(x, evaluate)?
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
