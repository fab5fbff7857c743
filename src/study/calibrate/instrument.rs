//! Measurement uncertainty of launch monitors: default standard uncertainties for columns without a
//! sigma.

use crate::drive::{Instrument, Outcome};

/// The measurement uncertainty of an outcome, with its value in SI; `None` if it is unknown.
///
/// ```
/// use longdrive::Outcome;
/// use longdrive::study::calibrate::instrument;
/// let (angle, sigma) = instrument(Outcome::LaunchAngle).unwrap();
/// assert_eq!((angle.sigma, sigma), ("0.3 deg", 0.3_f64.to_radians()));
/// ```
pub fn instrument(outcome: Outcome) -> Option<(&'static Instrument, f64)> {
    let instrument = outcome.instrument()?;
    Some((instrument, outcome.quantity().read(instrument.sigma).ok()?))
}

#[cfg(test)]
mod tests {
    use super::instrument;
    use crate::Outcome;
    use crate::units::System;

    #[test]
    fn every_outcome_has_an_uncertainty_above_0_with_a_source() {
        for outcome in Outcome::ALL {
            let (found, sigma) =
                instrument(*outcome).unwrap_or_else(|| panic!("{} has none", outcome.name()));
            let source = found.source().to_string();
            assert!(
                sigma > 0.0 && sigma.is_finite() && !source.is_empty(),
                "{}",
                outcome.name()
            );
            // quantities in braces are parsed and then printed in the units of either system
            assert!(!source.contains(['{', '}']), "{source}");
            let metric = found.source().in_units(System::Metric);
            assert!(
                !metric.contains(" yd") && !metric.contains(" mph"),
                "{metric}"
            );
        }
    }
}
