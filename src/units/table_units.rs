use super::{DisplayUnit, System};

/// Units of the columns of a CSV table: SI units, or the units of a system.
///
/// ```
/// use longdrive::units::{DisplayUnit, Quantity, System, TableUnits};
/// let speed = DisplayUnit { quantity: Quantity::SPEED, unit: "mph" };
/// assert_eq!(TableUnits::Si.head("swing.speed", speed), "swing.speed [m/s]");
/// let us = TableUnits::Of(System::Us);
/// assert_eq!(us.head("swing.speed", speed), "swing.speed [mph]");
/// assert_eq!(us.number(44.704, speed), 100.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TableUnits {
    /// SI units and radians.
    #[default]
    Si,
    /// The units of this system, as in texts.
    Of(System),
}

impl From<Option<System>> for TableUnits {
    /// The units of the stated system; SI units if no system is stated.
    fn from(stated: Option<System>) -> Self {
        stated.map_or(Self::Si, Self::Of)
    }
}

impl TableUnits {
    /// The unit of a column.
    pub fn unit(self, of: impl Into<DisplayUnit>) -> &'static str {
        let DisplayUnit { quantity, unit } = of.into();
        match self {
            Self::Si => quantity.si,
            Self::Of(system) => system.unit(unit),
        }
    }

    /// Column head: the name with its unit.
    pub fn head(self, name: &str, of: impl Into<DisplayUnit>) -> String {
        match self.unit(of) {
            "" => name.into(),
            unit => format!("{name} [{unit}]"),
        }
    }

    /// An SI value as a number in the unit of its column.
    pub fn number(self, value: f64, of: impl Into<DisplayUnit>) -> f64 {
        let DisplayUnit { quantity, unit } = of.into();
        match self {
            Self::Si => value,
            Self::Of(system) => quantity.number_in(value, system.unit(unit)),
        }
    }
}
