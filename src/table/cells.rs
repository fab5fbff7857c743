//! The cells of a record of comma-separated values.

use std::borrow::Cow;

/// The cells of a record, without the spaces around them; a quoted one without its quotes.
pub(crate) fn cells(text: &str, separator: u8) -> Vec<Cow<'_, str>> {
    if !text.contains('"') {
        return text
            .split(char::from(separator))
            .map(|cell| Cow::Borrowed(cell.trim()))
            .collect();
    }
    let mut cells = vec![];
    let mut rest = text;
    loop {
        let (cell, after) = cell(rest, separator);
        cells.push(cell);
        match after {
            Some(after) => rest = after,
            None => return cells,
        }
    }
}

/// The first cell, and what follows its separator, where there is one.
fn cell(text: &str, separator: u8) -> (Cow<'_, str>, Option<&str>) {
    let up_to_separator = |text: &str| text.bytes().position(|byte| byte == separator);
    let Some(quoted) = text.trim_start_matches(' ').strip_prefix('"') else {
        let end = up_to_separator(text);
        return (
            text[..end.unwrap_or(text.len())].trim().into(),
            end.map(|end| &text[end + 1..]),
        );
    };
    let mut from = 0;
    while let Some(at) = quoted[from..].find('"').map(|at| from + at) {
        if quoted[at + 1..].starts_with('"') {
            from = at + 2;
            continue;
        }
        let (inner, after) = (&quoted[..at], &quoted[at + 1..]);
        let end = up_to_separator(after);
        // what stands between the quote and the separator belongs to the cell
        let more = after[..end.unwrap_or(after.len())].trim_end();
        let after = end.map(|end| &after[end + 1..]);
        if more.is_empty() && from == 0 {
            return (inner.trim().into(), after);
        }
        let whole = format!("{}{more}", inner.replace("\"\"", "\""));
        return (whole.trim().to_owned().into(), after);
    }
    (quoted.replace("\"\"", "\"").trim().to_owned().into(), None)
}

/// True if a quote is still open at the end, so that the record continues in the next line.
pub(super) fn is_open(text: &str, separator: u8) -> bool {
    if !text.contains('"') {
        return false;
    }
    let (mut is_quoted, mut begins, mut has_closed) = (false, true, false);
    for byte in text.bytes() {
        match byte {
            // the second of two quotes within a cell opens again
            b'"' if is_quoted || begins || has_closed => {
                (is_quoted, begins, has_closed) = (!is_quoted, false, is_quoted);
            }
            b' ' if begins => {}
            byte => (begins, has_closed) = (!is_quoted && byte == separator, false),
        }
    }
    is_quoted
}

/// A cell as it is written: in quotes where it must be.
pub(crate) fn quoted(cell: &str, separator: u8) -> Cow<'_, str> {
    match cell
        .bytes()
        .any(|byte| byte == separator || matches!(byte, b'"' | b'\n' | b'\r'))
    {
        true => format!("\"{}\"", cell.replace('"', "\"\"")).into(),
        false => cell.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{cells, is_open, quoted};

    #[test]
    fn cells_are_read_as_written() {
        for (text, expected) in [
            ("a, b ,c", &["a", "b", "c"][..]),
            ("", &[""]),
            ("a,", &["a", ""]),
            ("\"a, b\",\"c \"\"d\"\"\",e", &["a, b", "c \"d\"", "e"]),
            ("10.5\",b", &["10.5\"", "b"]),
            (" \"a\" x,b", &["a x", "b"]),
            ("\"a\nb\",c", &["a\nb", "c"]),
        ] {
            assert_eq!(cells(text, b','), expected, "{text}");
            let again = expected
                .iter()
                .map(|cell| quoted(cell, b','))
                .collect::<Vec<_>>()
                .join(",");
            assert_eq!(cells(&again, b','), expected, "{again}");
            assert!(!is_open(text, b','), "{text}");
        }
        for text in ["\"a", "a,\"b,c", "\"a\"\"", "a, \"b\"\"c"] {
            assert!(is_open(text, b','), "{text}");
        }
        assert!(
            !is_open("10.5\",b", b','),
            "a quote within a cell opens nothing"
        );
    }
}
