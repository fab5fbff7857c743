//! Rows that are not read: rows without a shot, and rows that cannot be split into cells.

use super::column::Column;
use super::label::Label;
use super::launch_monitor::words;
use super::numbers::cell_number;
use super::records::only_cell;
use super::refusal::Refusal;
use crate::units::counted;

/// Reason why a row of a table is not read.
pub(crate) enum RowFault<'a> {
    /// A row of an export that summarizes other rows, with the cell that says so, such as
    /// `Average`.
    Summary(&'a str),
    /// A row of an export with a single filled cell, which is a title, such as the name of a club.
    Title(&'a str),
    /// An unclosed quote, fewer cells than column heads, or a filled cell beyond them.
    Unreadable(Refusal),
}

impl<'a> RowFault<'a> {
    /// Classifies a row of an export; `None` for a row that may hold a shot.
    pub fn of_export<S: AsRef<str>>(row: &'a [S], columns: &[Column]) -> Option<Self> {
        // `60°` is a value in a column of angles, but the title of a wedge elsewhere
        let is_value = |column: &Column, cell: &str| {
            column.quantity().is_some()
                && cell_number(cell, column.format.has_decimal_comma()).is_some()
        };
        let is_number = |(at, cell): &(usize, &str)| {
            let column = columns.get(*at);
            cell.parse::<f64>().is_ok() || column.is_some_and(|column| is_value(column, cell))
        };
        match only_cell(row).filter(|only| !is_number(only)) {
            Some((_, title)) => Some(Self::Title(title)),
            None => summary(row, columns).map(Self::Summary),
        }
    }

    /// Reason for rejecting the row.
    pub fn refusal(self) -> Refusal {
        match self {
            Self::Summary(word) => Refusal::new(
                Refusal::SUMMARY,
                format!("the row sums up other rows ({word})"),
            ),
            Self::Title(word) => {
                Refusal::new(Refusal::TITLE, format!("the row is a title ({word})"))
            }
            Self::Unreadable(refusal) => refusal,
        }
    }
}

/// Rows without a shot, by kind.
#[derive(Clone, Debug, Default)]
pub(crate) struct NonShotRows {
    summaries: Vec<String>,
    titles: Vec<String>,
}

impl NonShotRows {
    /// Adds a row without a shot; `row` is its number.
    ///
    /// # Errors
    /// The refusal of an unreadable row, which may hold a shot.
    pub fn add(&mut self, row: u64, fault: RowFault<'_>) -> Result<(), Refusal> {
        let (rows, word) = match fault {
            RowFault::Summary(word) => (&mut self.summaries, word),
            RowFault::Title(word) => (&mut self.titles, word),
            RowFault::Unreadable(refusal) => return Err(refusal),
        };
        rows.push(format!("row {row} ({word})"));
        Ok(())
    }

    /// One message per kind of row.
    pub fn messages(&self) -> Vec<String> {
        [
            (&self.summaries, "sum up other rows"),
            (&self.titles, "are titles"),
        ]
        .into_iter()
        .filter(|(rows, _)| !rows.is_empty())
        .map(|(rows, what)| format!("rows left out, since they {what}: {}", rows.join(", ")))
        .collect()
    }
}

/// Finds the label columns by their heads. Left of the measured values, the cells of the first
/// `rows` may show a label too ([`Label::of_cells`]).
pub(super) fn find_labels(columns: &mut [Column], rows: &[Vec<String>]) {
    let is_measured = |column: &Column| column.quantity().is_some();
    let first = columns.iter().position(is_measured).unwrap_or_default();
    // a row with a single filled cell is a title
    let rows = || rows.iter().filter(|row| only_cell(row).is_none());
    for (at, column) in columns.iter_mut().enumerate() {
        if is_measured(column) {
            column.label = Some(Label::Number);
            continue;
        }
        let head = words(&column.head);
        column.label = Label::of_head(&head);
        if column.label.is_none() && at < first {
            let cells: Vec<&str> = rows().map(|row| row[at].as_str()).collect();
            column.label = Label::of_cells(&cells, head.is_empty());
        }
    }
}

/// The cell that names a statistic of other rows; `None` for a row that may hold a shot.
fn summary<'a, S: AsRef<str>>(row: &'a [S], columns: &[Column]) -> Option<&'a str> {
    let mut cells = row.iter().map(AsRef::as_ref).zip(columns);
    let is_statistic =
        |cell: &str, column: &Column| column.label.is_some_and(|label| label.is_statistic(cell));
    let (cell, _) = cells.find(|(cell, column)| is_statistic(cell, column))?;
    Some(cell)
}

/// Refusal of a row that has fewer cells than `heads`, the number of column heads, or a filled cell
/// beyond them.
pub(super) fn miscounted<S: AsRef<str>>(row: &[S], heads: usize) -> Option<Refusal> {
    let filled = row
        .iter()
        .rposition(|cell| !cell.as_ref().is_empty())
        .map_or(0, |at| at + 1);
    if row.len() >= heads && filled <= heads {
        return None;
    }
    let [row, head] = [row.len(), heads].map(|count| counted(count as u64, "cell"));
    let reason = format!(
        "the row has {row}, but the head has {head}; give every row a cell for each column"
    );
    Some(Refusal::new(Refusal::CELLS, reason))
}
