//! Rows of a batch as bytes: CSV, JSON lines and Parquet. The columns are the swept parameters,
//! `status`, the outcomes, and `d_OUTCOME/d_PARAMETER`, all in SI; the heads of CSV name the units,
//! `carry [m]`. Numbers are written so that they read back equal; what does not exist is an empty
//! cell, or null.

mod csv;
mod json_lines;
#[cfg(feature = "parquet")]
mod parquet;
mod summary;

pub use csv::SweepCsv;
pub use json_lines::SweepJsonLines;
#[cfg(feature = "parquet")]
pub use parquet::SweepParquet;
pub use summary::summary_document;

use crate::batch::{Batch, Block};

/// The name of the column that says how a drive ended.
const STATUS: &str = "status";

/// Numbers of columns of a batch: parameters, outcomes, derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Columns([usize; 3]);

impl Columns {
    fn of(batch: &Batch) -> Self {
        let (outcomes, wrt) = (batch.outcomes().len(), batch.wrt().len());
        Self([batch.parameters().len(), outcomes, outcomes * wrt])
    }

    /// # Panics
    /// Where a block has others.
    #[track_caller]
    fn expect(&self, block: &Block) {
        let (here, there) = (self.0, block.columns());
        assert!(
            here == there,
            "the table is of {here:?} parameters, outcomes and derivatives, and the block of \
             {there:?}: it is of another batch"
        );
    }
}

/// The names of the swept parameters.
fn parameter_names(batch: &Batch) -> Vec<&'static str> {
    batch
        .parameters()
        .iter()
        .map(|parameter| parameter.name)
        .collect()
}

/// Appends a number in the shortest form that reads back equal.
pub(super) fn push_number(bytes: &mut Vec<u8>, number: f64) {
    // writing to memory does not fail
    let _ = serde_json::to_writer(bytes, &(number + 0.0));
}
