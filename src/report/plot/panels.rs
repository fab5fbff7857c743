//! A picture: a figure, and below it its other views.

use super::canvas::fine;
use super::figure::Figure;
use super::hover::escaped;
use super::svg::{Look, Panel, panel};
use crate::error::Result;
use std::fmt::Write;

/// A plot as SVG, a picture that scales. It is complete in itself, and names no other file; its colours are plain
/// attributes, which [`dark_rules`](super::dark_rules) can change on a page. Values stand in titles, which a browser shows where a pointer
/// rests on a point or a line.
///
/// # Errors
/// [`Error::Plot`](crate::Error::Plot) where nothing of it has a place on its axes.
pub fn figure_svg(figure: &Figure, look: &Look) -> Result<String> {
    let panels: Vec<Panel> =
        std::iter::once(figure).chain(&figure.panels).map(|one| panel(one, look)).collect::<Result<_>>()?;
    let (width, height) = (f64::from(look.width), panels.iter().map(|panel| panel.height).sum::<f64>());
    let mut svg = format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {} {}\" role=\"img\" \
         aria-label=\"{}\" xmlns=\"http://www.w3.org/2000/svg\">\n<desc>{}</desc>",
        fine(width),
        fine(height),
        escaped(&figure.title),
        escaped(&figure.note),
    );
    let mut top = 0.0;
    for Panel { body, height } in panels {
        // what a string takes, it takes
        let _ = if top == 0.0 {
            write!(svg, "{body}")
        } else {
            write!(svg, "<g transform=\"translate(0 {})\">{body}</g>", fine(top))
        };
        top += height;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
