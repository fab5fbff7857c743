//! Flown shots as messages of GSPro Open Connect, and the answer to a message.

use super::columns::{assumed, in_unit, launch};
use crate::batch::Status;
use crate::drive::Outcome;
use crate::report::json::ByName;
use crate::shots::{ASSUMED, Flown, Shot};
use serde::Serialize;

/// A shot with the keys and units of the protocol.
#[derive(Serialize)]
struct Message<'a> {
    #[serde(rename = "DeviceID")]
    device_id: &'static str,
    #[serde(rename = "Units")]
    units: &'static str,
    #[serde(rename = "ShotNumber")]
    shot_number: u64,
    #[serde(rename = "APIversion")]
    api_version: &'static str,
    #[serde(rename = "BallData")]
    ball: BallData,
    #[serde(rename = "ClubData")]
    club: ClubData,
    #[serde(rename = "ShotDataOptions")]
    options: Options,
    #[serde(rename = "Flight")]
    flight: Flight<'a>,
}

/// The launch: speed in mph, angles in degrees, spins in rpm, carry in yards. Missing values are
/// omitted.
#[derive(Serialize)]
struct BallData {
    #[serde(rename = "Speed", skip_serializing_if = "Option::is_none")]
    speed: Option<f64>,
    #[serde(rename = "SpinAxis", skip_serializing_if = "Option::is_none")]
    spin_axis: Option<f64>,
    #[serde(rename = "TotalSpin", skip_serializing_if = "Option::is_none")]
    total_spin: Option<f64>,
    #[serde(rename = "BackSpin", skip_serializing_if = "Option::is_none")]
    backspin: Option<f64>,
    #[serde(rename = "SideSpin", skip_serializing_if = "Option::is_none")]
    sidespin: Option<f64>,
    #[serde(rename = "HLA", skip_serializing_if = "Option::is_none")]
    direction: Option<f64>,
    #[serde(rename = "VLA", skip_serializing_if = "Option::is_none")]
    angle: Option<f64>,
    #[serde(rename = "CarryDistance", skip_serializing_if = "Option::is_none")]
    carry: Option<f64>,
}

/// The club: speed in mph, angles in degrees. Missing values are omitted.
#[derive(Serialize)]
struct ClubData {
    #[serde(rename = "Speed", skip_serializing_if = "Option::is_none")]
    speed: Option<f64>,
    #[serde(rename = "AngleOfAttack", skip_serializing_if = "Option::is_none")]
    attack_angle: Option<f64>,
    #[serde(rename = "FaceToTarget", skip_serializing_if = "Option::is_none")]
    face_angle: Option<f64>,
    #[serde(rename = "Path", skip_serializing_if = "Option::is_none")]
    path: Option<f64>,
}

/// Flags for the parts of a message.
#[derive(Serialize)]
#[serde(rename_all = "PascalCase")]
struct Options {
    contains_ball_data: bool,
    contains_club_data: bool,
    is_heart_beat: bool,
}

/// The predictions of a row, SI, with the status of its flight.
#[derive(Serialize)]
#[serde(rename_all = "PascalCase")]
struct Flight<'a> {
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
struct Answer<'a> {
    code: u16,
    message: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    flight: Option<Flight<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    player: Option<Player>,
}

/// The player of a simulator.
#[derive(Serialize)]
#[serde(rename_all = "PascalCase")]
struct Player {
    handed: &'static str,
    club: &'static str,
}

impl BallData {
    fn new(shot: &Shot) -> Self {
        let [speed, angle, direction, spin, axis] = launch(shot);
        let of_launch = |at: usize| shot.launch().map(|launch| launch[at]);
        // a simulator needs the assumed values too; `Origins` identifies them
        let direction = direction.or(of_launch(2));
        let axis = axis.or(shot.launch().map(|_| 0.0));
        let carry = shot.value(Outcome::CarryDistance).map(|value| value.value);
        Self {
            speed: number(speed, Outcome::BallSpeed, "mph"),
            spin_axis: number(axis, Outcome::SpinAxis, "deg"),
            total_spin: number(spin, Outcome::Spin, "rpm"),
            backspin: number(of_launch(3), Outcome::Backspin, "rpm"),
            sidespin: number(of_launch(4), Outcome::Sidespin, "rpm"),
            direction: number(direction, Outcome::LaunchDirection, "deg"),
            angle: number(angle, Outcome::LaunchAngle, "deg"),
            carry: number(carry, Outcome::CarryDistance, "yd"),
        }
    }
}

impl ClubData {
    fn new(shot: &Shot) -> Self {
        let angle = |value| number(value, Outcome::LaunchAngle, "deg");
        Self {
            speed: number(shot.club.speed, Outcome::BallSpeed, "mph"),
            attack_angle: angle(shot.club.attack_angle),
            face_angle: angle(shot.club.face_angle),
            path: angle(shot.club.path),
        }
    }

    fn is_empty(&self) -> bool {
        let values = [self.speed, self.attack_angle, self.face_angle, self.path];
        values.iter().all(Option::is_none)
    }
}

impl<'a> Flight<'a> {
    fn new(flown: &'a Flown, row: usize) -> Self {
        let shot = &flown.shots[row];
        let stated = shot
            .values
            .iter()
            .filter_map(|value| Some((value.of.name(), value.origin?.name())));
        let assumed = [Outcome::LaunchDirection, Outcome::SpinAxis]
            .into_iter()
            .zip(assumed(shot))
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

/// A number in a unit of the protocol.
fn number(value: Option<f64>, of: Outcome, unit: &str) -> Option<f64> {
    Some(in_unit(value?, of.quantity(), unit))
}

/// Appends the message of a row. For a row that cannot be flown, the message states that it has no
/// ball data, so that no simulator plays it.
pub(super) fn row(flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
    let shot = &flown.shots[row];
    let club = ClubData::new(shot);
    let message = Message {
        device_id: "longdrive",
        units: "Yards",
        shot_number: shot.line,
        api_version: "1",
        ball: BallData::new(shot),
        options: Options {
            contains_ball_data: shot.launch().is_some(),
            contains_club_data: !club.is_empty(),
            is_heart_beat: false,
        },
        club,
        flight: Flight::new(flown, row),
    };
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &message);
}

/// The answer to a message: 200 for a shot, with its predictions in SI; 201 for a message without a
/// shot, with the player; 501 for an unreadable message, with the reason. It ends with a line
/// break.
pub fn open_connect_answer(flown: &Flown) -> Vec<u8> {
    let is_no_shot = flown
        .shots
        .first()
        .and_then(Shot::refusal)
        .is_some_and(|refusal| refusal.is_no_shot());
    let shot = |message| Answer {
        code: 200,
        message: Some(message),
        flight: Some(Flight::new(flown, 0)),
        player: None,
    };
    let answer = match flown.status(0) {
        Some(Status::Landed) => shot("Shot received successfully"),
        Some(_) => shot("Shot received; the ball does not land"),
        None if is_no_shot => Answer {
            code: 201,
            message: Some("GSPro Player Information"),
            flight: None,
            player: Some(Player {
                handed: "RH",
                club: "DR",
            }),
        },
        None => Answer {
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
