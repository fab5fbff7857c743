//! Small symmetric systems of equations, balanced so that curvatures and normals of very different
//! sizes do not hide each other.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Pivots below this part of the largest, after balancing, show equations that depend on each
/// other.
const DEPENDENT: f64 = 1e-14;
/// Eigenvalues below this, after balancing, are none.
const RANK: f64 = 1e-13;
/// Rows whose largest entries differ from 1 by less than this factor's square are balanced.
const ALIKE: f64 = 4.0;
/// What dependent equations may miss, of the largest right-hand side.
const CONTRADICTS: f64 = 1e-9;

/// Solves a system. Where its equations depend on each other, the shortest solution of those that
/// do not contradict; `None` where some do.
pub(super) fn solved(matrix: DMatrix<f64>, right: DVector<f64>) -> Option<DVector<f64>> {
    let system = Balanced::new(matrix, right)?;
    system
        .only_solution()
        .or_else(|| system.shortest_solution())
}

/// A system whose rows and columns were multiplied by `lengths`.
struct Balanced {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    lengths: DVector<f64>,
}

impl Balanced {
    /// `None` where an entry is not finite.
    fn new(mut matrix: DMatrix<f64>, mut right: DVector<f64>) -> Option<Self> {
        if !matrix.iter().chain(right.iter()).all(|x| x.is_finite()) {
            return None;
        }
        let lengths = balance(&matrix);
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
        Some(Self {
            matrix,
            right,
            lengths,
        })
    }

    fn only_solution(&self) -> Option<DVector<f64>> {
        if self.right.is_empty() {
            return Some(self.right.clone());
        }
        let lu = self.matrix.clone().lu();
        let pivots = lu.lu_internal().diagonal().map(f64::abs);
        if pivots.min() <= DEPENDENT * pivots.max() {
            return None;
        }
        let first = lu.solve(&self.right)?;
        let rest = self.left_over(&first);
        let refined = lu
            .solve(&rest)
            .map_or(first.clone(), |change| &first + change);
        let best = if self.left_over(&refined).norm() < rest.norm() {
            refined
        } else {
            first
        };
        self.whole(best)
    }

    fn shortest_solution(&self) -> Option<DVector<f64>> {
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
        let shortest = eigenvectors * parts;
        let is_met = self.left_over(&shortest).amax()
            <= CONTRADICTS * self.right.amax().max(f64::MIN_POSITIVE);
        self.whole(shortest).filter(|_| is_met)
    }

    fn left_over(&self, x: &DVector<f64>) -> DVector<f64> {
        &self.right - &self.matrix * x
    }

    /// A solution in the units of the system before it was balanced, if it is finite.
    fn whole(&self, mut x: DVector<f64>) -> Option<DVector<f64>> {
        let is_finite = x.iter().all(|x| x.is_finite());
        x.component_mul_assign(&self.lengths);
        is_finite.then_some(x)
    }
}

/// Factors for rows and columns of a symmetric matrix that make the largest entry of each about 1
/// (Ruiz 2001); they end where all are within [`ALIKE`] of it.
fn balance(matrix: &DMatrix<f64>) -> DVector<f64> {
    let n = matrix.nrows();
    let mut lengths = DVector::from_element(n, 1.0);
    let mut factors = lengths.clone();
    for _ in 0..4 {
        let columns = matrix.as_slice().chunks_exact(n.max(1));
        for ((column, length), factor) in
            columns.zip(lengths.as_slice()).zip(factors.as_mut_slice())
        {
            // finite all of them
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
