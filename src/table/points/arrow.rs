use super::pieces::Pieces;
use super::record_batches::{Order, RecordBatches};
use crate::external_errors::read_error_text;
use crate::input_file::InputFile;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type};
use arrow_array::{Array, downcast_integer};
use arrow_schema::DataType;
use std::io::Read;
use std::path::Path;

const MAGIC: &[u8; 6] = b"ARROW1";
const FEATHER_1: &[u8; 4] = b"FEA1";

/// Feather version 2 is Arrow IPC too.
impl Pieces for RecordBatches {
    fn open(path: &Path) -> Result<Self, String> {
        let unreadable = |error: std::io::Error| read_error_text(&error);
        let mut file = InputFile::open(path).map_err(unreadable)?;
        let length = file.size().map_err(unreadable)?;
        let mut magic = vec![];
        file.by_ref()
            .take(MAGIC.len() as u64)
            .read_to_end(&mut magic)
            .map_err(unreadable)?;
        if magic.is_empty() {
            return Err("it is empty".into());
        }
        if magic == MAGIC {
            return Self::of_file(file, length);
        }
        if magic.starts_with(FEATHER_1) {
            return Err(
                "it is a Feather file of version 1; write version 2, which is Arrow IPC".into(),
            );
        }
        Self::of_stream(file, length)
    }

    fn names(&self) -> Vec<String> {
        self.schema
            .fields()
            .iter()
            .map(|field| field.name().clone())
            .collect()
    }

    fn refusal(&self, column: usize) -> Option<String> {
        let kind = self.schema.field(column).data_type();
        let is_read = kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64);
        (!is_read).then(|| {
            format!("its type is {kind}; a column must hold numbers (float64, float32 or integers)")
        })
    }

    fn rewind(&mut self) {
        match &mut self.order {
            Order::Listed { next, .. } => *next = 0,
            Order::Following { first, next } => *next = *first,
        }
        self.batch = None;
    }

    fn left(&mut self) -> Result<usize, String> {
        loop {
            match &self.batch {
                Some(batch) if batch.num_rows() > self.passed => {
                    return Ok(batch.num_rows() - self.passed);
                }
                // free the old batch before reading the next
                _ => (self.batch, self.passed) = (None, 0),
            }
            self.batch = self.next()?;
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
