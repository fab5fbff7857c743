//! Tooltips: SVG titles on invisible shapes.

use super::axis::{Axis, Measure, Scale};
use super::canvas::fine;
use super::contour::Ground;
use super::figure::{Figure, Layer};
use super::layers::Plane;
use crate::units::{Quantity, System, significant, typeset};
use std::fmt::Write;

/// Maximum number of points of a line with a tooltip at each point.
const FEW: usize = 40;

/// The tooltips of all values, as SVG; `grounds` are the contour regions of each layer.
pub(super) fn titles(
    figure: &Figure,
    plane: &Plane<'_>,
    system: System,
    grounds: &[Vec<Ground>],
) -> String {
    let mut svg = String::new();
    let at = |name: &str, [x, y]: [f64; 2]| {
        let values =
            [(&figure.x, x), (&figure.y, y)].map(|(axis, value)| on_axis(axis, value, system));
        [name.to_owned()]
            .into_iter()
            .chain(values)
            .filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join(", ")
    };
    let mut point = |name: &str, place: [f64; 2]| {
        if let Some([x, y]) = plane.pixel(place) {
            let title = escaped(&at(name, place));
            // writing to a string cannot fail
            let _ = writeln!(
                svg,
                "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"none\" \
                 pointer-events=\"all\"><title>{title}</title></circle>",
                fine(x),
                fine(y),
                fine(7.0)
            );
        }
    };
    let mut lines: Vec<(String, &[[f64; 2]])> = vec![];
    for (layer, grounds) in figure.layers.iter().zip(grounds) {
        let Layer::Contours(field) = layer else {
            continue;
        };
        let unit = system.unit(field.measure.unit);
        for ground in grounds {
            let title = format!(
                "{} {} {unit}",
                field.measure.label,
                significant(ground.level, 6)
            );
            lines.extend(
                ground
                    .lines
                    .iter()
                    .map(|piece| (title.trim_end().to_owned(), piece.as_slice())),
            );
        }
    }
    for layer in &figure.layers {
        match layer {
            Layer::Line { name, points, .. } if points.len() > FEW => {
                let pieces = points.split(|[x, y]| !(x.is_finite() && y.is_finite()));
                lines.extend(pieces.map(|piece| (name.clone(), piece)));
            }
            Layer::Line { name, points, .. } | Layer::Dots { name, points, .. } => {
                points.iter().for_each(|place| point(name, *place));
            }
            Layer::Mark { name, at, .. } => point(name, *at),
            Layer::Bars { name, bars, .. } => bars
                .iter()
                .for_each(|bar| point(name, [bar.to, bar.place as f64])),
            _ => {}
        }
    }
    for (title, points) in lines {
        let places: Vec<_> = points
            .iter()
            .filter_map(|place| plane.pixel(*place))
            .collect();
        if title.is_empty() || places.len() < 2 {
            continue;
        }
        let path: Vec<String> = places
            .iter()
            .map(|[x, y]| format!("{},{}", fine(*x), fine(*y)))
            .collect();
        let _ = writeln!(
            svg,
            "<path d=\"M{}\" fill=\"none\" stroke=\"none\" stroke-width=\"{}\" \
             pointer-events=\"stroke\"><title>{}</title></path>",
            path.join("L"),
            fine(8.0),
            escaped(&title)
        );
    }
    svg
}

/// A value with the name of its axis: "carry 279.2 yd"; for an axis of names, only the name.
fn on_axis(axis: &Axis, value: f64, system: System) -> String {
    match &axis.scale {
        Scale::Names(names) => names
            .get(value.round() as usize)
            .cloned()
            .unwrap_or_default(),
        _ => format!(
            "{} {}",
            axis.measure.label,
            of(&axis.measure, value, system)
        )
        .trim()
        .to_owned(),
    }
}

fn of(measure: &Measure, value: f64, system: System) -> String {
    if measure.quantity == Quantity::NUMBER {
        return significant(value, 4);
    }
    measure.quantity.read_off(value, system.unit(measure.unit))
}

/// Typeset text, with XML's special characters escaped.
pub(super) fn escaped(text: &str) -> String {
    typeset(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
