//! Splits a text of comma-separated values into records and cells.

use super::encoding::Encoding;
use super::refusal::Refusal;
use std::borrow::Cow;
use std::collections::VecDeque;
use std::io::{self, BufRead, Read};

/// Maximum length of a line, bytes.
const LONGEST: u64 = 1 << 20;

/// Maximum number of lines of a record after its first line. If a quote is still open then, the
/// message names the first line.
const MOST_LINES: usize = 32;

/// Reading ahead stops after this number of bytes.
const MOST_AHEAD: usize = 1 << 16;

/// A row of a table; or, in a stream of messages, a JSON object or other text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// Number of the record's first line, from 1.
    pub line: u64,
    /// The text.
    pub text: String,
    /// True if all quotes of the row, or all braces of the object, are closed.
    pub is_whole: bool,
}

impl Record {
    /// Refusal of this record if it has an unclosed quote.
    pub(crate) fn unclosed(&self) -> Option<Refusal> {
        let reason = || {
            format!(
                "line {} opens a quote (\") and does not close it; close it, or take it out",
                self.line
            )
        };
        (!self.is_whole).then(|| Refusal::new(Refusal::QUOTE, reason()))
    }
}

/// The lines of a text.
pub(super) struct Lines {
    source: Box<dyn BufRead + Send>,
    /// Encoding of the lines read so far.
    pub encoding: Encoding,
    /// True if all lines so far are in ASCII, which is both UTF-8 and Windows-1252.
    is_ascii: bool,
    /// Line terminator.
    end: u8,
    /// True if lines that begin with `#` are remarks, which are skipped.
    pub has_remarks: bool,
    /// Number of lines that have been read from the source.
    read: u64,
    /// Lines that were read ahead or pushed back. If reading ahead failed, the last item is the
    /// error.
    held: VecDeque<io::Result<(u64, String)>>,
}

impl Lines {
    /// The lines of a text; `beginning` is its first part.
    pub fn new(source: Box<dyn BufRead + Send>, beginning: &str, encoding: Encoding) -> Self {
        let end = if beginning.contains('\r') && !beginning.contains('\n') {
            b'\r'
        } else {
            b'\n'
        };
        Self {
            source,
            encoding,
            is_ascii: true,
            end,
            has_remarks: false,
            read: 0,
            held: VecDeque::new(),
        }
    }

    /// The next line, with its number.
    pub fn line(&mut self) -> io::Result<Option<(u64, String)>> {
        match self.held.pop_front() {
            Some(held) => held.map(Some),
            None => self.next_line(),
        }
    }

    /// Reads a line from the source.
    fn next_line(&mut self) -> io::Result<Option<(u64, String)>> {
        let mut bytes = vec![];
        let count = (&mut self.source)
            .take(LONGEST)
            .read_until(self.end, &mut bytes)?;
        self.read += 1;
        if count as u64 == LONGEST && bytes.last() != Some(&self.end) {
            return Err(io::Error::other(format!(
                "line {} is longer than 1 MiB; a line of a table must be shorter",
                self.read
            )));
        }
        while matches!(bytes.last(), Some(b'\n' | b'\r')) {
            bytes.pop();
        }
        if self.is_ascii && !bytes.is_ascii() {
            self.is_ascii = false;
            // all bytes so far are ASCII, which does not determine the encoding
            if std::str::from_utf8(&bytes).is_err() {
                self.encoding = Encoding::Windows1252;
            }
        }
        let text = self.encoding.text(bytes);
        let text = text.map_err(|why| io::Error::other(format!("line {}: {why}", self.read)))?;
        Ok((count > 0).then_some((self.read, text)))
    }

    /// Pushes a line back to the front of the input.
    pub fn give_back(&mut self, line: (u64, String)) {
        self.held.push_front(Ok(line));
    }

