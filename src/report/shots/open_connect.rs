//! Flown shots as messages of GSPro Open Connect, and the answer to a message.

use super::columns::launch;
use crate::batch::Status;
use crate::drive::Outcome;
use crate::parameters::Golfer;
use crate::report::json::ByName;
use crate::shots::{ASSUMED, Flown, Shot};
use crate::units::DisplayUnit;
use serde::Serialize;

/// A shot with the keys and units of the protocol.
#[derive(Serialize)]
struct OpenConnectShot<'a> {
    #[serde(rename = "DeviceID")]
    device_id: &'static str,
    #[serde(rename = "Units")]
    units: &'static str,
    #[serde(rename = "ShotNumber")]
    shot_number: u64,
    #[serde(rename = "APIversion")]
    api_version: &'static str,
    #[serde(rename = "BallData")]
    ball: ByName<f64>,
    #[serde(rename = "ClubData")]
    club: ByName<f64>,
    #[serde(rename = "ShotDataOptions")]
    options: ByName<bool>,
    #[serde(rename = "Flight")]
    flight: OpenConnectFlight<'a>,
}

/// The predictions of a row, SI, with the status of its flight.
#[derive(Serialize)]
#[serde(rename_all = "PascalCase")]
struct OpenConnectFlight<'a> {
    status: &'a str,
    reason: Option<&'a str>,
    notes: &'a [String],
    #[serde(skip_serializing_if = "Option::is_none")]
    origins: Option<ByName<&'static str>>,
    #[serde(flatten)]
    predicted: ByName<Option<f64>>,
}

/// The answer to a message.
#[derive(Serialize)]
#[serde(rename_all = "PascalCase")]
struct OpenConnectAnswer<'a> {
    code: u16,
    message: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    flight: Option<OpenConnectFlight<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    player: Option<ByName<&'static str>>,
}

/// The launch, with the keys of the protocol. A missing value is omitted.
fn ball(shot: &Shot) -> ByName<f64> {
    let [speed, angle, direction, spin, axis] = launch(shot);
    let [flown_direction, backspin, sidespin] = match shot.launch() {
        Some(&[_, _, direction, back, side]) => [direction, back, side].map(Some),
        _ => [None; 3],
    };
    // a simulator needs the assumed values too; `Origins` identifies them
    let direction = direction.or(flown_direction);
    let axis = axis.or(backspin.map(|_| 0.0));
    let carry = shot.value(Outcome::CarryDistance).map(|value| value.value);
    let values = [
        in_unit("Speed", speed, Outcome::BallSpeed, "mph"),
        in_unit("SpinAxis", axis, Outcome::SpinAxis, "deg"),
        in_unit("TotalSpin", spin, Outcome::Spin, "rpm"),
        in_unit("BackSpin", backspin, Outcome::Backspin, "rpm"),
        in_unit("SideSpin", sidespin, Outcome::Sidespin, "rpm"),
        in_unit("HLA", direction, Outcome::LaunchDirection, "deg"),
        in_unit("VLA", angle, Outcome::LaunchAngle, "deg"),
        in_unit("CarryDistance", carry, Outcome::CarryDistance, "yd"),
    ];
    values.into_iter().flatten().collect()
}

/// The club, with the keys of the protocol. A missing value is omitted.
fn club(shot: &Shot) -> ByName<f64> {
    let club = &shot.club;
    let angle = |key, value| in_unit(key, value, Outcome::LaunchAngle, "deg");
    let values = [
        in_unit("Speed", club.speed, Outcome::BallSpeed, "mph"),
        angle("AngleOfAttack", club.attack_angle),
        angle("FaceToTarget", club.face_angle),
        angle("Path", club.path),
    ];
    values.into_iter().flatten().collect()
}

/// A key with its value in a unit of the protocol. The value is rounded to six decimals, which
/// removes the rounding errors of the conversion.
fn in_unit(
    key: &'static str,
    value: Option<f64>,
    of: Outcome,
    unit: &'static str,
) -> Option<(&'static str, f64)> {
    let quantity = of.quantity();
    let number = value? / DisplayUnit { quantity, unit }.size();
    Some((key, (number * 1e6).round() / 1e6))
}

impl<'a> OpenConnectFlight<'a> {
    fn new(flown: &'a Flown, row: usize) -> Self {
        let shot = &flown.shots[row];
        let stated = shot
            .values
            .iter()
            .filter_map(|value| Some((value.of.name(), value.origin?.name())));
        let assumed = [
            (Outcome::LaunchDirection, shot.is_direction_assumed()),
            (Outcome::SpinAxis, shot.is_axis_assumed()),
        ]
        .into_iter()
        .filter(|(_, is)| *is && shot.launch().is_some())
        .map(|(of, _)| (of.name(), ASSUMED));
        let origins: ByName<&'static str> = stated.chain(assumed).collect();
        let outcomes = flown.of.iter().enumerate();
        Self {
            status: flown.flight(row),
            reason: flown.reason(row),
            notes: &shot.notes,
            origins: Some(origins).filter(|origins| !origins.0.is_empty()),
            predicted: outcomes
                .map(|(at, of)| (of.name(), flown.predicted(row, at)))
                .collect(),
        }
    }
}

/// Appends the message of a row. If the row cannot be flown, the message states that it has no ball
/// data, so that no simulator plays the shot.
pub(super) fn row(flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
    let shot = &flown.shots[row];
    let club = club(shot);
    let options = [
        ("ContainsBallData", shot.launch().is_some()),
        ("ContainsClubData", !club.0.is_empty()),
        ("IsHeartBeat", false),
    ];
    let message = OpenConnectShot {
        device_id: "longdrive",
        units: "Yards",
        shot_number: shot.line,
        api_version: "1",
        ball: ball(shot),
        club,
        options: options.into_iter().collect(),
        flight: OpenConnectFlight::new(flown, row),
    };
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &message);
}

/// The answer to a message, ending with a line break. A shot gets code 200 and its predictions in
/// SI. A message without a shot gets code 201 and the player: the handedness of `golfer`, and a
/// driver. Any other message gets code 501 and the reason.
pub fn open_connect_answer(flown: &Flown, golfer: Golfer) -> Vec<u8> {
    let is_no_shot = flown
        .shots
        .first()
        .and_then(Shot::refusal)
        .is_some_and(|refusal| refusal.is_no_shot());
    let shot = |message| OpenConnectAnswer {
        code: 200,
        message: Some(message),
        flight: Some(OpenConnectFlight::new(flown, 0)),
        player: None,
    };
    let hand = match golfer {
        Golfer::Right => "RH",
        Golfer::Left => "LH",
    };
    let answer = match flown.status(0) {
        Some(Status::Landed) => shot("Shot received successfully"),
        Some(_) => shot("Shot received; the ball does not land"),
        None if is_no_shot => OpenConnectAnswer {
            code: 201,
            message: Some("GSPro Player Information"),
            flight: None,
            player: Some([("Handed", hand), ("Club", "DR")].into_iter().collect()),
        },
        None => OpenConnectAnswer {
            code: 501,
            message: flown.reason(0),
            flight: None,
            player: None,
        },
    };
    let mut bytes = serde_json::to_vec(&answer).unwrap_or_default();
    bytes.push(b'\n');
    bytes
}
