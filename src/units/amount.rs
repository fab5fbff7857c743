use super::Quantity;
use super::expression::read_unit;
use super::symbols::Dimension;

/// A number with a unit of any quantity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Amount {
    /// SI value.
    pub value: f64,
    /// True if the unit belongs to a temperature scale with its own zero: 20 degC is 293.15 K, but
    /// a difference of 20 degC is 20 K.
    pub is_on_scale: bool,
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
                is_on_scale: false,
                dimension: Dimension::NONE,
            });
        }
        let unit = read_unit(unit)
            .ok_or_else(|| format!("'{unit}' is no unit; write for example 12 cm^2 or 0.5 g/mm"))?;
        Ok(Self {
            value: unit.value(number),
            is_on_scale: unit.zero.is_some(),
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

    /// The quantity with this dimension; `None` if [`Quantity`] has none.
    pub fn quantity(self) -> Option<Quantity> {
        Quantity::ALL
            .iter()
            .copied()
            .find(|quantity| quantity.dimension == self.dimension)
    }
}
