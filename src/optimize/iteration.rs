use super::quadratic_model::QuadraticModel;

/// Data of one iteration, for observers.
#[derive(Clone, Debug, Default)]
pub struct Iteration {
    /// Iteration number; 0 is the start.
    pub number: u64,
    /// Objective f.
    pub value: f64,
    /// Iterate.
    pub x: Vec<f64>,
    /// Relative KKT residual.
    pub kkt_residual: f64,
    /// Largest relative violation of a constraint.
    pub violation: f64,
    /// Trust-region radius Δ for the next step, in units of the variables' scale.
    pub radius: f64,
    /// True if the step was accepted; true at the start.
    pub accepted: bool,
    /// Reduction of the merit function (of f if there are no constraints) that the model predicted
    /// for the step; 0 at the start.
    pub predicted_reduction: f64,
    /// Actual reduction of the merit function by the step; −∞ if the functions are undefined at the
    /// trial point, 0 at the start.
    pub actual_reduction: f64,
    /// The model at the iterate; `None` unless the observer requests
    /// [`models`](super::Observer::models).
    pub model: Option<QuadraticModel>,
}
