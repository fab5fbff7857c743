//! Tables as launch monitors write them: heads, units, separators and sides.

use super::heads::{HEADS, Meaning, NOT_USED};
use crate::drive::Outcome;
use crate::units::Quantity;

/// The meaning of a head without its unit; `None` for one of this program's own names, and for what it has no name for.
pub(super) fn meaning(name: &str) -> Option<Meaning> {
    if is_own(name) {
        return None;
    }
    let words = words(name);
    HEADS.iter().find(|(head, _)| *head == words).map(|(_, meaning)| *meaning)
}

/// Whether a name is spelled as this program's are: `ball_speed`.
fn is_own(name: &str) -> bool {
    name == name.to_lowercase() && !name.contains(' ')
}

/// A head in small letters, without marks.
pub(crate) fn words(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { ' ' };
    let words: String = name.chars().map(plain).collect();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The known head that one without a meaning differs from by a letter or two: "ball speed" for `Ball Sped [mph]`.
pub(crate) fn nearest_head(head: &str) -> Option<&'static str> {
    let words = words(split_unit(head).0);
    let near = HEADS.iter().map(|(known, _)| (strsim::levenshtein(&words, known), *known)).min()?;
    let is_known = NOT_USED.contains(&words.as_str());
    (words.len() > 4 && !is_known && (1..=2).contains(&near.0)).then_some(near.1)
}

/// The meaning of a head with its unit: `Ball (km/h)` is a speed, while `Ball` by itself may be a kind of ball.
pub(super) fn meaning_with(name: &str, unit: Option<&str>) -> Option<Meaning> {
    let is_speed = unit.is_some_and(|unit| Quantity::SPEED.size_of(unit).is_some());
    let is_time = unit.is_some_and(|unit| Quantity::TIME.size_of(unit).is_some());
    let is_density = unit.is_some_and(|unit| Quantity::DENSITY.size_of(unit).is_some());
    let by_unit = match name {
        "Ball" if is_speed => Some(Meaning::Outcome(Outcome::BallSpeed)),
        "Club" if is_speed => Some(Meaning::Input("swing.speed")),
        // without a unit it is that of the day
        "Time" if is_time => Some(Meaning::Outcome(Outcome::FlightTime)),
        // numbers of g/L and of lb/ft³ differ by a factor of sixteen
        _ if is_density && words(name) == "air density" => Some(Meaning::Input("air.density")),
        _ => None,
    };
    by_unit.or_else(|| meaning(name))
}

/// Whether a table is one of a launch monitor: two heads or more are written as these write them, perhaps with a slip of the pen.
pub(crate) fn is_export<'a>(heads: impl Iterator<Item = &'a str>) -> bool {
    let is_near = |head: &str| !is_own(split_unit(head).0) && nearest_head(head).is_some();
    heads.filter(|head| meaning(split_unit(head).0).is_some() || is_near(head)).count() >= 2
}

/// A head's name, and its unit: `Club Speed [mph]`, `Carry (yds)`, `Ball Speed MPH`.
pub(crate) fn split_unit(head: &str) -> (&str, Option<String>) {
    let head = head.trim();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, unit)) = head.split_once(open).filter(|(_, unit)| !is_simulated(unit)) {
            return (name.trim(), Some(unit.trim_end().trim_end_matches(close).trim().to_owned()));
        }
    }
    match head.rsplit_once(' ') {
        Some((name, word)) if meaning(name.trim()).is_some() && is_unit(word) => (name.trim(), Some(word.to_owned())),
        _ => (head, None),
    }
}

/// Whether what stands in brackets is TrackMan's word for values of another flight model, `Carry (Sim)`, and not a unit.
fn is_simulated(word: &str) -> bool {
    word.trim_end_matches([')', ']']).trim().eq_ignore_ascii_case("sim")
}

