//! Reads messages of GSPro Open Connect as shots.

use super::export::{OF_SPIN, add_notes, launch};
use super::shot::{Club, NOT_COMPARED, Origin, REFUSED, Shot, StatedValue};
use super::written;
use crate::drive::Outcome;
use crate::error::nearest;
use crate::parameters::Parameter;
use crate::table::{NOT_MEASURED, Record, Refusal, outside};
use crate::units::{DisplayUnit, Quantity};
use serde_json::{Map, Value as Json};

/// The origin that `fly` writes for a launch value that it assumed.
pub(crate) const ASSUMED: &str = "assumed";

/// Keys of `BallData` with their outcomes.
const BALL: [(&str, Outcome); 8] = [
    ("Speed", Outcome::BallSpeed),
    ("VLA", Outcome::LaunchAngle),
    ("HLA", Outcome::LaunchDirection),
    ("TotalSpin", Outcome::Spin),
    ("SpinAxis", Outcome::SpinAxis),
    ("BackSpin", Outcome::Backspin),
    ("SideSpin", Outcome::Sidespin),
    ("CarryDistance", Outcome::CarryDistance),
];

/// Units of speeds and lengths in a message, from its member `Units`; mph and yd without this
/// member.
fn units(message: &Map<String, Json>) -> Result<(&'static str, &'static str), Refusal> {
    match message.get("Units") {
        None | Some(Json::Null) => Ok(("mph", "yd")),
        Some(Json::String(units)) => match units.to_lowercase().as_str() {
            "yards" | "yard" | "yd" | "imperial" => Ok(("mph", "yd")),
            "meters" | "metres" | "meter" | "metre" | "m" | "metric" => Ok(("m/s", "m")),
            _ => Err(Refusal::new(
                Refusal::UNREADABLE,
                format!("Units: '{units}' is unknown; write \"Yards\" or \"Meters\""),
            )),
        },
        Some(other) => Err(Refusal::new(
            Refusal::UNREADABLE,
            format!("Units: {other} is no text; write \"Yards\" or \"Meters\""),
        )),
    }
}

/// The number stored under a key; `None` if the key is absent.
fn number(of: &Map<String, Json>, group: &str, key: &str) -> Result<Option<f64>, Refusal> {
    match of.get(key) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => match value.as_f64() {
            Some(number) => Ok(Some(number)),
            None => Err(Refusal::new(
                Refusal::UNREADABLE,
                format!("{group}.{key}: {value} is not a number"),
            )),
        },
    }
}

/// Origin of a value in a message that `fly` wrote. Total spin, spin axis, backspin and sidespin
/// have a common origin.
fn origin(message: &Map<String, Json>, of: Outcome) -> Option<Origin> {
    let origins = message.get("Flight")?.get("Origins")?;
    let spins: &[Outcome] = if OF_SPIN.contains(&of) { &OF_SPIN } else { &[] };
    let named = [of]
        .iter()
        .chain(spins)
        .find_map(|of| origins.get(of.name()));
    Origin::read(named?.as_str()?)
}

/// True for a value that `fly` assumed because it was missing.
fn is_assumed(message: &Map<String, Json>, of: Outcome) -> bool {
    // an assumed spin axis of 0 means that the sidespin of 0 is assumed too
    let of = if of == Outcome::Sidespin {
        Outcome::SpinAxis
    } else {
        of
    };
    let origin = message
        .get("Flight")
        .and_then(|flight| flight.get("Origins")?.get(of.name()));
    origin.is_some_and(|origin| origin == ASSUMED)
}

/// Suggestion for a missing key: an unknown key of the ball data with a similar name.
fn suggestion(ball: &Map<String, Json>, key: &str) -> String {
    let unknown = ball
        .keys()
        .filter(|other| BALL.iter().all(|(known, _)| known != other));
    let near = unknown.filter(|other| {
        nearest(&other.to_lowercase(), [key.to_lowercase().as_str()])
            .is_some_and(|(likeness, _)| likeness > 0.85)
    });
    near.map(|other| format!(" (did you mean '{key}' instead of '{other}'?)"))
        .next()
        .unwrap_or_default()
}

