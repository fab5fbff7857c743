//! Points that stand in a table: one column for each parameter, one row for each drive.

#[cfg(feature = "arrow")]
mod arrow;
mod columns;
mod csv;
mod fingerprint;
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
use crate::error::Result;
#[cfg(not(all(feature = "arrow", feature = "parquet")))]
use crate::features::how_to_get;
use crate::parameters::Setup;
use columns::refused;
use std::path::Path;

/// The table in a file, by the ending of its name: CSV (`.csv`), Parquet (`.parquet`), or Arrow IPC (`.arrow`, `.arrows`,
/// `.feather`; a file or a stream, whichever its first bytes say).
///
/// # Errors
/// [`Error::Table`](crate::Error::Table) for a file that cannot be read, a name without a known ending, and everything the tables refuse.
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
