use super::{Reply, json, shown, table::table};
use crate::error::Result;
use crate::parameters::{
    GOLFER, LAW, METHOD, PRESETS, Parameter, Preset, SPEED_OF, Setup, TABLE, UNSET,
};
use crate::units::System;
use serde_json::{Value, json};

/// The source of a parameter's value in a preset: its own, or the table's where the preset does not
/// change it.
pub(super) fn sourced(
    preset: &Preset,
    setup: &Setup<f64>,
) -> Vec<(&'static str, String, &'static str)> {
    let entry = |name: &str| preset.entries.iter().find(|entry| entry.name == name);
    let mut rows: Vec<_> = setup
        .parameters()
        .into_iter()
        .map(|row| {
            let shown = entry(row.name).map_or(row.default, |entry| entry.value);
            (
                row.name,
                shown.to_owned(),
                entry(row.name).map_or(row.source, |entry| entry.source),
            )
        })
        .collect();
    let law_at = rows
        .iter()
        .position(|(name, ..)| name.starts_with("aero."))
        .unwrap_or(rows.len());
    let source = entry(LAW).map_or(
        "fitted to what launch monitors predict; smooth, with the right apex and descent",
        |entry| entry.source,
    );
    rows.insert(law_at, (LAW, setup.law.name().into(), source));
    let method_at = rows
        .iter()
        .position(|(name, ..)| *name == "flight.step")
        .unwrap_or(rows.len());
    let source = entry(METHOD).map_or("the classical method, which the sources use", |entry| {
        entry.source
    });
    rows.insert(method_at, (METHOD, setup.method.name().into(), source));
    let speed_at = after_speed(&rows);
    rows.insert(
        speed_at,
        (
            SPEED_OF,
            setup.speed_of.name().into(),
            "as radars state it, within millimetres",
        ),
    );
    let source = "right-handed, as the golfers of the sources";
    rows.insert(0, (GOLFER, setup.golfer.name().into(), source));
    rows
}

/// Where each number of a setup comes from: its name, its value and its source, in the units of a
/// system, or without one as they are typed. A number that differs from the preset's is the asker's
/// own.
pub fn sources(
    setup: &Setup<f64>,
    preset: &Preset,
    system: Option<System>,
) -> Result<Vec<(&'static str, String, String)>> {
    let base = Setup::preset(preset.name)?;
    let known = sourced(preset, &base);
    let source = |name: &str, is_kept: bool| {
        let known = known.iter().find(|(known, ..)| *known == name);
        match known {
            Some((.., source)) if is_kept => (*source).to_owned(),
            Some((_, shown, _)) => {
                let row = base.parameter(name).ok();
                let number = row
                    .zip(system)
                    .map(|(row, system)| shown::set(row, base.value(row), system));
                format!(
                    "as given, instead of {}",
                    number.unwrap_or_else(|| shown.clone())
                )
            }
            None => "as given".into(),
        }
    };
    let set = |row: &Parameter, value: Option<f64>| match system {
        Some(system) => shown::set(row, value, system),
        None => row.show(value),
    };
    let mut rows: Vec<_> = setup
        .parameters()
        .into_iter()
        // what follows from other parameters is not given beside them
        .filter(|row| setup.why_replaced(row).is_none())
        .map(|row| {
            let value = setup.value(row);
            // a coefficient of another law than the preset's has its own source
            let source = match base.parameter(row.name) {
                Ok(known) => source(row.name, base.value(known) == value),
                Err(_) if value == row.default_value() => row.source.to_owned(),
                Err(_) => format!("as given, instead of {}", set(row, row.default_value())),
            };
            (row.name, set(row, value), source)
        })
        .collect();
    let law_at = rows
        .iter()
        .position(|(name, ..)| name.starts_with("aero."))
        .unwrap_or(rows.len());
    if let Some(table) = setup.law.table() {
        rows.insert(law_at, (TABLE, table.file().into(), source(TABLE, false)));
    }
    rows.insert(
        law_at,
        (
            LAW,
            setup.law.name().into(),
            source(LAW, base.law.name() == setup.law.name()),
        ),
    );
    let method_at = rows
        .iter()
        .position(|(name, ..)| *name == "flight.step")
        .unwrap_or(rows.len());
    rows.insert(
        method_at,
        (
            METHOD,
            setup.method.name().into(),
            source(METHOD, base.method == setup.method),
        ),
    );
    let speed_of = (
        SPEED_OF,
        setup.speed_of.name().into(),
        source(SPEED_OF, base.speed_of == setup.speed_of),
    );
    rows.insert(after_speed(&rows), speed_of);
    rows.insert(
        0,
        (
            GOLFER,
            setup.golfer.name().into(),
            source(GOLFER, base.golfer == setup.golfer),
        ),
    );
    Ok(rows)
}

