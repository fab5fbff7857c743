use super::document::{Document, DocumentTable, Line};
use super::json::{ByName, Settings, settings};
use super::reply::Report;
use super::shown;
use crate::error::Result;
use crate::parameters::{
    GOLFER, LAW, METHOD, PRESETS, Parameter, Preset, SPEED_OF, Setup, SetupFile, TABLE,
    is_of_strike,
};
use crate::units::System;
use serde::Serialize;
use std::borrow::Cow;
use std::ffi::OsStr;
use std::path::Path;

/// A value of a setup with its source.
#[derive(Clone, Debug)]
pub(super) struct SourcedValue {
    /// The parameter or choice.
    pub name: &'static str,
    /// The value as text.
    pub value: String,
    /// The source of the value, or a remark.
    pub source: Cow<'static, str>,
}

impl SourcedValue {
    fn new(
        name: &'static str,
        value: impl Into<String>,
        source: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            name,
            value: value.into(),
            source: source.into(),
        }
    }
}

/// A row of a setup file.
enum SetupRow {
    Number(&'static Parameter),
    Choice(&'static str),
}

/// The rows of a setup in the order of a setup file: the parameters, with each choice next to the
/// related numbers. A turf has no row, because its numbers have rows.
fn setup_rows(setup: &Setup<f64>) -> Vec<SetupRow> {
    let mut rows = vec![SetupRow::Choice(GOLFER)];
    let mut has_law = false;
    for parameter in setup.parameters() {
        if parameter.name.starts_with("aero.") && !has_law {
            has_law = true;
            rows.extend([LAW, TABLE].map(SetupRow::Choice));
        }
        if parameter.name == "flight.step" {
            rows.push(SetupRow::Choice(METHOD));
        }
        rows.push(SetupRow::Number(parameter));
        if parameter.name == "swing.speed" {
            rows.push(SetupRow::Choice(SPEED_OF));
        }
    }
    rows
}

/// The source of a choice that a preset does not change.
fn source_of_default(choice: &str) -> &'static str {
    match choice {
        LAW => "fitted to launch monitors' predictions; smooth, with the right apex and descent",
        METHOD => "the classical method, which the sources use",
        SPEED_OF => "as radars state it, within millimetres",
        GOLFER => "right-handed, like the golfers of the sources",
        _ => "",
    }
}

/// The values of a preset with their sources. A value that the preset does not change has the
/// source of the default.
pub(super) fn sourced(preset: &Preset, setup: &Setup<f64>) -> Vec<SourcedValue> {
    let entry = |name: &str| preset.entries.iter().find(|entry| entry.name == name);
    let sourced = |row: SetupRow| match row {
        SetupRow::Number(row) => Some(match entry(row.name) {
            Some(entry) => SourcedValue::new(row.name, entry.value, entry.source),
            None => SourcedValue::new(row.name, row.default, row.source),
        }),
        SetupRow::Choice(name) => {
            let source = entry(name).map_or(source_of_default(name), |entry| entry.source);
            Some(SourcedValue::new(name, setup.choice(name)?, source))
        }
    };
    setup_rows(setup).into_iter().filter_map(sourced).collect()
}

/// The values of a setup with their sources. The values are in the units of `system`; if `system`
/// is `None`, they are in their declared units.
///
/// The source of a value is the first of these:
///
/// 1. the comment on the value in `file`, if the setup still has the value of `file`
/// 2. the source in the preset, if the setup still has the value of the preset
/// 3. "as given, instead of" the value of the preset
pub(super) fn sources(
    setup: &Setup<f64>,
    file: &SetupFile,
    system: Option<System>,
) -> Result<Vec<SourcedValue>> {
    let base = Setup::preset(file.preset.name)?;
    let known = sourced(file.preset, &base);
    let comment = |name: &str, is_of_file: bool| {
        let comment = file.remarks.get(name).filter(|_| is_of_file);
        comment.cloned().map(Cow::from)
    };
    let source = |name: &str, is_kept: bool| -> Cow<'static, str> {
        match known.iter().find(|known| known.name == name) {
            None => "as given".into(),
            Some(known) if is_kept => known.source.clone(),
            Some(known) => instead_of(known, &base, system).into(),
        }
    };
    let set = |row: &Parameter, value: Option<f64>| match system {
        Some(system) => shown::setup_value(row, value, system, shown::IN_LIST),
        None => row.show(value),
    };
    let number = |row: &'static Parameter| {
        let value = setup.value(row);
        // a coefficient of a law other than the preset's has its own default and source
        let source = match base.parameter(row.name) {
            Ok(known) if known == row => source(row.name, base.value(row) == value),
            _ if value == row.default_value() => row.source.into(),
            _ => format!("as given, instead of {}", set(row, row.default_value())).into(),
        };
        let in_file = file.setup.parameter(row.name);
        let is_of_file = in_file.is_ok_and(|known| known == row && file.setup.value(row) == value);
        let source = comment(row.name, is_of_file).unwrap_or(source);
        SourcedValue::new(row.name, set(row, value), source)
    };
    let choice = |name: &'static str| {
        let own = setup.choice(name)?;
        let comment = comment(name, file.setup.choice(name) == Some(own));
        let source = comment.unwrap_or_else(|| source(name, base.choice(name) == Some(own)));
        Some(SourcedValue::new(name, own, source))
    };
    let row = |row: SetupRow| match row {
        // omit a parameter that other parameters determine
        SetupRow::Number(row) if setup.why_replaced(row).is_some() => None,
        SetupRow::Number(row) => Some(number(row)),
        SetupRow::Choice(name) => choice(name),
    };
    Ok(setup_rows(setup).into_iter().filter_map(row).collect())
}

