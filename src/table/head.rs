//! The column heads of a table: meaning of the columns, and errors in column heads.

use super::CONDITIONS;
use super::air::{air_replaced, weather_of_rows};
use super::column::{Column, Content, LAUNCH, STATUS, TableFormat};
use super::decimal_mark::DecimalMark;
use super::export_columns::{
    assume_unit, assumed_units_remark, columns_remark, ignore_columns, in_degrees,
};
use super::launch_monitor::{is_export, split_unit, units_row, words};
use super::maker::maker;
use super::records::Record;
use super::row_fault::{RowFault, find_labels, miscounted};
use super::sign_conventions::{turn_spins, turned_remark};
use super::table_use::TableUse;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::units::Message;
use std::ops::Range;

/// First columns that `fly` adds to the shots.
pub(crate) const OF_FLOWN: [&str; 4] = ["Line", "Flight", "Reason", "Notes"];
/// Prefixes of the columns that `fly` adds behind [`OF_FLOWN`].
const FLOWN_PREFIXES: [&str; 2] = ["Predicted ", "Residual "];

/// The column heads of a table, interpreted.
#[derive(Clone, Debug, Default)]
pub(crate) struct TableHead {
    /// The column heads as written.
    pub heads: Vec<String>,
    /// The columns in order.
    pub columns: Vec<Column>,
    /// Format of the table.
    pub format: TableFormat,
    /// Cells of the line of units; `None` without this line.
    pub units: Option<Vec<String>>,
    /// The first rows of the section that have a cell for each head. Units, decimal mark and signs
    /// of the columns are detected from them. Empty for a table in SI.
    pub rows: Vec<Vec<String>>,
    /// Remarks on columns, such as ignored ones.
    pub remarks: Vec<Message>,
    /// The columns without a unit, each with the assumed unit.
    pub assumed_units: Vec<String>,
    /// Remark on the encoding.
    pub encoding: Option<&'static str>,
    /// Maker of an export, if the column heads identify it.
    pub maker: Option<&'static str>,
    /// Remark on columns whose positive values are to the left.
    pub turned: Option<String>,
    /// Indices of the columns that an earlier run of `fly` added: line, flight status, reason,
    /// notes, then outcomes. Empty without such columns.
    pub flown: Range<usize>,
}

impl TableHead {
    /// Interprets the column heads of a text table; `first` is the row below, which may contain
    /// units. `file` is the name for messages.
    ///
    /// # Errors
    /// [`Error::Table`] if a column cannot be read. If several names are unknown, the message lists
    /// them all. Otherwise it reports the first column that cannot be read.
    pub fn read(
        setup: &Setup<f64>,
        heads: Vec<String>,
        first: Option<Vec<String>>,
        separator: u8,
        table_use: TableUse,
        file: &str,
    ) -> Result<Self> {
        let is_export = is_export(heads.iter().map(String::as_str));
        let format = TableFormat {
            is_export,
            decimal_mark: (separator == b',').then_some(DecimalMark::Point),
        };
        let units = first.as_ref().and_then(|first| units_row(&heads, first));
        let flown = flown_columns(&heads);
        let column = |(at, head): (usize, &String)| {
            if flown.contains(&at) {
                return (at, Ok(Column::of(Content::Written, split_unit(head).0)));
            }
            let below = units.as_ref().and_then(|units| units.get(at)?.as_deref());
            (at, Column::read(setup, head, below, format))
        };
        let mut columns = all(
            heads.iter().enumerate().map(column),
            table_use.advice(),
            file,
        )?;
        if !table_use.has_air_of_rows() {
            let of_air = columns.iter_mut().filter(|column| column.is_stated_air());
            of_air.for_each(|column| column.content = Content::Note);
        }
        let units = units.and(first);
        Ok(Self {
            heads,
            columns,
            format,
            units,
            flown,
            ..Self::default()
        })
    }

    /// Interprets the columns by the first `rows` of the section: finds the decimal mark, and the
    /// meaning of columns that the heads alone do not tell.
    pub fn interpret(&mut self, setup: &Setup<f64>, rows: Vec<Vec<String>>, table_use: TableUse) {
        self.rows = rows;
        self.detect_decimal_mark();
        if self.format.is_export {
            self.interpret_export(setup, table_use);
        }
        resolve_sweep_names(&mut self.columns);
    }

