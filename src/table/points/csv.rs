use super::columns::PointColumns;
use super::rows::PointRows;
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::table::export_columns::columns_remark;
use crate::table::head::{TableHead, remark_from_line};
use crate::table::records::{Record, cells};
use crate::table::row_fault::NonShotRows;
use crate::table::table_use::TableUse;
use crate::table::text::{TableEntry, Text, TextTable};
use crate::units::Message;
use std::path::{Path, PathBuf};

/// Reads the rows of a CSV file. Column heads are parameters with units (`club.loft [deg]`,
/// `impact.restitution`) or column heads of a launch monitor (`Ball Speed [mph]`). Commas,
/// semicolons or tabs separate cells.
pub(super) struct CsvRows {
    path: PathBuf,
    table: TextTable,
    columns: PointColumns,
    /// The column heads of the current section.
    head: TableHead,
    /// Indices of the columns to read in this section.
    at: Vec<usize>,
    /// Remarks on later sections.
    section_notes: Vec<Message>,
    /// Number of the row below the column heads, from 1. Averages and titles count too.
    row: u64,
    no_shots: NonShotRows,
}

impl CsvRows {
    /// Opens a file and interprets its column heads.
    ///
    /// # Errors
    /// [`Error::Table`] if the file is unreadable, if a column is unknown or
    /// repeated, if no column is a parameter, or if a unit has the wrong dimension. Reading a row
    /// fails if a cell is not a number, or if its decimal mark is ambiguous.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let text = Text::of_file(path)?;
        let (table, mut head) = TextTable::open(text, setup, TableUse::Points)?;
        let columns = PointColumns::new(setup, &table.name, &mut head)?;
        check_units(&table.name, &head, &columns.at)?;
        Ok(Self {
            path: path.to_owned(),
            table,
            at: columns.at.clone(),
            columns,
            head,
            section_notes: vec![],
            row: 0,
            no_shots: NonShotRows::default(),
        })
    }

    /// Begins a section at a line of column heads. The section must have the parameters of the
    /// first section; other columns are not read.
    fn begin(&mut self, record: &Record) -> Result<()> {
        let Some(mut head) = self.table.section(record)? else {
            return Ok(());
        };
        let (file, parameters) = (&self.table.name, &self.columns.parameters);
        let own = PointColumns::new(&self.table.setup, file, &mut head)?;
        let at = own.places_of(parameters).map_err(|missing| {
            let reason = format!(
                "the column heads in line {} lack {missing}; the column heads at the top of the \
                 table have it",
                record.line
            );
            Error::table(file, "", reason)
        })?;
        check_units(file, &head, &at)?;
        let others = own.at.iter().filter(|place| !at.contains(place));
        let others: Vec<&str> = others.map(|at| head.columns[*at].head.as_str()).collect();
        let what = "columns not read, since the first column heads lack them";
        let notes = own
            .notes
            .iter()
            .cloned()
            .chain(columns_remark(what, &others));
        let notes = notes.map(|note| remark_from_line(record.line, &note));
        self.section_notes.extend(notes);
        (self.head, self.at) = (head, at);
        Ok(())
    }

    /// Cells of the next row; `None` at the end. Averages and titles of an export are skipped.
    fn cells(&mut self) -> Result<Option<Vec<String>>> {
        loop {
            let record = match self.table.next_entry()? {
                None => return Ok(None),
                Some(TableEntry::Head(record)) => {
                    self.begin(&record)?;
                    continue;
                }
                Some(TableEntry::Row(record)) => record,
                Some(TableEntry::Excluded) => continue,
            };
            self.row += 1;
            let row = cells(&record.text, self.table.separator);
            let Some(fault) = self.head.row_fault(&record, &row) else {
                return Ok(Some(row.into_iter().map(Into::into).collect()));
            };
            self.no_shots.add(self.row, fault).map_err(|refusal| {
                let place = format!(", row {}", self.row);
                Error::table(&self.table.name, place, refusal.reason)
            })?;
        }
    }
}

/// Checks the units of the columns `at`.
fn check_units(file: &str, head: &TableHead, at: &[usize]) -> Result<()> {
    for at in at {
        head.columns[*at].check_unit().map_err(|error| {
            Error::table(file, format!(", column {}", at + 1), error.to_string())
        })?;
    }
    Ok(())
}

impl PointRows for CsvRows {
    fn columns(&self) -> &PointColumns {
        &self.columns
    }

    fn rewind(&mut self) -> Result<()> {
        // a decoded text is not seekable
        *self = Self::open(&self.table.setup, &self.path)?;
        Ok(())
    }

    fn read(
        &mut self,
        most: usize,
        values: &mut Vec<f64>,
        numbers: &mut Vec<u64>,
    ) -> Result<usize> {
        for count in 0..most {
            let Some(row) = self.cells()? else {
                return Ok(count);
            };
            for at in &self.at {
                let (cell, column) = (row[*at].as_str(), &self.head.columns[*at]);
                let wrong = |reason| {
                    let place = format!(", row {}, column {}", self.row, column.head);
                    Error::table(&self.table.name, place, reason)
                };
                values.push(column.value(cell).map_err(wrong)?.unwrap_or(f64::NAN));
            }
            numbers.push(self.row);
        }
        Ok(most)
    }

    fn notes(&self) -> Vec<Message> {
        self.columns
            .notes
            .iter()
            .chain(&self.section_notes)
            .cloned()
            .chain(self.no_shots.messages().into_iter().map(Message::from))
            .chain(self.table.final_remarks())
            .collect()
    }
}
