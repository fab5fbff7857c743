use super::Number;

/// Solves A x = b by Gaussian elimination with partial pivoting. `None` where A is exactly singular or holds a number that is not finite.
///
/// nalgebra's and num-dual's decompositions ask for more than [`Number`] offers; a number type of our own
/// need not be a field in their sense.
pub(crate) fn solve<T: Number, const N: usize>(mut a: [[T; N]; N], mut b: [T; N]) -> Option<[T; N]> {
    for column in 0..N {
        let pivot = (column..N).max_by(|&i, &j| {
            let size = |row: usize| a[row][column].re().abs();
            size(i).total_cmp(&size(j))
        })?;
        let size = a[pivot][column].re();
        if size == 0.0 || !size.is_finite() {
            return None;
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let inverse = a[column][column].recip();
        for row in column + 1..N {
            let factor = a[row][column] * inverse;
            let (above, below) = a.split_at_mut(row);
            for (entry, eliminated) in below[0].iter_mut().zip(above[column]).skip(column + 1) {
                *entry = *entry - factor * eliminated;
            }
            b[row] = b[row] - factor * b[column];
        }
    }
    for row in (0..N).rev() {
        for k in row + 1..N {
            b[row] = b[row] - a[row][k] * b[k];
        }
        b[row] = b[row] / a[row][row];
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::solve;

    #[test]
    fn exact_system_that_needs_a_pivot() {
        let x = solve([[0.0, 2.0], [4.0, 2.0]], [2.0, 6.0]);
        assert_eq!(x, Some([1.0, 1.0]));
    }

    #[test]
    fn exact_singular_and_non_finite_systems_have_no_solution() {
        assert_eq!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
        assert_eq!(solve([[f64::NAN]], [1.0]), None);
    }
}
