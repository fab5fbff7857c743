//! Damped Gauss–Newton model at a point, and its minimum within the bounds.

use super::super::domain::Bounds;
use super::super::qp::{Activity, MaxTerm, QpSolver, QuadraticProgram};
use super::{Loss, Rows};
use nalgebra::{DMatrix, DVector};

/// A point with its residuals r, and the gradient JᵀWr and curvature JᵀWJ of the Gauss–Newton
/// model. W is the diagonal matrix of the loss's weights.
#[derive(Clone, Debug)]
pub(super) struct GaussNewtonPoint {
    pub x: Vec<f64>,
    pub rows: Rows,
    pub cost: f64,
    gradient: DVector<f64>,
    curvature: DMatrix<f64>,
}

/// Step of the damped Gauss–Newton model.
pub(super) struct ModelStep {
    /// Trial point.
    pub to: Vec<f64>,
    /// Reduction of F that the model without damping predicts.
    pub predicted_reduction: f64,
}

impl GaussNewtonPoint {
    /// Builds the model; fails if residuals or Jacobian have the wrong shape or are not finite.
    pub fn new(x: Vec<f64>, rows: Rows, loss: Loss) -> Result<Self, String> {
        let n = x.len();
        rows.check_shape(n)?;
        let all = rows.residuals.iter().chain(rows.jacobian.iter().flatten());
        if !all.copied().all(f64::is_finite) {
            return Err("a residual or a derivative is not finite".into());
        }
        /// Upper limit of residuals and derivatives: larger numbers overflow when squared and
        /// summed.
        const TOO_LARGE: f64 = 1e150;
        for (at, (r, row)) in rows.residuals.iter().zip(&rows.jacobian).enumerate() {
            if let Some(entry) = row.iter().chain([r]).find(|entry| entry.abs() > TOO_LARGE) {
                let what = if r.abs() > TOO_LARGE {
                    "is"
                } else {
                    "has the derivative"
                };
                return Err(format!(
                    "residual r[{at}] {what} {entry:e}, too large for a sum of squares"
                ));
            }
        }
        let (mut gradient, mut curvature) = (DVector::zeros(n), DMatrix::zeros(n, n));
        for (r, row) in rows.residuals.iter().zip(&rows.jacobian) {
            let weight = loss.weight(*r);
            for i in 0..n {
                gradient[i] += weight * r * row[i];
                for j in 0..=i {
                    curvature[(i, j)] += weight * row[i] * row[j];
                }
            }
        }
        curvature.fill_upper_triangle_with_lower_triangle();
        let cost = rows.residuals.iter().map(|r| loss.of(*r)).sum();
        Ok(Self {
            x,
            rows,
            cost,
            gradient,
            curvature,
        })
    }

    /// Raises each entry of `scale` to the length of its Jacobian column, if the column is longer
    /// (Moré 1978: a scale never shrinks).
    pub fn raise_scale(&self, scale: &mut [f64]) {
        for (i, length) in scale.iter_mut().enumerate() {
            *length = length.max(self.curvature[(i, i)].sqrt());
        }
    }

    /// Largest cosine of the angle between the residuals and a column of the Jacobian. Columns
    /// whose variable is blocked by a bound are omitted.
    pub fn cosine(&self, bounds: &Bounds) -> f64 {
        let size = (2.0 * self.cost).sqrt();
        let of = |i: usize| {
            let (slope, length) = (self.gradient[i], self.curvature[(i, i)].sqrt());
            let is_blocked = slope > 0.0 && self.x[i] <= bounds.low[i]
                || slope < 0.0 && self.x[i] >= bounds.high[i];
            if is_blocked || length == 0.0 || size == 0.0 {
                0.0
            } else {
                slope.abs() / (length * size)
            }
        };
        (0..self.x.len()).map(of).fold(0.0, f64::max)
    }

    /// Minimizes the model ½ dᵀ(JᵀWJ + μ D²) d + gᵀd within the bounds, with the damping μ and the
    /// diagonal matrix D of `scale`. Returns the trial point and the predicted reduction of the
    /// undamped model; `None` if the step is too long, or if the quadratic program has no solution.
    pub fn step(
        &self,
        bounds: &Bounds,
        scale: &[f64],
        damping: f64,
        solver: &mut QpSolver,
    ) -> Option<ModelStep> {
        /// Largest step, in scaled units.
        const LONGEST_STEP: f64 = 1e12;
        let n = self.x.len();
        let size = |i: usize| if scale[i] > 0.0 { scale[i] } else { 1.0 };
        let damped = |i: usize, j: usize| {
            let own = if i == j { damping } else { 0.0 };
            self.curvature[(i, j)] / (size(i) * size(j)) + own
        };
        let end = |i: usize, bound: f64| (bound - self.x[i]) * size(i);
        let gradient = DVector::from_fn(n, |i, _| self.gradient[i] / size(i));
        let program = QuadraticProgram {
            hessian: DMatrix::from_fn(n, n, damped),
            max_terms: vec![MaxTerm {
                offset: 0.0,
                gradient,
            }],
            low: DVector::from_fn(n, |i, _| end(i, bounds.low[i])),
            high: DVector::from_fn(n, |i, _| end(i, bounds.high[i])),
            rows: vec![],
        };
        let found = solver
            .solve(&program)
            .filter(|found| found.d.amax() <= LONGEST_STEP)?;
        let d = DVector::from_fn(n, |i, _| found.d[i] / size(i));
        let predicted_reduction = -(self.gradient.dot(&d) + 0.5 * d.dot(&(&self.curvature * &d)));
        let to = |i: usize| match found.activities[i] {
            Activity::Lower if bounds.low[i].is_finite() => bounds.low[i],
            Activity::Upper if bounds.high[i].is_finite() => bounds.high[i],
            _ => (self.x[i] + d[i]).clamp(bounds.low[i], bounds.high[i]),
        };
        Some(ModelStep {
            to: (0..n).map(to).collect(),
            predicted_reduction,
        })
    }
}
