//! Sign conventions of the spin: detects columns whose positive values are to the left.

use crate::drive::Outcome;
use crate::table::{Column, Content, has_outcome};

/// Minimum fraction of the rows that agree on a sign convention.
const SHARE: f64 = 0.8;

/// The side of a lateral curve counts if the curve exceeds this fraction of the carry.
const LEAST_CURVE: f64 = 0.01;

/// Reverses the signs of spin columns whose positive values are to the left, and returns a message
/// about them.
pub(super) fn turn_spins(
    maker: Option<&str>,
    columns: &mut [Column],
    rows: &[Vec<String>],
) -> Option<String> {
    let turned = turned_spins(maker, columns, rows);
    let is_turned =
        |column: &Column| matches!(column.content, Content::Outcome(of) if turned.contains(&of));
    let mut names = vec![];
    for column in columns.iter_mut().filter(|column| is_turned(column)) {
        column.is_turned = !column.is_turned;
        names.push(column.head.as_str());
    }
    let (is, why) = match turned.contains(&Outcome::SpinAxis) {
        true => ("are", ": the balls curve to the opposite side"),
        false => ("is", ", as Garmin's exports have it"),
    };
    (!names.is_empty())
        .then(|| format!("{} {is} read with + to the left{why}", names.join(" and ")))
}

/// The spins whose positive values are to the left, in exports of Garmin. Positive values of
/// `Sidespin` are to the left if the table has no spin axis, or if sidespin and spin axis have
/// opposite signs. If the signs agree, but the balls curve to the opposite side, positive values of
/// both are to the left.
fn turned_spins(
    maker: Option<&str>,
    columns: &[Column],
    rows: &[Vec<String>],
) -> &'static [Outcome] {
    if maker != Some("Garmin") || !has_outcome(columns, Outcome::Sidespin) {
        return &[];
    }
    if !has_outcome(columns, Outcome::SpinAxis) {
        return &[Outcome::Sidespin];
    }
    let signs: Vec<Signs> = rows.iter().map(|row| Signs::of(columns, row)).collect();
    let are_opposite = mostly(
        signs
            .iter()
            .filter_map(|row| Some(row.sidespin? != row.axis?)),
    );
    let curves_against = mostly(signs.iter().filter_map(|row| Some(row.curve? != row.axis?)));
    match (are_opposite, curves_against) {
        (true, _) => &[Outcome::Sidespin],
        (false, true) => &[Outcome::Sidespin, Outcome::SpinAxis],
        (false, false) => &[],
    }
}

/// Signs of the values of a row, true for +; `None` for a missing value, for 0, and for a curve
/// below [`LEAST_CURVE`].
struct Signs {
    sidespin: Option<bool>,
    axis: Option<bool>,
    /// Side of the landing point relative to the launch direction.
    curve: Option<bool>,
}

impl Signs {
    fn of(columns: &[Column], row: &[String]) -> Self {
        let value = |of: Outcome| {
            let at = columns
                .iter()
                .position(|column| column.content == Content::Outcome(of))?;
            columns[at].value(row.get(at)?).ok().flatten()
        };
        let sign = |value: f64| (value != 0.0).then_some(value > 0.0);
        let curve = || {
            let (carry, side) = (value(Outcome::CarryDistance)?, value(Outcome::Lateral)?);
            let curve = side - carry * value(Outcome::LaunchDirection)?.sin();
            sign(curve).filter(|_| curve.abs() > LEAST_CURVE * carry)
        };
        let [sidespin, axis] =
            [Outcome::Sidespin, Outcome::SpinAxis].map(|of| value(of).and_then(sign));
        Self {
            sidespin,
            axis,
            curve: curve(),
        }
    }
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
