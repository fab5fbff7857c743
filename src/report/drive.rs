use super::conditions;
use super::document::{Document, DocumentTable, Line};
use super::json::{self, ByName, JsonNumber, Settings, settings};
use super::reply::{Ending, Report};
use super::shown;
use crate::atmosphere::AirState;
use crate::drive::{Drive, FlownRange, Outcome, OutcomeGroup, carry_with_law_held};
use crate::flight::Flight;
use crate::ground::Rest;
use crate::impact::Grip;
use crate::number::Vector;
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity, System, YARD, fixed};
use serde::Serialize;
use std::sync::atomic::AtomicBool;

/// Minimum uncertainty of the total (carry and run), m. No one has calibrated a ground
/// (docs/limitations.md).
const TOTAL_UNCERTAINTY: f64 = 10.0 * YARD;

/// A drive: setup, launch, head after impact and flight.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DriveReport<'a> {
    #[serde(skip)]
    drive_setup: &'a Setup<f64>,
    #[serde(skip)]
    drive: &'a Drive<f64>,
    /// Every parameter by its dotted name, and `aero.law`.
    pub setup: Settings,
    /// The launch.
    pub launch: LaunchReport,
    /// The head after impact; `null` if the launch is stated and there is no club.
    pub club_after: Option<ClubReport>,
    /// True if the ball was still sliding on the face at separation; `null` without a club.
    pub slipped: Option<bool>,
    /// The outcomes of the flight; `null` if the ball does not land.
    #[cfg_attr(test, schemars(schema_with = "flight_schema"))]
    pub flight: Option<ByName<JsonNumber>>,
    /// The fitted ranges of the law, each with the range that the flight covers; `null` if there is
    /// no air or no flight.
    pub law_range: Option<LawRanges>,
}

/// The launch of a drive.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LaunchReport {
    /// The outcomes of the launch.
    #[serde(flatten)]
    #[cfg_attr(test, schemars(schema_with = "launch_schema"))]
    pub outcomes: ByName<JsonNumber>,
    /// The velocity of the ball, m/s: up, right, downrange.
    pub velocity: [JsonNumber; 3],
    /// The angular velocity of the ball, rad/s: up, right, downrange.
    pub spin_vector: [JsonNumber; 3],
}

/// The head of the club after impact.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClubReport {
    /// The velocity of the centre of mass, m/s: up, right, downrange.
    pub velocity: [JsonNumber; 3],
    /// The angular velocity, rad/s: up, right, downrange.
    pub angular_velocity: [JsonNumber; 3],
}

/// The fitted range and the flown range of each quantity on which a law may depend. `null` for a
/// quantity over which the law was not fitted.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LawRanges {
    /// Spin ratio r ω/v.
    pub spin_ratio: Option<FlownRange>,
    /// Spin, rad/s.
    pub spin: Option<FlownRange>,
    /// Reynolds number.
    pub reynolds: Option<FlownRange>,
    /// Speed through the air, m/s.
    pub speed: Option<FlownRange>,
}

impl<'a> DriveReport<'a> {
    /// The report of a drive with this setup.
    pub fn new(setup: &'a Setup<f64>, drive: &'a Drive<f64>) -> Self {
        let impact = drive.impact.as_ref();
        Self {
            drive_setup: setup,
            drive,
            setup: settings(setup),
            launch: launch(drive),
            club_after: impact.map(|impact| ClubReport {
                velocity: json::components(impact.club_velocity),
                angular_velocity: json::components(impact.club_spin),
            }),
            slipped: impact.map(|impact| matches!(impact.grip, Grip::Slips(_))),
            flight: flight(drive),
            law_range: law_range(setup, drive),
        }
    }
}

