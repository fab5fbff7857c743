//! Numbers and units as tables write them.

use crate::units::Quantity;

/// Parses a number; decimal commas only where the comma does not separate cells.
pub(super) fn number(cell: &str, has_decimal_comma: bool) -> Option<f64> {
    let cell = cell.trim();
    // as nearly all are written, in every table
    if let Ok(number) = cell.parse::<f64>() {
        return Some(number).filter(|number| number.is_finite());
    }
    let cell = without_thousands(&cell.replace('\u{2212}', "-"));
    let cell = match has_decimal_comma {
        true if !cell.contains('.') => cell.replacen(',', ".", 1),
        false if has_thousands(&cell, ',') => cell.replace(',', ""),
        _ => cell,
    };
    cell.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Removes thousands separators that cannot be decimal marks: `2 500`, `2\u{2019}500`.
fn without_thousands(cell: &str) -> String {
    const MARKS: [char; 7] = [' ', '\u{a0}', '\u{2009}', '\u{202f}', '\'', '\u{2019}', '_'];
    let mark = MARKS
        .into_iter()
        .find(|mark| cell.contains(*mark) && has_thousands(&cell.replace(*mark, "_"), '_'));
    mark.map_or_else(|| cell.to_owned(), |mark| cell.replace(mark, ""))
}

/// True if the mark may separate thousands: the comma in `2,686` or `1,234.5`, not in `3,2` or
/// `0,250`.
pub(crate) fn has_thousands(cell: &str, mark: char) -> bool {
    let decimals: &[char] = if mark == ',' {
        &['.']
    } else if mark == '.' {
        &[',']
    } else {
        &['.', ',']
    };
    let whole = cell
        .trim_start_matches(['+', '-', '\u{2212}'])
        .split(decimals)
        .next()
        .unwrap_or_default();
    let mut groups = whole.split(mark);
    let is_of = |group: &str, digits: std::ops::RangeInclusive<usize>| {
        digits.contains(&group.len()) && group.bytes().all(|byte| byte.is_ascii_digit())
    };
    let begins = groups
        .next()
        .is_some_and(|first| is_of(first, 1..=3) && !first.starts_with('0'));
    whole.contains(mark) && begins && groups.all(|group| is_of(group, 3..=3))
}

/// Recognizes units of speed, length, angle, spin and time.
pub(super) fn is_unit(word: &str) -> bool {
    let unit = unit(word);
    [
        Quantity::SPEED,
        Quantity::LENGTH,
        Quantity::ANGLE,
        Quantity::ANGULAR_VELOCITY,
        Quantity::TIME,
    ]
    .iter()
    .any(|quantity| quantity.size_of(&unit).is_some())
}

/// A unit as this program writes it: `MPH` and `Yards` are mph and yards, `yds` yd.
pub(super) fn unit(written: &str) -> String {
    let written = written.trim();
    // `deg L-/R+`: what the signs mean
    let written = written
        .split_once(' ')
        .filter(|(_, signs)| signs.contains("-/"))
        .map_or(written, |(unit, _)| unit);
    match written.to_lowercase().as_str() {
        "yds" => "yd".into(),
        "mps" => "m/s".into(),
        "degs" => "deg".into(),
        "secs" => "s".into(),
        small @ ("mph" | "km/h" | "kmh" | "kph" | "m/s" | "yd" | "yard" | "yards" | "m"
        | "meter" | "meters" | "metre" | "metres" | "ft" | "feet" | "foot" | "deg"
        | "degree" | "degrees" | "rpm" | "s" | "sec" | "seconds" | "in" | "inch"
        | "inches" | "mm" | "cm") => small.into(),
        _ => written.into(),
    }
}

/// Compares units by size: `km/h` equals `kph`.
pub(super) fn is_same_unit(one: &str, other: &str) -> bool {
    const QUANTITIES: [Quantity; 6] = [
        Quantity::SPEED,
        Quantity::LENGTH,
        Quantity::ANGLE,
        Quantity::ANGULAR_VELOCITY,
        Quantity::TIME,
        Quantity::DENSITY,
    ];
    let is_in = |quantity: &Quantity| {
        quantity.size_of(one).is_some() && quantity.size_of(one) == quantity.size_of(other)
    };
    one == other || QUANTITIES.iter().any(is_in)
}

#[cfg(test)]
mod tests {
    use super::{number, unit};

    #[test]
    fn numbers_with_decimal_and_thousands_marks_are_read() {
        for (cell, comma, expected) in [
            ("2,686", false, 2686.0),
            ("1,234,567.5", false, 1_234_567.5),
            ("\u{2212}4.5", false, -4.5),
            ("+12,0", true, 12.0),
            ("2 500", false, 2500.0),
            ("2\u{a0}500", true, 2500.0),
            ("2\u{202f}500,5", true, 2500.5),
            ("-2'500", false, -2500.0),
            ("2\u{2019}500.25", false, 2500.25),
        ] {
            assert_eq!(number(cell, comma), Some(expected), "{cell}");
        }
        for (cell, comma) in [
            ("12,34", false),
            ("1234,567", false),
            ("3,2", false),
            ("12 5", false),
            ("1'2", false),
            ("", true),
        ] {
            assert_eq!(number(cell, comma), None, "{cell}");
        }
    }

    #[test]
    fn units_in_other_spellings_are_read() {
        assert_eq!(
            ["MPH", "Yards", "yds", "°", "Pa s"].map(unit),
            ["mph", "yards", "yd", "°", "Pa s"]
        );
    }
}
