//! Numbers formatted for people: in the units of a system, with the digits of a launch monitor, and
//! with R or L in place of a sign.

use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup, UNSET, Vary};
use crate::study::{Active, Constraint, Effect, Effects, Goal, Search, Sigma, SigmaEffect};
use crate::units::{
    Digits, DisplayUnit, Message, Quantity, System, is_zero, leading_number, one, per, signed,
    significant, with_unit,
};

/// The text for a missing number.
pub(super) const NONE: &str = "–";

/// A remark about strikes off the centre.
pub(super) const GEAR_EFFECT: &str =
    "the gear effect of strikes off the centre is known to about 30 %";

/// The remark on the gear effect for a strike towards the toe or the heel, with the consequence for
/// the curve. `None` for any other strike, and for a stated launch.
pub(super) fn gear_effect(setup: &Setup<f64>) -> Option<String> {
    let is_off_centre = !setup.launch.is_given() && setup.strike.toe != 0.0;
    is_off_centre.then(|| format!("{GEAR_EFFECT}, so the curve may be to the other side"))
}

/// Parameters that have another name on launch monitors.
const NAMES: [(&str, &str); 2] = [("swing.speed", "club speed"), ("swing.path", "club path")];

/// Groups of parameters whose name [`words`] omits.
const IMPLIED: [&str; 3] = ["swing", "launch", "aero"];

/// The name of an outcome or parameter in words, as on launch monitors: "ball speed", "attack
/// angle", "club speed". The name of the group is omitted if it is in `IMPLIED`, or if the rest of
/// the name contains it. Otherwise it stays: `wind.reference_height` is "wind reference height".
pub(super) fn words(name: &str) -> String {
    if let Some((_, words)) = NAMES.iter().find(|(known, _)| *known == name) {
        return (*words).into();
    }
    let is_without = |group: &str, rest: &str| {
        IMPLIED.contains(&group) || rest.split(['.', '_']).any(|word| word == group)
    };
    let own = name
        .split_once('.')
        .filter(|(group, rest)| is_without(group, rest));
    own.map_or(name, |(_, rest)| rest).replace(['.', '_'], " ")
}

/// A text with a capital first letter.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// Replaces the names of parameters in a sentence by words: `swing.speed` becomes "club speed".
/// Command-line input (`swing.speed=95mph`) stays unchanged.
pub(super) fn spoken(sentence: &str) -> String {
    let setup = Setup::modern_driver();
    let speak = |word: &str| {
        let name = word.trim_matches([',', ';', ':', '(', ')']);
        let is_spoken = word.contains('.') && !word.contains('=') && setup.parameter(name).is_ok();
        if is_spoken {
            word.replace(name, &words(name))
        } else {
            word.to_owned()
        }
    };
    sentence.split(' ').map(speak).collect::<Vec<_>>().join(" ")
}

/// The value of an outcome: "162.0 mph", "3.2 yd R".
pub fn outcome(of: Outcome, value: f64, system: System) -> String {
    if of.is_to_the_right() {
        side(of, value, system)
    } else {
        DisplayUnit::from(of).read_off(value, system)
    }
}

/// The value of a goal. A goal that is an outcome has the format of the outcome.
pub fn goal(goal: &Goal, value: f64, system: System) -> String {
    match (goal.outcome(), goal.unit) {
        (Some(of), _) => outcome(of, value, system),
        (None, "") => significant(value, 4),
        (None, _) => DisplayUnit::from(goal).read_off(value, system),
    }
}

/// A value with R (right) for a positive sign and L (left) for a negative sign: "3.2 yd R", "3.2 yd
/// L", "0.0 yd".
pub(super) fn side(of: impl Into<DisplayUnit>, value: f64, system: System) -> String {
    let size = of.into().read_off(value.abs(), system);
    match value {
        _ if is_zero(leading_number(&size)) => size,
        0.0.. => format!("{size} R"),
        _ => format!("{size} L"),
    }
}

/// The value of an outcome; a dash if the drive does not have it.
pub(super) fn outcome_or_dash(of: Outcome, value: Option<f64>, system: System) -> String {
    value.map_or(NONE.into(), |value| outcome(of, value, system))
}

