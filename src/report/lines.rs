//! Texts broken into lines that fit a terminal.

/// The width of a terminal that every table, paragraph and remark fits.
pub(super) const WIDTH: usize = 100;

/// Spaces before a line of a list.
const INDENT: usize = 2;

/// A paragraph.
pub(super) fn paragraph(text: &str) -> String {
    indented(text, 0, 0)
}

/// A line of a list, its lines indented alike.
pub(super) fn item(text: &str) -> String {
    indented(text, INDENT, INDENT)
}

/// What belongs to the line above.
pub(super) fn note(text: &str) -> String {
    indented(text, 3 * INDENT, 3 * INDENT)
}

/// A remark or warning for standard error: what does not fit its line is continued on indented lines. No line break at the end.
pub fn remark(text: &str) -> String {
    let lines: Vec<_> =
        text.lines().map(|line| if is_wide(line) { indented(line, 0, INDENT) } else { line.into() }).collect();
    lines.iter().map(|line| line.trim_end()).collect::<Vec<_>>().join("\n")
}

/// Breaks the lines of a text that are too wide.
pub(super) fn broken(text: &str) -> String {
    let line = |line: &str| {
        let indent = line.len() - line.trim_start().len();
        if is_wide(line) { indented(line.trim_start(), indent, indent) } else { format!("{line}\n") }
    };
    text.lines().map(line).collect()
}

fn is_wide(line: &str) -> bool {
    line.chars().count() > WIDTH
}

/// The words of a text in lines, the first indented by `first`, the others by `by`. A word stays whole, even where it is too wide: it
/// may be a file.
fn indented(text: &str, first: usize, by: usize) -> String {
    let mut lines = String::new();
    for paragraph in text.lines() {
        lines += &" ".repeat(first);
        let (mut width, mut is_begun) = (first, false);
        for word in paragraph.split(' ') {
            let size = word.chars().count();
            if is_begun && width + 1 + size > WIDTH {
                lines += "\n";
                lines += &" ".repeat(by);
                (width, is_begun) = (by, false);
            }
            if is_begun {
                lines += " ";
                width += 1;
            }
            lines += word;
            (width, is_begun) = (width + size, true);
        }
        lines += "\n";
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, item, paragraph, remark};

    #[test]
    fn exact_no_line_is_wider_than_a_terminal_and_no_word_is_lost() {
        let words = "a long explanation of what this is about, with the reason and what to do with it ".repeat(4);
        let words = words.trim();
        for text in [paragraph(words), item(words), remark(words)] {
            assert!(text.lines().all(|line| line.chars().count() <= WIDTH) && text.lines().count() > 3, "{text}");
            assert_eq!(text.split_whitespace().collect::<Vec<_>>().join(" "), words);
        }
        let said = remark(words);
        assert!(!said.starts_with(' ') && said.lines().skip(1).all(|line| line.starts_with("  ")), "{said}");
        let file = "/a/folder".repeat(20);
        assert_eq!(remark(&format!("wrote {file} anew")), format!("wrote\n  {file}\n  anew"), "a file stays whole");
        assert_eq!(remark("two\n  lines"), "two\n  lines", "what fits stays as it is");
    }
}
