//! What a launch monitor's columns mean: whose export it is, the units that it leaves out, and the sides that are its own.

use super::maker::maker;
use super::sides::Turned;
use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::table::{Column, Head, Holds, TextTable, cells, split_unit, states_weather, unstated, words};

/// What was found of an export.
#[derive(Clone, Debug, Default)]
pub(crate) struct Meant {
    /// Whose it is, where its heads tell.
    pub maker: Option<&'static str>,
    /// The units that are taken for granted.
    pub without_unit: Option<String>,
    /// The columns whose + is to the left.
    pub turned: Option<String>,
}

impl Meant {
    /// What the columns of an export mean, which are changed accordingly; nothing of a table that is none. `setup` has the air that is given, where the
    /// air of the rows matters.
    pub fn found(setup: Option<&Setup<f64>>, head: &mut Head, table: &TextTable) -> Self {
        if !head.format.is_export {
            return Self::default();
        }
        let plain: Vec<String> = head.heads.iter().map(|head| words(split_unit(head).0)).collect();
        let maker = maker(&plain);
        if maker == Some("Foresight") {
            rests_offline(&mut head.columns);
        }
        let rows = rows(table, head.heads.len());
        let states_unit = |at: usize, column: &Column| rows.iter().any(|row| column.has_unit_in(&row[at]));
        if let Some(setup) = setup {
            weather_of_rows(setup, &plain, &mut head.columns, &rows);
        }
        let without_unit = unstated(&mut head.columns, states_unit);
        let turned = Turned::found(maker, &head.columns, &rows);
        turned.turn(&mut head.columns);
        Self { maker, without_unit, turned: turned.told(&head.columns) }
    }
}

/// In TrackMan's exports the condition of a row says at which altitude and temperature it is meant: the air of the row, where no column states its
/// density and the setup no weather.
fn weather_of_rows(setup: &Setup<f64>, plain: &[String], columns: &mut [Column], rows: &[Vec<String>]) {
    let Ok(density) = setup.parameter("air.density") else { return };
    if columns.iter().any(|column| column.is_stated_air() || column.is_of_given_air()) {
        return;
    }
    let is_condition = |at: &usize| ["condition", "conditions"].contains(&plain[*at].as_str());
    let states_weather = |at: &usize| rows.iter().any(|row| states_weather(&row[*at]));
    if let Some(at) = (0..columns.len()).filter(is_condition).find(states_weather) {
        let column = columns[at].clone();
        let is_given = setup.why_replaced(density).is_some();
        columns[at] = if is_given { column.of_given_air() } else { column.of_weather(density) };
    }
}

/// So many rows at the beginning are looked at.
const MOST_ROWS: usize = 200;

/// The rows at the beginning of a table that have so many cells.
fn rows(table: &TextTable, width: usize) -> Vec<Vec<String>> {
    let row = |line: &str| cells(line, table.separator).into_iter().map(String::from).collect::<Vec<_>>();
    table.beginning.lines().map(row).filter(|row| row.len() >= width).take(MOST_ROWS).collect()
}

/// In Foresight's exports `Offline` is where the ball comes to rest.
fn rests_offline(columns: &mut [Column]) {
    for column in columns.iter_mut().filter(|column| words(&column.head) == "offline") {
        column.holds = Holds::Outcome(Outcome::LateralTotal);
    }
}
