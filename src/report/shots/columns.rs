//! Shots in a table with the columns of a launch monitor. The shots may come from an export or from
//! JSON.

use super::csv::PredictionColumns;
use crate::drive::Outcome;
use crate::shots::{Flown, Origin, Shot};

/// The launch columns, in the order of [`launch`]. The spin is given as total spin and spin axis.
pub(super) const LAUNCH: [(&str, Outcome); 5] = [
    ("Ball Speed", Outcome::BallSpeed),
    ("Launch Angle", Outcome::LaunchAngle),
    ("Launch Direction", Outcome::LaunchDirection),
    ("Spin Rate", Outcome::Spin),
    ("Spin Axis", Outcome::SpinAxis),
];

/// Columns of the club, each with an outcome that has the unit of the column.
const CLUB: [(&str, Outcome); 4] = [
    ("Club Speed", Outcome::BallSpeed),
    ("Attack Angle", Outcome::LaunchAngle),
    ("Club Path", Outcome::LaunchAngle),
    ("Face Angle", Outcome::LaunchAngle),
];

/// Columns of measured outcomes.
pub(super) const MEASURED: [(&str, Outcome); 8] = [
    ("Carry", Outcome::CarryDistance),
    ("Carry Side", Outcome::Lateral),
    ("Max Height", Outcome::ApexHeight),
    ("Hang Time", Outcome::FlightTime),
    ("Landing Angle", Outcome::DescentAngle),
    ("Carry Flat - Ball Speed", Outcome::LandingSpeed),
    ("Total", Outcome::Total),
    ("Total Side", Outcome::LateralTotal),
];

/// Columns of text: the origin of the spin (measured or estimated), and the conditions for which
/// the export states its values.
const TEXTS: [&str; 2] = ["Spin Rate Type", "Condition"];

/// The line of column heads.
pub(super) fn head(added: &PredictionColumns) -> Vec<u8> {
    let own = LAUNCH
        .iter()
        .chain(&CLUB)
        .chain(&MEASURED)
        .map(|(head, of)| ((*head).to_owned(), added.unit(*of)));
    let own = own.chain(TEXTS.map(|head| (head.to_owned(), "")));
    let heads = own.chain(added.heads());
    let heads = heads.map(|(head, unit)| {
        if unit.is_empty() {
            head
        } else {
            format!("{head} [{unit}]")
        }
    });
    (heads.collect::<Vec<_>>().join(",") + "\n").into_bytes()
}

/// The launch of a shot in the order of `LAUNCH`, SI: the input of the flight, or the stated values
/// of a shot that is not flown. Assumed values are omitted, because a later run of `fly` would read
/// their 0 as measured.
pub(super) fn launch(shot: &Shot) -> [Option<f64>; 5] {
    match shot.launch() {
        Some(&[speed, angle, direction, back, side]) => {
            let axis = side.atan2(back);
            [
                Some(speed),
                Some(angle),
                (!shot.is_direction_assumed()).then_some(direction),
                Some(back.hypot(side)),
                (!shot.is_axis_assumed()).then_some(axis),
            ]
        }
        _ => LAUNCH.map(|(_, of)| shot.value(of).map(|value| value.value)),
    }
}

/// Appends the cells of a row.
pub(super) fn row(added: &PredictionColumns, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
    let shot = &flown.shots[row];
    let measured = MEASURED.map(|(_, of)| shot.value(of).map(|value| value.value));
    let values = launch(shot)
        .into_iter()
        .chain(shot.club.values())
        .chain(measured);
    for ((_, of), value) in LAUNCH.iter().chain(&CLUB).chain(&MEASURED).zip(values) {
        added.push(bytes, value, added.unit(*of), *of);
        bytes.push(added.separator);
    }
    let spin_origin = shot.spin_origin().map_or("", Origin::name);
    for text in [spin_origin, shot.condition.as_deref().unwrap_or_default()] {
        added.push_text(bytes, text);
        bytes.push(added.separator);
    }
    added.row(flown, row, bytes);
}
