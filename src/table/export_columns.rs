//! Columns of an export: default units, and columns that are ignored.

use super::CONDITIONS;
use super::column::{Column, Content};
use super::heads::Meaning;
use super::launch_monitor::nearest_head;
use super::table_use::TableUse;
use crate::drive::Outcome;
use crate::units::{Message, Quantity};
use std::borrow::Borrow;

/// Beginning of the remark on assumed units.
pub(crate) const ASSUMED_UNITS: &str = "heads without a unit are read as";

/// Default units of columns without a unit, as in US versions of the makers' applications.
const DEFAULT_UNITS: [(Quantity, &str); 4] = [
    (Quantity::SPEED, "mph"),
    (Quantity::LENGTH, "yd"),
    (Quantity::ANGULAR_VELOCITY, "rpm"),
    (Quantity::TIME, "s"),
];

/// Assumes the default unit for a column whose head has no unit. If a cell of `rows` has a unit, no
/// unit is assumed, because each cell of the column then states its own. For angles,
/// [`Column::read`] has already assumed degrees. Returns the head with the assumed unit, for
/// [`assumed_units_remark`]; `None` if no unit is assumed.
pub(crate) fn assume_unit(at: usize, column: &mut Column, rows: &[Vec<String>]) -> Option<String> {
    if !column.lacks_unit() && !column.is_in_assumed_degrees() {
        return None;
    }
    if rows.iter().any(|row| column.has_unit_in(&row[at])) {
        column.has_units_in_cells = true;
        return None;
    }
    if !column.lacks_unit() {
        return None;
    }
    let quantity = column.quantity();
    let mut defaults = DEFAULT_UNITS.iter();
    let (_, unit) = defaults.find(|(of, _)| quantity == Some(*of))?;
    let is_height = column.content == Content::Outcome(Outcome::ApexHeight);
    let unit = if is_height { "ft" } else { unit };
    *column = column.clone().in_unit(unit);
    Some(format!("{} in {unit}", column.head))
}

/// Remark on columns with assumed units; `None` if there are none.
pub(crate) fn assumed_units_remark(assumed: &[String]) -> Option<Message> {
    (!assumed.is_empty()).then(|| {
        format!(
            "{ASSUMED_UNITS} {}; if the units are different, write them into the column heads",
            assumed.join(", ")
        )
        .into()
    })
}

/// True if a column holds this outcome.
pub(crate) fn has_outcome(columns: &[Column], of: Outcome) -> bool {
    columns
        .iter()
        .any(|column| column.content == Content::Outcome(of))
}

/// True if a column holds the speed of the club.
fn has_club_speed(columns: &[Column]) -> bool {
    columns
        .iter()
        .any(|column| matches!(column.content, Content::Input(of) if of.name == "swing.speed"))
}

/// True if no column of a launch is missing.
pub(crate) fn has_whole_launch(columns: &[Column]) -> bool {
    missing_of_launch(columns).is_empty()
}

/// The columns of a launch that are missing, in words.
pub(crate) fn missing_of_launch(columns: &[Column]) -> Vec<&'static str> {
    let has = |of| has_outcome(columns, of);
    let needed = [
        (has(Outcome::BallSpeed), "the ball speed"),
        (has(Outcome::LaunchAngle), "the launch angle"),
        (
            has(Outcome::Spin) || has(Outcome::Backspin),
            "the spin (spin rate, total spin or backspin)",
        ),
    ];
    needed
        .into_iter()
        .filter(|(is_there, _)| !is_there)
        .map(|(_, words)| words)
        .collect()
}

/// Remark on the parts of the launch that no column has; `None` if the launch is complete.
///
/// # Errors
/// A reason if no column has the ball speed or the club speed: the speed of an estimated delivery
/// would only be the assumed one.
pub(crate) fn missing_launch_remark(columns: &[Column]) -> Result<Option<String>, String> {
    let near = near_known(columns);
    if !has_outcome(columns, Outcome::BallSpeed) && !has_club_speed(columns) {
        let heads: Vec<&str> = columns.iter().map(|column| &column.head[..]).collect();
        return Err(format!(
            "no column has the ball speed or the club speed{near}; give it a head that is known, \
             as in 'Ball Speed [mph]' (the heads are: {})",
            heads.join(", ")
        ));
    }
    let missing = missing_of_launch(columns);
    let them = match missing.len() {
        0 => return Ok(None),
        1 => "it",
        _ => "them",
    };
    Ok(Some(format!(
        "no column has {}: the deliveries are estimated without {them}{near}",
        missing.join(" or ")
    )))
}

/// An unknown column head, with the nearest known one.
pub(crate) fn with_nearest(head: &str) -> String {
    match nearest_head(head) {
        Some((near, _)) => format!("{head} (did you mean '{near}'?)"),
        None => head.into(),
    }
}

/// The words "; near a known head: …" with the unknown column heads that are similar to a head of
/// the club, or of a launch condition that no column has. Empty if there are none.
pub(crate) fn near_known(columns: &[Column]) -> String {
    let is_missing = |meaning: Meaning| match meaning {
        Meaning::Outcome(of) => CONDITIONS.contains(&of) && !has_outcome(columns, of),
        Meaning::Input(_) => true,
    };
    let near = columns.iter().filter(|column| column.is_unknown());
    let near = near.filter_map(|column| {
        let (near, _) = nearest_head(&column.head).filter(|near| is_missing(near.1))?;
        Some(format!("'{}' (did you mean '{near}'?)", column.head))
    });
    let near: Vec<String> = near.collect();
    if near.is_empty() {
        String::new()
    } else {
        format!("; near a known head: {}", near.join(", "))
    }
}

