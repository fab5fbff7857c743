//! Corners: recognising one, and saying what is known of it.

use super::frame::{Frame, Point};
use super::problem::Evaluation;
use serde::{Deserialize, Serialize};

/// A corner of the objective along one variable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kink {
    /// The variable's index.
    pub variable: usize,
    /// The slope just below the corner; `None` where that is outside the bounds.
    pub slope_below: Option<f64>,
    /// The slope just above it; `None` where that is outside the bounds.
    pub slope_above: Option<f64>,
}

impl Kink {
    /// The slope inside, where the corner lies on a bound that the objective falls towards; and whether that is the
    /// lower one.
    pub(super) fn slope_towards_bound(&self) -> Option<(f64, bool)> {
        match (self.slope_below, self.slope_above) {
            (None, Some(above)) if above > 0.0 => Some((above, true)),
            (Some(below), None) if below < 0.0 => Some((-below, false)),
            _ => None,
        }
    }
}

/// Half the distance between the points compared, in units of the variables' scale.
const REACH: f64 = 1e-6;

/// Looks for a corner at a point: a variable whose slope jumps between two points 2·REACH apart by much more than
/// the curvature on either side accounts for.
pub(super) fn find(frame: &Frame, at: &Point, mut evaluate: impl FnMut(&[f64]) -> Option<Evaluation>) -> Option<Kink> {
    let bounds = &frame.domain.variables;
    (0..at.x.len()).filter(|&i| !bounds.is_fixed(i)).find_map(|i| {
        let mut side = |towards: f64| {
            let mut moved = at.x.clone();
            let to = at.x[i] + towards * REACH * frame.scale[i];
            moved[i] = to.clamp(bounds.low[i], bounds.high[i]);
            evaluate(&moved).map(|f| (moved[i], f.objective, moved[i] == to))
        };
        let ((from, below, is_below_inside), (to, above, is_above_inside)) = (side(-1.0)?, side(1.0)?);
        if below.hessian.is_empty() || above.hessian.is_empty() {
            return None;
        }
        let jump = above.gradient[i] - below.gradient[i];
        let is_unexplained = |bend: f64| (bend * (to - from) - jump).abs() > 0.5 * jump.abs();
        let matters = jump.abs() * frame.scale[i] > 1e-6 * frame.size(at);
        // on a bound the one side is the rounded tip of the corner itself, whose curvature may account for anything
        let is_sharp = (is_unexplained(below.hessian[i][i]) || !is_below_inside)
            && (is_unexplained(above.hessian[i][i]) || !is_above_inside)
            && (is_below_inside || is_above_inside);
        (to > from && matters && is_sharp).then_some(Kink {
            variable: i,
            slope_below: is_below_inside.then_some(below.gradient[i]),
            slope_above: is_above_inside.then_some(above.gradient[i]),
        })
    })
}

/// Whether a converged point may in truth be a smoothed corner: a curvature so high that the slope changes by
/// all of φ within a thousandth of the variable's scale.
pub(super) fn is_suspected(frame: &Frame, at: &Point) -> bool {
    let hessian = &at.f.objective.hessian;
    let curvature = |i: usize| hessian[i][i].abs() * frame.scale[i] * frame.scale[i];
    (0..hessian.len()).any(|i| curvature(i) > 1e3 * frame.size(at))
}
