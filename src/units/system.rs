use std::fmt;

/// System of units for results.
///
/// ```
/// use longdrive::units::System;
/// assert_eq!((System::Metric.unit("yd"), System::Us.unit("yd")), ("m", "yd"));
/// assert_eq!((System::Metric.unit("mph"), System::Us.unit("m/s")), ("m/s", "mph"));
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

/// Pairs of metric and US units.
const PAIRS: [(&str, &str); 3] = [("m", "yd"), ("m/s", "mph"), ("mm", "in")];

impl System {
    /// Both systems.
    pub const ALL: [Self; 2] = [Self::Metric, Self::Us];

    /// Name on the command line: `metric`, `us`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Metric => "metric",
            Self::Us => "us",
        }
    }

    /// The other system.
    pub fn other(self) -> Self {
        match self {
            Self::Metric => Self::Us,
            Self::Us => Self::Metric,
        }
    }

    /// The unit of this system for a unit of either system: yards for metres, miles per hour for
    /// metres per second, and vice versa. Millimetres, for strikes on the face, belong to both.
    pub fn unit(self, unit: &'static str) -> &'static str {
        match self {
            Self::Metric => PAIRS
                .iter()
                .find(|(_, us)| *us == unit)
                .map_or(unit, |(metric, _)| metric),
            Self::Us if unit == "mm" => unit,
            Self::Us => PAIRS
                .iter()
                .find(|(metric, _)| *metric == unit)
                .map_or(unit, |(_, us)| us),
        }
    }
}

impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
