use super::{Block, Document};
use crate::report::lines::paragraph;
use crate::report::table::table;

impl Document {
    /// As plain text.
    pub fn text(&self) -> String {
        let blocks = self.blocks.iter().filter_map(|block| match block {
            Block::Title(text) => Some(format!("{text}\n{}\n", "=".repeat(text.chars().count()))),
            Block::Heading(text) => Some(format!("\n{text}\n{}\n", "-".repeat(text.chars().count()))),
            Block::Paragraph(text) => Some(paragraph(text)),
            Block::Table { head, rows } => {
                let head: Vec<&str> = head.iter().map(String::as_str).collect();
                let right: Vec<usize> = (0..head.len().saturating_sub(1)).collect();
                Some(table(&head, &right, rows.iter().cloned()))
            }
            Block::Figure(_) => None,
        });
        blocks.collect::<Vec<_>>().join("\n")
    }
}
