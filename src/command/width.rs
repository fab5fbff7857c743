//! The width of text: the width that `COLUMNS` states, or else the width of the terminal.

#[cfg(feature = "cli")]
use std::io;
#[cfg(feature = "cli")]
use terminal_size::{Width, terminal_size_of};

/// Width of text if no terminal is known, columns.
pub const UNKNOWN: usize = 80;

/// Minimum and maximum width of text, columns. Longer lines are hard to read.
const WIDTHS: [usize; 2] = [40, 120];

/// Width of answers and help on standard output, columns.
pub fn of_answers() -> usize {
    #[cfg(feature = "cli")]
    let columns = terminal_size_of(io::stdout()).map(|(Width(columns), _)| columns);
    #[cfg(not(feature = "cli"))]
    let columns = None;
    width(columns)
}

/// Width of messages on standard error, columns.
#[cfg(feature = "cli")]
pub fn of_messages() -> usize {
    width(terminal_size_of(io::stderr()).map(|(Width(columns), _)| columns))
}

/// The width that `COLUMNS` states, or else `columns`, the width of the terminal. The result is
/// limited to [`WIDTHS`].
fn width(columns: Option<u16>) -> usize {
    let stated = std::env::var("COLUMNS").ok();
    let stated = stated.and_then(|columns| columns.parse().ok());
    let of_terminal = columns.map(usize::from);
    let [least, most] = WIDTHS;
    stated
        .filter(|columns| *columns > 0)
        .or(of_terminal)
        .unwrap_or(UNKNOWN)
        .clamp(least, most)
}
