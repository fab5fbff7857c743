//! The explorer's address for a setup: its part after `#` contains the setup.

use super::presets::{is_changed, preset_with_law_of};
use super::setup_file::exact;
use crate::error::{Error, Result};
use crate::parameters::{
    GOLFER, LAW, METHOD, Parameter, Preset, SPEED_OF, Setup, TABLE, is_of_step,
};
use crate::units::System;

/// Version of the format of the address.
const VERSION: &str = "1";

/// The state of the explorer for a setup: the text after `#` in the address of the explorer. The
/// text has the preset and each value that differs from the preset, in the syntax of `--set`. For
/// metric units it also has `units=metric`.
///
/// ```
/// use longdrive::{Setup, parameters::Preset, report::explorer_state, units::System};
/// let mut setup = Setup::preset("tour-average").unwrap();
/// setup.set_all([("swing.speed", "100 mph"), ("club.loft", "10.5 deg")]).unwrap();
/// let preset = Preset::named("tour-average").unwrap();
/// let state = explorer_state(&setup, preset, System::Us).unwrap();
/// assert_eq!(state, "1&tour-average&swing.speed=100mph&club.loft=10.5deg");
/// ```
///
/// # Errors
/// [`Error::Unreadable`] if the setup has a user's own table of drag and lift, because an address
/// cannot hold a table.
pub fn explorer_state(setup: &Setup<f64>, preset: &Preset, system: System) -> Result<String> {
    if let Some(table) = setup.law.table() {
        let source =
            "the explorer cannot have your own table; leave it out, or use a published law";
        return Err(Error::Unreadable {
            name: format!("{TABLE} {}", table.file),
            source: source.into(),
        });
    }
    let base = Setup::preset(preset.name)?;
    let units = (system == System::Metric).then(|| ("units", "metric".to_owned()));
    let values = changed_choices(setup, &base)
        .chain(changed_numbers(setup, preset, system)?)
        .chain(units);
    let parts: Vec<_> = values
        .map(|(name, value)| format!("&{name}={}", encoded(&compact(&value))))
        .collect();
    Ok(format!("{VERSION}&{}{}", preset.name, parts.concat()))
}

fn changed_choices(
    setup: &Setup<f64>,
    base: &Setup<f64>,
) -> impl Iterator<Item = (&'static str, String)> {
    let is_struck = !setup.launch.is_given();
    let is_other_step = setup.states_step && !base.states_step || setup.method != base.method;
    [
        (LAW, setup.law.name() != base.law.name()),
        (GOLFER, is_struck && setup.golfer != base.golfer),
        (SPEED_OF, is_struck && setup.speed_of != base.speed_of),
        (METHOD, is_other_step),
    ]
    .into_iter()
    .filter(|(_, is_changed)| *is_changed)
    .filter_map(|(name, _)| Some((name, setup.choice(name)?.to_owned())))
}

fn changed_numbers(
    setup: &Setup<f64>,
    preset: &Preset,
    system: System,
) -> Result<impl Iterator<Item = (&'static str, String)>> {
    let base = preset_with_law_of(setup, preset)?;
    let states_step = setup.states_step && !base.states_step;
    // the program refuses parameters of the strike if the launch is stated
    let is_used = |row: &Parameter| !(setup.launch.is_given() && row.is_of_strike());
    let is_stated = move |row: &&'static Parameter| {
        is_used(row) && is_changed(setup, &base, row) || states_step && is_of_step(row.name)
    };
    let rows = setup.parameters().into_iter().filter(is_stated);
    Ok(rows.map(move |row| {
        (
            row.name,
            exact(row, setup.value(row), system.unit(row.unit)),
        )
    }))
}

/// A value without the space before its unit: "10.5deg".
fn compact(value: &str) -> String {
    let is_of_number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    match value.split_once(' ') {
        Some((number, unit)) if number.chars().all(is_of_number) => number.to_owned() + unit,
        _ => value.to_owned(),
    }
}

/// A text with percent escapes (RFC 3986) for the characters that an address must not have, and for
/// the characters that separate the parts of the state.
fn encoded(text: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.~,:/".contains(&byte);
    let encoded = |byte: u8| match is_plain(byte) {
        true => char::from(byte).to_string(),
        false => format!("%{byte:02X}"),
    };
    text.bytes().map(encoded).collect()
}
