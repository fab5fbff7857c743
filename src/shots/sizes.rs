//! Unit conversion factors of shots, computed once.

use crate::units::Quantity;
use std::sync::LazyLock;

/// Units with their conversion factors to SI.
static CONVERSION_FACTORS: LazyLock<Vec<(&str, f64)>> = LazyLock::new(|| {
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

/// Conversion factor of a unit to SI; 1 for a plain number, which has no unit.
pub(crate) fn conversion_factor(quantity: Quantity, unit: &str) -> f64 {
    let known = CONVERSION_FACTORS
        .iter()
        .find(|(name, _)| *name == unit)
        .map(|(_, size)| *size);
    known.or_else(|| quantity.size_of(unit)).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use crate::drive::Outcome;
    use crate::units::{Quantity, System};

    #[test]
    fn every_unit_of_shots_is_a_unit_of_its_quantity() {
        let of_messages = [
            (Quantity::SPEED, "mph"),
            (Quantity::SPEED, "m/s"),
            (Quantity::LENGTH, "yd"),
            (Quantity::LENGTH, "m"),
            (Quantity::ANGLE, "deg"),
        ];
        let of_outcomes = Outcome::ALL.iter().flat_map(|of| {
            let unit = |system: System| (of.quantity(), system.unit(of.unit()));
            [System::Metric, System::Us].map(unit)
        });
        for (quantity, unit) in of_messages.into_iter().chain(of_outcomes) {
            let is_known = unit.is_empty() || quantity.size_of(unit).is_some();
            assert!(is_known, "{} {unit}", quantity.name);
        }
    }
}
