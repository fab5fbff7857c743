//! The records of a text of comma-separated values, one after the other.

use super::cells::is_open;
use super::encoding::Encoding;
use super::refusal::Refusal;
use std::collections::VecDeque;
use std::io::{self, BufRead, Read};

/// The longest line, in bytes.
const LONGEST: u64 = 1 << 20;

/// A record goes on over at most so many lines: a quote that is still open then is a mistake in the
/// first.
const MOST_LINES: usize = 32;

/// A record.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    /// The line that it begins in, from 1.
    pub line: u64,
    pub text: String,
    /// A quote is not closed.
    pub is_open: bool,
}

impl Record {
    /// Refusal of a record with an unclosed quote.
    pub(crate) fn unclosed(&self) -> Option<Refusal> {
        let reason = || {
            format!(
                "line {} opens a quote (\") and does not close it; close it, or take it out",
                self.line
            )
        };
        self.is_open.then(|| Refusal::new(Refusal::QUOTE, reason()))
    }
}

/// The lines of a text.
pub(super) struct Lines {
    source: Box<dyn BufRead + Send>,
    encoding: Encoding,
    /// Line terminator.
    end: u8,
    /// Lines that have been read from the source.
    read: u64,
    /// Lines that were looked at and given back.
    held: VecDeque<(u64, String)>,
}

impl Lines {
    /// The lines of a text that begins like this.
    pub fn new(source: Box<dyn BufRead + Send>, beginning: &str, encoding: Encoding) -> Self {
        let end = if beginning.contains('\r') && !beginning.contains('\n') {
            b'\r'
        } else {
            b'\n'
        };
        Self {
            source,
            encoding,
            end,
            read: 0,
            held: VecDeque::new(),
        }
    }

    /// The next line, with its number.
    pub fn line(&mut self) -> io::Result<Option<(u64, String)>> {
        if let Some(held) = self.held.pop_front() {
            return Ok(Some(held));
        }
        let mut bytes = vec![];
        let count = (&mut self.source)
            .take(LONGEST)
            .read_until(self.end, &mut bytes)?;
        self.read += 1;
        if count as u64 == LONGEST && bytes.last() != Some(&self.end) {
            return Err(io::Error::other(format!(
                "line {} is longer than 1 MiB; a table has shorter ones",
                self.read
            )));
        }
        while matches!(bytes.last(), Some(b'\n' | b'\r')) {
            bytes.pop();
        }
        let text = self.encoding.text(bytes);
        let text = text.map_err(|why| io::Error::other(format!("line {}: {why}", self.read)))?;
        Ok((count > 0).then_some((self.read, text)))
    }

    /// Gives a line back: it is the next one again.
    pub fn give_back(&mut self, line: (u64, String)) {
        self.held.push_front(line);
    }

    /// Pushes a record back to the front of the input.
    pub fn give_back_record(&mut self, record: Record) {
        self.give_back((record.line, record.text));
    }

    /// The next line other than blank lines, comments (`#`) and a separator declaration (`sep=;`).
    pub fn text_line(&mut self) -> io::Result<Option<(u64, String)>> {
        loop {
            let Some((line, text)) = self.line()? else {
                return Ok(None);
            };
            let words = text.trim_start_matches('\u{feff}');
            let is_none = words.trim().is_empty()
                || words.starts_with('#')
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
                is_open: false,
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
                    is_open: false,
                }));
            }
        }
        more.into_iter().rev().for_each(|line| self.give_back(line));
        Ok(Some(Record {
            line,
            text: first,
            is_open: true,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::{Encoding, Lines};

    #[test]
    fn an_unclosed_quote_affects_no_other_row() {
        let rows = |text: &'static str| {
            let mut lines = Lines::new(Box::new(text.as_bytes()), text, Encoding::Utf8);
            std::iter::from_fn(|| lines.record(b',').unwrap())
                .map(|record| (record.line, record.text, record.is_open))
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
}
