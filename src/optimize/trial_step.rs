use super::qp::StepSource;

/// The step that a search tries: the solution of its quadratic program.
#[derive(Clone)]
pub(super) struct TrialStep {
    /// The point at its end; a variable that ends at a bound is there exactly.
    pub x: Vec<f64>,
    /// ‖d‖∞, in units of the scale.
    pub length: f64,
    /// What the model says f falls by; it may rise where constraints ask for it.
    pub objective_reduction: f64,
    /// ‖v‖₂ before the step, in units of γ.
    pub violation: f64,
    /// ‖v‖₂ of the linearised constraints after it.
    pub linear_violation: f64,
    /// Multipliers of the constraints.
    pub multipliers: Vec<f64>,
    /// The number of active terms of the maximum; 1 away from corners.
    pub active_terms: usize,
    /// Whether the linearised constraints could not all be met, and were relaxed.
    pub is_relaxed: bool,
    /// Whether negative curvature of the model was reflected.
    pub is_reflected: bool,
    /// How its quadratic program was solved.
    pub source: StepSource,
}

/// The part of the trust region in which contradicting constraints are met as far as they can be;
/// the rest is left to the objective (Omojokun 1989: 0.8).
pub(super) const NORMAL_PART: f64 = 0.8;

impl TrialStep {
    /// Whether the trust region limits it.
    pub fn is_limited_by(&self, radius: f64) -> bool {
        let part = if self.is_relaxed { NORMAL_PART } else { 1.0 };
        self.length >= 0.99 * part * radius
    }
}
