//! A picture: a figure, and below it its other views.

use super::canvas::fine;
use super::figure::Figure;
use super::hover::escaped;
use super::svg::{Look, Panel, panel};
use crate::error::Result;
use std::fmt::Write;

/// Least width of a view in a row of several, pixels.
const LEAST_BESIDE: u32 = 280;

/// A plot as SVG. It is complete in itself, and names no other file; its colours are plain
/// attributes, which [`dark_rules`](super::dark_rules) can change on a page. Titles contain the
/// values, which a browser shows if a pointer rests on a point or a line.
///
/// # Errors
/// [`Error::Plot`](crate::Error::Plot) where nothing of it has a place on its axes.
pub fn figure_svg(figure: &Figure, look: &Look) -> Result<String> {
    let columns = figure
        .columns
        .min((look.width / LEAST_BESIDE) as usize)
        .max(1);
    let each = Look {
        width: look.width / columns as u32,
        ..*look
    };
    let panels: Vec<Panel> = std::iter::once(figure)
        .chain(&figure.panels)
        .map(|one| panel(one, &each))
        .collect::<Result<_>>()?;
    let heights = panels
        .chunks(columns)
        .map(|row| row.iter().map(|panel| panel.height).fold(0.0, f64::max));
    let (width, height) = (f64::from(look.width), heights.clone().sum::<f64>());
    let mut svg = format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {} {}\" role=\"img\" \
         aria-label=\"{}\" xmlns=\"http://www.w3.org/2000/svg\">\n<desc>{}</desc>",
        fine(width),
        fine(height),
        escaped(&figure.title),
        escaped(&figure.note),
    );
    let mut top = 0.0;
    for (row, height) in panels.chunks(columns).zip(heights) {
        for (i, Panel { body, .. }) in row.iter().enumerate() {
            let left = i as f64 * f64::from(each.width);
            // what a string takes, it takes
            let _ = if top == 0.0 && left == 0.0 {
                write!(svg, "{body}")
            } else {
                write!(
                    svg,
                    "<g transform=\"translate({} {})\">{body}</g>",
                    fine(left),
                    fine(top)
                )
            };
        }
        top += height;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
