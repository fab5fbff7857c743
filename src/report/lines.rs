//! Wraps texts into lines for a terminal.

use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

/// Spaces before a line of a list.
pub(super) const INDENT: usize = 2;

/// A remark or warning for standard error, wrapped to `width` columns. The second and later lines
/// are indented. The result does not end with a line break.
pub fn remark(text: &str, width: usize) -> String {
    let lines: Vec<_> = text
        .lines()
        .map(|line| {
            if line.chars().count() > width {
                wrapped(line, [0, INDENT], width)
            } else {
                line.into()
            }
        })
        .collect();
    lines
        .iter()
        .map(|line| line.trim_end())
        .collect::<Vec<_>>()
        .join("\n")
}

/// Wraps each line of a text to `most` columns. In the result, `first` is the indent of the first
/// line, and `by` is the indent of the following lines. A word that is too wide stays whole,
/// because it may be a file name. The result ends with a line break.
pub fn wrapped(text: &str, [first, by]: [usize; 2], most: usize) -> String {
    let [first, by] = [first, by].map(|columns| " ".repeat(columns));
    let options = Options::new(most)
        .initial_indent(&first)
        .subsequent_indent(&by)
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    text.lines()
        .map(|paragraph| textwrap::fill(paragraph, &options) + "\n")
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{INDENT, remark, wrapped};

    const WIDTH: usize = 100;

    #[test]
    fn no_line_is_wider_than_a_terminal_and_no_word_is_lost() {
        let words =
            "a long explanation of what this is about, with the reason and what to do with it "
                .repeat(4);
        let words = words.trim();
        for text in [wrapped(words, [INDENT; 2], WIDTH), remark(words, WIDTH)] {
            assert!(
                text.lines().all(|line| line.chars().count() <= WIDTH) && text.lines().count() > 3,
                "{text}"
            );
            assert_eq!(text.split_whitespace().collect::<Vec<_>>().join(" "), words);
        }
        let text = remark(words, WIDTH);
        assert!(
            !text.starts_with(' ') && text.lines().skip(1).all(|line| line.starts_with("  ")),
            "{text}"
        );
        let file = "/a/folder".repeat(20);
        assert_eq!(
            remark(&format!("wrote {file} anew"), WIDTH),
            format!("wrote\n  {file}\n  anew"),
            "a file stays whole"
        );
        assert_eq!(
            remark("two\n  lines", WIDTH),
            "two\n  lines",
            "what fits stays as it is"
        );
    }
}
