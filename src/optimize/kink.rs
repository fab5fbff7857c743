//! Corners: recognising one, and saying what is known of it.

use super::problem::{Bounds, Evaluation, Problem};

/// A corner of a function along one variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kink {
    /// The variable's index.
    pub variable: usize,
    /// The slope just below the corner.
    pub slope_below: f64,
    /// The slope just above it.
    pub slope_above: f64,
}

/// Half the distance between the points compared, in units of the variables' scale.
const REACH: f64 = 1e-6;

/// Looks for a corner at `x`: a variable whose slope jumps between two points 2·REACH apart by much more than
/// the curvature on either side accounts for.
pub(super) fn find(problem: &impl Problem, bounds: &Bounds, x: &[f64], phi: f64) -> Option<Kink> {
    let scale = bounds.scale(x);
    let defined = |x: &[f64]| problem.evaluate(x).ok().filter(Evaluation::is_finite);
    (0..x.len()).find_map(|i| {
        let side = |towards: f64| {
            let mut moved = x.to_vec();
            moved[i] = (x[i] + towards * REACH * scale[i]).clamp(bounds.low[i], bounds.high[i]);
            defined(&moved).map(|evaluation| (moved[i], evaluation))
        };
        let ((from, below), (to, above)) = (side(-1.0)?, side(1.0)?);
        let jump = above.gradient[i] - below.gradient[i];
        let smooth = [&below, &above].map(|side| (side.hessian[i][i] * (to - from) - jump).abs());
        let unexplained = smooth[0].min(smooth[1]) > 0.5 * jump.abs();
        let matters = jump.abs() * scale[i] > 1e-6 * phi;
        (to > from && unexplained && matters).then(|| Kink {
            variable: i,
            slope_below: below.gradient[i],
            slope_above: above.gradient[i],
        })
    })
}

/// Whether a converged point may in truth be a smoothed corner: a curvature so high that the slope changes by
/// all of φ within a thousandth of the variable's scale.
pub(super) fn is_suspected(evaluation: &Evaluation, scale: &[f64], phi: f64) -> bool {
    (0..scale.len()).any(|i| evaluation.hessian[i][i].abs() * scale[i] * scale[i] > 1e3 * phi)
}