    /// Finds the maker of an export, the signs of its spins and the air of its rows. Ignores columns
    /// that are not used, and assumes missing units.
    fn interpret_export(&mut self, setup: &Setup<f64>, table_use: TableUse) {
        self.maker = maker(&self.heads);
        find_labels(&mut self.columns, &self.rows);
        let turned = turn_spins(self.maker, &mut self.columns, &self.rows);
        if table_use.has_air_of_rows() {
            weather_of_rows(setup, &mut self.columns, &self.rows);
        }
        if self.maker == Some("Foresight") {
            // `Offline` is the lateral position at rest
            let columns = self.columns.iter_mut();
            for column in columns.filter(|column| words(&column.head) == "offline") {
                column.content = Content::Outcome(Outcome::LateralTotal);
            }
        }
        self.remarks = ignore_columns(&mut self.columns, table_use);
        self.turned = turned_remark(&self.columns, &turned);
        // a parameter of a sweep needs a stated unit
        if table_use != TableUse::Points {
            for at in 0..self.columns.len() {
                let (before, others) = self.columns.split_at_mut(at);
                // a repeated column is not read
                if before
                    .iter()
                    .all(|column| column.content != others[0].content)
                {
                    self.assumed_units
                        .extend(assume_unit(at, &mut others[0], &self.rows));
                }
            }
        }
    }

    /// Interprets the column names of a table in SI.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read).
    #[cfg(any(feature = "arrow", feature = "parquet"))]
    pub fn in_si(setup: &Setup<f64>, names: &[String], file: &str) -> Result<Self> {
        let names_in_order = names.iter().enumerate();
        let columns = names_in_order.map(|(at, name)| (at, Column::in_si(setup, name)));
        let mut columns = all(columns, TableUse::Points.advice(), file)?;
        resolve_sweep_names(&mut columns);
        Ok(Self {
            heads: names.to_vec(),
            columns,
            ..Self::default()
        })
    }

    /// Detects the decimal mark, unless commas separate the cells.
    fn detect_decimal_mark(&mut self) {
        if self.format.decimal_mark.is_some() {
            return;
        }
        let columns = &self.columns;
        let of_numbers = (0..columns.len()).filter(|at| columns[*at].quantity().is_some());
        self.format.decimal_mark = DecimalMark::detect(of_numbers, &self.rows);
        for column in &mut self.columns {
            column.format.decimal_mark = self.format.decimal_mark;
        }
    }

    /// Ignores each column whose content an earlier column has, and returns a remark.
    pub fn ignore_repeated(&mut self) -> Option<Message> {
        let mut repeated = vec![];
        for at in 0..self.columns.len() {
            let content = self.columns[at].content;
            let mut before = self.columns[..at].iter();
            let first = before.position(|column| column.content == content);
            if let Some(first) = first
                && !matches!(
                    content,
                    Content::Note | Content::Written | Content::Repeated
                )
            {
                self.columns[at].content = Content::Repeated;
                repeated.push(format!(
                    "'{}' repeats '{}'",
                    self.heads[at], self.heads[first]
                ));
            }
        }
        columns_remark("columns given twice; only the first is used", &repeated)
    }

    /// Remarks on how the columns are read.
    pub fn column_remarks(&self) -> Vec<Message> {
        let mut remarks: Vec<Message> = self.encoding.map(Message::from).into_iter().collect();
        remarks.extend(self.remarks.iter().cloned());
        remarks.extend(in_degrees(&self.columns).map(Message::from));
        remarks.extend(assumed_units_remark(&self.assumed_units));
        remarks.extend(self.turned.clone().map(Message::from));
        if let Some(column) = self.columns.iter().find(|column| column.is_overridden_air) {
            remarks.push(air_replaced(&column.head).into());
        }
        remarks
    }

    /// The first column with this content, and its index.
    pub fn column(&self, content: Content) -> Option<(usize, &Column)> {
        let mut columns = self.columns.iter().enumerate();
        columns.find(|(_, column)| column.content == content)
    }

    /// The column in which an export states the air of each row, and its index.
    pub fn stated_air(&self) -> Option<(usize, &Column)> {
        let mut columns = self.columns.iter().enumerate();
        columns.find(|(_, column)| column.is_stated_air())
    }

    /// Column head of an outcome, for messages; the name of the outcome if it has no column.
    pub fn name_of(&self, of: Outcome) -> String {
        let column = self.column(Content::Outcome(of));
        column.map_or(of.name().into(), |(_, column)| column.head.clone())
    }

