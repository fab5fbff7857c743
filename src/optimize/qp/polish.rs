//! From an active set to the exact solution it implies, and from there to a better active set.

use super::{End, Piece, QuadraticProgram, Step};
use nalgebra::{DMatrix, DVector};

/// Which ends and pieces hold a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ActiveSet {
    pub ends: Vec<End>,
    pub pieces: Vec<bool>,
}

/// What an active set implies, perhaps outside the ends.
pub(super) struct Candidate {
    pub d: DVector<f64>,
    pub weights: Vec<f64>,
    /// The pieces' common value.
    pub level: f64,
}

impl QuadraticProgram {
    /// Solves the program with the active ends and pieces as equations:
    /// B d + Σ αₖ gradientₖ = 0 on the free variables, Σ αₖ = 1, offsetₖ + gradientₖ · d = t.
    pub(super) fn equality_step(&self, active: &ActiveSet) -> Option<Candidate> {
        let free: Vec<usize> = (0..self.dimension()).filter(|&i| active.ends[i] == End::Free).collect();
        let held: Vec<usize> = (0..self.pieces.len()).filter(|&k| active.pieces[k]).collect();
        let mut d = DVector::from_fn(self.dimension(), |i, _| match active.ends[i] {
            End::Free => 0.0,
            End::Low => self.low[i],
            End::High => self.high[i],
        });
        let bent = &self.curvature * &d;

        let (f, size) = (free.len(), free.len() + held.len() + 1);
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        for (row, &i) in free.iter().enumerate() {
            for (column, &j) in free.iter().enumerate() {
                matrix[(row, column)] = self.curvature[(i, j)];
            }
            right[row] = -bent[i];
        }
        for (at, &k) in held.iter().enumerate() {
            let Piece { offset, gradient } = &self.pieces[k];
            for (row, &i) in free.iter().enumerate() {
                matrix[(row, f + at)] = gradient[i];
                matrix[(f + at, row)] = gradient[i];
            }
            matrix[(f + at, size - 1)] = -1.0;
            matrix[(size - 1, f + at)] = 1.0;
            right[f + at] = -offset - gradient.dot(&d);
        }
        right[size - 1] = 1.0;

        let solution = matrix.lu().solve(&right)?;
        if !solution.iter().all(|x| x.is_finite()) {
            return None;
        }
        for (row, &i) in free.iter().enumerate() {
            d[i] = solution[row];
        }
        let mut weights = vec![0.0; self.pieces.len()];
        for (at, &k) in held.iter().enumerate() {
            weights[k] = solution[f + at];
        }
        Some(Candidate { d, weights, level: solution[size - 1] })
    }

    /// The active set with what a candidate contradicts put right: free variables beyond an end are held,
    /// held ones that pull inward are freed, and likewise for the pieces.
    pub(super) fn corrected(&self, active: &ActiveSet, candidate: &Candidate) -> ActiveSet {
        let mut pull = &self.curvature * &candidate.d;
        for (piece, weight) in self.pieces.iter().zip(&candidate.weights) {
            pull += &piece.gradient * *weight;
        }
        let end = |i: usize| match active.ends[i] {
            _ if self.low[i] == self.high[i] => End::Low,
            End::Free if candidate.d[i] < self.low[i] => End::Low,
            End::Free if candidate.d[i] > self.high[i] => End::High,
            End::Low if pull[i] < 0.0 => End::Free,
            End::High if pull[i] > 0.0 => End::Free,
            same => same,
        };
        let tolerance = 1e-12 * (1.0 + candidate.level.abs());
        let piece = |k: usize| {
            let Piece { offset, gradient } = &self.pieces[k];
            if active.pieces[k] {
                candidate.weights[k] >= 0.0
            } else {
                offset + gradient.dot(&candidate.d) > candidate.level + tolerance
            }
        };
        ActiveSet {
            ends: (0..self.dimension()).map(end).collect(),
            pieces: (0..self.pieces.len()).map(piece).collect(),
        }
    }

    /// The candidate inside the ends.
    pub(super) fn clamped(&self, candidate: &Candidate, active: &ActiveSet) -> Step {
        let mut d = candidate.d.clone();
        let mut ends = active.ends.clone();
        for i in 0..self.dimension() {
            if d[i] <= self.low[i] {
                (d[i], ends[i]) = (self.low[i], End::Low);
            } else if d[i] >= self.high[i] {
                (d[i], ends[i]) = (self.high[i], End::High);
            }
        }
        Step { d, ends, weights: candidate.weights.clone() }
    }
}
