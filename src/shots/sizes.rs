//! Unit conversion factors of shots, computed once.

use crate::units::Quantity;
use std::sync::LazyLock;

/// Units with their conversion factors to SI.
static SIZES: LazyLock<Vec<(&str, f64)>> = LazyLock::new(|| {
    let of = |quantity: Quantity, units: [&'static str; 2]| {
        units.map(|unit| (unit, quantity.size_of(unit).unwrap_or(1.0)))
    };
    [
        of(Quantity::SPEED, ["mph", "m/s"]),
        of(Quantity::LENGTH, ["yd", "m"]),
        of(Quantity::ANGLE, ["deg", "rad"]),
        of(Quantity::ANGULAR_VELOCITY, ["rpm", "rad/s"]),
        of(Quantity::TIME, ["s", "ms"]),
    ]
    .concat()
});

/// Conversion factor of a unit to SI; 1 for an unknown unit.
pub(crate) fn size(quantity: Quantity, unit: &str) -> f64 {
    let known = SIZES
        .iter()
        .find(|(name, _)| *name == unit)
        .map(|(_, size)| *size);
    known.or_else(|| quantity.size_of(unit)).unwrap_or(1.0)
}
