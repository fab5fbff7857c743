//! Texts of launch monitors as tables with the head in the first line, for those who read tables as a whole.

use super::head::found;
use super::objects::Objects;
use super::open_connect;
use super::shot::Shot;
use super::written;
use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use std::borrow::Cow;

/// Whether a text is of messages in JSON, not of lines with cells.
pub(super) fn is_json(text: &str) -> bool {
    let mut characters = text.chars().filter(|c| !c.is_whitespace());
    match characters.next() {
        Some('{') => true,
        Some('[') => matches!(characters.next(), None | Some('{' | ']')),
        _ => false,
    }
}

/// The columns of a table made of messages: the head, and the value in SI.
type Column = (&'static str, fn(&Shot) -> Option<f64>);

fn value(shot: &Shot, of: Outcome) -> Option<f64> {
    shot.value(of).map(|value| value.value)
}

const COLUMNS: [Column; 20] = [
    ("Ball Speed [m/s]", |shot| value(shot, Outcome::BallSpeed)),
    ("Launch Angle [rad]", |shot| value(shot, Outcome::LaunchAngle)),
    ("Launch Direction [rad]", |shot| value(shot, Outcome::LaunchDirection)),
    ("Total Spin [rad/s]", |shot| value(shot, Outcome::Spin)),
    ("Spin Axis [rad]", |shot| value(shot, Outcome::SpinAxis)),
    ("Back Spin [rad/s]", |shot| value(shot, Outcome::Backspin)),
    ("Side Spin [rad/s]", |shot| value(shot, Outcome::Sidespin)),
    ("Carry [m]", |shot| value(shot, Outcome::CarryDistance)),
    ("Side [m]", |shot| value(shot, Outcome::Lateral)),
    ("Apex [m]", |shot| value(shot, Outcome::ApexHeight)),
    ("Max Height - Dist. [m]", |shot| value(shot, Outcome::ApexDownrange)),
    ("Landing Angle [rad]", |shot| value(shot, Outcome::DescentAngle)),
    ("Hang Time [s]", |shot| value(shot, Outcome::FlightTime)),
    ("Carry Flat - Ball Speed [m/s]", |shot| value(shot, Outcome::LandingSpeed)),
    ("Total Distance [m]", |shot| value(shot, Outcome::Total)),
    ("Side Total [m]", |shot| value(shot, Outcome::LateralTotal)),
    ("Club Speed [m/s]", |shot| shot.club.speed),
    ("Attack Angle [rad]", |shot| shot.club.attack_angle),
    ("Club Path [rad]", |shot| shot.club.path),
    ("Face Angle [rad]", |shot| shot.club.face_angle),
];

/// Those of the club: every row of a table has a value of them, or the table has no such column.
const OF_CLUB: usize = 16;

/// A text as a table with its head in the first line, and what deserves a word: title lines are left out, and messages of GSPro Open Connect, or lines
/// that `fly` wrote as JSON lines, become rows.
pub(crate) fn tabled<'a>(setup: &Setup<f64>, text: &'a str) -> (Cow<'a, str>, Vec<Message>) {
    if is_json(text) {
        let (table, remarks) = of_messages(text, &written::further(setup, text));
        return (table.into(), remarks);
    }
    (without_titles(text).unwrap_or(text.into()), vec![])
}

fn of_messages(text: &str, further: &[&'static Parameter]) -> (String, Vec<Message>) {
    let mut objects = Objects::default();
    objects.push(text.as_bytes());
    objects.finish();
    let shots: Vec<Shot> =
        std::iter::from_fn(|| objects.next_piece()).map(|piece| open_connect::shot(piece, further)).collect();
    let (mut remarks, mut refused) = (vec![], vec![]);
    for (at, shot) in shots.iter().enumerate() {
        refused
            .extend(shot.refusal().map(|refusal| format!("row {} (line {}: {})", at + 1, shot.line, refusal.reason)));
    }
    if !refused.is_empty() {
        remarks.push(format!("messages that are no shots are left out: {}", refused.join(", ")).into());
    }
    let flown: Vec<&Shot> = shots.iter().filter(|shot| shot.refusal().is_none()).collect();
    let is_there = |(at, (_, of)): &(usize, &Column)| match *at >= OF_CLUB {
        true => !flown.is_empty() && flown.iter().all(|shot| of(shot).is_some()),
        false => flown.iter().any(|shot| of(shot).is_some()),
    };
    let columns: Vec<&Column> = COLUMNS.iter().enumerate().filter(is_there).map(|(_, column)| column).collect();
    let line = |cells: Vec<String>| cells.join(",") + "\n";
    let heads = columns.iter().map(|(head, _)| (*head).to_owned());
    let mut table = line(heads.chain(further.iter().map(|row| row.quantity.head(row.name))).collect());
    for shot in &shots {
        // a row without a value is left out, and the others keep their numbers
        let cell = |of: &fn(&Shot) -> Option<f64>| of(shot).filter(|_| shot.refusal().is_none());
        let shown = |value: Option<f64>| value.map_or("-".into(), |value| value.to_string());
        let cells = columns.iter().map(|(_, of)| shown(cell(of)));
        let own = (0..further.len()).map(|at| shown(shot.further().get(at).copied()));
        table += &line(cells.chain(own).collect());
    }
    (table, remarks)
}

/// The lines from the head on, behind what says how cells are separated; `None` where nothing stands before the head.
fn without_titles(text: &str) -> Option<Cow<'_, str>> {
    let (_, at) = found(text)?;
    let mut lines = text.split_inclusive(['\n', '\r']).filter(|line| !line.trim_end_matches(['\n', '\r']).is_empty());
    let before: Vec<&str> = lines.by_ref().take(at).collect();
    let is_title =
        |line: &&str| !(line.trim().is_empty() || line.starts_with(['#', '\u{feff}']) || line.starts_with("sep="));
    if !before.iter().any(is_title) {
        return None;
    }
    let stated = before.iter().copied().filter(|line| line.trim_start_matches('\u{feff}').starts_with("sep="));
    Some(stated.chain(lines).collect::<String>().into())
}

#[cfg(test)]
mod tests {
    use super::tabled;
    use crate::parameters::Setup;

    #[test]
    fn exact_title_lines_are_left_out_and_other_tables_stay_as_they_are() {
        let head = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd]\n150,12,2700,240\n";
        let titled = format!("Session of May\n\nA. Player\n{head}");
        assert_eq!(tabled(&Setup::default(), &titled).0, head);
        for text in
            [head.to_owned(), format!("# remark\n{head}"), format!("sep=,\n{head}"), "club.loft [deg]\n9\n".into()]
        {
            assert_eq!(tabled(&Setup::default(), &text).0, text);
        }
    }
}