impl Report for DriveReport<'_> {
    const COMMAND: &'static str = "simulate";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["landed", "no-flight", "aloft"];

    /// The message is the reason why the ball does not land; `None` if the ball lands.
    fn ending(&self) -> Ending {
        match &self.drive.flight {
            Flight::Landed(_) => Ending {
                status: "landed",
                message: None,
            },
            Flight::None(why) => Ending {
                status: why.status(),
                message: Some(why.to_string()),
            },
        }
    }

    /// The outcomes of the launch, then those of the flight. Each value is in the units of `system`
    /// and, in parentheses, in the units of the other system.
    fn document(&self, system: System) -> Document {
        let Self {
            drive_setup, drive, ..
        } = self;
        let mut document = Document::default();
        document.add(outcomes("launch", OutcomeGroup::Launch, drive, system));
        document.list(bodies(drive, system));
        let air = conditions::air(drive_setup, system);
        let wind = conditions::wind(drive_setup, system);
        let wind = wind.as_deref().unwrap_or("no wind");
        let conditions = Line::note(format!("air: {air}; {wind}"));
        match &drive.flight {
            Flight::Landed(landed) => {
                document.add(outcomes("flight", OutcomeGroup::Flight, drive, system));
                let run = on_the_run(landed.rest.as_ref()).in_units(system);
                let beyond = with_law_held(drive, drive_setup, system);
                let notes = shown::gear_effect(drive_setup).map(Line::note).into_iter();
                let notes = notes
                    .chain(beyond.map(Line::note))
                    .chain([Line::note(run), conditions]);
                document.list(notes);
            }
            Flight::None(why) => {
                let why = Line::flush(why.message().in_units(system));
                document.list([why, conditions]);
            }
        }
        document
    }
}

/// The fitted and flown ranges of a drive. `None` if there is no air or no flight.
pub(super) fn law_range(setup: &Setup<f64>, drive: &Drive<f64>) -> Option<LawRanges> {
    let has_air = AirState::of(&setup.air).density > 0.0;
    if !has_air || matches!(drive.flight, Flight::None(_)) {
        return None;
    }
    let [spin_ratio, spin, reynolds, speed] = drive.flown_ranges(setup, &AtomicBool::new(false));
    Some(LawRanges {
        spin_ratio,
        spin,
        reynolds,
        speed,
    })
}

#[cfg(test)]
fn launch_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schema_of_group(OutcomeGroup::Launch, generator)
}

/// The schema of [`flight`].
#[cfg(test)]
pub(super) fn flight_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let mut schema = schema_of_group(OutcomeGroup::Flight, generator);
    schema.insert("type".into(), serde_json::json!(["object", "null"]));
    schema
}

/// The schema of an object with the outcomes of a group.
#[cfg(test)]
fn schema_of_group(
    group: OutcomeGroup,
    generator: &mut schemars::SchemaGenerator,
) -> schemars::Schema {
    let mut properties = serde_json::Map::new();
    for outcome in Outcome::in_group(group) {
        let mut value = generator.subschema_for::<JsonNumber>();
        let mut description = outcome.doc().to_owned();
        if !outcome.quantity().si.is_empty() {
            description += &format!(" SI unit: {}.", outcome.quantity().si);
        }
        value.insert("description".into(), description.into());
        properties.insert(outcome.name().into(), value.into());
    }
    let names: Vec<String> = properties.keys().cloned().collect();
    schemars::json_schema!({ "type": "object", "properties": properties, "required": names })
}

/// The outcomes of the launch, with the vectors of velocity and spin.
pub(super) fn launch(drive: &Drive<f64>) -> LaunchReport {
    LaunchReport {
        outcomes: of_group(drive, OutcomeGroup::Launch),
        velocity: json::components(drive.launch.velocity),
        spin_vector: json::components(drive.launch.spin),
    }
}

/// The outcomes of the flight; `None` if the ball does not land.
pub(super) fn flight(drive: &Drive<f64>) -> Option<ByName<JsonNumber>> {
    matches!(drive.flight, Flight::Landed(_)).then(|| of_group(drive, OutcomeGroup::Flight))
}

