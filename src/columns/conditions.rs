//! The launch that the conditions in a row make.

use super::CONDITIONS;
use crate::drive::Outcome;

/// What is wrong with the conditions of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    /// The condition.
    pub of: Outcome,
    pub why: &'static str,
    /// Whether it is missing, and all that is there is sound.
    pub is_missing: bool,
}

/// The launch of a row, by the parameters that it is, from the values of [`CONDITIONS`]. A direction or a tilt of the spin that is missing
/// is 0; `has` tells which conditions have a column.
///
/// # Errors
/// What is missing, stated twice, or is no launch.
pub(crate) fn conditions(
    values: [Option<f64>; CONDITIONS.len()],
    has: impl Fn(Outcome) -> bool,
) -> Result<[(&'static str, f64); 5], Fault> {
    let [speed, angle, direction, spin, backspin, sidespin, axis] = values;
    let missing = |of: Outcome, why| Fault { of, why, is_missing: true };
    let wrong = |of: Outcome, why| Err(Fault { of, why, is_missing: false });
    let is_empty = "the cell is empty; every launch needs one";
    let speed = speed.ok_or(missing(Outcome::BallSpeed, is_empty))?;
    let angle = angle.ok_or(missing(Outcome::LaunchAngle, is_empty))?;
    if speed <= 0.0 {
        return wrong(Outcome::BallSpeed, "the ball's speed must be above 0");
    }
    if angle.abs() >= std::f64::consts::FRAC_PI_2 {
        return wrong(Outcome::LaunchAngle, "the launch must be between −90° and 90°");
    }
    let (back, side) = match (spin, backspin, sidespin, axis) {
        (None, None, _, _) => {
            let of = if has(Outcome::Spin) { Outcome::Spin } else { Outcome::Backspin };
            return Err(missing(of, "the cells of the spin are empty; every launch needs one"));
        }
        (None, Some(back), side, None) => (back, side.unwrap_or(0.0)),
        (Some(spin), None, None, axis) => {
            let (sin, cos) = axis.unwrap_or(0.0).sin_cos();
            (spin * cos, spin * sin)
        }
        (Some(spin), None, Some(side), None) if side.abs() <= spin => ((spin * spin - side * side).sqrt(), side),
        _ => {
            return wrong(
                Outcome::Spin,
                "give the spin once: backspin with sidespin, or spin with spin_axis or with a sidespin no larger",
            );
        }
    };
    Ok([
        ("launch.ball_speed", speed),
        ("launch.launch_angle", angle),
        ("launch.launch_direction", direction.unwrap_or(0.0)),
        ("launch.backspin", back),
        ("launch.sidespin", side),
    ])
}
