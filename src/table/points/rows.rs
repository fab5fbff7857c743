use super::columns::PointColumns;
use crate::batch::{CHUNK, Points, Status};
use crate::error::Result;
use crate::fingerprint::Fingerprint;
use crate::parameters::{Parameter, Vary};
use crate::units::Message;

/// The rows of a table of points, in any format.
pub(super) trait PointRows {
    fn columns(&self) -> &PointColumns;

    /// Goes back to the first row.
    fn rewind(&mut self) -> Result<()>;

    /// Appends the values of the next rows, at most `most` of them, as [`Points::read`] does, and
    /// the number of each row below the column heads, from 1. Returns how many rows were read. A
    /// missing value is NaN.
    fn read(&mut self, most: usize, values: &mut Vec<f64>, numbers: &mut Vec<u64>)
    -> Result<usize>;

    /// Remarks on the columns and rows, complete after the last row.
    fn notes(&self) -> Vec<Message> {
        self.columns().notes.clone()
    }
}

/// Number of invalid rows that a message lists individually.
const LISTED: usize = 5;

/// A table of points. Opening reads it once, so that unreadable and invalid rows are reported
/// before any work.
pub(super) struct TablePoints<R> {
    rows: R,
    count: u64,
    ranges: Vec<Vary>,
    fingerprint: Fingerprint,
    notes: Vec<Message>,
    next: u64,
}

impl<R: PointRows> TablePoints<R> {
    /// Reads the whole table once.
    ///
    /// # Errors
    /// The errors of reading the rows.
    pub fn new(mut rows: R) -> Result<Self> {
        let none = |parameter: &&'static Parameter| Vary {
            parameter,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
        };
        let mut ranges: Vec<Vary> = rows.columns().parameters.iter().map(none).collect();
        let (mut count, mut fingerprint) = (0, Fingerprint::new());
        let (mut values, mut numbers) = (vec![], vec![]);
        let (mut listed, mut others) = (vec![], 0);
        loop {
            match rows.read(CHUNK, &mut values, &mut numbers)? {
                0 => break,
                more => count += more as u64,
            }
            for (row, number) in values.chunks(ranges.len()).zip(&numbers) {
                let wrong = ranges
                    .iter()
                    .zip(row)
                    .find_map(|(range, value)| why_invalid(range.parameter, *value));
                match wrong {
                    Some(why) if listed.len() < LISTED => {
                        listed.push(format!("row {number}: {why}"));
                    }
                    Some(_) => others += 1,
                    None => {}
                }
                for (range, value) in ranges.iter_mut().zip(row) {
                    fingerprint.add(*value);
                    if range.parameter.range.contains(*value) {
                        (range.low, range.high) = (range.low.min(*value), range.high.max(*value));
                    }
                }
            }
            values.clear();
            numbers.clear();
        }
        ranges.retain(|range| range.low <= range.high);
        let mut notes = rows.notes();
        notes.extend(note_of_invalid(listed, others));
        rows.rewind()?;
        Ok(Self {
            rows,
            count,
            ranges,
            fingerprint,
            notes,
            next: 0,
        })
    }
}

/// Message about invalid rows: it lists the first rows with their reasons, and counts the others.
/// `None` without invalid rows.
fn note_of_invalid(mut listed: Vec<String>, others: u64) -> Option<Message> {
    if others > 0 {
        listed.push(format!("and {others} more"));
    }
    if listed.is_empty() {
        return None;
    }
    let (status, rows) = (Status::OutOfRange, listed.join("; "));
    Some(format!("rows with invalid values, which get the status {status}: {rows}").into())
}

/// Reason why a value is invalid: it is missing or out of range. `None` for a valid value.
fn why_invalid(parameter: &'static Parameter, value: f64) -> Option<String> {
    let name = parameter.name;
    if value.is_nan() {
        return Some(format!("{name} is missing"));
    }
    let range = || parameter.range.show(parameter.quantity, parameter.unit);
    let shown = || parameter.show(Some(value));
    (!parameter.range.contains(value))
        .then(|| format!("{name} = {} is outside of its range {}", shown(), range()))
}

impl<R: PointRows> Points for TablePoints<R> {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.rows.columns().parameters
    }

    fn ranges(&self) -> Vec<Vary> {
        self.ranges.clone()
    }

    fn rows(&self) -> u64 {
        self.count
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        if row < self.next {
            self.rows.rewind()?;
            self.next = 0;
        }
        let mut passed = vec![];
        while self.next < row {
            let most = usize::try_from(row - self.next).unwrap_or(CHUNK).min(CHUNK);
            passed.clear();
            if self.read(most, &mut passed)? == 0 {
                break;
            }
        }
        Ok(())
    }

    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
        // ignore rows that were appended after the table was opened
        let left = usize::try_from(self.count - self.next).unwrap_or(most);
        let rows = self.rows.read(most.min(left), values, &mut vec![])?;
        self.next += rows as u64;
        Ok(rows)
    }

    fn notes(&self) -> Vec<Message> {
        self.notes.clone()
    }

    /// A text that identifies the rows of a table. Equal rows have equal texts, in any format.
    fn identity(&self) -> String {
        let names: Vec<_> = self
            .parameters()
            .iter()
            .map(|parameter| parameter.name)
            .collect();
        format!(
            "table of {} rows of {}, fingerprint {:016x}",
            self.count,
            names.join(" "),
            self.fingerprint.0
        )
    }
}
