use super::cholesky::factorise;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Least curvature kept by the reflection, of the largest.
const FLOOR: f64 = 1e-8;
/// The Hessian is raised by its size first, then by this factor more …
const GROWTH: f64 = 4.0;
/// … so often at most: beyond that the sum is no longer told from singular.
const MOST_RAISES: u32 = 15;
/// Before its eigenvalues are reflected it is raised by so many times its size, which sets those of the normals apart from those of the
/// directions along them.
const APART: f64 = 100.0;

/// A positive definite stand-in for a Hessian, equal to it where the search converges.
///
/// No method for the quadratic program can use an indefinite matrix (Clarabel answers with a wrong point). In order of preference:
/// 1. the Hessian itself, where it is positive definite;
/// 2. where only directions that are held make it indefinite: the Hessian raised along their normals. On what is free
///    it stays exact, and with it Newton's rate (the augmented Lagrangian's term; Nocedal & Wright 2006, §18.3);
/// 3. raised along them, and its eigenvalues then reflected to |λ| (Gill, Murray & Wright 1981, §4.4.2.1, with reflection for
///    truncation), no smaller than 1e-8 of the largest. So what is free has its own curvature, with the sign turned, and not that of the
///    normals, which may be far larger.
///
/// A Hessian of zeros stays as it is: what it leaves of a program is linear. It is written to `convex`. Returns what was added along each normal of length 1 before the reflection; 0 without one.
pub(super) fn convexify(
    hessian: &DMatrix<f64>,
    held: impl FnOnce() -> Vec<DVector<f64>>,
    convex: &mut DMatrix<f64>,
) -> f64 {
    if is_positive_definite(hessian, convex) || !hessian.amax().is_normal() {
        convex.copy_from(hessian);
        return 0.0;
    }
    let held = held();
    if held.is_empty() {
        *convex = reflected(hessian.clone());
        return 0.0;
    }
    let mut normals = DMatrix::zeros(hessian.nrows(), hessian.nrows());
    held.iter().for_each(|normal| normals.ger(1.0, normal, normal, 1.0));
    let raised = |convex: &mut DMatrix<f64>, by: f64| {
        convex.zip_zip_apply(hessian, &normals, |entry, own, normals| *entry = own + normals * by);
    };
    let size = hessian.amax();
    // some finite amount is enough (Debreu 1952) if anything is
    let (mut raise, mut room) = (size, DMatrix::default());
    for _ in 0..MOST_RAISES {
        raised(convex, raise);
        if is_positive_definite(convex, &mut room) {
            return 0.0;
        }
        raise *= GROWTH;
    }
    raised(convex, APART * size);
    *convex = reflected(std::mem::take(convex));
    APART * size
}

/// A matrix with its eigenvalues reflected to |λ|.
fn reflected(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let SymmetricEigen { eigenvectors, eigenvalues } = matrix.symmetric_eigen();
    let floor = FLOOR * eigenvalues.amax().max(f64::MIN_POSITIVE);
    let reflected = eigenvalues.map(|value| value.abs().max(floor));
    &eigenvectors * DMatrix::from_diagonal(&reflected) * eigenvectors.transpose()
}

/// Whether a symmetric matrix is positive definite by a margin that survives rounding: each entry of the diagonal can
/// be smaller by that part of itself, so that curvatures of very different sizes do not hide each other. It is
/// factorised in `room`.
fn is_positive_definite(matrix: &DMatrix<f64>, room: &mut DMatrix<f64>) -> bool {
    const MARGIN: f64 = 1e-13;
    let n = matrix.nrows();
    if room.nrows() != n {
        *room = DMatrix::zeros(n, n);
    }
    room.copy_from(matrix);
    for i in 0..n {
        room[(i, i)] *= 1.0 - MARGIN;
    }
    factorise(room)
}

#[cfg(test)]
mod tests {
    use super::{convexify, is_positive_definite};
    use nalgebra::{DMatrix, DVector};

    fn convexified(hessian: &DMatrix<f64>, held: &[DVector<f64>]) -> DMatrix<f64> {
        let mut convex = DMatrix::zeros(2, 2);
        convexify(hessian, || held.to_vec(), &mut convex);
        convex
    }

    #[test]
    fn exact_hessian_is_kept_where_convex_and_free_block_where_a_held_variable_is_to_blame() {
        let convex = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
        assert_eq!(convexified(&convex, &[]), convex);
        let bent = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, -3.0]);
        let raised = convexified(&bent, &[DVector::from_vec(vec![0.0, 1.0])]);
        assert!(is_positive_definite(&raised, &mut DMatrix::default()));
        assert_eq!((raised[(0, 0)], raised[(0, 1)]), (2.0, 1.0));
    }

    #[test]
    fn exact_reflection_of_a_saddle() {
        let reflected = convexified(&DMatrix::from_row_slice(2, 2, &[0.0, 2.0, 2.0, 0.0]), &[]);
        assert!((reflected - DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 2.0])).amax() < 1e-14);
    }
}
