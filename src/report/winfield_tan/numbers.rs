use crate::units::fixed;

/// An angle in degrees, to two decimals as the paper prints it.
pub(super) fn degrees(radians: f64) -> String {
    format!("{}°", fixed(radians.to_degrees(), 2))
}

/// Root mean square and the largest size of some numbers.
pub(super) fn spread(numbers: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = numbers.clone().count() as f64;
    let square: f64 = numbers.clone().map(|number| number * number).sum();
    (
        (square / n).sqrt(),
        numbers.map(f64::abs).fold(0.0, f64::max),
    )
}
