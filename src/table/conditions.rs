//! Launch conditions of a row: consistency, and conversion to a launch.

use super::CONDITIONS;
use super::refusal::Refusal;
use crate::drive::Outcome;

/// An error in the launch conditions of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ConditionFault {
    /// Category of the [`Refusal`]: [`MISSING`](Refusal::MISSING), [`RANGE`](Refusal::RANGE) or
    /// [`SPIN`](Refusal::SPIN).
    pub kind: &'static str,
    /// The condition at fault.
    pub of: Outcome,
    pub why: &'static str,
}

impl ConditionFault {
    fn new(kind: &'static str, of: Outcome, why: &'static str) -> Self {
        Self { kind, of, why }
    }
}

/// The values of [`CONDITIONS`] in a row.
pub(crate) type StatedConditions = [Option<f64>; CONDITIONS.len()];

/// The parameters of the launch that a row gives.
pub(crate) const LAUNCH_PARAMETERS: [&str; 5] = [
    "launch.ball_speed",
    "launch.launch_angle",
    "launch.launch_direction",
    "launch.backspin",
    "launch.sidespin",
];

/// Largest spin axis in a row that states backspin and spin axis, rad: sidespin = backspin ·
/// tan(axis), and tan 90° is infinite.
const MOST_AXIS: f64 = std::f64::consts::FRAC_PI_2 - 1e-9;

/// Two spins that differ by less than this fraction agree: the difference may be rounding. Rounding
/// a spin axis to whole degrees gives 0.9 %.
const ROUNDING: f64 = 0.02;

/// Removes redundant spin values. Keeps the first of these combinations that is present: spin with
/// axis, backspin with sidespin, spin with sidespin, backspin with axis, spin, backspin.
pub(crate) fn without_redundant_spins(values: StatedConditions) -> StatedConditions {
    let [speed, angle, direction, spin, backspin, sidespin, axis] = values;
    let [spin, backspin, sidespin, axis] = match (spin, backspin, sidespin, axis) {
        (Some(_), _, _, Some(_)) => [spin, None, None, axis],
        (_, Some(_), Some(_), _) => [None, backspin, sidespin, None],
        (Some(_), _, _, None) => [spin, None, sidespin, None],
        (None, ..) => [None, backspin, sidespin, axis],
    };
    [speed, angle, direction, spin, backspin, sidespin, axis]
}

/// True for a row without a launch direction, or without a spin tilt (spin axis or sidespin).
/// Missing values are assumed to be 0, so lateral results are not compared with measured values.
pub(crate) fn is_straight_by_assumption(values: &StatedConditions) -> bool {
    let [_, _, direction, _, _, sidespin, axis] = values;
    direction.is_none() || sidespin.is_none() && axis.is_none()
}

/// Message if spin values of a row are not used although they differ from the spin of the flight;
/// `None` otherwise. `back` and `side` are the backspin and the sidespin of the flight.
pub(crate) fn contradiction(
    values: StatedConditions,
    [back, side]: [f64; 2],
    name: impl Fn(Outcome) -> String,
) -> Option<String> {
    let used = without_redundant_spins(values);
    let (spin, axis) = (back.hypot(side), side.atan2(back));
    // if the spin tilt is unknown, any backspin up to the total spin is possible
    let is_tilted = used[5].is_some() || used[6].is_some();
    let is_off = |of: Outcome, value: f64| {
        let off = match of {
            Outcome::Spin => (value - spin).abs(),
            Outcome::Backspin if is_tilted => (value - back).abs(),
            Outcome::Backspin => value.abs() - spin,
            Outcome::Sidespin => (value - side).abs(),
            Outcome::SpinAxis => spin * (value - axis).sin().atan2((value - axis).cos()).abs(),
            _ => 0.0,
        };
        off > ROUNDING * spin
    };
    let not_used =
        CONDITIONS
            .iter()
            .zip(values.iter().zip(used))
            .filter_map(|(of, (stated, used))| {
                let value = (*stated).filter(|value| used.is_none() && is_off(*of, *value))?;
                Some(format!("{} ({})", name(*of), of.show(value)))
            });
    let not_used: Vec<String> = not_used.collect();
    if not_used.is_empty() {
        let [_, _, _, whole, part, ..] = values;
        let less = whole
            .zip(part)
            .filter(|(whole, part)| !is_tilted && part.abs() < (1.0 - ROUNDING) * whole);
        return less.map(|(whole, part)| {
            format!(
                "the {} ({}) is flown without a tilt, and the {} ({}) is not used: without spin \
                 axis or sidespin the side of the tilt is not known; add one of these, or leave \
                 one of the two spins out",
                name(Outcome::Spin),
                Outcome::Spin.show(whole),
                name(Outcome::Backspin),
                Outcome::Backspin.show(part)
            )
        });
    }
    let of_spin = CONDITIONS
        .iter()
        .zip(used)
        .skip(3)
        .filter(|(_, value)| value.is_some());
    let of_spin: Vec<String> = of_spin.map(|(of, _)| name(*of)).collect();
    let is = if of_spin.len() == 1 { "is" } else { "are" };
    Some(format!(
        "the spins contradict each other: {} {is} used, not {}",
        of_spin.join(" and "),
        not_used.join(", ")
    ))
}

