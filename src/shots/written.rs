//! Reads shots back from JSON lines that `fly` wrote.

use super::export::launch;
use super::objects::Objects;
use super::shot::{Club, Origin, REFUSED, Shot, StatedValue, within};
use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup};
use crate::table::Refusal;
use serde_json::{Map, Value as Json};

/// The text before the original row, which is the last member of a line. `fly` writes no such text
/// earlier in a line.
const ROW: &str = ",\"row\":";

/// Recognizes a JSON line written by `fly`.
pub(super) fn is_written(message: &Map<String, Json>) -> bool {
    ["stated", "predicted", "row"]
        .iter()
        .all(|key| message.contains_key(*key))
}

/// True if `fly` wrote the first line of a text.
pub(super) fn begins(beginning: &str) -> bool {
    let mut objects = Objects::default();
    objects.push(beginning.as_bytes());
    let first = objects
        .next_record()
        .and_then(|piece| serde_json::from_str::<Json>(&piece.text).ok());
    first
        .as_ref()
        .and_then(Json::as_object)
        .is_some_and(is_written)
}

/// The parameters that a flown shot states in addition to its launch; empty for a message of Open
/// Connect. `None` for a line that `fly` refused, and for a text that is not a JSON object.
pub(super) fn other_parameters(setup: &Setup<f64>, text: &str) -> Option<Vec<&'static Parameter>> {
    let message: Map<String, Json> = serde_json::from_str(text).ok()?;
    if !is_written(&message) {
        return Some(vec![]);
    }
    if is_refused(&message) {
        return None;
    }
    let own = message.get("parameters").and_then(Json::as_object);
    let names = own.into_iter().flat_map(Map::keys);
    Some(
        names
            .filter_map(|name| setup.parameter(name).ok())
            .collect(),
    )
}

/// True for the line of a row that `fly` refused.
fn is_refused(message: &Map<String, Json>) -> bool {
    message.get("flight").and_then(Json::as_str) == Some(REFUSED)
}

fn wrong(key: &str, found: impl std::fmt::Display) -> Refusal {
    let reason = format!(
        "{key}: {found} is not a value that 'fly' writes here; fly the original file of this line"
    );
    Refusal::new(Refusal::JSON, reason)
}

/// Members of the object stored under a key; empty if the key is missing.
fn members<'a>(
    message: &'a Map<String, Json>,
    key: &str,
) -> Result<Vec<(&'a String, &'a Json)>, Refusal> {
    match message.get(key) {
        None | Some(Json::Null) => Ok(vec![]),
        Some(Json::Object(members)) => Ok(members.iter().collect()),
        Some(other) => Err(wrong(key, other)),
    }
}

/// Reads the shot of a line, without its predictions.
///
/// # Errors
/// The reason why the shot cannot be flown.
pub(super) fn fill(
    shot: &mut Shot,
    message: &Map<String, Json>,
    other_parameters: &[&'static Parameter],
) -> Result<(), Refusal> {
    let text = message.get("row").map(Json::to_string).unwrap_or_default();
    // copy the text of the original row from the line, so that no byte changes
    let own = shot
        .text
        .split_once(ROW)
        .and_then(|(_, row)| row.trim_end().strip_suffix('}'));
    shot.text = own.map_or(text, str::to_owned);
    read_stated(shot, message)?;
    if is_refused(message) {
        let reason = message
            .get("reason")
            .and_then(Json::as_str)
            .unwrap_or("it was refused without a reason");
        return Err(Refusal::new(Refusal::BEFORE, reason));
    }
    shot.point = Ok(point(shot, message, other_parameters)?);
    Ok(())
}

fn read_stated(shot: &mut Shot, message: &Map<String, Json>) -> Result<(), Refusal> {
    let origins = members(message, "origins")?;
    for (name, value) in members(message, "stated")? {
        let (Ok(of), Some(value)) = (Outcome::named(name), value.as_f64()) else {
            return Err(wrong(&format!("stated.{name}"), value));
        };
        let origin = origins
            .iter()
            .find(|(of, _)| *of == name)
            .and_then(|(_, origin)| Origin::read(origin.as_str()?));
        shot.values.push(StatedValue { of, value, origin });
    }
    shot.club = club(message)?;
    let text = |key: &str| message.get(key).and_then(Json::as_str).map(str::to_owned);
    shot.club_name = text("club_name");
    shot.condition = text("condition");
    shot.is_normalized = message.get("normalized") == Some(&Json::Bool(true));
    let notes = message
        .get("notes")
        .and_then(Json::as_array)
        .into_iter()
        .flatten();
    shot.notes = notes
        .filter_map(|note| note.as_str().map(str::to_owned))
        .collect();
    Ok(())
}

fn club(message: &Map<String, Json>) -> Result<Club, Refusal> {
    let mut values = [None; Club::NAMES.len()];
    for (name, value) in members(message, "club")? {
        let at = Club::NAMES.iter().position(|known| known == name);
        let (Some(at), Some(value)) = (at, value.as_f64()) else {
            return Err(wrong(&format!("club.{name}"), value));
        };
        values[at] = Some(value);
    }
    Ok(Club::of(values))
}

/// Input of the flight of a line, SI: the launch parameters, then `other_parameters`.
fn point(
    shot: &Shot,
    message: &Map<String, Json>,
    other_parameters: &[&'static Parameter],
) -> Result<Vec<f64>, Refusal> {
    let own = members(message, "parameters")?;
    if let Some((name, _)) = own.iter().find(|(name, _)| {
        other_parameters
            .iter()
            .all(|parameter| parameter.name != *name)
    }) {
        let reason = format!(
            "the line has a value of {name}, but the first line has none; fly the original table \
             of these lines"
        );
        return Err(Refusal::new(Refusal::JSON, reason));
    }
    let mut point = launch(&shot.conditions(), |of| of.name().into(), |_| true)?;
    for parameter in other_parameters {
        let name = format!("parameters.{}", parameter.name);
        let value = own.iter().find(|(own, _)| *own == parameter.name);
        let value = value.and_then(|(_, value)| value.as_f64());
        let reason =
            || format!("{name} is missing; every row needs a value, since the first row has one");
        let value = value.ok_or_else(|| Refusal::new(Refusal::MISSING, reason()))?;
        point.push(within(parameter, value, &name)?);
    }
    Ok(point)
}