/// The number of a value without its unit, for a table with the unit in its head; a dash without a
/// value.
pub(super) fn number_or_dash(
    of: impl Into<DisplayUnit>,
    value: Option<f64>,
    system: System,
) -> String {
    value.map_or(NONE.into(), |value| {
        of.into().read_off_number(value, system)
    })
}

/// The number of a difference with its sign, like [`number_or_dash`].
pub(super) fn signed_or_dash(
    of: impl Into<DisplayUnit>,
    value: Option<f64>,
    system: System,
) -> String {
    signed(value.unwrap_or_default(), number_or_dash(of, value, system))
}

/// The value of a goal; a dash without a value.
pub(super) fn goal_or_dash(of: &Goal, value: Option<f64>, system: System) -> String {
    value.map_or(NONE.into(), |value| goal(of, value, system))
}

/// The value of an outcome in the units of the other system, in parentheses; empty if the units are
/// equal.
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
    format!(
        "{} {}",
        outcome(of, value, system),
        in_parentheses(of, value, system)
    )
    .trim_end()
    .to_owned()
}

/// A difference, standard deviation or loss of an outcome or parameter.
pub(super) fn difference(of: impl Into<DisplayUnit>, value: f64, system: System) -> String {
    let DisplayUnit { quantity, unit } = of.into();
    quantity.text(value, system.unit(unit), Digits::Difference)
}

/// A difference of a goal.
pub(super) fn goal_difference(goal: &Goal, value: f64, system: System) -> String {
    match goal.unit {
        "" => significant(value, 2),
        _ => difference(goal, value, system),
    }
}

/// A change of an outcome or parameter, with its sign.
pub(super) fn change(of: impl Into<DisplayUnit>, value: f64, system: System) -> String {
    signed(value, difference(of, value, system))
}

/// The change of an outcome between two values, with its sign. It is the difference of the
/// displayed values, so that the numbers of a text add up.
pub(super) fn change_as_displayed(of: Outcome, from: f64, to: f64, system: System) -> String {
    let unit = DisplayUnit::from(of);
    let displayed = |value: f64| {
        let number = unit.read_off_number(value, system);
        number
            .parse::<f64>()
            .map_or(value, |number| number * unit.size_in(system))
    };
    let change = displayed(of.unwrap_angle(to, from)) - displayed(from);
    signed(change, unit.read_off(change, system))
}

/// The change of one parameter in a step along a direction, always with a sign: "+1.20 deg".
pub(super) fn component(parameter: &Parameter, amount: f64, system: System) -> String {
    let sign = if amount < 0.0 { "-" } else { "+" };
    format!("{sign}{}", difference(parameter, amount.abs(), system))
}

/// A computed value of a parameter, such as an optimum or the end of a window.
pub fn parameter(parameter: &Parameter, value: f64, system: System) -> String {
    computed(parameter, value).in_units(system)
}

/// A computed value of a parameter. In its declared unit it is the value of a setup file.
pub(super) fn computed(parameter: &Parameter, value: f64) -> Message {
    let digits = if parameter.quantity == Quantity::NUMBER {
        Digits::Significant(5)
    } else {
        Digits::Fine
    };
    Message::default().quantity(parameter.quantity, parameter.unit, value, digits)
}

/// The QP solver may stop slightly inside a bound. A value is therefore at an end of its range if
/// the distance from the end is at most this fraction of the range.
pub(super) const END_TOLERANCE: f64 = 1e-6;

/// A value of a varied parameter, with enough digits to distinguish the value from the ends of the
/// range. A value within [`END_TOLERANCE`] of an end may look like the end.
pub(super) fn within(vary: &Vary, value: f64, system: System) -> String {
    let (parameter, ends) = (vary.parameter, ends(vary, system));
    let number = |text: &str| leading_number(text).parse::<f64>().ok();
    let is_apart = |text: &String| {
        let ends = [vary.low, vary.high].into_iter().zip(&ends);
        let is_apart = |end: f64| (end - value).abs() > END_TOLERANCE * (vary.high - vary.low);
        ends.filter(|(end, _)| is_apart(*end))
            .all(|(_, end)| number(text) != number(end))
    };
    let plain = self::parameter(parameter, value, system);
    let finer = (2..=MOST_DIGITS).map(|digits| with_digits(parameter, value, system, digits));
    std::iter::once(plain.clone())
        .chain(finer)
        .find(is_apart)
        .unwrap_or(plain)
}

/// Significant digits that distinguish all double-precision numbers.
pub(super) const MOST_DIGITS: usize = 17;

