//! What the program adds to messages of the library and of the reader of arguments: the option to
//! give, and where a word belongs.

use super::running::running;
use crate::error::Error;
use crate::parameters::{Preset, Setup};
use crate::units::Quantity;
use std::path::Path;

/// An error in the words of the program.
pub fn in_words_of_the_program(error: Error) -> Error {
    match error {
        Error::Nothing { doing, what } => Error::Nothing {
            doing,
            what: option(doing).unwrap_or(what),
        },
        error => error,
    }
}

/// What to name where there is nothing to do, with the option that names it.
fn option(doing: &str) -> Option<&'static str> {
    match doing {
        "vary" => Some(
            "parameter with a range wider than a single value, as in --vary club.loft=4deg..20deg",
        ),
        "fit" => Some("parameter, as in --fit aero.cd0 or --fit aero.cd0=0.1..0.4"),
        "sweep" => Some("parameter, as in --over club.loft=5deg..15deg:101"),
        _ => None,
    }
}

/// What to do about a word that is left over: why it is not where it belongs.
pub fn advice_on(left_over: &str) -> Option<String> {
    in_quotes(left_over)
        .or_else(|| joined(left_over))
        .or_else(|| after_an_option(left_over))
}

/// A length behind `--tolerance` that is not joined to it.
fn joined(left_over: &str) -> Option<String> {
    let running = running();
    let is_behind = running
        .words()
        .windows(2)
        .any(|words| words[0] == "--tolerance" && words[1] == left_over);
    let is_length = Quantity::LENGTH.read(left_over).is_ok();
    let tolerance = left_over.replace(' ', "");
    (is_behind && is_length).then(|| {
        format!("a tolerance is joined to its option by '=', as in --tolerance={tolerance}")
    })
}

/// How the names of tables end, lower case.
const TABLES: [&str; 6] = ["arrow", "arrows", "csv", "feather", "jsonl", "parquet"];

/// What to do about a file in the place of a setup that is none by its name, with the option of the
/// command for it.
pub fn no_setup(file: &Path) -> Option<String> {
    let kind = file.extension()?.to_ascii_lowercase();
    if !TABLES.iter().any(|table| kind == *table) {
        return None;
    }
    let running = running();
    let advice = match running.words().first().and_then(|command| command.to_str()) {
        Some("delivery") => "; a table of shots stands after --shots",
        Some("sweep") => "; a table of points stands after --points",
        Some("optimize" | "design" | "pareto" | "robust") => {
            "; a table of swings stands after --swings"
        }
        Some("calibrate" | "fly") => "; the measured shots stand first, the setup after them",
        _ => "",
    };
    Some(format!("a table is no setup{advice}"))
}

/// The value of a parameter without an option of its own.
fn after_an_option(left_over: &str) -> Option<String> {
    let (name, value) = left_over.split_once('=')?;
    let is_parameter = Setup::default().parameter(name.trim()).is_ok();
    let option = if value.contains("..") {
        "--vary or --over"
    } else {
        "--set"
    };
    (is_parameter && !Path::new(left_over).exists())
        .then(|| format!("every value stands after an option of its own, here {option}"))
}

/// A word behind an option, where the shell parted a value before it at its spaces: `90` and `mph`
/// of `--set swing.speed=90 mph`.
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
            "a value with a space stands in quotes, as in {name} \"{}\"",
            pieces.join(" ")
        )
    })
}
