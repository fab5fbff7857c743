use super::{Block, Document, Level, Line, Table};
use crate::report::lines::{item, note, paragraph};
use crate::report::table::table;

impl Document {
    /// The document as plain text, its blocks separated by blank lines.
    pub fn text(&self) -> String {
        let title = (!self.title.is_empty()).then(|| underlined(&self.title, "="));
        let blocks = self.blocks.iter().enumerate().filter_map(|(at, block)| {
            Some(match block {
                Block::Heading(_) if self.is_of_figures(at) => return None,
                Block::Heading(text) => format!("\n{}", underlined(text, "-")),
                Block::Paragraph(text) => paragraph(text),
                Block::List(lines) => lines.iter().map(line_text).collect(),
                Block::Table(table) => table_text(table),
                Block::Figure(_) => return None,
            })
        });
        title
            .into_iter()
            .chain(blocks)
            .collect::<Vec<_>>()
            .join("\n")
    }

    /// True if the section of this heading has only figures, which plain text omits.
    fn is_of_figures(&self, heading: usize) -> bool {
        let mut section = self.blocks[heading + 1..]
            .iter()
            .take_while(|block| !matches!(block, Block::Heading(_)))
            .peekable();
        section.peek().is_some() && section.all(Block::is_figure)
    }
}

fn underlined(text: &str, sign: &str) -> String {
    format!("{text}\n{}\n", sign.repeat(text.chars().count()))
}

fn line_text(line: &Line) -> String {
    match line.level {
        Level::Flush => paragraph(&line.text),
        Level::Item => item(&line.text),
        Level::Note => note(&line.text),
    }
}

fn table_text(found: &Table) -> String {
    let head: Vec<&str> = found.head.iter().map(String::as_str).collect();
    let right: Vec<usize> = (0..head.len())
        .filter(|column| found.is_right[*column])
        .collect();
    let mut text = table(&head, &right, found.rows.iter().cloned());
    if !found.row_notes.is_empty() {
        // a table of single lines: the head, then the rows
        let details = found.row_notes.iter().map(|details| note(details));
        let details = std::iter::once(String::new()).chain(details);
        text = text
            .lines()
            .zip(details)
            .map(|(line, details)| format!("{line}\n{details}"))
            .collect();
    }
    let caption = if found.caption.is_empty() {
        String::new()
    } else {
        paragraph(&found.caption)
    };
    let remarks: String = found.remarks.iter().map(line_text).collect();
    caption + &text + &remarks
}
