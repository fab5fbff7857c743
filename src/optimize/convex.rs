use super::null_space::null_space;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Least curvature kept by the reflection, of the largest.
const FLOOR: f64 = 1e-8;
/// The Hessian is raised by its size first, then by this factor more …
const GROWTH: f64 = 4.0;
/// … so often at most: beyond that the sum is no longer told from singular.
const MOST_RAISES: u32 = 15;
/// Before its eigenvalues are reflected it is raised by so many times its size, which sets those of
/// the normals apart from those of the directions along them.
const APART: f64 = 100.0;

/// The changes that made a Hessian positive definite.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Convexified {
    /// The amount added along each unit normal of what is active, before a reflection.
    pub raise: f64,
    /// Whether eigenvalues were reflected.
    pub is_reflected: bool,
}

/// A positive definite stand-in for a Hessian, equal to it where the search converges.
///
/// No method for the quadratic program can use an indefinite matrix (Clarabel answers with a wrong
/// point). In order of preference:
/// 1. the Hessian itself, where it is positive definite;
/// 2. where only directions across active bounds and constraints make it indefinite: the Hessian
///    raised along their normals. On the tangents it stays exact, and with it Newton's rate (the
///    augmented Lagrangian's term; Nocedal & Wright 2006, §18.3);
/// 3. raised along them, and its negative eigenvalues then reflected to `reflection` |λ| (Gill,
///    Murray & Wright 1981, §4.4.2.1, with reflection for truncation), no smaller than 1e-8 of the
///    largest. So the tangents have their own curvature, with the sign turned, and not that of the
///    normals, which may be far larger. Where `reflection` is below 1 the Hessian is reflected on
///    the tangents alone.
///
/// A Hessian of zeros stays as it is: what it leaves of a program is linear. It is written to
/// `convex`.
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
            raise: 0.0,
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
    // some finite amount is enough (Debreu 1952) if anything is
    let mut raise = size;
    for _ in 0..MOST_RAISES {
        raised(convex, raise);
        if is_positive_definite(convex) {
            return Convexified::default();
        }
        raise *= GROWTH;
    }
    if reflection < 1.0 {
        *convex = reflected_along(hessian, &active, reflection);
        return Convexified {
            raise: 0.0,
            is_reflected: true,
        };
    }
    raised(convex, APART * size);
    *convex = reflected(std::mem::take(convex), reflection);
    Convexified {
        raise: APART * size,
        is_reflected: true,
    }
}

/// A Hessian reflected on the tangents of what is active alone, with its own size along the
/// normals.
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

/// A matrix with its negative eigenvalues reflected to `reflection` |λ|.
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

/// Whether a symmetric matrix is positive definite by a margin that survives rounding: each entry
/// of the diagonal can be smaller by that part of itself, so that curvatures of very different
/// sizes do not hide each other.
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
