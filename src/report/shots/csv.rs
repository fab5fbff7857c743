//! Rows of an export with added columns for the predictions.

use crate::drive::Outcome;
use crate::report::csv_text::push_number;
use crate::shots::{Flown, ShotColumns};
use crate::table::{DecimalMark, OF_FLOWN, cells, quoted};
use crate::units::{DisplayUnit, System};
use std::sync::Arc;

/// Numbers in a table are multiples of 1/`DECIMALS`: four decimals, about 0.1 mm for a length.
const DECIMALS: f64 = 1e4;

/// The added columns: line, status of the flight, reason for a missing flight, notes, predicted
/// outcomes, and residuals.
#[derive(Clone, Debug)]
pub(super) struct PredictionColumns {
    pub of: Vec<Outcome>,
    pub system: System,
    pub separator: u8,
    pub has_decimal_comma: bool,
}

impl PredictionColumns {
    /// The column heads, each with its unit.
    pub fn heads(&self) -> Vec<(String, &'static str)> {
        let words = OF_FLOWN.map(|word| (word.to_owned(), ""));
        let of = |before: &'static str| {
            self.of.iter().map(move |of| {
                let unit = self.system.unit(of.unit());
                (format!("{before} {}", of.name()), unit)
            })
        };
        words
            .into_iter()
            .chain(of("Predicted"))
            .chain(of("Residual"))
            .collect()
    }

    /// Appends a number in the unit of the outcome; an empty cell for `None`.
    pub fn push(&self, bytes: &mut Vec<u8>, value: Option<f64>, of: Outcome) {
        let Some(value) = value else { return };
        let size = DisplayUnit::from(of).size_in(self.system);
        let number = (value / size * DECIMALS).round() / DECIMALS;
        let from = bytes.len();
        push_number(bytes, number);
        if self.has_decimal_comma {
            bytes[from..]
                .iter_mut()
                .filter(|byte| **byte == b'.')
                .for_each(|byte| *byte = b',');
        }
    }

    /// Appends a text.
    pub fn push_text(&self, bytes: &mut Vec<u8>, text: &str) {
        bytes.extend_from_slice(quoted(text, self.separator).as_bytes());
    }

    /// Appends the added cells of a row. No separator precedes the first cell.
    pub fn row(&self, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
        let shot = &flown.shots[row];
        bytes.extend_from_slice(shot.line.to_string().as_bytes());
        for text in [flown.flight(row), flown.reason(row).unwrap_or_default()] {
            bytes.push(self.separator);
            self.push_text(bytes, text);
        }
        bytes.push(self.separator);
        if !shot.notes.is_empty() {
            self.push_text(bytes, &shot.notes.join("; "));
        }
        for (outcome, of) in self.of.iter().enumerate() {
            bytes.push(self.separator);
            self.push(bytes, flown.predicted(row, outcome), *of);
        }
        for (outcome, of) in self.of.iter().enumerate() {
            bytes.push(self.separator);
            self.push(bytes, flown.residual(row, outcome), *of);
        }
    }
}

/// The rows of an export, unchanged, with the added columns.
#[derive(Clone, Debug)]
pub(super) struct ExportRows {
    columns: Arc<ShotColumns>,
    pub added: PredictionColumns,
}

impl ExportRows {
    pub fn new(columns: &Arc<ShotColumns>, of: &[Outcome], system: System) -> Self {
        Self {
            columns: columns.clone(),
            added: PredictionColumns {
                of: of.to_vec(),
                system,
                separator: columns.separator,
                has_decimal_comma: columns.head.format.decimal_mark == Some(DecimalMark::Comma),
            },
        }
    }

    /// The cells of a line, one for each column head, but without the cells that an earlier run of
    /// `fly` added. A missing cell at the end of the line is empty.
    fn own<'a, S: AsRef<str>>(&self, cells: &'a [S]) -> impl Iterator<Item = &'a str> {
        let (count, added) = (
            self.columns.head.heads.len(),
            self.columns.head.flown.clone(),
        );
        let cells = (0..count).map(|at| cells.get(at).map_or("", AsRef::as_ref));
        cells
            .enumerate()
            .filter(move |(at, _)| !added.contains(at))
            .map(|(_, cell)| cell)
    }

    pub fn head(&self) -> Vec<u8> {
        let separator = char::from(self.added.separator).to_string();
        let line = |own: &[String], added: Vec<String>| {
            let cells = self.own(own).chain(added.iter().map(String::as_str));
            let cells = cells.map(|cell| quoted(cell, self.added.separator));
            cells.collect::<Vec<_>>().join(&separator) + "\n"
        };
        let heads = self.added.heads();
        let in_brackets = |unit: &str| {
            if unit.is_empty() {
                String::new()
            } else {
                format!("[{unit}]")
            }
        };
        let text = match &self.columns.head.units {
            Some(units) => {
                let (names, below) = heads
                    .into_iter()
                    .map(|(name, unit)| (name, in_brackets(unit)))
                    .unzip();
                line(&self.columns.head.heads, names) + &line(units, below)
            }
            None => {
                let names = heads.into_iter().map(|(name, unit)| {
                    format!("{name} {}", in_brackets(unit))
                        .trim_end()
                        .to_owned()
                });
                line(&self.columns.head.heads, names.collect())
            }
        };
        text.into_bytes()
    }

    pub fn row(&self, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
        let shot = &flown.shots[row];
        let separator = self.added.separator;
        if shot
            .refusal()
            .is_some_and(|refusal| refusal.is_unreadable())
        {
            // write the row as one cell: its values may not belong to the column heads above them
            bytes.extend_from_slice(format!("\"{}\"", shot.text.replace('"', "\"\"")).as_bytes());
            bytes.extend(std::iter::repeat_n(
                separator,
                self.own(&self.columns.head.heads).count() - 1,
            ));
        } else if shot.has_cells_of_head && self.columns.head.flown.is_empty() {
            bytes.extend_from_slice(shot.text.as_bytes());
        } else {
            // omit the cells that an earlier run of `fly` added, and empty cells beyond the last
            // column head
            for (at, cell) in self
                .own(&cells(&shot.text, self.columns.separator))
                .enumerate()
            {
                if at > 0 {
                    bytes.push(separator);
                }
                self.added.push_text(bytes, cell);
            }
        }
        bytes.push(separator);
        self.added.row(flown, row, bytes);
    }
}
