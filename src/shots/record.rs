//! The records of a table that is read as a whole, and why one has no cells.

use super::lines::{Lines, Record};
use super::shot::Refusal;
use super::table::Table;
use crate::error::Result;
use std::io::Cursor;

/// The records of a text. A quote that is not closed takes no other record with it.
///
/// # Errors
/// [`Error::Table`](crate::Error::Table) for a line that no table has.
pub(crate) fn records(file: &str, text: &str, separator: u8) -> Result<Vec<Record>> {
    let table = Table(file.into());
    let mut lines = Lines::new(Box::new(Cursor::new(text.to_owned())), text);
    std::iter::from_fn(|| table.io(lines.record(separator)).transpose()).collect()
}

impl Record {
    /// Why it cannot be taken apart into cells, where its quote is not closed.
    pub(crate) fn unclosed(&self) -> Option<Refusal> {
        let reason = "a quote (\") is opened and not closed; close it, or take it out";
        self.is_open.then(|| Refusal::new(Refusal::QUOTE, reason))
    }
}

/// Why a row has not the cells of its head: one for each of so many columns, and nothing beyond.
pub(crate) fn miscounted<S: AsRef<str>>(row: &[S], heads: usize) -> Option<Refusal> {
    let filled = row.iter().rposition(|cell| !cell.as_ref().is_empty()).map_or(0, |at| at + 1);
    if row.len() >= heads && filled <= heads {
        return None;
    }
    let counted = |count: usize| if count == 1 { "1 cell".into() } else { format!("{count} cells") };
    let (row, head) = (counted(row.len()), counted(heads));
    let reason = format!("the row has {row}, but the head has {head}; give every row a cell for each column");
    Some(Refusal::new(Refusal::CELLS, reason))
}
