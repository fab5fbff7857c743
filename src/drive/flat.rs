//! Balls that land flatter than any whose bounce was measured.

use crate::flight::Landed;
use crate::ground::angle_of_impact;
use crate::number::Number;
use crate::units::{Digits, Message, Quantity};

/// Balls that land flatter than this from the ground, rad, bounce by an assumption that nothing
/// measured bears out (docs/limitations.md).
const FLAT: f64 = 25.0 * std::f64::consts::PI / 180.0;

/// The angle to the ground, of these slopes, at which a ball that bounces landed, where that is
/// flatter than any whose bounce was measured, rad.
pub(crate) fn flat_landing_angle<T: Number>(slopes: [f64; 2], landed: &Landed<T>) -> Option<f64> {
    landed
        .rest
        .as_ref()
        .filter(|rest| rest.bounces > 0 && rest.downrange.re().is_finite())?;
    Some(angle_of_impact(slopes, landed.velocity.map(Number::re))).filter(|angle| *angle < FLAT)
}

/// What is said of balls that land flatter than this angle, which follows the words before.
pub(super) fn assumed(before: Message) -> Message {
    before
        .quantity(Quantity::ANGLE, "deg", FLAT, Digits::Significant(3))
        .words(
            ": how a ball bounces that lands so flat is assumed, not measured, so total, run and \
         lateral total may be far off; \
         prefer carry (docs/limitations.md)",
        )
}
