//! A report of several parts, written once and shown as text on a terminal or as Markdown.

mod markdown;
mod text;

/// Headings, paragraphs and tables, in order.
#[derive(Clone, Debug, Default)]
pub struct Document {
    blocks: Vec<Block>,
}

#[derive(Clone, Debug)]
enum Block {
    Title(String),
    Heading(String),
    Paragraph(String),
    Table { head: Vec<String>, rows: Vec<Vec<String>> },
}

impl Document {
    /// A document of this title.
    pub(super) fn new(title: &str) -> Self {
        Self { blocks: vec![Block::Title(title.into())] }
    }

    /// Begins a part.
    pub(super) fn heading(&mut self, text: &str) {
        self.blocks.push(Block::Heading(text.into()));
    }

    pub(super) fn paragraph(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }

    /// A table; all but its last column are aligned right.
    pub(super) fn table(&mut self, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
        let head = head.iter().map(|&name| name.to_owned()).collect();
        self.blocks.push(Block::Table { head, rows: rows.into_iter().collect() });
    }
}
