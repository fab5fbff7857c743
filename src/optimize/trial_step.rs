//! Trial steps, and the ratio test of their actual and predicted reduction.

use super::qp::StepSource;
use super::scaling::EvaluatedPoint;

/// A trial step: solution of the quadratic program, with the quantities that the model predicts.
#[derive(Clone)]
pub(super) struct TrialStep {
    /// Trial point x + d. A variable that ends at a bound equals the bound exactly.
    pub x: Vec<f64>,
    /// Length ‖d‖∞, in units of the variables' scale.
    pub length: f64,
    /// Predicted reduction of f. Negative if the constraints require f to rise.
    pub objective_reduction: f64,
    /// Norm ‖v‖₂ of the violations before the step, in units of γ.
    pub violation: f64,
    /// Norm ‖v‖₂ of the linearized constraints' violations after the step.
    pub linear_violation: f64,
    /// Multipliers λ of the constraints.
    pub multipliers: Vec<f64>,
    /// Number of active terms of the piecewise model; 1 if no kink is near.
    pub active_terms: usize,
    /// True if the linearized constraints were inconsistent and were relaxed.
    pub is_relaxed: bool,
    /// True if negative eigenvalues of the Hessian were reflected.
    pub is_reflected: bool,
    /// Method that solved the quadratic program.
    pub source: StepSource,
}

/// Fraction of the trust-region radius to which the step of least violation is limited if the
/// constraints are inconsistent. The rest remains for the objective (Omojokun 1989: 0.8).
pub(super) const NORMAL_PART: f64 = 0.8;

impl TrialStep {
    /// True if the step ends on the boundary of the trust region.
    pub fn is_limited_by(&self, radius: f64) -> bool {
        let part = if self.is_relaxed { NORMAL_PART } else { 1.0 };
        self.length >= 0.99 * part * radius
    }
}

/// A trial step, the point at its end (`None` where the functions are undefined), and the reduction
/// of the merit function.
pub(super) struct Trial {
    pub step: TrialStep,
    pub point: Option<EvaluatedPoint>,
    pub reduction: Reduction,
}

/// Actual and predicted reduction of the merit function by a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduction {
    /// Actual reduction φ(x) − φ(x + d), with the merit function φ.
    pub actual: f64,
    /// Reduction predicted by the quadratic model.
    pub predicted: f64,
    /// Size of the merit function, to which its rounding error is proportional.
    pub size: f64,
}

/// Rounding error of the functions: of f relative to the objective's size, of a constraint relative
/// to its scale γ.
pub(super) const NOISE: f64 = 1e-14;
/// Threshold for reductions, relative to the size of the merit function. Smaller reductions are
/// little more than rounding.
const NEARLY_NOISE: f64 = 1e-10;
/// Smallest ratio of actual to predicted reduction of an accepted step (Conn, Gould & Toint 2000,
/// §6.1: any small positive number).
const ACCEPT: f64 = 1e-4;
/// A step is poor if the ratio of actual to predicted reduction is below this value: the trust
/// region shrinks.
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// A model counts as exact if the relative error of its predicted reduction is at most this value.
const EXACT: f64 = 1e-9;

impl Reduction {
    pub fn is_acceptable(&self) -> bool {
        self.ratio_is_at_least(ACCEPT)
    }

    pub fn is_poor(&self) -> bool {
        !self.ratio_is_at_least(POOR)
    }

    pub fn is_good(&self) -> bool {
        self.actual > GOOD * self.predicted
    }

    pub fn is_exact(&self) -> bool {
        (self.actual - self.predicted).abs() <= EXACT * self.predicted.abs()
    }

    pub fn is_nearly_rounding(&self) -> bool {
        let most = NEARLY_NOISE * self.size;
        self.predicted <= most && self.actual.abs() <= most
    }

    /// True if the ratio of actual to predicted reduction is at least `ratio`. The rounding error
    /// of the functions is added to both reductions, so that a step within rounding is accepted.
    fn ratio_is_at_least(&self, ratio: f64) -> bool {
        let noise = NOISE * self.size;
        self.actual + noise >= ratio * (self.predicted + noise)
    }
}