    /// The fault of a record with the cells `row`; `None` for a row that can be read.
    pub fn row_fault<'a, S: AsRef<str>>(
        &self,
        record: &Record,
        row: &'a [S],
    ) -> Option<RowFault<'a>> {
        if let Some(refusal) = record.unclosed() {
            return Some(RowFault::Unreadable(refusal));
        }
        if self.format.is_export
            && let Some(no_shot) = RowFault::of_export(row, &self.columns)
        {
            return Some(no_shot);
        }
        miscounted(row, self.columns.len()).map(RowFault::Unreadable)
    }

    /// True if a column is a parameter of swing, strike, club or impact.
    pub fn has_strike(&self) -> bool {
        self.columns.iter().any(Column::is_of_the_strike)
    }
}

/// Indices of the columns that an earlier run of `fly` added. Empty without such columns.
fn flown_columns(heads: &[String]) -> Range<usize> {
    let names: Vec<&str> = heads.iter().map(|head| split_unit(head).0).collect();
    let mut places = names.windows(OF_FLOWN.len());
    let Some(from) = places.position(|names| names == OF_FLOWN) else {
        return 0..0;
    };
    let of_outcomes = from + OF_FLOWN.len();
    let is_added = |name: &&&str| FLOWN_PREFIXES.iter().any(|before| name.starts_with(before));
    from..of_outcomes + names[of_outcomes..].iter().take_while(is_added).count()
}

/// All columns, or the error for the columns of `file` that cannot be read. A message about unknown
/// names ends with `advice`.
fn all(
    read: impl Iterator<Item = (usize, Result<Column>)>,
    advice: &str,
    file: &str,
) -> Result<Vec<Column>> {
    let (mut columns, mut faults) = (vec![], vec![]);
    for (at, column) in read {
        match column {
            Ok(column) => columns.push(column),
            Err(error) => faults.push((at, error)),
        }
    }
    column_error(faults, advice, file).map_or(Ok(columns), Err)
}

/// Resolves ambiguous names in a sweep that this program wrote. Such a table has a status column,
/// and its `carry` is the distance along the target line. If a launch condition has the prefix
/// `launch.`, names without this prefix are computed outcomes, and their columns are ignored.
fn resolve_sweep_names(columns: &mut [Column]) {
    let is_status = |column: &Column| column.content == Content::Written && column.head == STATUS;
    if !columns.iter().any(is_status) {
        return;
    }
    let is_condition = |column: &Column| match column.content {
        Content::Outcome(outcome) => CONDITIONS.contains(&outcome),
        _ => false,
    };
    let is_dotted = |column: &Column| column.head.starts_with(LAUNCH);
    if columns
        .iter()
        .any(|column| is_condition(column) && is_dotted(column))
    {
        for column in columns
            .iter_mut()
            .filter(|column| is_condition(column) && !is_dotted(column))
        {
            column.content = Content::Written;
        }
    }
    for column in columns
        .iter_mut()
        .filter(|column| column.head == Outcome::Carry.name())
    {
        column.content = Content::Outcome(Outcome::Carry);
    }
}

/// `remark` with the number of the line in which the section begins.
pub(crate) fn remark_from_line(line: u64, remark: &Message) -> Message {
    Message::from(format!("from line {line} on: ")).message(remark.clone())
}

/// The error for the columns of `file` that cannot be read; `None` if there are none. If several
/// names are unknown, the message lists them all. Otherwise it reports the first column that cannot
/// be read. A message about unknown names ends with `advice`. Columns are numbered from 0.
fn column_error(faults: Vec<(usize, Error)>, advice: &str, file: &str) -> Option<Error> {
    let (mut numbers, mut unknown) = (vec![], vec![]);
    for (at, error) in &faults {
        if let Error::Unknown {
            name, suggestion, ..
        } = error
        {
            let near = suggestion
                .as_ref()
                .map(|near| format!(" (did you mean '{near}'?)"))
                .unwrap_or_default();
            numbers.push((at + 1).to_string());
            unknown.push(format!("'{name}'{near}"));
        }
    }
    let refused = |place: String, reason: String| Error::table(file, place, reason);
    if unknown.len() > 1 {
        return Some(refused(
            format!(", columns {}", numbers.join(", ")),
            format!("unknown columns {}; {advice}", unknown.join(", ")),
        ));
    }
    let (at, mut error) = faults.into_iter().next()?;
    if let Error::Unknown {
        what: "column",
        advice: of_column,
        ..
    } = &mut error
    {
        *of_column = advice.into();
    }
    Some(refused(format!(", column {}", at + 1), error.to_string()))
}
