//! What a launch monitor's export has and is not used.

use super::air::air_as_given;
use super::column::{Column, Holds};
use super::launch_monitor::{nearest_head, words};
use crate::drive::Outcome;
use crate::units::Message;

/// Use of the club columns beside a measured launch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClubColumns {
    /// They are left out: the ball flies from its launch.
    Ignored,
    /// They are read: the delivery is sought that explains the launch.
    Read,
}

/// Where the spin is taken from that is stated in several ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SpinSource {
    /// From columns that are chosen for the whole table.
    Table,
    /// From what each row has, where rows are launches: [`taken`](super::conditions::taken).
    Row,
}

/// The columns of an export that have no name here but are near one that has, as the end of a
/// clause: "; near a known head: …".
pub(crate) fn near_known(columns: &[Column]) -> String {
    let near = columns.iter().filter(|column| column.is_unknown());
    let near = near.filter_map(|column| {
        Some(format!(
            "'{}' (did you mean '{}'?)",
            column.head,
            nearest_head(&column.head)?
        ))
    });
    let near: Vec<String> = near.collect();
    if near.is_empty() {
        String::new()
    } else {
        format!("; near a known head: {}", near.join(", "))
    }
}

/// Message for exports whose air the setup overrides.
pub(crate) fn given_air(columns: &[Column]) -> Option<String> {
    columns
        .iter()
        .find(|column| column.is_of_given_air())
        .map(|column| air_as_given(&column.head))
}

/// The angles whose unit is taken for granted.
pub(crate) fn in_degrees(columns: &[Column]) -> Option<String> {
    let heads: Vec<&str> = columns
        .iter()
        .filter(|column| column.is_in_degrees_untold())
        .map(|column| column.head.as_str())
        .collect();
    let (is, angles) = if heads.len() == 1 {
        ("is", "an angle")
    } else {
        ("are", "angles")
    };
    (!heads.is_empty()).then(|| {
        format!(
            "{} {is} read in degrees: {angles} without a unit, and launch monitors write degrees",
            heads.join(", ")
        )
    })
}

/// Leaves out what a launch monitor's table has and the fit cannot use, and says so: columns
/// without a name here; where the launch was measured, those of the club; of backspin, sidespin and
/// the spin axis what repeats the spin, unless each row chooses.
pub(super) fn ignore_columns(
    columns: &mut [Column],
    club: ClubColumns,
    spin: SpinSource,
) -> Vec<Message> {
    let named = |columns: &[Column], is: &dyn Fn(&Column) -> bool| -> Vec<String> {
        columns
            .iter()
            .filter(|column| is(column))
            .map(|column| column.head.clone())
            .filter(|head| !head.is_empty())
            .collect()
    };
    let mut remarks = vec![];
    // a condition is of the row's air, where it tells of that
    let is_a_word = |column: &Column| {
        column.head.is_empty()
            || ["condition", "conditions"].contains(&words(&column.head).as_str())
    };
    let unknown = columns
        .iter()
        .filter(|column| column.is_unknown() && !is_a_word(column));
    let unknown: Vec<String> = unknown
        .map(|column| match nearest_head(&column.head) {
            Some(near) => format!("{} (did you mean '{near}'?)", column.head),
            None => column.head.clone(),
        })
        .collect();
    if !unknown.is_empty() {
        remarks.push(
            format!(
                "columns without a name here are left out: {}",
                unknown.join(", ")
            )
            .into(),
        );
    }
    let has = |columns: &[Column], outcome| {
        columns
            .iter()
            .any(|column| column.holds == Holds::Outcome(outcome))
    };
    let has_spin = has(columns, Outcome::Spin) || has(columns, Outcome::Backspin);
    if has(columns, Outcome::BallSpeed) && has(columns, Outcome::LaunchAngle) && has_spin {
        let is_club = |column: &Column| {
            let is_of_the_strike = club == ClubColumns::Ignored && column.is_of_the_strike();
            is_of_the_strike || column.holds == Holds::Outcome(Outcome::SmashFactor)
        };
        let left = named(columns, &is_club);
        if !left.is_empty() {
            remarks.push(
                format!(
                    "{}: {}",
                    match club {
                        ClubColumns::Ignored =>
                            "the ball flies from its measured launch; columns of the club are left \
                             out",
                        ClubColumns::Read =>
                            "the speeds of ball and club are read, and not their \
                                              ratio; left out",
                    },
                    left.join(", ")
                )
                .into(),
            );
        }
        let repeated: &[Outcome] = match has(columns, Outcome::Spin)
            && (has(columns, Outcome::SpinAxis) || !has(columns, Outcome::Sidespin))
        {
            true => &[Outcome::Backspin, Outcome::Sidespin],
            false if has(columns, Outcome::Backspin) => &[Outcome::Spin, Outcome::SpinAxis],
            false => &[],
        };
        let repeats = |column: &Column| {
            repeated
                .iter()
                .any(|outcome| column.holds == Holds::Outcome(*outcome))
        };
        let again = named(columns, &repeats);
        let is_of_row = spin == SpinSource::Row
            && (club == ClubColumns::Ignored || !columns.iter().any(Column::is_of_the_strike));
        if !again.is_empty() {
            let told = match is_of_row {
                true => {
                    "the spin is stated twice; used only in rows without the other columns of the \
                     spin"
                }
                false => "the spin is stated twice; left out",
            };
            remarks.push(format!("{told}: {}", again.join(", ")).into());
        }
        for column in columns
            .iter_mut()
            .filter(|column| is_club(column) || !is_of_row && repeats(column))
        {
            column.holds = Holds::Note;
        }
    }
    remarks
}
