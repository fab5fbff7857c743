//! What the pictures of drives share: a drive has the same colour and dashes in all of them, and
//! grids become fields.

use crate::report::plot::{Field, Hue, Measure};
use crate::study::{Plane, Vary};

/// The colour of a drive, and whether its lines are dashed: by what it is, and where its name does
/// not say, by its place.
pub(super) fn style(name: &str, place: usize) -> (Hue, bool) {
    match name {
        "as set up" => (Hue::SET_UP, false),
        "optimum" => (Hue::OPTIMUM, true),
        _ => (Hue::Series(place), place > 0),
    }
}

/// An outcome of a grid as a field to draw.
pub(super) fn field(plane: &Plane, of: usize, measure: Measure) -> Field {
    let values = plane.values.get(of).map_or(&[][..], Vec::as_slice);
    field_of(measure, plane.across, plane.up, plane.columns, values)
}

/// Values at the nodes of a grid as a field to draw.
pub(super) fn field_of(
    measure: Measure,
    across: Vary,
    up: Vary,
    columns: usize,
    values: &[Option<f64>],
) -> Field {
    let (x, y) = ([across.low, across.high], [up.low, up.high]);
    Field {
        measure,
        x,
        y,
        columns,
        values: values.to_vec(),
        nothing: "no drive",
        beside: vec![],
    }
}
