//! Errors of the libraries that read files, in longdrive's words: what is wrong there, and what to
//! do.

/// What is wrong with a file of comma-separated values.
pub(crate) fn csv_error_text(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
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

/// What to do about a file that is damaged.
#[cfg(any(feature = "arrow", feature = "parquet"))]
pub(crate) const DAMAGED: &str = "copy it again, or write it again with the program that made it";

/// What is wrong with a Parquet file, whose first and last bytes are those of one.
#[cfg(feature = "parquet")]
pub(crate) fn parquet_error_text(error: &parquet::errors::ParquetError) -> String {
    use parquet::errors::ParquetError;
    match error {
        ParquetError::NYI(_) => {
            "it uses a part of Parquet that is not read here; write plain columns of numbers".into()
        }
        ParquetError::External(error) => match error.downcast_ref::<std::io::Error>() {
            Some(error) if error.raw_os_error().is_some() => read_error_text(error),
            // of a decoder
            _ => format!("it is damaged; {DAMAGED}"),
        },
        _ => format!("it is damaged or was cut short; {DAMAGED}"),
    }
}

/// What is wrong with a record batch of Arrow IPC.
#[cfg(feature = "arrow")]
pub(crate) fn arrow_error_text(error: &arrow_schema::ArrowError) -> String {
    use arrow_schema::ArrowError;
    match error {
        ArrowError::NotYetImplemented(_) => {
            "it uses a part of Arrow that is not read here; write plain columns of numbers".into()
        }
        // others are of a decoder
        ArrowError::IoError(_, error) if error.raw_os_error().is_some() => read_error_text(error),
        ArrowError::MemoryError(_) => {
            "there is no memory for it; write smaller record batches".into()
        }
        _ => format!("a record batch is damaged; {DAMAGED}"),
    }
}

/// What is wrong with a setup file that is not TOML, with the line where it is; `place` finds line
/// and column.
pub(crate) fn toml_error_text(
    error: &toml::de::Error,
    text: &str,
    place: impl Fn(usize) -> (usize, usize),
) -> String {
    let said = error.message().trim_end().replace('\n', ", ");
    let what =
        in_own_words(&said).map_or_else(|| format!("the reader says: {said}"), str::to_owned);
    let Some(span) = error.span() else {
        return format!("it is not valid TOML: {what}");
    };
    let (line, column) = place(span.start);
    let there = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
    let mark = " ".repeat(column.saturating_sub(1));
    format!("line {line}, column {column} is not valid TOML: {what}\n  {there}\n  {mark}^")
}

/// The most common mistakes in TOML: how the reader's message begins, what is wrong, and what to
/// do.
const OF_TOML: [(&str, &str); 22] = [
    (
        "duplicate key",
        "this key or table is given twice; keep one",
    ),
    ("string values must be quoted", NOT_QUOTED),
    ("invalid float", NOT_QUOTED),
    ("invalid integer", NOT_QUOTED),
    ("invalid boolean", NOT_QUOTED),
    (
        "unexpected leading zero",
        "a number must not begin with 0; take the zero out",
    ),
    (
        "`_` may only go between digits",
        "'_' may stand between digits only; take it out",
    ),
    (
        "invalid basic string, expected `\"`",
        "the string does not end; close it with \" on its line",
    ),
    (
        "invalid literal string, expected `'`",
        "the string does not end; close it with ' on its line",
    ),
    (
        "invalid multi-line basic string, expected `\"`",
        "the string does not end; close it with \"\"\"",
    ),
    (
        "invalid multi-line literal string, expected `'`",
        "the string does not end; close it with '''",
    ),
    (
        "missing escaped value",
        "a backslash in \"…\" begins an escape; write the backslash twice, or the string in '…'",
    ),
    (
        "unclosed table",
        "the head of the table does not end; close it with ], as in [club]",
    ),
    (
        "unclosed array table",
        "the head of the table does not end; write it as [club]",
    ),
    ("unclosed array", "the list does not end; close it with ]"),
    (
        "unclosed inline table",
        "the table in braces does not end; close it with }",
    ),
    (
        "key with no value",
        "a key needs '=' and a value after it, as in loft = \"10.5 deg\"",
    ),
    ("extra `=`", "there is one '=' too many; take it out"),
    (
        "unexpected key or value",
        "a line holds one setting; begin a new line here",
    ),
    (
        "unquoted keys cannot be empty",
        "the name is missing; write for example [club] or loft = \"10.5 deg\"",
    ),
    (
        "invalid key-value pair",
        "a setting begins with its name, as in loft = \"10.5 deg\"",
    ),
    (
        "invalid unquoted key",
        "a name has letters, digits, '-' and '_' only, as in attack_angle = \"3 deg\"",
    ),
];

/// What a value is where it is not a number alone.
const NOT_QUOTED: &str = "a value is a number, or text in quotes where it has a unit or is a name, \
                          as in loft = \"10.5 deg\" or preset = \"mae494\"";

fn in_own_words(said: &str) -> Option<&'static str> {
    OF_TOML
        .iter()
        .find(|(begins, _)| said.starts_with(begins))
        .map(|(_, what)| *what)
}

/// What is said of bytes that are no text.
pub(crate) const NOT_UTF_8: &str = "it holds bytes that are not text in UTF-8; save it as text in \
                                    UTF-8 (it may be in Windows-1252, ANSI or Latin-1)";

/// Why a file cannot be read. What this program says itself stays as it is.
pub(crate) fn read_error_text(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let why = match error.kind() {
        ErrorKind::InvalidData => return NOT_UTF_8.into(),
        ErrorKind::Other if error.get_ref().is_some() => return error.to_string(),
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        ErrorKind::PermissionDenied => "its permissions do not allow it".into(),
        _ => format!("the reader says: {error}"),
    };
    format!("it cannot be read ({why})")
}

/// Why a file cannot be written. What this program says itself stays as it is.
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

/// The number of the first line in which a quote is opened and not closed.
pub(crate) fn unclosed_quote(text: impl std::io::BufRead) -> Option<usize> {
    let is_odd = |line: &Vec<u8>| line.iter().filter(|byte| **byte == b'"').count() % 2 == 1;
    text.split(b'\n')
        .map_while(Result::ok)
        .position(|line| is_odd(&line))
        .map(|at| at + 1)
}

/// What is wrong with a row of a CSV table, `text` anew: a quote that is not closed takes the rows
/// after it in.
pub(crate) fn csv_row_error_text(error: &csv::Error, text: impl std::io::BufRead) -> String {
    match (error.kind(), unclosed_quote(text)) {
        (csv::ErrorKind::UnequalLengths { .. }, Some(line)) => {
            format!(
                "line {line} opens a quote (\") and does not close it; close it, or take it out"
            )
        }
        _ => csv_error_text(error),
    }
}

#[cfg(test)]
mod tests {
    use super::csv_error_text;

    #[test]
    fn a_row_that_is_too_short_is_reported_in_cells_and_columns() {
        let mut reader = csv::Reader::from_reader("a,b,c\n1,2\n".as_bytes());
        let error = reader.records().next().unwrap().unwrap_err();
        let told = csv_error_text(&error);
        assert!(
            told.starts_with("the row has 2 cells, but the head has 3 cells; "),
            "{told}"
        );
        assert!(
            error.to_string().contains("found record"),
            "what the library says is not what is told"
        );
    }
}
