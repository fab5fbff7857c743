use nalgebra::DMatrix;

/// Orthonormal basis of the null space of a matrix, whose rows have length 1 or 0.
pub(super) fn null_space(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let n = rows.ncols();
    if n == 0 {
        return DMatrix::zeros(0, 0);
    }
    let gram = (rows.transpose() * rows).symmetric_eigen();
    let largest = gram
        .eigenvalues
        .iter()
        .fold(f64::MIN_POSITIVE, |most, value| value.max(most));
    let kernel: Vec<usize> = (0..n)
        .filter(|&k| gram.eigenvalues[k] <= 1e-14 * largest)
        .collect();
    gram.eigenvectors.select_columns(&kernel)
}

/// Orthonormal basis of the null space of `rows`, in all `n` variables. The columns of `rows`
/// belong to the `free` variables; the basis is 0 in the other variables. The rows may have
/// different units: each is divided by its length.
pub(super) fn tangent_basis(n: usize, free: &[usize], mut rows: DMatrix<f64>) -> DMatrix<f64> {
    for mut row in rows.row_iter_mut() {
        row.try_normalize_mut(0.0);
    }
    let basis = null_space(&rows);
    let row = |i: usize| free.iter().position(|&f| f == i);
    DMatrix::from_fn(n, basis.ncols(), |i, k| {
        row(i).map_or(0.0, |row| basis[(row, k)])
    })
}
