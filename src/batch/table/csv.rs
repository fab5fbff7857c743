use super::columns::{Columns, refuse_columns, refused};
use super::fingerprint::Fingerprint;
use crate::batch::points::Points;
use crate::columns::{Column, Head, Marks, separated, summary};
use crate::error::{Error, Result};
use crate::foreign::{of_csv, of_csv_row, of_io};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use csv::{Reader, ReaderBuilder, StringRecord, Trim};
use std::fs::File;
use std::io::{BufRead, BufReader, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Points in a CSV file. Its head names the parameters with their units, `club.loft [deg]`, `impact.restitution`, or is that of a
/// launch monitor's export, `Ball Speed [mph]`; cells are separated by commas, semicolons or tabs.
#[derive(Debug)]
pub struct CsvTable {
    path: PathBuf,
    layout: Layout,
    reader: Reader<File>,
    columns: Columns,
    /// The columns that are read, with their places.
    read: Vec<(usize, Column)>,
    /// Whether the table is a launch monitor's, of which rows that sum up others are passed over.
    is_export: bool,
    notes: Vec<Message>,
    rows: u64,
    fingerprint: Fingerprint,
    next: u64,
    /// The number of the record in the file, and of those that are no drives.
    line: u64,
    summaries: Vec<String>,
    marks: Marks,
    record: StringRecord,
}

/// Where the cells of a file are.
#[derive(Clone, Copy, Debug)]
struct Layout {
    separator: u8,
    /// The byte at which the head begins.
    begin: u64,
    has_units_row: bool,
}

impl CsvTable {
    /// The table in a file. All of it is read once, so that a cell that is no number is told before any work.
    ///
    /// # Errors
    /// [`Error::Table`] for a file that cannot be read, without a row or without a column of a parameter, for a column that is unknown
    /// or given twice, a unit of another kind, and a cell that is no number or whose decimal mark is uncertain.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let mut layout = Layout::of(path)?;
        let mut reader = layout.begin(path)?;
        let heads = reader.headers().map_err(|error| refused(path, String::new(), of_csv(&error)))?.clone();
        let mut first = StringRecord::new();
        // a row that cannot be read is told with its number below
        let has_first = reader.read_record(&mut first).unwrap_or(false);
        let below = has_first.then(|| first.iter());
        let at_column = |(at, error): (usize, Error)| refused(path, format!(", column {}", at + 1), error.to_string());
        let head = Head::read(setup, heads.iter(), below, layout.separator).map_err(at_column)?;
        layout.has_units_row = head.has_units_row;
        let columns = Columns::new(setup, path, &head)?;
        let read = columns.at.iter().map(|at| (*at, head.columns[*at].clone())).collect::<Vec<_>>();
        for (at, column) in &read {
            column.check_unit().map_err(|error| at_column((*at, error)))?;
        }
        refuse_columns(path, &columns.parameters)?;
        let notes = head.remarks.iter().cloned().chain(columns.not_read(&head)).collect();
        let mut table = Self {
            path: path.to_owned(),
            layout,
            reader: layout.begin(path)?,
            columns,
            read,
            is_export: head.format.is_export,
            notes,
            rows: u64::MAX,
            fingerprint: Fingerprint::new(),
            next: 0,
            line: 0,
            summaries: vec![],
            marks: Marks::default(),
            record: StringRecord::new(),
        };
        (table.rows, table.fingerprint) = Fingerprint::of(&mut table)?;
        let summaries = std::mem::take(&mut table.summaries);
        if !summaries.is_empty() {
            table.notes.push(format!("rows left out, since they sum up other rows: {}", summaries.join(", ")).into());
        }
        table.seek(0)?;
        Ok(table)
    }

    /// The next row that is a drive.
    fn record(&mut self) -> Result<bool> {
        loop {
            let place = |line: u64| format!(", row {}", line + 1);
            let is_there = self.reader.read_record(&mut self.record).map_err(|error| match File::open(&self.path) {
                Ok(again) => refused(&self.path, place(self.line), of_csv_row(&error, BufReader::new(again))),
                Err(_) => refused(&self.path, place(self.line), of_csv(&error)),
            })?;
            self.line += u64::from(is_there);
            match summary(self.record.iter()).filter(|_| is_there && self.is_export) {
                Some(word) => {
                    if self.rows == u64::MAX {
                        self.summaries.push(format!("{} ({word})", self.line));
                    }
                }
                None => return Ok(is_there),
            }
        }
    }

    fn restart(&mut self) -> Result<()> {
        self.reader = self.layout.begin(&self.path)?;
        (self.next, self.line) = (0, 0);
        Ok(())
    }
}

impl Layout {
    /// How the file separates its cells: what its head says, and a line `sep=;` before it.
    fn of(path: &Path) -> Result<Self> {
        let unreadable = |error: std::io::Error| refused(path, String::new(), of_io(&error));
        let mut file = BufReader::new(File::open(path).map_err(unreadable)?);
        let mut bytes = vec![];
        loop {
            let from = bytes.len();
            if file.read_until(b'\n', &mut bytes).map_err(unreadable)? == 0 {
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
        Ok(Self { separator, begin: (text.len() - rest.len()) as u64, has_units_row: false })
    }

    /// Reads the file from its head.
    fn begin(&self, path: &Path) -> Result<Reader<File>> {
        let unreadable = |error: std::io::Error| refused(path, String::new(), of_io(&error));
        let mut file = File::open(path).map_err(unreadable)?;
        file.seek(SeekFrom::Start(self.begin)).map_err(unreadable)?;
        let mut reader =
            ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).delimiter(self.separator).from_reader(file);
        if self.has_units_row {
            let passed = reader.read_record(&mut StringRecord::new());
            passed.map_err(|error| refused(path, String::new(), of_csv(&error)))?;
        }
        Ok(reader)
    }
}

impl Points for CsvTable {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.columns.parameters
    }

    fn rows(&self) -> u64 {
        self.rows
    }

    fn notes(&self) -> Vec<Message> {
        self.notes.clone()
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        if row < self.next || self.reader.is_done() {
            self.restart()?;
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
            for (at, column) in &self.read {
                let cell = self.record.get(*at).unwrap_or_default();
                let wrong =
                    |reason| refused(&self.path, format!(", row {}, column {}", self.line, column.head), reason);
                self.marks.look(self.line, column, cell).map_err(wrong)?;
                let value = column.value(cell);
                let value = value.and_then(|value| value.ok_or("the cell is empty; every row needs a value".into()));
                values.push(value.map_err(wrong)?);
            }
            rows += 1;
        }
        Ok(rows)
    }

    fn identity(&self) -> String {
        self.fingerprint.identity(self)
    }
}
