//! Flown shots as messages of GSPro Open Connect, and the answer to a message.

use super::columns::{assumed, in_unit, launch};
use crate::batch::Status;
use crate::drive::Outcome;
use crate::shots::{ASSUMED, Flown, Shot};
use serde_json::{Map, Value, json};

/// A number of a message: of its unit.
fn number(value: Option<f64>, of: Outcome, unit: &str) -> Option<Value> {
    Some(in_unit(value?, of.quantity(), unit).into())
}

/// The members that have a value.
fn object(members: impl IntoIterator<Item = (&'static str, Option<Value>)>) -> Value {
    members
        .into_iter()
        .filter_map(|(key, value)| Some((key.to_owned(), value?)))
        .collect::<Map<_, _>>()
        .into()
}

fn ball(shot: &Shot) -> Value {
    let [speed, angle, direction, spin, axis] = launch(shot);
    let of_launch = |at: usize| shot.launch().map(|launch| launch[at]);
    // a simulator needs what is assumed too; `Origins` says that it is
    let (direction, axis) = (
        direction.or(of_launch(2)),
        axis.or(shot.launch().map(|_| 0.0)),
    );
    object([
        ("Speed", number(speed, Outcome::BallSpeed, "mph")),
        ("SpinAxis", number(axis, Outcome::SpinAxis, "deg")),
        ("TotalSpin", number(spin, Outcome::Spin, "rpm")),
        ("BackSpin", number(of_launch(3), Outcome::Backspin, "rpm")),
        ("SideSpin", number(of_launch(4), Outcome::Sidespin, "rpm")),
        ("HLA", number(direction, Outcome::LaunchDirection, "deg")),
        ("VLA", number(angle, Outcome::LaunchAngle, "deg")),
        (
            "CarryDistance",
            number(
                shot.value(Outcome::CarryDistance).map(|value| value.value),
                Outcome::CarryDistance,
                "yd",
            ),
        ),
    ])
}

fn club(shot: &Shot) -> Value {
    let angle = |value| number(value, Outcome::LaunchAngle, "deg");
    object([
        ("Speed", number(shot.club.speed, Outcome::BallSpeed, "mph")),
        ("AngleOfAttack", angle(shot.club.attack_angle)),
        ("FaceToTarget", angle(shot.club.face_angle)),
        ("Path", angle(shot.club.path)),
    ])
}

/// What is predicted of a row, SI, with how its flight ended; for the line of a file also where the
/// row is.
fn flight(flown: &Flown, row: usize) -> Value {
    let mut flight = Map::new();
    flight.insert("Status".into(), flown.flight(row).into());
    flight.insert("Reason".into(), flown.reason(row).into());
    flight.insert("Notes".into(), flown.shots()[row].notes.clone().into());
    let shot = &flown.shots()[row];
    let stated = shot
        .values
        .iter()
        .filter_map(|value| Some((value.of, value.origin?.name())));
    let assumed = [Outcome::LaunchDirection, Outcome::SpinAxis]
        .into_iter()
        .zip(assumed(shot));
    let assumed = assumed
        .filter(|(_, is)| *is && shot.launch().is_some())
        .map(|(of, _)| (of, ASSUMED));
    let origins: Map<String, Value> = stated
        .chain(assumed)
        .map(|(of, origin)| (of.name().into(), origin.into()))
        .collect();
    if !origins.is_empty() {
        flight.insert("Origins".into(), origins.into());
    }
    for (at, of) in flown.outcomes().iter().enumerate() {
        flight.insert(of.name().into(), flown.predicted(row, at).into());
    }
    flight.into()
}

/// Appends the message of a row. What cannot be flown says that it has no ball data, so that no
/// simulator plays it.
pub(super) fn row(flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
    let shot = &flown.shots()[row];
    let club = club(shot);
    let has_club = club.as_object().is_some_and(|club| !club.is_empty());
    let message = json!({
        "DeviceID": "longdrive",
        "Units": "Yards",
        "ShotNumber": shot.line,
        "APIversion": "1",
        "BallData": ball(shot),
        "ClubData": club,
        "ShotDataOptions": {
            "ContainsBallData": shot.launch().is_some(),
            "ContainsClubData": has_club,
            "IsHeartBeat": false,
        },
        "Flight": flight(flown, row),
    });
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &message);
}

/// The answer to a message: 200 for a shot, with what is predicted of its flight in SI; 201 for a
/// message that is no shot, with the player; 501 for one that cannot be read, with the reason. It
/// ends with a line break.
pub fn open_connect_answer(flown: &Flown) -> Vec<u8> {
    let is_no_shot = flown
        .shots()
        .first()
        .and_then(Shot::refusal)
        .is_some_and(|refusal| refusal.is_no_shot());
    let answer = match flown.status(0) {
        Some(Status::Landed) => {
            json!({"Code": 200, "Message": "Shot received successfully", "Flight": flight(flown, 0)})
        }
        Some(_) => {
            json!({"Code": 200, "Message": "Shot received; the ball does not land", "Flight": flight(flown, 0)})
        }
        None if is_no_shot => {
            json!({"Code": 201, "Message": "GSPro Player Information", "Player": {"Handed": "RH", "Club": "DR"}})
        }
        None => json!({"Code": 501, "Message": flown.reason(0)}),
    };
    let mut bytes = answer.to_string().into_bytes();
    bytes.push(b'\n');
    bytes
}
