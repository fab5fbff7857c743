//! Counter-example: the flight loop of the report's listing, to demonstrate its failure. No result
//! of this library uses this loop.

use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::atmosphere::AirState;
use crate::error::{Error, Result};
use crate::impact::strike;
use crate::number::Vector;
use crate::parameters::Setup;
use std::f64::consts::PI;

/// Landing point of the report's flight loop.
#[derive(Clone, Copy, Debug)]
pub struct LoopLanding {
    /// Downrange position at the first step below the ground, m: the report's distance.
    pub overshot: f64,
    /// Downrange position interpolated linearly between the last two steps, m.
    pub interpolated: f64,
}

/// Integrates the flight in steps of `step` s until the height is negative, as in the listing. The
/// velocity has explicit Euler steps, because the listing's `ode45` integrates a constant. The
/// position moves with the new velocity.
///
/// # Errors
/// The errors of [`strike`]; [`Error::NoFlight`] if the ball is airborne at the time limit.
pub(in super::super) fn fly_past_the_ground(setup: &Setup<f64>, step: f64) -> Result<LoopLanding> {
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
                reason: format!("no landing: the loop still runs after {time} s").into(),
            });
        }
        let spin = spin_at_launch * (-setup.aero.spin_decay * time).exp();
        let speed = velocity.norm();
        let per_speed = 2.0 * air.density * setup.ball.radius / air.viscosity;
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
