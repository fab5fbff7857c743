//! Displayed numbers, with as many digits as a launch monitor shows.

use super::spelling::{leading_number, with_unit};
use super::{Digits, Quantity, significant};

/// Significant digits of a number in a unit for which `quantities!` states no decimals.
const DIGITS: usize = 5;

/// Absolute value, in the displayed unit, below which a number is a rounding error.
const NOISE: f64 = 1e-6;

/// Absolute value from which numbers are displayed with significant digits instead of decimals.
const LARGE: f64 = 1e9;

impl Quantity {
    /// An SI value as text in `unit`, with as many digits as a launch monitor shows.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert_eq!(Quantity::SPEED.read_off(72.4216, "mph"), "162.0 mph");
    /// assert_eq!(Quantity::LENGTH.read_off(-2.3e-15, "yd"), "0.0 yd");
    /// assert_eq!(Quantity::DENSITY.read_off(1.184, "kg/m^3"), "1.184 kg/m³");
    /// ```
    pub fn read_off(self, value: f64, unit: &str) -> String {
        self.text(value, unit, Digits::LaunchMonitor)
    }

    /// An SI value as text in `unit`, with these digits.
    ///
    /// ```
    /// use longdrive::units::{Digits, Quantity};
    /// assert_eq!(Quantity::ANGLE.text(0.2, "deg", Digits::Fine), "11.46°");
    /// assert_eq!(Quantity::TIME.text(0.12345, "s", Digits::Difference), "0.123 s");
    /// assert_eq!(Quantity::TIME.text(0.000512, "s", Digits::Difference), "0.00051 s");
    /// assert_eq!(Quantity::LENGTH.text(1e-13, "m", Digits::Difference), "0.00 m");
    /// ```
    pub fn text(self, value: f64, unit: &str, digits: Digits) -> String {
        with_unit(&self.number_text(value, unit, digits), unit)
    }

    /// The text of a value in `unit`, without the unit.
    pub(super) fn number_text(self, value: f64, unit: &str, digits: Digits) -> String {
        let number = match digits {
            // a difference does not count from the zero of a temperature scale
            Digits::Difference => value / self.size_of(unit).unwrap_or(1.0),
            _ => self.number_in(value, unit),
        };
        match (digits, self.decimals_of(number, unit)) {
            (Digits::Significant(digits), _) => significant(number, digits),
            (_, None) => significant(number, DIGITS),
            (Digits::LaunchMonitor, Some(decimals)) => fixed(number, decimals),
            (Digits::Fine, Some(decimals)) => fixed(number, decimals + 1),
            (Digits::Difference, Some(decimals)) => {
                let size = number.abs();
                let needed = if size < NOISE {
                    0
                } else {
                    (1.0 - size.log10().floor()).max(0.0) as usize
                };
                fixed(number, needed.max(decimals + 1))
            }
        }
    }

    /// Number of decimals of a number in `unit`. `None` for a large number, and for a unit for
    /// which `quantities!` states no decimals: these are shown with significant digits.
    fn decimals_of(self, number: f64, unit: &str) -> Option<usize> {
        let (_, decimals) = self.decimals.iter().find(|(known, _)| *known == unit)?;
        (number.abs() < LARGE).then_some(*decimals)
    }
}

/// A count with its noun: "1 drive", "2 drives".
///
/// ```
/// use longdrive::units::counted;
/// assert_eq!((counted(1, "drive"), counted(0, "shot")), ("1 drive".into(), "0 shots".into()));
/// ```
pub fn counted(count: u64, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

/// A part of a count with its noun: "1 of 2 drives", "the only drive". Words that follow this text
/// must fit singular and plural.
///
/// ```
/// use longdrive::units::counted_of;
/// assert_eq!(counted_of(1, 2, ["search", "searches"]), "1 of 2 searches");
/// assert_eq!(counted_of(1, 1, ["search", "searches"]), "the only search");
/// ```
pub fn counted_of(part: u64, all: u64, [one, several]: [&str; 2]) -> String {
    match (part, all) {
        (1, 1) => format!("the only {one}"),
        (part, 1) => format!("{part} of 1 {one}"),
        (part, all) => format!("{part} of {all} {several}"),
    }
}

/// A number with this many decimals; zero without a sign.
pub(crate) fn fixed(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    if is_zero(&text) {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// The text of a number, with a plus sign if the number is positive and its text is not zero. The
/// text may include a unit.
pub(crate) fn signed(number: f64, text: String) -> String {
    if number > 0.0 && !is_zero(leading_number(&text)) {
        format!("+{text}")
    } else {
        text
    }
}

/// True if the text of a number is zero.
pub(crate) fn is_zero(text: &str) -> bool {
    text.bytes()
        .all(|digit| matches!(digit, b'-' | b'.' | b'0'))
}

#[cfg(test)]
mod tests {
    use super::{Digits, Quantity, fixed, signed};

    #[test]
    fn exact_digits_of_a_launch_monitor() {
        for (quantity, si, unit, shown) in [
            (Quantity::SPEED, 72.4216, "mph", "162.0 mph"),
            (Quantity::ANGLE, 0.1309, "deg", "7.5°"),
            (Quantity::ANGULAR_VELOCITY, 213.1, "rpm", "2035 rpm"),
            (Quantity::LENGTH, 229.6, "yd", "251.1 yd"),
            (Quantity::NUMBER, 1.4741, "", "1.47"),
            (Quantity::TIME, 7.0849, "s", "7.08 s"),
        ] {
            assert_eq!(quantity.read_off(si, unit), shown);
        }
    }

    #[test]
    fn rounding_has_no_digits_and_no_sign() {
        for value in [-2.2645e-15, 0.0, -0.0, -0.04] {
            assert_eq!(Quantity::LENGTH.read_off(value, "m"), "0.0 m");
        }
        assert_eq!(Quantity::ANGULAR_VELOCITY.read_off(-1e-14, "rpm"), "0 rpm");
        assert_eq!(
            Quantity::LENGTH.text(-1e-9, "m", Digits::Difference),
            "0.00 m"
        );
        let written = [0.004, -0.004, 0.006, -0.006]
            .map(|number| signed(number, format!("{} yd", fixed(number, 2))));
        assert_eq!(written, ["0.00 yd", "0.00 yd", "+0.01 yd", "-0.01 yd"]);
        assert_eq!(Quantity::LENGTH.read_off(1e300, "m"), "1e300 m");
        assert_eq!(Quantity::LENGTH.read_off(f64::INFINITY, "mm"), "inf mm");
    }
}
