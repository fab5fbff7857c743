use nalgebra::DMatrix;

/// An orthonormal basis of the vectors that every row of a matrix is normal to.
pub(super) fn null_space(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let n = rows.ncols();
    if n == 0 {
        return DMatrix::zeros(0, 0);
    }
    let across = (rows.transpose() * rows).symmetric_eigen();
    let largest = across
        .eigenvalues
        .iter()
        .fold(f64::MIN_POSITIVE, |most, value| value.max(most));
    let kept: Vec<usize> = (0..n)
        .filter(|&k| across.eigenvalues[k] <= 1e-14 * largest)
        .collect();
    across.eigenvectors.select_columns(&kept)
}

/// An orthonormal basis of the moves of `n` variables that leave all but the free ones where they
/// are and that every row, over the free ones, is normal to.
pub(super) fn free_moves(n: usize, free: &[usize], rows: &DMatrix<f64>) -> DMatrix<f64> {
    let basis = null_space(rows);
    let row = |i: usize| free.iter().position(|&f| f == i);
    DMatrix::from_fn(n, basis.ncols(), |i, k| {
        row(i).map_or(0.0, |row| basis[(row, k)])
    })
}
