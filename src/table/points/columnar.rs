use super::columns::PointColumns;
use super::rows::PointRows;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::table::TableHead;
use std::ops::Range;
use std::path::Path;

/// A file of numeric columns in SI that is read in pieces (row groups, record batches). The columns
/// have the names of parameters.
pub(super) trait ColumnarFile: Sized {
    /// Opens the file; the error is a sentence.
    fn open(path: &Path) -> Result<Self, String>;

    /// Column names.
    fn names(&self) -> Vec<String>;

    /// Reason why a column cannot be read as numbers; `None` for a numeric column.
    fn refusal(&self, column: usize) -> Option<String>;

    /// Goes back to the first piece.
    fn rewind(&mut self);

    /// Moves to the next piece and returns its number of rows; `None` at the end.
    fn next_piece(&mut self) -> Result<Option<usize>, String>;

    /// The values of a column in these rows of the current piece. The caller must read each column
    /// in the order of the rows, and each value once.
    fn values(&mut self, column: usize, rows: Range<usize>) -> Result<Vec<Option<f64>>, String>;
}

/// Rows of a file read in pieces.
pub(super) struct ColumnarRows<P> {
    /// Name of the file, for messages.
    file: String,
    columns: PointColumns,
    pieces: P,
    /// The unread rows of the current piece.
    unread: Range<usize>,
    /// Number of rows read from all pieces.
    next: u64,
}

impl<P: ColumnarFile> ColumnarRows<P> {
    /// Opens a file and interprets its columns.
    ///
    /// # Errors
    /// [`Error::Table`] if the file is unreadable or truncated, or if a column
    /// is not a parameter, is repeated or is not numeric. Reading a row fails if a value is
    /// infinite, unless the parameter allows infinity.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        let pieces = P::open(path).map_err(|reason| Error::table(&file, "", reason))?;
        let names = pieces.names();
        let mut head = TableHead::in_si(setup, &names, &file)?;
        let columns = PointColumns::new(setup, &file, &mut head)?;
        let refusal = columns
            .at
            .iter()
            .find_map(|at| Some((&names[*at], pieces.refusal(*at)?)));
        match refusal {
            Some((name, reason)) => Err(Error::table(file, format!(", column {name}"), reason)),
            None => Ok(Self {
                file,
                columns,
                pieces,
                unread: 0..0,
                next: 0,
            }),
        }
    }
}

impl<P: ColumnarFile> PointRows for ColumnarRows<P> {
    fn columns(&self) -> &PointColumns {
        &self.columns
    }

    fn rewind(&mut self) -> Result<()> {
        self.pieces.rewind();
        (self.unread, self.next) = (0..0, 0);
        Ok(())
    }

    fn read(&mut self, most: usize, into: &mut Vec<f64>, numbers: &mut Vec<u64>) -> Result<usize> {
        let PointColumns { at, parameters, .. } = &self.columns;
        let refused = |place: String, reason: String| Error::table(&self.file, place, reason);
        let mut rows = 0;
        // a chunk may span several pieces
        while rows < most {
            let place = || {
                if self.next == 0 {
                    String::new()
                } else {
                    format!(", after row {}", self.next)
                }
            };
            if self.unread.is_empty() {
                let next = self.pieces.next_piece();
                let Some(rows_of_piece) = next.map_err(|reason| refused(place(), reason))? else {
                    break;
                };
                self.unread = 0..rows_of_piece;
                continue;
            }
            let wanted = self.unread.len().min(most - rows);
            let part = self.unread.start..self.unread.start + wanted;
            let first = into.len();
            into.resize(first + wanted * at.len(), 0.0);
            for (i, (at, parameter)) in at.iter().zip(parameters).enumerate() {
                let values = self.pieces.values(*at, part.clone()).map_err(|reason| {
                    let rows = format!(", rows {} to {}", self.next + 1, self.next + wanted as u64);
                    refused(format!("{rows}, column {}", parameter.name), reason)
                })?;
                // a damaged file may return too few values: the rest is missing
                let values = values.into_iter().chain(std::iter::repeat(None));
                for (row, value) in values.take(wanted).enumerate() {
                    into[first + row * parameters.len() + i] =
                        checked(parameter, value).map_err(|reason| {
                            let row = self.next + row as u64 + 1;
                            refused(format!(", row {row}, column {}", parameter.name), reason)
                        })?;
                }
            }
            self.unread.start = part.end;
            let before = self.next;
            self.next += wanted as u64;
            numbers.extend(before + 1..=self.next);
            rows += wanted;
        }
        Ok(rows)
    }
}

/// A value of a row; NaN if it is missing. Refuses infinity, unless the parameter allows it: the
/// radius of a flat face is infinite.
fn checked(parameter: &Parameter, value: Option<f64>) -> Result<f64, String> {
    let Some(value) = value else {
        return Ok(f64::NAN);
    };
    if value.is_finite() || value.is_nan() || parameter.range.contains(value) {
        return Ok(value);
    }
    Err(format!(
        "{value} is not finite; every row needs a finite number"
    ))
}
