use super::Quantity;
use super::expression::read_unit;
use super::symbols::{Dimension, SYMBOLS};

/// A number that was given with any unit: its SI value and its dimension.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Amount {
    pub value: f64,
    dimension: Dimension,
}

impl Amount {
    /// Parses a number with a unit, or a plain number.
    ///
    /// # Errors
    /// A sentence with the reason, and advice.
    pub fn read(text: &str) -> Result<Self, String> {
        let (number, unit) = Quantity::NUMBER
            .split(text)
            .map_err(|error| error.to_string())?;
        if !number.is_finite() {
            return Err(format!("'{text}' is not finite"));
        }
        if unit.is_empty() {
            return Ok(Self {
                value: number,
                dimension: Dimension::NONE,
            });
        }
        let unit = read_unit(unit)
            .ok_or_else(|| format!("'{unit}' is no unit; write for example 12 cm^2 or 0.5 g/mm"))?;
        Ok(Self {
            value: unit.difference(number),
            dimension: unit.dimension,
        })
    }

    /// The product of this number and one SI unit of the quantity `by`.
    pub fn times(self, by: Quantity) -> Self {
        Self {
            dimension: self.dimension.times(by.dimension, 1),
            ..self
        }
    }

    /// The named quantity of this dimension; `None` if no named quantity has it.
    pub fn quantity(self) -> Option<Quantity> {
        Quantity::ALL
            .iter()
            .copied()
            .find(|quantity| quantity.dimension == self.dimension)
    }
}

impl Quantity {
    /// The first of the usual units; empty for a plain number.
    pub(crate) fn usual_unit(self) -> &'static str {
        if self.si.is_empty() {
            ""
        } else {
            self.usual.split(", ").next().unwrap_or_default()
        }
    }

    /// The unit with this spelling, if it is a usual unit or a symbol of this quantity.
    pub(crate) fn known_unit(self, written: &str) -> Option<&'static str> {
        let symbols = SYMBOLS.iter().flat_map(|symbol| symbol.names).copied();
        let known = self
            .usual
            .split(", ")
            .chain(symbols)
            .find(|unit| *unit == written)?;
        self.size_of(known).map(|_| known)
    }
}
