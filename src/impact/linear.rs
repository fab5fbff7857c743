//! Small linear systems of the impact.

use crate::number::{Numbers, inlined};

/// L D Lᵀ factorization of a symmetric 3 × 3 matrix, without pivoting and branches. Accurate for
/// positive definite matrices, such as inertia tensors and compliances.
#[derive(Clone, Copy)]
pub(super) struct SymmetricFactors<T> {
    /// 1/D.
    inverse_pivots: [T; 3],
    /// Entries (1,0), (2,0), (2,1) of the unit lower triangular L.
    below: [T; 3],
}

impl<T: Numbers> SymmetricFactors<T> {
    /// Factorizes the matrix whose lower triangle, row by row, is `lower`.
    #[inline(always)]
    pub fn new([a00, a10, a11, a20, a21, a22]: [T; 6]) -> Self {
        T::not_inlined(inlined!(|| {
            let first = a00.recip();
            let (l10, l20) = (a10 * first, a20 * first);
            let second = (a11 - l10 * a10).recip();
            let reduced = a21 - l20 * a10;
            let l21 = reduced * second;
            let third = (a22 - l20 * a20 - l21 * reduced).recip();
            Self {
                inverse_pivots: [first, second, third],
                below: [l10, l20, l21],
            }
        }))
    }

    /// Solves A x = b.
    #[inline(always)]
    pub fn solve(&self, [b0, b1, b2]: [T; 3]) -> [T; 3] {
        T::not_inlined(inlined!(|| {
            let ([d0, d1, d2], [l10, l20, l21]) = (self.inverse_pivots, self.below);
            let y1 = b1 - l10 * b0;
            let y2 = b2 - l20 * b0 - l21 * y1;
            let x2 = y2 * d2;
            let x1 = y1 * d1 - l21 * x2;
            [b0 * d0 - l10 * x1 - l20 * x2, x1, x2]
        }))
    }

    /// Lanes in which the matrix is positive definite: all pivots are positive and finite.
    #[inline(always)]
    pub fn is_positive(&self) -> T::Mask {
        let [first, second, third] = self.inverse_pivots;
        let is_positive = inlined!(|pivot: T| (-pivot).below(0.0) & pivot.below(f64::INFINITY));
        is_positive(first) & is_positive(second) & is_positive(third)
    }
}

#[cfg(test)]
mod tests {
    use super::SymmetricFactors;

    #[test]
    fn exact_solution_of_a_symmetric_system_and_a_pivot_that_is_none() {
        // the right-hand side is the matrix times (1, 2, 3), computed by hand
        let factors = SymmetricFactors::new([4.0, 2.0, 5.0, 1.0, 3.0, 6.0]);
        let x: [f64; 3] = factors.solve([11.0, 21.0, 25.0]);
        for (x, expected) in x.iter().zip([1.0, 2.0, 3.0]) {
            assert!((x - expected).abs() < 1e-14);
        }
        assert!(factors.is_positive());
        assert!(!SymmetricFactors::new([1.0, 2.0, 1.0, 0.0, 0.0, 1.0]).is_positive());
    }
}
