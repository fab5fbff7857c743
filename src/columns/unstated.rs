//! Units that an export does not state.

use super::column::{Column, Holds};
use crate::drive::Outcome;
use crate::units::Quantity;

/// What the remark about them begins with.
pub(crate) const UNSTATED: &str = "heads without a unit are read as";

/// The units of heads that state none, of an export: those of the makers' applications in the US.
const USUAL: [(Quantity, &str); 4] =
    [(Quantity::SPEED, "mph"), (Quantity::LENGTH, "yd"), (Quantity::ANGULAR_VELOCITY, "rpm"), (Quantity::TIME, "s")];

/// Reads the columns of an export that state no unit in the usual ones, and says which; angles are in degrees already.
pub(crate) fn unstated(columns: &mut [Column]) -> Option<String> {
    let mut told = vec![];
    for column in columns.iter_mut().filter(|column| column.lacks_unit()) {
        let Some((_, unit)) = USUAL.iter().find(|(quantity, _)| column.kind() == Some(*quantity)) else { continue };
        let is_height = column.holds == Holds::Outcome(Outcome::ApexHeight);
        let unit = if is_height { "ft" } else { unit };
        told.push(format!("{} in {unit}", column.head));
        *column = column.clone().in_unit(unit);
    }
    (!told.is_empty()).then(|| format!("{UNSTATED} {}; write other units into the heads", told.join(", ")))
}
