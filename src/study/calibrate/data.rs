//! Reads a table of measured shots.

use super::reading::Reading;
use super::rows::ShotRows;
use super::shot_table::ShotTable;
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::shots::{Shots, is_json};
use crate::table::{RowFilter, TableEntry, TableUse, Text, TextTable, unreadable_text};
use std::io::{Cursor, Read};
use std::path::Path;

impl ShotTable {
    /// Reads measured shots from the rows of a CSV file that `filter` selects, by default all rows.
    /// If `is_air_given` is true, every row has the air of the setup, even if an export states other
    /// air.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read), and [`Error::Table`] if `filter`
    /// selects no row or names a column that the table does not have.
    pub fn open(
        setup: &Setup<f64>,
        path: &Path,
        filter: RowFilter,
        is_air_given: bool,
    ) -> Result<Self> {
        let mut text = Text::of_file(path)?;
        text.filter = filter;
        text.is_air_given = is_air_given;
        Self::read_rows(setup, text, TableUse::Measurements)
    }

    /// Reads launches and club columns from a CSV file. A row needs no measurement other than its
    /// launch.
    ///
    /// # Errors
    /// The errors of [`open`](Self::open).
    pub fn open_launches(setup: &Setup<f64>, path: &Path, filter: RowFilter) -> Result<Self> {
        let mut text = Text::of_file(path)?;
        text.filter = filter;
        Self::read_rows(setup, text, TableUse::Deliveries)
    }

    /// Reads measured shots from CSV text. Also reads messages of GSPro Open Connect, and exports
    /// with title lines above the column heads.
    ///
    /// Rows without a measurement, or without a value that every shot needs, are ignored; a remark
    /// lists them. In a launch monitor's export, summary rows and rows with an unusable value are
    /// ignored too, and physically impossible measured values are not compared.
    ///
    /// # Errors
    /// [`Error::Table`] with row and column for an unknown column, a wrong
    /// unit, a cell that is not a number, an uncertain decimal mark, a sigma ≤ 0, a value
    /// outside its range, and a table without rows.
    pub fn read(setup: &Setup<f64>, file: &str, mut source: impl Read) -> Result<Self> {
        let mut bytes = vec![];
        let read = source.read_to_end(&mut bytes);
        read.map_err(|error| unreadable_text(file, &error))?;
        let text = Text::open(file, Cursor::new(bytes))?;
        Self::read_rows(setup, text, TableUse::Measurements)
    }

    /// Reads CSV text. For deliveries, a row needs no measurement other than its launch.
    fn read_rows(setup: &Setup<f64>, text: Text, table_use: TableUse) -> Result<Self> {
        let file = text.name.clone();
        if is_json(&text.beginning) {
            let shots = Shots::of_text(setup, text)?;
            return Self::of_messages(setup, shots, &file, table_use);
        }
        let (mut table, head) = TextTable::open(text, setup, table_use)?;
        let mut reading = Reading::of_head(&table, head)?;
        let is_launched = reading.is_launched;
        let mut rows = ShotRows::new(&file, table.title.clone());
        rows.begin(None, &reading);
        while let Some(entry) = table.next_entry()? {
            match entry {
                TableEntry::Row(record) => rows.take(&reading, &record, table.separator)?,
                TableEntry::Excluded => rows.skip(),
                TableEntry::Head(record) => {
                    let Some(head) = table.section(&record)? else {
                        continue;
                    };
                    reading = Reading::of_head(&table, head)?;
                    if reading.is_launched != is_launched {
                        let reason = "launches and deliveries are mixed: the rows of this section \
                                      are of another kind than the rows before it; use a separate \
                                      file for each kind";
                        let place = format!(", line {}", record.line);
                        return Err(Error::table(&table.name, place, reason));
                    }
                    rows.begin(Some(record.line), &reading);
                }
            }
        }
        rows.table(&table.filter, table.final_remarks())
    }

    /// Shots from messages of GSPro Open Connect, or from lines that `fly` wrote.
    fn of_messages(
        setup: &Setup<f64>,
        shots: Shots,
        file: &str,
        table_use: TableUse,
    ) -> Result<Self> {
        let other_parameters = shots.other_parameters.clone();
        let remarks = shots.remarks().to_vec();
        let shots = shots.all()?;
        let mut reading = Reading::of_shots(setup, &shots, &other_parameters, table_use);
        reading.head.remarks.extend(remarks);
        let mut rows = ShotRows::new(file, None);
        rows.begin(None, &reading);
        for shot in &shots {
            rows.take_shot(&reading, shot, &other_parameters);
        }
        rows.table(&RowFilter::default(), vec![])
    }
}