/// The source of a changed value: "as given", with the value of the preset `base`.
fn instead_of(known: &SourcedValue, base: &Setup<f64>, system: Option<System>) -> String {
    let number = base
        .parameter(known.name)
        .ok()
        .zip(system)
        .map(|(row, system)| shown::setup_value(row, base.value(row), system, shown::IN_LIST));
    format!(
        "as given, instead of {}",
        number.unwrap_or_else(|| known.value.clone())
    )
}

/// A number or choice that differs from the preset's, formatted for display.
pub struct ChangedSetting {
    /// The parameter or choice.
    pub key: &'static str,
    /// The name in words.
    pub name: String,
    /// The value in the preset.
    pub from: String,
    /// The value in the setup.
    pub to: String,
}

/// The differences between a setup and its preset, in the units of a system.
///
/// ```
/// use longdrive::parameters::Preset;
/// use longdrive::{Setup, report::changes, units::System};
/// let mut setup = Setup::preset("mae494").unwrap();
/// setup.set("club.loft", "11 deg").unwrap();
/// let changed = changes(&setup, Preset::named("mae494").unwrap(), System::Us).unwrap();
/// assert_eq!((changed.len(), &changed[0].from[..], &changed[0].to[..]), (1, "10°", "11°"));
/// ```
///
/// # Errors
/// No error occurs in practice: a test reads all presets.
pub fn changes(setup: &Setup<f64>, preset: &Preset, system: System) -> Result<Vec<ChangedSetting>> {
    let base = preset_with_law_of(setup, preset)?;
    let rows = setup.parameters().into_iter();
    let changed = rows.filter(|row| is_changed(setup, &base, row));
    let numbers = changed.map(|row| {
        let values = [&base, setup].map(|setup| setup.value(row));
        let show =
            |digits: usize| values.map(|value| shown::setup_value(row, value, system, digits));
        let [mut from, mut to] = show(shown::IN_SUMMARY);
        // show all digits if the first four are equal
        if from == to {
            [from, to] = show(shown::IN_LIST);
        }
        ChangedSetting {
            key: row.name,
            name: shown::words(row.name),
            from,
            to,
        }
    });
    let of_preset = Setup::preset(preset.name)?;
    Ok(numbers.chain(changed_choices(setup, &of_preset)).collect())
}

/// The [`changes`] without those that have no effect because the launch is given.
pub(super) fn used_changes(
    setup: &Setup<f64>,
    preset: &Preset,
    system: System,
) -> Result<Vec<ChangedSetting>> {
    let mut changes = changes(setup, preset, system)?;
    changes.retain(|change| !(setup.launch.is_given() && is_of_strike(change.key)));
    Ok(changes)
}

