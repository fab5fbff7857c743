//! Source of shots: an export, messages of GSPro Open Connect, or JSON lines that `fly` wrote.

use super::columns::ShotColumns;
use super::objects::Objects;
use super::open_connect;
use super::shot::Shot;
use super::written;
use crate::batch::CHUNK;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::table::{
    Column, Content, Record, RowFilter, TableEntry, TableUse, Text, TextTable, air_replaced,
    remark_from_line, unreadable_text,
};
use crate::units::Message;
use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

/// Buffer size, bytes.
const BUFFER: usize = 1 << 16;

/// Shots in a file.
pub struct Shots {
    /// The column heads of the table's first section; `None` for JSON.
    pub columns: Option<Arc<ShotColumns>>,
    pub(super) rows: UnreadRows,
    /// The parameters that each row states in addition to the launch, in the first section of a
    /// table. A later section may state more parameters, which come after these.
    pub other_parameters: Vec<&'static Parameter>,
    /// True if the source is JSON lines written by `fly`.
    is_written: bool,
}

/// Source of the unread rows: a table, or JSON objects.
pub(super) enum UnreadRows {
    Table(Box<TableRows>),
    Objects(Box<JsonRecords>),
}

/// The JSON objects of a text.
pub(super) struct JsonRecords {
    /// Name of the file, for messages.
    name: String,
    source: Box<dyn Read + Send>,
    objects: Objects,
    buffer: Vec<u8>,
    /// Records that were read before the flights begin.
    ahead: VecDeque<Record>,
    /// The air density, if the lines state it and the setup gives the air.
    replaced_air: Option<&'static Parameter>,
    remarks: Vec<Message>,
}

/// The rows of a table, section by section.
pub(super) struct TableRows {
    table: TextTable,
    /// Column heads of the current section.
    columns: Arc<ShotColumns>,
    /// The parameters that the first section states in addition to the launch.
    first_parameters: Vec<&'static Parameter>,
    /// The parameters that only later sections state.
    later_parameters: Vec<&'static Parameter>,
    /// True if a later section began after the previous chunk.
    section_began: bool,
    /// Remarks on later sections.
    remarks: Vec<Message>,
}

/// A section of a table: the rows below one line of column heads.
#[derive(Clone, Debug)]
pub struct Section {
    /// The column heads of the section.
    pub columns: Arc<ShotColumns>,
    /// True if this chunk begins a section other than the first.
    pub begins: bool,
}

/// A chunk of unread rows or messages.
pub(super) struct Chunk {
    /// The section of the table; `None` for JSON.
    pub section: Option<Section>,
    records: Vec<Record>,
    /// [`JsonRecords::replaced_air`]; `None` for a table.
    replaced_air: Option<&'static Parameter>,
}

impl Shots {
    /// Opens a file ("-" is standard input), and reads the rows of its table that `filter` selects.
    /// If `is_air_given` is true, every row has the air of the setup, even if the export states
    /// other air.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read), and [`Error::Table`] if the file
    /// cannot be opened, or if it is not a table and `filter` is not empty. If the filter selects
    /// no row, reading fails after the last row.
    pub fn open(
        setup: &Setup<f64>,
        path: &Path,
        filter: RowFilter,
        is_air_given: bool,
    ) -> Result<Self> {
        let mut text = if path == Path::new("-") {
            Text::open("standard input", io::stdin())?
        } else {
            Text::of_file(path)?
        };
        text.filter = filter;
        text.is_air_given = is_air_given;
        Self::of_text(setup, text)
    }

    /// Reads CSV with column heads, or JSON, in UTF-8, UTF-16 or Windows-1252.
    ///
    /// # Errors
    /// [`Error::Table`] if the text is unreadable or empty, if a launch column
    /// is missing, if a column is unknown, or if a unit has the wrong dimension.
    pub fn read(
        setup: &Setup<f64>,
        name: &str,
        source: impl Read + Send + 'static,
    ) -> Result<Self> {
        Self::of_text(setup, Text::open(name, source)?)
    }

