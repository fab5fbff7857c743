//! Counter-example: the flight loop of the report's listing, to demonstrate its failure. No result
//! of this library uses this loop.

use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::atmosphere::{AirState, in_effect};
use crate::derivative::check::{Check, Curve, Demand, Ladder, STEP_EXPONENTS};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::impact::strike;
use crate::json::number;
use crate::number::Vector;
use crate::parameters::{Parameter, Setup};
use crate::study::certificate::DerivativeRow;
use serde::Serialize;
use std::f64::consts::PI;

/// Landing point of the report's flight loop.
#[derive(Clone, Copy, Debug)]
pub struct LoopLanding {
    /// Downrange position at the first step below the ground, m: the report's distance.
    pub overshot: f64,
    /// Downrange position interpolated linearly between the last two steps, m.
    pub interpolated: f64,
}

/// Integrates the flight in steps of `step`, s, until the height is negative, as the listing does.
/// The listing's `ode45` integrates a constant acceleration within a step, which is an explicit
/// Euler step of the velocity. The position moves with the new velocity.
///
/// # Errors
/// The errors of [`strike`], and [`Error::NoFlight`] if the ball is still airborne at the time
/// limit.
pub(super) fn fly_past_the_ground(setup: &Setup<f64>, step: f64) -> Result<LoopLanding> {
    let launch = strike(setup)?.launch;
    let air = AirState::of(&setup.air);
    let area = PI * setup.ball.radius * setup.ball.radius;
    let (spin_at_launch, mut velocity) = (launch.total_spin(), launch.velocity);
    let axis = if spin_at_launch > 0.0 {
        launch.spin * (1.0 / spin_at_launch)
    } else {
        launch.spin
    };
    let (mut before, mut here, mut steps) = (Vector::zero(), Vector::zero(), 0_u32);
    while here.x >= 0.0 {
        let time = step * f64::from(steps);
        if time > setup.flight.time_limit {
            return Err(Error::NoFlight {
                status: "aloft",
                reason: format!("no landing: the loop still runs after {time} s").into(),
            });
        }
        let spin = spin_at_launch * (-setup.aero.spin_decay * time).exp();
        let speed = velocity.norm();
        let per_speed = air.reynolds_per_speed(setup.ball.radius);
        let coefficients =
            setup
                .law
                .coefficients(Stream::new(spin, speed, setup.ball.radius, per_speed));
        let pressure = 0.5 * air.density * area * speed / setup.ball.mass;
        let pull = axis.cross(velocity) * coefficients.lift - velocity * coefficients.drag;
        let weight = Vector::new(setup.flight.gravity, 0.0, 0.0);
        velocity = velocity + (pull * pressure - weight) * step;
        before = here;
        here = here + velocity * step;
        steps += 1;
    }
    let part = before.x / (before.x - here.x);
    Ok(LoopLanding {
        overshot: here.z,
        interpolated: before.z + part * (here.z - before.z),
    })
}

/// A finite difference of the carry that the while-loop of the MAE 494 report computes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LoopCheck"))]
pub struct LoopRow {
    /// The comparison of finite differences with the exact derivative.
    #[serde(flatten)]
    pub check: Check,
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The finite difference, SI, whose step is nearest to 1e-8 times the characteristic size of
    /// the parameter.
    // optimizers use steps of this size
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub difference: Option<f64>,
    /// True if `difference` and the exact derivative have different signs.
    #[serde(rename = "sign_is_wrong")]
    pub has_wrong_sign: bool,
    /// The errors of the finite differences at several steps.
    pub curve: Curve,
}

impl LoopRow {
    /// The row of a check. `scale` is the characteristic size of the parameter; the steps of the
    /// check are multiples of it.
    fn new(parameter: &'static Parameter, scale: f64, check: Check) -> Self {
        let distance = |step: f64| (step / scale / 1e-8).ln().abs();
        let nearest = check
            .curve
            .iter()
            .min_by(|a, b| distance(a.step).total_cmp(&distance(b.step)));
        let difference = nearest.map(|point| point.difference);
        Self {
            parameter,
            difference,
            has_wrong_sign: difference.is_some_and(|difference| difference * check.exact < 0.0),
            curve: Curve::of(&check.curve),
            check,
        }
    }
}

