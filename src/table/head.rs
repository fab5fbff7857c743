//! The head of a table: what its columns hold.

use super::CONDITIONS;
use super::column::{Column, Format, Holds};
use super::column_errors::{ColumnErrors, OF_LAUNCHES, OF_POINTS, OF_SHOTS};
use super::ignored_columns::{ClubColumns, SpinSource, ignore_columns};
use super::launch_monitor::{is_export, units_row};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Setup;
use crate::units::Message;

/// Options for reading a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    /// Use of the club columns beside a measured launch.
    pub club: ClubColumns,
    /// Where a spin is taken from that is stated twice.
    pub spin: SpinSource,
    /// Advice for unknown heads.
    pub advice: &'static str,
}

impl Wanted {
    /// Shots that are flown from their launch.
    pub const LAUNCHES: Self = Self {
        club: ClubColumns::Ignored,
        spin: SpinSource::Row,
        advice: OF_LAUNCHES,
    };
    /// Shots with what was measured of them.
    pub const MEASUREMENTS: Self = Self {
        club: ClubColumns::Ignored,
        spin: SpinSource::Row,
        advice: OF_SHOTS,
    };
    /// Shots whose delivery is sought.
    pub const DELIVERIES: Self = Self {
        club: ClubColumns::Read,
        spin: SpinSource::Row,
        advice: OF_SHOTS,
    };
    /// Points of a sweep, and swings.
    pub const POINTS: Self = Self {
        club: ClubColumns::Ignored,
        spin: SpinSource::Table,
        advice: OF_POINTS,
    };
}

/// Head of a table.
#[derive(Clone, Debug)]
pub(crate) struct Head {
    /// Line of the head, from 1.
    pub line: u64,
    /// The heads, as they are written.
    pub heads: Vec<String>,
    /// The columns, in their order.
    pub columns: Vec<Column>,
    /// How the table is written.
    pub format: Format,
    /// The cells of a line of units below the heads, where there is one.
    pub units: Option<Vec<String>>,
    /// Remarks on ignored columns.
    pub remarks: Vec<Message>,
    /// Remark on the encoding.
    pub encoding: Option<&'static str>,
}

/// The names of some columns, as a message lists them.
pub(crate) struct Names<'a>(pub Vec<&'a str>);

impl Head {
    /// Reads the heads of a table of text and the first row below them, which may state units;
    /// `separator` is what stands between cells.
    ///
    /// # Errors
    /// The columns that cannot be read, and why.
    pub fn read(
        setup: &Setup<f64>,
        heads: Vec<String>,
        first: Option<Vec<String>>,
        separator: u8,
        wanted: &Wanted,
    ) -> Result<Self, ColumnErrors> {
        let is_export = is_export(heads.iter().map(String::as_str));
        let format = Format {
            is_export,
            has_decimal_comma: separator != b',',
        };
        let units = first.as_ref().and_then(|first| units_row(&heads, first));
        let column = |(at, head): (usize, &String)| {
            let below = units.as_ref().and_then(|units| units.get(at)?.as_deref());
            (at, Column::read(setup, head, below, format))
        };
        let columns = all(heads.iter().enumerate().map(column));
        let mut columns = columns.map_err(|wrong| wrong.advised(wanted.advice))?;
        // a sweep needs a value in every row, and the delivery of a club none of the air
        let is_air_of_rows = wanted.club == ClubColumns::Ignored && wanted.spin == SpinSource::Row;
        for column in columns
            .iter_mut()
            .filter(|column| !is_air_of_rows && column.is_stated_air())
        {
            column.holds = Holds::Note;
        }
        let remarks = if is_export {
            ignore_columns(&mut columns, wanted.club, wanted.spin)
        } else {
            vec![]
        };
        told_apart(&mut columns);
        let units = units.and(first);
        Ok(Self {
            line: 1,
            heads,
            columns,
            format,
            units,
            remarks,
            encoding: None,
        })
    }

    /// Reads the names of the columns of a table that is in SI throughout.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    #[cfg(any(feature = "arrow", feature = "parquet"))]
    pub fn in_si(setup: &Setup<f64>, names: &[String]) -> Result<Self, ColumnErrors> {
        let columns = all(names
            .iter()
            .enumerate()
            .map(|(at, name)| (at, Column::in_si(setup, name))));
        let mut columns = columns.map_err(|wrong| wrong.advised(OF_POINTS))?;
        told_apart(&mut columns);
        let format = Format {
            is_export: false,
            has_decimal_comma: false,
        };
        Ok(Self {
            line: 1,
            heads: names.to_vec(),
            columns,
            format,
            units: None,
            remarks: vec![],
            encoding: None,
        })
    }

    /// Compares heads and units.
    pub fn is_like(&self, heads: &[String], units: Option<&[String]>) -> bool {
        self.heads == heads && self.units.as_deref() == units
    }

    /// True with a column of the delivery.
    pub fn has_strike(&self) -> bool {
        self.columns.iter().any(Column::is_of_the_strike)
    }

    /// True with a complete launch and no delivery.
    pub fn is_launched(&self) -> bool {
        let has = |outcome| {
            self.columns
                .iter()
                .any(|column| column.holds == Holds::Outcome(outcome))
        };
        let has_spin = has(Outcome::Spin) || has(Outcome::Backspin);
        has(Outcome::BallSpeed) && has(Outcome::LaunchAngle) && has_spin && !self.has_strike()
    }

    /// The heads of the columns of which this is so.
    pub fn named(&self, is: impl Fn(&Column) -> bool) -> Names<'_> {
        Names(
            self.columns
                .iter()
                .filter(|column| is(column))
                .map(|column| column.head.as_str())
                .collect(),
        )
    }
}

/// The columns, where all can be read.
fn all(read: impl Iterator<Item = (usize, Result<Column>)>) -> Result<Vec<Column>, ColumnErrors> {
    let (mut columns, mut faults) = (vec![], vec![]);
    for (at, column) in read {
        match column {
            Ok(column) => columns.push(column),
            Err(error) => faults.push((at, error)),
        }
    }
    ColumnErrors::of(faults).map_or(Ok(columns), Err)
}

/// What the same name is in a sweep that this program wrote, which has a status. Beside launch
/// conditions by their dotted names, those without a group are outcomes; and `carry` is the
/// distance along the target line that it is everywhere else.
fn told_apart(columns: &mut [Column]) {
    if !columns.iter().any(Column::is_status) {
        return;
    }
    if columns.iter().any(Column::is_dotted_condition) {
        for column in columns
            .iter_mut()
            .filter(|column| !column.is_dotted_condition())
        {
            if matches!(column.holds, Holds::Outcome(outcome) if CONDITIONS.contains(&outcome)) {
                column.holds = Holds::Written;
            }
        }
    }
    for column in columns
        .iter_mut()
        .filter(|column| column.head == Outcome::Carry.name())
    {
        column.holds = Holds::Outcome(Outcome::Carry);
    }
}

impl Names<'_> {
    /// `what: a, b`, where there are any.
    pub fn told(&self, what: &str) -> Option<Message> {
        (!self.0.is_empty()).then(|| format!("{what}: {}", self.0.join(", ")).into())
    }
}
