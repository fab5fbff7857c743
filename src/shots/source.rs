//! Where shots come from: an export, or messages of GSPro Open Connect.

use super::head::ExportHead;
use super::lines::{Lines, Record};
use super::objects::{Objects, Piece};
use super::open_connect;
use super::shot::{LAUNCH, Shot};
use super::table::Table;
use super::tabled::is_json;
use super::written;
use crate::columns::decoded;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use std::fs::File;
use std::io::{self, BufReader, Cursor, Read};
use std::path::Path;

/// Bytes at the beginning of a file that its kind and its head are looked for in.
const BEGINNING: u64 = 1 << 16;

/// Bytes read at a time.
const PIECE: usize = 1 << 16;

/// How rows are written.
#[derive(Clone, Debug)]
pub enum Layout {
    /// An export in comma-separated values.
    Export(Box<Export>),
    /// Messages of GSPro Open Connect.
    OpenConnect,
}

/// The head of an export.
#[derive(Clone, Debug)]
pub struct Export {
    pub(super) head: ExportHead,
}

impl Export {
    /// What separates its cells.
    pub fn separator(&self) -> u8 {
        self.head.separator
    }

    /// Its heads.
    pub fn heads(&self) -> &[String] {
        &self.head.heads
    }

    /// The units of a line below the heads, where there is one.
    pub fn units(&self) -> Option<&[String]> {
        self.head.units.as_deref()
    }

    /// Whether its numbers have decimal commas.
    pub fn has_decimal_comma(&self) -> bool {
        self.head.decimals == super::decimals::Decimals::Comma
    }

    /// The cells of a row.
    pub fn cells<'a>(&self, text: &'a str) -> Vec<std::borrow::Cow<'a, str>> {
        super::cells::cells(text, self.head.separator)
    }

    /// The columns that an earlier flight of the rows has added, which the table has not from its maker.
    pub(crate) fn added(&self) -> std::ops::Range<usize> {
        self.head.added.clone()
    }
}

/// Shots in a file.
pub struct Shots {
    pub(super) layout: Layout,
    pub(super) rows: Rows,
    pub(super) parameters: Vec<&'static Parameter>,
    /// Whether they are lines that `fly` wrote.
    is_written: bool,
}

/// Rows that are not looked at yet.
pub(super) enum Rows {
    Lines(Lines, Table),
    Objects(Box<dyn Read + Send>, Objects, Table),
}

/// Some rows.
pub(super) enum Chunk {
    Records(Vec<Record>),
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
        let table = Table(name.clone());
        // a folder opens, and cannot be read
        Self::read(setup, &name, table.io(File::open(path))?)
    }

    /// The shots of a text: comma-separated values with a head, or JSON. It may be in UTF-8 or UTF-16, behind byte-order marks.
    ///
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a text that cannot be read, is empty, or has a head without a column that a launch needs, with an unknown
    /// column, or with a unit of another kind.
    pub fn read(setup: &Setup<f64>, name: &str, source: impl Read + Send + 'static) -> Result<Self> {
        let table = Table(name.into());
        let mut source = table.io(decoded(source))?;
        let mut beginning = vec![];
        table.io((&mut source).take(BEGINNING).read_to_end(&mut beginning))?;
        let text = String::from_utf8_lossy(&beginning).into_owned();
        let source = Cursor::new(beginning).chain(source);
        if is_json(&text) {
            let launch = LAUNCH.iter().map(|name| setup.parameter(name)).collect::<Result<Vec<_>>>()?;
            let rows = Rows::Objects(Box::new(source), Objects::default(), table);
            let parameters = launch.into_iter().chain(written::further(setup, &text)).collect();
            return Ok(Self { layout: Layout::OpenConnect, rows, parameters, is_written: written::begins(&text) });
        }
        let mut lines = Lines::new(Box::new(BufReader::with_capacity(PIECE, source)), &text);
        let head = ExportHead::read(setup, &mut lines, &text, &table)?;
        let parameters = head.parameters(setup)?;
        let layout = Layout::Export(Box::new(Export { head }));
        Ok(Self { layout, rows: Rows::Lines(lines, table), parameters, is_written: false })
    }

    /// How its rows are written.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Whose export it is, where its heads tell; of JSON, what wrote it.
    pub fn maker(&self) -> Option<&'static str> {
        match &self.layout {
            Layout::Export(export) => export.head.maker,
            Layout::OpenConnect if self.is_written => Some("JSON lines of longdrive fly"),
            Layout::OpenConnect => Some("GSPro Open Connect"),
        }
    }

    /// What its reader should know of its columns.
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

    /// Whether its rows may state this outcome.
    pub fn has(&self, of: Outcome) -> bool {
        matches!(&self.layout, Layout::Export(export) if export.head.has(of))
    }

    /// Flies every row in the air of the setup, also where the export states that of each.
    pub fn in_given_air(&mut self) {
        if let Layout::Export(export) = &mut self.layout
            && export.head.leave_air_out()
        {
            let further = export.head.further.iter().map(|further| further.parameter);
            self.parameters = self.parameters[..LAUNCH.len()].iter().copied().chain(further).collect();
        }
    }

    /// Those of them that are no launch conditions.
    pub fn further(&self) -> &[&'static Parameter] {
        &self.parameters[LAUNCH.len()..]
    }
}

impl Rows {
    /// The next rows, at most `most`; `None` at the end.
    pub fn next_rows(&mut self, separator: u8, most: usize) -> Result<Option<Chunk>> {
        match self {
            Self::Lines(lines, table) => {
                let mut records = vec![];
                while records.len() < most {
                    match table.io(lines.record(separator))? {
                        Some(record) => records.push(record),
                        None => break,
                    }
                }
                Ok((!records.is_empty()).then_some(Chunk::Records(records)))
            }
            Self::Objects(source, objects, table) => {
                let mut pieces = vec![];
                let mut bytes = vec![0; PIECE];
                while pieces.len() < most {
                    if let Some(piece) = objects.next_piece() {
                        pieces.push(piece);
                        continue;
                    }
                    let read = table.io(source.read(&mut bytes))?;
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

impl Layout {
    /// What separates the cells of a row.
    pub(super) fn separator(&self) -> u8 {
        match self {
            Self::Export(export) => export.head.separator,
            Self::OpenConnect => b',',
        }
    }

    /// The shots of some rows, of which each has values of these further parameters.
    pub(super) fn shots(&self, chunk: Chunk, further: &[&'static Parameter]) -> Vec<Shot> {
        match (self, chunk) {
            (Self::Export(export), Chunk::Records(records)) => {
                records.into_iter().map(|record| export.head.shot(record)).collect()
            }
            (_, Chunk::Pieces(pieces)) => pieces.into_iter().map(|piece| open_connect::shot(piece, further)).collect(),
            // rows of a text are records
            (Self::OpenConnect, Chunk::Records(_)) => vec![],
        }
    }
}
