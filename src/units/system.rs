use super::{DisplayUnit, Quantity};

/// System of units for results.
///
/// ```
/// use longdrive::units::System;
/// assert_eq!((System::Metric.unit("yd"), System::Us.unit("yd")), ("m", "yd"));
/// assert_eq!((System::Metric.unit("mph"), System::Us.unit("m/s")), ("m/s", "mph"));
/// assert_eq!((System::Metric.unit("degC"), System::Us.unit("degC")), ("degC", "degF"));
/// assert_eq!((System::Metric.unit("ft"), System::Us.unit("ft")), ("m", "ft"));
/// assert_eq!(System::Metric.unit("deg"), "deg"); // like rpm, g and mm, in both systems
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum System {
    /// Metres and metres per second.
    Metric,
    /// Yards and miles per hour.
    #[default]
    Us,
}

variant_names! {
    /// Name on the command line, and in JSON: `metric`, `us`.
    System as "System" {
        Metric = "metric",
        Us = "us",
    }
}

impl System {
    /// The other system.
    pub fn other(self) -> Self {
        match self {
            Self::Metric => Self::Us,
            Self::Us => Self::Metric,
        }
    }

    /// The unit of this system for a unit of either system: yards for metres, miles per hour for
    /// metres per second, and vice versa. In the US system, feet stay feet (altitudes), and
    /// millimetres stay millimetres (strikes on the face).
    pub fn unit(self, unit: &'static str) -> &'static str {
        let mut pairs = Quantity::ALL.iter().flat_map(|known| known.metric_and_us);
        match self {
            Self::Metric => pairs
                .find(|(_, us)| *us == unit)
                .map_or(unit, |(metric, _)| metric),
            Self::Us if unit == "mm" => unit,
            Self::Us => pairs
                .find(|(metric, _)| *metric == unit)
                .map_or(unit, |(_, us)| us),
        }
    }
}

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