/// Reads the shot of a message. A message without ball data, such as a heartbeat, is refused. If
/// `fly` wrote the message, its `parameters` must be exactly those in `other_parameters`.
pub(super) fn shot(record: Record, other_parameters: &[&'static Parameter]) -> Shot {
    let Record {
        line,
        text,
        is_whole,
    } = record;
    let parsed = if is_whole {
        serde_json::from_str::<Json>(&text).map_err(|error| syntax_error(&error))
    } else if text.starts_with('{') {
        Err("the JSON object does not end; close its braces and quotes".into())
    } else {
        Err("it is not a JSON object; a message begins with {".into())
    };
    let message = match parsed {
        Ok(Json::Object(message)) => message,
        Ok(_) => {
            return Shot::refused(
                line,
                text,
                Refusal::new(Refusal::JSON, "it is not a JSON object"),
            );
        }
        Err(reason) => return Shot::refused(line, text, Refusal::new(Refusal::JSON, reason)),
    };
    let mut shot = Shot::refused(line, text, Refusal::new(Refusal::NO_BALL, ""));
    if let Err(refusal) = fill(&mut shot, &message, other_parameters) {
        shot.point = Err(refusal);
    }
    shot
}

fn syntax_error(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let what = message.split(" at line").next().unwrap_or_default();
    format!(
        "it is not valid JSON (line {}, column {} of the object: {what})",
        error.line(),
        error.column()
    )
}

fn fill(
    shot: &mut Shot,
    message: &Map<String, Json>,
    other_parameters: &[&'static Parameter],
) -> Result<(), Refusal> {
    if written::is_written(message) {
        return written::fill(shot, message, other_parameters);
    }
    let ball = ball_data(message)?;
    if let Some(parameter) = other_parameters.first() {
        let reason = format!(
            "the message has no value of {}, but the first flown line has one; put messages and \
             lines of 'fly' into separate files",
            parameter.name
        );
        return Err(Refusal::new(Refusal::MISSING, reason));
    }
    let (speed_unit, length_unit) = units(message)?;
    fill_ball(shot, message, ball, speed_unit, length_unit)?;
    if option(message, "ContainsClubData") != Some(false) {
        match message.get("ClubData") {
            Some(Json::Object(club)) => {
                shot.club = club_data(club, speed_unit, &mut shot.notes);
            }
            None | Some(Json::Null) => {}
            Some(_) => shot.notes.push(format!(
                "ClubData is not an object; the club {NOT_MEASURED}"
            )),
        }
    }
    remove_unsent(&mut shot.values);
    let stated = shot.conditions();
    let name = |of: Outcome| {
        let key = BALL
            .iter()
            .find(|(_, known)| *known == of)
            .map_or("", |(key, _)| *key);
        format!(
            "BallData.{key}{}",
            if ball.contains_key(key) {
                String::new()
            } else {
                suggestion(ball, key)
            }
        )
    };
    shot.point = launch(&stated, name, |of| {
        of != Outcome::Spin || !ball.contains_key("BackSpin")
    });
    add_notes(shot, &stated, name);
    Ok(())
}

fn fill_ball(
    shot: &mut Shot,
    message: &Map<String, Json>,
    ball: &Map<String, Json>,
    speed_unit: &'static str,
    length_unit: &'static str,
) -> Result<(), Refusal> {
    for (key, of) in BALL {
        let unit = match of {
            Outcome::BallSpeed => speed_unit,
            Outcome::CarryDistance => length_unit,
            of => of.unit(),
        };
        match number(ball, "BallData", key) {
            Ok(Some(_)) if is_assumed(message, of) => {}
            Ok(Some(number)) => {
                let quantity = of.quantity();
                let value = number * DisplayUnit { quantity, unit }.size();
                match outside(of, value).filter(|_| of == Outcome::CarryDistance) {
                    // 0 means that the value was not sent
                    Some(_) if number == 0.0 => {}
                    Some(why) => {
                        let note = format!("{NOT_COMPARED}BallData.{key}: {why}");
                        shot.notes.push(note);
                    }
                    None => shot.values.push(StatedValue {
                        of,
                        value,
                        origin: origin(message, of),
                    }),
                }
            }
            Ok(None) => {}
            Err(refusal) if of == Outcome::CarryDistance => {
                shot.notes.push(format!("{NOT_COMPARED}{}", refusal.reason))
            }
            Err(refusal) => return Err(refusal),
        }
    }
    Ok(())
}

/// A flag of `ShotDataOptions`.
fn option(message: &Map<String, Json>, key: &str) -> Option<bool> {
    message.get("ShotDataOptions")?.get(key)?.as_bool()
}

/// The ball data of a message.
///
/// # Errors
/// The refusal, if the message has no ball data, or if an earlier run of `fly` refused the message.
fn ball_data(message: &Map<String, Json>) -> Result<&Map<String, Json>, Refusal> {
    let flight = |key: &str| message.get("Flight")?.get(key)?.as_str();
    if let (Some(REFUSED), Some(reason)) = (flight("Status"), flight("Reason")) {
        return Err(Refusal::new(Refusal::BEFORE, reason));
    }
    let none = |why: &str| Err(Refusal::new(Refusal::NO_BALL, why));
    if option(message, "IsHeartBeat") == Some(true) {
        return none("a heartbeat (ShotDataOptions.IsHeartBeat), not a shot");
    }
    if option(message, "ContainsBallData") == Some(false) {
        return none("it has no ball data (ShotDataOptions.ContainsBallData is false)");
    }
    match message.get("BallData") {
        Some(Json::Object(ball)) => Ok(ball),
        None | Some(Json::Null) => {
            let reason = "it has no BallData; a shot needs BallData with Speed, VLA and TotalSpin \
                          or BackSpin";
            Err(Refusal::new(Refusal::MISSING, reason))
        }
        Some(_) => Err(Refusal::new(
            Refusal::JSON,
            "BallData is not an object; write \"BallData\": {\"Speed\": …}",
        )),
    }
}

fn club_data(club: &Map<String, Json>, speed_unit: &'static str, notes: &mut Vec<String>) -> Club {
    let value = |key, unit: DisplayUnit| match number(club, "ClubData", key) {
        Ok(number) => Ok(number.map(|number| number * unit.size())),
        Err(refusal) => Err(refusal.reason),
    };
    let speed = DisplayUnit {
        quantity: Quantity::SPEED,
        unit: speed_unit,
    };
    let degree = DisplayUnit {
        quantity: Quantity::ANGLE,
        unit: "deg",
    };
    let stated = [
        value("Speed", speed),
        value("AngleOfAttack", degree),
        value("Path", degree),
        value("FaceToTarget", degree),
    ];
    let heads = [
        "ClubData.Speed",
        "ClubData.AngleOfAttack",
        "ClubData.Path",
        "ClubData.FaceToTarget",
    ];
    Club::measured(stated, heads, notes)
}

/// Removes a spin value of 0 that was not sent. A value of 0 was not sent if another form of the
/// spin is not 0.
fn remove_unsent(values: &mut Vec<StatedValue>) {
    let has = |of| {
        values
            .iter()
            .any(|value| value.of == of && value.value != 0.0)
    };
    let has_axis = values.iter().any(|value| value.of == Outcome::SpinAxis);
    let (has_total, has_back, has_side) = (
        has(Outcome::Spin),
        has(Outcome::Backspin),
        has(Outcome::Sidespin),
    );
    values.retain(|value| match value.of {
        Outcome::Spin => has_total || !has_back,
        Outcome::Backspin => has_back || !has_total,
        // keep a sidespin of 0 if there is a total spin without an axis: the sidespin gives the
        // axis
        Outcome::Sidespin => has_side || has_back || has_total && !has_axis,
        Outcome::SpinAxis => has_total || value.value != 0.0 || !has_side,
        _ => true,
    });
}
