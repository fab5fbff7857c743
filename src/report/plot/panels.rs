//! The picture of a figure, with its further views below.

use super::canvas::fine;
use super::figure::Figure;
use super::hover::escaped;
use super::svg::{Look, Panel, panel};
use crate::error::Result;
use std::fmt::Write;

/// Minimum width of a view in a row with other views, pixels.
const LEAST_BESIDE: u32 = 280;

/// A plot as self-contained SVG, without references to other files. Its colours are attributes,
/// which [`dark_rules`](super::dark_rules) can change on a page. Browsers show the values of points
/// and lines as tooltips.
///
/// # Errors
/// [`Error::Plot`](crate::Error::Plot) if no part of the plot can be shown on its axes.
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
            // writing to a string cannot fail
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