/// The ends of the range of a varied parameter.
pub(super) fn ends(vary: &Vary, system: System) -> [String; 2] {
    stated_apart(vary.parameter, [vary.low, vary.high], system)
}

/// The range of a varied parameter: "4° .. 20°".
pub(super) fn range(vary: &Vary, system: System) -> String {
    ends(vary, system).join(" .. ")
}

/// Two stated numbers, with enough digits to distinguish them.
fn stated_apart(of: impl Into<DisplayUnit>, ends: [f64; 2], system: System) -> [String; 2] {
    let of = of.into();
    let shown = |digits: usize| ends.map(|end| with_digits(of, end, system, digits));
    let apart = (STATED..=MOST_DIGITS)
        .map(shown)
        .find(|[low, high]| ends[0] == ends[1] || low != high);
    apart.unwrap_or_else(|| shown(MOST_DIGITS))
}

/// Maximum number of significant digits of a stated number.
pub(super) const STATED: usize = 5;

/// Maximum number of significant digits of a standard uncertainty.
pub(super) const OF_SIGMA: usize = 3;

/// Maximum number of significant digits of a number in a list of all numbers of a setup.
pub(super) const IN_LIST: usize = 7;

/// Maximum number of significant digits in the summary of a request: "110 mph" is "49.17 m/s" and
/// not "49.174 m/s".
pub(super) const IN_SUMMARY: usize = 4;

/// A stated value of a parameter, without trailing zeros.
pub fn stated(parameter: &Parameter, value: f64, system: System) -> String {
    with_digits(parameter, value, system, STATED)
}

/// A stated difference or uncertainty of a parameter, without trailing zeros: 2.7 °F for 1.5 K.
pub fn stated_difference(parameter: &Parameter, value: f64, system: System) -> String {
    difference_with_digits(parameter, value, system, STATED)
}

/// A difference or uncertainty of a parameter with at most `digits` significant digits.
pub(super) fn difference_with_digits(
    parameter: &Parameter,
    value: f64,
    system: System,
    digits: usize,
) -> String {
    let size = DisplayUnit::from(parameter).size_in(system);
    let number = significant(value / size, digits);
    with_unit(&number, system.unit(parameter.unit))
}

/// A parameter with its standard uncertainty: "club speed ± 0.5 mph".
pub(super) fn with_sigma(sigma: &Sigma, system: System) -> String {
    let name = words(sigma.parameter.name);
    let deviation = difference_with_digits(sigma.parameter, sigma.value, system, OF_SIGMA);
    format!("{name} ± {deviation}")
}

/// A value of a setup with at most `digits` significant digits, or "none".
pub(super) fn setup_value(
    parameter: &Parameter,
    value: Option<f64>,
    system: System,
    digits: usize,
) -> String {
    value.map_or(UNSET.into(), |value| {
        with_digits(parameter, value, system, digits)
    })
}

/// A value with its unit, with at most `digits` significant digits.
pub(super) fn with_digits(
    of: impl Into<DisplayUnit>,
    value: f64,
    system: System,
    digits: usize,
) -> String {
    let DisplayUnit { quantity, unit } = of.into();
    Message::default()
        .quantity(quantity, unit, value, Digits::Significant(digits))
        .in_units(system)
}

/// A constraint in the units of a system: "descent angle ≥ 38°", "lateral = 0 yd", "20 yd ≤ apex
/// height ≤ 35 yd".
pub(super) fn constraint(constraint: &Constraint, system: System) -> String {
    let Constraint {
        goal, low, high, ..
    } = constraint;
    let name = words(&goal.expression);
    let [least, most] = stated_apart(goal, [*low, *high], system);
    match [low, high].map(|end| end.is_finite()) {
        _ if constraint.is_equation() => format!("{name} = {least}"),
        [true, true] => format!("{least} ≤ {name} ≤ {most}"),
        [true, false] => format!("{name} ≥ {least}"),
        _ => format!("{name} ≤ {most}"),
    }
}

/// The constraints of a search, for the end of a sentence about its optimum: ", with descent angle
/// ≥ 38° and apex height ≤ 35 yd". Empty without constraints.
pub fn with_constraints(subject_to: &[Constraint], system: System) -> String {
    if subject_to.is_empty() {
        return String::new();
    }
    let each = subject_to.iter().map(|limit| constraint(limit, system));
    format!(", with {}", each.collect::<Vec<_>>().join(" and "))
}

