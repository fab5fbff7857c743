use super::{Block, Document, Table};
use crate::report::frame::svg_name;
use crate::units::System;

impl Document {
    /// As Markdown (CommonMark with the tables of GitHub); the figures are files beside it,
    /// `NAME-us.svg` or `NAME-metric.svg`.
    pub fn markdown(&self, system: System) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(text) => format!("## {}\n", escaped(text)),
            Block::Paragraph(text) => format!("{}\n", escaped(text)),
            Block::Table(found) => table(found),
            Block::Figure(figure) => {
                let picture = format!(
                    "![{}]({})\n",
                    escaped(&figure.title),
                    svg_name(figure, system)
                );
                if figure.note.is_empty() {
                    picture
                } else {
                    format!("{picture}\n{}\n", escaped(&figure.note))
                }
            }
        });
        let title = format!("# {}\n", escaped(&self.title));
        std::iter::once(title)
            .chain(blocks)
            .collect::<Vec<_>>()
            .join("\n")
    }
}

fn table(
    Table {
        head,
        rows,
        is_right,
    }: &Table,
) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<_> = cells.iter().map(|cell| escaped(cell)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = is_right
        .iter()
        .map(|is_right| if *is_right { "---:|" } else { "---|" });
    let rule = format!("|{}\n", rule.collect::<String>());
    line(head) + &rule + &rows.iter().map(|row| line(row)).collect::<String>()
}

/// A text whose signs mean nothing to Markdown.
fn escaped(text: &str) -> String {
    let special = ['\\', '|', '*', '_', '`', '<', '>', '#', '[', ']', '&'];
    text.chars()
        .flat_map(|c| special.contains(&c).then_some('\\').into_iter().chain([c]))
        .collect()
}
