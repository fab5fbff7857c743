//! Errors of the libraries that read files, in longdrive's words: what is wrong there, and what to do.

/// What is wrong with a file of comma-separated values.
pub(crate) fn of_csv(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            let cells = |count: u64| if count == 1 { "1 cell".to_owned() } else { format!("{count} cells") };
            format!(
                "the row has {}, but the head has {}; give every row a cell for each column",
                cells(*len),
                cells(*expected_len)
            )
        }
        csv::ErrorKind::Utf8 { .. } => {
            "it holds bytes that are not text in UTF-8; save the table as CSV in UTF-8".into()
        }
        csv::ErrorKind::Io(error) => format!("it cannot be read ({error})"),
        _ => format!("it cannot be read as CSV ({error})"),
    }
}

/// What to do about a file that is damaged.
#[cfg(any(feature = "arrow", feature = "parquet"))]
pub(crate) const DAMAGED: &str = "copy it again, or have the program that wrote it write it anew";

/// What is wrong with a Parquet file, whose first and last bytes are those of one.
#[cfg(feature = "parquet")]
pub(crate) fn of_parquet(error: &parquet::errors::ParquetError) -> String {
    use parquet::errors::ParquetError;
    match error {
        ParquetError::NYI(_) => {
            "it uses a part of Parquet that is not read here; write plain columns of numbers".into()
        }
        ParquetError::External(error) => match error.downcast_ref::<std::io::Error>() {
            Some(error) if error.raw_os_error().is_some() => format!("it cannot be read ({error})"),
            // of a decoder
            _ => format!("it is damaged; {DAMAGED}"),
        },
        _ => format!("it is damaged or was cut short; {DAMAGED}"),
    }
}

/// What is wrong with a record batch of Arrow IPC.
#[cfg(feature = "arrow")]
pub(crate) fn of_arrow(error: &arrow_schema::ArrowError) -> String {
    use arrow_schema::ArrowError;
    match error {
        ArrowError::NotYetImplemented(_) => {
            "it uses a part of Arrow that is not read here; write plain columns of numbers".into()
        }
        // others are of a decoder
        ArrowError::IoError(_, error) if error.raw_os_error().is_some() => format!("it cannot be read ({error})"),
        ArrowError::MemoryError(_) => "there is no memory for it; write smaller record batches".into(),
        _ => format!("a record batch is damaged; {DAMAGED}"),
    }
}

/// What is wrong with a setup file that is not TOML, with the line where it is; `place` finds line and column.
pub(crate) fn of_toml(error: &toml::de::Error, text: &str, place: impl Fn(usize) -> (usize, usize)) -> String {
    let what = error.message().trim_end().replace('\n', ", ");
    let Some(span) = error.span() else { return format!("it is not valid TOML: {what}") };
    let (line, column) = place(span.start);
    let there = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
    let mark = " ".repeat(column.saturating_sub(1));
    format!("line {line}, column {column} is not valid TOML: {what}\n  {there}\n  {mark}^")
}

#[cfg(test)]
mod tests {
    use super::of_csv;

    #[test]
    fn a_row_that_is_too_short_is_told_in_cells_and_columns() {
        let mut reader = csv::Reader::from_reader("a,b,c\n1,2\n".as_bytes());
        let error = reader.records().next().unwrap().unwrap_err();
        let told = of_csv(&error);
        assert!(told.starts_with("the row has 2 cells, but the head has 3 cells; "), "{told}");
        assert!(error.to_string().contains("found record"), "what the library says is not what is told");
    }
}
