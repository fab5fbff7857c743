//! Rows of a batch as bytes: CSV, JSON lines and Parquet. The columns are the swept parameters, `status`, the outcomes,
//! and `d_OUTCOME/d_PARAMETER`, all in SI; the heads of CSV name the units, `carry [m]`. Numbers are written so that they read back equal; what does not exist is an
//! empty cell, or null.

mod csv;
mod json_lines;
#[cfg(feature = "parquet")]
mod parquet;

pub use csv::SweepCsv;
pub use json_lines::SweepJsonLines;
#[cfg(feature = "parquet")]
pub use parquet::SweepParquet;

use crate::batch::Batch;
use crate::drive::Outcome;

/// The name of the column that says how a drive ended.
const STATUS: &str = "status";

/// The names of the swept parameters.
fn parameter_names(batch: &Batch) -> Vec<&'static str> {
    batch.parameters().iter().map(|parameter| parameter.name).collect()
}

/// The names of the outcomes, then of their derivatives.
fn result_names(batch: &Batch) -> Vec<String> {
    let derivative = |of: &Outcome| batch.wrt().iter().map(|by| format!("d_{}/d_{}", of.name(), by.name)).collect();
    let derivatives = batch.outcomes().iter().flat_map::<Vec<_>, _>(derivative);
    batch.outcomes().iter().map(|of| of.name().to_owned()).chain(derivatives).collect()
}

/// Appends a number in the shortest form that reads back equal.
pub(super) fn push_number(bytes: &mut Vec<u8>, number: f64) {
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &(number + 0.0));
}