/// An active bound or constraint: "attack angle at its upper bound", "apex height ≤ 35 yd". `name`
/// formats the name of a parameter.
pub(super) fn active(
    active: &Active,
    search: &Search,
    system: System,
    name: impl Fn(&str) -> String,
) -> String {
    let limit = || {
        search
            .subject_to
            .iter()
            .find(|limit| limit.expression == active.name)
    };
    match active.end {
        Some(_) => Active {
            name: name(&active.name),
            ..active.clone()
        }
        .to_string(),
        None => limit().map_or_else(|| active.to_string(), |limit| constraint(limit, system)),
    }
}

/// Relative size below which a change counts as a rounding error.
const ROUNDING: f64 = 1e-12;

/// Returns `slope`, or 0 if `slope` is only the rounding error of its computation.
///
/// - `value` is the value of the quantity `of`, SI.
/// - `slope` is the first or second derivative of this quantity by the one or two parameters `by`,
///   SI. If `by` is empty, `slope` is a change of the quantity.
///
/// The derivative is a rounding error if |`slope`| times the [typical sizes](typical_size) of the
/// parameters is less than 1e-12 · max(|`value`|, one unit of `of`). A flight has about a thousand
/// operations with a relative rounding error of 1e-16 each: a smaller derivative has no correct
/// digit. The criterion depends neither on the displayed units nor on the values of the parameters,
/// which may be 0. JSON and CSV keep all digits.
pub(super) fn zero_if_rounding(
    slope: f64,
    value: f64,
    of: impl Into<DisplayUnit>,
    by: &[&Parameter],
) -> f64 {
    let sizes = by.iter().map(|by| typical_size(by));
    let change = slope.abs() * sizes.product::<f64>();
    if change < ROUNDING * value.abs().max(of.into().size()) {
        0.0
    } else {
        slope
    }
}

/// The typical size of a parameter, SI: |default|, or one unit if the default is 0 or missing.
pub(super) fn typical_size(parameter: &Parameter) -> f64 {
    let default = parameter.default_value().map(f64::abs);
    default
        .filter(|default| *default > 0.0 && default.is_finite())
        .unwrap_or_else(|| DisplayUnit::from(parameter).size())
}

/// True if a `change` of an outcome is only a rounding error of the outcome's `value`.
pub(super) fn is_rounding(of: Outcome, value: f64, change: f64) -> bool {
    zero_if_rounding(change, value, of, &[]) == 0.0
}

/// True if an outcome depends on the parameter `by`: the first or the second derivative is more
/// than a rounding error of the outcome's `value`.
pub(super) fn depends(of: Outcome, value: f64, by: &Parameter, slope: f64, curvature: f64) -> bool {
    zero_if_rounding(slope, value, of, &[by]) != 0.0
        || zero_if_rounding(curvature, value, of, &[by, by]) != 0.0
}

/// True if an uncertain parameter p has no effect on an outcome. Then the derivatives by p, and the
/// changes of the outcome at p − σ and p + σ, are only rounding errors.
pub(super) fn is_without(effects: &Effects, effect: &Effect) -> bool {
    let Some(SigmaEffect {
        sigma,
        second_order: Some(second),
        flown: [Some(below), Some(above)],
        ..
    }) = effect.sigma_effect
    else {
        return false;
    };
    let curvature = 2.0 * second / (sigma.value * sigma.value);
    let (of, value) = (effects.of, effects.value);
    let is_moved = [below, above]
        .into_iter()
        .any(|by| !is_rounding(of, value, by));
    !is_moved && !depends(of, value, effect.parameter, effect.gradient, curvature)
}

/// The derivative `slope` of an outcome by a parameter, in the units of a system: "2.11 yd per
/// deg". A `slope` that is only a rounding error of the outcome's `value` counts as 0.
pub(super) fn slope(
    of: Outcome,
    value: f64,
    by: &Parameter,
    slope: f64,
    system: System,
    digits: usize,
) -> String {
    ratio(
        of,
        by,
        zero_if_rounding(slope, value, of, &[by]),
        system,
        digits,
    )
}

