use super::{Block, Document};

impl Document {
    /// As Markdown (CommonMark with the tables of GitHub); the figures are files beside it, `NAME.svg`.
    pub fn markdown(&self) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Title(text) => format!("# {}\n", escaped(text)),
            Block::Heading(text) => format!("## {}\n", escaped(text)),
            Block::Paragraph(text) => format!("{}\n", escaped(text)),
            Block::Table { head, rows } => table(head, rows),
            Block::Figure(figure) => {
                let picture = format!("![{}]({}.svg)\n", escaped(&figure.title), figure.name);
                if figure.note.is_empty() { picture } else { format!("{picture}\n{}\n", escaped(&figure.note)) }
            }
        });
        blocks.collect::<Vec<_>>().join("\n")
    }
}

fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<_> = cells.iter().map(|cell| escaped(cell)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let last = head.len().saturating_sub(1);
    let rule = (0..head.len()).map(|column| if column < last { "---:|" } else { "---|" });
    let rule = format!("|{}\n", rule.collect::<String>());
    line(head) + &rule + &rows.iter().map(|row| line(row)).collect::<String>()
}

/// A text whose signs mean nothing to Markdown.
fn escaped(text: &str) -> String {
    let special = ['\\', '|', '*', '_', '`', '<', '>', '#', '[', ']', '&'];
    text.chars().flat_map(|c| special.contains(&c).then_some('\\').into_iter().chain([c])).collect()
}
