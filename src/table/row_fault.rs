//! Rows that are not read: rows without a shot, and rows that cannot be split into cells.

use super::column::Column;
use super::numbers::cell_number;
use super::records::Record;
use super::refusal::Refusal;
use crate::units::counted;

/// Reason why a row of a table is not read.
pub(crate) enum RowFault<'a> {
    /// A row of an export that summarizes other rows, with the word that identifies it, such as
    /// `Average`.
    Summary(&'a str),
    /// A row of an export with a single filled cell, which is a title, such as the name of a club.
    Title(&'a str),
    /// An unclosed quote, fewer cells than column heads, or a filled cell beyond them.
    Unreadable(Refusal),
}

impl<'a> RowFault<'a> {
    /// The fault of a record with the cells `row`, in a table with `width` columns; `None` for a
    /// row that can be read. `column` returns the column with an index, if its cells are read.
    pub fn find<'c, S: AsRef<str>>(
        record: &Record,
        row: &'a [S],
        width: usize,
        is_export: bool,
        column: impl Fn(usize) -> Option<&'c Column>,
    ) -> Option<Self> {
        if let Some(refusal) = record.unclosed() {
            return Some(Self::Unreadable(refusal));
        }
        let no_shot = is_export.then(|| Self::of_export(row, column)).flatten();
        no_shot.or_else(|| miscounted(row, width).map(Self::Unreadable))
    }

    /// Classifies a row of an export; `None` for a row that may hold a shot.
    fn of_export<'c, S: AsRef<str>>(
        row: &'a [S],
        column: impl Fn(usize) -> Option<&'c Column>,
    ) -> Option<Self> {
        if let Some(word) = summary(row.iter().map(AsRef::as_ref)) {
            return Some(Self::Summary(word));
        }
        let mut filled = row
            .iter()
            .map(AsRef::as_ref)
            .enumerate()
            .filter(|(_, cell)| !cell.is_empty());
        let (at, only) = filled.next()?;
        // `60°` is a value in a column of angles, but the title of a wedge elsewhere
        let is_value =
            |column: &Column| cell_number(only, column.format.has_decimal_comma()).is_some();
        let is_number = || only.parse::<f64>().is_ok() || column(at).is_some_and(is_value);
        let is_title = filled.next().is_none() && !is_number();
        is_title.then_some(Self::Title(only))
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

/// The word that identifies a statistic of other rows, such as `Average`; `None` for a row that may
/// hold a shot.
fn summary<'a>(cells: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    const WORDS: [&str; 17] = [
        "dev",
        "average",
        "averages",
        "avg",
        "mean",
        "median",
        "consistency",
        "std dev",
        "stddev",
        "stdev",
        "standard deviation",
        "deviation",
        "std deviation",
        "durchschnitt",
        "mittelwert",
        "standardabweichung",
        "Ø",
    ];
    let mut cells = cells.map(str::trim);
    // fast path: most cells contain none of the words
    cells.find(|cell| {
        let words = || {
            cell.split(|c: char| c.is_whitespace() || c == '.' || c == ':')
                .filter(|word| !word.is_empty())
        };
        let is = |known: &&str| {
            let mut known = known.split(' ');
            words().all(|word| {
                known
                    .next()
                    .is_some_and(|other| word.eq_ignore_ascii_case(other))
            }) && known.next().is_none()
        };
        let first = cell
            .bytes()
            .find(|byte| !matches!(byte, b'.' | b':' | b' '));
        let begins = |known: &&&str| {
            first.is_some_and(|first| known.as_bytes()[0].eq_ignore_ascii_case(&first))
        };
        WORDS.iter().filter(begins).any(is)
    })
}

/// Refusal of a row that has fewer cells than `heads`, the number of column heads, or a filled cell
/// beyond them.
fn miscounted<S: AsRef<str>>(row: &[S], heads: usize) -> Option<Refusal> {
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
