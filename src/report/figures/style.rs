//! The style of the plots of drives, and the conversion of grids to fields. A drive has the same
//! colour and dash pattern in all plots.

use crate::drive::Outcome;
use crate::report::plot::{Field, Hue, Layer, NamedQuantity, Shape};
use crate::study::{NamedDrive, Plane};

/// The colour of a drive, and true if its lines are dashed. [`NamedDrive::AS_SET_UP`] and
/// [`NamedDrive::OPTIMUM`] have fixed styles. A drive with another name has the colour of series
/// `place`, with dashed lines except for series 0.
pub(super) fn style(name: &str, place: usize) -> (Hue, bool) {
    match name {
        NamedDrive::AS_SET_UP => (Hue::SET_UP, false),
        NamedDrive::OPTIMUM => (Hue::OPTIMUM, true),
        _ => (Hue::Series(place), place > 0),
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
