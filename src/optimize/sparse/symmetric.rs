use clarabel::algebra::CscMatrix;
use nalgebra::DVector;

/// A symmetric matrix of which most entries are 0; every entry of its diagonal is kept.
#[derive(Clone, Debug)]
pub(in crate::optimize) struct Symmetric(CscMatrix<f64>);

impl Symmetric {
    /// The sum of (i, j, value), each of which stands for (j, i) too.
    pub fn sum(n: usize, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> Self {
        let diagonal = (0..n).map(|i| (i, i, 0.0));
        let upper = entries.into_iter().map(|(i, j, value)| (i.min(j), i.max(j), value));
        let (mut rows, mut columns, mut values) = (vec![], vec![], vec![]);
        for (row, column, value) in diagonal.chain(upper) {
            rows.push(row);
            columns.push(column);
            values.push(value);
        }
        Self(CscMatrix::new_from_triplets(n, n, rows, columns, values))
    }

    /// Its upper triangle, column by column.
    pub fn upper(&self) -> &CscMatrix<f64> {
        &self.0
    }

    /// (i, j, value) of the upper triangle, i ≤ j.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let CscMatrix { n, colptr, rowval, nzval, .. } = &self.0;
        (0..*n).flat_map(move |j| (colptr[j]..colptr[j + 1]).map(move |at| (rowval[at], j, nzval[at])))
    }

    pub fn size(&self) -> usize {
        self.0.n
    }

    /// The largest |entry|.
    pub fn largest(&self) -> f64 {
        self.0.nzval.iter().fold(0.0, |most, value| value.abs().max(most))
    }

    /// Where the entries of the diagonal stand among all.
    pub fn diagonal(&self) -> Vec<usize> {
        // the last of each column of an upper triangle
        (0..self.0.n).map(|j| self.0.colptr[j + 1] - 1).collect()
    }

    /// The matrix with a number added to each entry of the diagonal.
    pub fn shifted(mut self, by: f64) -> Self {
        self.diagonal().into_iter().for_each(|at| self.0.nzval[at] += by);
        self
    }

    pub fn times(&self, d: &[f64]) -> DVector<f64> {
        let mut product = DVector::zeros(self.size());
        for (i, j, value) in self.entries() {
            product[i] += value * d[j];
            if i != j {
                product[j] += value * d[i];
            }
        }
        product
    }

    /// dᵀ M d.
    pub fn quadratic_form(&self, d: &DVector<f64>) -> f64 {
        self.times(d.as_slice()).dot(d)
    }
}
