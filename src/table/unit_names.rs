//! Units as launch monitors write them.

use crate::units::Quantity;

/// Whether a word is a unit of what launch monitors state.
pub(super) fn is_unit(word: &str) -> bool {
    let unit = unit(word);
    [Quantity::SPEED, Quantity::LENGTH, Quantity::ANGLE, Quantity::ANGULAR_VELOCITY, Quantity::TIME]
        .iter()
        .any(|quantity| quantity.size_of(&unit).is_some())
}

/// A unit as this program writes it: `MPH` and `Yards` are mph and yards, `yds` yd.
pub(super) fn unit(written: &str) -> String {
    let written = written.trim();
    // `deg L-/R+`: what the signs mean
    let written = written.split_once(' ').filter(|(_, signs)| signs.contains("-/")).map_or(written, |(unit, _)| unit);
    match written.to_lowercase().as_str() {
        "yds" => "yd".into(),
        "mps" => "m/s".into(),
        "degs" => "deg".into(),
        "secs" => "s".into(),
        small @ ("mph" | "km/h" | "kmh" | "kph" | "m/s" | "yd" | "yard" | "yards" | "m" | "meter" | "meters"
        | "metre" | "metres" | "ft" | "feet" | "foot" | "deg" | "degree" | "degrees" | "rpm" | "s" | "sec"
        | "seconds" | "in" | "inch" | "inches" | "mm" | "cm") => small.into(),
        _ => written.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::unit;

    #[test]
    fn exact_units_in_other_spellings() {
        assert_eq!(["MPH", "Yards", "yds", "°", "Pa s"].map(unit), ["mph", "yards", "yd", "°", "Pa s"]);
    }
}
