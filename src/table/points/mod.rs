//! Tables of points, as [`Points`] of a batch: one column per parameter, one row per drive.
//! [`open_table`] reads CSV, Parquet and Arrow.

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
use crate::input_file::table_extension;
use crate::parameters::Setup;
use crate::table::SourceName;
#[cfg(any(feature = "arrow", feature = "parquet"))]
use pieces::PieceRows;
use rows::Table;
use std::path::Path;

/// Opens a table by its file name extension: CSV (`.csv`, including exports of launch monitors
/// separated by commas, semicolons or tabs), Parquet (`.parquet`), or Arrow IPC file or stream
/// (`.arrow`, `.arrows`, `.feather`). Columns are parameters, with units in CSV and in SI
/// otherwise. The whole table is read once, so that errors appear before any work.
///
/// # Errors
/// [`Error::Table`](crate::Error::Table) if the extension is unknown, if the file is unreadable,
/// damaged or truncated, if no column is a parameter, if a column is unknown, repeated or not
/// numeric, if a unit has the wrong dimension, or if a value is not a number, is infinite, or has
/// an ambiguous decimal mark. A missing value is no error: its row gets a status.
pub fn open_table(setup: &Setup<f64>, path: &Path) -> Result<Box<dyn Points + Send>> {
    let refused =
        |reason: &str| Err(SourceName(path.display().to_string()).refused(String::new(), reason));
    match table_extension(path).as_str() {
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
        "parquet" => refused(&how_to_get("parquet")),
        #[cfg(not(feature = "arrow"))]
        "arrow" | "arrows" | "feather" => refused(&how_to_get("arrow")),
        _ => refused("a table's name must end in .csv, .parquet, .arrow, .arrows or .feather"),
    }
}
