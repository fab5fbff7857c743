//! Points that stand in a table: one column for each parameter, one row for each drive.

mod csv;
#[cfg(feature = "parquet")]
mod parquet;

pub use csv::CsvTable;
#[cfg(feature = "parquet")]
pub use parquet::ParquetTable;

use super::points::Points;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use std::path::Path;

/// The table in a file: CSV, or Parquet where its name ends in `.parquet`.
///
/// # Errors
/// [`Error::Table`] for a file that cannot be read, a name without a known ending, and everything the tables refuse.
pub fn open_table(setup: &Setup<f64>, path: &Path) -> Result<Box<dyn Points>> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_lowercase();
    match ending.as_str() {
        "csv" => Ok(Box::new(CsvTable::open(setup, path)?)),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(Box::new(ParquetTable::open(setup, path)?)),
        _ => {
            let reason = if cfg!(feature = "parquet") {
                "a table's name must end in .csv or .parquet"
            } else {
                "a table's name must end in .csv (this longdrive is built without the feature parquet)"
            };
            Err(refused(path, String::new(), reason))
        }
    }
}

fn refused(path: &Path, place: String, reason: impl Into<String>) -> Error {
    Error::Table { file: path.display().to_string(), place, reason: reason.into() }
}

/// The parameter of a column.
fn column(setup: &Setup<f64>, path: &Path, number: usize, name: &str) -> Result<&'static Parameter> {
    let place = format!(", column {number}");
    setup.variable(name).map_err(|error| refused(path, place, format!("{error}; every column is a parameter")))
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
struct Fingerprint(u64);

impl Fingerprint {
    const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}
