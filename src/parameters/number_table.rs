//! A small table of numbers in the text of a CSV file: a line of column heads, then rows.

use crate::csv_dialect::detect_separator;
use crate::external_errors::csv_row_error_text;
use csv::{Reader, ReaderBuilder, StringRecord, Trim};

/// A fault of a table.
pub(crate) struct TableFault {
    /// Place in the file, which follows the name of the file in a message: ", line 3, column cd".
    /// Empty for the whole file.
    pub place: String,
    pub reason: String,
}

impl TableFault {
    /// A fault of the whole file.
    pub fn of_file(reason: String) -> Self {
        Self {
            place: String::new(),
            reason,
        }
    }

    /// A fault of a line.
    pub fn at_line(line: u64, reason: String) -> Self {
        Self {
            place: format!(", line {line}"),
            reason,
        }
    }

    /// A fault of a cell.
    pub fn in_cell(line: u64, head: &str, reason: String) -> Self {
        Self {
            place: format!(", line {line}, column {head}"),
            reason,
        }
    }
}

/// The reader of a table. Lines that begin with `#` are remarks.
pub(crate) struct NumberTable<'a> {
    text: &'a str,
    reader: Reader<&'a [u8]>,
    /// Number of lines above the text of `reader`.
    skipped: u64,
    pub heads: StringRecord,
    /// Cell separator.
    separator: u8,
    /// The first cell with a decimal mark: a point, or a comma if a comma does not separate cells.
    first_mark: Option<String>,
    /// A column head with its unit, for messages: `speed [m/s]`.
    example: &'static str,
}

/// A row of a table.
pub(crate) struct NumberRow {
    /// Line in the file, from 1.
    pub line: u64,
    cells: StringRecord,
}

impl<'a> NumberTable<'a> {
    /// Reads the column heads of a table. `example` is a column head with its unit, for messages.
    pub fn new(text: &'a str, example: &'static str) -> Result<Self, TableFault> {
        let (separator, rest) = detect_separator(text);
        let reader = ReaderBuilder::new()
            .trim(Trim::All)
            .comment(Some(b'#'))
            .delimiter(separator)
            .from_reader(rest.as_bytes());
        let mut table = Self {
            text,
            reader,
            skipped: text[..text.len() - rest.len()].matches('\n').count() as u64,
            heads: StringRecord::new(),
            separator,
            first_mark: None,
            example,
        };
        table.heads = match table.reader.headers() {
            Ok(heads) => heads.clone(),
            Err(error) => return Err(table.unreadable(&error)),
        };
        Ok(table)
    }

    /// The next row with a filled cell. `None` after the last row.
    pub fn next_row(&mut self) -> Result<Option<NumberRow>, TableFault> {
        let mut cells = StringRecord::new();
        loop {
            match self.reader.read_record(&mut cells) {
                Ok(true) => {}
                Ok(false) => return Ok(None),
                Err(error) => return Err(self.unreadable(&error)),
            }
            // spreadsheets end a table with rows of empty cells
            if cells.iter().any(|cell| !cell.is_empty()) {
                let line = self.line(cells.position());
                return Ok(Some(NumberRow { line, cells }));
            }
        }
    }

    /// The number of a row in the column with the index `column`.
    pub fn number(&mut self, row: &NumberRow, column: usize) -> Result<f64, TableFault> {
        let number = self.parse(&row.cells[column]);
        number.map_err(|reason| TableFault::in_cell(row.line, &self.heads[column], reason))
    }

    fn line(&self, position: Option<&csv::Position>) -> u64 {
        position.map_or(0, csv::Position::line) + self.skipped
    }

    fn unreadable(&self, error: &csv::Error) -> TableFault {
        let reason = csv_row_error_text(error, self.text.as_bytes());
        TableFault::at_line(self.line(error.position()), reason)
    }

    fn parse(&mut self, cell: &str) -> Result<f64, String> {
        if cell.is_empty() {
            return Err("the cell is empty; every row needs a value".into());
        }
        let mut plain = cell.replace('\u{2212}', "-");
        if self.separator != b',' {
            self.check_mark(cell)?;
            plain = plain.replacen(',', ".", 1);
        }
        match plain.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(format!("'{cell}' is not finite; give a number")),
            Err(_) => Err(format!(
                "'{cell}' is not a number; a unit is written in the head, as in '{}'",
                self.example
            )),
        }
    }

    /// Refuses a cell whose decimal mark differs from the first mark in the table, because one of
    /// the two marks may separate thousands.
    fn check_mark(&mut self, cell: &str) -> Result<(), String> {
        let mark_of = |cell: &str| [',', '.'].into_iter().find(|mark| cell.contains(*mark));
        let Some(mark) = mark_of(cell) else {
            return Ok(());
        };
        let first = self.first_mark.get_or_insert_with(|| cell.into());
        if mark_of(first) == Some(mark) {
            return Ok(());
        }
        let [own, other] = if mark == ',' {
            ["comma", "point"]
        } else {
            ["point", "comma"]
        };
        Err(format!(
            "'{cell}' has a {own}, but '{first}' has a {other}; write all decimals of the table \
             with the same mark, and nothing between thousands"
        ))
    }
}
