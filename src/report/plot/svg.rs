//! The picture of a figure with its `panels`. A row of the picture has `columns` views.

use super::canvas::{Anchor, Canvas, Font, LINE, Stroke};
use super::contour::contour_regions;
use super::figure::{Figure, Layer, Shape};
use super::hover::write_tooltips;
use super::layers::{PlotArea, draw_layer, field_arrows, write_levels};
use super::layout::{Layout, MARGIN, TITLE};
use super::marks::{write_line_names, write_marks, write_texts};
use super::palette::{DARK, LIGHT};
use super::simplify::simplified;
use super::text_width::{SMALL_TEXT, TEXT};
use super::ticks::DrawnAxis;
use crate::error::Result;
use crate::units::typeset;
use maud::{PreEscaped, html};
use std::fmt::Write;

/// Length of a tick, pixels.
const TICK: f64 = 4.0;

/// Minimum width of a view in a row with other views, pixels.
const LEAST_BESIDE: u32 = 280;

/// The appearance of a plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// True for the colours of a dark page; false for those of a bright page and of print.
    pub is_dark: bool,
    /// The width, pixels. The text size does not depend on it.
    pub width: u32,
}

impl Default for Look {
    /// Light, 480 pixels: readable on a phone and in a printed column.
    fn default() -> Self {
        Self {
            is_dark: false,
            width: 480,
        }
    }
}

/// A plot as self-contained SVG, without references to other files. The colours are attributes, so
/// that the CSS of [`dark_rules`] can change them on a page. Browsers show the values of points and
/// lines as tooltips.
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

/// Draws a figure without its `panels`.
///
/// # Errors
/// [`Error::Plot`](crate::Error::Plot) if no part of the figure can be shown on its axes, or if the
/// width is too small for them.
fn panel(figure: &Figure, look: &Look) -> Result<Canvas> {
    let layout = Layout::new(figure, look.width)?;
    let mut canvas = Canvas {
        palette: if look.is_dark { &DARK } else { &LIGHT },
        height: layout.height,
        svg: String::new(),
        labelled: vec![],
    };
    let size = [f64::from(look.width), layout.height];
    canvas.rectangle([0.0, 0.0], size, canvas.palette.background, 1.0);
    write_texts_around(&mut canvas, &layout);
    draw_inside(&mut canvas, figure, &layout);
    Ok(canvas)
}

/// Draws the axes, the layers and their labels.
fn draw_inside(canvas: &mut Canvas, figure: &Figure, layout: &Layout<'_>) {
    let area = &layout.area;
    draw_axes(canvas, area, figure);
    // the contours are computed once for drawing, labels and tooltips
    let contours = |layer: &Layer| match &layer.shape {
        Shape::Contours(field) => contour_regions(field, figure.system),
        _ => vec![],
    };
    let regions: Vec<_> = figure.layers.iter().map(contours).collect();
    let layers = || figure.layers.iter().zip(&regions);
    // areas are drawn below the contour lines and the other layers
    let (areas, others): (Vec<_>, Vec<_>) = layers().partition(|(layer, _)| {
        matches!(
            layer.shape,
            Shape::Contours(_) | Shape::Region { .. } | Shape::Band(_)
        )
    });
    for (layer, regions) in areas {
        draw_layer(canvas, area, layer, regions);
    }
    let contour_line = Stroke::new(canvas.palette.faint, 0.7);
    for line in regions.iter().flatten().flat_map(|region| &region.lines) {
        canvas.line(&simplified(&area.all(line)), contour_line);
    }
    for (layer, regions) in others {
        draw_layer(canvas, area, layer, regions);
    }
    if let Some(rows) = &layout.rows {
        rows.draw(canvas, area);
        for layer in 0..figure.layers.len() {
            rows.bars(canvas, area, figure, layer);
        }
    }
    write_marks(canvas, area, figure);
    write_texts(canvas, area, figure);
    write_line_names(canvas, area, figure);
    if let Some(names) = &layout.end_names {
        names.draw(canvas, area, figure);
    }
    write_levels(canvas, area, figure, &regions);
    field_arrows(canvas, area, figure);
    write_tooltips(canvas, area, figure, &regions);
}

