//! Interpretation of an export: missing units, and the air of each row.

use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::table::{Column, Content, TableHead, TableUse, assume_unit, weather_column, words};

/// Interprets the columns of an export: changes contents and units of the columns in `head`. A
/// table that is not an export stays unchanged. If each row may state its own air, a column that
/// states the weather determines this air. Returns the columns without a unit, each with the assumed unit.
pub(crate) fn interpret(
    setup: &Setup<f64>,
    head: &mut TableHead,
    table_use: TableUse,
) -> Vec<String> {
    if !head.format.is_export {
        return vec![];
    }
    let (columns, rows) = (&mut head.columns, &head.rows);
    if head.maker == Some("Foresight") {
        // `Offline` is the lateral position at rest
        for column in columns
            .iter_mut()
            .filter(|column| words(&column.head) == "offline")
        {
            column.content = Content::Outcome(Outcome::LateralTotal);
        }
    }
    if table_use.has_air_of_rows() {
        weather_of_rows(setup, columns, rows);
    }
    columns
        .iter_mut()
        .enumerate()
        .filter_map(|(at, column)| assume_unit(at, column, rows))
        .collect()
}

/// TrackMan's column `Condition` states altitude and temperature, which determine the air of each
/// row. A column of the density, or weather in the setup, replaces this air.
fn weather_of_rows(setup: &Setup<f64>, columns: &mut [Column], rows: &[Vec<String>]) {
    let Ok(density) = setup.parameter("air.density") else {
        return;
    };
    if let Some(at) = weather_column(columns, rows) {
        let column = &mut columns[at];
        if setup.why_replaced(density).is_some() {
            (column.content, column.is_overridden_air) = (Content::Note, true);
        } else {
            (column.content, column.is_weather) = (Content::Input(density), true);
        }
    }
}
