use super::{Fingerprint, column, is_value, refuse_columns, refused};
use crate::batch::points::Points;
use crate::error::Result;
use crate::foreign::of_csv;
use crate::parameters::{Parameter, Setup};
use csv::{Reader, ReaderBuilder, StringRecord, Trim};
use std::fs::File;
use std::path::{Path, PathBuf};

/// Points in a CSV file. Its head names the parameters with their units: `club.loft [deg]`, `impact.restitution`.
#[derive(Debug)]
pub struct CsvTable {
    path: PathBuf,
    reader: Reader<File>,
    columns: Vec<Column>,
    parameters: Vec<&'static Parameter>,
    rows: u64,
    fingerprint: Fingerprint,
    next: u64,
    record: StringRecord,
}

/// A column of numbers, and the unit that they are in; a plain number has none.
#[derive(Clone, Debug)]
struct Column {
    parameter: &'static Parameter,
    unit: Option<String>,
}

impl CsvTable {
    /// The table in a file. All of it is read once, so that a cell that is no number is told before any work.
    ///
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a file that cannot be read, a column that is no parameter or given
    /// twice, a unit of another kind, and a cell that is no number.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let mut reader = begin(path)?;
        let head = reader.headers().map_err(|error| refused(path, String::new(), of_csv(&error)))?.clone();
        let columns = head.iter().enumerate().map(|(at, head)| Column::read(setup, path, at + 1, head));
        let columns = columns.collect::<Result<Vec<_>>>()?;
        let parameters: Vec<_> = columns.iter().map(|column| column.parameter).collect();
        refuse_columns(path, &parameters)?;
        let (path, record, fingerprint) = (path.to_owned(), StringRecord::new(), Fingerprint::new());
        let mut table = Self { path, reader, columns, parameters, rows: u64::MAX, fingerprint, next: 0, record };
        (table.rows, table.fingerprint) = Fingerprint::of(&mut table)?;
        table.seek(0)?;
        Ok(table)
    }

    fn record(&mut self) -> Result<bool> {
        self.reader.read_record(&mut self.record).map_err(|error| {
            let place = format!(", row {}", self.next + 1);
            refused(&self.path, place, of_csv(&error))
        })
    }
}

fn begin(path: &Path) -> Result<Reader<File>> {
    let file =
        File::open(path).map_err(|error| refused(path, String::new(), format!("it cannot be read ({error})")))?;
    Ok(ReaderBuilder::new().trim(Trim::All).from_reader(file))
}

impl Column {
    fn read(setup: &Setup<f64>, path: &Path, number: usize, head: &str) -> Result<Self> {
        // a spreadsheet's mark of its encoding is no part of a name
        let head = head.trim_start_matches('\u{feff}');
        let (name, unit) = match head.split_once('[') {
            Some((name, unit)) => (name.trim(), Some(unit.trim_end().trim_end_matches(']').trim())),
            None => (head, None),
        };
        let parameter = column(setup, path, number, name)?;
        if let Some(unit) = unit
            && let Err(error) = parameter.quantity.read(&format!("1 {unit}"))
        {
            return Err(refused(path, format!(", column {number} ({name})"), error.to_string()));
        }
        if unit.is_none() && !parameter.quantity.si.is_empty() {
            let reason = format!("it has no unit; write it into the head, as in '{name} [{}]'", parameter.unit);
            return Err(refused(path, format!(", column {number} ({name})"), reason));
        }
        Ok(Self { parameter, unit: unit.map(str::to_owned) })
    }

    /// The SI value of a cell.
    fn value(&self, cell: &str) -> Result<f64, String> {
        let number: f64 = cell.parse().ok().filter(|number| is_value(self.parameter, *number)).ok_or_else(|| {
            let unit = self.parameter.unit;
            match cell {
                "" => "the cell is empty; every row needs a value".into(),
                _ => format!(
                    "'{cell}' is not a finite number; units stand in the head, as in '{} [{unit}]'",
                    self.parameter.name
                ),
            }
        })?;
        match &self.unit {
            Some(unit) => self.parameter.quantity.read(&format!("{number} {unit}")).map_err(|error| error.to_string()),
            None => Ok(number),
        }
    }
}

impl Points for CsvTable {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    fn rows(&self) -> u64 {
        self.rows
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        if row < self.next || self.reader.is_done() {
            self.reader = begin(&self.path)?;
            self.next = 0;
        }
        while self.next < row && self.record()? {
            self.next += 1;
        }
        Ok(())
    }

    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
        let mut rows = 0;
        while rows < most && self.next < self.rows && self.record()? {
            self.next += 1;
            for (column, cell) in self.columns.iter().zip(&self.record) {
                values.push(column.value(cell).map_err(|reason| {
                    refused(&self.path, format!(", row {}, column {}", self.next, column.parameter.name), reason)
                })?);
            }
            rows += 1;
        }
        Ok(rows)
    }

    fn identity(&self) -> String {
        self.fingerprint.identity(self)
    }
}
