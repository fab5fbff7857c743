use super::{json, table::table};
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
    /// `landed`, `no-flight` or `aloft`.
    pub status: &'static str,
    /// Why there is no landing.
    pub message: Option<String>,
    /// The outcomes of the launch, with the vectors `velocity` and `spin_vector`.
    pub launch: Map<String, Value>,
    /// The head after impact: `velocity` and `angular_velocity`; `null` where the launch is given and there is no club.
    pub club_after: Option<Map<String, Value>>,
    /// Whether the ball still slid on the face as it left; `null` where there is no club.
    pub slipped: Option<bool>,
    /// The outcomes of the flight.
    pub flight: Option<Map<String, Value>>,
    /// What deserves a word.
    pub warnings: Vec<String>,
}

impl DriveReport {
    /// The report of a drive.
    pub fn new(setup: &Setup<f64>, drive: &Drive<f64>, warnings: Vec<String>) -> Self {
        let of_part = |part| json::named(Outcome::of_part(part).map(|outcome| (outcome.name(), outcome.value(drive))));
        let launch = &drive.launch;
        let vectors = |pairs: [(&str, Vector<f64>); 2]| pairs.map(|(name, v)| (name.to_owned(), json::vector(v)));
        let (status, message) = match &drive.flight {
            Flight::Landed(_) => ("landed", None),
            Flight::None(why) => (why.status(), Some(why.to_string())),
        };
        Self {
            setup: json::setup(setup),
            status,
            flight: message.is_none().then(|| of_part(Part::Flight)),
            message,
            launch: of_part(Part::Launch)
                .into_iter()
                .chain(vectors([("velocity", launch.velocity), ("spin_vector", launch.spin)]))
                .collect(),
            club_after: drive.impact.as_ref().map(|Impact { club_velocity, club_spin, .. }| {
                vectors([("velocity", *club_velocity), ("angular_velocity", *club_spin)]).into_iter().collect()
            }),
            slipped: drive.impact.as_ref().map(|impact| matches!(impact.grip, Grip::Slips(_))),
            warnings,
        }
    }
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
    let mut bodies = format!("  ball {}\n", components(drive.launch.velocity));
    if let Some(impact) = &drive.impact {
        bodies += &format!("  club after impact {}\n", components(impact.club_velocity));
        if matches!(impact.grip, Grip::Slips(_)) {
            bodies += "  the ball slipped on the face\n";
        }
    }
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
