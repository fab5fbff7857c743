//! Column heads, units and separators as launch monitors write them.

use super::heads::{AIR, Meaning, NOT_USED, heads};
use super::numbers::{cell_number, is_unit};
use super::records::cells;
use crate::drive::Outcome;
use crate::units::Quantity;

/// Meaning of a launch monitor's column head, which is given without its unit. `None` for names of
/// this program and unknown heads.
pub(super) fn meaning(name: &str) -> Option<Meaning> {
    let is_a_name = || Outcome::OF_DRIVES.iter().any(|of| of.name() == name);
    if is_own(name) && (!name.contains('_') || is_a_name()) {
        return None;
    }
    let known = |words: &str| {
        heads()
            .find(|(head, _)| *head == words)
            .map(|(_, meaning)| meaning)
    };
    known(&words(name)).or_else(|| known(&words(&split_camel_case(name))))
}

/// Splits camel case into words: `Ball Speed` for `BallSpeed`.
fn split_camel_case(name: &str) -> String {
    let mut spaced = String::with_capacity(name.len() + 4);
    let mut before = ' ';
    for c in name.chars() {
        if c.is_uppercase() && before.is_lowercase() {
            spaced.push(' ');
        }
        spaced.push(c);
        before = c;
    }
    spaced
}

/// True for the spelling of this program: `ball_speed`.
fn is_own(name: &str) -> bool {
    name == name.to_lowercase() && !name.contains(' ')
}

/// A column head in lower case, without punctuation.
pub(crate) fn words(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() { c } else { ' ' };
    let words = name.chars().map(plain).collect::<String>().to_lowercase();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The known column head nearest to an unknown column head, if at most two letters differ: "ball
/// speed" for `Ball Sped [mph]`. `None` if heads with other meanings are equally near: `Launch` may
/// be "launch v" or "launch h".
pub(super) fn nearest_head(head: &str) -> Option<(&'static str, Meaning)> {
    let near = nearest_heads(head);
    let first = *near.first()?;
    near.iter()
        .all(|(_, meaning)| *meaning == first.1)
        .then_some(first)
}

/// The known column heads nearest to an unknown column head, if at most two letters differ, in
/// alphabetical order.
fn nearest_heads(head: &str) -> Vec<(&'static str, Meaning)> {
    let words = words(split_unit(head).0);
    if words.len() <= 4 || NOT_USED.contains(&words.as_str()) {
        return vec![];
    }
    let distance = |known: &str| strsim::levenshtein(&words, known);
    let least = heads().map(|(known, _)| distance(known)).min();
    let mut near: Vec<_> = heads()
        .filter(|(known, _)| Some(distance(known)) == least)
        .collect();
    near.sort_by_key(|(known, _)| *known);
    if !least.is_some_and(|least| (1..=2).contains(&least)) {
        near.clear();
    }
    near
}

/// Meaning of a column head with its unit. Some heads are ambiguous without a unit: `Ball (km/h)`
/// is a speed, but `Ball` may be the name of a ball model, and Square writes `ClubSpeed` in a unit
/// that it does not state.
pub(super) fn meaning_with(name: &str, unit: Option<&str>) -> Option<Meaning> {
    let is_speed = unit.is_some_and(|unit| Quantity::SPEED.size_of(unit).is_some());
    let is_time = unit.is_some_and(|unit| Quantity::TIME.size_of(unit).is_some());
    let is_density = unit.is_some_and(|unit| Quantity::DENSITY.size_of(unit).is_some());
    let by_unit = match name {
        "Ball" if is_speed => Some(Meaning::Outcome(Outcome::BallSpeed)),
        "Club" if is_speed => Some(Meaning::Input("swing.speed")),
        // a column `Time` without a unit contains the time of day
        "Time" if is_time => Some(Meaning::Outcome(Outcome::FlightTime)),
        // without a unit, the density may be in g/L or in lb/ft³ (a factor of 16)
        _ if is_density && ["air density", "luftdichte"].contains(&words(name).as_str()) => {
            Some(Meaning::Input(AIR))
        }
        _ => None,
    };
    let is_not_used = unit.is_none() && NOT_USED.contains(&words(name).as_str());
    by_unit.or_else(|| meaning(name).filter(|_| !is_not_used))
}

/// Recognizes exports: at least two column heads of launch monitors, misspelt or not.
pub(crate) fn is_export<'a>(heads: impl Iterator<Item = &'a str>) -> bool {
    let is_near = |head: &str| !is_own(split_unit(head).0) && !nearest_heads(head).is_empty();
    heads.filter(|head| is_known(head) || is_near(head)).count() >= 2
}

