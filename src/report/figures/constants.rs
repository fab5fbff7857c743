//! The subtitle of a plot of optima: the parameters that are constant in the plot.

use crate::parameters::{Preset, Setup};
use crate::report::presets::used_changes;
use crate::report::shown;
use crate::units::System;

/// Maximum number of changed parameters that a subtitle names. The others are as set up, which the
/// subtitle says of all that it does not name.
const NAMED: usize = 6;

/// The subtitle: "at club speed 92 mph, attack angle −3°, all else as set up". It names the speed
/// and the differences between the setup and its preset, then `further` constants. `varies` is true
/// for the names of parameters that are not constant.
pub(super) fn subtitle(
    setup: &Setup<f64>,
    preset: &Preset,
    varies: impl Fn(&str) -> bool,
    further: Option<String>,
    system: System,
) -> String {
    const REST: &str = "all else as set up";
    let speed = if setup.launch.is_given() {
        "launch.ball_speed"
    } else {
        "swing.speed"
    };
    let speed_text = setup.variable(speed).ok().and_then(|row| {
        let value = shown::stated(row, setup.value(row)?, system);
        Some(format!("{} {value}", shown::words(row.name)))
    });
    // no error occurs: every preset is read in a test
    let changed = used_changes(setup, preset, system).unwrap_or_default();
    let changed = changed.into_iter();
    let changed = changed.filter(|change| change.key != speed && !varies(change.key));
    let changed = changed.map(|change| format!("{} {}", change.name, change.to));
    let constants: Vec<String> = speed_text
        .filter(|_| !varies(speed))
        .into_iter()
        .chain(changed.take(NAMED))
        .chain(further)
        .collect();
    if constants.is_empty() {
        return REST.into();
    }
    format!("at {}, {REST}", constants.join(", "))
}