/// The place behind the club speed.
fn after_speed<S, V>(rows: &[(&'static str, S, V)]) -> usize {
    rows.iter()
        .position(|(name, ..)| *name == "swing.speed")
        .map_or(0, |at| at + 1)
}

/// A number, or a choice such as the law, that differs from the preset's, as a person reads it.
pub struct Change {
    /// The parameter, where it is one.
    pub parameter: Option<&'static Parameter>,
    /// What it is called.
    pub name: String,
    /// In the preset.
    pub from: String,
    /// In the setup.
    pub to: String,
}

/// What differs between a setup and the preset that it started from, in the units of a system.
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
/// None that a test does not rule out: presets are read as any setup is.
pub fn changes(setup: &Setup<f64>, preset: &Preset, system: System) -> Result<Vec<Change>> {
    let base = Setup::preset(preset.name)?;
    let used = setup
        .parameters()
        .into_iter()
        .filter(|row| setup.why_replaced(row).is_none());
    let numbers = used.filter_map(|row| {
        // a coefficient of another law than the preset's is compared with its own default
        let from = base
            .parameter(row.name)
            .map_or_else(|_| row.default_value(), |known| base.value(known));
        let to = setup.value(row);
        (from != to).then(|| {
            let short = [from, to]
                .map(|value| value.map_or(UNSET.into(), |value| shown::told(row, value, system)));
            // all digits where the first four are the same
            let [from, to] = if short[0] == short[1] {
                [from, to].map(|value| shown::set(row, value, system))
            } else {
                short
            };
            Change {
                parameter: Some(row),
                name: shown::words(row.name),
                from,
                to,
            }
        })
    });
    let law = setup
        .law
        .table()
        .map_or(setup.law.name(), |table| table.file());
    let words = [
        ("law of drag and lift", base.law.name(), law),
        (
            "method of integration",
            base.method.name(),
            setup.method.name(),
        ),
        (
            "hand of the golfer",
            base.golfer.name(),
            setup.golfer.name(),
        ),
        (
            "point of the club speed",
            base.speed_of.name(),
            setup.speed_of.name(),
        ),
    ];
    let words = words
        .into_iter()
        .filter(|(_, from, to)| from != to)
        .map(|(name, from, to)| Change {
            parameter: None,
            name: name.into(),
            from: from.into(),
            to: to.into(),
        });
    Ok(numbers.chain(words).collect())
}

/// The answer of `presets`: every number of each preset, or of the one that is named, with its
/// source.
///
/// # Errors
/// [`Error::Unknown`](crate::Error::Unknown) for a name that no preset bears.
pub fn presets_reply(name: Option<&str>) -> Result<Reply<Value>> {
    if let Some(name) = name {
        Setup::preset(name)?;
    }
    let one = |preset: &Preset| -> Result<Value> {
        let setup = Setup::preset(preset.name)?;
        let sources = sourced(preset, &setup)
            .into_iter()
            .map(|(name, _, source)| (name.to_owned(), json!(source)));
        Ok(json!({
            "name": preset.name,
            "about": preset.about,
            "setup": json::setup(&setup),
            "sources": sources.collect::<serde_json::Map<_, _>>(),
        }))
    };
    let asked = PRESETS
        .iter()
        .filter(|preset| name.is_none_or(|name| preset.name == name));
    Ok(Reply::done(
        "presets",
        vec![],
        json!({ "presets": asked.map(one).collect::<Result<Vec<_>>>()? }),
    ))
}

/// The presets as text, a line each.
pub fn presets_text() -> String {
    let rows = PRESETS
        .iter()
        .map(|preset| vec![preset.name.into(), preset.about.into()]);
    table(&["preset", ""], &[], rows)
        + "\n  'longdrive presets NAME' prints one as a setup file, with the source of each \
           number\n"
}
