//! Nonlinear least squares over bounds, with exact Jacobians. It knows no golf.
//!
//! ```text
//!   minimise F(x) = Σ ρ(rᵢ(x))  subject to  low ≤ x ≤ high,   ρ(r) = ½ r², or Huber's
//! ```
//!
//! by Levenberg and Marquardt's method: each step is the convex quadratic program of the damped Gauss–Newton model over the
//! bounds ([`qp`](super::qp)), so that active bounds are exact; the damping follows the gain ratio. Where residuals are not
//! defined at a trial point, the step is refused and the damping grows.
//!
//! ```
//! use longdrive::optimize::Domain;
//! use longdrive::optimize::least_squares::{Options, Rows, Status, fit};
//!
//! // the line a + b t through (0, 1), (1, 3), (2, 5): a = 1, b = 2, nothing left over
//! let line = |x: &[f64]| Ok(Rows {
//!     residuals: [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)].iter().map(|(t, y)| x[0] + x[1] * t - y).collect(),
//!     jacobian: [0.0, 1.0, 2.0].iter().map(|t| vec![1.0, *t]).collect(),
//! });
//! let domain = Domain::new(vec![f64::NEG_INFINITY; 2], vec![f64::INFINITY; 2]).unwrap();
//! let found = fit(&line, &domain, &[0.0, 0.0], &Options::default()).unwrap();
//! assert_eq!(found.status, Status::Converged);
//! assert!((found.x[0] - 1.0).abs() < 1e-12 && (found.x[1] - 2.0).abs() < 1e-12);
//! ```

mod fit;
mod loss;
mod step;

pub use fit::{Fit, Follow, Status, fit, fit_from, fit_watched};
pub use loss::Loss;

/// Residuals and their Jacobian at a point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// r₁ … rₘ.
    pub residuals: Vec<f64>,
    /// ∂rᵢ/∂xⱼ, a row for each residual.
    pub jacobian: Vec<Vec<f64>>,
}

/// What is to be made small: one method.
pub trait Residuals {
    /// The residuals and their Jacobian at `x`.
    ///
    /// # Errors
    /// A sentence saying why there are none at `x`. The search then steps back.
    fn evaluate(&self, x: &[f64]) -> Result<Rows, String>;
}

impl<F: Fn(&[f64]) -> Result<Rows, String>> Residuals for F {
    fn evaluate(&self, x: &[f64]) -> Result<Rows, String> {
        self(x)
    }
}

/// Settings of a fit, each with its default.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// What is summed (squares).
    pub loss: Loss,
    /// Most iterations (200).
    pub max_iterations: u64,
    /// Largest cosine of the angle between the residuals and a column of the Jacobian that is free to move, at which the fit
    /// has converged (1e-10; Moré 1978, MINPACK's `gtol`).
    pub tolerance: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { loss: Loss::Squares, max_iterations: 200, tolerance: 1e-10 }
    }
}
