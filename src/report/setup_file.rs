//! Setups as setup files in TOML. Reading such a file gives the same setup, to the last bit.

use super::presets::{SourcedValue, sourced, sources};
use super::shown::{self, MOST_DIGITS};
use crate::error::Result;
use crate::parameters::{
    Parameter, Preset, Setup, SetupFile, TABLE, UNSET, Vary, is_given_alike, is_of_step,
};
use crate::study::Constraint;
use crate::units::{significant, typed};

/// Writes a setup as a setup file in TOML: the lines `about` as comments, the preset, then every
/// parameter with its source as a comment. A remark in `remarks` replaces the source of its
/// parameter.
///
/// - `file` is the file or preset from which the setup comes. An unchanged value keeps its comment.
/// - Method and step are written only if the setup states them. Otherwise the command that reads
///   the written file may choose them.
/// - Values of air and wind that equal those of the preset are written as comments. A command can
///   then read the written file and state other weather.
///
/// ```
/// use longdrive::{Setup, parameters::SetupFile, report::setup_toml};
/// let text = "preset = 'mae494'\n[club]\nmass = '200 g' # weighed";
/// let file = SetupFile::read(text, "mine.toml").unwrap();
/// let mut setup = file.setup;
/// setup.set("club.loft", "10.5 deg").unwrap();
/// let text = setup_toml(&setup, &file, &[], &[]).unwrap();
/// assert!(text.contains("\nmass = \"200 g\" # weighed\n"));
/// assert!(text.contains("\nloft = \"10.5 deg\" # as given, instead of 10 deg\n"));
/// assert_eq!(SetupFile::read(&text, "mine.toml").unwrap().setup, setup);
/// ```
///
/// # Errors
/// No error occurs in practice: a test reads all presets.
pub fn setup_toml(
    setup: &Setup<f64>,
    file: &SetupFile,
    about: &[String],
    remarks: &[(&'static Parameter, String)],
) -> Result<String> {
    let of_preset = Setup::preset(file.preset.name)?;
    let is_of_preset = |row: &SourcedValue| {
        let parameter = setup.parameter(row.name);
        parameter.is_ok_and(|parameter| is_given_alike([setup, &of_preset], parameter))
    };
    let rows = rows(setup, file, remarks)?;
    Ok(toml(setup, file.preset, about, &rows, is_of_preset))
}

/// A setup for a setup file, with the comments of the file.
#[derive(Clone, Debug)]
pub struct CommentedSetup {
    /// The setup.
    pub setup: Setup<f64>,
    /// The lines at the head of the file.
    pub about: Vec<String>,
    /// Remarks, each in place of the source of its parameter.
    pub remarks: Vec<(&'static Parameter, String)>,
}

impl CommentedSetup {
    /// The setup file in TOML (see [`setup_toml`]).
    ///
    /// # Errors
    /// The errors of [`setup_toml`].
    pub fn toml(&self, file: &SetupFile) -> Result<String> {
        setup_toml(&self.setup, file, &self.about, &self.remarks)
    }
}

/// Writes a setup as a setup file in TOML. Values that equal those of the preset, and that are not
/// in `file.given`, are comments. So reading the text gives the same setup, and the parameters that
/// are given.
///
/// ```
/// use longdrive::{parameters::SetupFile, report::given_toml};
/// let file = SetupFile::read("[club]\nloft = '8.8 deg'", "mine.toml").unwrap();
/// let text = given_toml(&file.setup, &file).unwrap();
/// let read = SetupFile::read(&text, "mine.toml").unwrap();
/// assert_eq!((read.setup, read.given), (file.setup, file.given));
/// ```
///
/// # Errors
/// The errors of [`setup_toml`].
pub fn given_toml(setup: &Setup<f64>, file: &SetupFile) -> Result<String> {
    let of_preset = Setup::preset(file.preset.name)?;
    let is_only_of_preset = |row: &SourcedValue| {
        let parameter = of_preset.parameter(row.name);
        parameter.is_ok_and(|parameter| {
            of_preset.value(parameter) == setup.value(parameter)
                && !file.given.contains(&parameter)
                && !is_of_step(row.name)
        })
    };
    let rows = rows(setup, file, &[])?;
    Ok(toml(setup, file.preset, &[], &rows, is_only_of_preset))
}

/// The line about a constraint for the head of a setup file.
pub(super) fn about_constraint(constraint: &Constraint) -> String {
    format!("subject to {}", constraint.expression)
}

/// The remark of each varied parameter in a setup file, such as "optimum: 10.4 deg in 4 deg .. 20
/// deg".
pub(super) fn remarks_on_varied(
    word: &str,
    vary: &[Vary],
    values: &[f64],
) -> Vec<(&'static Parameter, String)> {
    let remark = |(vary, value): (&Vary, &f64)| {
        let found = shown::computed(vary.parameter, *value);
        let [low, high] = [vary.low, vary.high].map(|end| vary.parameter.show(Some(end)));
        (
            vary.parameter,
            format!("{word}: {found} in {low} .. {high}"),
        )
    };
    vary.iter().zip(values).map(remark).collect()
}

/// Every parameter and choice, with its value and its source. A remark replaces the source.
fn rows(
    setup: &Setup<f64>,
    file: &SetupFile,
    remarks: &[(&'static Parameter, String)],
) -> Result<Vec<SourcedValue>> {
    let row = |row: SourcedValue| {
        // use an absolute path: a relative one would refer to the folder of the setup file
        if row.name == TABLE {
            let file = std::path::absolute(&row.value);
            let value = file.map_or(row.value, |path| path.display().to_string());
            return SourcedValue { value, ..row };
        }
        let Ok(parameter) = setup.parameter(row.name) else {
            return row;
        };
        let remark = remarks
            .iter()
            .find(|(of, _)| *of == parameter)
            .map(|(_, remark)| remark.clone().into());
        SourcedValue {
            name: row.name,
            value: exact(parameter, setup.value(parameter), parameter.unit),
            source: remark.unwrap_or(row.source),
        }
    };
    let rows = sources(setup, file, None)?.into_iter();
    Ok(rows.map(row).collect())
}

/// A preset as a setup file in TOML, each number with its source.
///
/// # Errors
/// [`Error::Unknown`](crate::Error::Unknown) if there is no preset `name`.
pub fn preset_toml(name: &str) -> Result<String> {
    let setup = Setup::preset(name)?;
    let preset = Preset::known(name)?;
    let about = [preset.name.into(), preset.about.into()];
    let rows = sourced(preset, &setup);
    Ok(toml(&setup, preset, &about, &rows, |_| false))
}

/// The setting `NAME=VALUE` of `--set` that gives exactly this value.
#[cfg(feature = "commands")]
pub(crate) fn setting_text(parameter: &Parameter, value: f64) -> String {
    let value = exact(parameter, Some(value), parameter.unit);
    format!("{}={value}", parameter.name)
}

/// The shortest text in `unit` that parses to exactly this value. If rounding makes this impossible
/// in `unit`, the text is in SI.
pub(super) fn exact(parameter: &Parameter, value: Option<f64>, unit: &str) -> String {
    let Some(value) = value else {
        return UNSET.into();
    };
    let number = parameter.quantity.number_in(value, unit);
    let text = |digits: usize| typed(&significant(number, digits), unit);
    let reads_back = |text: &String| {
        parameter
            .read(text, false)
            .is_ok_and(|read| read.map(f64::to_bits) == Some(value.to_bits()))
    };
    let shown = (1..=MOST_DIGITS).map(text).find(reads_back);
    shown.unwrap_or_else(|| typed(&format!("{value:?}"), parameter.quantity.si))
}

/// Writes a setup file: the lines `about` as comments, the preset, then the values by TOML table.
/// Method and step are omitted unless the setup states them. A value for which `is_comment` is true
/// becomes a comment.
fn toml(
    setup: &Setup<f64>,
    preset: &Preset,
    about: &[String],
    rows: &[SourcedValue],
    is_comment: impl Fn(&SourcedValue) -> bool,
) -> String {
    // control characters may occur in file names
    let remark = |text: &str| text.replace(char::is_control, " ");
    let mut text: String = about
        .iter()
        .map(|line| format!("# {}\n", remark(line)))
        .collect();
    text += &format!("preset = \"{}\"\n", preset.name);
    let table_of = |name: &'static str| name.split_once('.').map_or("", |(table, _)| table);
    let rows = rows.iter();
    let rows = rows.filter(|row| setup.states_step || !is_of_step(row.name));
    // keys without a table must precede the first table; each table has one header
    let mut tables = vec![""];
    for row in rows.clone() {
        if !tables.contains(&table_of(row.name)) {
            tables.push(table_of(row.name));
        }
    }
    for table in tables {
        if !table.is_empty() {
            text += &format!("\n[{table}]\n");
        }
        for row in rows.clone().filter(|row| table_of(row.name) == table) {
            let key = row.name.split_once('.').map_or(row.name, |(_, key)| key);
            let (value, remark) = (quoted(&row.value), remark(&row.source));
            let begin = if is_comment(row) { "# " } else { "" };
            text += &format!("{begin}{key} = {value} # {remark}\n");
        }
    }
    text
}

/// A quoted TOML string, with control characters escaped.
fn quoted(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04X}", u32::from(c)),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}
