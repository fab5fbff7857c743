//! Why a flight could not be followed, and what to do about it.

use crate::units::significant;

/// Steps up to this follow any golf ball, s; the default is 10 ms.
const FINE: f64 = 0.05;

/// What is out of the ordinary in a flight that diverged, and what to do: the step only where it is
/// a long one. In SI: the step, then speed and spin at launch, ρ A/(2 m) and the speed of the wind.
pub(super) fn advice(
    step: f64,
    [speed, spin, force_per_mass, wind]: [f64; 4],
    law: &str,
) -> String {
    if step > FINE {
        return "the step is long; reduce flight.step (the default is 10 ms)".into();
    }
    let most = [
        // the record is below 110 m/s
        ("the ball leaves at", speed, 150.0, "m/s"),
        // 19000 rpm
        ("its spin is", spin, 2000.0, "rad/s"),
        (
            "air.density · area/(2 ball.mass) is",
            force_per_mass,
            0.1,
            "per m (0.018 for a golf ball in air)",
        ),
        // a hurricane
        ("the wind is", wind, 100.0, "m/s"),
    ];
    // also what is no number at all
    let beyond = most
        .into_iter()
        .filter(|(_, value, most, _)| !(0.0..=*most).contains(value));
    let found: Vec<_> = beyond
        .map(|(what, value, _, unit)| format!("{what} {} {unit}", significant(value, 3)))
        .collect();
    match &found[..] {
        [] => format!(
            "launch, ball and air are as usual, so check the coefficients of the law {law}: they \
             may give a negative drag, or a \
             force that is far too large"
        ),
        found => format!(
            "{}, which is unusual; check it, or let a tolerance choose a step that follows it",
            found.join(", and ")
        ),
    }
}
