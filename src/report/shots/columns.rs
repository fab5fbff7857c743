//! Shots in a table with the columns of a launch monitor. The shots may come from an export or from
//! JSON.

use super::csv::PredictionColumns;
use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::csv_text::push_number;
use crate::shots::{Flown, Origin, Shot, Shots};
use crate::units::{System, TableUnits};

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

/// Column of the name of the club.
const CLUB_NAME: &str = "Club";

/// The columns for the shots of a source.
#[derive(Clone, Debug)]
pub(super) struct LaunchMonitorColumns {
    added: PredictionColumns,
    /// Parameters that each row states in addition to its launch, such as its wind.
    other_parameters: Vec<&'static Parameter>,
    /// True if the source names the club of each shot.
    has_club_name: bool,
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

impl LaunchMonitorColumns {
    pub fn new(shots: &Shots, of: &[Outcome], system: System) -> Self {
        Self {
            added: PredictionColumns {
                of: of.to_vec(),
                system,
                separator: b',',
                has_decimal_comma: false,
            },
            other_parameters: shots.other_parameters.clone(),
            has_club_name: shots.names_clubs(),
        }
    }

    /// The line of column heads.
    pub fn head(&self) -> Vec<u8> {
        let with_unit = |(head, unit): (String, &'static str)| {
            if unit.is_empty() {
                head
            } else {
                format!("{head} [{unit}]")
            }
        };
        let own = LAUNCH
            .iter()
            .chain(&CLUB)
            .chain(&MEASURED)
            .map(|(head, of)| with_unit(((*head).to_owned(), self.added.system.unit(of.unit()))));
        let units = TableUnits::Of(self.added.system);
        let club_name = self.has_club_name.then_some(CLUB_NAME);
        let texts = TEXTS.into_iter().chain(club_name).map(str::to_owned);
        let parameters = self
            .other_parameters
            .iter()
            .map(|row| units.head(row.name, *row));
        let added = self.added.heads().into_iter().map(with_unit);
        let heads = own.chain(texts).chain(parameters).chain(added);
        (heads.collect::<Vec<_>>().join(",") + "\n").into_bytes()
    }

    /// Appends the cells of a row.
    pub fn row(&self, flown: &Flown, row: usize, bytes: &mut Vec<u8>) {
        let (added, shot) = (&self.added, &flown.shots[row]);
        let measured = MEASURED.map(|(_, of)| shot.value(of).map(|value| value.value));
        let values = launch(shot)
            .into_iter()
            .chain(shot.club.values())
            .chain(measured);
        for ((_, of), value) in LAUNCH.iter().chain(&CLUB).chain(&MEASURED).zip(values) {
            added.push(bytes, value, *of);
            bytes.push(added.separator);
        }
        let spin_origin = shot.spin_origin().map_or("", Origin::name);
        let condition = shot.condition.as_deref().unwrap_or_default();
        let club_name = shot.club_name.as_deref().unwrap_or_default();
        let club_name = self.has_club_name.then_some(club_name);
        for text in [spin_origin, condition].into_iter().chain(club_name) {
            added.push_text(bytes, text);
            bytes.push(added.separator);
        }
        let mut stated = shot.other_parameters().iter();
        for parameter in &self.other_parameters {
            // a shot that is not flown has no values
            if let Some(value) = stated.next() {
                push_number(
                    bytes,
                    TableUnits::Of(added.system).number(*value, *parameter),
                );
            }
            bytes.push(added.separator);
        }
        added.row(flown, row, bytes);
    }
}