/// The gain for each unit by which a limit is relaxed: "2.11 yd for each degree".
pub(super) fn price(
    of: impl Into<DisplayUnit>,
    amount: f64,
    by: impl Into<DisplayUnit>,
    system: System,
) -> String {
    let (of, by) = (of.into(), by.into());
    let number = quotient(of, by, amount, system, 3);
    format!(
        "{} for each {}",
        with_unit(&number, system.unit(of.unit)),
        one(system.unit(by.unit))
    )
}

/// A quotient of two quantities in the units of a system.
pub(super) fn ratio(
    of: impl Into<DisplayUnit>,
    by: impl Into<DisplayUnit>,
    value: f64,
    system: System,
    digits: usize,
) -> String {
    let (of, by) = (of.into(), by.into());
    let number = quotient(of, by, value, system, digits);
    format!(
        "{} {}",
        with_unit(&number, system.unit(of.unit)),
        per("", system.unit(by.unit)).trim()
    )
    .trim_end()
    .to_owned()
}

/// A quotient of two quantities in the units of a system, without its unit.
pub(super) fn quotient(
    of: impl Into<DisplayUnit>,
    by: impl Into<DisplayUnit>,
    value: f64,
    system: System,
    digits: usize,
) -> String {
    let number = value * by.into().size_in(system) / of.into().size_in(system);
    significant(number, digits)
}

#[cfg(test)]
mod tests {
    use super::{
        Outcome, System, both, change, change_as_displayed, constraint, number_or_dash, outcome,
        range, slope, spoken, within, words,
    };
    use crate::Setup;
    use crate::parameters::{Law, Vary};
    use crate::study::Constraint;

    #[test]
    fn exact_digits_of_each_quantity() {
        for (of, value, shown) in [
            (Outcome::FlightTime, 5.2408, "5.24"),
            (Outcome::FlightTime, 0.1234, "0.12"),
            (Outcome::SmashFactor, 1.474, "1.47"),
            (Outcome::Spin, 213.1, "2035"),
            (Outcome::Spin, 21.31, "203"),
            (Outcome::BallSpeed, 72.4216, "162.0"),
            (Outcome::Carry, 2.286, "2.5"),
        ] {
            assert_eq!(number_or_dash(of, Some(value), System::Us), shown);
        }
    }

    #[test]
    fn names_in_sentences_are_in_words_but_not_where_they_are_typed() {
        let message = "between swing.speed = 20 mph and 65 mph (club.loft, aero.law); write --set \
                    swing.speed=95mph";
        let says = "between club speed = 20 mph and 65 mph (club loft, aero.law); write --set \
                    swing.speed=95mph";
        assert_eq!(spoken(message), says);
    }

    #[test]
    fn no_name_has_a_word_twice() {
        let setup = Setup::modern_driver();
        let parameters = setup
            .parameters()
            .into_iter()
            .chain(Law::all_rows())
            .map(|row| row.name);
        for name in parameters.chain(Outcome::OF_DRIVES.iter().map(|of| of.name())) {
            let words = words(name);
            let mut seen: Vec<&str> = words.split(' ').collect();
            seen.sort_unstable();
            assert!(seen.windows(2).all(|pair| pair[0] != pair[1]), "{words}");
        }
        let mut names: Vec<String> = setup
            .parameters()
            .iter()
            .map(|row| words(row.name))
            .collect();
        names.sort_unstable();
        assert!(
            names.windows(2).all(|pair| pair[0] != pair[1]),
            "two parameters of one name: {names:?}"
        );
        assert_eq!(words("launch.launch_angle"), "launch angle");
        assert_eq!(
            [
                "launch.ball_speed",
                "club.inertia.xx",
                "swing.attack_angle",
                "swing.speed",
                "aero.cd0"
            ]
            .map(words),
            [
                "ball speed",
                "club inertia xx",
                "attack angle",
                "club speed",
                "cd0"
            ]
        );
    }

