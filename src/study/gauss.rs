//! Gauss rules from the recurrence of orthogonal polynomials.

use nalgebra::{DMatrix, SymmetricEigen};

/// Nodes and weights of a Gauss rule (Golub & Welsch 1969). They follow from a symmetric
/// tridiagonal matrix with the entries `diagonal` and `off_diagonal`, which are the coefficients of
/// the recurrence of the orthogonal polynomials. The weights sum to 1.
pub(super) fn gauss(diagonal: &[f64], off_diagonal: &[f64]) -> Vec<(f64, f64)> {
    let n = diagonal.len();
    let mut jacobi = DMatrix::zeros(n, n);
    for (k, entry) in diagonal.iter().enumerate() {
        jacobi[(k, k)] = *entry;
    }
    for (k, entry) in off_diagonal.iter().enumerate().take(n - 1) {
        (jacobi[(k, k + 1)], jacobi[(k + 1, k)]) = (*entry, *entry);
    }
    let eigen = SymmetricEigen::new(jacobi);
    let mut rule: Vec<(f64, f64)> = (0..n)
        .map(|k| (eigen.eigenvalues[k], eigen.eigenvectors[(0, k)].powi(2)))
        .collect();
    rule.sort_by(|a, b| a.0.total_cmp(&b.0));
    rule
}

/// Gauss–Legendre rule for a uniform distribution between two bounds.
pub(super) fn legendre([low, high]: [f64; 2], nodes: usize) -> Vec<(f64, f64)> {
    let entry = |k: f64| k / (4.0 * k * k - 1.0).sqrt();
    let off_diagonal: Vec<f64> = (1..nodes).map(|k| entry(k as f64)).collect();
    let rule = gauss(&vec![0.0; nodes], &off_diagonal);
    rule.into_iter()
        .map(|(node, weight)| (low + (high - low) * (0.5 + 0.5 * node), weight))
        .collect()
}
