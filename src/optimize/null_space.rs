use nalgebra::DMatrix;

/// An orthonormal basis of the vectors that every row of a matrix is normal to.
pub(super) fn null_space(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let n = rows.ncols();
    if n == 0 {
        return DMatrix::zeros(0, 0);
    }
    let across = (rows.transpose() * rows).symmetric_eigen();
    let largest = across.eigenvalues.iter().fold(f64::MIN_POSITIVE, |most, value| value.max(most));
    let kept: Vec<usize> = (0..n).filter(|&k| across.eigenvalues[k] <= 1e-14 * largest).collect();
    across.eigenvectors.select_columns(&kept)
}
