use super::columns::{Columns, columns_in_si, refused, wrong_value};
use super::fingerprint::Fingerprint;
use super::record_batches::RecordBatches;
use crate::batch::points::Points;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use arrow_array::cast::AsArray;
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, RecordBatch};
use arrow_schema::DataType;
use std::path::{Path, PathBuf};

/// Points in an Arrow IPC file or stream (Feather of version 2 is such a file): columns of numbers, SI, named by
/// parameters. It is read a record batch at a time; batches may be compressed by ZSTD or LZ4.
pub struct ArrowTable {
    path: PathBuf,
    batches: RecordBatches,
    read: Columns,
    notes: Vec<Message>,
    rows: u64,
    fingerprint: Fingerprint,
    /// The record batch that is being read, and how many of its rows have been.
    batch: Option<RecordBatch>,
    passed: usize,
    next: u64,
}

impl ArrowTable {
    /// The table in a file. All of it is read once, so that a value that is missing is told before any work.
    ///
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a file that cannot be read, is cut short, a column
    /// that is no parameter, given twice or not of numbers, a missing value, and NaN.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let batches = RecordBatches::open(path).map_err(|reason| refused(path, String::new(), reason))?;
        let fields = batches.schema().fields();
        let names: Vec<String> = fields.iter().map(|field| field.name().clone()).collect();
        let (read, notes) = columns_in_si(setup, path, &names)?;
        for at in &read.at {
            let kind = fields[*at].data_type();
            if !(kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64)) {
                let reason = format!("its type is {kind}; a column must hold numbers (float64, float32 or integers)");
                return Err(refused(path, format!(", column {}", names[*at]), reason));
            }
        }
        let (path, fingerprint) = (path.to_owned(), Fingerprint::new());
        let mut table = Self { path, batches, read, notes, rows: 0, fingerprint, batch: None, passed: 0, next: 0 };
        (table.rows, table.fingerprint) = Fingerprint::of(&mut table)?;
        table.seek(0)?;
        Ok(table)
    }

    fn unreadable(&self, reason: String) -> crate::Error {
        let place = if self.next == 0 { String::new() } else { format!(", after row {}", self.next) };
        refused(&self.path, place, reason)
    }

    /// How many rows of the record batch are left.
    fn left(&self) -> usize {
        self.batch.as_ref().map_or(0, |batch| batch.num_rows() - self.passed)
    }

    /// Begins record batches until one has rows left; false at the end. Those that lie wholly before a row are passed
    /// over, unread.
    fn open_batch(&mut self, row: u64) -> Result<bool> {
        while self.left() == 0 {
            // its memory is free before the next one's is taken
            (self.batch, self.passed) = (None, 0);
            let Some(head) = self.batches.next().map_err(|reason| self.unreadable(reason))? else {
                return Ok(false);
            };
            if head.rows <= row.saturating_sub(self.next) {
                self.next += head.rows;
                continue;
            }
            let batch = self.batches.read(&head).map_err(|reason| self.unreadable(reason))?;
            self.batch = Some(batch);
        }
        Ok(true)
    }
}

/// The values of a column; what stands for a missing one is any number. None of a column that is not of numbers.
fn values(column: &dyn Array) -> Option<Vec<f64>> {
    macro_rules! read {
        ($kind:ty, $into:expr) => {
            column.as_primitive::<$kind>().values().iter().copied().map($into).collect()
        };
    }
    Some(match column.data_type() {
        DataType::Float64 => read!(Float64Type, |value| value),
        DataType::Float32 => read!(Float32Type, f64::from),
        DataType::Int8 => read!(Int8Type, f64::from),
        DataType::Int16 => read!(Int16Type, f64::from),
        DataType::Int32 => read!(Int32Type, f64::from),
        DataType::Int64 => read!(Int64Type, |value| value as f64),
        DataType::UInt8 => read!(UInt8Type, f64::from),
        DataType::UInt16 => read!(UInt16Type, f64::from),
        DataType::UInt32 => read!(UInt32Type, f64::from),
        DataType::UInt64 => read!(UInt64Type, |value| value as f64),
        _ => return None,
    })
}

impl Points for ArrowTable {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.read.parameters
    }

    fn notes(&self) -> Vec<Message> {
        self.notes.clone()
    }

    fn rows(&self) -> u64 {
        self.rows
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        self.batches.rewind();
        (self.batch, self.passed, self.next) = (None, 0, 0);
        if self.open_batch(row)? {
            self.passed = (row - self.next) as usize;
            self.next = row;
        }
        Ok(())
    }

    fn read(&mut self, most: usize, into: &mut Vec<f64>) -> Result<usize> {
        let width = self.read.parameters.len();
        let mut rows = 0;
        // a chunk may reach over the end of a record batch
        while rows < most && self.open_batch(self.next)? {
            let wanted = self.left().min(most - rows);
            let Some(batch) = &self.batch else { break };
            let first = into.len();
            into.resize(first + wanted * width, 0.0);
            for (i, parameter) in self.read.parameters.iter().enumerate() {
                let column = batch.column(self.read.at[i]).slice(self.passed, wanted);
                let values = values(&column).ok_or_else(|| self.unreadable("it is not a column of numbers".into()))?;
                for (row, value) in values.into_iter().enumerate() {
                    let found = (!column.is_null(row)).then_some(value);
                    if let Some(wrong) = wrong_value(parameter, found) {
                        let place = format!(", row {}, column {}", self.next + row as u64 + 1, parameter.name);
                        return Err(refused(&self.path, place, wrong));
                    }
                    into[first + row * width + i] = value;
                }
            }
            self.passed += wanted;
            self.next += wanted as u64;
            rows += wanted;
        }
        Ok(rows)
    }

    fn identity(&self) -> String {
        self.fingerprint.identity(self)
    }
}
