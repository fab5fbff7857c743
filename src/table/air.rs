//! Air density of each shot, from an export.

use super::column::{Column, Content};
use super::decimal_mark::DecimalMark;
use super::heads::{AIR, is_condition_head};
use super::launch_monitor::words;
use super::numbers::number;
use crate::atmosphere::in_effect;
use crate::parameters::Setup;
use crate::units::Quantity;

/// Range of air density on golf courses, kg/m³: from a course at 5000 m on a hot day to the coast
/// at −40 °C.
const RANGE: [f64; 2] = [0.6, 1.6];

impl Column {
    /// True for a column in which an export states the air. False for a column with the head
    /// `air.density`, which is an ordinary parameter.
    pub fn is_stated_air(&self) -> bool {
        self.head != AIR
            && matches!(self.content, Content::Input(parameter) if parameter.name == AIR)
    }

    /// Parses the air density of a row, SI.
    ///
    /// # Errors
    /// A message, if the cell states no density, or a density that does not occur on golf courses.
    pub fn stated_air(&self, cell: &str) -> Result<f64, String> {
        let name = &self.head;
        if self.is_weather {
            return density_in(cell, self.format.decimal_mark).ok_or_else(|| {
                format!("{name}: the cell states no altitude and temperature that can be read")
            });
        }
        let density = self.value(cell).map_err(|why| format!("{name}: {why}"))?;
        let density = density.ok_or_else(|| format!("{name}: the cell is empty"))?;
        let [low, high] = RANGE;
        if (low..=high).contains(&density) {
            return Ok(density);
        }
        let shown = Quantity::DENSITY.show(density, "kg/m^3");
        Err(format!(
            "{name}: {shown} is outside of the range on golf courses, {low} to {high} kg/m^3"
        ))
    }
}

/// Air density, kg/m³, from TrackMan's weather text: `Normalized to no wind conditions at 1135 ft
/// altitude, 77 °F and Premium ball`. `None` without a valid altitude and temperature, and for a
/// number whose mark may separate decimals or thousands.
fn density_in(text: &str, of_table: Option<DecimalMark>) -> Option<f64> {
    let text = with_spaces(text);
    let words: Vec<&str> = text.split_whitespace().collect();
    let number_before = |at: usize| number_at_end(&words[..at], of_table);
    // the units in `1135 ft altitude` and `77 °F`
    let altitude = words.iter().position(|word| *word == "altitude")?;
    let altitude = altitude.checked_sub(1)?;
    let is_degrees = |word: &&str| ["°F", "°C", "F", "C"].contains(word);
    let temperature = words.iter().position(is_degrees)?;
    let degrees = if words[temperature].ends_with('F') {
        "degF"
    } else {
        "degC"
    };
    let stated = [
        (
            "air.altitude",
            format!("{} {}", number_before(altitude)?, words[altitude]),
        ),
        (
            "air.temperature",
            format!("{} {degrees}", number_before(temperature)?),
        ),
    ];
    let mut setup = Setup::<f64>::modern_driver();
    setup
        .set_all(stated.iter().map(|(name, value)| (*name, value.as_str())))
        .ok()?;
    setup.validate().ok()?;
    Some(in_effect(&setup).air.density)
}

/// Reads the column that states altitude and temperature, such as `Condition` of TrackMan, as the
/// air of each row: the head is known, and one of the first `rows` has a number. A column of the
/// density, or weather in the setup, replaces this air.
pub(super) fn weather_of_rows(setup: &Setup<f64>, columns: &mut [Column], rows: &[Vec<String>]) {
    let is_density = |column: &Column| match column.content {
        Content::Input(parameter) => parameter.name == AIR,
        _ => column.is_overridden_air,
    };
    if columns.iter().any(is_density) {
        return;
    }
    let has_number = |at: usize| {
        let is_digit = |c: char| c.is_ascii_digit();
        rows.iter().any(|row| row[at].contains(is_digit))
    };
    let is_known = |at: usize| is_condition_head(&words(&columns[at].head));
    let weather = (0..columns.len()).find(|at| is_known(*at) && has_number(*at));
    let (Some(at), Ok(density)) = (weather, setup.parameter(AIR)) else {
        return;
    };
    let column = &mut columns[at];
    if setup.why_replaced(density).is_some() {
        (column.content, column.is_overridden_air) = (Content::Note, true);
    } else {
        (column.content, column.is_weather) = (Content::Input(density), true);
    }
}

/// The text with a space before and after each comma and semicolon that is not in a number, and
/// between a number and its unit.
fn with_spaces(text: &str) -> String {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let mut spaced = String::with_capacity(text.len() + 8);
    let mut characters = text.chars().peekable();
    let mut before = None;
    while let Some(c) = characters.next() {
        let is_in_number = is_digit(before) && is_digit(characters.peek().copied());
        if c == ';' || c == ',' && !is_in_number {
            spaced.extend([' ', c, ' ']);
        } else {
            if is_digit(before) && (c == '\u{b0}' || c.is_alphabetic()) {
                spaced.push(' ');
            }
            spaced.push(c);
        }
        before = Some(c);
    }
    spaced
}

/// The number in the last of these words, in which spaces may separate thousands. `None` if the
/// words before it are part of no number, or if its mark may separate decimals or thousands.
fn number_at_end(words: &[&str], of_table: Option<DecimalMark>) -> Option<f64> {
    let is_part = |word: &&&str| {
        let digits = word.trim_start_matches(['+', '-', '\u{2212}']);
        digits.starts_with(|c: char| c.is_ascii_digit())
    };
    let count = words.iter().rev().take_while(is_part).count();
    let text = words[words.len() - count..].join(" ");
    if DecimalMark::ambiguity(of_table, &text).is_some() {
        return None;
    }
    number(&text, of_table != Some(DecimalMark::Point))
}

/// Message for exports that state the air of each row.
pub(crate) fn air_of_rows(head: &str) -> String {
    format!("each shot flies in the air that the export states for its row: {head}")
}

/// Message for exports that state the air of each row, if the setup gives the air.
pub(crate) fn air_replaced(head: &str) -> String {
    format!("the given air replaces the air that the export states for each row: {head}")
}

/// Ignores the columns in which an export states the air, because the setup gives the air.
pub(super) fn ignore_stated_air(columns: &mut [Column]) {
    for column in columns.iter_mut().filter(|column| column.is_stated_air()) {
        (column.content, column.is_overridden_air) = (Content::Note, true);
    }
}

/// Message for a row that states no valid air density. Its shot flies in the air of the setup.
pub(crate) fn air_of_setup(why: &str) -> String {
    format!("the air of the setup is assumed; {why}")
}
