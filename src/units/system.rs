use std::fmt;

/// The units that results are shown in.
///
/// ```
/// use longdrive::units::System;
/// assert_eq!((System::Metric.unit("yd"), System::Us.unit("yd")), ("m", "yd"));
/// assert_eq!((System::Metric.unit("mph"), System::Us.unit("m/s")), ("m/s", "mph"));
/// assert_eq!(System::Metric.unit("deg"), "deg"); // and rpm, g, mm: the same for golfers everywhere
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum System {
    /// Metres and metres per second.
    Metric,
    /// Yards and miles per hour.
    #[default]
    Us,
}

/// Units that differ, metric and US.
const PAIRS: [(&str, &str); 3] = [("m", "yd"), ("m/s", "mph"), ("mm", "in")];

impl System {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Metric, Self::Us];

    /// Its name on the command line: `metric`, `us`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Metric => "metric",
            Self::Us => "us",
        }
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::Metric => Self::Us,
            Self::Us => Self::Metric,
        }
    }

    /// The unit that stands in this system for a unit that golfers read: yards for metres, miles
    /// per hour for metres per second, and the other way. Millimetres on the clubface are read
    /// everywhere and stay.
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
