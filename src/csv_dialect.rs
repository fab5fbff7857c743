//! The separator of the cells of a CSV table.

/// The separator of the cells, and the text of the table. A first line such as `sep=;` states the
/// separator; the text of the table then begins after this line. Otherwise the separator is the
/// most frequent of tab, semicolon and comma in the line of column heads.
pub(crate) fn detect_separator(text: &str) -> (u8, &str) {
    let text = text.trim_start_matches('\u{feff}');
    if let Some(rest) = text.strip_prefix("sep=") {
        let (stated, rest) = rest.split_once('\n').unwrap_or((rest, ""));
        if let Some(separator) = stated.trim_end_matches('\r').bytes().next() {
            return (separator, rest);
        }
    }
    let head = text
        .lines()
        .find(|line| !line.starts_with('#') && !line.trim().is_empty())
        .unwrap_or_default();
    let count = |separator: &u8| head.bytes().filter(|byte| byte == separator).count();
    // a table of one column has no separator: all counts are 0, and `max_by_key` returns the last
    // element, the comma
    let separator = [b'\t', b';', b',']
        .into_iter()
        .max_by_key(count)
        .unwrap_or(b',');
    (separator, text)
}

#[cfg(test)]
mod tests {
    use super::detect_separator;

    #[test]
    fn the_separator_is_that_of_the_head_or_of_a_sep_line() {
        assert_eq!(detect_separator("# a, b; c\na;b;c\n").0, b';');
        assert_eq!(detect_separator("\u{feff}a\tb, c\td\n").0, b'\t');
        assert_eq!(detect_separator("a,b\n").0, b',');
        assert_eq!(detect_separator("sep=;\r\na;b\n"), (b';', "a;b\n"));
    }
}
