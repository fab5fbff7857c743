//! Words of the program around messages: arguments as options, the option that would help, and
//! advice on words that are left over.
//!
//! A message names an argument of a request in backquotes, with its value after a space:
//! `` `vary club.loft=4deg..20deg` ``; a command has parentheses: `` `parameters()` ``. The host
//! writes them in its own words: the program as `--vary club.loft=4deg..20deg`.

use super::args::Args;
use super::running::running;
use crate::error::Error;
use crate::parameters::{Preset, Setup};
use crate::units::Quantity;
use clap::CommandFactory;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

/// An argument of a request, as a message names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Argument<'a> {
    /// The name, with underscores: `subject_to`.
    pub name: &'a str,
    /// The value, if the message gives one.
    pub value: Option<&'a str>,
    /// Whether it takes a value; `overwrite` takes none.
    pub takes_value: bool,
}

/// A part of a message that each host writes in its own words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mention<'a> {
    /// An argument of a request.
    Argument(Argument<'a>),
    /// A command of the program, such as `parameters`.
    Command(&'a str),
}

impl Mention<'_> {
    /// The words of the command line: `--vary club.loft=4deg..20deg`.
    pub fn in_words_of_the_program(self) -> String {
        let Argument { name, value, .. } = match self {
            Mention::Command(name) => return format!("'longdrive {name}'"),
            Mention::Argument(argument) => argument,
        };
        let option = match name {
            "output" => "-o".into(),
            _ => format!("--{}", name.replace('_', "-")),
        };
        match value {
            None => option,
            // an option whose value may be left out
            Some(value) if name == "tolerance" => format!("{option}={value}"),
            Some(value) => format!("{option} {value}"),
        }
    }
}

/// A message with its arguments and commands in the words of `write`.
///
/// ```
/// use longdrive::command::{Mention, with_mentions};
/// let message = "give a range, as in `vary club.loft=4deg..20deg`";
/// let program = with_mentions(message, |mention| mention.in_words_of_the_program());
/// assert_eq!(program, "give a range, as in --vary club.loft=4deg..20deg");
/// ```
pub fn with_mentions(message: &str, write: impl Fn(Mention<'_>) -> String) -> String {
    let mut written = String::with_capacity(message.len());
    let mut rest = message;
    while let Some((before, after)) = rest.split_once('`') {
        written.push_str(before);
        let mention = after
            .split_once('`')
            .and_then(|(inside, behind)| Some((mention(inside)?, behind)));
        match mention {
            Some((mention, behind)) => {
                written.push_str(&write(mention));
                rest = behind;
            }
            None => {
                written.push('`');
                rest = after;
            }
        }
    }
    written + rest
}

/// The text of a help with its options in backquotes, as a message mentions them.
///
/// ```
/// use longdrive::command::mark_options;
/// assert_eq!(mark_options("unless --max-size is given"), "unless `max_size` is given");
/// ```
pub fn mark_options(help: &str) -> String {
    let mut marked = String::with_capacity(help.len());
    let mut rest = help;
    while let Some((before, after)) = rest.split_once("--") {
        let end = after
            .find(|c: char| !c.is_ascii_lowercase() && c != '-')
            .unwrap_or(after.len());
        let (option, behind) = after.split_at(end);
        let is_option = !option.is_empty() && !before.ends_with(char::is_alphanumeric);
        marked.push_str(before);
        if is_option {
            marked.push_str(&format!("`{}`", option.replace('-', "_")));
        } else {
            marked.push_str("--");
            marked.push_str(option);
        }
        rest = behind;
    }
    marked + rest
}

/// The argument or command between two backquotes, if the program has it.
fn mention(inside: &str) -> Option<Mention<'_>> {
    if let Some(command) = inside.strip_suffix("()") {
        return Some(Mention::Command(command));
    }
    let (name, value) = inside
        .split_once(' ')
        .map_or((inside, None), |(name, value)| (name, Some(value)));
    let takes_value = *arguments().get(name)?;
    Some(Mention::Argument(Argument {
        name,
        value,
        takes_value,
    }))
}

/// All arguments of all commands, each with whether it takes a value.
fn arguments() -> &'static BTreeMap<String, bool> {
    static ARGUMENTS: OnceLock<BTreeMap<String, bool>> = OnceLock::new();
    fn collect(command: &clap::Command, all: &mut BTreeMap<String, bool>) {
        for argument in command.get_arguments() {
            if let Some(option) = argument.get_long() {
                all.insert(
                    option.replace('-', "_"),
                    argument.get_action().takes_values(),
                );
            }
        }
        for below in command.get_subcommands() {
            collect(below, all);
        }
    }
    ARGUMENTS.get_or_init(|| {
        let mut all = BTreeMap::new();
        collect(&Args::command(), &mut all);
        all
    })
}

/// A message in the words of the host of this command.
pub fn in_words_of_the_host(message: &str) -> String {
    let running = running();
    with_mentions(message, |mention| running.host.mention(mention))
}

