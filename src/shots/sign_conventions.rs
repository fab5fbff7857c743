//! Sign conventions of the spin: detects columns whose positive values are to the left.

use crate::drive::Outcome;
use crate::table::{Column, Content, has_outcome};

/// Flags for spin columns whose positive values are to the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct SignConventions {
    sidespin: bool,
    axis: bool,
}

/// Minimum fraction of the rows that agree on a sign convention.
const SHARE: f64 = 0.8;

/// The side of a lateral curve counts if the curve exceeds this fraction of the carry.
const STRAIGHT: f64 = 0.01;

impl SignConventions {
    /// Detects such columns in exports of Garmin. Positive values of `Sidespin` are to the left if
    /// the table has no spin axis, or if sidespin and spin axis have opposite signs. If these signs
    /// agree and the balls curve to the other side, positive values of both are to the left.
    pub fn detect(maker: Option<&str>, columns: &[Column], rows: &[Vec<String>]) -> Self {
        if maker != Some("Garmin") || !has_outcome(columns, Outcome::Sidespin) {
            return Self::default();
        }
        if !has_outcome(columns, Outcome::SpinAxis) {
            return Self {
                sidespin: true,
                axis: false,
            };
        }
        let signs: Vec<Signs> = rows.iter().map(|row| Signs::of(columns, row)).collect();
        if mostly(
            signs
                .iter()
                .filter_map(|row| Some(row.sidespin? != row.axis?)),
        ) {
            return Self {
                sidespin: true,
                axis: false,
            };
        }
        let curves_against = mostly(signs.iter().filter_map(|row| Some(row.curve? != row.axis?)));
        Self {
            sidespin: curves_against,
            axis: curves_against,
        }
    }

    /// Reverses the signs of the affected columns, and returns a message about them.
    pub fn apply(self, columns: &mut [Column]) -> Option<String> {
        let mut names = vec![];
        for column in columns {
            let is_turned = match column.content {
                Content::Outcome(Outcome::Sidespin) => self.sidespin,
                Content::Outcome(Outcome::SpinAxis) => self.axis,
                _ => false,
            };
            if is_turned {
                column.is_turned = !column.is_turned;
                names.push(column.head.as_str());
            }
        }
        let (is, why) = match self.axis {
            true => ("are", ": the balls curve to the opposite side"),
            false => ("is", ", as Garmin's exports have it"),
        };
        (!names.is_empty())
            .then(|| format!("{} {is} read with + to the left{why}", names.join(" and ")))
    }
}

/// Signs of the values of a row, true for +; `None` for a missing value, for 0, and for a curve
/// that is too small.
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
            sign(curve).filter(|_| curve.abs() > STRAIGHT * carry)
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
