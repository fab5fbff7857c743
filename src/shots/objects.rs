//! Finds JSON objects in a byte stream: one per line, consecutive, or in an array.

use crate::table::Record;
use std::collections::VecDeque;

/// Maximum length of an object, bytes.
const LONGEST: usize = 1 << 16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ScannerState {
    Between,
    /// Within an object, with the number of open braces and brackets.
    Inside(usize),
    /// Within a string of an object: the number of open braces and brackets, and a flag that is
    /// true after a backslash.
    Text(usize, bool),
    /// In text outside of objects, until the end of the line.
    OutsideText,
    /// In the rest of an object that is too long.
    TooLong,
}

/// Finds JSON objects in bytes as the bytes arrive. Truncated objects and text outside of objects
/// are records too, so that each can be refused. Text outside of objects ends with its line, or
/// before the next opening brace. A truncated object ends before a line that begins with a brace,
/// or at a line end within a string. These rules let the scanner find the objects after the fault.
#[derive(Clone, Debug)]
pub struct Objects {
    state: ScannerState,
    line: u64,
    is_line_start: bool,
    begun: u64,
    bytes: Vec<u8>,
    found: VecDeque<Record>,
}

impl Default for Objects {
    fn default() -> Self {
        let state = ScannerState::Between;
        Self {
            state,
            line: 1,
            is_line_start: true,
            begun: 1,
            bytes: vec![],
            found: VecDeque::new(),
        }
    }
}

