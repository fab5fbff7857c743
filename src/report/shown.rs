//! Numbers as people read them: in the units of a system, with the digits of a launch monitor, and to the right or left.

use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::units::{Quantity, System, per, significant};

/// What stands where there is no number.
pub(super) const NONE: &str = "–";

/// The name of an outcome or parameter in words: "ball speed", "swing speed"; a word of the group that the name repeats stands once:
/// "launch angle" for `launch.launch_angle`.
pub(super) fn words(name: &str) -> String {
    let own = name.split_once('.').filter(|(group, rest)| rest.split(['.', '_']).any(|word| word == *group));
    own.map_or(name, |(_, rest)| rest).replace(['.', '_'], " ")
}

/// Whether an outcome is positive to the right.
fn is_sideways(of: Outcome) -> bool {
    matches!(of, Outcome::Lateral | Outcome::LaunchDirection | Outcome::Sidespin | Outcome::SpinAxis)
}

/// The value of an outcome: "162.0 mph", "3.2 yd R".
pub fn outcome(of: Outcome, value: f64, system: System) -> String {
    let unit = system.unit(of.unit());
    if is_sideways(of) { side(of.quantity(), unit, value) } else { of.quantity().read_off(value, unit) }
}

/// A value that is positive to the right: "3.2 yd R", "3.2 yd L", and "0.0 yd" without a side.
pub(super) fn side(quantity: Quantity, unit: &str, value: f64) -> String {
    let size = quantity.read_off(value.abs(), unit);
    let is_straight = size.split(' ').next().is_some_and(|number| number.bytes().all(|digit| b"0.".contains(&digit)));
    match value {
        _ if is_straight => size,
        0.0.. => format!("{size} R"),
        _ => format!("{size} L"),
    }
}

/// The same with one decimal more, to compare two that are close.
pub(super) fn finely(of: Outcome, value: f64, system: System) -> String {
    of.quantity().read_off_finely(value, system.unit(of.unit()))
}

/// The value of an outcome, with a dash where the drive has none.
pub(super) fn outcome_or_dash(of: Outcome, value: Option<f64>, system: System) -> String {
    value.map_or(NONE.into(), |value| outcome(of, value, system))
}

/// The value of an outcome in the units of the other system, in parentheses; empty where both are the same.
pub(super) fn in_parentheses(of: Outcome, value: f64, system: System) -> String {
    let other = system.other();
    if system.unit(of.unit()) == other.unit(of.unit()) {
        String::new()
    } else {
        format!("({})", outcome(of, value, other))
    }
}

/// The value of an outcome in both systems: "279.2 yd (255.3 m)".
pub(super) fn both(of: Outcome, value: f64, system: System) -> String {
    format!("{} {}", outcome(of, value, system), in_parentheses(of, value, system)).trim_end().to_owned()
}

/// A standard deviation or loss of an outcome.
pub(super) fn spread(of: Outcome, value: f64, system: System) -> String {
    of.quantity().read_off_difference(value, system.unit(of.unit()))
}

/// A change of an outcome, with its sign.
pub(super) fn change(of: Outcome, value: f64, system: System) -> String {
    let text = spread(of, value, system);
    if value > 0.0 { format!("+{text}") } else { text }
}

/// A value of a parameter that was computed: an optimum, the end of a window.
pub(super) fn parameter(parameter: &Parameter, value: f64, system: System) -> String {
    computed(parameter, value, system.unit(parameter.unit))
}

/// The same in the unit that the parameter is declared in, as setup files write its value.
pub(super) fn as_declared(parameter: &Parameter, value: f64) -> String {
    computed(parameter, value, parameter.unit)
}

fn computed(parameter: &Parameter, value: f64, unit: &str) -> String {
    if parameter.quantity == Quantity::NUMBER {
        return significant(value, 5);
    }
    parameter.quantity.read_off_finely(value, unit)
}

/// A value of a parameter that was stated: with the digits that it has, and no more.
pub fn stated(parameter: &Parameter, value: f64, system: System) -> String {
    let unit = system.unit(parameter.unit);
    let number = value / parameter.quantity.size_of(unit).unwrap_or(1.0);
    format!("{} {unit}", significant(number, 5)).trim_end().to_owned()
}

/// A derivative of an outcome by a parameter, in the units of a system: "2.11 yd per deg".
pub(super) fn slope(of: Outcome, by: &Parameter, value: f64, system: System, digits: usize) -> String {
    ratio((of.quantity(), of.unit()), (by.quantity, by.unit), value, system, digits)
}

/// A quotient of two quantities in the units of a system.
pub(super) fn ratio(
    of: (Quantity, &'static str),
    by: (Quantity, &'static str),
    value: f64,
    system: System,
    digits: usize,
) -> String {
    let (of_unit, by_unit) = (system.unit(of.1), system.unit(by.1));
    let size = |quantity: Quantity, unit| quantity.size_of(unit).unwrap_or(1.0);
    let number = significant(value * size(by.0, by_unit) / size(of.0, of_unit), digits);
    format!("{number} {}", per(of_unit, by_unit)).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{Outcome, System, both, change, outcome, words};
    use crate::Setup;
    use crate::parameters::Law;

    #[test]
    fn no_name_has_a_word_twice() {
        let setup = Setup::default();
        let parameters = setup.parameters().into_iter().chain(Law::all_rows()).map(|row| row.name);
        for name in parameters.chain(Outcome::ALL.iter().map(|of| of.name())) {
            let words = words(name);
            let mut seen: Vec<&str> = words.split(' ').collect();
            seen.sort_unstable();
            assert!(seen.windows(2).all(|pair| pair[0] != pair[1]), "{words}");
        }
        assert_eq!(words("launch.launch_angle"), "launch angle");
        assert_eq!(
            (words("launch.ball_speed"), words("club.inertia.xx")),
            ("launch ball speed".into(), "club inertia xx".into())
        );
    }

    #[test]
    fn exact_sides_and_both_systems() {
        for (value, shown) in [(2.92608, "3.2 yd R"), (-2.92608, "3.2 yd L"), (-1e-15, "0.0 yd"), (0.0, "0.0 yd")] {
            assert_eq!(outcome(Outcome::Lateral, value, System::Us), shown);
        }
        assert_eq!(both(Outcome::Carry, 91.44, System::Us), "100.0 yd (91.4 m)");
        assert_eq!(both(Outcome::Carry, 91.44, System::Metric), "91.4 m (100.0 yd)");
        assert_eq!(both(Outcome::LaunchAngle, 0.1309, System::Metric), "7.5 deg");
        assert_eq!(both(Outcome::Lateral, -9.144, System::Metric), "9.1 m L (10.0 yd L)");
        assert_eq!(change(Outcome::Carry, 0.9144, System::Us), "+1.00 yd");
        assert_eq!(change(Outcome::Carry, -0.9144, System::Us), "-1.00 yd");
    }
}
