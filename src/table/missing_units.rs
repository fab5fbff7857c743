//! Units that an export does not state.

use super::column::{Column, Holds};
use crate::drive::Outcome;
use crate::units::Quantity;

/// Prefix of the remark.
pub(crate) const ASSUMED_UNITS: &str = "heads without a unit are read as";

/// The units of heads that state none, of an export: those of the makers' applications in the US.
const USUAL: [(Quantity, &str); 4] = [
    (Quantity::SPEED, "mph"),
    (Quantity::LENGTH, "yd"),
    (Quantity::ANGULAR_VELOCITY, "rpm"),
    (Quantity::TIME, "s"),
];

/// Reads the columns of an export that state no unit in the usual ones, and says which; angles are
/// in degrees already. Where the cells of a column state their units, they are read in those.
pub(crate) fn assume_units(
    columns: &mut [Column],
    states_unit: impl Fn(usize, &Column) -> bool,
) -> Option<String> {
    let mut told = vec![];
    for (at, column) in columns.iter_mut().enumerate() {
        let is_untold = column.lacks_unit() || column.is_in_degrees_untold();
        if is_untold && states_unit(at, column) {
            *column = column.clone().with_units_in_cells();
            continue;
        }
        if !column.lacks_unit() {
            continue;
        }
        let Some((_, unit)) = USUAL
            .iter()
            .find(|(quantity, _)| column.kind() == Some(*quantity))
        else {
            continue;
        };
        let is_height = column.holds == Holds::Outcome(Outcome::ApexHeight);
        let unit = if is_height { "ft" } else { unit };
        told.push(format!("{} in {unit}", column.head));
        *column = column.clone().in_unit(unit);
    }
    (!told.is_empty()).then(|| {
        format!(
            "{ASSUMED_UNITS} {}; write other units into the heads",
            told.join(", ")
        )
    })
}
