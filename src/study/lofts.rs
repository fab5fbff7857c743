//! The carry and the total over loft and attack angle.

use super::Vary;
use super::plane::Plane;
use crate::derivative::Order;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::DEGREE;

/// Numbers of nodes: attack angles (across) and lofts (up).
const NODES: [usize; 2] = [5, 7];

/// Minimum steps of attack angle and loft, degrees.
const LEAST_STEPS: [f64; 2] = [2.0, 1.0];

/// The outcomes of [`lofts`], in order.
pub const LOFT_OUTCOMES: [Outcome; 2] = [Outcome::Carry, Outcome::Total];

/// The carry and the total at whole degrees of attack angle (across) and loft (up). The ranges
/// contain the values of both setups, of which the second usually is the optimum. All other
/// parameters are those of the first setup. `None` if the launch is given, or if no drive flies.
///
/// # Errors
/// The errors of [`Batch::new`](crate::batch::Batch::new).
pub fn lofts(setup: &Setup<f64>, other: &Setup<f64>) -> Result<Option<Plane>> {
    if setup.launch.is_given() {
        return Ok(None);
    }
    let vary = |name: &str, axis: usize| -> Result<Vary> {
        let parameter = setup.variable(name)?;
        let values = [setup, other].map(|setup| setup.value(parameter).unwrap_or_default());
        Ok(range_around(
            parameter,
            values,
            NODES[axis],
            LEAST_STEPS[axis],
        ))
    };
    let (across, up) = (vary("swing.attack_angle", 0)?, vary("club.loft", 1)?);
    let plane = Plane::fly(setup, &LOFT_OUTCOMES, across, up, NODES, Order::Value)?;
    let flies = plane.values[0].iter().any(Option::is_some);
    Ok(Some(plane).filter(|_| flies))
}

/// A range of `count` values in equal steps, which contains the two `values` (rad). The step is a
/// multiple of `least` degrees, as small as possible. The range may exceed the range of the
/// parameter; drives beyond it have no outcomes.
fn range_around(parameter: &'static Parameter, values: [f64; 2], count: usize, least: f64) -> Vary {
    let [low, high] = [f64::min, f64::max].map(|end| end(values[0], values[1]) / DEGREE);
    let steps = (count - 1) as f64;
    let start = |step: f64| step * ((0.5 * (low + high) / step).round() - (0.5 * steps).floor());
    let mut step = least;
    while start(step) > low || start(step) + steps * step < high {
        step += least;
    }
    let start = start(step);
    Vary {
        parameter,
        low: start * DEGREE,
        high: (start + steps * step) * DEGREE,
    }
}
