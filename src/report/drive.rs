use super::{Reply, json, lines::note, lines::paragraph, shown, table::table};
use crate::aerodynamics::AerodynamicLaw;
use crate::atmosphere::AirState;
use crate::drive::{Drive, Outcome, OutcomeGroup};
use crate::flight::Flight;
use crate::ground::Rest;
use crate::impact::{Grip, Impact};
use crate::number::Vector;
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity, System};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// What a total is known within at best, m: grounds differ by as much (docs/limitations.md).
const RUN_WITHIN: f64 = 10.0 * 0.9144;

/// A drive as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct DriveReport {
    /// Every parameter by its dotted name, and `aero.law`.
    pub setup: Map<String, Value>,
    /// The outcomes of the launch, with the vectors `velocity` and `spin_vector`.
    pub launch: Map<String, Value>,
    /// The head after impact: `velocity` and `angular_velocity`; `null` where the launch is given
    /// and there is no club.
    pub club_after: Option<Map<String, Value>>,
    /// Whether the ball still slid on the face as it left; `null` where there is no club.
    pub slipped: Option<bool>,
    /// The outcomes of the flight.
    pub flight: Option<Map<String, Value>>,
    /// What the law was fitted to, and how much of the flight is outside; `null` without air or a
    /// flight.
    pub law_range: Option<Map<String, Value>>,
}

impl DriveReport {
    /// The answer of `simulate`: the status is `landed`, `no-flight` or `aloft`, the message why
    /// there is no landing.
    pub fn reply(setup: &Setup<f64>, drive: &Drive<f64>, warnings: Vec<Message>) -> Reply<Self> {
        let (status, message) = match &drive.flight {
            Flight::Landed(_) => ("landed", None),
            Flight::None(why) => (why.status(), Some(why.to_string())),
        };
        Reply::done("simulate", warnings, Self::new(setup, drive)).ended(status, message)
    }

    /// The report of a drive.
    pub fn new(setup: &Setup<f64>, drive: &Drive<f64>) -> Self {
        Self {
            setup: json::setup(setup),
            launch: launch(drive),
            club_after: drive.impact.as_ref().map(
                |Impact {
                     club_velocity,
                     club_spin,
                     ..
                 }| {
                    vectors([
                        ("velocity", *club_velocity),
                        ("angular_velocity", *club_spin),
                    ])
                    .collect()
                },
            ),
            slipped: drive
                .impact
                .as_ref()
                .map(|impact| matches!(impact.grip, Grip::Slips(_))),
            flight: flight(drive),
            law_range: law_range(setup, drive),
        }
    }
}

/// For each quantity that a law may be fitted to: the range, how far the flight goes, and the share
/// of the time outside; `null` where no range is known.
pub(super) fn law_range(setup: &Setup<f64>, drive: &Drive<f64>) -> Option<Map<String, Value>> {
    let range = |ends: [f64; 2]| json!({ "low": json::number(Some(ends[0])), "high": json::number(Some(ends[1])) });
    let fitted = setup.law.fitted();
    let within = drive.flown_ranges(setup);
    let each = fitted.ranges().into_iter().zip(within).map(|((name, _, known), within)| {
        let told = known.zip(within).map(|(known, within)| {
            json!({ "fitted": range(known), "flown": range(within.flown), "share_outside": json::number(Some(within.outside)) })
        });
        (json::range_key(name).to_owned(), told.unwrap_or_default())
    });
    let found: Map<String, Value> = each.collect();
    (AirState::of(&setup.air).density > 0.0 && matches!(drive.flight, Flight::Landed(_)))
        .then_some(found)
}

/// The outcomes of the launch, with the vectors `velocity` and `spin_vector`.
pub(super) fn launch(drive: &Drive<f64>) -> Map<String, Value> {
    let launch = &drive.launch;
    let vectors = vectors([("velocity", launch.velocity), ("spin_vector", launch.spin)]);
    of_part(drive, OutcomeGroup::Launch)
        .into_iter()
        .chain(vectors)
        .collect()
}

/// The outcomes of the flight; `None` where the ball does not land.
pub(super) fn flight(drive: &Drive<f64>) -> Option<Map<String, Value>> {
    matches!(drive.flight, Flight::Landed(_)).then(|| of_part(drive, OutcomeGroup::Flight))
}

