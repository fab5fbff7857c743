use super::columns::{Columns, refused};
use super::rows::Rows;
use crate::columns::{Club, Column, Head, Marks, Spin, decoded, is_utf_16, separated, summary};
use crate::error::{Error, Result};
use crate::foreign::{of_csv, of_csv_row, of_io};
use crate::parameters::Setup;
use crate::units::Message;
use csv::{Position, Reader, ReaderBuilder, StringRecord, Trim};
use std::fs::File;
use std::io::{BufRead, BufReader, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// The rows of a CSV file. Its head names the parameters with their units, `club.loft [deg]`, `impact.restitution`, or is that of a
/// launch monitor's export, `Ball Speed [mph]`; cells are separated by commas, semicolons or tabs.
pub(super) struct CsvRows {
    path: PathBuf,
    reader: Reader<File>,
    /// Where the first row begins.
    first: Position,
    columns: Columns,
    /// The columns that are read, with their places.
    read: Vec<(usize, Column)>,
    /// Whether the table is a launch monitor's, of which rows that sum up others are passed over.
    is_export: bool,
    /// The number of the record in the file, and of those that are no drives.
    line: u64,
    summaries: Vec<String>,
    marks: Marks,
    record: StringRecord,
}

impl CsvRows {
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a file that cannot be read or without a column of a parameter, for a column that is unknown
    /// or given twice, and a unit of another kind. Of its rows: a cell that is no number or whose decimal mark is uncertain.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let unreadable = |error: std::io::Error| refused(path, String::new(), of_io(&error));
        let mut file = File::open(path).and_then(in_utf_8).map_err(unreadable)?;
        let (separator, begin) = layout(&file).map_err(unreadable)?;
        file.seek(SeekFrom::Start(begin)).map_err(unreadable)?;
        let mut reader =
            ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).delimiter(separator).from_reader(file);
        let heads = reader.headers().map_err(|error| refused(path, String::new(), of_csv(&error)))?.clone();
        let mut first = reader.position().clone();
        let mut record = StringRecord::new();
        // a row that cannot be read is told with its number later
        let has_first = reader.read_record(&mut record).unwrap_or(false);
        let below = has_first.then(|| record.iter());
        let head = Head::read(setup, heads.iter(), below, separator, Club::LeftOut, Spin::OfTable)
            .map_err(|wrong| wrong.of_points().in_file(&path.display().to_string()))?;
        if head.has_units_row {
            first = reader.position().clone();
        }
        // the reader counts from the head
        first.set_byte(begin + first.byte());
        let columns = Columns::new(setup, path, &head)?;
        let read = columns.at.iter().map(|at| (*at, head.columns[*at].clone())).collect::<Vec<_>>();
        for (at, column) in &read {
            let wrong = |error: Error| refused(path, format!(", column {}", at + 1), error.to_string());
            column.check_unit().map_err(wrong)?;
        }
        let (path, is_export) = (path.to_owned(), head.format.is_export);
        let (summaries, marks) = (vec![], Marks::default());
        Ok(Self { path, reader, first, columns, read, is_export, line: 0, summaries, marks, record })
    }

    /// The next row that is a drive.
    fn record(&mut self) -> Result<bool> {
        loop {
            let is_there = self.reader.read_record(&mut self.record).map_err(|error| {
                let again = File::open(&self.path).map(BufReader::new);
                let reason = again.map_or_else(|_| of_csv(&error), |again| of_csv_row(&error, again));
                refused(&self.path, format!(", row {}", self.line + 1), reason)
            })?;
            if !is_there {
                return Ok(false);
            }
            self.line += 1;
            match summary(self.record.iter()).filter(|_| self.is_export) {
                Some(word) => self.summaries.push(format!("row {} ({word})", self.line)),
                None => return Ok(true),
            }
        }
    }
}

/// A file in UTF-8: itself, or a copy of one in UTF-16. Its rows are read more than once, so it must be a file.
fn in_utf_8(mut file: File) -> std::io::Result<File> {
    let is_wide = is_utf_16(&mut file)?;
    file.rewind()?;
    if !is_wide {
        return Ok(file);
    }
    let mut copy = tempfile::tempfile()?;
    std::io::copy(&mut decoded(file)?, &mut copy)?;
    copy.rewind()?;
    Ok(copy)
}

/// What separates the cells of a file, as its head says, and a line `sep=;` before it; and the byte at which the head begins.
fn layout(file: &File) -> std::io::Result<(u8, u64)> {
    let mut file = BufReader::new(file);
    let mut bytes = vec![];
    loop {
        let from = bytes.len();
        if file.read_until(b'\n', &mut bytes)? == 0 {
            break;
        }
        let line = String::from_utf8_lossy(&bytes[from..]);
        let line = line.trim_start_matches('\u{feff}').trim();
        if !(line.is_empty() || line.starts_with(['#']) || line.starts_with("sep=")) {
            break;
        }
    }
    let text = String::from_utf8_lossy(&bytes);
    let (separator, rest) = separated(&text);
    Ok((separator, (text.len() - rest.len()) as u64))
}

impl Rows for CsvRows {
    fn columns(&self) -> &Columns {
        &self.columns
    }

    fn rewind(&mut self) -> Result<()> {
        (self.line, self.summaries) = (0, vec![]);
        let to = SeekFrom::Start(self.first.byte());
        let found = self.reader.seek_raw(to, self.first.clone());
        found.map_err(|error| refused(&self.path, String::new(), of_csv(&error)))
    }

    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
        let mut rows = 0;
        while rows < most && self.record()? {
            for (at, column) in &self.read {
                let cell = self.record.get(*at).unwrap_or_default();
                let wrong =
                    |reason| refused(&self.path, format!(", row {}, column {}", self.line, column.head), reason);
                self.marks.look(self.line, column, cell).map_err(wrong)?;
                values.push(column.value(cell).map_err(wrong)?.unwrap_or(f64::NAN));
            }
            rows += 1;
        }
        Ok(rows)
    }

    fn notes(&self) -> Vec<Message> {
        let mut notes = self.columns.notes.clone();
        if !self.summaries.is_empty() {
            notes.push(format!("rows left out, since they sum up other rows: {}", self.summaries.join(", ")).into());
        }
        notes
    }
}