fn of_group(drive: &Drive<f64>, group: OutcomeGroup) -> ByName<JsonNumber> {
    Outcome::in_group(group)
        .map(|outcome| (outcome.name(), outcome.value(drive)))
        .collect()
}

/// The table of a group of outcomes: name, value, and value in the other system of units.
fn outcomes(title: &str, group: OutcomeGroup, drive: &Drive<f64>, system: System) -> DocumentTable {
    let texts: Vec<_> = Outcome::in_group(group)
        .map(|outcome| {
            let value = outcome.value(drive);
            let text = shown::outcome_or_dash(outcome, value, system);
            (outcome, value, text)
        })
        .collect();
    let width = |text: &str| {
        let number = text.split(' ').next().unwrap_or_default();
        number.chars().count()
    };
    let widest = texts.iter().map(|(_, _, text)| width(text)).max();
    let widest = widest.unwrap_or(0);
    let rows = texts.iter().map(|(outcome, value, text)| {
        let other = value.map(|value| shown::in_parentheses(*outcome, value, system));
        // aligns the last digits of the numbers, and their units
        let indent = " ".repeat(widest - width(text));
        vec![
            shown::words(outcome.name()),
            format!("{indent}{text}"),
            other.unwrap_or_default(),
        ]
    });
    DocumentTable::new([title, "", ""], rows)
}

/// The velocities of ball and head after impact.
fn bodies(drive: &Drive<f64>, system: System) -> Vec<Line> {
    let ball = components(drive.launch.velocity, system);
    let mut lines = vec![Line::item(format!("ball velocity {ball}"))];
    if let Some(impact) = &drive.impact {
        let head = components(impact.club_velocity, system);
        lines.push(Line::item(format!("club velocity after impact {head}")));
        if matches!(impact.grip, Grip::Slips(_)) {
            lines.push(Line::item("the ball slipped on the face"));
        }
    }
    lines
}

/// How the ball comes to rest, and the uncertainty of the total.
fn on_the_run(rest: Option<&Rest<f64>>) -> Message {
    let parts = match rest {
        Some(rest) if rest.downrange.is_nan() => {
            return Message::from(format!("run: {}", Outcome::Run.why_undefined()));
        }
        Some(Rest { bounces: 1.., .. }) => "run: bounces, then rolling; ",
        _ => "run: none, the ball embeds; ",
    };
    Message::from(parts).message(total_uncertainty_note())
}

/// The change of the carry with the law held at the end of its range, in words. `None` if the
/// flight stays in this range, or if the change is small.
pub(super) fn with_law_held(
    drive: &Drive<f64>,
    setup: &Setup<f64>,
    system: System,
) -> Option<String> {
    let change = drive.extrapolated_carry(setup)?;
    Some(carry_with_law_held(change).in_units(system))
}

/// The minimum uncertainty of a total.
pub(super) fn total_uncertainty() -> Message {
    Message::default().quantity(
        Quantity::LENGTH,
        "yd",
        TOTAL_UNCERTAINTY,
        Digits::Significant(2),
    )
}

/// The uncertainty of a total, in words.
pub fn total_uncertainty_note() -> Message {
    Message::from("total, run and lateral total are known within ")
        .message(total_uncertainty())
        .words(" at best, since no one has calibrated a ground (docs/limitations.md)")
}

/// A velocity: "139.20 mph downrange, 19.85 up, 0.00 right".
fn components(velocity: Vector<f64>, system: System) -> String {
    let unit = system.unit("m/s");
    let size = Quantity::SPEED.size_of(unit).unwrap_or(1.0);
    let [up, right, downrange] = velocity
        .to_array()
        .map(|component| fixed(component / size, 2));
    let (right, side) = match right.strip_prefix('-') {
        Some(left) => (left, "left"),
        None => (right.as_str(), "right"),
    };
    format!("{downrange} {unit} downrange, {up} up, {right} {side}")
}
