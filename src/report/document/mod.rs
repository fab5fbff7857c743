//! The document of a report, and its conversion to plain text, Markdown and HTML.

mod html;
mod line;
mod markdown;
mod table;
mod table_text;
mod text;

pub(super) use html::content;
pub use html::document_files;
pub use line::Line;
pub(super) use table::DocumentTable;
pub use text::TextOptions;

use super::plot::Figure;

/// Headings, paragraphs, lists, tables and figures, in order.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// The title; may be empty.
    title: String,
    parts: Vec<DetailedBlock>,
}

/// A block of a document. A page contains every block; `detail` determines which plain texts
/// contain this block.
#[derive(Clone, Debug)]
struct DetailedBlock {
    block: DocumentBlock,
    detail: Detail,
}

/// Determines which plain texts contain a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Detail {
    /// Every text.
    Always,
    /// Texts with the option `all`.
    WithAll,
    /// Texts with the option `verbose`, which have details of the computation.
    WithVerbose,
}

/// A block of a document.
#[derive(Clone, Debug)]
pub(super) enum DocumentBlock {
    Heading(String),
    Paragraph(String),
    List(Vec<Line>),
    Table(DocumentTable),
    Figure(Box<Figure>),
}

impl DocumentBlock {
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

    /// Adds a block with its detail. A list without lines leaves the document unchanged.
    pub(super) fn add_detail(&mut self, block: DocumentBlock, detail: Detail) {
        let is_empty = matches!(&block, DocumentBlock::List(lines) if lines.is_empty());
        if !is_empty {
            self.parts.push(DetailedBlock { block, detail });
        }
    }

    fn blocks(&self) -> impl Iterator<Item = &DocumentBlock> {
        self.parts.iter().map(|part| &part.block)
    }

    /// Begins a section.
    pub fn heading(&mut self, text: &str) {
        self.add_detail(DocumentBlock::Heading(text.into()), Detail::Always);
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: impl Into<String>) {
        self.add_detail(DocumentBlock::Paragraph(text.into()), Detail::Always);
    }

    /// Adds consecutive lines. Without lines, the document is unchanged.
    pub fn list(&mut self, lines: impl IntoIterator<Item = Line>) {
        self.add_detail(
            DocumentBlock::List(lines.into_iter().collect()),
            Detail::Always,
        );
    }

    /// Adds a table.
    pub(super) fn add(&mut self, table: DocumentTable) {
        self.add_detail(DocumentBlock::Table(table), Detail::Always);
    }

    /// Adds a figure. Plain text omits it.
    pub(super) fn figure(&mut self, figure: Figure) {
        self.add_detail(DocumentBlock::Figure(Box::new(figure)), Detail::Always);
    }

    /// Adds the title of another document as a heading, then its blocks.
    pub fn append(&mut self, other: Self) {
        if !other.title.is_empty() {
            self.add_detail(DocumentBlock::Heading(other.title), Detail::Always);
        }
        self.parts.extend(other.parts);
    }

    /// Appends another document and sets the detail of its blocks.
    pub(super) fn append_detail(&mut self, other: Self, detail: Detail) {
        let before = self.parts.len();
        self.append(other);
        for part in &mut self.parts[before..] {
            part.detail = detail;
        }
    }

    /// Puts lines before the first block. If the first block is a list, the lines begin this list.
    pub(super) fn put_first(&mut self, first: impl Iterator<Item = Line>) {
        if let Some(DetailedBlock {
            block: DocumentBlock::List(lines),
            detail: Detail::Always,
        }) = self.parts.first_mut()
        {
            lines.splice(0..0, first);
            return;
        }
        let part = DetailedBlock {
            block: DocumentBlock::List(first.collect()),
            detail: Detail::Always,
        };
        self.parts.insert(0, part);
    }

    /// Replaces each text by `write(text)`, except the texts of figures.
    #[must_use]
    pub fn map_texts(mut self, write: impl Fn(&str) -> String) -> Self {
        let change = |text: &mut String| *text = write(text);
        change(&mut self.title);
        for DetailedBlock { block, .. } in &mut self.parts {
            match block {
                DocumentBlock::Heading(text) | DocumentBlock::Paragraph(text) => change(text),
                DocumentBlock::List(lines) => {
                    lines.iter_mut().for_each(|line| change(&mut line.text))
                }
                DocumentBlock::Table(table) => table.texts().for_each(change),
                DocumentBlock::Figure(_) => {}
            }
        }
        self
    }

    /// The figures, in order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.blocks().filter_map(|block| match block {
            DocumentBlock::Figure(figure) => Some(figure.as_ref()),
            _ => None,
        })
    }
}
