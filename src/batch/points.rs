use crate::error::{Error, Result};
use crate::parameters::{Parameter, Vary, first_repeated};
use crate::units::Message;

/// Source of a batch's points: rows of parameter values in a reproducible order.
pub trait Points {
    /// Parameters of each row.
    fn parameters(&self) -> &[&'static Parameter];

    /// Ranges of the values. Impossible values are ignored; a parameter whose values are all
    /// impossible is omitted.
    fn ranges(&self) -> Vec<Vary>;

    /// Number of rows.
    fn rows(&self) -> u64;

    /// Moves to a row, from which [`read`](Self::read) continues.
    ///
    /// # Errors
    /// The errors of the rows before `row`, if this source must read them to reach `row`.
    fn seek(&mut self, row: u64) -> Result<()>;

    /// Appends up to `most` rows to `values`, SI, with a value for each parameter. Returns the
    /// number of rows, which is 0 only at the end. The caller checks the number of values.
    ///
    /// # Errors
    /// [`Error::Table`] if the input cannot be read.
    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize>;

    /// Notes on the source, such as ignored columns of a table.
    fn notes(&self) -> Vec<Message> {
        vec![]
    }

    /// Identity of the points: equal texts if and only if the points are equal.
    fn identity(&self) -> String;
}

/// Refuses repeated parameters, and an empty list.
pub(crate) fn refuse_repeated(parameters: &[&'static Parameter]) -> Result<()> {
    if let Some(repeated) = first_repeated(parameters.iter().copied()) {
        return Err(Error::SearchRange {
            name: repeated.name.into(),
            reason: "it is given twice; keep one".into(),
        });
    }
    if parameters.is_empty() {
        return Err(Error::Nothing {
            doing: "sweep",
            what: "parameter",
        });
    }
    Ok(())
}
