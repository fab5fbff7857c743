//! Flown shots as Parquet, in SI. Each row has the stated values of a shot, the predictions, and
//! the original row.

use super::columns::{LAUNCH, MEASURED, launch};
use crate::batch::CHUNK;
use crate::drive::Outcome;
use crate::error::Result;
use crate::report::parquet::{Cells, ColumnType, ParquetTable, RowGroups};
use crate::shots::{Club, Flown, Shots};
use crate::table::columns_remark;
use crate::units::Message;
use parquet::data_type::ByteArray;

/// A row group is complete once it has at least this many rows.
const ROWS: usize = 32 * CHUNK;

#[derive(Clone, Copy)]
enum ColumnSource {
    Line,
    Flight,
    Reason,
    Notes,
    Launch(usize),
    Club(usize),
    Parameter(usize),
    SpinOrigin,
    Condition,
    Measured(Outcome),
    Predicted(usize),
    Residual(usize),
    Row,
}

/// Writes flown shots as Parquet, in row groups of about 33,000 rows. The first bytes of a file are
/// [`PARQUET_MAGIC`](crate::report::PARQUET_MAGIC).
pub struct ShotParquet {
    table: ParquetTable,
    columns: Vec<ColumnSource>,
    waiting: Vec<Flown>,
    groups: RowGroups,
}

impl ShotParquet {
    /// The table of these shots with their predicted outcomes. A parameter that only a later
    /// section of the shots states has no column; [`remark`](Self::remark) names it.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) if Parquet does not allow the columns.
    pub fn new(shots: &Shots, of: &[Outcome]) -> Result<Self> {
        let mut columns: Vec<(String, ColumnType, ColumnSource)> = vec![
            ("line".into(), ColumnType::Number, ColumnSource::Line),
            ("flight".into(), ColumnType::Text, ColumnSource::Flight),
            ("reason".into(), ColumnType::SomeText, ColumnSource::Reason),
            ("notes".into(), ColumnType::SomeText, ColumnSource::Notes),
        ];
        let mut number =
            |name: String, of: ColumnSource| columns.push((name, ColumnType::SomeNumber, of));
        LAUNCH
            .iter()
            .enumerate()
            .for_each(|(at, (_, of))| number(of.name().into(), ColumnSource::Launch(at)));
        Club::NAMES
            .iter()
            .enumerate()
            .for_each(|(at, name)| number((*name).into(), ColumnSource::Club(at)));
        shots
            .other_parameters
            .iter()
            .enumerate()
            .for_each(|(at, row)| number(row.name.into(), ColumnSource::Parameter(at)));
        MEASURED.iter().for_each(|(_, of)| {
            number(
                format!("measured_{}", of.name()),
                ColumnSource::Measured(*of),
            )
        });
        of.iter().enumerate().for_each(|(at, of)| {
            number(
                format!("predicted_{}", of.name()),
                ColumnSource::Predicted(at),
            )
        });
        of.iter().enumerate().for_each(|(at, of)| {
            number(
                format!("residual_{}", of.name()),
                ColumnSource::Residual(at),
            )
        });
        columns.push((
            "spin_origin".into(),
            ColumnType::SomeText,
            ColumnSource::SpinOrigin,
        ));
        columns.push((
            "condition".into(),
            ColumnType::SomeText,
            ColumnSource::Condition,
        ));
        columns.push(("row".into(), ColumnType::Text, ColumnSource::Row));
        let kinds: Vec<(String, ColumnType)> = columns
            .iter()
            .map(|(name, kind, _)| (name.clone(), *kind))
            .collect();
        let columns = columns.into_iter().map(|(.., of)| of).collect();
        let table = ParquetTable::new("shots", &kinds, "fly")?;
        Ok(Self {
            table,
            columns,
            waiting: vec![],
            groups: RowGroups::default(),
        })
    }

    /// Adds shots. If a row group is full, returns the bytes of this group, otherwise no bytes.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) if Parquet does not allow a value of the shots.
    pub fn push(&mut self, flown: Flown) -> Result<Vec<u8>> {
        self.waiting.push(flown);
        let rows: usize = self.waiting.iter().map(|flown| flown.shots.len()).sum();
        match rows >= ROWS {
            true => self.group(),
            false => Ok(vec![]),
        }
    }

    /// The last bytes of a file: the remaining rows and the footer.
    ///
    /// # Errors
    /// The errors of [`push`](Self::push).
    pub fn finish(&mut self) -> Result<Vec<u8>> {
        let mut bytes = if self.waiting.is_empty() {
            vec![]
        } else {
            self.group()?
        };
        bytes.extend(self.table.footer(&self.groups, &[])?);
        Ok(bytes)
    }

    /// A remark that names the parameters of the rows that have no column. Call it after the last
    /// shot.
    pub fn remark(&self, shots: &Shots) -> Option<Message> {
        let what = "parameters of later sections, which have no column in the Parquet file (JSON \
                    lines have them)";
        columns_remark(what, &shots.later_parameters())
    }

    fn group(&mut self) -> Result<Vec<u8>> {
        let group = self
            .table
            .group(|number| self.cells(self.columns[number]))?;
        self.groups.add(&group.metadata)?;
        self.waiting.clear();
        Ok(group.bytes)
    }

    fn cells(&self, of: ColumnSource) -> Cells {
        let rows = || {
            self.waiting
                .iter()
                .flat_map(|flown| (0..flown.shots.len()).map(move |row| (flown, row)))
        };
        let numbers = |value: &dyn Fn(&Flown, usize) -> Option<f64>| {
            Cells::Numbers(rows().map(|(flown, row)| value(flown, row)).collect())
        };
        let texts = |text: &dyn Fn(&Flown, usize) -> Option<String>| {
            let text =
                |(flown, row)| text(flown, row).map(|text| ByteArray::from(text.into_bytes()));
            Cells::Texts(rows().map(text).collect())
        };
        match of {
            ColumnSource::Line => numbers(&|flown, row| Some(flown.shots[row].line as f64)),
            ColumnSource::Flight => texts(&|flown, row| Some(flown.flight(row).to_owned())),
            ColumnSource::Row => texts(&|flown, row| Some(flown.shots[row].text.clone())),
            ColumnSource::Reason => texts(&|flown, row| flown.reason(row).map(str::to_owned)),
            ColumnSource::Notes => texts(&|flown, row| {
                let notes = &flown.shots[row].notes;
                (!notes.is_empty()).then(|| notes.join("; "))
            }),
            ColumnSource::SpinOrigin => {
                texts(&|flown, row| Some(flown.shots[row].spin_origin()?.name().to_owned()))
            }
            ColumnSource::Condition => texts(&|flown, row| flown.shots[row].condition.clone()),
            ColumnSource::Launch(at) => numbers(&|flown, row| launch(&flown.shots[row])[at]),
            ColumnSource::Club(at) => numbers(&|flown, row| flown.shots[row].club.values()[at]),
            ColumnSource::Parameter(at) => {
                numbers(&|flown, row| flown.shots[row].other_parameters().get(at).copied())
            }
            ColumnSource::Measured(of) => {
                numbers(&|flown, row| Some(flown.shots[row].value(of)?.value))
            }
            ColumnSource::Predicted(at) => numbers(&|flown, row| flown.predicted(row, at)),
            ColumnSource::Residual(at) => numbers(&|flown, row| flown.residual(row, at)),
        }
    }
}