    #[test]
    fn sides_and_both_unit_systems_are_printed() {
        for (value, shown) in [
            (2.92608, "3.2 yd R"),
            (-2.92608, "3.2 yd L"),
            (-1e-15, "0.0 yd"),
            (0.0, "0.0 yd"),
        ] {
            assert_eq!(outcome(Outcome::Lateral, value, System::Us), shown);
        }
        assert_eq!(both(Outcome::Carry, 91.44, System::Us), "100.0 yd (91.4 m)");
        assert_eq!(
            both(Outcome::Carry, 91.44, System::Metric),
            "91.4 m (100.0 yd)"
        );
        assert_eq!(both(Outcome::LaunchAngle, 0.1309, System::Metric), "7.5°");
        assert_eq!(
            both(Outcome::Lateral, -9.144, System::Metric),
            "9.1 m L (10.0 yd L)"
        );
        assert_eq!(change(Outcome::Carry, 0.9144, System::Us), "+1.00 yd");
        assert_eq!(change(Outcome::Carry, -0.9144, System::Us), "-1.00 yd");
        assert_eq!(
            [1e-15, -1e-15].map(|by| change(Outcome::Carry, by, System::Us)),
            ["0.00 yd", "0.00 yd"]
        );
    }
    #[test]
    fn two_different_numbers_never_print_alike() {
        let setup = Setup::<f64>::modern_driver();
        let vary = |text: &str| Vary::read(&setup, text).unwrap();
        let loft = vary("club.loft=0deg..89deg");
        let shown = |vary: &Vary, degrees: f64| within(vary, degrees.to_radians(), System::Us);
        let texts = [0.0, 0.001_1, 6.701_2, 88.999_9, 89.0].map(|degrees| shown(&loft, degrees));
        assert_eq!(texts, ["0.00°", "0.0011°", "6.70°", "88.9999°", "89.00°"]);
        assert_eq!(range(&loft, System::Us), "0° .. 89°");
        let narrow = vary("club.loft=10deg..10.0000001deg");
        assert_eq!(range(&narrow, System::Us), "10° .. 10.0000001°");
        assert_eq!(
            range(&vary("club.loft=10deg..10deg"), System::Us),
            "10° .. 10°"
        );
        for (text, expected) in [
            (
                "38 deg <= descent_angle <= 38.0000001 deg",
                "38° ≤ descent angle ≤ 38.0000001°",
            ),
            ("38 deg <= descent_angle <= 38 deg", "descent angle = 38°"),
            ("descent_angle >= 38.123456 deg", "descent angle ≥ 38.123°"),
        ] {
            assert_eq!(
                constraint(&Constraint::read(text).unwrap(), System::Us),
                expected
            );
        }
    }

    #[test]
    fn exact_difference_of_displayed_values_and_of_directions_across_half_a_turn() {
        let yards = |from: f64, to: f64| {
            change_as_displayed(Outcome::Carry, from * 0.9144, to * 0.9144, System::Us)
        };
        assert_eq!(yards(285.96, 300.44), "+14.4 yd");
        assert_eq!(yards(300.0, 299.96), "0.0 yd");
        let [from, to] = [179.0_f64, -178.5].map(f64::to_radians);
        let axis = change_as_displayed(Outcome::SpinAxis, from, to, System::Us);
        assert_eq!(axis, "+2.5°");
    }

    #[test]
    fn rounding_is_printed_as_0_and_small_derivatives_are_not() {
        let setup = Setup::<f64>::modern_driver();
        let shown = |of: Outcome, value: f64, by: &str, d: f64, system: System| {
            slope(of, value, setup.parameter(by).unwrap(), d, system, 4)
        };
        for system in System::ALL {
            // each derivative is 0 except for rounding: ball speed by radius, backspin at an attack
            // angle of 0, carry at its maximum, lateral of a straight drive
            for (of, value, by, d) in [
                (Outcome::BallSpeed, 70.0, "ball.radius", 6e-16),
                (Outcome::Backspin, 250.0, "swing.attack_angle", 2.8e-14),
                (Outcome::Carry, 250.0, "club.loft", -2e-12),
                (Outcome::Lateral, 0.0, "swing.speed", 1e-15),
            ] {
                assert!(
                    shown(of, value, by, d, system).starts_with("0 "),
                    "{of:?} {by}: {}",
                    shown(of, value, by, d, system)
                );
            }
        }
        // small derivatives that are not rounding errors: 1 nm of carry per metre of ground height,
        // 0.1 nm per g cm² of inertia
        assert_eq!(
            shown(Outcome::Carry, 250.0, "ground.height", 1e-9, System::Metric),
            "1e-9 m per m"
        );
        assert_eq!(
            shown(
                Outcome::Carry,
                250.0,
                "club.inertia.yy",
                1e-3,
                System::Metric
            ),
            "1e-10 m per g cm²"
        );
    }
}
