use super::scaling::{EvaluatedPoint, Scaling, largest_scaled};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Quasi-Newton Hessian of the Lagrangian, in scaled variables, for a problem without Hessians. It
/// stays positive definite.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct QuasiNewton {
    rows: Vec<Vec<f64>>,
    updates: u32,
}

impl QuasiNewton {
    /// Initial Hessian: the identity times the largest scaled derivative of f.
    pub fn initial(scaling: &Scaling, at: &EvaluatedPoint) -> Self {
        let n = at.x.len();
        let slope = largest_scaled(&at.f.objective.gradient, &scaling.scale);
        Self {
            rows: rows(&(DMatrix::identity(n, n) * slope.max(f64::MIN_POSITIVE))),
            updates: 0,
        }
    }

    /// True if the dimensions fit `n` variables.
    pub fn has_dimensions(&self, n: usize) -> bool {
        self.rows.len() == n && self.rows.iter().all(|row| row.len() == n)
    }

    pub fn matrix(&self) -> DMatrix<f64> {
        let n = self.rows.len();
        DMatrix::from_fn(n, n, |i, j| self.rows[i][j])
    }

    /// Damped BFGS update after a step (Powell 1978; Nocedal & Wright 2006, procedure 18.2).
    pub fn update(
        &mut self,
        scaling: &Scaling,
        from: &EvaluatedPoint,
        to: &EvaluatedPoint,
        multipliers: &[f64],
    ) {
        let n = from.x.len();
        let (start, end) = (
            from.lagrangian_gradient(multipliers),
            to.lagrangian_gradient(multipliers),
        );
        let s = DVector::from_fn(n, |i, _| (to.x[i] - from.x[i]) / scaling.scale[i]);
        let y = DVector::from_fn(n, |i, _| (end[i] - start[i]) * scaling.scale[i]);
        let is_first = self.updates == 0;
        self.updates += 1;
        if s.norm() == 0.0 {
            return;
        }
        let curvature = s.dot(&y);
        let initial = y.norm_squared() / curvature;
        let before = if is_first && curvature > 0.0 && initial.is_finite() {
            // curvature along the first step (Nocedal & Wright 2006, eq. 6.20)
            DMatrix::identity(n, n) * initial
        } else {
            self.matrix()
        };
        let bs = &before * &s;
        let expected = s.dot(&bs);
        let damping = if curvature >= 0.2 * expected {
            1.0
        } else {
            0.8 * expected / (expected - curvature)
        };
        let y = y * damping + &bs * (1.0 - damping);
        let after = &before - &bs * bs.transpose() / expected + &y * y.transpose() / s.dot(&y);
        let is_finite = after.iter().all(|entry| entry.is_finite());
        self.rows = rows(if is_finite { &after } else { &before });
    }
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect()
}