impl Objects {
    /// Adds bytes.
    pub fn push(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.take(byte);
            self.is_line_start = byte == b'\n';
            self.line += u64::from(byte == b'\n');
        }
    }

    /// The next record: an object, a truncated object or text outside of objects. `None` if no
    /// further record is complete.
    pub fn next_record(&mut self) -> Option<Record> {
        self.found.pop_front()
    }

    /// True if the bytes so far end within an object or within other text.
    pub fn is_incomplete(&self) -> bool {
        self.state != ScannerState::Between
    }

    /// Makes a record of an unfinished object or text at the end of the input.
    pub fn finish(&mut self) {
        match self.state {
            ScannerState::Between => {}
            // the record of the object was made when the object became too long
            ScannerState::TooLong => self.state = ScannerState::Between,
            _ => self.end(false),
        }
    }

    fn begin(&mut self, state: ScannerState, byte: u8) {
        (self.state, self.begun) = (state, self.line);
        self.bytes = vec![byte];
    }

    fn end(&mut self, is_whole: bool) {
        let text = String::from_utf8_lossy(&std::mem::take(&mut self.bytes))
            .trim_end()
            .to_owned();
        self.found.push_back(Record {
            line: self.begun,
            text,
            is_whole,
        });
        self.state = ScannerState::Between;
    }

    fn take(&mut self, byte: u8) {
        match self.state {
            ScannerState::Between => match byte {
                b'{' => self.begin(ScannerState::Inside(1), byte),
                // array syntax, separators, and bytes of a byte-order mark
                b'[' | b']' | b',' | 0 | 0xef | 0xbb | 0xbf => {}
                _ if byte.is_ascii_whitespace() => {}
                _ => self.begin(ScannerState::OutsideText, byte),
            },
            ScannerState::OutsideText => match byte {
                b'\n' => self.end(false),
                b'{' => {
                    self.end(false);
                    self.begin(ScannerState::Inside(1), byte);
                }
                _ => self.add(byte),
            },
            ScannerState::TooLong => {
                if byte == b'\n' {
                    self.state = ScannerState::Between;
                } else if byte == b'{' && self.is_line_start {
                    self.begin(ScannerState::Inside(1), byte);
                }
            }
            ScannerState::Inside(_) if byte == b'{' && self.is_line_start => {
                self.end(false);
                self.begin(ScannerState::Inside(1), byte);
            }
            ScannerState::Inside(depth) => {
                self.add(byte);
                if self.state == ScannerState::TooLong {
                    return;
                }
                match byte {
                    b'"' => self.state = ScannerState::Text(depth, false),
                    b'{' | b'[' => self.state = ScannerState::Inside(depth + 1),
                    b'}' | b']' if depth == 1 => self.end(true),
                    b'}' | b']' => self.state = ScannerState::Inside(depth - 1),
                    _ => {}
                }
            }
            // a JSON string cannot contain a line feed
            ScannerState::Text(..) if byte == b'\n' => self.end(false),
            ScannerState::Text(depth, is_escaped) => {
                self.add(byte);
                if self.state == ScannerState::TooLong {
                    return;
                }
                self.state = match byte {
                    b'"' if !is_escaped => ScannerState::Inside(depth),
                    _ => ScannerState::Text(depth, byte == b'\\' && !is_escaped),
                };
            }
        }
    }

    fn add(&mut self, byte: u8) {
        self.bytes.push(byte);
        if self.bytes.len() > LONGEST {
            self.end(false);
            self.state = ScannerState::TooLong;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, Objects};

    fn pieces(text: &str) -> Vec<(u64, String, bool)> {
        let mut objects = Objects::default();
        // chunks of 3 bytes split objects and characters
        for bytes in text.as_bytes().chunks(3) {
            objects.push(bytes);
        }
        objects.finish();
        std::iter::from_fn(|| objects.next_record())
            .map(|piece| (piece.line, piece.text, piece.is_whole))
            .collect()
    }

    #[test]
    fn objects_are_found_in_lines_arrays_and_sequences() {
        let (a, b) = (r#"{"a": {"b": "}\"{"}, "c": [1, 2]}"#, r#"{"d": 2}"#);
        let whole = |line, text: &str| (line, text.to_owned(), true);
        for text in [
            format!("{a}{b}"),
            format!("[{a}, {b}]"),
            format!("\u{feff}{a}\0 {b}"),
        ] {
            assert_eq!(pieces(&text), [whole(1, a), whole(1, b)], "{text}");
        }
        assert_eq!(
            pieces(&format!("[\n  {a},\r\n  {b}\n]\n")),
            [whole(2, a), whole(3, b)]
        );
        let pretty = "{\n  \"a\": {\n    \"b\": 1\n  }\n}";
        assert_eq!(
            pieces(&format!("{pretty}\n{b}")),
            [whole(1, pretty), whole(6, b)]
        );
    }

    #[test]
    fn truncated_or_wrong_objects_do_not_affect_others() {
        let broken = |line, text: &str| (line, text.to_owned(), false);
        let whole = |line, text: &str| (line, text.to_owned(), true);
        for (text, expected) in [
            (
                "{\"a\": {\n{\"b\": 1}\n",
                vec![broken(1, "{\"a\": {"), whole(2, "{\"b\": 1}")],
            ),
            (
                "{\"a\": \"x\n{\"b\": 1}",
                vec![broken(1, "{\"a\": \"x"), whole(2, "{\"b\": 1}")],
            ),
            (
                "hello\n{\"b\": 1}",
                vec![broken(1, "hello"), whole(2, "{\"b\": 1}")],
            ),
            ("x{\"b\": 1}", vec![broken(1, "x"), whole(1, "{\"b\": 1}")]),
            ("{\"b\": 1", vec![broken(1, "{\"b\": 1")]),
            ("  \n", vec![]),
        ] {
            assert_eq!(pieces(text), expected, "{text}");
        }
        let long = format!("{{\"a\": \"{}\"}}", "x".repeat(LONGEST));
        let found = pieces(&format!("{long}\n{{\"b\": 1}}"));
        assert_eq!(
            (found.len(), found[0].2, &found[1]),
            (2, false, &whole(2, "{\"b\": 1}"))
        );
        for at_the_end in [long.clone(), long + "\n"] {
            assert_eq!(pieces(&at_the_end).len(), 1);
        }
    }
}
