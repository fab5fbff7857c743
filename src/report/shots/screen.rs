//! Flown shots for a terminal: six columns of fixed width.

use super::columns::launch;
use crate::drive::Outcome;
use crate::report::shown;
use crate::shots::Flown;
use crate::units::{System, printed};

/// Width of the column with the line numbers, in characters.
const LINE: usize = 5;

/// Width of each other column, in characters.
const WIDTH: usize = 15;

/// Two lines of column heads: the outcomes, and their units. The columns are the launch of a shot,
/// the predicted value of `of`, and the residual (predicted − measured).
pub(super) fn head(of: Option<Outcome>, system: System) -> Vec<u8> {
    let launch = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Spin];
    let columns = launch.into_iter().chain(of.into_iter().cycle().take(2));
    let mut names = vec!["line".to_owned()];
    let mut units = vec![String::new()];
    for (column, of) in columns.enumerate() {
        names.push(match column {
            4 => "residual".into(),
            _ => shown::words(of.name()),
        });
        units.push(format!("[{}]", printed(system.unit(of.unit()))));
    }
    let mut bytes = vec![];
    for cells in [names, units] {
        push(&mut bytes, &cells);
        bytes.push(b'\n');
    }
    bytes
}

/// Appends the cells of a row.
pub(super) fn row(
    of: Option<Outcome>,
    system: System,
    flown: &Flown,
    row: usize,
    bytes: &mut Vec<u8>,
) {
    let shot = &flown.shots[row];
    let [speed, angle, _, spin, _] = launch(shot);
    let launch = [
        (Outcome::BallSpeed, speed),
        (Outcome::LaunchAngle, angle),
        (Outcome::Spin, spin),
    ];
    let mut cells = vec![shot.line.to_string()];
    cells.extend(launch.map(|(of, value)| shown::number_or_dash(of, value, system)));
    if let Some(of) = of {
        cells.push(match flown.predicted(row, 0) {
            Some(value) => shown::number_or_dash(of, Some(value), system),
            None => flown.flight(row).to_owned(),
        });
        cells.push(shown::signed_or_dash(of, flown.residual(row, 0), system));
    }
    push(bytes, &cells);
}

/// Appends the cells of a line, right-aligned.
fn push(bytes: &mut Vec<u8>, cells: &[String]) {
    for (column, cell) in cells.iter().enumerate() {
        let width = if column == 0 { LINE } else { WIDTH };
        bytes.extend(format!("{cell:>width$}").into_bytes());
    }
}
