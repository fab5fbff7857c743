//! The style of the plots of drives, and the conversion of grids to fields. A drive has the same
//! colour and dash pattern in all plots.

use crate::drive::Outcome;
use crate::report::plot::{Field, Hue, Layer, NamedQuantity, Shape};
use crate::study::{DriveRole, Plane};

/// The first series of drives with names of their own; series 0 and 1 are the drive as set up and
/// the optimum.
const OTHERS: usize = 2;

/// The colour of a drive, and true if its lines are dashed. `place` is the place of the drive among
/// those of the plot. A drive with a name of its own has a later series than the drive as set up
/// and the optimum.
pub(super) fn style(role: &DriveRole, place: usize) -> (Hue, bool) {
    match role {
        DriveRole::Alone | DriveRole::AsSetUp => (Hue::SET_UP, false),
        DriveRole::Optimum => (Hue::OPTIMUM, true),
        DriveRole::Other(_) => (Hue::Series(OTHERS + place), place > 0),
    }
}

/// Clears the names of lines, dots and marks in a second view, because the legend of the first view
/// already has the names.
pub(super) fn clear_names(layers: &mut [Layer]) {
    for layer in layers {
        if let Shape::Line { .. } | Shape::Dots(_) | Shape::Mark(_) = layer.shape {
            layer.name.clear();
            layer.remark.clear();
        }
    }
}

/// The field of an outcome for a plot: values and gradients. `of` is the index of the outcome in
/// `plane`. If the plane lacks this outcome, the field has no values.
pub(super) fn field(plane: &Plane, of: usize, outcome: Outcome) -> Field {
    Field {
        quantity: NamedQuantity::outcome(outcome),
        x: [plane.across.low, plane.across.high],
        y: [plane.up.low, plane.up.high],
        columns: plane.columns,
        values: plane.values.get(of).cloned().unwrap_or_default(),
        gradients: plane.gradients.get(of).cloned().unwrap_or_default(),
        common_values: vec![],
    }
}
