//! Messages in the syntax of the `Host` that runs the command, such as Python, and advice on words
//! that belong to no option.

use super::files::{ending, is_table};
use super::mention::Mention;
use super::running::running;
use crate::error::{Error, Result};
use crate::parameters::{Preset, Setup};
use crate::units::Quantity;
use std::path::Path;

/// A message in the syntax of this command's host.
pub fn in_host_syntax(message: &str) -> String {
    running().in_host_syntax(message)
}

/// The name of an argument in the syntax of this command's host; `shown` is its name in the
/// parser's message (`--width <PIXELS>`, `<STUDY>`). `None` if the host writes the name as the
/// command line does.
pub fn name_in_host_syntax(shown: &str) -> Option<String> {
    let name = match shown.strip_prefix("--") {
        Some(option) => option.split([' ', '=']).next()?.replace('-', "_"),
        None => shown.trim_matches(['<', '>', '[', ']', '.']).to_lowercase(),
    };
    let mention = Mention::Argument {
        name: &name,
        value: None,
        takes_value: true,
    };
    Some(running().host.mention(mention)).filter(|words| *words != mention.in_command_line_syntax())
}

/// Adds advice to the error of a constraint without a comparison: the shell may have removed `>` or
/// `<` as a redirection.
pub fn with_quotes_advice(error: Error) -> Error {
    match error {
        Error::Constraint {
            expression,
            column,
            reason,
        } if !expression.contains(['<', '>', '='])
            && running()
                .words
                .iter()
                .any(|word| option_of(&word.to_string_lossy()) == "--subject-to") =>
        {
            Error::Constraint {
                reason: format!("{reason}; {}", quotes_advice()),
                expression,
                column,
            }
        }
        error => error,
    }
}

/// The option of a word such as `--speed=90` or `--speed`: the part before `=`.
fn option_of(word: &str) -> &str {
    word.split_once('=').map_or(word, |(option, _)| option)
}

/// Advice on a word that is neither an option nor a setup.
pub fn advice_on(left_over: &str) -> Option<String> {
    in_quotes(left_over)
        .or_else(|| unquoted_constraint(left_over))
        .or_else(|| joined(left_over))
        .or_else(|| after_an_option(left_over))
}

/// Advice on a piece of a constraint that was given without quotes: the shell treats `>` and `<` as
/// redirections, and for `>=` it writes a file named `=`.
fn unquoted_constraint(left_over: &str) -> Option<String> {
    let running = running();
    let words = &running.words;
    let left_over = words.iter().position(|word| word == left_over)?;
    let option = words[..left_over]
        .iter()
        .rposition(|word| word.to_string_lossy().starts_with("--"))?;
    if option_of(&words[option].to_string_lossy()) != "--subject-to" {
        return None;
    }
    let has_sign = |word: &std::ffi::OsString| word.to_string_lossy().contains(['<', '>']);
    if words[option..left_over].iter().any(has_sign) {
        return None;
    }
    Some(quotes_advice())
}

/// Advice to write a constraint in quotes.
fn quotes_advice() -> String {
    let wrote = if Path::new("=").is_file() {
        ", and has written a file named '='"
    } else {
        ""
    };
    format!(
        "put a constraint in quotes, as in `subject_to \"descent_angle >= 38 deg\"`; without them \
         the shell reads > and < as redirections to files{wrote}"
    )
}

/// Advice on a length that follows the word `--tolerance`: this option needs '=' before its value.
fn joined(left_over: &str) -> Option<String> {
    let running = running();
    let is_behind = running
        .words
        .windows(2)
        .any(|words| words[0] == "--tolerance" && words[1] == left_over);
    let is_length = Quantity::LENGTH.read(left_over).is_ok();
    let tolerance = left_over.replace(' ', "");
    (is_behind && is_length).then(|| {
        format!("a tolerance is joined to its option by '=', as in `tolerance {tolerance}`")
    })
}

/// Refuses a table in place of a setup. The error names the option of the command that takes a
/// table.
pub fn refuse_table(file: &Path) -> Result<()> {
    if !is_table(file) {
        return Ok(());
    }
    let advice = match running().command {
        Some("delivery") => "; give a table of shots with `shots FILE`",
        Some("sweep") => "; give a table of points with `points FILE`",
        Some("optimize" | "design" | "pareto" | "robust") => {
            "; give a table of swings with `swings FILE`"
        }
        Some("calibrate" | "fly") => "; name the measured shots first, then the setup",
        _ if ending(file) == "csv" => "; `fly()` flies a table of shots",
        _ => "",
    };
    Err(Error::Toml {
        file: file.display().to_string(),
        message: format!("a table is no setup{advice}"),
    })
}

/// Advice on `NAME=VALUE` without an option before it.
fn after_an_option(left_over: &str) -> Option<String> {
    let (name, value) = left_over.split_once('=')?;
    let is_parameter = Setup::modern_driver().parameter(name.trim()).is_ok();
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
        .words
        .iter()
        .map(|word| word.to_string_lossy())
        .collect();
    let left_over = words.iter().position(|word| *word == left_over)?;
    let option = words[..left_over]
        .iter()
        .rposition(|word| word.starts_with("--"))?;
    let name = option_of(&words[option]);
    let begun = words[option].split_once('=').map(|(_, value)| value);
    // a negative number is no option
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
    // the number follows `NAME=`, or stands alone after an option such as --speed
    let is_number = (number.contains('=') || number.parse::<f64>().is_ok())
        && number.ends_with(|c: char| c.is_ascii_digit());
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
