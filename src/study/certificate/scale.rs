use crate::drive::{Drive, Outcome};
use crate::flight::Flight;
use crate::parameters::{Parameter, Setup};
use crate::units::{DisplayUnit, Quantity};

/// Characteristic size of a parameter, SI, which scales the steps of differences. It is the
/// magnitude of the value. If the value is 0, or if the parameter may be negative, it is at least a
/// typical size.
pub(super) fn scale(setup: &Setup<f64>, parameter: &Parameter) -> f64 {
    let value = setup.value(parameter).unwrap_or_default().abs();
    let default = parameter
        .default_value()
        .filter(|default| default.is_finite())
        .unwrap_or_default()
        .abs();
    let usual = if default > 0.0 {
        default
    } else {
        usual(parameter)
    };
    let has_a_sign = parameter.range.low < 0.0;
    if value == 0.0 || has_a_sign {
        value.max(usual)
    } else {
        value
    }
}

/// Typical size of parameters with default 0, SI.
fn usual(parameter: &Parameter) -> f64 {
    let units = match (parameter.name, parameter.unit) {
        // a published value; a thousandth of it already changes a flight
        ("aero.spin_damping", _) => 2e-5,
        ("air.altitude", _) => 1000.0,
        (_, "deg") => 5.0,
        (_, "mm" | "rad/s") => 10.0,
        (_, "g cm^2" | "rpm") => 1000.0,
        (_, "") => 0.1,
        _ => 1.0,
    };
    units * DisplayUnit::from(parameter).size()
}

/// Magnitude of the terms from which an outcome is computed, SI. The rounding error of the outcome
/// is relative to this magnitude. It is the outcome's absolute value, but at least:
///
/// - length: the distance to the landing point;
/// - time: the flight time;
/// - speed: the ball speed;
/// - angular velocity: the spin, and after an impact also m R v/I with mass m, radius R, speed v
///   and moment of inertia I of the ball;
/// - angle or number: 1.
pub(super) fn size_of_terms(of: Outcome, setup: &Setup<f64>, drive: &Drive<f64>) -> f64 {
    let launch = &drive.launch;
    let made_of = match (&drive.flight, of.quantity()) {
        (Flight::Landed(landed), Quantity::LENGTH) => landed.carry.hypot(landed.lateral),
        (Flight::Landed(landed), Quantity::TIME) => landed.flight_time,
        (_, Quantity::SPEED) => launch.ball_speed(),
        (_, Quantity::ANGULAR_VELOCITY) => {
            let ball = &setup.ball;
            let per_speed = ball.inertia.map_or(2.5 / ball.radius, |inertia| {
                ball.mass * ball.radius / inertia
            });
            let turned = if drive.impact.is_some() {
                launch.ball_speed() * per_speed
            } else {
                0.0
            };
            launch.total_spin().max(turned)
        }
        (_, Quantity::ANGLE | Quantity::NUMBER) => 1.0,
        _ => 0.0,
    };
    of.value(drive).unwrap_or_default().abs().max(made_of)
}