/// Recognizes column heads of launch monitors, including `ball_speed_mph`.
fn is_known(head: &str) -> bool {
    let (name, unit) = split_unit(head);
    meaning(name).is_some()
        || unit.is_some() && head.trim().starts_with(name) && head[name.len()..].starts_with('_')
}

/// Splits a column head into name and unit: `Club Speed [mph]`, `Carry (yds)`, `Ball Speed MPH`,
/// `BallSpeedMph`, `ball_speed_mph`.
pub(crate) fn split_unit(head: &str) -> (&str, Option<String>) {
    let head = head.trim();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, unit)) = head.split_once(open) {
            let unit = unit.trim_end().trim_end_matches(close).trim();
            // the `(Sim)` of TrackMan's `Carry (Sim)` is no unit
            if !unit.eq_ignore_ascii_case("sim") {
                return (name.trim(), Some(unit.to_owned()));
            }
        }
    }
    let capital = || {
        head.char_indices()
            .rfind(|(at, c)| *at > 0 && c.is_uppercase())
            .map(|(at, _)| head.split_at(at))
    };
    let is_of_heads = |name: &str| {
        let words = words(&split_camel_case(name));
        heads().any(|(known, _)| known == words)
    };
    let last_word = [head.rsplit_once(' '), head.rsplit_once('_'), capital()]
        .into_iter()
        .flatten();
    for (name, word) in last_word {
        if is_unit(word) && is_of_heads(name) {
            return (name.trim(), Some(word.to_owned()));
        }
    }
    (head, None)
}

/// Parses the line of units below the column heads: its cells are units such as `[mph]`, or empty.
/// `None` if the line is not a line of units. Below known column heads, at least one cell must be a
/// unit, and no cell may be a number. An unknown word below a known column head is returned as a
/// unit, so that it is reported as an error.
pub(super) fn units_row(heads: &[String], cells: &[String]) -> Option<Vec<Option<String>>> {
    let is_known = |head: &str| {
        let name = split_unit(head).0;
        meaning(name).is_some() || is_own(name)
    };
    let under_known: Vec<bool> = heads.iter().map(|head| is_known(head)).collect();
    let is_under_known = |at: usize| under_known.get(at).copied().unwrap_or_default();
    let bare = |cell: &str| {
        cell.trim()
            .trim_matches(['[', ']', '(', ')'])
            .trim()
            .to_owned()
    };
    let is_in_brackets =
        |cell: &str| cell.trim().starts_with(['[', '(']) && cell.trim().ends_with([']', ')']);
    let is_number = |cell: &str| cell_number(cell, true).is_some();
    if cells
        .iter()
        .enumerate()
        .any(|(at, cell)| is_under_known(at) && is_number(cell))
    {
        return None;
    }
    let has_unit = cells
        .iter()
        .enumerate()
        .any(|(at, cell)| is_under_known(at) && is_unit(&bare(cell)));
    let unit = |(at, cell): (usize, &String)| {
        let bare = bare(cell);
        let is_unit = is_under_known(at) || is_in_brackets(cell) || is_unit(&bare);
        Some(bare).filter(|bare| is_unit && !bare.is_empty())
    };
    has_unit.then(|| cells.iter().enumerate().map(unit).collect())
}

/// Recognizes the line of column heads of an export.
pub(super) fn is_head(text: &str, separator: u8) -> bool {
    // nearly every row contains a number
    let is_number = |cell: &str| cell.trim().parse::<f64>().is_ok();
    if text.split(char::from(separator)).any(is_number) {
        return false;
    }
    cells(text, separator)
        .iter()
        .filter(|cell| is_known(&cell.replace('\n', " ")))
        .count()
        >= 2
}

#[cfg(test)]
mod tests {
    use super::{Meaning, is_export, meaning, meaning_with, split_unit, units_row};
    use crate::Outcome;
    use crate::parameters::Setup;
    use std::collections::HashSet;

