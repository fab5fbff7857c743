//! Corners: recognising one, and saying what is known of it.

use super::problem::Evaluation;
use super::scaling::{Point, Scaling};
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
    /// The slope inside, where the corner lies on a bound that the objective falls towards; and
    /// whether that is the lower one.
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

/// Looks for a corner at a point: a variable whose slope jumps between two points 2·REACH apart by
/// much more than the curvature on either side accounts for. `evaluate` gives `None` where the
/// functions are not defined.
pub(super) fn find<E>(
    scaling: &Scaling,
    at: &Point,
    mut evaluate: impl FnMut(&[f64]) -> Result<Option<Evaluation>, E>,
) -> Result<Option<Kink>, E> {
    let bounds = &scaling.domain.variables;
    for i in (0..at.x.len()).filter(|&i| !bounds.is_fixed(i)) {
        let mut side = |towards: f64| {
            let mut moved = at.x.clone();
            let to = at.x[i] + towards * REACH * scaling.scale[i];
            moved[i] = to.clamp(bounds.low[i], bounds.high[i]);
            let objective = evaluate(&moved)?.map(|f| f.objective);
            Ok(objective.map(|f| Side {
                x: moved[i],
                slope: f.gradient[i],
                hessian: f.hessian,
                is_inside: moved[i] == to,
            }))
        };
        let (Some(below), Some(above)) = (side(-1.0)?, side(1.0)?) else {
            return Ok(None);
        };
        if is_corner(scaling, at, i, &below, &above) {
            let slope = |side: &Side| side.is_inside.then_some(side.slope);
            return Ok(Some(Kink {
                variable: i,
                slope_below: slope(&below),
                slope_above: slope(&above),
            }));
        }
    }
    Ok(None)
}

/// The objective a little to one side of a point.
struct Side {
    x: f64,
    slope: f64,
    hessian: Vec<Vec<f64>>,
    /// Whether it is where it was meant to be; on a bound it is not.
    is_inside: bool,
}

fn is_corner(scaling: &Scaling, at: &Point, i: usize, below: &Side, above: &Side) -> bool {
    if below.hessian.is_empty() || above.hessian.is_empty() {
        return false;
    }
    let (apart, jump) = (above.x - below.x, above.slope - below.slope);
    let matters = jump.abs() * scaling.scale[i] > 1e-6 * scaling.size(at);
    // on a bound the one side is the rounded tip of the corner itself, whose curvature may account
    // for anything
    let is_unexplained = |side: &Side| {
        !side.is_inside || (side.hessian[i][i] * apart - jump).abs() > 0.5 * jump.abs()
    };
    let is_seen = below.is_inside || above.is_inside;
    apart > 0.0 && matters && is_seen && is_unexplained(below) && is_unexplained(above)
}

/// Whether a converged point may in truth be a smoothed corner: a curvature so high that the slope
/// changes by all of φ within a thousandth of the variable's scale.
pub(super) fn is_suspected(scaling: &Scaling, at: &Point) -> bool {
    let hessian = &at.f.objective.hessian;
    let curvature = |i: usize| hessian[i][i].abs() * scaling.scale[i] * scaling.scale[i];
    (0..hessian.len()).any(|i| curvature(i) > 1e3 * scaling.size(at))
}
