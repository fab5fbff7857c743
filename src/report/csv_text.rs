use crate::error::{Error, Result};

/// A table as CSV.
///
/// # Errors
/// [`Error::Output`] if a row has more or fewer cells than the head.
pub(super) fn csv_text(
    head: Vec<String>,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<String> {
    let mut writer = csv::Writer::from_writer(vec![]);
    for record in std::iter::once(head).chain(rows) {
        let written = writer.write_record(record);
        written.map_err(|error| Error::Output(error.into()))?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
