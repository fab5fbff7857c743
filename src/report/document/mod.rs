//! A report of several parts, written once: shown as text on a terminal, as Markdown, or as a page
//! of HTML.

mod html;
mod markdown;
mod text;

pub use html::document_files;

use super::frame::is_of_numbers;
use super::plot::Figure;

/// Headings, paragraphs, tables and figures, in order.
#[derive(Clone, Debug, Default)]
pub struct Document {
    title: String,
    blocks: Vec<Block>,
}

#[derive(Clone, Debug)]
enum Block {
    Heading(String),
    Paragraph(String),
    Table(Table),
    Figure(Box<Figure>),
}

#[derive(Clone, Debug)]
struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    /// Whether each column is aligned right.
    is_right: Vec<bool>,
}

impl Block {
    fn is_figure(&self) -> bool {
        matches!(self, Self::Figure(_))
    }
}

impl Document {
    /// A document of this title.
    pub(super) fn new(title: &str) -> Self {
        Self {
            title: title.into(),
            blocks: vec![],
        }
    }

    /// Begins a part.
    pub(super) fn heading(&mut self, text: &str) {
        self.blocks.push(Block::Heading(text.into()));
    }

    pub(super) fn paragraph(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }

    /// A table; its columns of numbers are aligned right, and their heads.
    pub(super) fn table(&mut self, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
        let head: Vec<String> = head.iter().map(|&name| name.to_owned()).collect();
        let rows: Vec<Vec<String>> = rows.into_iter().collect();
        let cells = |column: usize| {
            rows.iter()
                .filter_map(move |row| row.get(column))
                .map(String::as_str)
        };
        let is_right = (0..head.len())
            .map(|column| is_of_numbers(cells(column)))
            .collect();
        self.blocks.push(Block::Table(Table {
            head,
            rows,
            is_right,
        }));
    }

    /// A figure; on a terminal it is left out.
    pub(super) fn figure(&mut self, figure: Figure) {
        self.blocks.push(Block::Figure(Box::new(figure)));
    }

    /// The figures, in order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Figure(figure) => Some(figure.as_ref()),
            _ => None,
        })
    }
}
