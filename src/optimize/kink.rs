//! Detection of kinks (corners of the objective).

use super::problem::Evaluation;
use super::scaling::{EvaluatedPoint, Scaling};
use argmin::core::Error;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A kink of the objective along one variable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kink {
    /// Index of the variable.
    pub variable: usize,
    /// Derivative just below the kink; `None` if the kink lies on the lower bound.
    pub slope_below: Option<f64>,
    /// Derivative just above the kink; `None` if the kink lies on the upper bound.
    pub slope_above: Option<f64>,
}

impl Kink {
    /// True if the kink lies between the bounds of the variable.
    pub fn is_between_bounds(self) -> bool {
        self.slope_below.is_some() && self.slope_above.is_some()
    }
}

/// The one-sided derivatives: "-1.5 below and 2 above".
impl fmt::Display for Kink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = |slope: Option<f64>| {
            slope.map_or("unknown (out of bounds)".into(), |slope| {
                format!("{slope:.6}")
            })
        };
        let [below, above] = [self.slope_below, self.slope_above].map(side);
        write!(f, "{below} below and {above} above")
    }
}

/// Distance from the tested point to each of the two compared points, in units of the variables'
/// scale.
const REACH: f64 = 1e-6;

/// Looks for a kink at a point. A variable has a kink if the derivative by this variable changes,
/// between two points 2·REACH apart, by much more than the curvature on either side explains.
/// `evaluate` returns `None` where the functions are undefined. A variable is not tested if the
/// functions are undefined at one of its two points.
pub(super) fn find(
    scaling: &Scaling,
    at: &EvaluatedPoint,
    mut evaluate: impl FnMut(&[f64]) -> Result<Option<Evaluation>, Error>,
) -> Result<Option<Kink>, Error> {
    let bounds = &scaling.domain.variables;
    for i in (0..at.x.len()).filter(|&i| !bounds.is_fixed(i)) {
        let mut side = |towards: f64| -> Result<Option<KinkSide>, Error> {
            let mut moved = at.x.clone();
            let to = at.x[i] + towards * REACH * scaling.scale[i];
            moved[i] = to.clamp(bounds.low[i], bounds.high[i]);
            let objective = evaluate(&moved)?.map(|f| f.objective);
            Ok(objective.map(|f| KinkSide {
                x: moved[i],
                slope: f.gradient[i],
                hessian: f.hessian,
                is_inside: moved[i] == to,
            }))
        };
        let (Some(below), Some(above)) = (side(-1.0)?, side(1.0)?) else {
            continue;
        };
        if is_kink(scaling, at, i, &below, &above) {
            let slope = |side: &KinkSide| side.is_inside.then_some(side.slope);
            return Ok(Some(Kink {
                variable: i,
                slope_below: slope(&below),
                slope_above: slope(&above),
            }));
        }
    }
    Ok(None)
}

/// The derivatives of the objective at a distance [`REACH`] from a point, on one side.
struct KinkSide {
    x: f64,
    slope: f64,
    hessian: Vec<Vec<f64>>,
    /// False if a bound limited the displacement.
    is_inside: bool,
}

fn is_kink(
    scaling: &Scaling,
    at: &EvaluatedPoint,
    i: usize,
    below: &KinkSide,
    above: &KinkSide,
) -> bool {
    if below.hessian.is_empty() || above.hessian.is_empty() {
        return false;
    }
    let (distance, jump) = (above.x - below.x, above.slope - below.slope);
    let is_significant = jump.abs() * scaling.scale[i] > 1e-6 * scaling.size(at);
    // a bound leaves one of the two points on the rounded tip of the kink, where the curvature
    // could explain any change: do not test this point
    let is_unexplained = |side: &KinkSide| {
        !side.is_inside || (side.hessian[i][i] * distance - jump).abs() > 0.5 * jump.abs()
    };
    let has_inner_side = below.is_inside || above.is_inside;
    distance > 0.0
        && is_significant
        && has_inner_side
        && is_unexplained(below)
        && is_unexplained(above)
}

/// True if a converged point may be a smoothed kink: in scaled variables, a second derivative of
/// the objective is more than 1000 times the objective's size.
pub(super) fn is_suspected(scaling: &Scaling, at: &EvaluatedPoint) -> bool {
    let hessian = &at.f.objective.hessian;
    let curvature = |i: usize| hessian[i][i].abs() * scaling.scale[i] * scaling.scale[i];
    (0..hessian.len()).any(|i| curvature(i) > 1e3 * scaling.size(at))
}