fn of_part(drive: &Drive<f64>, group: OutcomeGroup) -> Map<String, Value> {
    json::named(Outcome::in_group(group).map(|outcome| (outcome.name(), outcome.value(drive))))
}

fn vectors(pairs: [(&str, Vector<f64>); 2]) -> impl Iterator<Item = (String, Value)> {
    pairs
        .map(|(name, v)| (name.to_owned(), json::vector(v)))
        .into_iter()
}

/// A drive as text: what a launch monitor shows, and the flight; each number in the units of
/// `system`, then in the other's.
pub fn drive_text(drive: &Drive<f64>, system: System) -> String {
    let part = |title: &str, group| {
        let texts = Outcome::in_group(group)
            .map(|outcome| {
                (
                    outcome,
                    shown::outcome_or_dash(outcome, outcome.value(drive), system),
                )
            })
            .collect::<Vec<_>>();
        let number = |text: &str| {
            text.split(' ')
                .next()
                .map_or(0, |number| number.chars().count())
        };
        let widest = texts
            .iter()
            .map(|(_, text)| number(text))
            .max()
            .unwrap_or(0);
        let rows = texts.iter().map(|(outcome, text)| {
            let other = outcome
                .value(drive)
                .map(|value| shown::in_parentheses(*outcome, value, system));
            // numbers end below each other, and their units begin there
            let text = format!("{}{text}", " ".repeat(widest - number(text)));
            vec![
                shown::words(outcome.name()),
                text,
                other.unwrap_or_default(),
            ]
        });
        table(&[title, "", ""], &[], rows)
    };
    let launch = part("launch", OutcomeGroup::Launch);
    let mut bodies = format!(
        "  ball velocity {}\n",
        components(drive.launch.velocity, system)
    );
    if let Some(impact) = &drive.impact {
        bodies += &format!(
            "  club velocity after impact {}\n",
            components(impact.club_velocity, system)
        );
        if matches!(impact.grip, Grip::Slips(_)) {
            bodies += "  the ball slipped on the face\n";
        }
    }
    match &drive.flight {
        Flight::Landed(landed) => {
            let run = note(&on_the_run(landed.rest.as_ref()).in_units(system));
            format!(
                "{launch}\n{bodies}\n{}\n{run}",
                part("flight", OutcomeGroup::Flight)
            )
        }
        Flight::None(why) => {
            format!(
                "{launch}\n{bodies}\n{}",
                paragraph(&why.message().in_units(system))
            )
        }
    }
}

/// The air that the weather of a setup gives, in a line; empty where the air is given by itself.
pub fn air_text(setup: &Setup<f64>, system: System) -> String {
    if !setup.air.has_weather() {
        return String::new();
    }
    let density = AirState::of(&setup.air).density;
    let told = Message::from("air: the weather gives a density of ");
    note(
        &told
            .quantity(Quantity::DENSITY, "kg/m^3", density, Digits::Significant(5))
            .in_units(system),
    )
}

/// What a run is made of, and what it is worth.
fn on_the_run(rest: Option<&Rest<f64>>) -> Message {
    let told = match rest {
        Some(rest) if rest.downrange.is_nan() => {
            return Message::from(format!("run: {}", Outcome::Run.why_undefined()));
        }
        Some(Rest { bounces: 1.., .. }) => "run: bounces, then rolling; ",
        _ => "run: none, the ball embeds; ",
    };
    Message::from(told).message(known_within())
}

/// How well a total is known, in words.
pub fn known_within() -> Message {
    Message::from("total, run and lateral total are known within ")
        .quantity(Quantity::LENGTH, "yd", RUN_WITHIN, Digits::Significant(2))
        .words(" at best, since no one has calibrated a ground (docs/limitations.md)")
}

/// A velocity: "139.20 mph downrange, 19.85 up, 0.00 right".
fn components(velocity: Vector<f64>, system: System) -> String {
    let unit = system.unit("m/s");
    let size = Quantity::SPEED.size_of(unit).unwrap_or(1.0);
    // two decimals, as the paper prints them; rounding has no sign
    let [up, right, downrange] = velocity
        .to_array()
        .map(|component| (component / size * 100.0).round() / 100.0 + 0.0);
    let side = if right < 0.0 { "left" } else { "right" };
    format!(
        "{downrange:.2} {unit} downrange, {up:.2} up, {:.2} {side}",
        right.abs()
    )
}
