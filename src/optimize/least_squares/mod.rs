//! Nonlinear least squares within bounds, with exact Jacobians. The module contains nothing about
//! golf.
//!
//! ```text
//!   minimize F(x) = Σ ρ(rᵢ(x))  subject to  low ≤ x ≤ high,   ρ(r) = ½ r², or Huber's
//! ```
//!
//! by the Levenberg–Marquardt method. Each step minimizes the damped Gauss–Newton model within the
//! bounds; this is a convex quadratic program (`optimize::qp`), whose solution lies exactly on the
//! active bounds. The gain ratio controls the damping. If the residuals are undefined at a trial
//! point, the step is rejected and the damping grows.
//!
//! ```
//! use longdrive::optimize::Domain;
//! use longdrive::optimize::least_squares::{FitOptions, Rows, FitStatus, fit};
//!
//! // the line a + b t through (0, 1), (1, 3), (2, 5): a = 1, b = 2, nothing left over
//! let line = |x: &[f64]| Ok(Rows {
//!     residuals: [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)].iter().map(|(t, y)| x[0] + x[1] * t - y).collect(),
//!     jacobian: [0.0, 1.0, 2.0].iter().map(|t| vec![1.0, *t]).collect(),
//! });
//! let domain = Domain::new(vec![f64::NEG_INFINITY; 2], vec![f64::INFINITY; 2]).unwrap();
//! let found = fit(&line, &domain, &[0.0, 0.0], &FitOptions::default()).unwrap();
//! assert_eq!(found.status, FitStatus::Converged);
//! assert!((found.x[0] - 1.0).abs() < 1e-12 && (found.x[1] - 2.0).abs() < 1e-12);
//! ```

mod fit;
mod loss;
mod step;

pub use fit::{Fit, FitObserver, FitStatus, RejectedPoints, fit, fit_from, fit_observed};
pub use loss::Loss;

/// Residuals and their Jacobian at a point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Residuals r₁ … rₘ.
    pub residuals: Vec<f64>,
    /// Jacobian ∂rᵢ/∂xⱼ, a row for each residual.
    pub jacobian: Vec<Vec<f64>>,
}

impl Rows {
    /// Checks that there are residuals, and that the Jacobian has a row for each residual and `n`
    /// columns. The error is the reason.
    fn check_shape(&self, n: usize) -> Result<(), String> {
        let m = self.residuals.len();
        if m == 0 {
            return Err("there are no residuals to fit".into());
        }
        if self.jacobian.len() != m || self.jacobian.iter().any(|row| row.len() != n) {
            return Err(format!(
                "the Jacobian has the wrong shape; it must be {m} by {n} (residuals by variables)"
            ));
        }
        Ok(())
    }
}

/// Options of a fit, with their defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Loss of a residual (squares).
    pub loss: Loss,
    /// Maximum number of iterations (200).
    pub max_iterations: u64,
    /// Convergence tolerance: largest cosine of the angle between the residuals and a column of the
    /// Jacobian (1e-10; Moré 1978, MINPACK's `gtol`). Columns whose variable is blocked by a bound
    /// are omitted.
    pub tolerance: f64,
    /// Rounding error of the residuals; 0, the default, if it is unknown. A fit has converged if no
    /// residual exceeds this error.
    pub rounding: f64,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            loss: Loss::Squares,
            max_iterations: 200,
            tolerance: 1e-10,
            rounding: 0.0,
        }
    }
}
