use super::symmetric::Symmetric;
use crate::optimize::qp::{End, Step};
use nalgebra::DVector;

/// minimise  ½ dᵀB d + gradient · d  over  low ≤ d ≤ high  and  rows, with B = H + shift · 1 positive definite.
#[derive(Clone, Debug)]
pub(in crate::optimize) struct SparseProgram {
    /// H, not always convex.
    pub hessian: Symmetric,
    /// B.
    pub convex: Symmetric,
    /// What was added to the diagonal of H.
    pub shift: f64,
    pub gradient: DVector<f64>,
    /// Lower ends of the step, ≤ 0.
    pub low: DVector<f64>,
    /// Upper ends of the step, ≥ 0.
    pub high: DVector<f64>,
    pub rows: Vec<SparseRow>,
    /// What probably holds the step: where the active set begins.
    pub guess: SparseActive,
}

/// low ≤ normal · d ≤ high; an equation where both are one number.
#[derive(Clone, Debug)]
pub(in crate::optimize) struct SparseRow {
    pub normal: Vec<(usize, f64)>,
    pub low: f64,
    pub high: f64,
}

/// Which ends and rows hold a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::optimize) struct SparseActive {
    pub ends: Vec<End>,
    pub rows: Vec<End>,
}

impl SparseRow {
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        self.normal.iter().map(|(i, a)| a * d[*i]).sum()
    }

    /// The largest of its coefficients.
    pub fn largest(&self) -> f64 {
        self.normal.iter().fold(0.0, |most, (_, a)| a.abs().max(most))
    }
}

impl SparseProgram {
    pub(super) fn dimension(&self) -> usize {
        self.low.len()
    }

    /// The largest amount by which a row is missed.
    pub(super) fn missed(&self, d: &DVector<f64>) -> f64 {
        let missed = |row: &SparseRow| {
            let value = row.value(d);
            (row.low - value).max(value - row.high).max(0.0)
        };
        self.rows.iter().map(missed).fold(0.0, f64::max)
    }

    /// The objective with one of its two matrices.
    pub(super) fn value(&self, matrix: &Symmetric, d: &DVector<f64>) -> f64 {
        self.gradient.dot(d) + 0.5 * matrix.quadratic_form(d)
    }

    /// Whether a step meets the rows and, where staying would meet them too, is better than that.
    pub(super) fn is_worth_it(&self, matrix: &Symmetric, step: &Step) -> bool {
        let rows_met = self.missed(&step.d) <= 1e-9 * (1.0 + step.d.amax());
        let reach = self.high.amax().max(self.low.amax());
        let rounding = 1e-14 * reach * self.gradient.amax();
        let staying_misses = self.rows.iter().any(|row| row.low > 0.0 || row.high < 0.0);
        rows_met && (staying_misses || self.value(matrix, &step.d) <= rounding)
    }
}
