//! The picture of a figure, with its further views below.

use super::canvas::Canvas;
use super::figure::Figure;
use super::svg::{Look, panel};
use crate::error::Result;
use crate::units::typeset;
use maud::{PreEscaped, html};

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
    let panels: Vec<Canvas> = std::iter::once(figure)
        .chain(&figure.panels)
        .map(|one| panel(one, &each))
        .collect::<Result<_>>()?;
    let heights = panels
        .chunks(columns)
        .map(|row| row.iter().map(|panel| panel.height).fold(0.0, f64::max));
    let (width, height) = (f64::from(look.width), heights.clone().sum::<f64>());
    let mut top = 0.0;
    let mut views = vec![];
    for (row, height) in panels.chunks(columns).zip(heights) {
        for (i, panel) in row.iter().enumerate() {
            let left = i as f64 * f64::from(each.width);
            let body = PreEscaped(&panel.svg);
            views.push(if top == 0.0 && left == 0.0 {
                html! { (body) }
            } else {
                html! { g transform={ "translate(" (left) " " (top) ")" } { (body) } }
            });
        }
        top += height;
    }
    let svg = html! {
        svg width=(width) height=(height) viewBox={ "0 0 " (width) " " (height) } role="img"
            aria-label=(typeset(&figure.title)) xmlns="http://www.w3.org/2000/svg" {
            "\n" desc { (typeset(&figure.note)) } "\n"
            @for view in views { (view) }
        }
    };
    Ok(svg.0 + "\n")
}
