//! Interpretation of an export: its maker, missing units, and sign conventions.

use super::sign_conventions::turn_spins;
use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::table::{
    Column, Content, TableHead, assume_unit, density_in, is_condition_head, split_unit, words,
};

/// Each maker, with column heads (in lower case) that occur together only in exports of this maker.
/// Sources: docs/sources.md.
const SIGNATURES: [(&str, &[&str]); 16] = [
    ("TrackMan", &["carry flat length"]),
    ("TrackMan", &["tmd no"]),
    ("TrackMan", &["dyn loft", "spin rate"]),
    ("TrackMan", &["dynamic loft", "landing angle", "hang time"]),
    ("Garmin", &["carry deviation distance"]),
    ("Garmin", &["carry abweichungsdistanz"]),
    ("FlightScope", &["launch v", "launch h"]),
    ("FlightScope", &["launch angle v", "height"]),
    ("Foresight", &["push pull", "peak height"]),
    ("Foresight", &["tilt angle", "total spin"]),
    ("Foresight", &["side angle", "offline", "face to target"]),
    ("Foresight", &["azimuth", "offline"]),
    ("Rapsodo", &["side carry", "club type"]),
    ("Uneekor", &["side angle", "side distance"]),
    ("Square", &["index", "offline", "dynamic loft"]),
    (
        "Awesome Golf",
        &[
            "vertical launch",
            "horizontal launch",
            "carry lateral distance",
        ],
    ),
];

/// Interpretation of an export.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interpretation {
    /// Maker, if the column heads identify it.
    pub maker: Option<&'static str>,
    /// Columns without a unit, each with the assumed unit.
    pub assumed_units: Vec<String>,
    /// Message about columns whose positive values are to the left.
    pub turned: Option<String>,
}

impl Interpretation {
    /// Interprets the columns of an export: changes contents, units and signs of the columns in
    /// `head`. A table that is not an export stays unchanged. With a `setup`, a column that states
    /// the weather determines the air of each row.
    pub fn of(setup: Option<&Setup<f64>>, head: &mut TableHead) -> Self {
        if !head.format.is_export {
            return Self::default();
        }
        let plain: Vec<String> = head
            .heads
            .iter()
            .map(|head| words(split_unit(head).0))
            .collect();
        let has = |head: &&str| plain.iter().any(|other| other == head);
        let signature = SIGNATURES.iter().find(|(_, all)| all.iter().all(has));
        let maker = signature.map(|(maker, _)| *maker);
        let (columns, rows) = (&mut head.columns, &head.rows);
        if maker == Some("Foresight") {
            // `Offline` is the lateral position at rest
            for column in columns
                .iter_mut()
                .filter(|column| words(&column.head) == "offline")
            {
                column.content = Content::Outcome(Outcome::LateralTotal);
            }
        }
        if let Some(setup) = setup {
            weather_of_rows(setup, &plain, columns, rows);
        }
        let assumed_units = columns
            .iter_mut()
            .enumerate()
            .filter_map(|(at, column)| assume_unit(at, column, rows))
            .collect();
        Self {
            maker,
            assumed_units,
            turned: turn_spins(maker, columns, rows),
        }
    }
}

/// TrackMan's column `Condition` states altitude and temperature, which determine the air of each
/// row. A column of the density, or weather in the setup, replaces this air.
fn weather_of_rows(
    setup: &Setup<f64>,
    plain: &[String],
    columns: &mut [Column],
    rows: &[Vec<String>],
) {
    let Ok(density) = setup.parameter("air.density") else {
        return;
    };
    if columns
        .iter()
        .any(|column| column.is_stated_air() || column.is_overridden_air)
    {
        return;
    }
    let is_condition = |at: &usize| is_condition_head(&plain[*at]);
    let states_weather = |at: &usize| rows.iter().any(|row| density_in(&row[*at]).is_some());
    if let Some(at) = (0..columns.len()).filter(is_condition).find(states_weather) {
        let column = &mut columns[at];
        if setup.why_replaced(density).is_some() {
            (column.content, column.is_overridden_air) = (Content::Note, true);
        } else {
            (column.content, column.is_weather) = (Content::Input(density), true);
        }
    }
}