    /// Reads ahead up to `most` lines, or fewer if they have [`MOST_AHEAD`] bytes or if the source
    /// has an error. [`line`](Self::line) returns these lines again.
    pub fn ahead(&mut self, most: usize) -> impl Iterator<Item = &str> {
        let mut bytes: usize = self.held.iter().flatten().map(|line| line.1.len()).sum();
        while self.held.len() < most && bytes < MOST_AHEAD {
            match self.next_line().transpose() {
                None => break,
                Some(line) => {
                    bytes += line.as_ref().map_or(MOST_AHEAD, |line| line.1.len());
                    self.held.push_back(line);
                }
            }
        }
        self.held.iter().flatten().map(|line| line.1.as_str())
    }

    /// The next line other than blank lines, remarks and a separator declaration (`sep=;`).
    pub fn text_line(&mut self) -> io::Result<Option<(u64, String)>> {
        loop {
            let Some((line, text)) = self.line()? else {
                return Ok(None);
            };
            let words = text.trim_start_matches('\u{feff}');
            let is_none = words.trim().is_empty()
                || self.has_remarks && words.starts_with('#')
                || line == 1 && words.starts_with("sep=");
            if !is_none {
                return Ok(Some((line, text)));
            }
        }
    }

    /// The next record.
    pub fn record(&mut self, separator: u8) -> io::Result<Option<Record>> {
        let Some((line, mut text)) = self.text_line()? else {
            return Ok(None);
        };
        if !is_open(&text, separator) {
            return Ok(Some(Record {
                line,
                text,
                is_whole: true,
            }));
        }
        let first = text.clone();
        let mut more = vec![];
        while more.len() < MOST_LINES {
            let Some(next) = self.line()? else { break };
            text = format!("{text}\n{}", next.1);
            more.push(next);
            if !is_open(&text, separator) {
                return Ok(Some(Record {
                    line,
                    text,
                    is_whole: true,
                }));
            }
        }
        more.into_iter().rev().for_each(|line| self.give_back(line));
        Ok(Some(Record {
            line,
            text: first,
            is_whole: false,
        }))
    }
}

/// Splits a record into cells, without surrounding spaces and quotes.
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

/// The first cell, and the text after its separator.
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
        // text between the closing quote and the separator belongs to the cell
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
            // a doubled quote counts as closing the cell and opening it again
            b'"' if is_quoted || begins || has_closed => {
                (is_quoted, begins, has_closed) = (!is_quoted, false, is_quoted);
            }
            b' ' if begins => {}
            byte => (begins, has_closed) = (!is_quoted && byte == separator, false),
        }
    }
    is_quoted
}

/// The only filled cell of a record, with its index; `None` if it has none or several.
pub(super) fn only_cell<S: AsRef<str>>(row: &[S]) -> Option<(usize, &str)> {
    let cells = row.iter().map(AsRef::as_ref).enumerate();
    let mut filled = cells.filter(|(_, cell)| !cell.is_empty());
    let only = filled.next()?;
    filled.next().is_none().then_some(only)
}

/// Quotes a cell if necessary.
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
    use super::{Encoding, Lines};
    use super::{cells, is_open, quoted};

    #[test]
    fn an_unclosed_quote_affects_no_other_row() {
        let rows = |text: &'static str| {
            let mut lines = Lines::new(Box::new(text.as_bytes()), text, Encoding::Utf8);
            lines.has_remarks = true;
            std::iter::from_fn(|| lines.record(b',').unwrap())
                .map(|record| (record.line, record.text, !record.is_whole))
                .collect::<Vec<_>>()
        };
        let row = |line, text: &str, is_open| (line, text.to_owned(), is_open);
        assert_eq!(
            rows("a,b\r\n\n# c\n\"d\ne\",f\ng"),
            [
                row(1, "a,b", false),
                row(4, "\"d\ne\",f", false),
                row(6, "g", false)
            ]
        );
        assert_eq!(
            rows("1,\"a\n2,b\n3,c\n"),
            [
                row(1, "1,\"a", true),
                row(2, "2,b", false),
                row(3, "3,c", false)
            ]
        );
        assert_eq!(
            rows("1,a\r2,b\r"),
            [row(1, "1,a", false), row(2, "2,b", false)]
        );
    }

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
