use nalgebra::{DMatrix, DVector};

/// minimise  ½ dᵀB d + maxₖ (offsetₖ + gradientₖ · d)  over  low ≤ d ≤ high  and  rows, with B positive definite.
///
/// One piece is the usual quadratic model of a smooth function; more describe a function with a kink, each
/// smooth side of it by a piece.
#[derive(Clone, Debug, Default)]
pub struct QuadraticProgram {
    /// B.
    pub curvature: DMatrix<f64>,
    /// The linear pieces; the first is the one that holds at d = 0.
    pub pieces: Vec<Piece>,
    /// Lower ends of the step, ≤ 0.
    pub low: DVector<f64>,
    /// Upper ends of the step, ≥ 0.
    pub high: DVector<f64>,
    /// Linear constraints.
    pub rows: Vec<Row>,
}

/// offset + gradient · d.
#[derive(Clone, Debug, Default)]
pub struct Piece {
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
    /// Lower end, or −∞.
    pub low: f64,
    /// Upper end, or ∞.
    pub high: f64,
}

/// Where a variable or a row ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Between its ends.
    Free,
    /// Exactly at the lower end.
    Low,
    /// Exactly at the upper end.
    High,
}

/// A step.
#[derive(Clone, Debug)]
pub struct Step {
    /// d; a variable at an end is there exactly.
    pub d: DVector<f64>,
    /// Where each variable ends.
    pub ends: Vec<End>,
    /// Weight of each piece, ≥ 0, together 1.
    pub weights: Vec<f64>,
    /// Multiplier of each row: > 0 at its upper end, < 0 at its lower, 0 between. Gradient, curvature and these
    /// balance: B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 on the variables that are free.
    pub multipliers: Vec<f64>,
    /// Who found the active set.
    pub by: Method,
}

impl Step {
    /// That of a program without a solution: it stays where it is.
    pub fn none(variables: usize, rows: usize) -> Self {
        Self {
            d: DVector::zeros(variables),
            ends: vec![End::Free; variables],
            weights: vec![1.0],
            multipliers: vec![0.0; rows],
            by: Method::Descent,
        }
    }
}

/// Who found the active set of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The walk over the faces of the box.
    Faces,
    /// The dual active-set method.
    Dual,
    /// Clarabel.
    Clarabel,
    /// Clarabel, after the rows were rescaled.
    Rescaled,
    /// None: the step runs down the slope.
    Descent,
}

impl QuadraticProgram {
    /// Makes room for a program of `n` variables, one piece and `m` rows, without moving what has it.
    pub(in crate::optimize) fn resize(&mut self, n: usize, m: usize) {
        if self.dimension() != n {
            let own = Piece { offset: 0.0, gradient: DVector::zeros(n) };
            let (low, high) = (DVector::zeros(n), DVector::zeros(n));
            *self = Self { curvature: DMatrix::zeros(n, n), pieces: vec![own], low, high, rows: vec![] };
        }
        self.pieces.truncate(1);
        self.rows.resize_with(m, Row::default);
    }

    /// The objective.
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        let pieces = self.pieces.iter().map(|piece| piece.offset + piece.gradient.dot(d));
        0.5 * quadratic_form(&self.curvature, d) + pieces.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest amount by which a row is missed.
    pub(super) fn missed(&self, d: &DVector<f64>) -> f64 {
        let missed = |row: &Row| {
            let value = row.normal.dot(d);
            (row.low - value).max(value - row.high).max(0.0)
        };
        self.rows.iter().map(missed).fold(0.0, f64::max)
    }

    pub(super) fn dimension(&self) -> usize {
        self.low.len()
    }
}

/// dᵀ B d.
pub(in crate::optimize) fn quadratic_form(b: &DMatrix<f64>, d: &DVector<f64>) -> f64 {
    b.column_iter().zip(d).map(|(column, d_j)| d_j * column.dot(d)).sum()
}
