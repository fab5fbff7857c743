//! Flown shots as JSON lines, in SI.

#[cfg(test)]
use super::super::json::{ByName, JsonNumber};
use crate::drive::Outcome;
#[cfg(test)]
use crate::shots::Origin;
use crate::shots::{Club, Flown, Section, Shot, ShotColumns, Shots};
use crate::table::cells;
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// The keys of the launch, in the order of [`crate::shots::Shot::launch`].
const LAUNCH: [&str; 5] = [
    "ball_speed",
    "launch_angle",
    "launch_direction",
    "backspin",
    "sidespin",
];

/// The keys of a line.
#[derive(Clone, Debug)]
pub(super) struct Keys {
    of: Vec<Outcome>,
    /// Parameters that are not part of the launch; every row has a value of each.
    other_parameters: Vec<&'static str>,
    /// The columns of the export, with the JSON key of each; `None` for shots that came as JSON
    /// messages.
    cells: Option<(Arc<ShotColumns>, Vec<String>)>,
}

/// A shot, SI and radians.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
pub struct FlyRow {
    /// The line of the file in which the row begins.
    #[schemars(range(min = 1))]
    line: u64,
    /// The status of the drive; `refused` if the row is not flown.
    #[schemars(extend("enum" = [&["refused"][..], &crate::batch::Status::NAMES].concat()))]
    flight: String,
    /// The reason why the row has no predicted outcomes; `null` if it has them.
    reason: Option<String>,
    /// Notes on assumed values, and on measured values that are not compared with predictions.
    notes: Vec<String>,
    /// True if the export states that its values are normalized; `null` if it states nothing.
    #[schemars(extend("enum" = [true, null]))]
    normalized: Option<bool>,
    /// The launch that is flown; `null` for a refused row.
    #[schemars(extend("required" = LAUNCH))]
    launch: Option<ByOutcome<JsonNumber>>,
    /// The parameters that the row states in addition to the launch.
    parameters: ByName<JsonNumber>,
    /// The delivery of the club that the row states.
    #[schemars(extend("propertyNames" = { "enum": Club::NAMES }))]
    club: ByName<JsonNumber>,
    /// The name of the club that the row states.
    club_name: Option<String>,
    /// The conditions for which the export states its values.
    condition: Option<String>,
    /// The outcomes that the row states, including the launch.
    stated: ByOutcome<JsonNumber>,
    /// The origins of stated outcomes, if the export states them.
    origins: ByOutcome<Origin>,
    /// The predicted outcomes.
    predicted: ByOutcome<JsonNumber>,
    /// The residuals, predicted − measured.
    residual: ByOutcome<JsonNumber>,
    /// The row as in the file: the cells by their column heads, the message if the shot came as a
    /// message, or the text if it cannot be divided into cells.
    #[schemars(extend("type" = ["object", "string"]))]
    row: serde_json::Value,
}

/// Schema of values by outcome name. The request chooses the outcomes.
#[cfg(test)]
struct ByOutcome<V>(std::marker::PhantomData<V>);

#[cfg(test)]
impl<V: schemars::JsonSchema> schemars::JsonSchema for ByOutcome<V> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("ByOutcome_of_{}", V::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "object",
            "propertyNames": generator.subschema_for::<Outcome>(),
            "additionalProperties": generator.subschema_for::<V>()
        })
    }
}

/// Appends a value as JSON. A number that is not finite is `null`.
fn push(bytes: &mut Vec<u8>, value: impl Serialize) {
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &value);
}

fn push_object<'a, V: Serialize>(bytes: &mut Vec<u8>, entries: impl Iterator<Item = (&'a str, V)>) {
    // writing to memory does not fail
    let _ = serde_json::Serializer::new(bytes).collect_map(entries);
}

fn push_numbers<'a>(bytes: &mut Vec<u8>, of: impl Iterator<Item = (&'a str, Option<f64>)>) {
    // the sum turns -0 into 0
    let numbers = of.map(|(name, value)| (name, value.map(|value| value + 0.0)));
    push_object(bytes, numbers);
}

impl Keys {
    pub fn new(shots: &Shots, of: &[Outcome]) -> Self {
        Self {
            of: of.to_vec(),
            other_parameters: shots.other_parameters.iter().map(|row| row.name).collect(),
            cells: None,
        }
    }

