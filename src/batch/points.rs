use crate::error::{Error, Result};
use crate::parameters::{Parameter, Vary};
use crate::units::Message;

/// Where the points of a batch come from: the values of some parameters, a row for each drive, in
/// an order that is the same every time.
pub trait Points {
    /// The parameters that have a value in each row.
    fn parameters(&self) -> &[&'static Parameter];

    /// The ranges that the values lie in. Values that no drive can have do not count; a parameter
    /// that has no others is left out.
    fn ranges(&self) -> Vec<Vary>;

    /// How many rows there are.
    fn rows(&self) -> u64;

    /// Goes to a row; [`read`](Self::read) goes on from there.
    ///
    /// # Errors
    /// What keeps the rows before it from being read.
    fn seek(&mut self, row: u64) -> Result<()>;

    /// Appends the next rows to `values`, SI, one row after the other with a value for each
    /// parameter, at most `most` of them; how many there were, 0 at the end only. Who reads them
    /// refuses other numbers of values.
    ///
    /// # Errors
    /// [`Error::Table`] for what cannot be read.
    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize>;

    /// Notes on where they come from: columns of a table that are not read.
    fn notes(&self) -> Vec<Message> {
        vec![]
    }

    /// What tells these points from any others: the same words for the same points.
    fn identity(&self) -> String;
}

/// A parameter that is given twice has two values.
pub(crate) fn refuse_repeated(parameters: &[&'static Parameter]) -> Result<()> {
    for (at, parameter) in parameters.iter().enumerate() {
        if parameters[..at].contains(parameter) {
            let reason = "it is given twice; keep one".into();
            return Err(Error::SearchRange {
                name: parameter.name.into(),
                reason,
            });
        }
    }
    if parameters.is_empty() {
        return Err(Error::Nothing {
            doing: "sweep",
            what: "parameter",
        });
    }
    Ok(())
}
