use super::{Block, Document, Table};
use crate::report::lines::paragraph;
use crate::report::table::table;

impl Document {
    /// As plain text.
    pub fn text(&self) -> String {
        // a part of figures alone has nothing to show here
        let is_of_figures = |at: usize| {
            let part = self.blocks[at + 1..]
                .iter()
                .take_while(|block| !matches!(block, Block::Heading(_)));
            self.blocks.get(at + 1).is_some_and(Block::is_figure)
                && part.clone().all(Block::is_figure)
        };
        let blocks = self
            .blocks
            .iter()
            .enumerate()
            .filter_map(|(at, block)| match block {
                Block::Heading(_) if is_of_figures(at) => None,
                Block::Heading(text) => {
                    Some(format!("\n{text}\n{}\n", "-".repeat(text.chars().count())))
                }
                Block::Paragraph(text) => Some(paragraph(text)),
                Block::Table(Table {
                    head,
                    rows,
                    is_right,
                }) => {
                    let head: Vec<&str> = head.iter().map(String::as_str).collect();
                    let right: Vec<usize> =
                        (0..head.len()).filter(|column| is_right[*column]).collect();
                    Some(table(&head, &right, rows.iter().cloned()))
                }
                Block::Figure(_) => None,
            });
        let title = format!(
            "{}\n{}\n",
            self.title,
            "=".repeat(self.title.chars().count())
        );
        std::iter::once(title)
            .chain(blocks)
            .collect::<Vec<_>>()
            .join("\n")
    }
}
