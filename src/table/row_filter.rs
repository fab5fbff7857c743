//! Selects rows of a text table by the text of their cells.

use super::launch_monitor::{split_unit, words};
use crate::error::{Error, Result};
use crate::units::Message;
use std::collections::BTreeMap;

/// Maximum number of values of a column that a message lists.
const MOST_VALUES: usize = 12;

/// Conditions on the cells of a row. In each named column, the cell must equal one of the allowed
/// values; upper and lower case are equivalent.
///
/// ```
/// use longdrive::table::RowFilter;
/// assert!(RowFilter::read(&["Club=Driver".into()]).is_ok());
/// assert!(RowFilter::read(&["Driver".into()]).is_err());
/// ```
#[derive(Clone, Debug, Default)]
pub struct RowFilter {
    columns: Vec<ColumnFilter>,
    rows: u64,
    kept: u64,
}

/// The allowed values of a column.
#[derive(Clone, Debug)]
struct ColumnFilter {
    name: String,
    values: Vec<String>,
    /// Index of the column in the current section.
    at: usize,
    /// Number of rows for each text in this column; at most [`MOST_VALUES`] texts.
    seen: BTreeMap<String, u64>,
    /// True if the column has texts that `seen` does not list.
    has_others: bool,
}

impl RowFilter {
    /// Reads conditions `COLUMN=VALUE`. Several values of one column are alternatives.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if a text has no column or no value.
    pub fn read(texts: &[String]) -> Result<Self> {
        let mut columns: Vec<ColumnFilter> = vec![];
        for text in texts {
            let condition = text
                .split_once('=')
                .map(|(name, value)| (name.trim(), value.trim()))
                .filter(|(name, value)| !name.is_empty() && !value.is_empty());
            let (name, value) = condition.ok_or_else(|| Error::Unreadable {
                name: format!("`only {text}`"),
                source: "write COLUMN=VALUE, for example Club=Driver".into(),
            })?;
            match columns.iter_mut().find(|column| column.is_named(name)) {
                Some(column) => column.values.push(value.into()),
                None => columns.push(ColumnFilter {
                    name: name.into(),
                    values: vec![value.into()],
                    at: 0,
                    seen: BTreeMap::new(),
                    has_others: false,
                }),
            }
        }
        Ok(Self {
            columns,
            rows: 0,
            kept: 0,
        })
    }

    /// True if there are no conditions.
    pub fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    /// True if there is a condition on this column.
    pub(crate) fn names(&self, head: &str) -> bool {
        self.columns.iter().any(|column| column.is_named(head))
    }

    /// Finds the columns of the conditions among the column heads of a section.
    ///
    /// # Errors
    /// A message, if there is no column with the name in a condition.
    pub(super) fn begin(&mut self, heads: &[String]) -> Result<(), String> {
        for column in &mut self.columns {
            let at = heads.iter().position(|head| column.is_named(head));
            column.at = at.ok_or_else(|| {
                let heads: Vec<_> = heads.iter().filter(|head| !head.is_empty()).collect();
                let heads = heads.iter().map(|head| head.as_str()).collect::<Vec<_>>();
                format!(
                    "`only` names the column '{}', which the table does not have; its columns are \
                     {}",
                    column.name,
                    heads.join(", ")
                )
            })?;
        }
        Ok(())
    }

    /// True if the row satisfies the conditions. Also counts the row and the texts of its cells.
    pub(super) fn takes(&mut self, row: &[String]) -> bool {
        let mut is_taken = true;
        for column in &mut self.columns {
            let cell = row.get(column.at).map_or("", |cell| cell.trim());
            is_taken &= column.values.iter().any(|value| is_like(value, cell));
            if column.seen.len() < MOST_VALUES || column.seen.contains_key(cell) {
                *column.seen.entry(cell.into()).or_default() += 1;
            } else {
                column.has_others = true;
            }
        }
        self.rows += 1;
        self.kept += u64::from(is_taken);
        is_taken
    }

    /// Checks after the last row that some row satisfied the conditions.
    ///
    /// # Errors
    /// A message with the values of the columns, if no row satisfied the conditions.
    pub(super) fn finish(&self) -> Result<(), String> {
        if self.is_empty() || self.kept > 0 || self.rows == 0 {
            return Ok(());
        }
        let of_column = |column: &ColumnFilter| {
            let values = counted_values(column.seen.iter());
            let more = if column.has_others { ", …" } else { "" };
            format!("; {} is {values}{more}", column.name)
        };
        let listed: String = self.columns.iter().map(of_column).collect();
        Err(format!("no row has {}{listed}", self.conditions()))
    }

    /// A remark on the number of rows so far that satisfy the conditions; `None` without
    /// conditions.
    pub(crate) fn remark(&self) -> Option<Message> {
        let (kept, rows) = (self.kept, self.rows);
        (!self.is_empty()).then(|| format!("{}: {kept} of {rows} rows", self.conditions()).into())
    }

    /// The conditions: `Club = Driver or 3 Wood, Player = A`.
    fn conditions(&self) -> String {
        let of_column =
            |column: &ColumnFilter| format!("{} = {}", column.name, column.values.join(" or "));
        self.columns
            .iter()
            .map(of_column)
            .collect::<Vec<_>>()
            .join(", ")
    }
}

impl ColumnFilter {
    /// True if `head` is the head of this column, with or without its unit.
    fn is_named(&self, head: &str) -> bool {
        is_like(&self.name, head) || words(&self.name) == words(split_unit(head).0)
    }
}

fn is_like(a: &str, b: &str) -> bool {
    a.trim().to_lowercase() == b.trim().to_lowercase()
}

/// Values with their numbers of rows: `Driver (14), 3 Wood (3)`.
pub(crate) fn counted_values<'a>(
    counts: impl IntoIterator<Item = (&'a String, &'a u64)>,
) -> String {
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(value, count)| (std::cmp::Reverse(**count), (*value).clone()));
    let shown = |(value, count): (&String, &u64)| match value.as_str() {
        "" => format!("empty ({count})"),
        value => format!("{value} ({count})"),
    };
    counts.into_iter().map(shown).collect::<Vec<_>>().join(", ")
}

/// Column heads of the column that names the club, in lower case without punctuation, best first.
const OF_CLUB: [&str; 4] = ["club type", "club", "club name", "schlägerart"];

/// Index of the column that names the club; `None` if there is none. `is_text` is true for a column
/// without numbers.
pub(crate) fn club_column(heads: &[String], is_text: impl Fn(usize) -> bool) -> Option<usize> {
    OF_CLUB.iter().find_map(|known| {
        let named = |at: &usize| words(&heads[*at]) == *known && is_text(*at);
        (0..heads.len()).find(named)
    })
}
