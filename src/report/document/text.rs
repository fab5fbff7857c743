use super::{Detail, Document, DocumentBlock};
use crate::report::lines::wrapped;

/// The width and the detail of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextOptions {
    /// The maximum width of a line, in characters. A single word may be wider, and so may a table
    /// that cannot be narrower.
    pub width: usize,
    /// True to include tables and rows that do not fit on a screen.
    pub all: bool,
    /// True to include details of the computation: residuals, and parameters that were left out.
    pub verbose: bool,
}

impl Default for TextOptions {
    /// Everything, in 80 columns.
    fn default() -> Self {
        Self {
            width: 80,
            all: true,
            verbose: true,
        }
    }
}

/// The last line of a text that leaves out blocks of [`Detail::WithAll`].
const REST: &str = "the rest of the answer: `all`";

impl Document {
    /// The document as plain text, its blocks separated by blank lines.
    pub fn text(&self, options: &TextOptions) -> String {
        let title = (!self.title.is_empty()).then(|| underlined(&self.title, "="));
        let width = options.width;
        let blocks = self.parts.iter().enumerate().filter_map(|(at, part)| {
            let is_left_out = match part.detail {
                Detail::Always => false,
                Detail::WithAll => !options.all,
                Detail::WithVerbose => !options.verbose,
            };
            if is_left_out {
                return None;
            }
            Some(match &part.block {
                DocumentBlock::Heading(_) if self.is_of_figures(at) => return None,
                DocumentBlock::Heading(text) => format!("\n{}", underlined(text, "-")),
                DocumentBlock::Paragraph(text) => wrapped(text, [0; 2], width),
                DocumentBlock::List(lines) => {
                    let lines = lines
                        .iter()
                        .map(|line| wrapped(&line.text, [line.indent; 2], width));
                    lines.collect()
                }
                DocumentBlock::Table(table) => table.text(options),
                DocumentBlock::Figure(_) => return None,
            })
        });
        let leaves_out_blocks =
            !options.all && self.parts.iter().any(|part| part.detail == Detail::WithAll);
        let rest = leaves_out_blocks.then(|| wrapped(REST, [0; 2], width));
        title
            .into_iter()
            .chain(blocks)
            .chain(rest)
            .collect::<Vec<_>>()
            .join("\n")
    }

    /// True if the section of the heading at index `heading` has only figures. Plain text omits
    /// such a heading.
    fn is_of_figures(&self, heading: usize) -> bool {
        let mut section = self.parts[heading + 1..]
            .iter()
            .map(|part| &part.block)
            .take_while(|block| !matches!(block, DocumentBlock::Heading(_)))
            .peekable();
        section.peek().is_some() && section.all(DocumentBlock::is_figure)
    }
}

fn underlined(text: &str, sign: &str) -> String {
    format!("{text}\n{}\n", sign.repeat(text.chars().count()))
}
