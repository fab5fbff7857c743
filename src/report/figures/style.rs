//! Common style of the plots of drives, and conversion of grids to fields. A drive has one colour
//! and one dash pattern in all plots, and the titles of all plots use the same words.

use crate::drive::Outcome;
use crate::report::plot::{Field, Hue, Layer, NamedQuantity};
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

/// Clears the names of layers in a further view, because the legend of the first view has them.
pub(super) fn clear_names(layers: &mut [Layer]) {
    for layer in layers {
        if let Layer::Line { name, .. } | Layer::Dots { name, .. } | Layer::Mark { name, .. } =
            layer
        {
            name.clear();
        }
    }
}

/// The outcome `outcome`, with index `of` in `plane`, as a field of a plot with gradients. A
/// `plane` without this outcome gives a field without values.
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
