//! Output of batches: CSV, JSON lines and Parquet. The columns are the swept parameters, `status`,
//! the outcomes, and `d_OUTCOME/d_PARAMETER`. Numbers are in SI. CSV may also have other units; its
//! column heads contain the units: `carry [m]`. Numbers are written so that parsing returns the
//! same `f64`. A missing value is an empty cell or null.

mod csv;
mod json_lines;
#[cfg(feature = "parquet")]
mod parquet;
mod summary;

pub use csv::SweepCsv;
pub use json_lines::SweepJsonLines;
#[cfg(test)]
pub use json_lines::SweepRow;
#[cfg(feature = "parquet")]
pub use parquet::SweepParquet;
pub use summary::summary_document;

use crate::batch::{Batch, Block};

const STATUS: &str = "status";

/// Number of parameters, outcomes and derivatives in a batch.
fn column_counts(batch: &Batch) -> [usize; 3] {
    let (outcomes, wrt) = (batch.outcomes().len(), batch.wrt().len());
    [batch.parameters().len(), outcomes, outcomes * wrt]
}

/// Checks that a block has as many parameters, outcomes and derivatives as the table.
///
/// # Panics
/// If the block differs in the number of parameters, outcomes or derivatives.
#[track_caller]
fn expect_columns(here: [usize; 3], block: &Block) {
    let there = block.columns();
    assert!(
        here == there,
        "the table has {here:?} parameters, outcomes and derivatives, but the block has \
         {there:?}: the block belongs to another batch"
    );
}