/// Values of [`LAUNCH_PARAMETERS`] from the values of [`CONDITIONS`]. A missing direction or spin
/// tilt counts as 0; redundant spins are removed by [`without_redundant_spins`]. `has` is true for
/// conditions that have a column.
///
/// # Errors
/// The fault, if conditions are missing, contradictory or invalid.
pub(crate) fn conditions(
    values: StatedConditions,
    has: impl Fn(Outcome) -> bool,
) -> Result<[f64; LAUNCH_PARAMETERS.len()], ConditionFault> {
    let [speed, angle, direction, spins @ ..] = without_redundant_spins(values);
    let is_empty = "the cell is empty; every launch needs this value";
    let missing = |of: Outcome| ConditionFault::new(Refusal::MISSING, of, is_empty);
    let speed = speed.ok_or(missing(Outcome::BallSpeed))?;
    let angle = angle.ok_or(missing(Outcome::LaunchAngle))?;
    if speed <= 0.0 {
        return Err(ConditionFault::new(
            Refusal::RANGE,
            Outcome::BallSpeed,
            "the ball's speed must be above 0",
        ));
    }
    if angle.abs() >= std::f64::consts::FRAC_PI_2 {
        return Err(ConditionFault::new(
            Refusal::RANGE,
            Outcome::LaunchAngle,
            "the launch angle must be between −90° and 90°",
        ));
    }
    let [back, side] = spin_components(spins, has)?;
    Ok([speed, angle, direction.unwrap_or(0.0), back, side])
}

/// Backspin and sidespin from spin values that [`without_redundant_spins`] kept.
fn spin_components(
    [spin, backspin, sidespin, axis]: [Option<f64>; 4],
    has: impl Fn(Outcome) -> bool,
) -> Result<[f64; 2], ConditionFault> {
    match (spin, backspin, sidespin, axis) {
        (None, None, _, _) => {
            let of = if has(Outcome::Spin) {
                Outcome::Spin
            } else {
                Outcome::Backspin
            };
            Err(ConditionFault::new(
                Refusal::MISSING,
                of,
                "the cells of the spin are empty; every launch needs a spin",
            ))
        }
        (None, Some(back), side @ Some(_), _) | (None, Some(back), side, None) => {
            Ok([back, side.unwrap_or(0.0)])
        }
        (None, Some(back), None, Some(axis)) if axis.abs() <= MOST_AXIS => {
            Ok([back, back * axis.tan()])
        }
        (None, Some(_), None, Some(_)) => Err(ConditionFault::new(
            Refusal::RANGE,
            Outcome::SpinAxis,
            "with a backspin the axis must be between −90° and 90°, since sidespin = backspin · \
             tan(axis); correct it, or give the sidespin",
        )),
        (Some(spin), _, Some(side), None) if side.abs() <= spin => {
            Ok([(spin * spin - side * side).sqrt(), side])
        }
        (Some(_), _, Some(_), None) => Err(ConditionFault::new(
            Refusal::SPIN,
            Outcome::Spin,
            "the sidespin is larger than the spin; correct one of them",
        )),
        (Some(spin), _, _, axis) => {
            let (sin, cos) = axis.unwrap_or(0.0).sin_cos();
            Ok([spin * cos, spin * sin])
        }
    }
}
