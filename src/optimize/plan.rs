//! From a quadratic program to the step that a search tries.

use super::qp::{End, Method, Step};
use super::scaling::{Point, Scaling, norm};
use nalgebra::DVector;

/// A step that the model leads to.
#[derive(Clone)]
pub(super) struct Plan {
    /// Where it ends; a variable that ends at a bound is there exactly.
    pub x: Vec<f64>,
    /// Its largest component, in units of the scale.
    pub length: f64,
    /// What the model says f falls by; it may rise where constraints ask for it.
    pub descent: f64,
    /// The norm of the constraints' violations before it, in units of γ.
    pub violation: f64,
    /// What the linearised constraints leave of it.
    pub violation_left: f64,
    /// The multipliers that go with the step.
    pub multipliers: Vec<f64>,
    /// How many sides of a corner hold it; 1 away from corners.
    pub sides: usize,
    /// Whether the linearised constraints could not all be met.
    pub is_relaxed: bool,
    /// Who found its active set.
    pub by: Method,
}

impl Plan {
    /// Whether the trust region kept it from going further.
    pub fn is_limited_by(&self, radius: f64) -> bool {
        let part = if self.is_relaxed { NORMAL_PART } else { 1.0 };
        self.length >= 0.99 * part * radius
    }
}

/// Of the trust region, the part that serves to meet the constraints where they cannot all be met; the rest is left
/// to the objective (Omojokun 1989: 0.8).
pub(super) const NORMAL_PART: f64 = 0.8;
/// Room for the rounding of what is left, where a relaxed row is met with nothing to spare.
const ROUNDING: f64 = 1e-12;

/// A quadratic program, dense or sparse.
pub(super) trait Program: Clone {
    /// Its solution; `None` where the rows cannot be met within the ends.
    fn solve(&self) -> Option<Step>;

    /// The limits of the rows.
    fn limits(&mut self) -> impl Iterator<Item = (&mut f64, &mut f64)>;

    /// What a step leaves each row beyond its limits: above the upper > 0, below the lower < 0.
    fn left_over(&self, d: &DVector<f64>) -> impl Iterator<Item = f64>;
}

/// The place around which a program is posed.
#[derive(Clone, Copy)]
pub(super) struct Around<'a> {
    pub scaling: &'a Scaling,
    pub at: &'a Point,
    pub radius: f64,
}

impl Around<'_> {
    /// The plan that a program leads to. Where its rows contradict each other they are relaxed by what the step of least violation
    /// leaves of each: missing > 0, too much < 0. `descent` is what the model says f falls by.
    pub fn plan<P: Program>(
        &self,
        program: &P,
        least_violation: impl FnOnce() -> (Step, Vec<f64>),
        descent: impl FnOnce(&DVector<f64>) -> f64,
    ) -> Plan {
        let (step, is_relaxed) = match program.solve() {
            Some(step) => (step, false),
            None => {
                let (nearest, left) = least_violation();
                let mut relaxed = program.clone();
                for ((low, high), left) in relaxed.limits().zip(&left) {
                    if low == high {
                        *low -= left;
                        *high = *low;
                    } else {
                        *low -= left.max(0.0) + ROUNDING;
                        *high += (-left).max(0.0) + ROUNDING;
                    }
                }
                (relaxed.solve().unwrap_or(nearest), true)
            }
        };
        let x = self.end_of(&step);
        let d = self.steps_to(&x);
        Plan {
            length: step.d.amax(),
            descent: descent(&d),
            violation: norm(self.scaling.violations(&self.at.f)),
            violation_left: norm(program.left_over(&d)),
            multipliers: step.multipliers.iter().zip(&self.scaling.gamma).map(|(m, gamma)| m / gamma).collect(),
            sides: step.weights.iter().filter(|weight| **weight > 1e-6).count(),
            by: step.by,
            is_relaxed,
            x,
        }
    }

    /// The point a step ends at.
    fn end_of(&self, step: &Step) -> Vec<f64> {
        let Self { scaling, at, radius } = *self;
        // a bound over the scale, times the scale, may fall short of it by rounding
        let nearly = 1.0 - 4.0 * f64::EPSILON;
        let coordinate = |i: usize| {
            let (low, high) = (scaling.domain.variables.low[i], scaling.domain.variables.high[i]);
            match step.ends[i] {
                End::Low if step.d[i] > -radius && step.d[i] * scaling.scale[i] <= nearly * (low - at.x[i]) => low,
                End::High if step.d[i] < radius && step.d[i] * scaling.scale[i] >= nearly * (high - at.x[i]) => high,
                _ => (at.x[i] + step.d[i] * scaling.scale[i]).clamp(low, high),
            }
        };
        (0..at.x.len()).map(coordinate).collect()
    }

    /// The way to a point, in scaled variables.
    pub fn steps_to(&self, x: &[f64]) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| (x[i] - self.at.x[i]) / self.scaling.scale[i])
    }

    /// Where a step of a variable ends on either side: at the bound, or the trust region.
    pub fn ends(&self, i: usize) -> (f64, f64) {
        let Self { scaling, at, radius } = *self;
        let bounds = &scaling.domain.variables;
        let limit = |bound: f64| ((bound - at.x[i]) / scaling.scale[i]).clamp(-radius, radius);
        (limit(bounds.low[i]), limit(bounds.high[i]))
    }

    /// The limits of a constraint's row where its function would have this value without a step.
    pub fn row_limits(&self, j: usize, value: f64) -> (f64, f64) {
        let (limits, gamma) = (&self.scaling.domain.constraints, self.scaling.gamma[j]);
        let low = (limits.low[j] - value) / gamma;
        let high = if limits.is_fixed(j) { low } else { (limits.high[j] - value) / gamma };
        (low, high)
    }
}
