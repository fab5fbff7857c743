//! The source of a setup: a preset, a TOML file, or standard input.

use crate::command::running::running;
use crate::command::wording::{advice_on, refuse_table};
use crate::input_file;
use crate::parameters::{Law, PRESETS, Preset, SetupFile};
use crate::{Error, Result, Setup};
use std::path::Path;

/// The argument for standard input.
const STANDARD_INPUT: &str = "-";

/// The setup of a preset or a file, before the settings of the command line.
#[derive(Clone)]
pub struct Source {
    /// The argument on the command line.
    pub argument: String,
    /// The content of the file; for a preset, only its setup.
    pub content: SetupFile,
    /// The names of the parameters that the host states in the setup named `-`. They count as
    /// settings.
    pub stated: Vec<String>,
}

impl Source {
    /// Reads the setup that the command line names.
    ///
    /// # Errors
    /// [`Error::Unknown`] if `argument` is an unknown preset, and the errors of [`SetupFile::open`]
    /// if it names a file or standard input.
    pub fn read(argument: &str) -> Result<Self> {
        let path = Path::new(argument);
        let is_named_like_a_file = argument.contains(['/', '\\']) || path.extension().is_some();
        let is_preset = Preset::named(argument).is_some();
        let content = if argument == STANDARD_INPUT {
            let content = read_standard_input()?;
            if let Some(stated) = running().host.stated() {
                return Ok(Self::of_host(content, stated));
            }
            content
        } else if !is_preset
            && (input_file::exists(path) || is_named_like_a_file && !argument.contains('='))
        {
            refuse_table(path)?;
            SetupFile::open(path)?
        } else {
            read_preset(argument)?
        };
        Ok(Self {
            argument: argument.into(),
            content,
            stated: vec![],
        })
    }

    /// The setup `content` of a host, with the argument `-`. `stated` are the parameters that the
    /// host gives.
    pub fn of_host(content: SetupFile, stated: Vec<String>) -> Self {
        Self {
            argument: STANDARD_INPUT.into(),
            content,
            stated,
        }
    }

    /// True if the argument names a setup: a preset, standard input or an existing file. A text
    /// with a slash, `=` or an extension also counts as a setup, unless the text is a part of a
    /// parameter name. Any other text is a search word.
    pub fn is_named_by(argument: &str) -> bool {
        let path = Path::new(argument);
        let is_written_like_a_file =
            argument.contains(['/', '\\', '=']) || path.extension().is_some();
        let rows = || {
            Setup::modern_driver()
                .parameters()
                .into_iter()
                .chain(Law::all_rows())
        };
        let is_part_of_a_name = || rows().any(|row| row.name.contains(argument));
        Preset::named(argument).is_some()
            || argument == STANDARD_INPUT
            || input_file::exists(path)
            || is_written_like_a_file && !is_part_of_a_name()
    }

    /// The name for messages.
    pub fn name(&self) -> &str {
        if self.has_name() {
            &self.argument
        } else {
            running().host.setup_name()
        }
    }

    /// The name for the title of an answer. If a file names no preset, the preset that it starts
    /// from follows in parentheses: "mine.toml (tour-average)".
    pub fn title(&self) -> String {
        if self.content.names_preset {
            return self.name().into();
        }
        format!("{} ({})", self.name(), self.content.preset.name)
    }

    /// True for a preset or a file, which have a name; false for standard input.
    pub fn has_name(&self) -> bool {
        self.argument != STANDARD_INPUT
    }

    /// The setup file, if the source is a file on disk.
    pub fn file(&self) -> Option<&Path> {
        let is_file = self.has_name() && Preset::named(&self.argument).is_none();
        is_file.then_some(Path::new(&self.argument))
    }
}

fn read_preset(argument: &str) -> Result<SetupFile> {
    let unknown = || {
        let names = PRESETS.iter().map(|preset| preset.name);
        let usual = || format!("a setup is a preset ({}) or a TOML file", Preset::names());
        let advice = advice_on(argument).unwrap_or_else(usual);
        Error::unknown("setup", argument, names, advice)
    };
    SetupFile::of_preset(argument).map_err(|_| unknown())
}

fn read_standard_input() -> Result<SetupFile> {
    let name = running().host.setup_name();
    let text = running().input().map_err(|source| Error::File {
        file: name.into(),
        source,
        presets: Preset::names(),
    })?;
    if text.trim().is_empty() {
        let source = format!(
            "it is empty; give a setup in TOML, or name a preset ({}) in place of -",
            Preset::names()
        );
        return Err(Error::unreadable(name, source));
    }
    let read = SetupFile::read(&text, name)?;
    Ok(SetupFile {
        // a written setup file starts from the setup `name`; standard input cannot be read again,
        // so the file starts from the preset
        name: read.preset.name.into(),
        ..read
    })
}
