//! Where shots come from: an export, or messages of GSPro Open Connect.

use super::head::ExportHead;
use super::objects::{Objects, Piece};
use super::open_connect;
use super::section::{Export, Section};
use super::shot::{LAUNCH, Shot};
use super::written;
use crate::batch::CHUNK;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Golfer, Parameter, Setup};
use crate::table::{Entry, Record, SourceName, Text, TextTable, Wanted};
use crate::units::Message;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

/// Bytes read at a time.
const PIECE: usize = 1 << 16;

/// How rows are written.
#[derive(Clone, Debug)]
pub enum Layout {
    /// An export in comma-separated values.
    Export(Arc<Export>),
    /// Messages of GSPro Open Connect.
    OpenConnect,
}

/// Shots in a file.
pub struct Shots {
    pub(super) layout: Layout,
    pub(super) rows: Rows,
    pub(super) parameters: Vec<&'static Parameter>,
    /// JSON lines written by `fly`.
    is_written: bool,
}

/// Rows that are not looked at yet.
pub(super) enum Rows {
    Table(Box<TableRows>),
    Objects(Box<dyn Read + Send>, Objects, SourceName),
}

/// The rows of a table, section by section.
pub(super) struct TableRows {
    table: TextTable,
    setup: Setup<f64>,
    /// The head of the section, and whether none of its rows has been handed on.
    export: Arc<Export>,
    is_begun: bool,
    /// The further parameters that every row has a value of.
    further: Vec<&'static Parameter>,
    is_air_given: bool,
    /// Remarks on later sections.
    remarks: Vec<Message>,
}

/// Rows of a section of an export.
pub(super) struct Records {
    pub export: Arc<Export>,
    /// They begin a later section.
    pub begins: bool,
    records: Vec<Record>,
}

/// Some rows.
pub(super) enum Chunk {
    Records(Records),
    Pieces(Vec<Piece>),
}

impl Shots {
    /// The shots of a file; "-" is standard input.
    ///
    /// # Errors
    /// As [`read`](Self::read), and for a file that cannot be read.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            return Self::read(setup, "standard input", io::stdin());
        }
        let name = path.display().to_string();
        let table = SourceName(name.clone());
        // a folder opens, and cannot be read
        Self::read(setup, &name, table.io(File::open(path))?)
    }

    /// The shots of a text: comma-separated values with a head, or JSON. It may be in UTF-8 or
    /// UTF-16, behind byte-order marks.
    ///
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a text that cannot be read, is empty, or has a
    /// head without a column that a launch needs, with an unknown column, or with a unit of another
    /// kind.
    pub fn read(
        setup: &Setup<f64>,
        name: &str,
        source: impl Read + Send + 'static,
    ) -> Result<Self> {
        Self::of_text(setup, Text::open(name, source)?)
    }

    /// The shots of a text that is being read.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub(crate) fn of_text(setup: &Setup<f64>, text: Text) -> Result<Self> {
        if is_json(&text.beginning) {
            let launch = LAUNCH
                .iter()
                .map(|name| setup.parameter(name))
                .collect::<Result<Vec<_>>>()?;
            let parameters = launch
                .into_iter()
                .chain(written::further(setup, &text.beginning))
                .collect();
            let is_written = written::begins(&text.beginning);
            let rows = Rows::Objects(text.source, Objects::default(), text.name);
            return Ok(Self {
                layout: Layout::OpenConnect,
                rows,
                parameters,
                is_written,
            });
        }
        // shots are passed on as they are stated, + to the right for every golfer
        let setup = Setup {
            golfer: Golfer::Right,
            ..*setup
        };
        let (table, head) = TextTable::open(text, &setup, &Wanted::LAUNCHES)?;
        let head = ExportHead::read(&setup, head, &table)?;
        let parameters = head.parameters(&setup)?;
        let export = Arc::new(Export { head });
        let rows = TableRows {
            table,
            setup,
            export: export.clone(),
            is_begun: false,
            further: parameters[LAUNCH.len()..].to_vec(),
            is_air_given: false,
            remarks: vec![],
        };
        Ok(Self {
            layout: Layout::Export(export),
            rows: Rows::Table(Box::new(rows)),
            parameters,
            is_written: false,
        })
    }

    /// All of them.
    ///
    /// # Errors
    /// Errors of the source.
    pub(crate) fn all(mut self) -> Result<Vec<Shot>> {
        let mut all = vec![];
        while let Some(chunk) = self.rows.next_rows(CHUNK)? {
            all.extend(chunk.shots(&self.parameters[LAUNCH.len()..]).0);
        }
        Ok(all)
    }

    /// How its rows are written.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Maker of the export, if its heads identify it; for JSON the format.
    pub fn maker(&self) -> Option<&'static str> {
        match &self.layout {
            Layout::Export(export) => export.head.maker,
            Layout::OpenConnect if self.is_written => Some("JSON lines of longdrive fly"),
            Layout::OpenConnect => Some("GSPro Open Connect"),
        }
    }

    /// Remarks on later sections, complete after the last row.
    pub fn remarks_of_sections(&self) -> &[Message] {
        match &self.rows {
            Rows::Table(rows) => &rows.remarks,
            Rows::Objects(..) => &[],
        }
    }

    /// Remarks on the columns.
    pub fn remarks(&self) -> &[Message] {
        match &self.layout {
            Layout::Export(export) => &export.head.remarks,
            Layout::OpenConnect => &[],
        }
    }

    /// The parameters that each row has a value of: a launch, and what further columns give.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    /// True if the table has a column of this outcome.
    pub fn has(&self, of: Outcome) -> bool {
        matches!(&self.layout, Layout::Export(export) if export.head.has(of))
    }

    /// Head of the column of an outcome.
    pub fn name_of(&self, of: Outcome) -> String {
        match &self.layout {
            Layout::Export(export) => export.head.name_of(of),
            Layout::OpenConnect => of.name().into(),
        }
    }

    /// Flies every row in the air of the setup, also where the export states that of each.
    pub fn in_given_air(&mut self) {
        let (Layout::Export(export), Rows::Table(rows)) = (&mut self.layout, &mut self.rows) else {
            return;
        };
        rows.is_air_given = true;
        if Arc::make_mut(export).head.leave_air_out() {
            rows.further = export
                .head
                .further
                .iter()
                .map(|further| further.parameter)
                .collect();
            rows.export = export.clone();
            self.parameters.truncate(LAUNCH.len());
            self.parameters.extend(&rows.further);
        }
    }

    /// Those of them that are no launch conditions.
    pub fn further(&self) -> &[&'static Parameter] {
        &self.parameters[LAUNCH.len()..]
    }
}

