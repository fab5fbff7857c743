//! The document of a report, and its conversion to plain text, Markdown and HTML.

mod html;
mod markdown;
mod text;

pub use html::document_files;
pub use text::TextOptions;

use super::frame::is_of_numbers;
use super::plot::Figure;

/// Headings, paragraphs, lists, tables and figures, in order.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// The title; may be empty.
    title: String,
    parts: Vec<Part>,
}

/// A block with its detail. Pages show all blocks.
#[derive(Clone, Debug)]
struct Part {
    block: Block,
    detail: Detail,
}

/// The detail of a block. It determines the texts that show the block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Detail {
    /// All texts.
    Answer,
    /// Texts that show every table, which a text for a screen does not.
    Rest,
    /// Texts about the computation.
    Computation,
}

#[derive(Clone, Debug)]
enum Block {
    Heading(String),
    Paragraph(String),
    List(Vec<Line>),
    Table(Table),
    Figure(Box<Figure>),
}

/// A line of a list.
#[derive(Clone, Debug)]
pub struct Line {
    level: Level,
    text: String,
}

/// The indent of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Level {
    /// No indent.
    Flush,
    /// An item of a list.
    Item,
    /// Details of the item above.
    Note,
}

impl Line {
    /// A line without indent.
    pub fn flush(text: impl Into<String>) -> Self {
        Self::new(Level::Flush, text)
    }

    /// An item of a list.
    pub fn item(text: impl Into<String>) -> Self {
        Self::new(Level::Item, text)
    }

    /// Details of the item above.
    pub fn note(text: impl Into<String>) -> Self {
        Self::new(Level::Note, text)
    }

    fn new(level: Level, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { level, text }
    }
}

/// A table with remarks below it.
#[derive(Clone, Debug)]
pub(super) struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    /// Right-aligned columns.
    is_right: Vec<bool>,
    /// A line directly above the table; omitted if it is empty.
    caption: String,
    /// Details below each row; an empty text is omitted.
    row_notes: Vec<String>,
    /// Lines directly below the table.
    remarks: Vec<Line>,
    /// Number of rows that a text for a screen shows.
    first_rows: usize,
}

impl Table {
    /// A table with these column heads. Columns of numbers are right-aligned.
    pub fn new<H: Into<String>>(
        head: impl IntoIterator<Item = H>,
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        let head: Vec<String> = head.into_iter().map(Into::into).collect();
        let rows: Vec<Vec<String>> = rows.into_iter().collect();
        let is_right = (0..head.len())
            .map(|column| {
                let cells = rows.iter().filter_map(|row| row.get(column));
                is_of_numbers(cells.map(String::as_str))
            })
            .collect();
        Self {
            head,
            rows,
            is_right,
            caption: String::new(),
            row_notes: vec![],
            remarks: vec![],
            first_rows: usize::MAX,
        }
    }

    /// Right-aligns exactly these columns.
    #[must_use]
    pub fn right(mut self, columns: impl IntoIterator<Item = usize>) -> Self {
        self.is_right.fill(false);
        for column in columns {
            self.is_right[column] = true;
        }
        self
    }

    /// Adds a line directly above the table.
    #[must_use]
    pub fn with_caption(self, caption: &str) -> Self {
        Self {
            caption: caption.into(),
            ..self
        }
    }

    /// Limits the number of rows that a text for a screen shows.
    #[must_use]
    pub fn with_first_rows(self, first_rows: usize) -> Self {
        Self { first_rows, ..self }
    }

    /// Adds details below each row.
    #[must_use]
    pub fn with_row_notes(self, row_notes: Vec<String>) -> Self {
        Self { row_notes, ..self }
    }

    /// Adds a remark directly below the table.
    pub fn remark(&mut self, text: impl Into<String>) {
        self.line(Line::item(text));
    }

    /// Adds a line directly below the table.
    pub fn line(&mut self, line: Line) {
        self.remarks.push(line);
    }

    /// All texts.
    fn texts(&mut self) -> impl Iterator<Item = &mut String> {
        let remarks = self.remarks.iter_mut().map(|line| &mut line.text);
        self.head
            .iter_mut()
            .chain(self.rows.iter_mut().flatten())
            .chain([&mut self.caption])
            .chain(&mut self.row_notes)
            .chain(remarks)
    }

    /// The notes and remarks of the table, without the caption.
    fn notes(&self) -> impl Iterator<Item = &str> {
        let remarks = self.remarks.iter().map(|line| line.text.as_str());
        self.row_notes.iter().map(String::as_str).chain(remarks)
    }
}

impl Block {
    fn is_figure(&self) -> bool {
        matches!(self, Self::Figure(_))
    }
}

impl Document {
    /// A document with this title.
    pub fn new(title: &str) -> Self {
        Self {
            title: title.into(),
            parts: vec![],
        }
    }

    fn push(&mut self, block: Block) {
        self.parts.push(Part {
            block,
            detail: Detail::Answer,
        });
    }

    fn blocks(&self) -> impl Iterator<Item = &Block> {
        self.parts.iter().map(|part| &part.block)
    }

    /// Begins a section.
    pub fn heading(&mut self, text: &str) {
        self.push(Block::Heading(text.into()));
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: impl Into<String>) {
        self.push(Block::Paragraph(text.into()));
    }

    /// Adds consecutive lines. Without lines, the document is unchanged.
    pub fn list(&mut self, lines: impl IntoIterator<Item = Line>) {
        let lines: Vec<Line> = lines.into_iter().collect();
        if !lines.is_empty() {
            self.push(Block::List(lines));
        }
    }

    /// Adds a table.
    pub(super) fn add(&mut self, table: Table) {
        self.push(Block::Table(table));
    }

    /// Adds a figure. Plain text omits it.
    pub(super) fn figure(&mut self, figure: Figure) {
        self.push(Block::Figure(Box::new(figure)));
    }

    /// Adds the blocks of another document; its title becomes a heading.
    pub fn append(&mut self, other: Self) {
        if !other.title.is_empty() {
            self.push(Block::Heading(other.title));
        }
        self.parts.extend(other.parts);
    }

    /// Adds the blocks of another document with this detail.
    pub(super) fn append_detail(&mut self, other: Self, detail: Detail) {
        let before = self.parts.len();
        self.append(other);
        for part in &mut self.parts[before..] {
            part.detail = detail;
        }
    }

    /// Puts lines before the first block. If the first block is a list, the lines begin this list.
    pub(super) fn put_first(&mut self, first: impl Iterator<Item = Line>) {
        if let Some(Part {
            block: Block::List(lines),
            detail: Detail::Answer,
        }) = self.parts.first_mut()
        {
            lines.splice(0..0, first);
            return;
        }
        let part = Part {
            block: Block::List(first.collect()),
            detail: Detail::Answer,
        };
        self.parts.insert(0, part);
    }

    /// Changes each text of the document, apart from the figures.
    #[must_use]
    pub fn map_texts(mut self, write: impl Fn(&str) -> String) -> Self {
        let change = |text: &mut String| *text = write(text);
        change(&mut self.title);
        for Part { block, .. } in &mut self.parts {
            match block {
                Block::Heading(text) | Block::Paragraph(text) => change(text),
                Block::List(lines) => lines.iter_mut().for_each(|line| change(&mut line.text)),
                Block::Table(table) => table.texts().for_each(change),
                Block::Figure(_) => {}
            }
        }
        self
    }

    /// The figures, in order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.blocks().filter_map(|block| match block {
            Block::Figure(figure) => Some(figure.as_ref()),
            _ => None,
        })
    }
}