/// The name of an argument as the parser shows it (`--width <PIXELS>`, `<STUDY>`) in the words of
/// the host; `None` in a terminal, and for an unknown argument.
pub fn name_in_words_of_the_host(shown: &str) -> Option<String> {
    let name = match shown.strip_prefix("--") {
        Some(option) => option.split([' ', '=']).next()?.replace('-', "_"),
        None => shown.trim_matches(['<', '>', '[', ']', '.']).to_lowercase(),
    };
    let mention = Mention::Argument(Argument {
        name: &name,
        value: None,
        takes_value: true,
    });
    Some(running().host.mention(mention))
        .filter(|words| *words != mention.in_words_of_the_program())
}

/// An error with the argument that would help.
pub fn with_argument(error: Error) -> Error {
    match error {
        Error::Nothing { doing, what } => Error::Nothing {
            doing,
            what: missing_argument(doing).unwrap_or(what),
        },
        error => error,
    }
}

/// The argument that a command without anything to do lacks.
fn missing_argument(doing: &str) -> Option<&'static str> {
    match doing {
        "vary" => Some(
            "parameter with a range wider than a single value, as in `vary club.loft=4deg..20deg`",
        ),
        "fit" => Some("parameter, as in `fit aero.cd0` or `fit aero.cd0=0.1..0.4`"),
        "sweep" => Some("parameter, as in `over club.loft=5deg..15deg:101`"),
        _ => None,
    }
}

/// Advice on a word that belongs to no option and is no setup.
pub fn advice_on(left_over: &str) -> Option<String> {
    in_quotes(left_over)
        .or_else(|| joined(left_over))
        .or_else(|| after_an_option(left_over))
}

/// Advice on a length after `--tolerance` without '='.
fn joined(left_over: &str) -> Option<String> {
    let running = running();
    let is_behind = running
        .words()
        .windows(2)
        .any(|words| words[0] == "--tolerance" && words[1] == left_over);
    let is_length = Quantity::LENGTH.read(left_over).is_ok();
    let tolerance = left_over.replace(' ', "");
    (is_behind && is_length).then(|| {
        format!("a tolerance is joined to its option by '=', as in `tolerance {tolerance}`")
    })
}

/// Extensions of tables, lower case.
const TABLES: [&str; 6] = ["arrow", "arrows", "csv", "feather", "jsonl", "parquet"];

/// Advice on a table in the place of a setup, with the option of the command for it.
pub fn no_setup(file: &Path) -> Option<String> {
    let kind = file.extension()?.to_ascii_lowercase();
    if !TABLES.iter().any(|table| kind == *table) {
        return None;
    }
    let running = running();
    let advice = match running.words().first().and_then(|command| command.to_str()) {
        Some("delivery") => "; a table of shots stands after `shots`",
        Some("sweep") => "; a table of points stands after `points`",
        Some("optimize" | "design" | "pareto" | "robust") => {
            "; a table of swings stands after `swings`"
        }
        Some("calibrate" | "fly") => "; the measured shots stand first, the setup after them",
        _ => "",
    };
    Some(format!("a table is no setup{advice}"))
}

/// Advice on a value of a parameter without an option before it.
fn after_an_option(left_over: &str) -> Option<String> {
    let (name, value) = left_over.split_once('=')?;
    let is_parameter = Setup::default().parameter(name.trim()).is_ok();
    let advice = if value.contains("..") {
        "each range needs its own option: write `vary NAME=LOW..HIGH` or `over NAME=LOW..HIGH`"
    } else {
        "each value needs its own option: write `set NAME=VALUE`"
    };
    (is_parameter && !Path::new(left_over).exists()).then(|| advice.into())
}

/// Advice on a value that the shell split at its space: `90` and `mph` of
/// `--set swing.speed=90 mph`.
fn in_quotes(left_over: &str) -> Option<String> {
    let running = running();
    let words: Vec<_> = running
        .words()
        .iter()
        .map(|word| word.to_string_lossy())
        .collect();
    let left_over = words.iter().position(|word| *word == left_over)?;
    let option = words[..left_over]
        .iter()
        .rposition(|word| word.starts_with("--"))?;
    let (name, begun) = words[option]
        .split_once('=')
        .map_or((&*words[option], None), |(name, value)| (name, Some(value)));
    // a negative number is none
    let is_option = |word: &str| {
        word.strip_prefix('-')
            .is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    let is_setup = |word: &str| Preset::named(word).is_some() || Path::new(word).exists();
    let further = words[option + 1..].iter().map(|word| &**word);
    let further = further.take_while(|word| !is_option(word) && !is_setup(word));
    let pieces: Vec<&str> = begun.into_iter().chain(further).collect();
    let [number, unit, ..] = pieces[..] else {
        return None;
    };
    let unit = unit
        .split(['.', ',', ':'])
        .next()
        .filter(|unit| !unit.is_empty())?;
    let is_number = number.contains('=') && number.ends_with(|c: char| c.is_ascii_digit());
    let is_parted = is_number
        && Quantity::ALL
            .iter()
            .any(|quantity| quantity.size_of(unit).is_some());
    is_parted.then(|| {
        format!(
            "put a value with a space in quotes, as in {name} \"{}\"",
            pieces.join(" ")
        )
    })
}
