use super::super::csv_text::push_number;
use super::{STATUS, column_counts, expect_columns};
use crate::batch::{Batch, Block};
use crate::units::{DerivativeUnit, DisplayUnit, TableUnits, Unit};

/// A batch as CSV. A missing value is an empty cell.
#[derive(Clone, Debug)]
pub struct SweepCsv {
    names: Vec<String>,
    /// Number of parameters, outcomes and derivatives.
    columns: [usize; 3],
    /// The unit of each parameter and outcome; `None` for a number in SI.
    units: Vec<Option<Unit>>,
    /// The size of the unit of each derivative, SI.
    derivative_sizes: Vec<f64>,
}

impl SweepCsv {
    /// The table of a batch in these units.
    pub fn new(batch: &Batch, units: TableUnits) -> Self {
        let parameters = batch.parameters().iter();
        let parameters = parameters.map(|row| (row.name, DisplayUnit::from(*row)));
        let outcomes = batch.outcomes().iter();
        let outcomes = outcomes.map(|of| (of.name(), DisplayUnit::from(*of)));
        let head = |(name, of): (&str, DisplayUnit)| units.head(name, of);
        let is_si = units == TableUnits::Si;
        let of_value = |(_, of): (&str, DisplayUnit)| {
            let unit = of.quantity.unit_named(units.unit(of));
            unit.filter(|_| !is_si)
        };
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
        let derivative_sizes = derivative_units
            .iter()
            .map(|unit| if is_si { 1.0 } else { unit.size });
        Self {
            names,
            columns: column_counts(batch),
            units: parameters.chain(outcomes).map(of_value).collect(),
            derivative_sizes: derivative_sizes.collect(),
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
        let in_unit = |value: f64, unit: &Option<Unit>| match unit {
            None => value,
            Some(unit) => unit.number(value),
        };
        for row in 0..block.rows() {
            let point = block.point(row);
            let (of_point, of_outcomes) = self.units.split_at(point.len());
            for (value, unit) in point.iter().zip(of_point) {
                match *value {
                    value if value.is_finite() => push_number(&mut bytes, in_unit(value, unit)),
                    // the table of points has no value here
                    value if value.is_nan() => {}
                    // the radius of a flat face
                    _ => bytes.extend_from_slice(b"inf"),
                }
                bytes.push(b',');
            }
            bytes.extend_from_slice(block.status(row).name().as_bytes());
            let outcomes = block.outcomes(row).zip(of_outcomes);
            let outcomes = outcomes.map(|(value, unit)| Some(in_unit(value?, unit)));
            let derivatives = block.derivatives(row).zip(&self.derivative_sizes);
            let derivatives = derivatives.map(|(value, size)| Some(value? / size));
            for number in outcomes.chain(derivatives) {
                bytes.push(b',');
                if let Some(number) = number {
                    push_number(&mut bytes, number);
                }
            }
            bytes.push(b'\n');
        }
        bytes
    }
}
