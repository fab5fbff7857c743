//! Setup files: TOML with the dotted names of parameters as keys. A quantity with a dimension is a
//! string with its unit. Errors have a line and a column.

use super::air::is_reset;
use super::declare::{Parameter, UNSET};
use super::law_table::TABLE;
use super::presets::{DEFAULT_PRESET, Preset};
use super::setup::{CHOICES, SettingText};
use super::table::{Law, Setup};
use crate::error::{Error, Result};
use crate::external_errors::toml_error_text;
use crate::input_file::InputFile;
use crate::repeated::first_repeated;
use std::collections::BTreeMap;
use std::path::Path;
use toml::de::{DeTable, DeValue};

/// Key of the preset that a file starts from.
const PRESET: &str = "preset";

/// A value of the file with its dotted key. `key_at`, `value_at` and `value_end` are byte offsets.
struct Item<'a> {
    key: String,
    key_at: usize,
    value: &'a DeValue<'a>,
    value_at: usize,
    value_end: usize,
}

impl Item<'_> {
    /// The text of a string; empty for a value of another type.
    fn text(&self) -> &str {
        self.value.as_str().unwrap_or_default()
    }

    fn is_reset(&self) -> bool {
        is_reset(&self.key, self.text())
    }

    /// The preset that the item names.
    fn preset(&self) -> Result<&'static Preset> {
        let name = self.value.as_str();
        let name = name.ok_or_else(|| self.wrong_type("a name in quotes".into()))?;
        Preset::known(name)
    }

    /// The setting that the item gives. The file of a table is relative to `folder`; `rows` are all
    /// parameters, of all laws.
    fn setting(&self, folder: &Path, rows: &[&'static Parameter]) -> Result<SettingText<'_>> {
        if let Some(expected) = self.other_expected_type(rows) {
            return Err(self.wrong_type(expected));
        }
        let text = match self.value {
            DeValue::Integer(number) => number.to_string().into(),
            DeValue::Float(number) => number.as_str().into(),
            _ if self.key == TABLE => folder.join(self.text()).display().to_string().into(),
            _ => self.text().into(),
        };
        Ok(SettingText {
            name: &self.key,
            text,
            is_bare: false,
        })
    }

    /// The expected type, in words; `None` if the value has this type, or if neither a parameter of
    /// `rows` nor a choice has the name of the item.
    fn other_expected_type(&self, rows: &[&'static Parameter]) -> Option<String> {
        let is_text = matches!(self.value, DeValue::String(_));
        let is_number = matches!(self.value, DeValue::Integer(_) | DeValue::Float(_));
        if self.key == TABLE {
            return (!is_text).then(|| "the name of a file in quotes".into());
        }
        if CHOICES.contains(&self.key.as_str()) {
            return (!is_text).then(|| "a name in quotes".into());
        }
        let group = format!("{}.", self.key);
        if rows.iter().any(|row| row.name.starts_with(&group)) {
            return Some(format!("a table, [{}]", self.key));
        }
        let parameter = rows.iter().find(|row| row.name == self.key)?;
        (!is_text && !is_number).then(|| accepted(parameter))
    }

    fn wrong_type(&self, expected: String) -> Error {
        let found = match self.value {
            DeValue::String(_) => "a string",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "a boolean",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "an array",
            DeValue::Table(_) => "a table",
        };
        Error::WrongType {
            key: self.key.clone(),
            found,
            expected,
        }
    }
}

/// Contents of a setup file, or a preset.
#[derive(Clone, Debug)]
pub struct SetupFile {
    /// The name of the file, or of the preset.
    pub name: String,
    /// The setup.
    pub setup: Setup<f64>,
    /// The preset that the file starts from: [`DEFAULT_PRESET`] if the file names no preset.
    pub preset: &'static Preset,
    /// True if the file names its preset.
    pub names_preset: bool,
    /// Parameters that the file gives, in the order of the file. A turf counts as the parameters of
    /// the ground that it sets.
    pub given: Vec<&'static Parameter>,
    /// Comments after the values, by the dotted names of parameters and choices. A setup file that
    /// is written again repeats the comment of each unchanged value.
    pub remarks: BTreeMap<String, String>,
}

impl SetupFile {
    /// The contents of a file that names only this preset.
    ///
    /// # Errors
    /// [`Error::Unknown`] if there is no preset `name`.
    pub fn of_preset(name: &str) -> Result<Self> {
        Ok(Self {
            name: name.into(),
            setup: Setup::preset(name)?,
            preset: Preset::known(name)?,
            names_preset: true,
            given: vec![],
            remarks: BTreeMap::new(),
        })
    }

    /// Reads a setup file.
    ///
    /// # Errors
    /// [`Error::File`] if the file cannot be opened; the errors of [`read`](Self::read).
    pub fn open(path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        match InputFile::read_to_string(path) {
            Ok(text) => Self::read(&text, &file),
            Err(source) => Err(Error::File {
                file,
                source,
                presets: Preset::names(),
            }),
        }
    }

    /// Parses the text of a setup file. `file` is the file's name in messages; paths in the text
    /// are relative to the folder of `file`. A parameter that is not in the file has the value of
    /// the file's preset, or of [`DEFAULT_PRESET`] if the file names no preset.
    ///
    /// ```
    /// use longdrive::parameters::SetupFile;
    /// let text = "preset = 'mae494'\n[club]\nloft = '12 deg'";
    /// let setup = SetupFile::read(text, "mine.toml").unwrap().setup;
    /// assert_eq!(setup.club.loft, 12.0_f64.to_radians());
    /// let error = SetupFile::read("[club]\nlofft = '12 deg'", "mine.toml").unwrap_err();
    /// let message = "mine.toml:2:1: unknown parameter 'club.lofft'; did you mean 'club.loft'?";
    /// assert!(error.to_string().starts_with(message));
    /// ```
    ///
    /// # Errors
    /// [`Error::Toml`] if the text is not TOML, and [`Error::InFile`], with line and column, if a
    /// key or a value is wrong.
    pub fn read(text: &str, file: &str) -> Result<Self> {
        let table = DeTable::parse(text).map_err(|error| Error::Toml {
            file: file.into(),
            message: toml_error_text(&error, text, |at| place_in(text, at)),
        })?;
        let mut items = Vec::new();
        flatten(table.get_ref(), "", &mut items);
        items.sort_by_key(|item| item.key_at);
        refuse_duplicate_keys(&items, text, file)?;
        let remarks = items.iter().filter_map(|item| {
            let remark = comment_after(text, item.value_end)?;
            Some((item.key.clone(), remark.to_owned()))
        });
        let remarks = remarks.collect();

        let at_value = |item: &Item<'_>, error| in_file(text, file, item.value_at, error);
        let (named, items): (Vec<_>, Vec<_>) =
            items.into_iter().partition(|item| item.key == PRESET);
        let preset = match named.first() {
            Some(item) => item.preset().map_err(|error| at_value(item, error))?,
            None => Preset::known(DEFAULT_PRESET)?,
        };
        let mut setup = Setup::preset(preset.name)?;
        let rows: Vec<_> = setup
            .parameters()
            .into_iter()
            .chain(Law::all_rows())
            .collect();
        let folder = Path::new(file).parent().unwrap_or(Path::new(""));
        let setting =
            |item| Item::setting(item, folder, &rows).map_err(|error| at_value(item, error));
        let settings = items.iter().map(setting).collect::<Result<Vec<_>>>()?;
        setup.apply_each(&settings).map_err(|fault| {
            let item = &items[fault.index];
            if fault.is_of_value {
                at_value(item, fault.error)
            } else {
                in_file(text, file, item.key_at, fault.error)
            }
        })?;
        let given = items
            .iter()
            .filter(|item| !item.is_reset())
            .flat_map(|item| setup.set_by(&item.key))
            .collect();
        Ok(Self {
            name: file.into(),
            setup,
            preset,
            names_preset: !named.is_empty(),
            given,
            remarks,
        })
    }
}

/// The comment between the byte offset `end` of a value and the end of its line, without `#`.
fn comment_after(text: &str, end: usize) -> Option<&str> {
    let line = text.get(end..)?.lines().next()?;
    let comment = line.trim_start().strip_prefix('#')?.trim();
    (!comment.is_empty()).then_some(comment)
}

fn refuse_duplicate_keys(items: &[Item<'_>], text: &str, file: &str) -> Result<()> {
    let Some([first, again]) = first_repeated(items, |a, b| a.key == b.key) else {
        return Ok(());
    };
    let (line, _) = place_in(text, items[first].key_at);
    let key = items[again].key.clone();
    let source = Error::Twice { key, line };
    Err(in_file(text, file, items[again].key_at, source))
}

/// Accepted type of the values of a parameter, with an example, for messages.
fn accepted(parameter: &Parameter) -> String {
    let kind = if parameter.unit.is_empty() {
        "a number, or a string"
    } else {
        "a string with its unit,"
    };
    let example = if parameter.default == UNSET {
        format!("1 {}", parameter.unit)
    } else {
        parameter.default.into()
    };
    format!("{kind} like \"{}\"", example.trim_end())
}

fn flatten<'a>(table: &'a DeTable<'a>, prefix: &str, items: &mut Vec<Item<'a>>) {
    for (key, value) in table {
        let name = format!("{prefix}{}", key.get_ref());
        match value.get_ref() {
            DeValue::Table(inner) => flatten(inner, &format!("{name}."), items),
            other => items.push(Item {
                key: name,
                key_at: key.span().start,
                value: other,
                value_at: value.span().start,
                value_end: value.span().end,
            }),
        }
    }
}

/// Adds file, line and column to an error.
pub(crate) fn in_file(text: &str, file: &str, at: usize, source: Error) -> Error {
    let (line, column) = place_in(text, at);
    Error::InFile {
        file: file.into(),
        line,
        column,
        source: Box::new(source),
    }
}

/// Line and column of a byte offset, both counted from 1.
pub(crate) fn place_in(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    )
}
