//! Reader of text tables: title lines, column heads, rows, and further lines of column heads that
//! begin sections.

use super::air::ignore_stated_air;
use super::encoding::{Encoding, decoded};
use super::head::TableHead;
use super::launch_monitor::{is_export, is_head, units_row};
use super::numbers::cell_number;
use super::records::{Lines, Record, cells, only_cell};
use super::row_filter::RowFilter;
use super::table_use::TableUse;
use crate::csv_dialect::detect_separator;
use crate::error::{Error, Result};
use crate::external_errors::read_error_text;
use crate::input_file::InputFile;
use crate::parameters::Setup;
use crate::units::Message;
use std::io::{self, BufReader, Cursor, Read};
use std::path::Path;

/// Number of bytes inspected for format, encoding and column heads.
const BEGINNING: u64 = 1 << 16;

/// Buffer size, bytes.
const PIECE: usize = 1 << 16;

/// Number of rows inspected for units, decimal marks and signs.
const MOST_ROWS: usize = 200;

/// Number of records searched for the column heads.
const MOST_RECORDS: usize = 25;

/// Remark on the encoding.
const IN_WINDOWS_1252: &str = "its text is not in UTF-8, and is read as Windows-1252";

/// The error for a text that cannot be read because of an error of the system.
pub(crate) fn unreadable_text(file: &str, error: &io::Error) -> Error {
    Error::table(file, "", read_error_text(error))
}

fn empty_table(file: &str) -> Error {
    let reason = "it is empty; give a head with the names of columns, and rows below it";
    Error::table(file, "", reason)
}

/// A text whose format (table or JSON) is not yet known.
pub(crate) struct Text {
    /// Name of the file, for messages.
    pub name: String,
    /// The first 64 KiB.
    pub beginning: String,
    /// The whole text, including `beginning`, in UTF-8 or Windows-1252.
    pub source: Box<dyn Read + Send>,
    encoding: Encoding,
    /// Selection of the rows of a table.
    pub filter: RowFilter,
    /// True if every row has the air of the setup, even if an export states other air.
    pub is_air_given: bool,
}

impl Text {
    /// Opens a text in UTF-8, UTF-16 or Windows-1252, with or without byte-order marks.
    ///
    /// # Errors
    /// [`Error::Table`] if the source cannot be read.
    pub fn open(name: &str, source: impl Read + Send + 'static) -> Result<Self> {
        let unreadable = |error: io::Error| unreadable_text(name, &error);
        let mut source = decoded(source).map_err(unreadable)?;
        let mut bytes = vec![];
        let mut beginning = (&mut source).take(BEGINNING);
        beginning.read_to_end(&mut bytes).map_err(unreadable)?;
        let encoding = Encoding::of(&bytes);
        let beginning = encoding.lossy(&bytes);
        let source = Box::new(Cursor::new(bytes).chain(source));
        Ok(Self {
            name: name.into(),
            beginning,
            source,
            encoding,
            filter: RowFilter::default(),
            is_air_given: false,
        })
    }

    /// Opens a file.
    ///
    /// # Errors
    /// The errors of [`open`](Self::open), and [`Error::Table`] if there is no
    /// such file.
    pub fn of_file(path: &Path) -> Result<Self> {
        let name = path.display().to_string();
        // a folder can be opened; the error appears when `Self::open` reads it
        let file = InputFile::open(path).map_err(|error| unreadable_text(&name, &error))?;
        Self::open(&name, file)
    }
}

/// A record of a table.
pub(crate) enum TableEntry {
    /// A row.
    Row(Record),
    /// A row that the filter excludes.
    Excluded,
    /// A line of column heads. It begins the next section of the table.
    Head(Record),
}

/// Streaming reader of a text table.
pub(crate) struct TextTable {
    /// Name of the file, for messages.
    pub name: String,
    lines: Lines,
    /// The only filled cell of the record above the first column heads, such as the name of a club.
    pub title: Option<String>,
    /// Cell separator.
    pub separator: u8,
    /// Encoding of the lines up to the first column heads.
    encoding_of_head: Encoding,
    /// True for exports, which may contain further lines of column heads.
    has_sections: bool,
    /// The column heads of the current section.
    heads: Vec<String>,
    /// The line of units of the current section; `None` without this line.
    units: Option<Vec<String>>,
    pub filter: RowFilter,
    pub setup: Setup<f64>,
    pub table_use: TableUse,
    is_air_given: bool,
}

