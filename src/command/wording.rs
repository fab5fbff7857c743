//! What the program adds to messages of the library: the option to give.

use crate::error::Error;

/// An error in the words of the program.
pub fn in_words_of_the_program(error: Error) -> Error {
    match error {
        Error::Nothing { doing, what } => Error::Nothing { doing, what: option(doing).unwrap_or(what) },
        error => error,
    }
}

/// What to name where there is nothing to do, with the option that names it.
fn option(doing: &str) -> Option<&'static str> {
    match doing {
        "vary" => Some("parameter with a range wider than a single value, as in --vary club.loft=4deg..20deg"),
        "fit" => Some("parameter, as in --fit aero.cd0 or --fit aero.cd0=0.1..0.4"),
        "sweep" => Some("parameter, as in --over club.loft=5deg..15deg:101"),
        _ => None,
    }
}
