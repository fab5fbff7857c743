use super::{DisplayUnit, TableUnits, ratio};

/// The unit of a derivative in a table.
///
/// ```
/// use longdrive::units::{DerivativeUnit, DisplayUnit, Quantity, System, TableUnits};
/// let of = DisplayUnit { quantity: Quantity::LENGTH, unit: "yd" };
/// let by = DisplayUnit { quantity: Quantity::ANGLE, unit: "deg" };
/// assert_eq!(DerivativeUnit::new(of, by, TableUnits::Si).head("slope"), "slope [m/rad]");
/// let us = DerivativeUnit::new(of, by, TableUnits::Of(System::Us));
/// assert_eq!(us.head("slope"), "slope [yd/deg]");
/// assert_eq!(us.size, 0.9144 / 1f64.to_radians());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeUnit {
    /// Name of the unit; empty for a plain number.
    pub name: String,
    /// SI size of the unit.
    pub size: f64,
}

impl DerivativeUnit {
    /// The unit of the derivative of the quantity `of` by the quantity `by`.
    pub fn new(of: DisplayUnit, by: DisplayUnit, units: TableUnits) -> Self {
        let unit = |display: DisplayUnit| units.unit(display);
        let size = |display: DisplayUnit| {
            let size = display.quantity.size_of(unit(display));
            size.unwrap_or(1.0)
        };
        Self {
            name: ratio(unit(of), unit(by)),
            size: size(of) / size(by),
        }
    }

    /// Column head: the name with the unit.
    pub fn head(&self, name: &str) -> String {
        match self.name.as_str() {
            "" => name.into(),
            unit => format!("{name} [{unit}]"),
        }
    }
}