/// A preset with the law of a setup. If the preset has another law, the coefficients are the
/// published ones.
pub(super) fn preset_with_law_of(setup: &Setup<f64>, preset: &Preset) -> Result<Setup<f64>> {
    let mut base = Setup::preset(preset.name)?;
    if base.law.name() != setup.law.name() {
        base.law = setup.law;
        let rows = base.parameters().into_iter();
        for row in rows.filter(|row| row.law.is_some()) {
            base.set_value(row, row.default_value())?;
        }
    }
    Ok(base)
}

/// True if the value of a parameter differs from that in `base`, the [`preset_with_law_of`] the
/// setup. False for a parameter that others determine.
pub(super) fn is_changed(setup: &Setup<f64>, base: &Setup<f64>, row: &Parameter) -> bool {
    setup.why_replaced(row).is_none() && setup.value(row) != base.value(row)
}

fn changed_choices(setup: &Setup<f64>, base: &Setup<f64>) -> impl Iterator<Item = ChangedSetting> {
    let shown = |setup: &Setup<f64>, key: &str| match key {
        LAW => setup.choice(TABLE).map(file_name).or(setup.choice(LAW)),
        _ => setup.choice(key),
    };
    let change = move |(key, name): (&'static str, &str)| {
        let (from, to) = (shown(base, key)?, shown(setup, key)?);
        (from != to).then(|| ChangedSetting {
            key,
            name: name.into(),
            from: from.into(),
            to: to.into(),
        })
    };
    let names = [
        (LAW, "law of drag and lift"),
        (METHOD, "method of integration"),
        (GOLFER, "hand of the golfer"),
        (SPEED_OF, "point of the club speed"),
    ];
    names.into_iter().filter_map(change)
}

/// The name of a file. Pages and pictures omit its folder (privacy).
pub(super) fn file_name(path: &str) -> &str {
    let name = Path::new(path).file_name().and_then(OsStr::to_str);
    name.unwrap_or(path)
}

/// Presets with every number and its source.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PresetsReport {
    /// The presets.
    pub presets: Vec<PresetReport>,
}

/// A preset with every number and its source.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PresetReport {
    /// The name by which a setup refers to the preset.
    pub name: &'static str,
    /// A one-line description.
    pub about: &'static str,
    /// Every parameter by its dotted name, SI and radians.
    pub setup: Settings,
    /// True if the preset states `flight.method` or `flight.step`. Otherwise a command that
    /// computes many drives chooses method and step.
    pub states_step: bool,
    /// The source of each parameter.
    pub sources: ByName<Cow<'static, str>>,
}

impl PresetsReport {
    /// The report of all presets, or of the preset with this name.
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) if there is no preset `name`.
    pub fn new(name: Option<&str>) -> Result<Self> {
        if let Some(name) = name {
            Setup::preset(name)?;
        }
        let presets = PRESETS
            .iter()
            .filter(|preset| name.is_none_or(|name| preset.name == name))
            .map(PresetReport::new)
            .collect::<Result<_>>()?;
        Ok(Self { presets })
    }
}

impl PresetReport {
    fn new(preset: &Preset) -> Result<Self> {
        let setup = Setup::preset(preset.name)?;
        let sources = sourced(preset, &setup).into_iter();
        Ok(Self {
            name: preset.name,
            about: preset.about,
            setup: settings(&setup),
            states_step: setup.states_step,
            sources: sources.map(|row| (row.name, row.source)).collect(),
        })
    }
}

impl Report for PresetsReport {
    const COMMAND: &'static str = "presets";

    fn document(&self, _: System) -> Document {
        let rows = self
            .presets
            .iter()
            .map(|preset| vec![preset.name.into(), preset.about.into()]);
        let mut document = Document::default();
        document.add(DocumentTable::new(["preset", ""], rows));
        document.list([Line::item(
            "`presets()` with a name prints one as a setup file, with the source of each number",
        )]);
        document
    }
}
