//! Setup files: TOML with the dotted names of parameters as keys. A quantity with a dimension is a
//! string with its unit. Errors have a line and a column.

use super::air::is_reset;
use super::choices::{GOLFER, METHOD, SPEED_OF};
use super::declare::{Parameter, UNSET};
use super::law_table::{TABLE, TABLE_LAW};
use super::presets::{DEFAULT_PRESET, Preset};
use super::setup::{SettingText, table_with_another_law};
use super::table::{LAW, Law, Setup};
use super::turf::{TURF, refuse_idle_turf};
use crate::error::{Error, Result};
use crate::external_errors::toml_error_text;
use crate::input_file::InputFile;
use crate::repeated::first_repeated;
use std::collections::BTreeMap;
use std::path::Path;
use toml::de::{DeTable, DeValue};

/// Key of the preset that a file starts from.
const PRESET: &str = "preset";

/// A value of the file with its dotted key; positions are byte offsets.
struct Item<'a> {
    key: String,
    key_at: usize,
    value: &'a DeValue<'a>,
    value_at: usize,
    value_end: usize,
}

impl Item<'_> {
    fn is_reset(&self) -> bool {
        self.value
            .as_str()
            .is_some_and(|text| is_reset(&self.key, text))
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
    /// Parameters that the file gives, in the order of the file.
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
    /// are relative to the folder of `file`. Parameters that the file does not give have the values
    /// of its `preset`, by default [`DEFAULT_PRESET`].
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
        // sort the items: preset, table, turf and law come first, then the others in the order of
        // the file, the resets (`none`) last
        let rank = |key: &str| match key {
            PRESET => 0,
            TABLE | TURF => 1,
            LAW => 2,
            _ => 3,
        };
        items.sort_by_key(|item| (rank(&item.key), item.is_reset(), item.key_at));
        refuse_duplicate_keys(&items, text, file)?;

        let mut setup = Setup::preset(DEFAULT_PRESET)?;
        let folder = Path::new(file).parent().unwrap_or(Path::new(""));
        for item in &items {
            setup
                .apply(item, folder)
                .map_err(|(at, source)| in_file(text, file, at, source))?;
        }
        refuse_conflicts(&setup, &items, text, file)?;
        let preset = items
            .iter()
            .find(|item| item.key == PRESET)
            .and_then(|item| item.value.as_str());
        let given = items
            .iter()
            .filter(|item| !item.is_reset())
            .filter_map(|item| setup.parameter(&item.key).ok())
            .collect();
        let remarks = items.iter().filter_map(|item| {
            let remark = comment_after(text, item.value_end)?;
            Some((item.key.clone(), remark.to_owned()))
        });
        Ok(Self {
            name: file.into(),
            setup,
            preset: Preset::known(preset.unwrap_or(DEFAULT_PRESET))?,
            names_preset: preset.is_some(),
            given,
            remarks: remarks.collect(),
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

/// Refuses a turf without effect, and parameters that other parameters of the file replace.
fn refuse_conflicts(setup: &Setup<f64>, items: &[Item<'_>], text: &str, file: &str) -> Result<()> {
    if let Some(turf) = items.iter().find(|item| item.key == TURF) {
        refuse_idle_turf(|name| items.iter().any(|item| item.key == name))
            .map_err(|source| in_file(text, file, turf.key_at, source))?;
    }
    for item in items.iter().filter(|item| !item.is_reset()) {
        setup
            .refuse_replaced(&[&item.key])
            .map_err(|source| in_file(text, file, item.key_at, source))?;
    }
    Ok(())
}

impl Setup<f64> {
    fn apply(&mut self, item: &Item<'_>, folder: &Path) -> Result<(), (usize, Error)> {
        let at_value = |e| (item.value_at, e);
        let name_in_quotes = || string(item, "a name in quotes").map_err(at_value);
        if item.key == PRESET {
            *self = Self::preset(name_in_quotes()?).map_err(at_value)?;
            return Ok(());
        }
        if item.key == TABLE {
            let name = string(item, "the name of a file in quotes").map_err(at_value)?;
            return self.set_table(&folder.join(name)).map_err(at_value);
        }
        if item.key == LAW {
            let name = name_in_quotes()?;
            if matches!(self.law, Law::Table(_)) && name.trim() != TABLE_LAW {
                return Err(at_value(table_with_another_law(name)));
            }
            return self.set_law(name).map_err(at_value);
        }
        if matches!(item.key.as_str(), TURF | METHOD | GOLFER | SPEED_OF) {
            let setting = SettingText {
                name: &item.key,
                text: name_in_quotes()?,
                is_bare: false,
            };
            return self.apply_setting(&setting).map_err(at_value);
        }
        let group = format!("{}.", item.key);
        if self
            .parameters()
            .iter()
            .any(|row| row.name.starts_with(&group))
        {
            let expected = format!("a table, [{}]", item.key);
            return Err(at_value(wrong_type(item, expected)));
        }
        let parameter = self.parameter(&item.key).map_err(|e| (item.key_at, e))?;
        let value = match item.value {
            DeValue::String(_) if item.is_reset() => Ok(None),
            DeValue::String(text) => parameter.read(text, false),
            DeValue::Integer(number) => parameter.read(&number.to_string(), false),
            DeValue::Float(number) => parameter.read(number.as_str(), false),
            _ => Err(wrong_type(item, accepted(parameter))),
        };
        self.set_value(parameter, value.map_err(at_value)?)
            .map_err(at_value)
    }
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

fn string<'a>(item: &'a Item<'a>, expected: &str) -> Result<&'a str> {
    item.value
        .as_str()
        .ok_or_else(|| wrong_type(item, expected.into()))
}

fn wrong_type(item: &Item<'_>, expected: String) -> Error {
    let found = match item.value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    };
    Error::WrongType {
        key: item.key.clone(),
        found,
        expected,
    }
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

#[cfg(test)]
mod tests {
    use super::{Setup, SetupFile};

    #[test]
    fn comments_after_values_are_remarks() {
        let text = "preset = 'mae494'\r\n# of the club\r\nclub.mass = '0.2 kg'   #  weighed # twice \r\n\
                    club.loft = '9 deg'\n# none\nswing = { speed = '50 m/s', path = '0 deg' } # of both\n\
                    golfer = \"left\" # '#'\nball.mass = '45 g' #\nball.radius = '0.0214 m'# close";
        let file = SetupFile::read(text, "a.toml").unwrap();
        let remarks: Vec<_> = file
            .remarks
            .iter()
            .map(|(of, text)| format!("{of}: {text}"))
            .collect();
        assert_eq!(
            remarks,
            [
                "ball.radius: close",
                "club.mass: weighed # twice",
                "golfer: '#'"
            ]
        );
    }

    #[test]
    fn nested_keys_and_units() {
        let text = "aero.law = 'linear'\n[swing]\nspeed = '50 m/s'\n[club]\ninertia = \
                    { xx = '5679 g cm^2', yz = '1e-6 kg m^2' }\n\
                    bulge_radius = inf\n[impact]\nfriction = 0.4\n[aero]\ncd = 0.27";
        let error = SetupFile::read(text, "a.toml").unwrap_err().to_string();
        assert!(
            error.starts_with("a.toml: "),
            "a table defined twice is a TOML error: {error}"
        );
        let setup = SetupFile::read(
            &text
                .replace("\n[aero]\ncd", "\n[a]\n")
                .replace("[a]\n = 0.27", ""),
            "a.toml",
        )
        .unwrap()
        .setup;
        assert_eq!((setup.swing.speed, setup.club.inertia_xx), (50.0, 5.679e-4));
        assert_eq!(
            (setup.club.bulge_radius, setup.impact.friction),
            (f64::INFINITY, Some(0.4))
        );
        assert_eq!(setup.law.name(), "linear");
    }

    fn assert_refused(texts: &[(&str, &str, &str)]) {
        for (text, start, says) in texts {
            let message = SetupFile::read(text, "f").unwrap_err().to_string();
            assert!(
                message.starts_with(start) && message.contains(says),
                "{text:?}: {message}"
            );
        }
    }

    #[test]
    fn every_wrong_value_has_its_line_and_column() {
        assert_refused(&[
            (
                "[club]\nloft = '10 kg'",
                "f:2:8: club.loft: \"10 kg\" is not an angle",
                "deg",
            ),
            (
                "[club]\nloft = '10'",
                "f:2:8: club.loft: \"10\" has no unit",
                "deg",
            ),
            (
                "[club]\nloft = 10",
                "f:2:8: club.loft: \"10\" has no unit",
                "deg",
            ),
            (
                "[club]\nloft = nan",
                "f:2:8: club.loft: \"nan\" is not a number",
                "10.5 deg",
            ),
            (
                "[club]\nloft = true",
                "f:2:8: 'club.loft' is a boolean",
                "9.8 deg",
            ),
            (
                "preset = 'mae'",
                "f:1:10: unknown preset 'mae'; did you mean 'mae494'?",
                "winfield-tan",
            ),
            (
                "club = 3",
                "f:1:8: 'club' is a number; expected a table",
                "[club]",
            ),
            (
                "[[swing]]\nspeed = 50",
                "f:1:1: 'swing' is an array; expected a table",
                "[swing]",
            ),
        ]);
    }

    #[test]
    fn a_value_of_a_wrong_type_gets_an_example_of_its_quantity() {
        for parameter in Setup::default().parameters() {
            let read = |value: &str| SetupFile::read(&format!("{parameter} = {value}"), "f");
            let message = read("true").unwrap_err().to_string();
            let (expected, example) = message.split_once(" like ").unwrap();
            let takes_bare_numbers = read("0.5").is_ok() || read("4").is_ok();
            assert_eq!(
                expected.contains("a number"),
                takes_bare_numbers,
                "{message}"
            );
            let example = example.trim_matches('"');
            assert!(parameter.quantity.read(example).is_ok(), "{message}");
        }
    }

    #[test]
    fn every_wrong_name_has_its_line_and_column() {
        assert_refused(&[
            (
                "[club]\nloft = { x = 1 }",
                "f:2:10: unknown parameter 'club.loft.x'",
                "did you mean 'club.loft'",
            ),
            (
                "\n\nprset = 'mae494'",
                "f:3:1: unknown parameter 'prset'",
                "`parameters()` lists them all",
            ),
            (
                "[aero]\nlaw = 'linear'\ncd0 = 0.3",
                "f:3:1: 'aero.cd0' is a coefficient of robinson, ",
                "robinson",
            ),
            (
                "\"swing.speed\" = 50\n[swing]\nspeed = 40",
                "f:3:1: 'swing.speed' is given twice, here and at line 1",
                "keep one",
            ),
        ]);
    }

    #[test]
    fn a_mistake_of_the_syntax_has_its_line_and_column() {
        let message = SetupFile::read("[club\nloft = 1", "f")
            .unwrap_err()
            .to_string();
        assert!(message.contains("line 1, column"), "{message}");
    }
}
