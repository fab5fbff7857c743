use crate::units::fixed;

/// An angle in degrees, to four decimals as the report prints it.
pub(super) fn degrees(radians: f64) -> String {
    format!("{}°", fixed(radians.to_degrees(), 4))
}
