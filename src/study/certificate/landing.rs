//! The landing as an implicit function, without its being looked for: the state at the fixed time T
//! of the landing, moved to the ground along the velocity there, has the derivatives that the
//! landing has.
//!
//! ```text
//!   height(T + dt, p + dp) = ground   ⇒   dt = −(∂height/∂p − ∂ground/∂p) dp / ẋ,   d carry = ∂z/∂p dp + ż dt
//! ```

use super::rows::{demand, in_few_steps};
use super::scale::{scale, size};
use crate::derivative::check::{Check, Ladder};
use crate::derivative::jacobian;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::flight::{Landed, trajectory};
use crate::impact::strike;
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::{Parameter, Setup};

/// The outcomes that the landing gives its derivative to.
pub(super) const AT_LANDING: [Outcome; 3] = [Outcome::Carry, Outcome::Lateral, Outcome::FlightTime];

/// The ground is put so far down, m, that every flight of a ladder is still in the air at T.
const WAY_DOWN: f64 = 2000.0;

/// A derivative at the landing beside differences at a fixed time.
#[derive(Clone, Debug)]
pub struct AtLanding {
    /// `carry`, `lateral` or `flight_time`.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The derivative beside differences of the state at the time of landing, moved to the ground.
    pub check: Check,
    /// What of the derivative is the landing's: the rest is the derivative at a fixed time.
    pub landing_term: f64,
}

/// The derivatives of a landing by each of some parameters. In a logarithmic wind, which counts its
/// height from the ground, there are none of them: the ground cannot be taken away from under the
/// ball.
///
/// # Errors
/// As [`jacobian`].
pub(super) fn at_landing(setup: &Setup<f64>, wrt: &[&'static Parameter]) -> Result<Vec<AtLanding>> {
    if setup.wind.roughness.is_some() || setup.ground.height - WAY_DOWN < -1e4 {
        return Ok(vec![]);
    }
    let (setup, landed) = ending_with_a_step(setup)?;
    let time = landed.flight_time;
    let exact = jacobian(&setup, &AT_LANDING, wrt)?;
    let drive = Drive::new(&setup)?;
    let judged = if drive.corners(&setup).is_empty() {
        Ladder::judge
    } else {
        Ladder::judge_on_a_corner
    };
    let sizes = AT_LANDING.map(|of| size(of, &setup, &drive));
    let mut all = vec![];
    for (k, parameter) in wrt.iter().enumerate() {
        let at = setup.value(parameter).unwrap_or_default();
        let moved = |value: f64| {
            let mut moved = setup;
            moved.set_value(parameter, Some(value)).ok()?;
            let ground = moved.ground.height;
            moved.ground.height -= WAY_DOWN;
            // no further than T
            moved.flight.time_limit = time - 0.5 * setup.flight.step;
            let launch = match Launch::given(&moved) {
                Some(launch) => launch,
                None => strike(&moved).ok()?.launch,
            };
            let path = trajectory(&moved, &launch).ok()?;
            Some(to_ground(
                path.points.last()?.position,
                landed.velocity,
                ground,
                time,
            ))
        };
        let sample = |steps| {
            Ladder::sample(at, scale(&setup, parameter), steps, &mut |value| {
                moved(value).map_or(vec![f64::NAN; 3], |outcomes| outcomes.to_vec())
            })
        };
        let judge = |(i, ladder): (usize, Ladder)| {
            judged(
                &ladder.rounded_as(sizes[i]),
                exact[i].gradient[k],
                demand(&setup),
            )
        };
        let per_time = [landed.velocity.z, landed.velocity.y, 1.0];
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

/// The setup with a step of which one ends at the landing, and that landing. Another step moves the
/// landing by its own error of truncation: the step is made anew until it does so by no more than
/// rounding, for away from the ground the differences are those of another place. The way there is
/// short, since the landing changes by a part of h^p only.
fn ending_with_a_step(setup: &Setup<f64>) -> Result<(Setup<f64>, Landed<f64>)> {
    /// Steps that are tried.
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

/// Carry, lateral and flight time of a ball that is here at a time, by the straight way to the
/// ground.
fn to_ground(position: Vector<f64>, velocity: Vector<f64>, ground: f64, time: f64) -> [f64; 3] {
    let more = -(position.x - ground) / velocity.x;
    [
        position.z + velocity.z * more,
        position.y + velocity.y * more,
        time + more,
    ]
}
