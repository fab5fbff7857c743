use super::Quantity;

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
