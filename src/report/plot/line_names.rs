//! Names of lines, written on the lines.

use super::canvas::Labels;
use super::figure::{Figure, Layer};
use super::layers::{Plane, place_on};
use super::marks::write_near;
use crate::error::Result;

/// Writes the names of lines on the lines, if the figure has no legend for them. A name without
/// space on its line is written next to it.
pub(super) fn write_line_names(
    labels: &mut Labels<'_, '_>,
    plane: &Plane<'_>,
    figure: &Figure,
) -> Result<()> {
    for layer in figure.layers.iter().filter(|_| figure.names_on_lines) {
        let Layer::Line {
            name, hue, points, ..
        } = layer
        else {
            continue;
        };
        let (places, color) = (plane.all(points), labels.palette.of(*hue));
        if name.is_empty() {
            continue;
        }
        match place_on(labels, plane, &places, name) {
            Some(middle) => labels.write(name, middle, color, true)?,
            // a line without a name could not be identified
            None => places
                .get(places.len() / 2)
                .map_or(Ok(()), |at| write_near(labels, plane, name, *at, color))?,
        }
    }
    Ok(())
}