impl TextTable {
    /// Opens a table and reads its first line of column heads.
    ///
    /// # Errors
    /// [`Error::Table`] if the source cannot be read, if the table is empty,
    /// if a quote in the column heads is not closed, or if a column is unknown.
    pub fn open(text: Text, setup: &Setup<f64>, table_use: TableUse) -> Result<(Self, TableHead)> {
        let Text {
            name,
            beginning,
            source,
            encoding,
            filter,
            is_air_given,
        } = text;
        let Some(place) = HeadPlace::find(&beginning) else {
            return Err(empty_table(&name));
        };
        let lines = Lines::new(
            Box::new(BufReader::with_capacity(PIECE, source)),
            &beginning,
            encoding,
        );
        let mut table = Self {
            name,
            lines,
            title: place.title,
            separator: place.separator,
            encoding_of_head: encoding,
            has_sections: false,
            heads: vec![],
            units: None,
            filter,
            setup: *setup,
            table_use,
            is_air_given,
        };
        let unreadable = |error| unreadable_text(&table.name, &error);
        while let Some(line) = table.lines.line().map_err(unreadable)? {
            if line.0 >= place.line {
                table.lines.give_back(line);
                break;
            }
        }
        let Some(record) = table.record()? else {
            return Err(empty_table(&table.name));
        };
        let mut head = table.head(&record)?;
        table.has_sections = head.format.is_export;
        (table.heads, table.units) = (head.heads.clone(), head.units.clone());
        table.encoding_of_head = table.lines.encoding;
        if table.encoding_of_head == Encoding::Windows1252 {
            head.encoding = Some(IN_WINDOWS_1252);
        }
        Ok((table, head))
    }

    /// Begins a section at a line of column heads. `None` if the line only repeats the column heads
    /// and units of the current section.
    ///
    /// # Errors
    /// The errors of [`open`](Self::open).
    pub fn section(&mut self, record: &Record) -> Result<Option<TableHead>> {
        let head = self.head(record)?;
        if head.heads == self.heads && head.units == self.units {
            return Ok(None);
        }
        (self.heads, self.units) = (head.heads.clone(), head.units.clone());
        Ok(Some(head))
    }

    /// Reads a line of column heads and the line of units below it.
    fn head(&mut self, record: &Record) -> Result<TableHead> {
        if let Some(refusal) = record.unclosed() {
            return Err(Error::table(&self.name, "", refusal.reason));
        }
        let heads: Vec<String> = self
            .cells(record)
            .into_iter()
            .map(|head| head.replace(['\r', '\n'], " "))
            .collect();
        let place = || format!(", line {}", record.line);
        self.filter
            .begin(&heads)
            .map_err(|reason| Error::table(&self.name, place(), reason))?;
        // in an export, `#1` is a shot number
        self.lines.has_remarks = !is_export(heads.iter().map(String::as_str));
        let below = self.record()?;
        let first = below.as_ref().map(|below| self.cells(below));
        let file = &self.name;
        let (setup, table_use) = (&self.setup, self.table_use);
        let mut head = TableHead::read(setup, heads, first, self.separator, table_use, file)?;
        if head.units.is_none()
            && let Some(below) = below
        {
            self.give_back(below);
        }
        // read ahead the first rows of the section; `next_entry` returns them again
        let separator = self.separator;
        let lines = self.lines.ahead(MOST_ROWS);
        let rows = lines
            .take_while(|line| !(head.format.is_export && is_head(line, separator)))
            .map(|line| cells(line, separator).into_iter().map(Into::into).collect())
            .filter(|row: &Vec<String>| row.len() >= head.heads.len())
            .collect();
        head.interpret(&self.setup, rows, self.table_use);
        if self.is_air_given {
            ignore_stated_air(&mut head.columns);
        }
        Ok(head)
    }

