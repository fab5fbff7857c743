//! Tooltips: SVG titles on invisible shapes.

use super::axis::{Axis, AxisScale};
use super::canvas::Canvas;
use super::contour::ContourRegion;
use super::figure::{Figure, Layer, Shape};
use super::layers::PlotArea;
use super::simplify::simplified;
use crate::report::shown::side;
use crate::units::{Quantity, System, significant, typed};

/// A line with more points than this has one tooltip for each piece. Other lines have a tooltip at
/// each point.
const FEW: usize = 40;

/// Writes the tooltips of points, marks, bars, lines and contour lines. `regions` are the contour
/// regions of each layer.
pub(super) fn write_tooltips(
    canvas: &mut Canvas,
    area: &PlotArea,
    figure: &Figure,
    regions: &[Vec<ContourRegion>],
) {
    for layer in &figure.layers {
        let name = layer.full_name();
        for place in points(layer) {
            if let Some(at) = area.pixel(place) {
                canvas.point_tooltip(&title(figure, &name, place), at, 7.0);
            }
        }
    }
    let contours = figure.layers.iter().zip(regions);
    let contours = contours.flat_map(|(layer, regions)| contours_of(layer, regions, figure.system));
    for (title, points) in contours.chain(figure.layers.iter().flat_map(long_lines)) {
        let places = simplified(&area.all(points));
        if !title.is_empty() && places.len() > 1 {
            canvas.line_tooltip(&title, &places, 8.0);
        }
    }
}

/// The title of a point: its name and its coordinates.
fn title(figure: &Figure, name: &str, [x, y]: [f64; 2]) -> String {
    let values = [(&figure.x, x), (&figure.y, y)];
    let values = values.map(|(axis, value)| on_axis(axis, value, figure.system));
    let parts = [name.to_owned()].into_iter().chain(values);
    parts
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join(", ")
}

/// The points of a layer that have a tooltip of their own. The points of a long line have none.
fn points(layer: &Layer) -> Vec<[f64; 2]> {
    match &layer.shape {
        Shape::Line { points, .. } if points.len() > FEW => vec![],
        Shape::Line { .. } | Shape::Dots(_) | Shape::Mark(_) => layer.points(),
        Shape::Bars(bars) => bars.iter().map(|bar| [bar.to, bar.row as f64]).collect(),
        _ => vec![],
    }
}

/// The pieces of a line with more than `FEW` points, with the name of the line.
fn long_lines(layer: &Layer) -> Vec<(String, &[[f64; 2]])> {
    match &layer.shape {
        Shape::Line { points, .. } if points.len() > FEW => points
            .split(|[x, y]| !(x.is_finite() && y.is_finite()))
            .map(|piece| (layer.full_name(), piece))
            .collect(),
        _ => vec![],
    }
}

/// The contour lines of a layer with their levels.
fn contours_of<'a>(
    layer: &Layer,
    regions: &'a [ContourRegion],
    system: System,
) -> Vec<(String, &'a [[f64; 2]])> {
    let Shape::Contours(field) = &layer.shape else {
        return vec![];
    };
    let unit = system.unit(field.quantity.of.unit);
    let of = |region: &'a ContourRegion| {
        let level = typed(&significant(region.level, 6), unit);
        let title = format!("{} {level}", field.quantity.label);
        let lines = region.lines.iter();
        lines.map(move |piece| (title.clone(), piece.as_slice()))
    };
    regions.iter().flat_map(of).collect()
}

/// A value with the name of its axis: "carry 279.2 yd". On an axis of names: only the name. On an
/// axis of distances from the target line: only the distance, "16.3 yd R".
fn on_axis(axis: &Axis, value: f64, system: System) -> String {
    match &axis.scale {
        AxisScale::Names(names) => names
            .get(value.round() as usize)
            .cloned()
            .unwrap_or_default(),
        AxisScale::LeftRight => side(axis.quantity.of, value, system),
        AxisScale::Linear | AxisScale::Log => {
            let quantity = &axis.quantity;
            let value = match quantity.of.quantity {
                Quantity::NUMBER => significant(value, 4),
                _ => quantity.of.read_off(value, system),
            };
            format!("{} {value}", quantity.label).trim().to_owned()
        }
    }
}