impl TableRows {
    /// The next rows of the same section.
    fn next_rows(&mut self, most: usize) -> Result<Option<Chunk>> {
        let mut records = vec![];
        while records.len() < most {
            match self.table.next_entry()? {
                None => break,
                Some(Entry::Row(record)) => records.push(record),
                Some(Entry::Head(record)) if records.is_empty() => self.begin(&record)?,
                Some(Entry::Head(record)) => {
                    self.table.give_back(record);
                    break;
                }
            }
        }
        if records.is_empty() {
            return Ok(None);
        }
        let begins = std::mem::take(&mut self.is_begun);
        Ok(Some(Chunk::Records(Records {
            export: self.export.clone(),
            begins,
            records,
        })))
    }

    /// Begins the section of a head.
    fn begin(&mut self, record: &Record) -> Result<()> {
        let head = self.table.head(record, &self.setup, &Wanted::LAUNCHES)?;
        if head.is_like(&self.export.head.heads, self.export.head.units.as_deref()) {
            return Ok(());
        }
        let mut head = ExportHead::read(&self.setup, head, &self.table)?;
        if self.is_air_given {
            head.leave_air_out();
        }
        head.align(&self.further).map_err(|missing| {
            let reason = format!(
                "its head has no column of {missing}, as the first has; give the \
                                  sections the same columns, or separate files"
            );
            self.table
                .name
                .refused(format!(", line {}", record.line), reason)
        })?;
        let told = |remark: &Message| {
            Message::from(format!("from line {} on: ", record.line)).message(remark.clone())
        };
        self.remarks.extend(head.remarks.iter().map(told));
        (self.export, self.is_begun) = (Arc::new(Export { head }), true);
        Ok(())
    }
}

impl Rows {
    /// The next rows, at most `most`; `None` at the end.
    pub fn next_rows(&mut self, most: usize) -> Result<Option<Chunk>> {
        match self {
            Self::Table(rows) => rows.next_rows(most),
            Self::Objects(source, objects, name) => {
                let mut pieces = vec![];
                let mut bytes = vec![0; PIECE];
                while pieces.len() < most {
                    if let Some(piece) = objects.next_piece() {
                        pieces.push(piece);
                        continue;
                    }
                    let read = name.io(source.read(&mut bytes))?;
                    if read > 0 {
                        objects.push(&bytes[..read]);
                    } else if objects.is_under_way() {
                        objects.finish();
                    } else {
                        break;
                    }
                }
                Ok((!pieces.is_empty()).then_some(Chunk::Pieces(pieces)))
            }
        }
    }
}

impl Chunk {
    /// The shots of these rows, of which each has values of these further parameters; and their
    /// section.
    pub fn shots(self, further: &[&'static Parameter]) -> (Vec<Shot>, Option<Section>) {
        match self {
            Self::Records(Records {
                export,
                begins,
                records,
            }) => {
                let shots = records
                    .into_iter()
                    .map(|record| export.head.shot(record))
                    .collect();
                (shots, Some(Section { export, begins }))
            }
            Self::Pieces(pieces) => (
                pieces
                    .into_iter()
                    .map(|piece| open_connect::shot(piece, further))
                    .collect(),
                None,
            ),
        }
    }
}

/// Recognizes JSON.
pub(crate) fn is_json(text: &str) -> bool {
    let mut characters = text.chars().filter(|c| !c.is_whitespace());
    match characters.next() {
        Some('{') => true,
        Some('[') => matches!(characters.next(), None | Some('{' | ']')),
        _ => false,
    }
}
