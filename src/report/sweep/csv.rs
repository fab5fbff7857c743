use super::{Columns, STATUS, push_number};
use crate::batch::{Batch, Block};
use crate::units::ratio;

/// A batch as CSV. A missing value is an empty cell.
#[derive(Clone, Debug)]
pub struct SweepCsv {
    names: Vec<String>,
    columns: Columns,
}

impl SweepCsv {
    /// The table of a batch.
    pub fn new(batch: &Batch) -> Self {
        let parameters = batch
            .parameters()
            .iter()
            .map(|parameter| parameter.quantity.head(parameter.name));
        let outcomes = batch
            .outcomes()
            .iter()
            .map(|of| of.quantity().head(of.name()));
        let derivatives = batch
            .outcomes()
            .iter()
            .flat_map(|of| batch.wrt().iter().map(move |by| (of, by)));
        let derivatives = derivatives.map(|(of, by)| {
            let name = format!("d_{}/d_{}", of.name(), by.name);
            match ratio(of.quantity().si, by.quantity.si) {
                unit if unit.is_empty() => name,
                unit => format!("{name} [{unit}]"),
            }
        });
        let names = parameters
            .chain([STATUS.to_owned()])
            .chain(outcomes)
            .chain(derivatives)
            .collect();
        Self {
            names,
            columns: Columns::of(batch),
        }
    }

    /// The first line: names of the columns with SI units. They need no quotes.
    pub fn head(&self) -> Vec<u8> {
        (self.names.join(",") + "\n").into_bytes()
    }

    /// A line for each drive.
    ///
    /// # Panics
    /// If the block has other numbers of parameters, outcomes or derivatives than the batch.
    pub fn rows(&self, block: &Block) -> Vec<u8> {
        self.columns.expect(block);
        let mut bytes = Vec::with_capacity(block.rows() * self.names.len() * 20);
        for row in 0..block.rows() {
            for value in block.point(row) {
                match *value {
                    value if value.is_finite() => push_number(&mut bytes, value),
                    // a missing value in the table of points
                    value if value.is_nan() => {}
                    // the radius of a flat face
                    _ => bytes.extend_from_slice(b"inf"),
                }
                bytes.push(b',');
            }
            bytes.extend_from_slice(block.status(row).name().as_bytes());
            for value in block.outcomes(row).chain(block.derivatives(row)) {
                bytes.push(b',');
                if let Some(value) = value {
                    push_number(&mut bytes, value);
                }
            }
            bytes.push(b'\n');
        }
        bytes
    }
}
