//! Air density of each shot, from an export.

use super::column::{Column, Content};
use super::heads::AIR;
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
            return density_in(cell)
                .ok_or_else(|| format!("{name}: the cell states no altitude and temperature"));
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
/// altitude, 77 °F and Premium ball`. `None` without a valid altitude and temperature.
pub(crate) fn density_in(words: &str) -> Option<f64> {
    let words: Vec<&str> = words
        .split([' ', ',', ';'])
        .filter(|word| !word.is_empty())
        .collect();
    let number_before = |at: usize| words.get(at.checked_sub(1)?)?.parse::<f64>().ok();
    let altitude = words.iter().position(|word| *word == "altitude")?;
    let altitude_unit = *words.get(altitude.checked_sub(1)?)?;
    let is_degrees = |word: &&str| ["°F", "°C", "F", "C"].contains(word);
    let temperature = words.iter().position(is_degrees)?;
    let temperature_unit = if words[temperature].ends_with('F') {
        "degF"
    } else {
        "degC"
    };
    let stated = [
        (
            "air.altitude",
            format!("{} {altitude_unit}", number_before(altitude - 1)?),
        ),
        (
            "air.temperature",
            format!("{} {temperature_unit}", number_before(temperature)?),
        ),
    ];
    let mut setup = Setup::<f64>::default();
    setup
        .set_all(stated.iter().map(|(name, value)| (*name, value.as_str())))
        .ok()?;
    setup.validate().ok()?;
    Some(in_effect(&setup).air.density)
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
pub(crate) fn ignore_stated_air(columns: &mut [Column]) {
    for column in columns.iter_mut().filter(|column| column.is_stated_air()) {
        (column.content, column.is_overridden_air) = (Content::Note, true);
    }
}

/// Message for a row that states no valid air density. Its shot flies in the air of the setup.
pub(crate) fn air_of_setup(why: &str) -> String {
    format!("the air of the setup is assumed; {why}")
}
