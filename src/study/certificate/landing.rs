//! Implicit function test of the landing: the state at the fixed time T of the landing,
//! extrapolated to the ground along its velocity, has the same derivatives as the landing itself.
//! In the equations x is the height, z the downrange distance, and p a parameter.
//! ```text
//!   height(T + dt, p + dp) = ground   ⇒   dt = −(∂height/∂p − ∂ground/∂p) dp / ẋ,
//!                                         d carry = ∂z/∂p dp + ż dt
//! ```

use super::rows::{demand, in_few_steps};
use super::scale::{scale, size_of_terms};
use crate::derivative::check::{Check, Ladder};
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::flight::{Landed, trajectory};
use crate::impact::strike;
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::{Parameter, Setup};
use serde::Serialize;

/// Outcomes whose derivative contains a landing term.
pub(super) const AT_LANDING: [Outcome; 3] = [Outcome::Carry, Outcome::Lateral, Outcome::FlightTime];

/// Derivatives of the outcomes [`AT_LANDING`] by the landing time, from the velocity at landing.
pub(super) fn changes_per_time(velocity: Vector<f64>) -> [f64; 3] {
    [velocity.z, velocity.y, 1.0]
}

/// Depth to which the ground is lowered, m, so that all sampled flights are airborne at the landing
/// time T.
const LOWERED_BY: f64 = 2000.0;

/// A derivative at the landing compared with finite differences at a fixed time.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LandingCheck"))]
pub struct AtLanding {
    /// The comparison.
    #[serde(flatten)]
    pub check: Check,
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The contribution of the landing time to the derivative, SI.
    #[serde(serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub landing_term: f64,
}

/// Tests the derivatives of a landing by each parameter. Empty if the ground cannot be lowered.
/// There are two such cases: the wind is logarithmic, so that it depends on the height above
/// ground, or the lowered ground is outside the range of `ground.height`.
///
/// # Errors
/// The errors of [`evaluate`].
pub(super) fn at_landing(setup: &Setup<f64>, wrt: &[&'static Parameter]) -> Result<Vec<AtLanding>> {
    let mut lowered = *setup;
    lowered.ground.height -= LOWERED_BY;
    if setup.wind.roughness.is_some() || lowered.validate().is_err() {
        return Ok(vec![]);
    }
    let (setup, landed) = ending_with_a_step(setup)?;
    let exact = evaluate(&setup, &AT_LANDING, wrt, Order::First)?;
    let drive = Drive::new(&setup)?;
    let judged = if drive.corners(&setup).is_empty() {
        Ladder::judge
    } else {
        Ladder::judge_on_a_corner
    };
    let sizes = AT_LANDING.map(|of| size_of_terms(of, &setup, &drive));
    let mut all = vec![];
    for (k, parameter) in wrt.iter().enumerate() {
        let at = setup.value(parameter).unwrap_or_default();
        let sample = |steps| {
            Ladder::sample(at, scale(&setup, parameter), steps, &mut |value| {
                extrapolated_landing(&setup, &landed, parameter, value)
                    .map_or(vec![f64::NAN; 3], |outcomes| outcomes.to_vec())
            })
        };
        let judge = |(i, ladder): (usize, Ladder)| {
            judged(
                &ladder.with_rounding_size(sizes[i]),
                exact[i].gradient[k],
                demand(&setup),
            )
        };
        let per_time = changes_per_time(landed.velocity);
        for (i, check) in in_few_steps(sample, judge, Check::failed)
            .into_iter()
            .enumerate()
        {
            let landing_term = per_time[i] * exact[2].gradient[k];
            all.push(AtLanding {
                of: AT_LANDING[i],
                parameter,
                check,
                landing_term,
            });
        }
    }
    Ok(all)
}

/// Adjusts the time step so that a step ends at the landing. Returns the setup with this step, and
/// its landing. A change of the step shifts the landing by the truncation error, so the adjustment
/// is repeated until the landing time no longer changes.
fn ending_with_a_step(setup: &Setup<f64>) -> Result<(Setup<f64>, Landed<f64>)> {
    const TRIALS: usize = 16;
    let mut setup = *setup;
    let mut landed = *Drive::new(&setup)?.landed()?;
    let steps = (landed.flight_time / setup.flight.step).ceil();
    for _ in 0..TRIALS {
        let time = landed.flight_time;
        setup.flight.step = time / steps;
        landed = *Drive::new(&setup)?.landed()?;
        if (landed.flight_time - time).abs() <= 2.0 * f64::EPSILON * time {
            break;
        }
    }
    Ok((setup, landed))
}

/// Carry, lateral and flight time with the parameter at `value`. The position at the time of
/// `landed` is extrapolated to the ground along the velocity of `landed`. `None` without a flight.
fn extrapolated_landing(
    setup: &Setup<f64>,
    landed: &Landed<f64>,
    parameter: &Parameter,
    value: f64,
) -> Option<[f64; 3]> {
    let time = landed.flight_time;
    let mut moved = *setup;
    moved.set_value(parameter, Some(value)).ok()?;
    let ground = moved.ground.height;
    moved.ground.height -= LOWERED_BY;
    // the flight ends with the first step beyond this limit, which is the step that ends at `time`
    moved.flight.time_limit = time - 0.5 * setup.flight.step;
    let launch = match Launch::given(&moved) {
        Some(launch) => launch,
        None => strike(&moved).ok()?.launch,
    };
    let path = trajectory(&moved, &launch).ok()?;
    let position = path.points.last()?.position;
    let velocity = landed.velocity;
    let more = -(position.x - ground) / velocity.x;
    Some([
        position.z + velocity.z * more,
        position.y + velocity.y * more,
        time + more,
    ])
}
