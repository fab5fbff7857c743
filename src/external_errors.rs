//! Messages for errors of the operating system and of the libraries that read files: the cause, and
//! advice.

/// Advice about a damaged file.
#[cfg(any(feature = "arrow", feature = "parquet"))]
pub(crate) const DAMAGED: &str = "copy it again, or write it again with the program that made it";

/// Message for an error of the Parquet reader. An error without a known cause counts as damage.
#[cfg(feature = "parquet")]
pub(crate) fn parquet_error_text(error: &parquet::errors::ParquetError) -> String {
    use parquet::errors::ParquetError;
    match error {
        ParquetError::NYI(_) => {
            "it uses a feature of Parquet that is not supported; write plain columns of numbers"
                .into()
        }
        ParquetError::External(error) => match error.downcast_ref::<std::io::Error>() {
            Some(error) if error.raw_os_error().is_some() => read_error_text(error),
            // without a code of the operating system, the error comes from a decoder
            _ => format!("it is damaged; {DAMAGED}"),
        },
        _ => format!("it is damaged or was cut short; {DAMAGED}"),
    }
}

/// Message for an error in a record batch of Arrow IPC.
#[cfg(feature = "arrow")]
pub(crate) fn arrow_error_text(error: &arrow_schema::ArrowError) -> String {
    use arrow_schema::ArrowError;
    match error {
        ArrowError::NotYetImplemented(_) => {
            "it uses a feature of Arrow that is not supported; write plain columns of numbers"
                .into()
        }
        // an I/O error without a code of the operating system comes from a decoder
        ArrowError::IoError(_, error) if error.raw_os_error().is_some() => read_error_text(error),
        ArrowError::MemoryError(_) => {
            "a record batch does not fit into memory; write smaller ones".into()
        }
        _ => format!("a record batch is damaged; {DAMAGED}"),
    }
}

/// Message for a file that is not TOML: the place, the parser's sentence, advice, and the line with
/// a mark. `place` converts a byte offset to line and column.
pub(crate) fn toml_error_text(
    error: &toml::de::Error,
    text: &str,
    place: impl Fn(usize) -> (usize, usize),
) -> String {
    const OF_VALUES: &str = "a name stands once in its table, and its value is a number, or text in quotes, as in loft = \"10.5 deg\"";
    const OF_TABLES: &str = "a table is a name in brackets, as in [club]";
    let reason = error.message().trim_end().replace('\n', ", ");
    let Some(span) = error.span() else {
        return format!("it is not valid TOML: {reason}; {OF_VALUES}");
    };
    let (line, column) = place(span.start);
    let source = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
    let advice = if source.trim_start().starts_with('[') {
        OF_TABLES
    } else {
        OF_VALUES
    };
    let mark = " ".repeat(column.saturating_sub(1));
    format!(
        "line {line}, column {column} is not valid TOML: {reason}; {advice}\n  {source}\n  {mark}^"
    )
}

/// Message for bytes that are not text in UTF-8.
pub(crate) const NOT_UTF_8: &str = "it holds bytes that are not text in UTF-8; save it as text in \
                                    UTF-8 (it may be in Windows-1252, ANSI or Latin-1)";

/// Reason why a file cannot be read. Messages of this program, inside an [`std::io::Error`], are
/// returned unchanged.
pub(crate) fn read_error_text(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let why = match error.kind() {
        // `read_to_string` reports bytes that are not UTF-8 without an inner error; the errors of
        // decoders have an inner error
        ErrorKind::InvalidData if error.get_ref().is_none() => return NOT_UTF_8.into(),
        ErrorKind::Other if error.get_ref().is_some() => return error.to_string(),
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        ErrorKind::PermissionDenied => "its permissions do not allow it".into(),
        _ => format!("the reader says: {error}"),
    };
    format!("it cannot be read ({why})")
}

/// Reason why a file cannot be written: "the disk is full". Messages of this program, inside an
/// [`std::io::Error`], are returned unchanged.
pub(crate) fn write_error_text(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let why = match error.kind() {
        _ if error.raw_os_error().is_none() && error.get_ref().is_some() => {
            return error.to_string();
        }
        ErrorKind::NotFound => "no file can be made there",
        ErrorKind::PermissionDenied => "the permissions do not allow it",
        ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "your share of the disk is used up",
        ErrorKind::IsADirectory => "it is a folder",
        ErrorKind::FileTooLarge => "it is larger than the disk or the system allows",
        _ => return format!("the system says: {error}"),
    };
    why.into()
}

/// Message for an error in a row of a CSV table. `text` is the whole table, read again to find an
/// unclosed quote, because the CSV reader counts the rows after such a quote as part of the quoted
/// cell.
pub(crate) fn csv_row_error_text(error: &csv::Error, text: impl std::io::BufRead) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
            let is_odd =
                |line: &Vec<u8>| line.iter().filter(|byte| **byte == b'"').count() % 2 == 1;
            let mut lines = text.split(b'\n').map_while(Result::ok);
            if let Some(at) = lines.position(|line| is_odd(&line)) {
                return format!(
                    "line {} opens a quote (\") and does not close it; close it, or take it out",
                    at + 1
                );
            }
            let cells = |count: u64| {
                if count == 1 {
                    "1 cell".to_owned()
                } else {
                    format!("{count} cells")
                }
            };
            format!(
                "the row has {}, but the head has {}; give every row a cell for each column",
                cells(*len),
                cells(*expected_len)
            )
        }
        csv::ErrorKind::Utf8 { .. } => {
            "it holds bytes that are not text in UTF-8; save the table as CSV in UTF-8".into()
        }
        csv::ErrorKind::Io(error) => read_error_text(error),
        _ => format!("it cannot be read as CSV (the reader says: {error})"),
    }
}

#[cfg(test)]
mod tests {
    use super::{NOT_UTF_8, csv_row_error_text, read_error_text};
    use std::io;

    #[test]
    fn invalid_data_is_not_utf_8_only_where_text_is_read() {
        let of_text = io::read_to_string(&b"\xff"[..]).unwrap_err();
        assert_eq!(read_error_text(&of_text), NOT_UTF_8);
        let of_a_decoder = io::Error::new(io::ErrorKind::InvalidData, "wrong checksum");
        assert_eq!(
            read_error_text(&of_a_decoder),
            "it cannot be read (the reader says: wrong checksum)"
        );
    }

    #[test]
    fn a_row_that_is_too_short_is_reported_in_cells_and_columns() {
        let text = "a,b,c\n1,2\n".as_bytes();
        let mut reader = csv::Reader::from_reader(text);
        let error = reader.records().next().unwrap().unwrap_err();
        let sentence = csv_row_error_text(&error, text);
        assert!(
            sentence.starts_with("the row has 2 cells, but the head has 3 cells; "),
            "{sentence}"
        );
        assert!(
            error.to_string().contains("found record"),
            "the message of the library has other words than this test expects"
        );
    }
}
