//! Plausible ranges of measured values. Values outside are errors of the table, such as a wrong
//! unit.

use super::CONDITIONS;
use super::conditions::{Stated, conditions, without_redundant_spins};
use crate::drive::Outcome;
use crate::units::Quantity;
use std::sync::LazyLock;

/// Range of each outcome in its unit. The fastest recorded ball speed is 241.7 mph (108 m/s); a
/// driver gives no topspin.
const RANGES: &[(Outcome, f64, f64, &str)] = &[
    (Outcome::BallSpeed, 0.0, 270.0, "mph"),
    (Outcome::LaunchAngle, -90.0, 90.0, "deg"),
    (Outcome::LaunchDirection, -90.0, 90.0, "deg"),
    (Outcome::Spin, 0.0, 20_000.0, "rpm"),
    (Outcome::Backspin, 0.0, 20_000.0, "rpm"),
    (Outcome::Sidespin, -20_000.0, 20_000.0, "rpm"),
    (Outcome::SpinAxis, -180.0, 180.0, "deg"),
    (Outcome::CarryDistance, 0.0, 600.0, "yd"),
    (Outcome::Lateral, -600.0, 600.0, "yd"),
    (Outcome::ApexHeight, 0.0, 150.0, "yd"),
    (Outcome::FlightTime, 0.0, 20.0, "s"),
    (Outcome::DescentAngle, 0.0, 90.0, "deg"),
    (Outcome::LandingSpeed, 0.0, 270.0, "mph"),
    (Outcome::Total, 0.0, 800.0, "yd"),
    (Outcome::LateralTotal, -800.0, 800.0, "yd"),
];

/// Range of each club parameter. The fastest recorded club speed is below 170 mph (76 m/s).
const OF_CLUB: &[(&str, f64, f64, &str)] = &[
    ("swing.speed", 0.0, 170.0, "mph"),
    ("swing.attack_angle", -45.0, 45.0, "deg"),
    ("swing.path", -45.0, 45.0, "deg"),
    ("swing.face_angle", -60.0, 60.0, "deg"),
];

/// Physical quantity of a club range, from its unit.
fn quantity_in(unit: &str) -> Quantity {
    if unit == "mph" {
        Quantity::SPEED
    } else {
        Quantity::ANGLE
    }
}

/// Club ranges in SI.
static OF_CLUB_IN_SI: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
    let range = |(_, low, high, unit): &(&str, f64, f64, &str)| {
        let size = quantity_in(unit).size_of(unit).unwrap_or(1.0);
        [low * size, high * size]
    };
    OF_CLUB.iter().map(range).collect()
});

/// Message for implausible values of a club; `head` is the column head.
pub(crate) fn implausible_club(parameter: &str, value: f64, head: &str) -> Option<String> {
    let at = OF_CLUB.iter().position(|(known, ..)| *known == parameter)?;
    let [lowest, highest] = OF_CLUB_IN_SI[at];
    let (_, low, high, unit) = OF_CLUB[at];
    // a club at rest cannot strike a ball
    let is_still = lowest == 0.0 && value == 0.0;
    if (lowest..=highest).contains(&value) && !is_still {
        return None;
    }
    if is_still {
        return Some(format!("{head}: a club speed of 0 counts as not measured"));
    }
    let shown = quantity_in(unit).show(value, unit);
    Some(format!(
        "{head}: {shown} is outside of what a club has, {low} to {high} {unit}; it counts as not \
         measured"
    ))
}

/// Outcomes whose value must exceed the lower end of the range: 0 means that it was not measured.
const ABOVE: &[Outcome] = &[
    Outcome::BallSpeed,
    Outcome::Spin,
    Outcome::CarryDistance,
    Outcome::ApexHeight,
    Outcome::FlightTime,
    Outcome::DescentAngle,
    Outcome::Total,
];

/// Ranges in SI. Inclusive ends get a margin for the rounding of a unit conversion.
static IN_SI: LazyLock<Vec<(Outcome, f64, f64)>> = LazyLock::new(|| {
    let range = |(of, low, high, unit): &(Outcome, f64, f64, &str)| {
        let size = of.quantity().size_of(unit).unwrap_or(1.0);
        let slack = 1e-9 * high;
        let low = if ABOVE.contains(of) {
            f64::MIN_POSITIVE
        } else {
            low - slack
        };
        (*of, low * size, (high + slack) * size)
    };
    RANGES.iter().map(range).collect()
});

/// Message for values that no drive has; `name` is the column head.
pub(crate) fn implausible(
    of: Outcome,
    value: f64,
    name: impl FnOnce() -> String,
) -> Option<String> {
    outside(of, value).map(|why| format!("{}: {why}", name()))
}

/// Message without the column head.
pub(crate) fn outside(of: Outcome, value: f64) -> Option<String> {
    let (at, (_, lowest, highest)) = IN_SI
        .iter()
        .enumerate()
        .find(|(_, (outcome, ..))| *outcome == of)?;
    if (*lowest..=*highest).contains(&value) {
        return None;
    }
    let (_, low, high, unit) = RANGES[at];
    let shown = of.quantity().show(value, unit);
    let from = if ABOVE.contains(&of) { "above " } else { "" };
    Some(format!(
        "{shown} is outside of what a drive has, {from}{low} to {high} {unit}; check the value and \
         its unit"
    ))
}

/// Outcomes that are positive: a negative value, and a length or time of 0, is an error of the
/// table.
const POSITIVE: &[Outcome] = &[
    Outcome::Carry,
    Outcome::CarryDistance,
    Outcome::Total,
    Outcome::ApexHeight,
    Outcome::FlightTime,
    Outcome::DescentAngle,
    Outcome::LandingSpeed,
    Outcome::BallSpeed,
    Outcome::SmashFactor,
];

/// Message for values that no landed drive has.
pub(crate) fn impossible(of: Outcome, value: f64) -> Option<String> {
    let is_possible = if of == Outcome::Spin {
        value >= 0.0
    } else {
        !POSITIVE.contains(&of) || value > 0.0
    };
    let advice = if value == 0.0 {
        "leave the cell empty where nothing was measured"
    } else {
        "check its sign"
    };
    let least = if of == Outcome::Spin {
        "0 or more"
    } else {
        "above 0"
    };
    (!is_possible).then(|| {
        format!(
            "{} is no {} of a drive, which is {least}; {advice}",
            of.show(value),
            of.name()
        )
    })
}

/// Message for an implausible launch, by the stated values and by the spin components computed from
/// them.
pub(crate) fn implausible_launch(
    values: &Stated,
    name: impl Fn(Outcome) -> String,
) -> Option<String> {
    let used = without_redundant_spins(*values);
    let stated = |(of, value): (&Outcome, &Option<f64>)| implausible(*of, (*value)?, || name(*of));
    if let Some(reason) = CONDITIONS.iter().zip(&used).find_map(stated) {
        return Some(reason);
    }
    let [.., (_, back), (_, side)] = conditions(used, |_| true).ok()?;
    // the tangent is large near 90°, and the cosine is negative above
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
