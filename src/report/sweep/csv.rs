use super::{STATUS, column_counts, expect_columns, push_number};
use crate::batch::{Batch, Block};
use crate::units::{DerivativeUnit, Quantity, TableUnits, Unit};

/// A batch as CSV. A missing value is an empty cell.
#[derive(Clone, Debug)]
pub struct SweepCsv {
    names: Vec<String>,
    /// Number of parameters, outcomes and derivatives.
    columns: [usize; 3],
    /// The unit of each parameter, outcome and derivative; `None` for a number in SI.
    units: Vec<Option<ColumnUnit>>,
}

#[derive(Clone, Copy, Debug)]
enum ColumnUnit {
    /// Unit of a parameter or an outcome; the zero of its scale may differ from SI (°F).
    Value(Unit),
    /// Size of the unit of a derivative, SI.
    Ratio(f64),
}

impl SweepCsv {
    /// The table of a batch in these units.
    pub fn new(batch: &Batch, units: TableUnits) -> Self {
        let parameters = batch.parameters().iter();
        let parameters = parameters.map(|row| (row.name, row.quantity, row.unit));
        let outcomes = batch.outcomes().iter();
        let outcomes = outcomes.map(|of| (of.name(), of.quantity(), of.unit()));
        let head = |(name, quantity, unit): (&str, Quantity, &'static str)| {
            units.head(name, quantity, unit)
        };
        let is_si = units == TableUnits::Si;
        let of_value = |(_, quantity, unit): (&str, Quantity, &'static str)| {
            let unit = quantity.unit_named(units.unit(quantity, unit));
            unit.filter(|_| !is_si).map(ColumnUnit::Value)
        };
        let values = || parameters.clone().chain(outcomes.clone());
        let derivatives = batch
            .outcomes()
            .iter()
            .flat_map(|of| batch.wrt().iter().map(move |by| (*of, *by)));
        let derivative_units: Vec<_> = derivatives
            .clone()
            .map(|(of, by)| DerivativeUnit::new(of.into(), by.into(), units))
            .collect();
        let derivative_heads = derivatives
            .zip(&derivative_units)
            .map(|((of, by), unit)| unit.head(&format!("d_{}/d_{}", of.name(), by.name)));
        let names = parameters
            .clone()
            .map(head)
            .chain([STATUS.to_owned()])
            .chain(outcomes.clone().map(head))
            .chain(derivative_heads)
            .collect();
        let of_derivatives = derivative_units
            .iter()
            .map(|unit| Some(ColumnUnit::Ratio(unit.size)).filter(|_| !is_si));
        Self {
            names,
            columns: column_counts(batch),
            units: values().map(of_value).chain(of_derivatives).collect(),
        }
    }

    /// The first line: the names of the columns with their units. No name needs quotes.
    pub fn head(&self) -> Vec<u8> {
        (self.names.join(",") + "\n").into_bytes()
    }

    /// A line for each drive.
    ///
    /// # Panics
    /// If the block differs from the batch in the number of parameters, outcomes or derivatives.
    pub fn rows(&self, block: &Block) -> Vec<u8> {
        expect_columns(self.columns, block);
        let mut bytes = Vec::with_capacity(block.rows() * self.names.len() * 20);
        let write = |bytes: &mut Vec<u8>, value: f64, at: usize| {
            let number = match self.units[at] {
                None => value,
                Some(ColumnUnit::Value(unit)) => unit.number(value),
                Some(ColumnUnit::Ratio(size)) => value / size,
            };
            push_number(bytes, number);
        };
        for row in 0..block.rows() {
            let point = block.point(row);
            for (at, value) in point.iter().enumerate() {
                match *value {
                    value if value.is_finite() => write(&mut bytes, value, at),
                    // the table of points has no value here
                    value if value.is_nan() => {}
                    // the radius of a flat face
                    _ => bytes.extend_from_slice(b"inf"),
                }
                bytes.push(b',');
            }
            bytes.extend_from_slice(block.status(row).name().as_bytes());
            let computed = block.outcomes(row).chain(block.derivatives(row));
            for (at, value) in (point.len()..).zip(computed) {
                bytes.push(b',');
                if let Some(value) = value {
                    write(&mut bytes, value, at);
                }
            }
            bytes.push(b'\n');
        }
        bytes
    }
}