    /// The next row or line of column heads; `None` at the end.
    ///
    /// # Errors
    /// [`Error::Table`] if the source cannot be read, if a line is not text or
    /// is too long, or, at the end, if the filter selected no row.
    pub fn next_entry(&mut self) -> Result<Option<TableEntry>> {
        let Some(record) = self.record()? else {
            self.filter
                .finish()
                .map_err(|reason| Error::table(&self.name, "", reason))?;
            return Ok(None);
        };
        if self.has_sections && is_head(&record.text, self.separator) {
            return Ok(Some(TableEntry::Head(record)));
        }
        if !self.filter.is_empty() {
            let row = self.cells(&record);
            if !self.filter.takes(&row) {
                return Ok(Some(TableEntry::Excluded));
            }
        }
        Ok(Some(TableEntry::Row(record)))
    }

    /// Remarks on the whole table, complete after the last row.
    pub fn final_remarks(&self) -> Vec<Message> {
        let is_detected_later = self.lines.encoding != self.encoding_of_head;
        let encoding = is_detected_later.then(|| Message::from(IN_WINDOWS_1252));
        self.filter.remark().into_iter().chain(encoding).collect()
    }

    /// Pushes a record back to the front of the input.
    pub fn give_back(&mut self, record: Record) {
        self.lines.give_back((record.line, record.text));
    }

    fn record(&mut self) -> Result<Option<Record>> {
        let record = self.lines.record(self.separator);
        record.map_err(|error| unreadable_text(&self.name, &error))
    }

    fn cells(&self, record: &Record) -> Vec<String> {
        let text = record.text.trim_start_matches('\u{feff}');
        cells(text, self.separator)
            .into_iter()
            .map(Into::into)
            .collect()
    }
}

struct HeadPlace {
    separator: u8,
    line: u64,
    /// The only filled cell of the record above.
    title: Option<String>,
    /// The cells of the record.
    cells: Vec<String>,
}

impl HeadPlace {
    /// Finds the first record with two known column heads. If there is none, returns the first
    /// record. Lines that begin with `#` are remarks, unless they are column heads above rows.
    fn find(beginning: &str) -> Option<Self> {
        let mut lines = Lines::new(
            Box::new(Cursor::new(beginning.to_owned())),
            beginning,
            Encoding::Utf8,
        );
        let stated = detect_separator(beginning);
        let stated =
            (stated.1.len() != beginning.trim_start_matches('\u{feff}').len()).then_some(stated.0);
        let mut first: Option<Self> = None;
        // the last line with known column heads that begins with `#`
        let mut marked: Option<Self> = None;
        let (mut title, mut records) = (None, 0);
        // if the text does not state a separator (`sep=;`), the separator is detected in the first
        // line of each record
        while records < MOST_RECORDS {
            let Ok(Some((line, text))) = lines.text_line() else {
                break;
            };
            let words = text.trim_start_matches('\u{feff}');
            let begins_with_mark = words.starts_with('#');
            let separator =
                stated.unwrap_or_else(|| detect_separator(words.trim_start_matches('#')).0);
            if begins_with_mark && !is_head(words, separator) {
                continue;
            }
            records += 1;
            lines.give_back((line, text));
            let Ok(Some(record)) = lines.record(separator) else {
                break;
            };
            let row = cells(&record.text, separator);
            let place = Self {
                separator,
                line: record.line,
                title: title.take(),
                cells: row.into_iter().map(Into::into).collect(),
            };
            title = only_cell(&place.cells).map(|(_, cell)| cell.to_owned());
            if begins_with_mark {
                // an earlier record with at least as many filled cells has the heads of the table
                let is_first = first
                    .as_ref()
                    .is_none_or(|first| first.filled() < place.filled());
                marked = is_first.then_some(place).or(marked);
                continue;
            }
            if is_head(&record.text, separator) {
                return Some(place);
            }
            match marked.take_if(|marked| place.cells.len() >= marked.cells.len()) {
                Some(heads) if place.is_below(&heads) => return Some(heads),
                _ => {
                    first.get_or_insert(place);
                }
            }
        }
        first.or(marked)
    }

    /// Number of filled cells.
    fn filled(&self) -> usize {
        self.cells.iter().filter(|cell| !cell.is_empty()).count()
    }

    /// True for a row with a number or a unit below these column heads, false for other heads.
    fn is_below(&self, heads: &Self) -> bool {
        let is_number = |cell: &String| cell_number(cell, true).is_some();
        self.cells.iter().any(is_number) || units_row(&heads.cells, &self.cells).is_some()
    }
}
