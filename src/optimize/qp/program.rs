use nalgebra::{DMatrix, DVector};

/// Quadratic program: minimize ½ dᵀB d + maxₖ (offsetₖ + gradientₖ · d) over low ≤ d ≤ high and
/// linear constraints, with B positive semidefinite.
///
/// The model of a smooth function has one term; the model of a function with a kink has one term
/// for each smooth side. All numbers must be finite, except limits; no lower limit may exceed its
/// upper limit.
#[derive(Clone, Debug, Default)]
pub struct QuadraticProgram {
    /// Hessian B.
    pub hessian: DMatrix<f64>,
    /// Terms of the maximum, at least one; the first is the largest at d = 0.
    pub max_terms: Vec<MaxTerm>,
    /// Lower bounds of the step, ≤ 0, or −∞.
    pub low: DVector<f64>,
    /// Upper bounds of the step, ≥ 0, or ∞.
    pub high: DVector<f64>,
    /// Linear constraints.
    pub rows: Vec<LinearConstraint>,
}

/// Linear term offset + gradient · d.
#[derive(Clone, Debug, Default)]
pub struct MaxTerm {
    /// Value at d = 0.
    pub offset: f64,
    /// Gradient.
    pub gradient: DVector<f64>,
}

/// Linear constraint low ≤ normal · d ≤ high; low = high is an equality.
#[derive(Clone, Debug, Default)]
pub struct LinearConstraint {
    /// Coefficients of d.
    pub normal: DVector<f64>,
    /// Lower limit, or −∞.
    pub low: f64,
    /// Upper limit, or ∞.
    pub high: f64,
}

/// Activity of a variable or row: inactive, or active at one of its limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Activity {
    /// Not active.
    Inactive,
    /// Exactly at the lower limit.
    Lower,
    /// Exactly at the upper limit.
    Upper,
}

/// Solution of a quadratic program.
#[derive(Clone, Debug)]
pub struct QpStep {
    /// Step d. A variable at a bound equals the bound exactly.
    pub d: DVector<f64>,
    /// Active bounds of the variables.
    pub activities: Vec<Activity>,
    /// Multiplier αₖ of each term of the maximum: αₖ ≥ 0, Σ αₖ = 1.
    pub weights: Vec<f64>,
    /// Multiplier μⱼ of each row: > 0 at its upper limit, < 0 at its lower limit, 0 between the
    /// limits. B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 for the variables that are not at a bound.
    pub multipliers: Vec<f64>,
    /// Method that found the step.
    pub source: StepSource,
}

/// Method that solved a quadratic program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepSource {
    /// Warm start: the previous active set solves the program (one linear system).
    WarmStart,
    /// Clarabel's active set, polished to an exact KKT point.
    Clarabel,
    /// Polishing failed. The step is the exact point of Clarabel's active set with Clarabel's
    /// multipliers, or Clarabel's own solution, projected on the bounds.
    Unpolished,
}

impl MaxTerm {
    pub(super) fn value(&self, d: &DVector<f64>) -> f64 {
        self.offset + self.gradient.dot(d)
    }
}

impl LinearConstraint {
    pub(super) fn is_equation(&self) -> bool {
        self.low == self.high
    }

    /// Signed violation at d: > 0 above the upper limit, < 0 below the lower.
    pub(in crate::optimize) fn excess(&self, d: &DVector<f64>) -> f64 {
        let value = self.normal.dot(d);
        value - value.clamp(self.low, self.high)
    }
}

impl QuadraticProgram {
    /// Resizes to `n` variables, one term and `m` rows; reuses the allocations.
    pub(in crate::optimize) fn resize(&mut self, n: usize, m: usize) {
        if self.dimension() != n {
            *self = Self {
                hessian: DMatrix::zeros(n, n),
                max_terms: vec![MaxTerm {
                    offset: 0.0,
                    gradient: DVector::zeros(n),
                }],
                low: DVector::zeros(n),
                high: DVector::zeros(n),
                rows: vec![],
            };
        }
        self.max_terms.truncate(1);
        self.rows.resize_with(m, LinearConstraint::default);
    }

    /// Objective at d.
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        let terms = self.max_terms.iter().map(|term| term.value(d));
        0.5 * quadratic_form(&self.hessian, d) + terms.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Largest violation of a row.
    pub(super) fn violation(&self, d: &DVector<f64>) -> f64 {
        self.rows
            .iter()
            .map(|row| row.excess(d).abs())
            .fold(0.0, f64::max)
    }

    pub(super) fn dimension(&self) -> usize {
        self.low.len()
    }

    /// Largest absolute value of the finite bounds; 1 if all bounds are 0 or infinite.
    pub(super) fn largest_bound(&self) -> f64 {
        let bounds = self.low.iter().chain(&self.high).map(|bound| bound.abs());
        let largest = bounds.filter(|bound| bound.is_finite()).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// Largest gradient component of a term.
    pub(super) fn largest_gradient_component(&self) -> f64 {
        self.max_terms
            .iter()
            .map(|term| term.gradient.amax())
            .fold(0.0, f64::max)
    }
}

/// Quadratic form dᵀ B d.
pub(in crate::optimize) fn quadratic_form(b: &DMatrix<f64>, d: &DVector<f64>) -> f64 {
    b.column_iter()
        .zip(d)
        .map(|(column, d_j)| d_j * column.dot(d))
        .sum()
}
