//! Plausible ranges of measured values. A value outside of its range is an error of the table, such
//! as a wrong unit.

use super::CONDITIONS;
use super::conditions::{StatedConditions, conditions, without_redundant_spins};
use crate::drive::{Outcome, OutcomeGroup, Sign};
use crate::parameters::Range;
use crate::units::{DisplayUnit, Quantity};
use std::sync::LazyLock;

/// Plausible range of a club parameter.
struct ClubRange {
    parameter: &'static str,
    /// Lowest and highest value, in the unit `shown`.
    ends: [f64; 2],
    shown: DisplayUnit,
}

const MPH: DisplayUnit = DisplayUnit {
    quantity: Quantity::SPEED,
    unit: "mph",
};

const DEG: DisplayUnit = DisplayUnit {
    quantity: Quantity::ANGLE,
    unit: "deg",
};

/// Range of each club parameter. The fastest recorded club speed is below 170 mph (76 m/s).
const CLUB_RANGES: [ClubRange; 4] = [
    ClubRange {
        parameter: "swing.speed",
        ends: [0.0, 170.0],
        shown: MPH,
    },
    ClubRange {
        parameter: "swing.attack_angle",
        ends: [-45.0, 45.0],
        shown: DEG,
    },
    ClubRange {
        parameter: "swing.path",
        ends: [-45.0, 45.0],
        shown: DEG,
    },
    ClubRange {
        parameter: "swing.face_angle",
        ends: [-60.0, 60.0],
        shown: DEG,
    },
];

static CLUB_RANGES_IN_SI: LazyLock<[[f64; 2]; 4]> =
    LazyLock::new(|| CLUB_RANGES.map(|range| range.ends.map(|end| end * range.shown.size())));

/// End of each note on a value of the club that is not used.
pub(crate) const NOT_MEASURED: &str = "counts as not measured";

/// Message for an implausible value of a club parameter, or a club speed of 0; `None` for a
/// plausible value. `head` is the column head.
pub(crate) fn implausible_club(parameter: &str, value: f64, head: &str) -> Option<String> {
    let at = CLUB_RANGES
        .iter()
        .position(|range| range.parameter == parameter)?;
    let [lowest, highest] = CLUB_RANGES_IN_SI[at];
    // 0 is within the range of the speed, but a club at rest strikes no ball
    let is_still = lowest == 0.0 && value == 0.0;
    if (lowest..=highest).contains(&value) && !is_still {
        return None;
    }
    if is_still {
        return Some(format!("{head}: a club speed of 0 {NOT_MEASURED}"));
    }
    let ClubRange {
        ends: [low, high],
        shown,
        ..
    } = CLUB_RANGES[at];
    Some(format!(
        "{head}: {} is outside of the range of clubs, {low} to {high} {}; it {NOT_MEASURED}",
        shown.show(value),
        shown.unit
    ))
}

/// Plausible range of each outcome in SI, in the order of [`Outcome::OF_DRIVES`]; `None` for an
/// outcome without such a range. A bound that is itself plausible is moved outwards by the rounding
/// of a unit conversion.
static IN_SI: LazyLock<Vec<Option<[f64; 2]>>> = LazyLock::new(|| {
    let in_si = |of: &Outcome| {
        let plausible = of.instrument()?.plausible?;
        let size = of.quantity().size_of(of.unit()).unwrap_or(1.0);
        let slack = 1e-9 * plausible.high;
        let low = if plausible.low_included {
            plausible.low - slack
        } else {
            f64::MIN_POSITIVE
        };
        Some([low * size, (plausible.high + slack) * size])
    };
    Outcome::OF_DRIVES.iter().map(in_si).collect()
});

/// Message for a value outside of the plausible range of drives; `None` for a plausible value.
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
    } = of.instrument()?.plausible?;
    let (shown, unit) = (of.show(value), of.unit());
    let from = if low_included { "" } else { "above " };
    Some(format!(
        "{shown} is outside of the range of drives, {from}{low} to {high} {unit}; check the value \
         and its unit"
    ))
}

/// Reason why a measured value of an export is not compared; `None` for a usable value. In a row
/// with a `carry` of 0, a 0 of any other outcome of the flight was not measured either: launch
/// monitors write zeros for a ball that they lost.
pub(crate) fn not_compared(
    of: Outcome,
    value: f64,
    carry: impl FnOnce() -> Option<f64>,
) -> Option<String> {
    if let Some(why) = outside(of, value) {
        return Some(why);
    }
    let is_unmeasured = value == 0.0 && of.group() == OutcomeGroup::Flight && carry() == Some(0.0);
    is_unmeasured.then(|| "0 was not measured, since the carry of the row is 0 too".into())
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
    let stated = |(of, value): (&Outcome, &Option<f64>)| {
        let why = outside(*of, (*value)?)?;
        Some(format!("{}: {why}", name(*of)))
    };
    if let Some(reason) = CONDITIONS.iter().zip(&used).find_map(stated) {
        return Some(reason);
    }
    let [.., back, side] = conditions(used, |_| true).ok()?;
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
        let why = outside(of, value)?;
        Some(format!("{} ({formula}): {why}", name(from)))
    })
}
