//! Measurement uncertainty of launch monitors: default standard uncertainties for columns without a
//! sigma.

use crate::drive::Outcome;
use crate::units::{Digits, Message, Quantity};

/// Standard uncertainty of an outcome as a launch monitor measures it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instrument {
    /// The outcome.
    pub outcome: Outcome,
    /// Standard uncertainty of the outcome, with unit: `0.3 deg`.
    pub sigma: &'static str,
    /// Source, or "assumed" with the reasoning if no source was found. Braces enclose lengths and
    /// speeds, which are printed in the user's units.
    source: &'static str,
}

impl Instrument {
    /// The source of the uncertainty, or the reasoning behind an assumption.
    pub fn source(&self) -> Message {
        let parts = self.source.split(['{', '}']).enumerate();
        parts.fold(Message::default(), |message, (i, part)| {
            match quantity(part) {
                Some((quantity, unit, value)) if i % 2 == 1 => {
                    message.quantity(quantity, unit, value, Digits::Significant(2))
                }
                _ => message.words(part),
            }
        })
    }
}

/// Parses a length or a speed.
fn quantity(text: &str) -> Option<(Quantity, &'static str, f64)> {
    let kinds = [(Quantity::LENGTH, "yd"), (Quantity::SPEED, "mph")];
    kinds
        .into_iter()
        .find_map(|(quantity, unit)| Some((quantity, unit, quantity.read(text).ok()?)))
}

/// Ball speed: two radar units agree to about ±0.5 %
/// (golflaunchlab.com/guides/golf-launch-monitor-accuracy, read in a stored copy; it names no
/// test), 0.8 mph of 165 mph. Neither a maker's data sheet nor the numbers of Leach, Forrester,
/// Mears & Roberts (Measurement 112, 2017, 125–136) could be read.
const AGREE: &str = "two radar units agree to about 0.5 % (golflaunchlab.com, a guide that names \
                     no test): {0.8 mph} of {165 mph}, rounded up";
/// Launch angles: no source found.
const TENTHS: &str = "assumed: three times the resolution of exports, 0.1°";
/// Spin: no source found.
const OF_SPIN: &str = "assumed: 4 % of a driver's 2500 rpm";
/// Distances: difference between launch monitors for the same launch.
const APART: &str =
    "launch monitors predict the same launch within about {3 yd} of each other (docs/sources.md)";
/// Totals: differences of two monitors on the same shots (Bliss & Langdown 2026), whose ground
/// models differ.
const RUNS: &str = "the totals of two monitors on the same shots differ by {11.5 yd} (one standard \
                    deviation): {8 yd} each, docs/sources.md";
/// Apex height and descent angle: published averages are rounded to whole yards and degrees.
const ROUNDED: &str = "assumed: tables print whole units of length and whole degrees; indoors \
                       both are computed from the launch";

/// All known or assumed uncertainties.
const INSTRUMENTS: &[Instrument] = &[
    Instrument {
        outcome: Outcome::BallSpeed,
        sigma: "1 mph",
        source: AGREE,
    },
    Instrument {
        outcome: Outcome::LaunchAngle,
        sigma: "0.3 deg",
        source: TENTHS,
    },
    Instrument {
        outcome: Outcome::LaunchDirection,
        sigma: "0.3 deg",
        source: TENTHS,
    },
    Instrument {
        outcome: Outcome::Spin,
        sigma: "100 rpm",
        source: OF_SPIN,
    },
    Instrument {
        outcome: Outcome::Backspin,
        sigma: "100 rpm",
        source: OF_SPIN,
    },
    Instrument {
        outcome: Outcome::Sidespin,
        sigma: "100 rpm",
        source: "assumed: as for spin",
    },
    Instrument {
        outcome: Outcome::SpinAxis,
        sigma: "2 deg",
        source: "assumed: 100 rpm across a spin of 2700 rpm turn the axis by 2.1 deg",
    },
    Instrument {
        outcome: Outcome::SmashFactor,
        sigma: "0.02",
        source: "assumed: {1 mph} of the ball and {1.5 mph} of the club, of a ratio of 1.48",
    },
    Instrument {
        outcome: Outcome::Carry,
        sigma: "3 yd",
        source: APART,
    },
    Instrument {
        outcome: Outcome::CarryDistance,
        sigma: "3 yd",
        source: APART,
    },
    Instrument {
        outcome: Outcome::Lateral,
        sigma: "3 yd",
        source: "assumed: 0.7 deg of direction at {250 yd}",
    },
    Instrument {
        outcome: Outcome::ApexHeight,
        sigma: "1 yd",
        source: ROUNDED,
    },
    Instrument {
        outcome: Outcome::ApexDownrange,
        sigma: "3 yd",
        source: "assumed: as for carry",
    },
    Instrument {
        outcome: Outcome::ApexTime,
        sigma: "0.1 s",
        source: "assumed: as for flight_time",
    },
    Instrument {
        outcome: Outcome::FlightTime,
        sigma: "0.1 s",
        source: "assumed: tables print tenths of a second; indoors times are computed from the \
                 launch",
    },
    Instrument {
        outcome: Outcome::DescentAngle,
        sigma: "1 deg",
        source: ROUNDED,
    },
    Instrument {
        outcome: Outcome::LandingSpeed,
        sigma: "1 mph",
        source: "assumed: as for ball_speed",
    },
    Instrument {
        outcome: Outcome::Total,
        sigma: "8 yd",
        source: RUNS,
    },
    Instrument {
        outcome: Outcome::Run,
        sigma: "8 yd",
        source: RUNS,
    },
    Instrument {
        outcome: Outcome::LateralTotal,
        sigma: "8 yd",
        source: "assumed: as for total",
    },
];

/// The measurement uncertainty of an outcome, with its value in SI; `None` if nothing is known.
///
/// ```
/// use longdrive::Outcome;
/// use longdrive::study::calibrate::instrument;
/// let (angle, sigma) = instrument(Outcome::LaunchAngle).unwrap();
/// assert_eq!((angle.sigma, sigma), ("0.3 deg", 0.3_f64.to_radians()));
/// ```
pub fn instrument(outcome: Outcome) -> Option<(&'static Instrument, f64)> {
    let found = INSTRUMENTS
        .iter()
        .find(|instrument| instrument.outcome == outcome)?;
    let quantity: Quantity = outcome.quantity();
    Some((found, quantity.read(found.sigma).ok()?))
}

#[cfg(test)]
mod tests {
    use super::{INSTRUMENTS, instrument};
    use crate::Outcome;
    use crate::units::System;

    #[test]
    fn every_outcome_has_one_uncertainty_above_0_with_a_source() {
        for outcome in Outcome::ALL {
            let (found, sigma) =
                instrument(*outcome).unwrap_or_else(|| panic!("{} has none", outcome.name()));
            let source = found.source().to_string();
            assert!(
                sigma > 0.0 && sigma.is_finite() && !source.is_empty(),
                "{}",
                outcome.name()
            );
            // a quantity in braces parses, and prints in the units of either system
            assert!(!source.contains(['{', '}']), "{source}");
            let metric = found.source().in_units(System::Metric);
            assert!(
                !metric.contains(" yd") && !metric.contains(" mph"),
                "{metric}"
            );
        }
        assert_eq!(INSTRUMENTS.len(), Outcome::ALL.len());
    }
}
