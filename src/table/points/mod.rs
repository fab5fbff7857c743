//! Points that stand in a file, as [`Points`] of a batch: a column for each parameter, a row for
//! each drive. [`open_table`] reads CSV, Parquet and Arrow.

#[cfg(feature = "arrow")]
mod arrow;
mod columns;
mod csv;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(any(feature = "arrow", feature = "parquet"))]
mod pieces;
#[cfg(feature = "arrow")]
mod record_batches;
mod rows;

use crate::batch::Points;
use crate::error::Result;
#[cfg(not(all(feature = "arrow", feature = "parquet")))]
use crate::features::how_to_get;
use crate::parameters::Setup;
use columns::refused;
#[cfg(any(feature = "arrow", feature = "parquet"))]
use pieces::PieceRows;
use rows::Table;
use std::path::Path;

/// The table in a file, by the ending of its name: CSV (`.csv`; a launch monitor's export too, with
/// cells separated by commas, semicolons or tabs), Parquet (`.parquet`), or Arrow IPC (`.arrow`,
/// `.arrows`, `.feather`; a file or a stream, whichever its first bytes say). Columns are named by
/// parameters, with their units in CSV, and are in SI in the others. All of it is read once here,
/// so that a value that is missing is told before any work.
///
/// # Errors
/// [`Error::Table`](crate::Error::Table) for a name without a known ending; a file that cannot be
/// read, is damaged or cut short, or has no column of a parameter; a column that is unknown, given
/// twice or not of numbers; a unit of another kind; and a value that is missing, no number, not
/// finite where it must be, or whose decimal mark is uncertain.
pub fn open_table(setup: &Setup<f64>, path: &Path) -> Result<Box<dyn Points + Send>> {
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or_default()
        .to_lowercase();
    match ending.as_str() {
        "csv" => Ok(Box::new(Table::new(csv::CsvRows::open(setup, path)?)?)),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(Box::new(Table::new(
            PieceRows::<parquet::ParquetPieces>::open(setup, path)?,
        )?)),
        #[cfg(feature = "arrow")]
        "arrow" | "arrows" | "feather" => Ok(Box::new(Table::new(
            PieceRows::<arrow::ArrowPieces>::open(setup, path)?,
        )?)),
        #[cfg(not(feature = "parquet"))]
        "parquet" => Err(refused(path, String::new(), how_to_get("parquet"))),
        #[cfg(not(feature = "arrow"))]
        "arrow" | "arrows" | "feather" => Err(refused(path, String::new(), how_to_get("arrow"))),
        _ => Err(refused(
            path,
            String::new(),
            "a table's name must end in .csv, .parquet, .arrow, .arrows or .feather",
        )),
    }
}
