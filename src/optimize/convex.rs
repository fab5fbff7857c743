use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

/// A positive definite stand-in for a Hessian, equal to it where the search converges.
///
/// No method for the quadratic program can use an indefinite matrix (Clarabel answers with a wrong point). In order of preference:
/// 1. the Hessian itself, where it is positive definite;
/// 2. where only directions that are held make it indefinite: the Hessian raised along their normals. On what is free
///    it stays exact, and with it Newton's rate (the augmented Lagrangian's term; Nocedal & Wright 2006, §18.3);
/// 3. its eigenvalues reflected to |λ| (Gill, Murray & Wright 1981, §4.4.2.1, with reflection for truncation),
///    no smaller than 1e-8 of the largest.
///
/// It is written to `convex`.
pub(super) fn convexify(hessian: &DMatrix<f64>, held: impl FnOnce() -> Vec<DVector<f64>>, convex: &mut DMatrix<f64>) {
    if is_positive_definite(hessian, convex) {
        convex.copy_from(hessian);
    } else {
        *convex = raised(hessian, &held()).unwrap_or_else(|| reflected(hessian));
    }
}

/// The Hessian raised along normals until it is positive definite, if they are to blame.
fn raised(hessian: &DMatrix<f64>, held: &[DVector<f64>]) -> Option<DMatrix<f64>> {
    if !held.is_empty() {
        let n = hessian.nrows();
        let mut normals = DMatrix::zeros(n, n);
        held.iter().for_each(|normal| normals.ger(1.0, normal, normal, 1.0));
        // some finite amount is enough (Debreu 1952) if anything is; doubling finds it
        let (mut raised, mut room) = (hessian.clone(), DMatrix::default());
        let mut raise = hessian.amax().max(f64::MIN_POSITIVE);
        for _ in 0..MOST_DOUBLINGS {
            raised.zip_zip_apply(hessian, &normals, |entry, own, normals| *entry = own + normals * raise);
            if is_positive_definite(&raised, &mut room) {
                return Some(raised);
            }
            raise *= 2.0;
        }
    }
    None
}

/// The Hessian with its eigenvalues reflected to |λ|.
fn reflected(hessian: &DMatrix<f64>) -> DMatrix<f64> {
    let SymmetricEigen { eigenvectors, eigenvalues } = hessian.clone().symmetric_eigen();
    let floor = FLOOR * eigenvalues.amax().max(f64::MIN_POSITIVE);
    let reflected = eigenvalues.map(|value| value.abs().max(floor));
    &eigenvectors * DMatrix::from_diagonal(&reflected) * eigenvectors.transpose()
}

/// Least curvature kept by the reflection, of the largest.
const FLOOR: f64 = 1e-8;

/// Beyond 2³⁰ times the Hessian's size the sum is no longer told from singular.
const MOST_DOUBLINGS: u32 = 30;

/// Whether a symmetric matrix is positive definite by a margin that survives rounding: each entry of the diagonal can
/// be smaller by that part of itself, so that curvatures of very different sizes do not hide each other. It is
/// factorised in `room`.
fn is_positive_definite(matrix: &DMatrix<f64>, room: &mut DMatrix<f64>) -> bool {
    const MARGIN: f64 = 1e-13;
    let n = matrix.nrows();
    if room.nrows() != n {
        *room = DMatrix::zeros(n, n);
    }
    let mut lowered = std::mem::take(room);
    lowered.copy_from(matrix);
    for i in 0..n {
        lowered[(i, i)] *= 1.0 - MARGIN;
    }
    let factors = Cholesky::new(lowered);
    let is_found = factors.is_some();
    *room = factors.map(Cholesky::unpack_dirty).unwrap_or_default();
    is_found
}

#[cfg(test)]
mod tests {
    use super::{convexify, is_positive_definite};
    use nalgebra::{DMatrix, DVector, dmatrix, dvector};

    fn convexified(hessian: &DMatrix<f64>, held: &[DVector<f64>]) -> DMatrix<f64> {
        let mut convex = DMatrix::zeros(2, 2);
        convexify(hessian, || held.to_vec(), &mut convex);
        convex
    }

    #[test]
    fn exact_hessian_is_kept_where_convex_and_free_block_where_a_held_variable_is_to_blame() {
        let convex = dmatrix![2.0, 1.0; 1.0, 2.0];
        assert_eq!(convexified(&convex, &[]), convex);
        let bent = dmatrix![2.0, 1.0; 1.0, -3.0];
        let raised = convexified(&bent, &[dvector![0.0, 1.0]]);
        assert!(is_positive_definite(&raised, &mut DMatrix::default()));
        assert_eq!((raised[(0, 0)], raised[(0, 1)]), (2.0, 1.0));
    }

    #[test]
    fn exact_reflection_of_a_saddle() {
        let reflected = convexified(&dmatrix![0.0, 2.0; 2.0, 0.0], &[]);
        assert!((reflected - dmatrix![2.0, 0.0; 0.0, 2.0]).amax() < 1e-14);
    }
}
