use nalgebra::{DMatrix, DVector};

/// minimise ½ dᵀB d + maxₖ (offsetₖ + gradientₖ · d) over low ≤ d ≤ high and linear constraints,
/// with B positive semidefinite.
///
/// One term of the maximum is the usual quadratic model of a smooth function; more describe a
/// function with a corner, each smooth side of it by a term. All numbers must be finite but for
/// limits of rows, and no lower end may exceed its upper one.
#[derive(Clone, Debug, Default)]
pub struct QuadraticProgram {
    /// B.
    pub hessian: DMatrix<f64>,
    /// The terms of the maximum, at least one; the first is the largest at d = 0.
    pub max_terms: Vec<MaxTerm>,
    /// Lower bounds of the step, ≤ 0, or −∞.
    pub low: DVector<f64>,
    /// Upper bounds of the step, ≥ 0, or ∞.
    pub high: DVector<f64>,
    /// Linear constraints.
    pub rows: Vec<Row>,
}

/// offset + gradient · d.
#[derive(Clone, Debug, Default)]
pub struct MaxTerm {
    /// Value at d = 0.
    pub offset: f64,
    /// Slope.
    pub gradient: DVector<f64>,
}

/// low ≤ normal · d ≤ high; an equation where both are one number.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Coefficients of d.
    pub normal: DVector<f64>,
    /// Lower limit, or −∞.
    pub low: f64,
    /// Upper limit, or ∞.
    pub high: f64,
}

/// Whether a variable or a row is active, and on which side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Not active.
    Inactive,
    /// Exactly at the lower end.
    Lower,
    /// Exactly at the upper end.
    Upper,
}

/// A solution of a quadratic program.
#[derive(Clone, Debug)]
pub struct Step {
    /// d; a variable at a bound is there exactly.
    pub d: DVector<f64>,
    /// The bounds on which the variables lie.
    pub sides: Vec<Side>,
    /// Multiplier α of each term of the maximum, ≥ 0, together 1.
    pub weights: Vec<f64>,
    /// Multiplier μ of each row: > 0 at its upper limit, < 0 at its lower, 0 between.
    /// B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 on the variables that are not at a bound.
    pub multipliers: Vec<f64>,
    /// How it was found.
    pub source: StepSource,
}

/// How a quadratic program was solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepSource {
    /// The active set of the program before holds: one linear system.
    WarmStart,
    /// Clarabel's active set, polished to an exact KKT point.
    Clarabel,
    /// Clarabel's own solution, moved inside the bounds: no active set near it is exact.
    Unpolished,
}

impl Row {
    pub(super) fn is_equation(&self) -> bool {
        self.low == self.high
    }

    /// The amount by which d exceeds the limits: above the upper > 0, below the lower < 0.
    pub(in crate::optimize) fn excess(&self, d: &DVector<f64>) -> f64 {
        let value = self.normal.dot(d);
        value - value.clamp(self.low, self.high)
    }
}

impl QuadraticProgram {
    /// Gives it the shape of a program of `n` variables, one term and `m` rows, in the memory that
    /// it has.
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
        self.rows.resize_with(m, Row::default);
    }

    /// The objective.
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        let terms = self
            .max_terms
            .iter()
            .map(|term| term.offset + term.gradient.dot(d));
        0.5 * quadratic_form(&self.hessian, d) + terms.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest violation of a row.
    pub(super) fn violation(&self, d: &DVector<f64>) -> f64 {
        self.rows
            .iter()
            .map(|row| row.excess(d).abs())
            .fold(0.0, f64::max)
    }

    pub(super) fn dimension(&self) -> usize {
        self.low.len()
    }

    /// The largest absolute value of a finite bound; 1 without one.
    pub(super) fn reach(&self) -> f64 {
        let bounds = self.low.iter().chain(&self.high).map(|bound| bound.abs());
        let largest = bounds.filter(|bound| bound.is_finite()).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// The largest slope of a term.
    pub(super) fn largest_slope(&self) -> f64 {
        self.max_terms
            .iter()
            .map(|term| term.gradient.amax())
            .fold(0.0, f64::max)
    }
}

/// dᵀ B d.
pub(in crate::optimize) fn quadratic_form(b: &DMatrix<f64>, d: &DVector<f64>) -> f64 {
    b.column_iter()
        .zip(d)
        .map(|(column, d_j)| d_j * column.dot(d))
        .sum()
}
