//! Cholesky factors of small matrices.

use nalgebra::DMatrix;

/// Writes L of B = L Lᵀ over the lower triangle of a symmetric matrix; whether it is positive definite. What stands above the
/// diagonal stays.
pub(super) fn factorise(matrix: &mut DMatrix<f64>) -> bool {
    let n = matrix.nrows();
    let all = matrix.as_mut_slice();
    for c in 0..n {
        let (before, own) = all.split_at_mut(c * n);
        let own = &mut own[c..n];
        for column in before.chunks_exact(n) {
            let below = &column[c..];
            subtract_times(own, below[0], below);
        }
        if !(own[0] > 0.0 && own[0].is_finite()) {
            return false;
        }
        let root = own[0].sqrt();
        own[0] = root;
        own[1..].iter_mut().for_each(|entry| *entry /= root);
    }
    true
}

/// Solves L Lᵀ x = b, which is written over.
pub(super) fn solve(factors: &DMatrix<f64>, x: &mut [f64]) {
    let n = factors.nrows();
    for (c, column) in factors.as_slice().chunks_exact(n).enumerate() {
        x[c] /= column[c];
        let known = x[c];
        subtract_times(&mut x[c + 1..], known, &column[c + 1..]);
    }
    for (c, column) in factors.as_slice().chunks_exact(n).enumerate().rev() {
        let known: f64 = column[c + 1..].iter().zip(&x[c + 1..]).map(|(entry, x)| entry * x).sum();
        x[c] = (x[c] - known) / column[c];
    }
}

/// a − times · b.
fn subtract_times(a: &mut [f64], times: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= times * b);
}

#[cfg(test)]
mod tests {
    use super::{factorise, solve};
    use nalgebra::DMatrix;

    #[test]
    fn exact_factors_and_solution_of_a_system_of_three() {
        // L = [2 0 0; 6 1 0; −8 5 3], and L Lᵀ (1, 2, 3)
        let mut matrix = DMatrix::from_row_slice(3, 3, &[4.0, 12.0, -16.0, 12.0, 37.0, -43.0, -16.0, -43.0, 98.0]);
        let mut x = [4.0 + 24.0 - 48.0, 12.0 + 74.0 - 129.0, -16.0 - 86.0 + 294.0];
        assert!(factorise(&mut matrix));
        assert_eq!(
            matrix.lower_triangle(),
            DMatrix::from_row_slice(3, 3, &[2.0, 0.0, 0.0, 6.0, 1.0, 0.0, -8.0, 5.0, 3.0])
        );
        solve(&matrix, &mut x);
        assert_eq!(x, [1.0, 2.0, 3.0]);
    }

    #[test]
    fn exact_refusal_of_what_is_not_positive_definite() {
        for mut matrix in [
            DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]),
            DMatrix::zeros(2, 2),
            DMatrix::from_row_slice(1, 1, &[f64::NAN]),
        ] {
            assert!(!factorise(&mut matrix));
        }
    }
}
