use super::symmetric::Symmetric;
use clarabel::qdldl::{QDLDLFactorisation, QDLDLSettings};

/// The first shift, of the largest entry, and what it grows by until the matrix is positive definite.
const FIRST: f64 = 1e-8;
const GROWTH: f64 = 4.0;
/// So often at most: the last shift exceeds every eigenvalue.
const MOST: u32 = 40;
/// Rounding of a pivot, of the entry it came from.
const MARGIN: f64 = 1e-13;

/// A positive definite matrix: the Hessian itself, or else with about the least number added to its diagonal that makes it so (Nocedal &
/// Wright 2006, algorithm 3.3, with the signs of the pivots of LDLᵀ). `size` is that of a curvature where the Hessian has none.
pub(in crate::optimize) fn convex(hessian: &Symmetric, size: f64) -> (Symmetric, f64) {
    let (n, unit) = (hessian.size(), hessian.largest().max(size).max(f64::MIN_POSITIVE));
    let lowered =
        Symmetric::sum(n, hessian.entries().map(|(i, j, a)| (i, j, if i == j { a * (1.0 - MARGIN) } else { a })));
    // the order of elimination is found once
    let settings = QDLDLSettings { logical: true, regularize_enable: false, ..QDLDLSettings::default() };
    if let Ok(mut factors) = QDLDLFactorisation::new(lowered.upper(), Some(settings)) {
        let (diagonal, signs) = (lowered.diagonal(), vec![1; n]);
        let (mut shift, mut before) = (0.0, 0.0);
        for _ in 0..MOST {
            factors.offset_values(&diagonal, shift - before, &signs);
            if factors.refactor().is_ok() && factors.positive_inertia() == n {
                return (hessian.clone().shifted(shift), shift);
            }
            before = shift;
            shift = if shift == 0.0 { FIRST * unit } else { GROWTH * shift };
        }
    }
    // as many times the largest entry as there are rows is more than any eigenvalue
    let shift = 2.0 * n as f64 * unit;
    (hessian.clone().shifted(shift), shift)
}

#[cfg(test)]
mod tests {
    use super::{Symmetric, convex};

    #[test]
    fn exact_hessian_is_kept_where_convex() {
        let hessian = Symmetric::sum(2, [(0, 0, 2.0), (0, 1, 1.0), (1, 1, 2.0)]);
        let (kept, shift) = convex(&hessian, 1.0);
        assert_eq!((kept.upper(), shift), (hessian.upper(), 0.0));
    }

    #[test]
    fn closed_form_of_the_least_eigenvalue_bounds_the_shift() {
        // the second difference on 50 points less 1: its eigenvalues are 2 − 2 cos(kπ/51) − 1
        let entries = (0..50).flat_map(|i| [(i, i, 1.0), (i, (i + 1).min(49), if i < 49 { -1.0 } else { 0.0 })]);
        let least = 1.0 - 2.0 * (std::f64::consts::PI / 51.0).cos();
        let (_, shift) = convex(&Symmetric::sum(50, entries), 1.0);
        assert!(shift > -least && shift < -4.0 * least, "{shift} for {least}");
    }
}
