use super::pieces::Pieces;
use super::record_batches::RecordBatches;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type};
use arrow_array::{Array, RecordBatch, downcast_integer};
use arrow_schema::DataType;
use std::path::Path;

/// An Arrow IPC file or stream (Feather of version 2 is such a file), read a record batch at a
/// time; batches may be compressed by ZSTD or LZ4.
pub(super) struct ArrowPieces {
    batches: RecordBatches,
    /// The record batch that is being read, and how many of its rows have been.
    batch: Option<RecordBatch>,
    passed: usize,
}

impl Pieces for ArrowPieces {
    fn open(path: &Path) -> Result<Self, String> {
        Ok(Self {
            batches: RecordBatches::open(path)?,
            batch: None,
            passed: 0,
        })
    }

    fn names(&self) -> Vec<String> {
        self.batches
            .schema()
            .fields()
            .iter()
            .map(|field| field.name().clone())
            .collect()
    }

    fn refusal(&self, column: usize) -> Option<String> {
        let kind = self.batches.schema().field(column).data_type();
        let is_read = kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64);
        (!is_read).then(|| {
            format!("its type is {kind}; a column must hold numbers (float64, float32 or integers)")
        })
    }

    fn rewind(&mut self) {
        self.batches.rewind();
        self.batch = None;
    }

    fn left(&mut self) -> Result<usize, String> {
        loop {
            match &self.batch {
                Some(batch) if batch.num_rows() > self.passed => {
                    return Ok(batch.num_rows() - self.passed);
                }
                // its memory is free before the next one's is taken
                _ => (self.batch, self.passed) = (None, 0),
            }
            self.batch = self.batches.next()?;
            if self.batch.is_none() {
                return Ok(0);
            }
        }
    }

    fn values(&mut self, column: usize, rows: usize) -> Result<Vec<Option<f64>>, String> {
        let column = self
            .batch
            .as_ref()
            .map(|batch| batch.column(column).slice(self.passed, rows));
        column
            .and_then(|column| numbers(&column))
            .ok_or("it is not a column of numbers".into())
    }

    fn pass(&mut self, rows: usize) {
        self.passed += rows;
    }
}

/// The values of a column; nothing of one that is not of numbers.
fn numbers(column: &dyn Array) -> Option<Vec<Option<f64>>> {
    macro_rules! read {
        ($kind:ty) => {
            Some(
                column
                    .as_primitive::<$kind>()
                    .iter()
                    .map(|value| value.map(|value| value as f64))
                    .collect(),
            )
        };
    }
    downcast_integer! {
        column.data_type() => (read),
        DataType::Float32 => read!(Float32Type),
        DataType::Float64 => read!(Float64Type),
        _ => None
    }
}
