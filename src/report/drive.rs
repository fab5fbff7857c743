use super::{json, table::table};
use crate::drive::{Drive, Outcome};
use crate::flight::Flight;
use crate::impact::Grip;
use crate::number::Vector;
use crate::parameters::Setup;
use crate::units::{Quantity, significant};
use serde_json::{Value, json};

const LAUNCH: [Outcome; 8] = [
    Outcome::BallSpeed,
    Outcome::LaunchAngle,
    Outcome::LaunchDirection,
    Outcome::Spin,
    Outcome::Backspin,
    Outcome::Sidespin,
    Outcome::SpinAxis,
    Outcome::SmashFactor,
];

const FLIGHT: [Outcome; 8] = [
    Outcome::Carry,
    Outcome::Lateral,
    Outcome::FlightTime,
    Outcome::ApexHeight,
    Outcome::ApexTime,
    Outcome::ApexDownrange,
    Outcome::DescentAngle,
    Outcome::LandingSpeed,
];

/// A drive as JSON, SI and radians.
pub fn drive_json(setup: &Setup<f64>, drive: &Drive<f64>, warnings: &[String]) -> Value {
    let outcomes = |all: &[Outcome]| json::named(all.iter().map(|outcome| (outcome.name(), outcome.value(drive))));
    let mut launch = outcomes(&LAUNCH);
    launch["velocity"] = json::vector(drive.impact.launch.velocity);
    launch["spin_vector"] = json::vector(drive.impact.launch.spin);
    let (status, reason, flight) = match &drive.flight {
        Flight::Landed(_) => ("landed", Value::Null, outcomes(&FLIGHT)),
        Flight::None(why) => (why.status(), json!(why.to_string()), Value::Null),
    };
    json!({
        "setup": json::setup(setup),
        "status": status,
        "message": reason,
        "launch": launch,
        "club_after": {
            "velocity": json::vector(drive.impact.club_velocity),
            "angular_velocity": json::vector(drive.impact.club_spin),
        },
        "slipped": matches!(drive.impact.grip, Grip::Slips(_)),
        "flight": flight,
        "warnings": warnings,
    })
}

/// A drive as text: what a launch monitor shows, and the flight.
pub fn drive_text(drive: &Drive<f64>) -> String {
    let row = |outcome: &Outcome| {
        let value = outcome.value(drive);
        vec![
            outcome.name().replace('_', " "),
            value.map_or("–".into(), |v| readable(*outcome, v)),
            value.map_or("–".into(), |v| si(*outcome, v)),
        ]
    };
    let launch = table(&["launch", "", "SI"], &[1, 2], LAUNCH.iter().map(row));
    let slipped = if matches!(drive.impact.grip, Grip::Slips(_)) { "  the ball slipped on the face\n" } else { "" };
    let bodies = format!(
        "  ball {}\n  club after impact {}\n{slipped}",
        components(drive.impact.launch.velocity),
        components(drive.impact.club_velocity)
    );
    match &drive.flight {
        Flight::Landed(_) => {
            format!("{launch}\n{bodies}\n{}", table(&["flight", "", "SI"], &[1, 2], FLIGHT.iter().map(row)))
        }
        Flight::None(why) => format!("{launch}\n{bodies}\nno flight: {why}\n"),
    }
}

/// A velocity: "139.20 mph downrange, 19.85 up, 0.00 right".
fn components(velocity: Vector<f64>) -> String {
    let mph = Quantity::SPEED.size_of("mph").unwrap_or(1.0);
    let [up, right, downrange] = velocity.to_array().map(|component| component / mph + 0.0);
    format!("{downrange:.2} mph downrange, {up:.2} up, {right:.2} right")
}

/// An outcome in the unit people read, to five digits.
pub(super) fn readable(outcome: Outcome, value: f64) -> String {
    let size = outcome.quantity().size_of(outcome.unit()).unwrap_or(1.0);
    format!("{} {}", significant(value / size, 5), outcome.unit()).trim_end().to_owned()
}

fn si(outcome: Outcome, value: f64) -> String {
    format!("{} {}", significant(value, 7), outcome.quantity().si).trim_end().to_owned()
}