    /// Reads shots from a text that was opened before.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read).
    pub(crate) fn of_text(setup: &Setup<f64>, text: Text) -> Result<Self> {
        if is_json(&text.beginning) {
            if !text.filter.is_empty() {
                let reason = "`only` selects rows of a table by a column, but these are JSON \
                     messages; leave out `only`";
                return Err(Error::table(text.name, "", reason));
            }
            let is_written = written::begins(&text.beginning);
            let is_air_given = text.is_air_given;
            let mut records = JsonRecords {
                name: text.name,
                source: text.source,
                objects: Objects::default(),
                buffer: vec![0; BUFFER],
                ahead: VecDeque::new(),
                replaced_air: None,
                remarks: vec![],
            };
            return Ok(Self {
                columns: None,
                other_parameters: records.other_parameters(setup, is_air_given)?,
                rows: UnreadRows::Objects(Box::new(records)),
                is_written,
            });
        }
        let (table, head) = TextTable::open(text, setup, TableUse::Launches)?;
        let columns = Arc::new(ShotColumns::read(head, &table)?);
        let rows = TableRows {
            table,
            columns: columns.clone(),
            first_parameters: columns.other_parameters.clone(),
            later_parameters: vec![],
            section_began: false,
            remarks: vec![],
        };
        Ok(Self {
            other_parameters: columns.other_parameters.clone(),
            columns: Some(columns),
            rows: UnreadRows::Table(Box::new(rows)),
            is_written: false,
        })
    }

    /// Reads all shots.
    ///
    /// # Errors
    /// Errors of the source.
    pub(crate) fn all(mut self) -> Result<Vec<Shot>> {
        let mut all = vec![];
        while let Some(chunk) = self.rows.next_rows(CHUNK)? {
            all.extend(chunk.shots(&self.other_parameters).0);
        }
        Ok(all)
    }

    /// Maker of the export, if its column heads identify it; for JSON, the name of the format.
    pub fn maker(&self) -> Option<&'static str> {
        match &self.columns {
            Some(columns) => columns.head.maker,
            None if self.is_written => Some("JSON lines of longdrive fly"),
            None => Some("GSPro Open Connect"),
        }
    }

    /// Remarks on later sections and on the whole table. They are complete after the last row.
    pub fn final_remarks(&self) -> Vec<Message> {
        match &self.rows {
            UnreadRows::Table(rows) => {
                let of_table = rows.table.final_remarks();
                rows.remarks.iter().cloned().chain(of_table).collect()
            }
            UnreadRows::Objects(..) => vec![],
        }
    }

    /// Remarks on the columns, or on the parameters of JSON lines.
    pub fn remarks(&self) -> &[Message] {
        match &self.rows {
            UnreadRows::Table(_) => self
                .columns
                .as_ref()
                .map_or(&[], |columns| &columns.remarks),
            UnreadRows::Objects(records) => &records.remarks,
        }
    }

    /// True if the first section of a table names the club of each shot.
    pub(crate) fn names_clubs(&self) -> bool {
        let columns = self.columns.as_ref();
        columns.is_some_and(|columns| columns.club_name.is_some())
    }

    /// The names of the parameters that only later sections of the table state, complete after the
    /// last row.
    pub(crate) fn later_parameters(&self) -> Vec<&'static str> {
        match &self.rows {
            UnreadRows::Table(rows) => rows.later_parameters.iter().map(|row| row.name).collect(),
            UnreadRows::Objects(..) => vec![],
        }
    }

    fn column_of(&self, of: Outcome) -> Option<&Column> {
        let head = &self.columns.as_ref()?.head;
        let (_, column) = head.column(Content::Outcome(of))?;
        Some(column)
    }

    /// True if the table has a column of this outcome.
    pub fn has(&self, of: Outcome) -> bool {
        self.column_of(of).is_some()
    }

    /// Column head of an outcome; the name of the outcome if it has no column.
    pub fn name_of(&self, of: Outcome) -> String {
        match &self.columns {
            Some(columns) => columns.head.name_of(of),
            None => of.name().into(),
        }
    }

    /// Unit in which the column of an outcome is read; `None` without such a column.
    pub fn unit_of(&self, of: Outcome) -> Option<&str> {
        self.column_of(of).map(Column::unit)
    }

    /// Advice for values whose unit is probably wrong.
    pub(super) fn unit_advice(&self) -> &'static str {
        match &self.columns {
            Some(_) => "check the unit in the head",
            None if self.is_written => "check the units of the original file",
            None => "check Units in the messages",
        }
    }
}

impl TableRows {
    /// The next rows, at most `most`, all from one section; `None` at the end of the table.
    fn next_rows(&mut self, most: usize) -> Result<Option<Chunk>> {
        let mut records = vec![];
        while records.len() < most {
            match self.table.next_entry()? {
                None => break,
                Some(TableEntry::Row(record)) => records.push(record),
                Some(TableEntry::Excluded) => {}
                Some(TableEntry::Head(record)) if records.is_empty() => self.begin(&record)?,
                Some(TableEntry::Head(record)) => {
                    self.table.give_back(record);
                    break;
                }
            }
        }
        if records.is_empty() {
            return Ok(None);
        }
        let begins = std::mem::take(&mut self.section_began);
        let section = Some(Section {
            columns: self.columns.clone(),
            begins,
        });
        Ok(Some(Chunk {
            section,
            records,
            replaced_air: None,
        }))
    }

