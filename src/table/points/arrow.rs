use super::columnar::ColumnarFile;
use super::record_batches::RecordBatches;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type};
use arrow_array::{Array, RecordBatch, downcast_integer};
use arrow_schema::DataType;
use std::path::Path;

/// Reads an Arrow IPC file or stream by record batches. The batches may be compressed with ZSTD or
/// LZ4. Feather version 2 is the same format.
pub(super) struct ArrowFile {
    batches: RecordBatches,
    /// Current record batch, and the number of its rows that have been read.
    batch: Option<RecordBatch>,
    passed: usize,
}

impl ColumnarFile for ArrowFile {
    fn open(path: &Path) -> Result<Self, String> {
        Ok(Self {
            batches: RecordBatches::open(path)?,
            batch: None,
            passed: 0,
        })
    }

    fn names(&self) -> Vec<String> {
        self.batches
            .schema
            .fields()
            .iter()
            .map(|field| field.name().clone())
            .collect()
    }

    fn refusal(&self, column: usize) -> Option<String> {
        let kind = self.batches.schema.field(column).data_type();
        let is_read = kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64);
        (!is_read).then(|| {
            format!("its type is {kind}; a column must hold numbers (float64, float32 or integers)")
        })
    }

    fn rewind(&mut self) {
        self.batches.rewind();
        self.batch = None;
    }

    fn rows_left(&mut self) -> Result<usize, String> {
        loop {
            match &self.batch {
                Some(batch) if batch.num_rows() > self.passed => {
                    return Ok(batch.num_rows() - self.passed);
                }
                // free the old batch before reading the next
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

    fn advance(&mut self, rows: usize) {
        self.passed += rows;
    }
}

/// Values of a numeric column; `None` for another type.
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