fn is_unit(word: &str) -> bool {
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

/// The units of a second line under the head, `[mph]` each or nothing, perhaps of quantities that are not read, `[g/L]`; `None` where the line is none of units.
pub(super) fn units_row<'a>(cells: impl Iterator<Item = &'a str>) -> Option<Vec<Option<String>>> {
    let read = |cell: &str| {
        let cell = cell.trim();
        let bare = cell.trim_matches(['[', ']', '(', ')']).trim().to_owned();
        // units of other kinds, `[g/L]`, `[%]`
        let is_in_brackets = cell.starts_with(['[', '(']) && cell.ends_with([']', ')']);
        match bare.is_empty() {
            true => Some(None),
            false => (is_in_brackets || is_unit(&bare)).then_some(Some(bare)),
        }
    };
    let units = cells.map(read).collect::<Option<Vec<_>>>()?;
    units.iter().flatten().any(|unit| is_unit(unit)).then_some(units)
}

/// What a row is that sums up others: the word for it, as it is written. Shots have none of these words in any cell.
pub(crate) fn summary<'a>(cells: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    const WORDS: [&str; 12] = [
        "dev",
        "average",
        "averages",
        "avg",
        "mean",
        "median",
        "consistency",
        "std dev",
        "stddev",
        "stdev",
        "standard deviation",
        "deviation",
    ];
    let mut cells = cells.map(str::trim);
    // most cells are none of them: that must cost next to nothing
    cells.find(|cell| {
        let words = || cell.split(|c: char| c.is_whitespace() || c == '.' || c == ':').filter(|word| !word.is_empty());
        let is = |known: &&str| {
            let mut known = known.split(' ');
            words().all(|word| known.next().is_some_and(|other| word.eq_ignore_ascii_case(other)))
                && known.next().is_none()
        };
        let first = cell.bytes().find(|byte| !matches!(byte, b'.' | b':' | b' '));
        let begins = |known: &&&str| first.is_some_and(|first| known.as_bytes()[0].eq_ignore_ascii_case(&first));
        WORDS.iter().filter(begins).any(is)
    })
}

/// A number as these tables write it: with a decimal comma where that separates no cells, and with its side where it has one,
/// `3.2 L`, `3.2R`, right of the target +.
pub(super) fn number(cell: &str, has_decimal_comma: bool, has_side: impl Fn() -> bool) -> Option<f64> {
    let cell = cell.trim();
    // as nearly all are written, in every table
    if let Ok(number) = cell.parse::<f64>() {
        return Some(number).filter(|number| number.is_finite());
    }
    let cell = cell.replace('\u{2212}', "-");
    let (cell, sign) = match side(&cell).filter(|_| has_side()) {
        Some((magnitude, sign)) if !magnitude.starts_with('-') => (magnitude.to_owned(), sign),
        Some(_) => return None,
        None => (cell, 1.0),
    };
    let cell = match has_decimal_comma {
        true if !cell.contains('.') => cell.replacen(',', ".", 1),
        false if has_thousands(&cell, ',') => cell.replace(',', ""),
        _ => cell,
    };
    cell.parse().ok().filter(|number: &f64| number.is_finite()).map(|number| sign * number)
}

/// Whether a mark may part the digits of a number into thousands: the comma in `2,686` or `1,234.5`, and not in `3,2` or `0,250`.
pub(crate) fn has_thousands(cell: &str, mark: char) -> bool {
    let decimal = if mark == ',' { '.' } else { ',' };
    let whole = cell.trim_start_matches(['-', '\u{2212}']).split(decimal).next().unwrap_or_default();
    let mut groups = whole.split(mark);
    let is_of = |group: &str, digits: std::ops::RangeInclusive<usize>| {
        digits.contains(&group.len()) && group.bytes().all(|byte| byte.is_ascii_digit())
    };
    let begins = groups.next().is_some_and(|first| is_of(first, 1..=3) && !first.starts_with('0'));
    whole.contains(mark) && begins && groups.all(|group| is_of(group, 3..=3))
}