    /// The keys of rows in a section of a table.
    pub fn of_section(&self, section: &Section) -> Self {
        let columns = &section.columns;
        let heads = &columns.head.heads;
        // a repeated column head gets a number
        let key = |(at, head): (usize, &String)| {
            let before = heads[..at].iter().filter(|other| *other == head).count();
            if before == 0 {
                head.clone()
            } else {
                format!("{head} ({})", before + 1)
            }
        };
        let keys = heads.iter().enumerate().map(key).collect();
        Self {
            of: self.of.clone(),
            other_parameters: columns
                .other_parameters
                .iter()
                .map(|row| row.name)
                .collect(),
            cells: Some((columns.clone(), keys)),
        }
    }

    pub fn row(&self, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
        let shot = &flown.shots[row];
        let flight = flown.flight(row);
        let start = format!("{{\"line\":{},\"flight\":\"{flight}\",", shot.line);
        bytes.extend_from_slice(start.as_bytes());
        bytes.extend_from_slice(b"\"reason\":");
        push(bytes, flown.reason(row));
        bytes.extend_from_slice(b",\"notes\":");
        push(bytes, &shot.notes);
        self.measured(shot, bytes);
        let outcomes = || self.of.iter().enumerate();
        bytes.extend_from_slice(b",\"predicted\":");
        push_numbers(
            bytes,
            outcomes().map(|(at, of)| (of.name(), flown.predicted(row, at))),
        );
        bytes.extend_from_slice(b",\"residual\":");
        push_numbers(
            bytes,
            outcomes().map(|(at, of)| (of.name(), flown.residual(row, at))),
        );
        bytes.extend_from_slice(b",\"row\":");
        let refusal = shot.refusal();
        let is_unreadable = refusal.is_some_and(|refusal| refusal.is_unreadable());
        self.own(shot.text.as_str(), is_unreadable, bytes);
        bytes.push(b'}');
    }

    /// Appends the members from `normalized` to `origins`: the values that the row states.
    fn measured(&self, shot: &Shot, bytes: &mut Vec<u8>) {
        let normalized: &[u8] = match shot.is_normalized {
            true => b",\"normalized\":true,\"launch\":",
            false => b",\"normalized\":null,\"launch\":",
        };
        bytes.extend_from_slice(normalized);
        match shot.launch() {
            Some(launch) => {
                let launch = launch.iter().map(|value| Some(*value));
                push_numbers(bytes, LAUNCH.into_iter().zip(launch));
            }
            None => bytes.extend_from_slice(b"null"),
        }
        bytes.extend_from_slice(b",\"parameters\":");
        let other_parameters = shot.other_parameters().iter().map(|value| Some(*value));
        push_numbers(
            bytes,
            self.other_parameters.iter().copied().zip(other_parameters),
        );
        bytes.extend_from_slice(b",\"club\":");
        let club = Club::NAMES
            .into_iter()
            .zip(shot.club.values())
            .filter(|(_, value)| value.is_some());
        push_numbers(bytes, club);
        bytes.extend_from_slice(b",\"club_name\":");
        push(bytes, &shot.club_name);
        bytes.extend_from_slice(b",\"condition\":");
        push(bytes, &shot.condition);
        bytes.extend_from_slice(b",\"stated\":");
        let stated = shot.values.iter();
        push_numbers(
            bytes,
            stated.map(|value| (value.of.name(), Some(value.value))),
        );
        bytes.extend_from_slice(b",\"origins\":");
        let origins = shot.values.iter();
        let origins = origins.filter_map(|value| Some((value.of.name(), value.origin?.name())));
        push_object(bytes, origins);
    }

    fn own(&self, row: &str, is_unreadable: bool, bytes: &mut Vec<u8>) {
        match &self.cells {
            _ if is_unreadable => push(bytes, row),
            // put the message on one line: a JSON string cannot contain a line break, so that each
            // line break is white space
            None => bytes.extend(row.bytes().map(|byte| {
                if matches!(byte, b'\n' | b'\r') {
                    b' '
                } else {
                    byte
                }
            })),
            Some((columns, keys)) => {
                push_object(
                    bytes,
                    keys.iter()
                        .map(String::as_str)
                        .zip(cells(row, columns.separator)),
                );
            }
        }
    }
}