/// Remark on angles without a unit, which are read in degrees.
pub(crate) fn in_degrees<'a>(columns: impl IntoIterator<Item = &'a Column>) -> Option<String> {
    let heads = heads_of(columns, Column::is_in_assumed_degrees);
    let (is, have) = if heads.len() == 1 {
        ("is", "the head has")
    } else {
        ("are", "the heads have")
    };
    (!heads.is_empty()).then(|| {
        format!(
            "{} {is} read in degrees: {have} no unit, and launch monitors write angles in degrees",
            heads.join(", ")
        )
    })
}

/// Ignores columns of an export:
///
/// - of measurements and for deliveries, columns of the rest position,
/// - with a whole launch, the smash factor, unless a delivery needs it in place of a club speed,
/// - with a whole launch, columns of the club that the use of the table does not need,
/// - with a whole launch, redundant spin columns, if no row chooses among its own spin values.
///
/// Returns remarks, also on unknown columns.
pub(crate) fn ignore_columns(columns: &mut [Column], table_use: TableUse) -> Vec<Message> {
    if table_use == TableUse::Deliveries {
        // a delivery does not depend on the rest position: list it among the unused columns
        ignore_totals(columns);
    }
    let mut remarks: Vec<Message> = vec![];
    let unknown: Vec<String> = columns
        .iter()
        .filter(|column| column.is_unknown() && !column.head.is_empty())
        .map(|column| with_nearest(&column.head))
        .collect();
    if !unknown.is_empty() {
        let list = unknown.join(", ");
        remarks.push(format!("columns that are not used: {list}").into());
    }
    if table_use == TableUse::Measurements {
        remarks.extend(ignore_totals(columns));
    }
    if !has_whole_launch(columns) {
        return remarks;
    }
    let reads_club = table_use.reads_club();
    let selects_spin_by_row = table_use.selects_spin_by_row();
    // for a delivery without a club speed, the smash factor determines the speed
    let reads_smash_factor = table_use == TableUse::Deliveries && !has_club_speed(columns);
    let is_club = |column: &Column| {
        let is_of_the_strike = !reads_club && column.is_of_the_strike();
        let is_smash_factor = column.content == Content::Outcome(Outcome::SmashFactor);
        is_of_the_strike || is_smash_factor && !reads_smash_factor
    };
    let ignored = heads_of(&*columns, is_club);
    if !ignored.is_empty() {
        let reason = match reads_club {
            true => "the smash factor follows from the speeds of ball and club; left out",
            false => "the ball flies from its measured launch; columns of the club are left out",
        };
        remarks.push(format!("{reason}: {}", ignored.join(", ")).into());
    }
    let redundant = redundant_spins(columns);
    remarks.extend(match selects_spin_by_row {
        true => redundant_spins_remark(columns),
        false => spins_remark(columns, "left out"),
    });
    for column in columns
        .iter_mut()
        .filter(|column| is_club(column) || !selects_spin_by_row && is_of(column, redundant))
    {
        column.content = Content::Note;
    }
    remarks
}

/// Remark on the columns of a second statement of the spin, if each row chooses among its own
/// values.
pub(crate) fn redundant_spins_remark(columns: &[Column]) -> Option<Message> {
    let use_of_these = "these columns are used only in rows whose other spin cells are empty";
    spins_remark(columns, use_of_these)
}

fn spins_remark(columns: &[Column], use_of_these: &str) -> Option<Message> {
    let redundant = redundant_spins(columns);
    let heads = heads_of(columns, |column| is_of(column, redundant));
    let list = heads.join(", ");
    (!heads.is_empty()).then(|| format!("the spin is stated twice; {use_of_these}: {list}").into())
}

fn is_of(column: &Column, outcomes: &[Outcome]) -> bool {
    matches!(column.content, Content::Outcome(of) if outcomes.contains(&of))
}

fn redundant_spins(columns: &[Column]) -> &'static [Outcome] {
    let has = |of| has_outcome(columns, of);
    if has(Outcome::Spin) && (has(Outcome::SpinAxis) || !has(Outcome::Sidespin)) {
        &[Outcome::Backspin, Outcome::Sidespin]
    } else if has(Outcome::Backspin) {
        &[Outcome::Spin, Outcome::SpinAxis]
    } else {
        &[]
    }
}

/// The message `what: a, b` for the names a and b; `None` without names.
pub(crate) fn columns_remark<S: Borrow<str>>(what: &str, names: &[S]) -> Option<Message> {
    (!names.is_empty()).then(|| format!("{what}: {}", names.join(", ")).into())
}

/// Column heads of the columns that satisfy `is`.
pub(crate) fn heads_of<'a>(
    columns: impl IntoIterator<Item = &'a Column>,
    is: impl Fn(&Column) -> bool,
) -> Vec<&'a str> {
    columns
        .into_iter()
        .filter(|column| is(column))
        .map(|column| column.head.as_str())
        .collect()
}

/// Ignores the columns of the ball's rest position, because the ground of an export is unknown.
/// Returns a remark.
fn ignore_totals(columns: &mut [Column]) -> Option<Message> {
    let is_total =
        |column: &Column| matches!(column.content, Content::Outcome(of) if of.needs_run());
    let remark = columns_remark(
        "the rest position is not compared, since the ground of the launch monitor is not known",
        &heads_of(&*columns, is_total),
    );
    for column in columns.iter_mut().filter(|column| is_total(column)) {
        column.content = Content::Note;
    }
    remark
}
