//! The style of the plots of drives, and the conversion of grids to fields. A drive has the same
//! colour and dash pattern in all plots.

use crate::drive::Outcome;
use crate::report::plot::{Field, Hue, Layer, NamedQuantity, Shape};
use crate::study::{DriveRole, Plane};

/// The colour of a drive, and true if its lines are dashed.
pub(super) fn style(role: DriveRole) -> (Hue, bool) {
    match role {
        DriveRole::Alone | DriveRole::AsSetUp => (Hue::SET_UP, false),
        DriveRole::Optimum => (Hue::OPTIMUM, true),
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
