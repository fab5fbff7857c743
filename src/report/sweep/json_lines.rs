use super::super::csv_text::push_number;
use super::{STATUS, column_counts, expect_columns};
use crate::batch::{Batch, Block};

/// A batch as JSON lines: an object for each drive. A missing value is `null`.
#[derive(Clone, Debug)]
pub struct SweepJsonLines {
    /// The text `"name":` for each swept parameter.
    parameters: Vec<String>,
    /// The text `,"name":` for each outcome and derivative.
    results: Vec<String>,
    /// Number of parameters, outcomes and derivatives.
    columns: [usize; 3],
}

/// A drive of a sweep: the swept parameters, the status, the outcomes, and the derivatives as
/// `d_OUTCOME/d_PARAMETER`. The request chooses the keys other than `status`.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
pub struct SweepRow {
    /// The status of the drive.
    status: crate::batch::Status,
    #[schemars(flatten)]
    values: super::super::json::ByName<super::super::json::JsonNumber>,
}

impl SweepJsonLines {
    /// The table of a batch.
    pub fn new(batch: &Batch) -> Self {
        let key = |name: &str| format!("\"{name}\":");
        Self {
            parameters: batch.parameters().iter().map(|row| key(row.name)).collect(),
            results: batch
                .columns()
                .iter()
                .map(|name| format!(",{}", key(name)))
                .collect(),
            columns: column_counts(batch),
        }
    }

    /// A line for each drive.
    ///
    /// # Panics
    /// If the block differs from the batch in the number of parameters, outcomes or derivatives.
    pub fn rows(&self, block: &Block) -> Vec<u8> {
        expect_columns(self.columns, block);
        let width = self.parameters.len() + self.results.len();
        let mut bytes = Vec::with_capacity(block.rows() * (width * 40 + 20));
        for row in 0..block.rows() {
            bytes.push(b'{');
            for (key, value) in self.parameters.iter().zip(block.point(row)) {
                bytes.extend_from_slice(key.as_bytes());
                match *value {
                    value if value.is_finite() => push_number(&mut bytes, value),
                    // the table of points has no value here
                    value if value.is_nan() => bytes.extend_from_slice(b"null"),
                    // the radius of a flat face: JSON has no infinity
                    _ => bytes.extend_from_slice(b"\"inf\""),
                }
                bytes.push(b',');
            }
            bytes.extend_from_slice(format!("\"{STATUS}\":\"{}\"", block.status(row)).as_bytes());
            for (key, value) in self
                .results
                .iter()
                .zip(block.outcomes(row).chain(block.derivatives(row)))
            {
                bytes.extend_from_slice(key.as_bytes());
                match value {
                    Some(value) => push_number(&mut bytes, value),
                    None => bytes.extend_from_slice(b"null"),
                }
            }
            bytes.extend_from_slice(b"}\n");
        }
        bytes
    }
}
