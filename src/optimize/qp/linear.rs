//! Small symmetric linear systems. Equilibration prevents large curvatures and normals from hiding
//! small curvatures and normals.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Equations count as linearly independent if, after equilibration, each pivot is at least this
/// fraction of the largest pivot.
const DEPENDENT: f64 = 1e-14;
/// Threshold for eigenvalues after equilibration. Smaller eigenvalues count as zero.
const RANK: f64 = 1e-13;
/// Equilibration ends when all factors of a pass are between 1/4 and 4. The largest entry of each
/// row is then between 1/16 and 16.
const ALIKE: f64 = 4.0;
/// Linearly dependent equations count as inconsistent if the residual of their solution is larger
/// than this fraction of the largest right-hand side.
const INCONSISTENT: f64 = 1e-9;

/// A symmetric system of linear equations.
pub(in crate::optimize) struct SymmetricSystem {
    pub matrix: DMatrix<f64>,
    pub right: DVector<f64>,
}

impl SymmetricSystem {
    /// Solves the system. If its equations are linearly dependent, returns the solution of minimum
    /// norm, or `None` if they are inconsistent. `None` also if a number is not finite.
    pub fn solve(mut self) -> Option<DVector<f64>> {
        let lengths = self.equilibrate()?;
        let mut x = self
            .unique_solution()
            .or_else(|| self.minimum_norm_solution())?;
        x.component_mul_assign(&lengths);
        Some(x)
    }

    /// Equilibrates the system: multiplies its rows and columns by the returned factors. `None` if
    /// an entry is not finite.
    fn equilibrate(&mut self) -> Option<DVector<f64>> {
        let Self { matrix, right } = self;
        if !matrix.iter().chain(right.iter()).all(|x| x.is_finite()) {
            return None;
        }
        let lengths = equilibration_factors(matrix);
        for (column, own) in matrix
            .as_mut_slice()
            .chunks_exact_mut(lengths.len().max(1))
            .zip(lengths.as_slice())
        {
            column
                .iter_mut()
                .zip(lengths.as_slice())
                .for_each(|(entry, length)| *entry = *entry * length * own);
        }
        right.component_mul_assign(&lengths);
        Some(lengths)
    }

    fn unique_solution(&self) -> Option<DVector<f64>> {
        if self.right.is_empty() {
            return Some(self.right.clone());
        }
        let lu = self.matrix.clone().lu();
        let pivots = lu.lu_internal().diagonal().map(f64::abs);
        if pivots.min() <= DEPENDENT * pivots.max() {
            return None;
        }
        let first = lu.solve(&self.right)?;
        let rest = self.residual(&first);
        let refined = lu
            .solve(&rest)
            .map_or(first.clone(), |change| &first + change);
        let best = if self.residual(&refined).norm() < rest.norm() {
            refined
        } else {
            first
        };
        is_finite(&best).then_some(best)
    }

    fn minimum_norm_solution(&self) -> Option<DVector<f64>> {
        let SymmetricEigen {
            eigenvalues,
            eigenvectors,
        } = self
            .matrix
            .clone()
            .try_symmetric_eigen(f64::EPSILON, 1000)?;
        let mut parts = eigenvectors.tr_mul(&self.right);
        parts.zip_apply(&eigenvalues, |part, value| {
            *part = if value.abs() > RANK {
                *part / value
            } else {
                0.0
            }
        });
        let solution = eigenvectors * parts;
        let is_met = self.residual(&solution).amax()
            <= INCONSISTENT * self.right.amax().max(f64::MIN_POSITIVE);
        (is_met && is_finite(&solution)).then_some(solution)
    }

    fn residual(&self, x: &DVector<f64>) -> DVector<f64> {
        &self.right - &self.matrix * x
    }
}

fn is_finite(x: &DVector<f64>) -> bool {
    x.iter().all(|x| x.is_finite())
}

/// Equilibration factors of a symmetric matrix (Ruiz 2001): they bring the largest entry of each
/// row near 1 (see [`ALIKE`]).
fn equilibration_factors(matrix: &DMatrix<f64>) -> DVector<f64> {
    let n = matrix.nrows();
    let mut lengths = DVector::from_element(n, 1.0);
    let mut factors = lengths.clone();
    for _ in 0..4 {
        let columns = matrix.as_slice().chunks_exact(n.max(1));
        for ((column, length), factor) in
            columns.zip(lengths.as_slice()).zip(factors.as_mut_slice())
        {
            // all entries are finite: this is cheaper than `f64::max`, which handles NaN
            let larger = |most: f64, a: f64| if a > most { a } else { most };
            let entries = column
                .iter()
                .zip(lengths.as_slice())
                .map(|(entry, other)| (entry * other).abs());
            let largest = entries.fold(0.0, larger) * length;
            *factor = if largest == 0.0 {
                1.0
            } else {
                largest.sqrt().recip()
            };
        }
        if factors
            .iter()
            .all(|factor| (ALIKE.recip()..=ALIKE).contains(factor))
        {
            break;
        }
        lengths.component_mul_assign(&factors);
    }
    lengths
}
