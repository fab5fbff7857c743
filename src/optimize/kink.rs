//! Corners: recognising one, and saying what is known of it.

use super::frame::{Frame, Point};
use super::problem::Evaluation;

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

/// Looks for a corner at a point: a variable whose slope jumps between two points 2·REACH apart by much more than
/// the curvature on either side accounts for.
pub(super) fn find(frame: &Frame, at: &Point, mut evaluate: impl FnMut(&[f64]) -> Option<Evaluation>) -> Option<Kink> {
    (0..at.x.len()).find_map(|i| {
        let mut side = |towards: f64| {
            let mut moved = at.x.clone();
            let to = at.x[i] + towards * REACH * frame.scale[i];
            moved[i] = to.clamp(frame.bounds.low[i], frame.bounds.high[i]);
            evaluate(&moved).map(|evaluation| (moved[i], evaluation))
        };
        let ((from, below), (to, above)) = (side(-1.0)?, side(1.0)?);
        let (slope_below, slope_above) = (below.gradient[i], above.gradient[i]);
        let jump = slope_above - slope_below;
        let is_unexplained = |side: &Evaluation| (side.hessian[i][i] * (to - from) - jump).abs() > 0.5 * jump.abs();
        let matters = jump.abs() * frame.scale[i] > 1e-6 * frame.phi;
        let is_corner = to > from && matters && is_unexplained(&below) && is_unexplained(&above);
        is_corner.then_some(Kink { variable: i, slope_below, slope_above })
    })
}

/// Whether a converged point may in truth be a smoothed corner: a curvature so high that the slope changes by
/// all of φ within a thousandth of the variable's scale.
pub(super) fn is_suspected(frame: &Frame, at: &Point) -> bool {
    let curvature = |i: usize| at.f.hessian[i][i].abs() * frame.scale[i] * frame.scale[i];
    (0..at.x.len()).any(|i| curvature(i) > 1e3 * frame.phi)
}
