//! Names of lines, written on the lines.

use super::canvas::{LINE, Labels};
use super::figure::{Figure, Layer, LineNames};
use super::layers::{Plane, place_on};
use super::marks::write_near;

/// Minimum distance of a name from a label beside it: two labels in a row would look like one,
/// pixels.
const APART: f64 = 8.0;

/// Writes the names of lines on the lines, if the figure has them there. A name without
/// space on its line is written next to it.
pub(super) fn write_line_names(labels: &mut Labels<'_>, plane: &Plane<'_>, figure: &Figure) {
    let is_on_lines = figure.line_names == LineNames::OnLines;
    for layer in figure.layers.iter().filter(|_| is_on_lines) {
        let Layer::Line {
            name, hue, points, ..
        } = layer
        else {
            continue;
        };
        let (places, color) = (plane.all(points), labels.canvas.palette.of(*hue));
        if name.is_empty() {
            continue;
        }
        match place_on(labels, plane, &places, name, APART) {
            Some(middle) => labels.write(name, middle, color, true),
            // a line without a name could not be identified
            None => {
                if let Some(at) = places.get(places.len() / 2) {
                    write_near(labels, plane, name, *at, color, LINE);
                }
            }
        }
    }
}
