//! Decodes texts in UTF-8, UTF-16 or Windows-1252, with or without byte-order marks.

use crate::external_errors::NOT_UTF_8;
use std::io::{self, Read};

/// Byte-order mark of UTF-8.
const MARK: [u8; 3] = [0xef, 0xbb, 0xbf];

/// A line feed in UTF-16 with its two bytes swapped. Unicode does not assign this character. The
/// decoded text contains it if a byte before the line feed is missing.
const SWAPPED_LINE_END: char = '\u{a00}';

/// Bytes read at a time.
const PIECE: usize = 1 << 14;

/// Encoding of the lines. UTF-16 has been decoded to UTF-8 before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Utf8,
    /// Western-European Windows: `°` is the byte B0.
    Windows1252,
}

impl Encoding {
    /// Detects the encoding from the first bytes: Windows-1252 if they are not valid UTF-8. An
    /// incomplete last character is ignored.
    pub fn of(beginning: &[u8]) -> Self {
        match std::str::from_utf8(beginning) {
            Err(error) if error.error_len().is_some() && !beginning.contains(&0) => {
                Self::Windows1252
            }
            _ => Self::Utf8,
        }
    }

    /// Decodes a line.
    ///
    /// # Errors
    /// A message, if the bytes are invalid in this encoding.
    pub fn text(self, bytes: Vec<u8>) -> Result<String, &'static str> {
        match String::from_utf8(bytes) {
            Ok(text) => Ok(text),
            Err(_) if self == Self::Utf8 => Err(NOT_UTF_8),
            Err(error) => Ok(of_windows_1252(error.as_bytes())),
        }
    }

    /// Decodes the beginning of a text, whose last character may be incomplete.
    pub fn lossy(self, bytes: &[u8]) -> String {
        match self {
            Self::Utf8 => String::from_utf8_lossy(bytes).into_owned(),
            Self::Windows1252 => of_windows_1252(bytes),
        }
    }
}

/// The characters of Windows-1252 from 0x80 to 0x9f (encoding.spec.whatwg.org). Every other byte is
/// the code point of its character.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Decodes Windows-1252. A library for all encodings would bring 0.2 MB of tables.
fn of_windows_1252(bytes: &[u8]) -> String {
    let character = |byte: &u8| match byte {
        0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
        other => char::from(*other),
    };
    bytes.iter().map(character).collect()
}

/// A source decoded to UTF-8, without byte-order marks.
pub(crate) struct Decoded<R> {
    source: R,
    /// Combines two bytes to a code unit of UTF-16, in the byte order of the source. `None` for a
    /// source that is not in UTF-16.
    code_unit: Option<fn([u8; 2]) -> u16>,
    /// Bytes of an incomplete character.
    raw: Vec<u8>,
    /// Decoded text and the read position.
    text: Vec<u8>,
    at: usize,
}

/// Decodes a source in UTF-8 or UTF-16, with or without a byte-order mark.
///
/// # Errors
/// Errors of the source, and [`io::ErrorKind::Other`] if the text is invalid UTF-16. Later reads
/// can return the same errors.
pub(crate) fn decoded<R: Read>(mut source: R) -> io::Result<Decoded<R>> {
    // the first 7 bytes: at most two byte-order marks, and one more byte
    let mut raw = vec![];
    (&mut source)
        .take(2 * MARK.len() as u64 + 1)
        .read_to_end(&mut raw)?;
    let mut decoded = Decoded {
        source,
        // in UTF-16 without a byte-order mark, every second byte of ASCII text is 0; UTF-8 text
        // contains no 0
        code_unit: match raw.get(..4).or(raw.get(..2)) {
            Some([0xff, 0xfe, ..] | [1..=0xff, 0, 1..=0xff, 0]) => Some(u16::from_le_bytes),
            Some([0xfe, 0xff, ..] | [0, 1..=0xff, 0, 1..=0xff]) => Some(u16::from_be_bytes),
            _ => None,
        },
        raw,
        text: vec![],
        at: 0,
    };
    if decoded.code_unit.is_some() {
        decoded.decode(false)?;
    } else {
        decoded.text = std::mem::take(&mut decoded.raw);
    }
    while decoded.text[decoded.at..].starts_with(&MARK) {
        decoded.at += MARK.len();
    }
    Ok(decoded)
}