/// The magnitude and the sign of `3.2 L` or `R 3.2`.
fn side(cell: &str) -> Option<(&str, f64)> {
    let sides = [("Right", 1.0), ("Left", -1.0), ("R", 1.0), ("L", -1.0), ("r", 1.0), ("l", -1.0)];
    sides.into_iter().find_map(|(word, sign)| {
        let rest = cell.strip_suffix(word).or_else(|| cell.strip_prefix(word))?;
        Some((rest.trim(), sign))
    })
}

/// A cell without the side that may stand in it.
pub(crate) fn without_side(cell: &str) -> &str {
    let cell = cell.trim();
    side(cell).map_or(cell, |(magnitude, _)| magnitude)
}

#[cfg(test)]
mod tests {
    use super::{Meaning, is_export, meaning, meaning_with, number, split_unit, unit, units_row};
    use crate::Outcome;
    use crate::parameters::Setup;
    use std::collections::HashSet;

    #[test]
    fn heads_of_launch_monitors_are_known_and_own_names_are_left_to_the_table() {
        for (head, name, of) in [
            ("Club Speed [mph]", "Club Speed", Meaning::Input("swing.speed")),
            ("Carry Flat - Length [yds]", "Carry Flat - Length", Meaning::Outcome(Outcome::CarryDistance)),
            ("Carry Flat - Land. Angle", "Carry Flat - Land. Angle", Meaning::Outcome(Outcome::DescentAngle)),
            ("Ball Speed (mph)", "Ball Speed", Meaning::Outcome(Outcome::BallSpeed)),
            ("Ball Speed MPH", "Ball Speed", Meaning::Outcome(Outcome::BallSpeed)),
            ("Carry Yards", "Carry", Meaning::Outcome(Outcome::CarryDistance)),
            ("Launch V (°)", "Launch V", Meaning::Outcome(Outcome::LaunchAngle)),
        ] {
            assert_eq!((split_unit(head).0, meaning(name)), (name, Some(of)), "{head}");
        }
        assert_eq!(meaning_with("Ball", Some("km/h")), Some(Meaning::Outcome(Outcome::BallSpeed)));
        assert_eq!((meaning_with("Ball", None), meaning_with("Club", Some("deg"))), (None, None));
        assert_eq!((meaning("carry"), meaning("Total"), meaning("spin_axis")), (None, None, None));
        assert!(is_export(["Ball Speed", "Launch Angle", "Player"].into_iter()));
        assert!(!is_export(["carry [yd]", "club.loft [deg]", "Carry"].into_iter()));
        let mut seen = HashSet::new();
        for (head, of) in super::HEADS.iter() {
            assert!(seen.insert(head), "{head} is listed twice");
            if let Meaning::Input(name) = of {
                assert!(Setup::<f64>::default().variable(name).is_ok(), "{name}");
            }
        }
    }

    #[test]
    fn exact_units_separators_and_sides() {
        assert_eq!(["MPH", "Yards", "yds", "°", "Pa s"].map(unit), ["mph", "yards", "yd", "°", "Pa s"]);
        let units = units_row([" ", "[mph]", "(deg)", "rpm"].into_iter()).unwrap();
        assert_eq!(units, [None, Some("mph".into()), Some("deg".into()), Some("rpm".into())]);
        assert_eq!((units_row(["1", "[mph]"].into_iter()), units_row(["", ""].into_iter())), (None, None));
        assert_eq!(number("3.2 L", false, || true), Some(-3.2));
        assert_eq!(number("3,2R", true, || true), Some(3.2));
        assert_eq!(number("Left 3", false, || true), Some(-3.0));
        assert_eq!(number("2,686", false, || false), Some(2686.0));
        assert_eq!(number("1,234,567.5", false, || false), Some(1_234_567.5));
        assert_eq!(number("\u{2212}4.5", false, || true), Some(-4.5));
        for (cell, comma, side) in [
            ("12,34", false, false),
            ("1234,567", false, false),
            ("-3 L", false, true),
            ("3 L", false, false),
            ("3,2", false, true),
            ("L", false, true),
        ] {
            assert_eq!(number(cell, comma, || side), None, "{cell}");
        }
    }
}
