//! The columns that every table of points has, whatever its format.

use crate::batch::points::refuse_repeated;
use crate::columns::{CONDITIONS, Column, Head, Holds};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use std::path::Path;

pub(super) fn refused(path: &Path, place: String, reason: impl Into<String>) -> Error {
    Error::Table { file: path.display().to_string(), place, reason: reason.into() }
}

/// The columns of a table that drives are computed from.
#[derive(Debug)]
pub(super) struct Columns {
    /// Their places in the table, from 0.
    pub at: Vec<usize>,
    pub parameters: Vec<&'static Parameter>,
}

impl Columns {
    /// The columns of parameters and, where the table has no club, of launch conditions.
    pub fn new(setup: &Setup<f64>, path: &Path, head: &Head) -> Result<Self> {
        let is_struck = head.has_strike();
        let parameter = |column: &Column| match column.holds {
            Holds::Input(parameter) => Some(parameter),
            Holds::Outcome(outcome) if !is_struck && CONDITIONS.contains(&outcome) => {
                setup.launch_condition(outcome.name())
            }
            _ => None,
        };
        let read = head.columns.iter().enumerate().filter_map(|(at, column)| Some((at, parameter(column)?)));
        let (at, parameters): (Vec<_>, Vec<_>) = read.unzip();
        if let (true, [_, ..]) = (at.is_empty(), &head.columns[..]) {
            let heads = head.named(|_| true).0.join(", ");
            let reason = format!(
                "none of its columns is a parameter or a launch condition ({heads}); add one, such as 'club.loft [deg]'"
            );
            return Err(refused(path, String::new(), reason));
        }
        Ok(Self { at, parameters })
    }

    /// The columns that are not read, but for those of which the head itself says so.
    pub fn not_read(&self, head: &Head) -> Option<Message> {
        let is_read = |column: &Column| self.at.iter().any(|at| std::ptr::eq(&head.columns[*at], column));
        let not_read = head.named(|column| !is_read(column) && (column.holds != Holds::Note || !head.format.is_export));
        let of = if head.has_strike() && !head.format.is_export { "parameters of the club" } else { "parameters" };
        not_read.told(&format!("columns not read, since they are results or remarks and not {of}"))
    }
}

/// The columns of a table that is in SI throughout, by their names, and what deserves a word.
#[cfg(any(feature = "arrow", feature = "parquet"))]
pub(super) fn columns_in_si(setup: &Setup<f64>, path: &Path, names: &[String]) -> Result<(Columns, Vec<Message>)> {
    let head = Head::in_si(setup, names)
        .map_err(|(at, error)| refused(path, format!(", column {}", at + 1), error.to_string()))?;
    let columns = Columns::new(setup, path, &head)?;
    refuse_columns(path, &columns.parameters)?;
    let notes = columns.not_read(&head).into_iter().collect();
    Ok((columns, notes))
}

/// What is wrong with a value that is missing or that may not stand in a column.
#[cfg(any(feature = "arrow", feature = "parquet"))]
pub(super) fn wrong_value(parameter: &Parameter, value: Option<f64>) -> Option<String> {
    match value {
        None => Some("a value is missing; every row needs one".into()),
        Some(value) if !is_value(parameter, value) => {
            let what = if value.is_nan() { "not a number" } else { "not finite" };
            Some(format!("{value} is {what}; every row needs a finite number"))
        }
        Some(_) => None,
    }
}

#[cfg(any(feature = "arrow", feature = "parquet"))]
/// Whether a value may stand in a column: NaN never, an infinite one only where the parameter may be that (a flat face).
fn is_value(parameter: &Parameter, value: f64) -> bool {
    value.is_finite() || parameter.range.contains(value)
}

/// Refuses a column given twice, and a table without any.
pub(super) fn refuse_columns(path: &Path, parameters: &[&'static Parameter]) -> Result<()> {
    refuse_repeated(parameters).map_err(|_| {
        let twice = parameters.iter().enumerate().find(|(at, parameter)| parameters[..*at].contains(parameter));
        let reason = twice.map_or("it has no columns".into(), |(_, twice)| {
            format!("the parameter {} has two columns; keep one", twice.name)
        });
        refused(path, String::new(), reason)
    })
}
