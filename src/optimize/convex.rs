use super::null_space::null_space;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Eigenvalues below this fraction of the largest |eigenvalue| are reflected. The reflected
/// |eigenvalue| is at least this fraction.
const FLOOR: f64 = 1e-8;
/// An attempt adds curvature to the Hessian along the active normals. The first attempt adds the
/// largest |entry| of the Hessian. Each further attempt adds the previous curvature times this
/// factor.
const GROWTH: f64 = 4.0;
/// Maximum number of attempts to add curvature. Still more curvature would make the matrix
/// numerically singular.
const MOST_RAISES: u32 = 15;
/// Curvature added along the active normals before a reflection, relative to the largest |entry| of
/// the Hessian. It separates the eigenvalues of the active normals from those of the tangents.
const SEPARATION: f64 = 100.0;

/// Result of the convexification.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Convexified {
    /// Curvature added along each active unit normal before a reflection; 0 if none was added, or
    /// if no eigenvalue was reflected.
    pub added_curvature: f64,
    /// True if eigenvalues were reflected.
    pub is_reflected: bool,
}

/// Replaces a Hessian by a positive definite matrix. Near a minimum, both have the same curvature
/// along the tangents of the active constraints.
///
/// A quadratic program needs a convex matrix (for an indefinite matrix Clarabel returns a wrong
/// point). In order of preference:
/// 1. the Hessian itself, if it is positive definite;
/// 2. if only directions along active normals make it indefinite: the Hessian plus curvature along
///    these normals (the term of the augmented Lagrangian; Nocedal & Wright 2006, §18.3). The sum
///    is exact on the tangents, which preserves Newton's rate of convergence;
/// 3. otherwise: this sum with each negative eigenvalue λ replaced by `reflection` |λ|, where |λ|
///    is at least 1e-8 of the largest |eigenvalue| (Gill, Murray & Wright 1981, §4.4.2.1, with
///    reflection in place of truncation). The added curvature separates the normals' eigenvalues
///    from the tangents' eigenvalues. If `reflection` < 1, only the Hessian on the tangents is
///    reflected.
///
/// A zero Hessian stays zero: the program is then linear. The result is written to `convex`.
pub(super) fn convexify(
    hessian: &DMatrix<f64>,
    active_normals: impl FnOnce() -> Vec<DVector<f64>>,
    reflection: f64,
    convex: &mut DMatrix<f64>,
) -> Convexified {
    if is_positive_definite(hessian) || !hessian.amax().is_normal() {
        convex.copy_from(hessian);
        return Convexified::default();
    }
    let active = active_normals();
    if active.is_empty() {
        *convex = reflected(hessian.clone(), reflection);
        return Convexified {
            added_curvature: 0.0,
            is_reflected: true,
        };
    }
    let mut normals = DMatrix::zeros(hessian.nrows(), hessian.nrows());
    active
        .iter()
        .for_each(|normal| normals.ger(1.0, normal, normal, 1.0));
    let raised = |convex: &mut DMatrix<f64>, by: f64| {
        convex.zip_zip_apply(hessian, &normals, |entry, own, normals| {
            *entry = own + normals * by
        });
    };
    let size = hessian.amax();
    // if the Hessian is positive definite on the tangents, the sum is positive definite for a
    // sufficiently large added curvature (Debreu 1952)
    let mut raise = size;
    for _ in 0..MOST_RAISES {
        raised(convex, raise);
        if is_positive_definite(convex) {
            // do not correct the multipliers: their error is the added curvature times the
            // violation, which vanishes at a solution. With a correction, problems 106 and 116 of
            // Hock and Schittkowski end less accurately
            return Convexified::default();
        }
        raise *= GROWTH;
    }
    if reflection < 1.0 {
        *convex = reflected_along(hessian, &active, reflection);
        return Convexified {
            added_curvature: 0.0,
            is_reflected: true,
        };
    }
    raised(convex, SEPARATION * size);
    *convex = reflected(std::mem::take(convex), reflection);
    Convexified {
        added_curvature: SEPARATION * size,
        is_reflected: true,
    }
}

/// Reflects the negative curvature of the Hessian along the tangents of the active constraints.
/// Along the normals of these constraints, the curvature is set to the largest |entry| of the
/// Hessian.
fn reflected_along(
    hessian: &DMatrix<f64>,
    active: &[DVector<f64>],
    reflection: f64,
) -> DMatrix<f64> {
    let rows = DMatrix::from_rows(
        &active
            .iter()
            .map(|normal| normal.transpose())
            .collect::<Vec<_>>(),
    );
    let tangents = null_space(&rows);
    let across =
        DMatrix::identity(hessian.nrows(), hessian.nrows()) - &tangents * tangents.transpose();
    let along = reflected(tangents.transpose() * hessian * &tangents, reflection);
    &tangents * along * tangents.transpose() + across * hessian.amax()
}

/// The matrix with each eigenvalue λ below the floor replaced by `reflection` max(|λ|, floor). The
/// floor is [`FLOOR`] times the largest |eigenvalue|.
fn reflected(matrix: DMatrix<f64>, reflection: f64) -> DMatrix<f64> {
    if matrix.is_empty() {
        return matrix;
    }
    let SymmetricEigen {
        eigenvectors,
        eigenvalues,
    } = matrix.symmetric_eigen();
    let floor = FLOOR * eigenvalues.amax().max(f64::MIN_POSITIVE);
    let of = |value: f64| {
        if value > floor {
            value
        } else {
            reflection * value.abs().max(floor)
        }
    };
    let reflected = eigenvalues.map(of);
    &eigenvectors * DMatrix::from_diagonal(&reflected) * eigenvectors.transpose()
}

/// True if a symmetric matrix is positive definite with a margin for rounding. The margin is
/// relative to each diagonal entry, so that curvatures of very different sizes do not hide each
/// other.
fn is_positive_definite(matrix: &DMatrix<f64>) -> bool {
    const MARGIN: f64 = 1e-13;
    let mut smaller = matrix.clone();
    for i in 0..matrix.nrows() {
        smaller[(i, i)] *= 1.0 - MARGIN;
    }
    smaller.cholesky().is_some()
}

#[cfg(test)]
mod tests {
    use super::{convexify, is_positive_definite};
    use nalgebra::{DMatrix, DVector};

    fn convexified(hessian: &DMatrix<f64>, normals: &[DVector<f64>]) -> DMatrix<f64> {
        let mut convex = DMatrix::zeros(2, 2);
        convexify(hessian, || normals.to_vec(), 1.0, &mut convex);
        convex
    }

    #[test]
    fn exact_hessian_where_convex_and_free_block_where_an_active_variable_makes_it_indefinite() {
        let convex = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
        assert_eq!(convexified(&convex, &[]), convex);
        let bent = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, -3.0]);
        let raised = convexified(&bent, &[DVector::from_vec(vec![0.0, 1.0])]);
        assert!(is_positive_definite(&raised));
        assert_eq!((raised[(0, 0)], raised[(0, 1)]), (2.0, 1.0));
    }

    #[test]
    fn exact_reflection_of_a_saddle() {
        let reflected = convexified(&DMatrix::from_row_slice(2, 2, &[0.0, 2.0, 2.0, 0.0]), &[]);
        assert!((reflected - DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 2.0])).amax() < 1e-14);
    }
}
