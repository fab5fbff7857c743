//! Sign conventions of the spin: detects columns whose positive values are to the left.

use super::column::{Column, Content};
use super::export_columns::has_outcome;
use super::numbers::CellSide;
use crate::drive::Outcome;

/// Minimum fraction of the rows that agree on a sign convention.
const SHARE: f64 = 0.8;

/// Smallest lateral curve that shows the side to which the ball curves, as a fraction of the carry.
const LEAST_CURVE: f64 = 0.01;

/// Reads the spin columns of an export whose positive values are to the left in this way, and
/// returns their indices. A column that states its signs is not changed.
pub(super) fn turn_spins(
    maker: Option<&str>,
    columns: &mut [Column],
    rows: &[Vec<String>],
) -> Vec<usize> {
    let turned = turned_spins(maker, columns, rows);
    let mut at = vec![];
    for (own, column) in columns.iter_mut().enumerate() {
        let is_turned = matches!(column.content, Content::Outcome(of) if turned.contains(&of));
        if is_turned && column.positive_side.is_none() {
            column.positive_side = Some(CellSide::LEFT);
            at.push(own);
        }
    }
    at
}

/// Message about the columns that [`turn_spins`] changed, without those that are ignored since then.
pub(super) fn turned_remark(columns: &[Column], turned: &[usize]) -> Option<String> {
    let turned = turned.iter().map(|at| &columns[*at]);
    let read: Vec<&Column> = turned
        .filter(|column| matches!(column.content, Content::Outcome(_)))
        .collect();
    let names: Vec<&str> = read.iter().map(|column| column.head.as_str()).collect();
    let is = if names.len() > 1 { "are" } else { "is" };
    let is_axis = |column: &&Column| column.content == Content::Outcome(Outcome::SpinAxis);
    let why = match read.iter().any(is_axis) {
        true => ": the balls curve to the opposite side",
        false => ", as Garmin's exports have it",
    };
    (!names.is_empty())
        .then(|| format!("{} {is} read with + to the left{why}", names.join(" and ")))
}

/// The spins whose positive values are to the left, in exports of Garmin:
///
/// - `Sidespin`, if no row has a spin axis, or if sidespin and spin axis have opposite signs
/// - `Sidespin` and the spin axis, if their signs agree, but the balls curve to the opposite side
fn turned_spins(
    maker: Option<&str>,
    columns: &[Column],
    rows: &[Vec<String>],
) -> &'static [Outcome] {
    if maker != Some("Garmin") || !has_outcome(columns, Outcome::Sidespin) {
        return &[];
    }
    // a column without a value states no axis
    let has_axis = |row: &Vec<String>| value(columns, row, Outcome::SpinAxis).is_some();
    if !rows.iter().any(has_axis) {
        return &[Outcome::Sidespin];
    }
    // true if positive, false if negative, `None` if 0
    let sign = |value: f64| (value != 0.0).then_some(value > 0.0);
    let sign_of = |row: &[String], of: Outcome| sign(value(columns, row, of)?);
    let are_opposite = mostly(rows.iter().filter_map(|row| {
        let axis = sign_of(row, Outcome::SpinAxis)?;
        Some(sign_of(row, Outcome::Sidespin)? != axis)
    }));
    let curves_against = mostly(rows.iter().filter_map(|row| {
        let axis = sign_of(row, Outcome::SpinAxis)?;
        Some(sign(curve(columns, row)?)? != axis)
    }));
    match (are_opposite, curves_against) {
        (true, _) => &[Outcome::Sidespin],
        (false, true) => &[Outcome::Sidespin, Outcome::SpinAxis],
        (false, false) => &[],
    }
}

/// The value of an outcome in a row, SI.
fn value(columns: &[Column], row: &[String], of: Outcome) -> Option<f64> {
    let at = columns
        .iter()
        .position(|column| column.content == Content::Outcome(of))?;
    columns[at].value(row.get(at)?).ok().flatten()
}

/// Lateral distance of the landing point from the launch direction, m; `None` if the distance is at
/// most [`LEAST_CURVE`] times the carry.
fn curve(columns: &[Column], row: &[String]) -> Option<f64> {
    let value = |of| value(columns, row, of);
    let (carry, side) = (value(Outcome::CarryDistance)?, value(Outcome::Lateral)?);
    let curve = side - carry * value(Outcome::LaunchDirection)?.sin();
    (curve.abs() > LEAST_CURVE * carry).then_some(curve)
}

/// True if at least one row is true, and the fraction of true rows is at least [`SHARE`].
fn mostly(rows: impl Iterator<Item = bool>) -> bool {
    let (mut all, mut yes) = (0_u32, 0_u32);
    for row in rows {
        all += 1;
        yes += u32::from(row);
    }
    yes > 0 && f64::from(yes) >= SHARE * f64::from(all)
}
