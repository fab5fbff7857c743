use crate::error::{Error, Result};
use crate::parameters::{Parameter, Vary};
use crate::repeated::first_repeated;
use crate::units::Message;

/// Source of the points of a batch: rows of parameter values, in the same order each time.
pub trait Points {
    /// Parameters of each row.
    fn parameters(&self) -> &[&'static Parameter];

    /// Range of the values of each parameter. Missing values, and values outside the allowed range
    /// of the parameter, are ignored. A parameter without a valid value is omitted.
    fn ranges(&self) -> Vec<Vary>;

    /// Number of rows.
    fn rows(&self) -> u64;

    /// Moves to `row`: the next call of [`read`](Self::read) begins with this row.
    ///
    /// # Errors
    /// The errors of the rows before `row`, if this source must read them to reach `row`.
    fn seek(&mut self, row: u64) -> Result<()>;

    /// Appends up to `most` rows to `values`, each with a value for each parameter, SI. Returns the
    /// number of appended rows: 0 only at the end. The caller checks the number of values.
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
    if let Some([_, again]) = first_repeated(parameters, |a, b| a == b) {
        return Err(Error::SearchRange {
            name: parameters[again].name.into(),
            reason: "it is given twice; keep one".into(),
        });
    }
    if parameters.is_empty() {
        return Err(Error::Nothing {
            doing: "sweep",
            what: "parameter, as in `over club.loft=5deg..15deg:101`",
        });
    }
    Ok(())
}
