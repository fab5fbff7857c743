//! Flown shots for a terminal: six columns of fixed width.

use super::columns::launch;
use crate::drive::Outcome;
use crate::report::shown;
use crate::shots::Flown;
use crate::units::{System, printed, signed};

/// Width of the column with the line numbers, in characters.
const LINE: usize = 5;

/// Width of each other column, in characters.
const WIDTH: usize = 15;

/// Table of the launch of each shot, the predicted value of the first requested outcome, and the
/// residual (predicted − measured).
#[derive(Clone, Debug)]
pub(super) struct Screen {
    pub of: Option<Outcome>,
    pub system: System,
}

impl Screen {
    /// Two lines of column heads: the outcomes, and their units.
    pub fn head(&self) -> Vec<u8> {
        let launch = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Spin];
        let columns = launch
            .into_iter()
            .chain(self.of.iter().copied().cycle().take(2));
        let unit = |of: Outcome| format!("[{}]", printed(self.system.unit(of.unit())));
        let mut names = vec!["line".to_owned()];
        let mut units = vec![String::new()];
        for (column, of) in columns.enumerate() {
            names.push(match column {
                4 => "residual".into(),
                _ => shown::words(of.name()),
            });
            units.push(unit(of));
        }
        let mut bytes = vec![];
        for cells in [names, units] {
            push(&mut bytes, &cells);
            bytes.push(b'\n');
        }
        bytes
    }

    /// Appends the cells of a row.
    pub fn row(&self, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
        let shot = &flown.shots[row];
        let [speed, angle, _, spin, _] = launch(shot);
        let launch = [
            (Outcome::BallSpeed, speed),
            (Outcome::LaunchAngle, angle),
            (Outcome::Spin, spin),
        ];
        let mut cells = vec![shot.line.to_string()];
        cells.extend(launch.map(|(of, value)| self.number(of, value, false)));
        if let Some(of) = self.of {
            cells.push(match flown.predicted(row, 0) {
                Some(carry) => self.number(of, Some(carry), false),
                None => flown.flight(row).to_owned(),
            });
            cells.push(self.number(of, flown.residual(row, 0), true));
        }
        push(bytes, &cells);
    }

    fn number(&self, of: Outcome, value: Option<f64>, has_sign: bool) -> String {
        let Some(value) = value else {
            return shown::NONE.into();
        };
        let unit = self.system.unit(of.unit());
        let text = of.quantity().read_off_number(value, unit);
        if has_sign { signed(value, text) } else { text }
    }
}

/// Appends the cells of a line, right-aligned.
fn push(bytes: &mut Vec<u8>, cells: &[String]) {
    for (column, cell) in cells.iter().enumerate() {
        let width = if column == 0 { LINE } else { WIDTH };
        bytes.extend(format!("{cell:>width$}").into_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::{Outcome, Screen, System};

    #[test]
    fn exact_digits_of_each_quantity() {
        let screen = Screen {
            of: None,
            system: System::Us,
        };
        for (of, value, shown) in [
            (Outcome::FlightTime, 5.2408, "5.24"),
            (Outcome::SmashFactor, 1.474, "1.47"),
            (Outcome::Spin, 213.1, "2035"),
            (Outcome::BallSpeed, 72.4216, "162.0"),
        ] {
            assert_eq!(screen.number(of, Some(value), false), shown);
        }
    }
}
