//! The points of a sweep: a table, a grid or a sequence, as [`Points`] of a batch. A table has one
//! column per parameter and one row per drive; [`open_table`] reads CSV, Parquet and Arrow.

#[cfg(feature = "arrow")]
mod arrow;
#[cfg(any(feature = "arrow", feature = "parquet"))]
mod columnar;
mod columns;
mod csv;
#[cfg(feature = "parquet")]
mod parquet;
mod rows;

use crate::batch::{Grid, GridAxis, Points, Sequence};
use crate::error::{Error, Result};
#[cfg(not(all(feature = "arrow", feature = "parquet")))]
use crate::features::how_to_get;
use crate::input_file::table_extension;
use crate::parameters::{Setup, Vary};
#[cfg(any(feature = "arrow", feature = "parquet"))]
use columnar::ColumnarRows;
use rows::TablePoints;
use std::path::Path;

/// Opens a table by its file name extension: CSV (`.csv`, including exports of launch monitors
/// separated by commas, semicolons or tabs), Parquet (`.parquet`), or Arrow IPC file or stream
/// (`.arrow`, `.arrows`, `.feather`). Each column is a parameter. Column heads of CSV state the
/// units; other tables are in SI. The whole table is read once, so that errors appear before any
/// work.
///
/// # Errors
/// [`Error::Table`] if the extension is unknown, if the file is unreadable,
/// damaged or truncated, if no column is a parameter, if a column is unknown, repeated or not
/// numeric, if a unit has the wrong dimension, or if a value is not a number, is infinite, or has
/// an ambiguous decimal mark. A missing value is no error: its row gets a status.
pub fn open_table(setup: &Setup<f64>, path: &Path) -> Result<Box<dyn Points + Send>> {
    let refused = |reason: &str| Err(Error::table(path.display().to_string(), "", reason));
    match table_extension(path).as_str() {
        "csv" => Ok(Box::new(TablePoints::new(csv::CsvRows::open(
            setup, path,
        )?)?)),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(Box::new(TablePoints::new(ColumnarRows::<
            parquet::ParquetFile,
        >::open(setup, path)?)?)),
        #[cfg(feature = "arrow")]
        "arrow" | "arrows" | "feather" => {
            Ok(Box::new(TablePoints::new(
                ColumnarRows::<arrow::ArrowFile>::open(setup, path)?,
            )?))
        }
        #[cfg(not(feature = "parquet"))]
        "parquet" => refused(&how_to_get("parquet")),
        #[cfg(not(feature = "arrow"))]
        "arrow" | "arrows" | "feather" => refused(&how_to_get("arrow")),
        _ => refused("a table's name must end in .csv, .parquet, .arrow, .arrows or .feather"),
    }
}

/// The points of a sweep:
///
/// - the rows of `table`, if it is given
/// - otherwise, if `sample` is given, this number of points of a [`Sequence`] in the ranges `over`
/// - otherwise the grid of the axes `over`
///
/// # Errors
/// The errors of [`open_table`], [`GridAxis::read`], [`Vary::read_column`], [`Grid::new`] and
/// [`Sequence::new`], and [`Error::SearchRange`] if `sample` is given and a range has a count.
pub fn sweep_points(
    setup: &Setup<f64>,
    table: Option<&Path>,
    over: &[String],
    sample: Option<u64>,
    seed: u32,
) -> Result<Box<dyn Points>> {
    if let Some(table) = table {
        return Ok(open_table(setup, table)?);
    }
    let over = over.iter();
    Ok(match sample {
        None => Box::new(Grid::new(
            over.map(|text| GridAxis::read(setup, text))
                .collect::<Result<_>>()?,
        )?),
        Some(rows) => {
            let over = over.map(|text| sampled_range(setup, text));
            Box::new(Sequence::new(over.collect::<Result<_>>()?, rows, seed)?)
        }
    })
}

fn sampled_range(setup: &Setup<f64>, text: &str) -> Result<Vary> {
    match text.rsplit_once(':') {
        Some((range, _)) => Err(Error::SearchRange {
            name: text.into(),
            reason: format!(
                "`sample` says how many points there are; write {range}, without a count"
            ),
        }),
        None => Vary::read_column(setup, text),
    }
}
