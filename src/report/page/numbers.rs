//! Numbers of a page, in both systems of units.

use crate::drive::Outcome;
use crate::report::frame::both;
use crate::report::shown;
use crate::units::leading_number;
use maud::Markup;

/// The value of an outcome; a dash if there is no value.
pub(super) fn outcome(of: Outcome, found: Option<f64>) -> Markup {
    both(|system| shown::outcome_or_dash(of, found, system))
}

/// A change with its unit at the end only: "9.5 → 6.70 deg". A text that does not begin with a
/// number stays whole.
pub(super) fn from_to(from: &str, to: &str) -> String {
    fn unit(text: &str) -> Option<&str> {
        let number = leading_number(text);
        let is_number = number.contains(|c: char| c.is_ascii_digit());
        is_number.then(|| &text[number.len()..])
    }
    let from = match (unit(from), unit(to)) {
        (Some(unit), Some(of_to)) if unit == of_to => leading_number(from),
        _ => from,
    };
    format!("{from} → {to}")
}

#[cfg(test)]
mod tests {
    use super::from_to;

    #[test]
    fn a_unit_is_printed_once() {
        assert_eq!(from_to("9.5 deg", "6.70 deg"), "9.5 → 6.70 deg");
        assert_eq!(from_to("-0.9°", "5.0°"), "-0.9 → 5.0°");
        assert_eq!(from_to("−0.9°", "5.0°"), "−0.9 → 5.0°");
        assert_eq!(from_to("0.03 1/s", "0.05 1/s"), "0.03 → 0.05 1/s");
        assert_eq!(from_to("3.2 yd L", "1.0 yd R"), "3.2 yd L → 1.0 yd R");
        assert_eq!(from_to("none", "3 deg"), "none → 3 deg");
        assert_eq!(
            from_to("launch-monitor", "ferguson"),
            "launch-monitor → ferguson"
        );
        assert_eq!(from_to("every-2nd", "each-2nd"), "every-2nd → each-2nd");
    }
}
