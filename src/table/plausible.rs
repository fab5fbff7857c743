//! Plausible ranges of measured values. A value outside of its range is an error of the table, such
//! as a wrong unit.

use super::CONDITIONS;
use super::conditions::{StatedConditions, conditions, without_redundant_spins};
use crate::drive::{Outcome, Sign};
use crate::parameters::Range;
use crate::units::Quantity;
use std::sync::LazyLock;

/// Range of each club parameter. The fastest recorded club speed is below 170 mph (76 m/s).
const OF_CLUB: &[(&str, f64, f64, &str)] = &[
    ("swing.speed", 0.0, 170.0, "mph"),
    ("swing.attack_angle", -45.0, 45.0, "deg"),
    ("swing.path", -45.0, 45.0, "deg"),
    ("swing.face_angle", -60.0, 60.0, "deg"),
];

fn quantity_in(unit: &str) -> Quantity {
    if unit == "mph" {
        Quantity::SPEED
    } else {
        Quantity::ANGLE
    }
}

static OF_CLUB_IN_SI: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
    let range = |(_, low, high, unit): &(&str, f64, f64, &str)| {
        let size = quantity_in(unit).size_of(unit).unwrap_or(1.0);
        [low * size, high * size]
    };
    OF_CLUB.iter().map(range).collect()
});

/// Message for an implausible value of the club, and for a club speed of 0; `None` for a plausible
/// value. `head` is the column head.
pub(crate) fn implausible_club(parameter: &str, value: f64, head: &str) -> Option<String> {
    let at = OF_CLUB.iter().position(|(known, ..)| *known == parameter)?;
    let [lowest, highest] = OF_CLUB_IN_SI[at];
    let (_, low, high, unit) = OF_CLUB[at];
    // 0 is within the range of the speed, but a club at rest strikes no ball
    let is_still = lowest == 0.0 && value == 0.0;
    if (lowest..=highest).contains(&value) && !is_still {
        return None;
    }
    if is_still {
        return Some(format!("{head}: a club speed of 0 counts as not measured"));
    }
    let shown = quantity_in(unit).show(value, unit);
    Some(format!(
        "{head}: {shown} is outside of the range of clubs, {low} to {high} {unit}; it counts as \
         not measured"
    ))
}

/// Plausible range of each outcome in SI, in the order of [`Outcome::ALL`]; `None` for an outcome
/// without such a range. An included end is moved outwards by a margin for the rounding of a unit
/// conversion.
static IN_SI: LazyLock<Vec<Option<[f64; 2]>>> = LazyLock::new(|| {
    let in_si = |of: &Outcome| {
        let plausible = of.plausible()?;
        let size = of.quantity().size_of(of.unit()).unwrap_or(1.0);
        let slack = 1e-9 * plausible.high;
        let low = if plausible.low_included {
            plausible.low - slack
        } else {
            f64::MIN_POSITIVE
        };
        Some([low * size, (plausible.high + slack) * size])
    };
    Outcome::ALL.iter().map(in_si).collect()
});

/// Message for a value that no drive has; `None` for a plausible value. `name` returns the column
/// head.
pub(crate) fn implausible(
    of: Outcome,
    value: f64,
    name: impl FnOnce() -> String,
) -> Option<String> {
    outside(of, value).map(|why| format!("{}: {why}", name()))
}

/// Like [`implausible`], but the message omits the column head.
pub(crate) fn outside(of: Outcome, value: f64) -> Option<String> {
    let [low, high] = (*IN_SI.get(of as usize)?)?;
    if (low..=high).contains(&value) {
        return None;
    }
    let Range {
        low,
        high,
        low_included,
        ..
    } = of.plausible()?;
    let (shown, unit) = (of.show(value), of.unit());
    let from = if low_included { "" } else { "above " };
    Some(format!(
        "{shown} is outside of the range of drives, {from}{low} to {high} {unit}; check the value \
         and its unit"
    ))
}

/// Message for a value that is impossible for a landed drive: a negative value of an outcome that
/// cannot be negative, or 0 for an outcome that is always positive. `None` for a possible value.
pub(crate) fn impossible(of: Outcome, value: f64) -> Option<String> {
    let (is_possible, least) = match of.sign() {
        Sign::Positive => (value > 0.0, "above 0"),
        Sign::NotNegative => (value >= 0.0, "0 or more"),
        Sign::Right | Sign::Either => return None,
    };
    let advice = if value == 0.0 {
        "leave the cell empty where nothing was measured"
    } else {
        "check its sign"
    };
    (!is_possible).then(|| {
        format!(
            "{} cannot be the {} of a drive, because this is always {least}; {advice}",
            of.show(value),
            of.name()
        )
    })
}

/// Message about the first implausible value of a launch: a stated value, or a spin component
/// computed from stated values. `None` if all are plausible.
pub(crate) fn implausible_launch(
    values: &StatedConditions,
    name: impl Fn(Outcome) -> String,
) -> Option<String> {
    let used = without_redundant_spins(*values);
    let stated = |(of, value): (&Outcome, &Option<f64>)| implausible(*of, (*value)?, || name(*of));
    if let Some(reason) = CONDITIONS.iter().zip(&used).find_map(stated) {
        return Some(reason);
    }
    let [.., (_, back), (_, side)] = conditions(used, |_| true).ok()?;
    // the stated spins may give implausible components: near a spin axis of 90° the tangent is
    // large, and above 90° the cosine is negative
    [
        (
            Outcome::Sidespin,
            side,
            Outcome::SpinAxis,
            "sidespin = backspin · tan(axis)",
        ),
        (
            Outcome::Backspin,
            back,
            Outcome::SpinAxis,
            "backspin = spin · cos(axis)",
        ),
        (
            Outcome::Spin,
            back.hypot(side),
            Outcome::Backspin,
            "spin = √(backspin² + sidespin²)",
        ),
    ]
    .into_iter()
    .find_map(|(of, value, from, formula)| {
        implausible(of, value, || format!("{} ({formula})", name(from)))
    })
}