impl<R> Decoded<R> {
    /// Decodes the complete characters of the buffered bytes.
    fn decode(&mut self, is_end: bool) -> io::Result<()> {
        let Some(code_unit) = self.code_unit else {
            return Ok(());
        };
        let mut units: Vec<u16> = self
            .raw
            .chunks_exact(2)
            .map(|pair| code_unit([pair[0], pair[1]]))
            .collect();
        // a high surrogate waits for its low surrogate
        let waits = !is_end
            && units
                .last()
                .is_some_and(|unit| (0xd800..0xdc00).contains(unit));
        units.truncate(units.len() - usize::from(waits));
        self.raw.drain(..2 * units.len());
        let no_text =
            |what| io::Error::other(format!("{what}; save the file again, preferably as UTF-8"));
        let text = String::from_utf16(&units);
        let text =
            text.map_err(|_| no_text("the text is in UTF-16, with an unpaired surrogate"))?;
        if text.contains(SWAPPED_LINE_END) {
            return Err(no_text("the text is in UTF-16, and one byte is missing"));
        }
        if is_end && !self.raw.is_empty() {
            return Err(no_text(
                "the text is in UTF-16, and ends with half a character: it was cut short",
            ));
        }
        self.text.extend(text.into_bytes());
        Ok(())
    }
}

impl<R: Read> Read for Decoded<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        while self.at == self.text.len() {
            (self.text, self.at) = (vec![], 0);
            if self.code_unit.is_none() {
                return self.source.read(into);
            }
            let mut piece = [0; PIECE];
            let read = self.source.read(&mut piece)?;
            self.raw.extend_from_slice(&piece[..read]);
            let is_end = read == 0;
            self.decode(is_end)?;
            if is_end && self.text.is_empty() {
                return Ok(0);
            }
        }
        let count = into.len().min(self.text.len() - self.at);
        into[..count].copy_from_slice(&self.text[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::{Encoding, decoded};
    use std::io::{self, Read};

    fn read(source: impl Read) -> io::Result<String> {
        let mut text = String::new();
        decoded(source)?.read_to_string(&mut text)?;
        Ok(text)
    }

    /// A source that returns one byte at a time.
    struct Slow<'a>(&'a [u8]);

    impl Read for Slow<'_> {
        fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
            let count = usize::from(!self.0.is_empty() && !into.is_empty());
            into[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }

    #[test]
    fn independent_characters_of_windows_1252() {
        let bytes: Vec<u8> = (0..=255).collect();
        let (text, ..) = encoding_rs::WINDOWS_1252.decode(&bytes);
        assert_eq!(Encoding::Windows1252.lossy(&bytes), text);
    }

    #[test]
    fn same_text_in_every_encoding_and_after_every_byte_order_mark() {
        let text = "Ball Speed [mph],Spin Axis [°]\n167,3 𝄞\n".repeat(900);
        let mark = "\u{feff}";
        let with = |marks: usize| mark.repeat(marks) + &text;
        let wide = |text: &str, of: fn(u16) -> [u8; 2]| {
            text.encode_utf16().flat_map(of).collect::<Vec<u8>>()
        };
        for bytes in [
            with(0).into_bytes(),
            with(1).into_bytes(),
            with(2).into_bytes(),
            wide(&with(1), u16::to_le_bytes),
            wide(&with(2), u16::to_le_bytes),
            wide(&with(0), u16::to_le_bytes),
            wide(&with(0), u16::to_be_bytes),
            wide(&with(1), u16::to_be_bytes),
        ] {
            assert!(read(&bytes[..]).unwrap() == text && read(Slow(&bytes)).unwrap() == text);
        }
        for short in ["", "a", "ab"] {
            assert_eq!(read(short.as_bytes()).unwrap(), short);
        }
    }

    #[test]
    fn invalid_utf_16_is_refused() {
        // an incomplete character at the end; an unpaired low and high surrogate
        let [cut, second, first]: [&[u8]; 3] =
            [b"b", &[0x1e, 0xdd, b'b', 0], &[0x34, 0xd8, b'b', 0]];
        // "b", "c" and a line feed, without the second byte of "b" and of the last character
        let missing = b"bc\0\n\0d".as_slice();
        for (bytes, words) in [
            (cut, "cut"),
            (second, "unpaired"),
            (first, "unpaired"),
            (&first[..2], "unpaired"),
            (missing, "missing"),
        ] {
            let bytes = [&[0xff, 0xfe, b'a', 0], bytes].concat();
            for error in [read(&bytes[..]), read(Slow(&bytes))].map(Result::unwrap_err) {
                assert!(
                    error.kind() == io::ErrorKind::Other && error.to_string().contains(words),
                    "{error}"
                );
            }
        }
    }
}
