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

/// A number in the shortest form from which it can be parsed exactly, without a sign of 0; empty if
/// it is not finite.
pub(super) fn number(number: f64) -> String {
    if !number.is_finite() {
        return String::new();
    }
    let mut bytes = vec![];
    push_number(&mut bytes, number);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Appends a finite number as [`number`] writes it. The text is also valid JSON.
pub(super) fn push_number(bytes: &mut Vec<u8>, number: f64) {
    // the sum turns -0 into 0; writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &(number + 0.0));
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn exact_numbers_in_their_shortest_form() {
        for (value, text) in [
            (-0.0, "0.0"),
            (5.0, "5.0"),
            (-0.1, "-0.1"),
            (7.440962633664672e-6, "7.440962633664672e-6"),
            (f64::NAN, ""),
            (f64::INFINITY, ""),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
