//! Points that stand in a table: one column for each parameter, one row for each drive.

#[cfg(feature = "arrow")]
mod arrow;
mod csv;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "arrow")]
mod record_batches;

#[cfg(feature = "arrow")]
pub use arrow::ArrowTable;
pub use csv::CsvTable;
#[cfg(feature = "parquet")]
pub use parquet::ParquetTable;

use super::points::Points;
use crate::columns::{CONDITIONS, Column, Head, Holds};
use crate::error::{Error, Result};
#[cfg(not(all(feature = "arrow", feature = "parquet")))]
use crate::features::how_to_get;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use std::path::Path;

/// The table in a file, by the ending of its name: CSV (`.csv`), Parquet (`.parquet`), or Arrow IPC (`.arrow`, `.arrows`,
/// `.feather`; a file or a stream, whichever its first bytes say).
///
/// # Errors
/// [`Error::Table`] for a file that cannot be read, a name without a known ending, and everything the tables refuse.
pub fn open_table(setup: &Setup<f64>, path: &Path) -> Result<Box<dyn Points>> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_lowercase();
    match ending.as_str() {
        "csv" => Ok(Box::new(CsvTable::open(setup, path)?)),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(Box::new(ParquetTable::open(setup, path)?)),
        #[cfg(feature = "arrow")]
        "arrow" | "arrows" | "feather" => Ok(Box::new(ArrowTable::open(setup, path)?)),
        #[cfg(not(feature = "parquet"))]
        "parquet" => Err(refused(path, String::new(), how_to_get("parquet"))),
        #[cfg(not(feature = "arrow"))]
        "arrow" | "arrows" | "feather" => Err(refused(path, String::new(), how_to_get("arrow"))),
        _ => {
            Err(refused(path, String::new(), "a table's name must end in .csv, .parquet, .arrow, .arrows or .feather"))
        }
    }
}

fn refused(path: &Path, place: String, reason: impl Into<String>) -> Error {
    Error::Table { file: path.display().to_string(), place, reason: reason.into() }
}

/// The columns of a table that drives are computed from.
#[derive(Debug)]
struct Columns {
    /// Their places in the table, from 0.
    at: Vec<usize>,
    parameters: Vec<&'static Parameter>,
}

impl Columns {
    /// The columns of parameters and, where the table has no club, of launch conditions.
    fn new(setup: &Setup<f64>, path: &Path, head: &Head) -> Result<Self> {
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
    fn not_read(&self, head: &Head) -> Option<Message> {
        let is_read = |column: &Column| self.at.iter().any(|at| std::ptr::eq(&head.columns[*at], column));
        let not_read = head.named(|column| !is_read(column) && (column.holds != Holds::Note || !head.format.is_export));
        let of = if head.has_strike() && !head.format.is_export { "parameters of the club" } else { "parameters" };
        not_read.told(&format!("columns not read, since they are results or remarks and not {of}"))
    }
}

/// The columns of a table that is in SI throughout, by their names, and what deserves a word.
#[cfg(any(feature = "arrow", feature = "parquet"))]
fn columns_in_si(setup: &Setup<f64>, path: &Path, names: &[String]) -> Result<(Columns, Vec<Message>)> {
    let head = Head::in_si(setup, names)
        .map_err(|(at, error)| refused(path, format!(", column {}", at + 1), error.to_string()))?;
    let columns = Columns::new(setup, path, &head)?;
    refuse_columns(path, &columns.parameters)?;
    let notes = columns.not_read(&head).into_iter().collect();
    Ok((columns, notes))
}

/// What is wrong with a value that is missing or that may not stand in a column.
#[cfg(any(feature = "arrow", feature = "parquet"))]
fn wrong_value(parameter: &Parameter, value: Option<f64>) -> Option<String> {
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
fn refuse_columns(path: &Path, parameters: &[&'static Parameter]) -> Result<()> {
    super::points::refuse_repeated(parameters).map_err(|_| {
        let twice = parameters.iter().enumerate().find(|(at, parameter)| parameters[..*at].contains(parameter));
        let reason = twice.map_or("it has no columns".into(), |(_, twice)| {
            format!("the parameter {} has two columns; keep one", twice.name)
        });
        refused(path, String::new(), reason)
    })
}

/// A fingerprint of bytes that come piece by piece (FNV-1a, 64 bits): tells a table from another, not from a forgery.
#[derive(Debug)]
struct Fingerprint(u64);

impl Fingerprint {
    const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Reads a table from where it stands to its end: how many rows there are, and the fingerprint of their values.
    fn of(table: &mut impl Points) -> Result<(u64, Self)> {
        let mut fingerprint = Self::new();
        let (mut rows, mut values) = (0, vec![]);
        loop {
            match table.read(super::CHUNK, &mut values)? {
                0 => return Ok((rows, fingerprint)),
                more => rows += more as u64,
            }
            for value in values.drain(..) {
                fingerprint.add(&value.to_bits().to_le_bytes());
            }
        }
    }

    /// What tells a table from any other: the same words for the same rows, whatever format they are in.
    fn identity(&self, table: &impl Points) -> String {
        let names: Vec<_> = table.parameters().iter().map(|parameter| parameter.name).collect();
        format!("table of {} rows of {}, fingerprint {:016x}", table.rows(), names.join(" "), self.0)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}
