//! A line that `fly` wrote as JSON lines, as the shot that it was made of.

use super::export::launch;
use super::objects::Objects;
use super::shot::{Club, Origin, Refusal, Shot, Value, of_conditions};
use crate::columns::is_straight_by_assumption;
use crate::drive::Outcome;
use serde_json::{Map, Value as Json};

/// What the row stands behind: the last member of a line, so that none of the others has it in its text.
const ROW: &str = ",\"row\":";

/// Whether a message is such a line.
pub(super) fn is_written(message: &Map<String, Json>) -> bool {
    ["stated", "predicted", "row"].iter().all(|key| message.contains_key(*key))
}

/// Whether a text begins with such a line.
pub(super) fn begins(beginning: &str) -> bool {
    let mut objects = Objects::default();
    objects.push(beginning.as_bytes());
    let first = objects.next_piece().and_then(|piece| serde_json::from_str::<Json>(&piece.text).ok());
    first.as_ref().and_then(Json::as_object).is_some_and(is_written)
}

fn wrong(key: &str, found: impl std::fmt::Display) -> Refusal {
    let reason = format!("{key}: {found} is not what 'fly' writes there; fly the file that the line was made of");
    Refusal::new(Refusal::JSON, reason)
}

/// The members of an object; none where it is missing.
fn members<'a>(message: &'a Map<String, Json>, key: &str) -> Result<Vec<(&'a String, &'a Json)>, Refusal> {
    match message.get(key) {
        None | Some(Json::Null) => Ok(vec![]),
        Some(Json::Object(members)) => Ok(members.iter().collect()),
        Some(other) => Err(wrong(key, other)),
    }
}

/// Takes what the line says of its shot. What was predicted is predicted anew.
///
/// # Errors
/// Why it cannot be flown.
pub(super) fn fill(shot: &mut Shot, message: &Map<String, Json>) -> Result<(), Refusal> {
    let text = message.get("row").map(Json::to_string).unwrap_or_default();
    // to the letter, where the line is as it was written
    let own = shot.text.split_once(ROW).and_then(|(_, row)| row.trim_end().strip_suffix('}'));
    shot.text = own.map_or(text, str::to_owned);
    let origins = members(message, "origins")?;
    for (name, value) in members(message, "stated")? {
        let (Ok(of), Some(value)) = (Outcome::named(name), value.as_f64()) else {
            return Err(wrong(&format!("stated.{name}"), value));
        };
        let origin = origins.iter().find(|(of, _)| *of == name).and_then(|(_, origin)| Origin::read(origin.as_str()?));
        shot.values.push(Value { of, value, origin });
    }
    let club = members(message, "club")?;
    let of_club = |name: &str| club.iter().find(|(key, _)| *key == name).and_then(|(_, value)| value.as_f64());
    let [speed, attack_angle, path, face_angle] = Club::NAMES.map(of_club);
    shot.club = Club { speed, attack_angle, path, face_angle };
    shot.condition = message.get("condition").and_then(Json::as_str).map(str::to_owned);
    shot.is_normalized = message.get("normalized").and_then(Json::as_bool).filter(|is| *is);
    let notes = message.get("notes").and_then(Json::as_array).into_iter().flatten();
    shot.notes = notes.filter_map(|note| note.as_str().map(str::to_owned)).collect();
    if message.get("flight").and_then(Json::as_str) == Some("refused") {
        let reason = message.get("reason").and_then(Json::as_str).unwrap_or("it was refused without a reason");
        return Err(Refusal::new(Refusal::BEFORE, reason));
    }
    if let Some((name, _)) = members(message, "parameters")?.first() {
        let reason = format!(
            "the row has a value of its own of {name}, which is not read from JSON lines; fly the table that it was made of"
        );
        return Err(Refusal::new(Refusal::JSON, reason));
    }
    let stated = of_conditions(|of| shot.value(of).map(|value| value.value));
    shot.is_straight_by_assumption = is_straight_by_assumption(&stated);
    shot.point = Ok(launch(&stated, |of| of.name().into(), |_| true)?);
    Ok(())
}