    /// Begins a section at a line of column heads. A repetition of the current column heads is
    /// skipped.
    fn begin(&mut self, record: &Record) -> Result<()> {
        let Some(head) = self.table.section(record)? else {
            return Ok(());
        };
        let mut columns = ShotColumns::read(head, &self.table)?;
        columns.order_parameters_like(&self.first_parameters).map_err(|missing| {
            let reason = format!(
                "its column heads lack {missing}, which the first section has; give all sections \
                 the same columns, or put them in separate files"
            );
            let place = format!(", line {}", record.line);
            Error::table(&self.table.name, place, reason)
        })?;
        for &parameter in &columns.other_parameters[self.first_parameters.len()..] {
            if !self.later_parameters.contains(&parameter) {
                self.later_parameters.push(parameter);
            }
        }
        let remarks = columns.remarks.iter();
        self.remarks
            .extend(remarks.map(|remark| remark_from_line(record.line, remark)));
        (self.columns, self.section_began) = (Arc::new(columns), true);
        Ok(())
    }
}

impl UnreadRows {
    /// The next rows, at most `most`; `None` at the end.
    pub fn next_rows(&mut self, most: usize) -> Result<Option<Chunk>> {
        match self {
            Self::Table(rows) => rows.next_rows(most),
            Self::Objects(source) => {
                let mut records = vec![];
                while records.len() < most {
                    let Some(record) = source.next()? else {
                        break;
                    };
                    records.push(record);
                }
                let chunk = Chunk {
                    section: None,
                    records,
                    replaced_air: source.replaced_air,
                };
                Ok(Some(chunk).filter(|chunk| !chunk.records.is_empty()))
            }
        }
    }
}

impl JsonRecords {
    /// The parameters that the first flown shot states in addition to its launch, without the air
    /// density if the setup gives the air. Reads the records up to this shot.
    fn other_parameters(
        &mut self,
        setup: &Setup<f64>,
        is_air_given: bool,
    ) -> Result<Vec<&'static Parameter>> {
        let mut stated = None;
        while stated.is_none()
            && let Some(record) = self.read()?
        {
            stated = written::other_parameters(setup, &record.text);
            self.ahead.push_back(record);
        }
        let mut parameters = stated.unwrap_or_default();
        let air = setup.parameter("air.density")?;
        let is_replaced = is_air_given || setup.why_replaced(air).is_some();
        if is_replaced && parameters.contains(&air) {
            parameters.retain(|parameter| *parameter != air);
            self.replaced_air = Some(air);
            self.remarks
                .push(air_replaced("parameters.air.density").into());
        }
        Ok(parameters)
    }

    /// The next record; `None` at the end.
    fn next(&mut self) -> Result<Option<Record>> {
        match self.ahead.pop_front() {
            Some(record) => Ok(Some(record)),
            None => self.read(),
        }
    }

    /// Reads a record from the source.
    fn read(&mut self) -> Result<Option<Record>> {
        loop {
            if let Some(record) = self.objects.next_record() {
                return Ok(Some(record));
            }
            let count = self.source.read(&mut self.buffer);
            let count = count.map_err(|error| unreadable_text(&self.name, &error))?;
            if count > 0 {
                self.objects.push(&self.buffer[..count]);
            } else if self.objects.is_incomplete() {
                self.objects.finish();
            } else {
                return Ok(None);
            }
        }
    }
}

impl Chunk {
    /// Reads the shots of these rows, and returns them with the section of the rows. A JSON line
    /// that `fly` wrote must have values of exactly `other_parameters` and the replaced air.
    pub fn shots(self, other_parameters: &[&'static Parameter]) -> (Vec<Shot>, Option<Section>) {
        let Self {
            section,
            records,
            replaced_air,
        } = self;
        let stated: Vec<_> = other_parameters
            .iter()
            .copied()
            .chain(replaced_air)
            .collect();
        let shot = |record: Record| match &section {
            Some(section) => section.columns.shot(record),
            None => {
                let mut shot = open_connect::shot(record, &stated);
                if replaced_air.is_some()
                    && let Ok(point) = &mut shot.point
                {
                    point.pop();
                }
                shot
            }
        };
        (records.into_iter().map(shot).collect(), section)
    }
}

/// Recognizes the beginning of a text in JSON.
pub(crate) fn is_json(text: &str) -> bool {
    let mut characters = text.chars().filter(|c| !c.is_whitespace());
    match characters.next() {
        Some('{') => true,
        Some('[') => matches!(characters.next(), None | Some('{' | ']')),
        _ => false,
    }
}