/// Writes the title, the line below it, the legend and the titles of the axes.
fn write_texts_around(canvas: &mut Canvas, layout: &Layout<'_>) {
    let [_, upper, right, bottom] = layout.area.frame;
    let bold = Font {
        size: TITLE,
        color: canvas.palette.ink,
        is_bold: true,
    };
    let faint = Font::new(TEXT, canvas.palette.faint);
    let mut write = |lines: &[String], first: [f64; 2], anchor: Anchor, font: Font| {
        for (i, line) in lines.iter().enumerate() {
            canvas.text(line, [first[0], first[1] + i as f64 * LINE], anchor, font);
        }
    };
    let top = 0.5 * LINE + 3.0;
    write(&layout.titles, [MARGIN, top], Anchor::Left, bold);
    let below = layout.titles.len() as f64 * LINE;
    let second = [MARGIN, below + top];
    write(&layout.subtitles, second, Anchor::Left, faint);
    let above = upper - (layout.y_title.len() as f64 - 0.5) * LINE - 8.0;
    write(&layout.y_title, [MARGIN, above], Anchor::Left, faint);
    let x_title = [right, bottom + 1.6 * LINE + 1.0];
    write(&layout.x_title, x_title, Anchor::Right, faint);
    let legend = [MARGIN, below + layout.subtitles.len() as f64 * LINE + 5.0];
    for entry in &layout.legend {
        entry.draw(canvas, legend);
    }
}

/// Draws the axes with their ticks, and the grid except under a map.
fn draw_axes(canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
    let [left, top, right, bottom] = area.frame;
    let palette = canvas.palette;
    let mesh = Stroke::new(palette.mesh, 0.8);
    let axis = Stroke::new(palette.faint, 1.0);
    let font = Font::new(SMALL_TEXT, palette.ink);
    let is_map = |layer: &Layer| matches!(layer.shape, Shape::Contours(_));
    let has_grid = !figure.layers.iter().any(is_map);
    let part = |drawn: &DrawnAxis, tick: f64| (tick - drawn.low) / (drawn.high - drawn.low);
    let x_of = |tick: &f64| left + part(&area.x, *tick) * (right - left);
    let y_of = |tick: &f64| bottom - part(&area.y, *tick) * (bottom - top);
    if has_grid {
        for x in area.x.ticks.iter().map(x_of) {
            canvas.line(&[[x, top], [x, bottom]], mesh);
        }
        for y in area.y.ticks.iter().map(y_of) {
            canvas.line(&[[left, y], [right, y]], mesh);
        }
    }
    canvas.line(&[[left, top], [left, bottom], [right, bottom]], axis);
    for tick in &area.x.ticks {
        let x = x_of(tick);
        canvas.line(&[[x, bottom], [x, bottom + TICK]], axis);
        let at = [x, bottom + 2.0 * TICK + 0.4 * SMALL_TEXT];
        canvas.text(&area.x.text(*tick), at, Anchor::Middle, font);
    }
    for tick in &area.y.ticks {
        let y = y_of(tick);
        canvas.line(&[[left - TICK, y], [left, y]], axis);
        let at = [left - 2.0 * TICK, y];
        canvas.text(&area.y.text(*tick), at, Anchor::Right, font);
    }
}

/// CSS rules that replace the light colours of pictures by dark colours. They apply inside the
/// elements that match the selector `inside`.
pub fn dark_rules(inside: &str) -> String {
    let mut rules = String::new();
    for (light, dark) in LIGHT.all().into_iter().zip(DARK.all()) {
        // writing to a string cannot fail
        let _ = writeln!(
            rules,
            "{inside} [fill=\"{light}\"]{{fill:{dark}}}{inside} \
             [stroke=\"{light}\"]{{stroke:{dark}}}"
        );
    }
    rules
}
