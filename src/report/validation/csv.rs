use crate::error::{Error, Result};
use crate::study::validation::SetScores;

/// Every law on every drive, as CSV: a row for each quantity of each, in SI.
///
/// # Errors
/// [`Error::Output`].
pub fn validation_csv(found: &[SetScores]) -> Result<String> {
    let failed = |error: csv::Error| Error::Output(error.into());
    let mut writer = csv::Writer::from_writer(vec![]);
    let head = [
        "set",
        "case",
        "law",
        "quantity",
        "unit",
        "computed",
        "published",
        "difference",
        "source",
    ];
    writer.write_record(head).map_err(failed)?;
    for set in found {
        for law in &set.laws {
            for score in &law.scores {
                for one in &score.residuals {
                    let case = &set.cases[one.case];
                    let numbers = [one.predicted, one.published, one.difference()]
                        .map(|number| number.to_string());
                    let words = [
                        set.set.name,
                        &case.name,
                        law.law,
                        score.of.name(),
                        score.of.unit().0.si,
                    ];
                    let row = words
                        .into_iter()
                        .chain(numbers.iter().map(String::as_str))
                        .chain([case.source.as_str()]);
                    writer.write_record(row).map_err(failed)?;
                }
            }
        }
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
