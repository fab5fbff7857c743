use super::{Digits, Quantity, System};

/// A quantity with its display unit. In a text in the units of a [`System`], [`System::unit`]
/// replaces the display unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Physical quantity.
    pub quantity: Quantity,
    /// Display unit.
    pub unit: &'static str,
}

impl DisplayUnit {
    /// SI size of the unit.
    pub fn size(self) -> f64 {
        self.quantity.size_of(self.unit).unwrap_or(1.0)
    }

    /// An SI value as text in the unit, as [`Quantity::show`] writes it.
    pub fn show(self, value: f64) -> String {
        self.quantity.show(value, self.unit)
    }

    /// An SI value as text in the unit that `system` uses in place of this unit, as
    /// [`Quantity::read_off`] writes it.
    pub fn read_off(self, value: f64, system: System) -> String {
        self.quantity.read_off(value, system.unit(self.unit))
    }

    /// The number of [`read_off`](Self::read_off) without the unit.
    pub(crate) fn read_off_number(self, value: f64, system: System) -> String {
        self.quantity
            .number_text(value, system.unit(self.unit), Digits::LaunchMonitor)
    }

    /// SI size of the unit that `system` uses in place of this unit ([`System::unit`]).
    pub fn size_in(self, system: System) -> f64 {
        let unit = system.unit(self.unit);
        self.quantity.size_of(unit).unwrap_or(1.0)
    }
}
