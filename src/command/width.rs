//! The width of the terminal: that of `COLUMNS` if it is set, else that of the stream.

use std::io;
use terminal_size::{Height, Width, terminal_size_of};

/// Width of text if no terminal is known, columns.
pub const UNKNOWN: usize = 80;

/// Minimum and maximum width of text, columns. Longer lines are hard to read.
const WIDTHS: [usize; 2] = [40, 120];

/// Width of answers and help on standard output, columns.
pub fn of_answers() -> usize {
    width(terminal_size_of(io::stdout()))
}

/// Width of messages on standard error, columns.
pub fn of_messages() -> usize {
    width(terminal_size_of(io::stderr()))
}

fn width(size: Option<(Width, Height)>) -> usize {
    let stated = std::env::var("COLUMNS").ok();
    let stated = stated.and_then(|columns| columns.parse().ok());
    let of_terminal = size.map(|(Width(columns), _)| usize::from(columns));
    let [least, most] = WIDTHS;
    stated
        .filter(|columns| *columns > 0)
        .or(of_terminal)
        .unwrap_or(UNKNOWN)
        .clamp(least, most)
}