    #[test]
    fn units_are_split_from_heads() {
        for (head, name) in [
            ("Club Speed [mph]", "Club Speed"),
            ("Carry Flat - Length [yds]", "Carry Flat - Length"),
            ("Carry Flat - Land. Angle", "Carry Flat - Land. Angle"),
            ("Ball Speed (mph)", "Ball Speed"),
            ("Ball Speed MPH", "Ball Speed"),
            ("Carry Yards", "Carry"),
            ("BallSpeed", "BallSpeed"),
            ("LaunchAngleDeg", "LaunchAngle"),
            ("spin_rate_rpm", "spin_rate"),
            ("Attack Ang. [deg]", "Attack Ang."),
            ("Ballgeschwindigkeit", "Ballgeschwindigkeit"),
            ("Launch V (°)", "Launch V"),
        ] {
            assert_eq!(split_unit(head).0, name, "{head}");
        }
    }

    #[test]
    fn names_of_launch_monitors_are_known_and_other_names_are_not() {
        for (name, of) in [
            ("Club Speed", Meaning::Input("swing.speed")),
            ("Attack Ang.", Meaning::Input("swing.attack_angle")),
            (
                "Carry Flat - Length",
                Meaning::Outcome(Outcome::CarryDistance),
            ),
            (
                "Carry Flat - Land. Angle",
                Meaning::Outcome(Outcome::DescentAngle),
            ),
            ("Carry", Meaning::Outcome(Outcome::CarryDistance)),
            ("Ball Speed", Meaning::Outcome(Outcome::BallSpeed)),
            ("BallSpeed", Meaning::Outcome(Outcome::BallSpeed)),
            ("Ballgeschwindigkeit", Meaning::Outcome(Outcome::BallSpeed)),
            ("SCHLAGFLÄCHE", Meaning::Input("swing.face_angle")),
            ("LaunchAngle", Meaning::Outcome(Outcome::LaunchAngle)),
            ("Launch V", Meaning::Outcome(Outcome::LaunchAngle)),
            ("spin_rate", Meaning::Outcome(Outcome::Spin)),
        ] {
            assert_eq!(meaning(name), Some(of), "{name}");
        }
        for name in ["carry", "Total", "spin_axis"] {
            assert_eq!(meaning(name), None, "{name}");
        }
    }

    #[test]
    fn some_names_have_a_meaning_with_their_unit_only() {
        assert_eq!(
            meaning_with("Ball", Some("km/h")),
            Some(Meaning::Outcome(Outcome::BallSpeed))
        );
        assert_eq!(meaning_with("Ball", None), None);
        assert_eq!(meaning_with("Club", Some("deg")), None);
    }

    #[test]
    fn exports_are_distinguished_from_other_tables() {
        assert!(is_export(
            ["Ball Speed", "Launch Angle", "Player"].into_iter()
        ));
        assert!(is_export(
            ["ball_speed_mph", "launch_angle_deg"].into_iter()
        ));
        assert!(!is_export(
            ["carry [yd]", "club.loft [deg]", "Carry"].into_iter()
        ));
        assert!(!is_export(
            ["ball_speed", "launch_angle [deg]", "spin_axis"].into_iter()
        ));
    }

    #[test]
    fn each_head_is_listed_once_and_names_a_parameter_or_an_outcome() {
        let mut seen = HashSet::new();
        for (head, of) in super::heads() {
            assert!(seen.insert(head), "{head} is listed twice");
            if let Meaning::Input(name) = of {
                assert!(
                    Setup::<f64>::modern_driver().variable(name).is_ok(),
                    "{name}"
                );
            }
        }
        for of in Outcome::OF_DRIVES.iter().filter(|of| of.needs_run()) {
            for head in of.column_heads() {
                assert!(seen.insert(head), "{head} is listed twice");
            }
        }
    }

    #[test]
    fn lines_of_units_are_recognised() {
        let heads = ["Date", "Ball Speed", "Launch Angle", "Spin Rate"].map(String::from);
        let below = |cells: [&str; 4]| units_row(&heads, &cells.map(String::from));
        let read = Some(vec![
            None,
            Some("mph".into()),
            Some("deg".into()),
            Some("rpm".into()),
        ]);
        assert_eq!(
            (
                below([" ", "[mph]", "(deg)", "rpm"]),
                below(["yyyy-mm-dd", "mph", "deg", "rpm"])
            ),
            (read.clone(), read)
        );
        assert_eq!(
            (below(["", "1", "[deg]", ""]), below(["", "", "", ""])),
            (None, None)
        );
    }
}
