use super::{Reply, json, table::table};
use crate::drive::{Drive, Outcome, Part};
use crate::flight::Flight;
use crate::impact::{Grip, Impact};
use crate::number::Vector;
use crate::parameters::Setup;
use crate::units::{Quantity, significant};
use serde::Serialize;
use serde_json::{Map, Value};

/// A drive as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct DriveReport {
    /// Every parameter by its dotted name, and `aero.law`.
    pub setup: Map<String, Value>,
    /// The outcomes of the launch, with the vectors `velocity` and `spin_vector`.
    pub launch: Map<String, Value>,
    /// The head after impact: `velocity` and `angular_velocity`.
    pub club_after: Map<String, Value>,
    /// Whether the ball still slid on the face as it left.
    pub slipped: bool,
    /// The outcomes of the flight.
    pub flight: Option<Map<String, Value>>,
}

impl DriveReport {
    /// The answer of `simulate`: the status is `landed`, `no-flight` or `aloft`, the message why there is no landing.
    pub fn reply(setup: &Setup<f64>, drive: &Drive<f64>, warnings: Vec<String>) -> Reply<Self> {
        let (status, message) = match &drive.flight {
            Flight::Landed(_) => ("landed", None),
            Flight::None(why) => (why.status(), Some(why.to_string())),
        };
        Reply::done("simulate", warnings, Self::new(setup, drive)).ended(status, message)
    }

    /// The report of a drive.
    pub fn new(setup: &Setup<f64>, drive: &Drive<f64>) -> Self {
        let Impact { club_velocity, club_spin, grip, .. } = &drive.impact;
        Self {
            setup: json::setup(setup),
            launch: launch(drive),
            club_after: vectors([("velocity", *club_velocity), ("angular_velocity", *club_spin)]).collect(),
            slipped: matches!(grip, Grip::Slips(_)),
            flight: flight(drive),
        }
    }
}

/// The outcomes of the launch, with the vectors `velocity` and `spin_vector`.
pub(super) fn launch(drive: &Drive<f64>) -> Map<String, Value> {
    let launch = &drive.impact.launch;
    let vectors = vectors([("velocity", launch.velocity), ("spin_vector", launch.spin)]);
    of_part(drive, Part::Launch).into_iter().chain(vectors).collect()
}

/// The outcomes of the flight; `None` where the ball does not land.
pub(super) fn flight(drive: &Drive<f64>) -> Option<Map<String, Value>> {
    matches!(drive.flight, Flight::Landed(_)).then(|| of_part(drive, Part::Flight))
}

fn of_part(drive: &Drive<f64>, part: Part) -> Map<String, Value> {
    json::named(Outcome::of_part(part).map(|outcome| (outcome.name(), outcome.value(drive))))
}

fn vectors(pairs: [(&str, Vector<f64>); 2]) -> impl Iterator<Item = (String, Value)> {
    pairs.map(|(name, v)| (name.to_owned(), json::vector(v))).into_iter()
}

/// A drive as text: what a launch monitor shows, and the flight.
pub fn drive_text(drive: &Drive<f64>) -> String {
    let row = |outcome: Outcome| {
        let value = outcome.value(drive);
        vec![
            outcome.name().replace('_', " "),
            value.map_or("–".into(), |v| readable(outcome, v)),
            value.map_or("–".into(), |v| si(outcome, v)),
        ]
    };
    let launch = table(&["launch", "", "SI"], &[1, 2], Outcome::of_part(Part::Launch).map(row));
    let slipped = if matches!(drive.impact.grip, Grip::Slips(_)) { "  the ball slipped on the face\n" } else { "" };
    let bodies = format!(
        "  ball {}\n  club after impact {}\n{slipped}",
        components(drive.impact.launch.velocity),
        components(drive.impact.club_velocity)
    );
    match &drive.flight {
        Flight::Landed(_) => {
            format!(
                "{launch}\n{bodies}\n{}",
                table(&["flight", "", "SI"], &[1, 2], Outcome::of_part(Part::Flight).map(row))
            )
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