/// Allowed range of the loop's time step, s. A shorter step takes too long; a longer step gives too
/// few points of the flight.
const LOOP_STEPS: [f64; 2] = [1e-4, 1.0];

/// True for a setup that the report's loop models: a launch computed from a swing, no wind, no spin
/// damping, and a ground at the height of the tee.
fn is_modelled(setup: &Setup<f64>) -> bool {
    let wind = in_effect(setup).wind;
    let is_calm = [wind.up, wind.right, wind.downrange] == [0.0; 3];
    !setup.launch.is_given()
        && is_calm
        && setup.aero.spin_damping.is_none()
        && setup.ground.height == 0.0
}

/// The landing of the report's loop in steps of `step` s.
///
/// ```
/// use longdrive::{Setup, reproduce::loop_landing};
/// let landing = loop_landing(&Setup::preset("mae494").unwrap(), 0.01).unwrap();
/// // the exact carry is 114.313 m; the loop ends at the first step below the ground
/// assert!(landing.overshot > landing.interpolated && landing.overshot < 116.0);
/// ```
///
/// # Errors
/// - [`Error::OutOfRange`] if `step` is outside 0.0001 s to 1 s
/// - [`Error::Undefined`] if the setup has something that the loop does not model: a stated launch,
///   wind, spin damping, or a ground that is not level with the tee
/// - [`Error::NoFlight`] if the ball does not land before the time limit
/// - errors of [`Setup::validate`] and of [`strike`](crate::impact::strike)
pub fn loop_landing(setup: &Setup<f64>, step: f64) -> Result<LoopLanding> {
    let [least, most] = LOOP_STEPS;
    if !(least..=most).contains(&step) {
        return Err(Error::OutOfRange {
            name: "the step of the loop".into(),
            si: step,
            value: format!("{step} s"),
            range: format!("{least} s .. {most} s"),
            advice: "the report's step is 0.01 s".into(),
        });
    }
    if !is_modelled(setup) {
        return Err(Error::Undefined {
            what: "the while-loop".into(),
            reason: "it models a swing without wind and spin damping, on ground level with the \
                     tee; reset wind.*, aero.spin_damping and ground.height"
                .into(),
        });
    }
    setup.validate()?;
    fly_past_the_ground(setup, step)
}

/// Compares finite differences of the report's loop with the derivatives of carry in `rows`.
/// Derivatives by wind and by the height of the ground are omitted, because the loop models
/// neither. Empty if the loop does not model the setup: a stated launch, wind, spin damping, or a
/// ground that is not level with the tee.
pub fn while_loop(setup: &Setup<f64>, rows: &[DerivativeRow]) -> Vec<LoopRow> {
    if !is_modelled(setup) {
        return vec![];
    }
    let known = |row: &&DerivativeRow| {
        row.of == Outcome::Carry
            && !row.parameter.name.starts_with("wind")
            && row.parameter.name != "ground.height"
    };
    rows.iter()
        .filter(known)
        .filter_map(|row| {
            let (parameter, scale) = (row.parameter, row.ladder.scale);
            let mut carry = |x: f64| {
                let mut moved = *setup;
                let flown = moved
                    .set_value(parameter, Some(x))
                    .and_then(|()| moved.validate())
                    .and_then(|()| fly_past_the_ground(&moved, setup.flight.step));
                vec![flown.map_or(f64::NAN, |stop| stop.overshot)]
            };
            let ladder =
                Ladder::sample(setup.value(parameter)?, scale, STEP_EXPONENTS, &mut carry).pop()?;
            let check = ladder.judge(row.first.exact, Demand::FIRST);
            Some(LoopRow::new(parameter, scale, check))
        })
        .collect()
}
