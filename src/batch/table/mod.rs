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
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
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
        _ => Err(refused(path, String::new(), endings())),
    }
}

/// Which endings a table's name may have.
fn endings() -> String {
    let mut endings = vec![".csv"];
    let mut without = String::new();
    for (feature, is_there, more) in [
        ("parquet", cfg!(feature = "parquet"), &[".parquet"][..]),
        ("arrow", cfg!(feature = "arrow"), &[".arrow", ".arrows", ".feather"]),
    ] {
        if is_there {
            endings.extend(more);
        } else {
            without += &format!(" (this longdrive is built without the feature {feature})");
        }
    }
    let last = endings.pop().unwrap_or_default();
    let others = if endings.is_empty() { String::new() } else { endings.join(", ") + " or " };
    format!("a table's name must end in {others}{last}{without}")
}

fn refused(path: &Path, place: String, reason: impl Into<String>) -> Error {
    Error::Table { file: path.display().to_string(), place, reason: reason.into() }
}

/// The parameter of a column.
fn column(setup: &Setup<f64>, path: &Path, number: usize, name: &str) -> Result<&'static Parameter> {
    let place = format!(", column {number}");
    // a launch monitor's own names stand for the launch conditions
    if let Some(condition) = setup.launch_condition(name) {
        return Ok(condition);
    }
    setup.column(name).map_err(|error| refused(path, place, format!("{error}; every column must be a parameter")))
}

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
