use super::line::DETAILS;
use super::{Document, DocumentBlock, DocumentTable, Line};
use crate::report::frame::svg_name;

impl Document {
    /// The document as Markdown (CommonMark with GitHub's tables). The figures are separate files
    /// `NAME-us.svg` or `NAME-metric.svg`.
    pub fn markdown(&self) -> String {
        let blocks = self.blocks().map(|block| match block {
            DocumentBlock::Heading(text) => format!("## {}\n", escaped(text)),
            DocumentBlock::Paragraph(text) => format!("{}\n", escaped(text)),
            DocumentBlock::List(lines) => lines.iter().map(line).collect(),
            DocumentBlock::Table(found) => table(found),
            DocumentBlock::Figure(figure) => {
                let picture = format!("![{}]({})\n", escaped(&figure.title), svg_name(figure));
                if figure.note.is_empty() {
                    picture
                } else {
                    format!("{picture}\n{}\n", escaped(&figure.note))
                }
            }
        });
        let title = (!self.title.is_empty()).then(|| format!("# {}\n", escaped(&self.title)));
        title
            .into_iter()
            .chain(blocks)
            .collect::<Vec<_>>()
            .join("\n")
    }
}

fn line(line: &Line) -> String {
    let indent = if line.indent == DETAILS { "  " } else { "" };
    format!("{indent}- {}\n", escaped(&line.text))
}

fn table(found: &DocumentTable) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<_> = cells.iter().map(|cell| escaped(cell)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = found
        .is_right
        .iter()
        .map(|is_right| if *is_right { "---:|" } else { "---|" });
    let rule = format!("|{}\n", rule.collect::<String>());
    let notes: String = found
        .notes()
        .map(|text| format!("\n{}\n", escaped(text)))
        .collect();
    let caption = if found.caption.is_empty() {
        String::new()
    } else {
        format!("{}\n\n", escaped(&found.caption))
    };
    let rows = found.rows.iter().map(|row| line(row));
    caption + &line(&found.head) + &rule + &rows.collect::<String>() + &notes
}

fn escaped(text: &str) -> String {
    let special = ['\\', '|', '*', '_', '`', '<', '>', '#', '[', ']', '&'];
    text.chars()
        .flat_map(|c| special.contains(&c).then_some('\\').into_iter().chain([c]))
        .collect()
}
