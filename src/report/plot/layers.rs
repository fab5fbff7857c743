//! Draws each kind of layer, in pixels of the plot.

use super::canvas::{Canvas, SIGN, Stroke};
use super::contour::ContourRegion;
use super::figure::{Field, Figure, Hue, Layer, Shape};
use super::hatching::hatching;
use super::palette::{BAND_OPACITY, Color};
use super::simplify::simplified;
use super::ticks::DrawnAxis;
use crate::units::{significant, with_unit};

/// Distance between the start of a line and its first cross bar, pixels. In the legend, this bar is
/// in the middle of the symbol.
const FIRST_BARS: f64 = 0.5 * SIGN;
/// Distance between cross bars, pixels.
const BARS_APART: f64 = 32.0;

/// Width of the lines of background elements, pixels.
const THIN: f64 = 1.2;
/// Width of the lines of foreground elements, pixels.
const WIDE: f64 = 2.0;

/// Radius of a dot, pixels.
const DOT: f64 = 3.0;

/// Distance between hatching lines, pixels.
const HATCHES_APART: f64 = 11.0;

/// The axes of a plot, and the rectangle of the plot in the picture.
pub(super) struct PlotArea {
    pub x: DrawnAxis,
    pub y: DrawnAxis,
    /// Left, top, right and bottom, pixels.
    pub frame: [f64; 4],
}

impl PlotArea {
    /// The pixel of SI coordinates; `None` outside of the axes.
    pub fn pixel(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [left, top, right, bottom] = self.frame;
        let along = |drawn: &DrawnAxis, value: f64, from: f64, to: f64| {
            let part = (drawn.position(value)? - drawn.low) / (drawn.high - drawn.low);
            (-1e-6..=1.0 + 1e-6)
                .contains(&part)
                .then_some(from + part * (to - from))
        };
        Some([
            along(&self.x, x, left, right)?,
            along(&self.y, y, bottom, top)?,
        ])
    }

    /// The pixels of the points inside the axes.
    pub fn all(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points
            .iter()
            .filter_map(|point| self.pixel(*point))
            .collect()
    }

    /// The pieces of a line inside the axes.
    pub fn pieces(&self, points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let placed: Vec<_> = points.iter().map(|point| self.pixel(*point)).collect();
        placed
            .split(Option::is_none)
            .map(|piece| piece.iter().flatten().copied().collect())
            .collect()
    }
}

/// Draws one layer. `regions` are the contour regions of this layer. Contour lines and labels are
/// drawn later.
pub(super) fn draw_layer(
    canvas: &mut Canvas,
    area: &PlotArea,
    layer: &Layer,
    regions: &[ContourRegion],
) {
    let hue = layer.hue;
    let color = canvas.palette.of(hue);
    match &layer.shape {
        Shape::Line { is_dashed, points } => {
            for piece in area.pieces(points) {
                series(canvas, &piece, hue, *is_dashed);
            }
        }
        Shape::Dots(points) => {
            for at in area.all(points) {
                point(canvas, at, hue);
            }
        }
        Shape::Band(points) => {
            let low = points.iter().map(|[x, low, _]| [*x, *low]);
            let high = points.iter().rev().map(|[x, _, high]| [*x, *high]);
            let outline = area.all(&low.chain(high).collect::<Vec<_>>());
            canvas.polygon(&outline, color, BAND_OPACITY);
        }
        Shape::Contours(field) => fill_contours(canvas, area, field, regions),
        // drawn by `BarRows::bars`, `write_marks` and `write_texts`
        Shape::Bars(_) | Shape::Mark(_) | Shape::Text(_) => {}
        // the arrows of a field are drawn after the labels, which have precedence
        Shape::Arrows(_) if !layer.name.is_empty() => {}
        Shape::Arrows(arrows) => {
            for [from, to] in pixels(area, arrows) {
                arrow(canvas, from, to, color);
            }
        }
        Shape::Region { is_hatched, rings } => {
            let rings: Vec<_> = rings.iter().map(|ring| area.all(ring)).collect();
            region(canvas, &rings, hue, *is_hatched);
        }
    }
}

/// Draws the arrows of fields, except those that a label or mark would partly cover.
pub(super) fn field_arrows(canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
    for layer in &figure.layers {
        let Shape::Arrows(arrows) = &layer.shape else {
            continue;
        };
        if layer.name.is_empty() {
            continue;
        }
        let color = canvas.palette.of(layer.hue);
        for [from, to] in pixels(area, arrows) {
            let end = |pick: fn(f64, f64) -> f64| [pick(from[0], to[0]), pick(from[1], to[1])];
            if canvas.is_free([end(f64::min), end(f64::max)]) {
                arrow(canvas, from, to, color);
            }
        }
    }
}

/// The arrows with both ends inside the axes, in pixels.
fn pixels(area: &PlotArea, arrows: &[[[f64; 2]; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    arrows
        .iter()
        .filter_map(|[from, to]| Some([area.pixel(*from)?, area.pixel(*to)?]))
}

/// Writes the levels of contours where there is space.
pub(super) fn write_levels(
    canvas: &mut Canvas,
    area: &PlotArea,
    figure: &Figure,
    regions: &[Vec<ContourRegion>],
) {
    let ink = canvas.palette.ink;
    for (layer, regions) in figure.layers.iter().zip(regions) {
        let Shape::Contours(field) = &layer.shape else {
            continue;
        };
        let unit = figure.system.unit(field.quantity.of.unit);
        for region in regions {
            let text = with_unit(&significant(region.level, 6), unit);
            let mut lines: Vec<_> = region.lines.iter().map(|line| area.all(line)).collect();
            lines.sort_by_key(|line| std::cmp::Reverse(line.len()));
            let at = lines
                .iter()
                .find_map(|line| place_on(canvas, area, line, &text, 0.0));
            if let Some(at) = at {
                canvas.label(&text, at, ink, false);
            }
        }
    }
}

/// A free position for a label on a line, with at least `apart` pixels of free space on its left
/// and right. The position is as near as possible to the middle of the line, because the ends of
/// several lines are often close together.
pub(super) fn place_on(
    canvas: &Canvas,
    area: &PlotArea,
    places: &[[f64; 2]],
    text: &str,
    apart: f64,
) -> Option<[f64; 2]> {
    let middle = places.len() / 2;
    let outward = (0..places.len()).map(|i| {
        if i % 2 == 0 {
            middle.wrapping_add(i / 2)
        } else {
            middle.wrapping_sub(i / 2 + 1)
        }
    });
    outward
        .filter_map(|i| places.get(i))
        .find(|at| has_room(canvas, area, text, **at, apart))
        .copied()
}

/// True if a label with this middle is inside the frame and covers nothing. `apart` is the width,
/// pixels, that must also be free on its left and right.
pub(super) fn has_room(
    canvas: &Canvas,
    area: &PlotArea,
    text: &str,
    middle: [f64; 2],
    apart: f64,
) -> bool {
    let [left, top, right, bottom] = area.frame;
    let [low, high] = Canvas::label_extent(text, middle);
    let is_inside = low[0] >= left && high[0] <= right && low[1] >= top && high[1] <= bottom;
    is_inside && canvas.is_free([[low[0] - apart, low[1]], [high[0] + apart, high[1]]])
}

/// Draws a region: hatched, or tinted with an outline.
pub(super) fn region(canvas: &mut Canvas, rings: &[Vec<[f64; 2]>], hue: Hue, is_hatched: bool) {
    let color = canvas.palette.of(hue);
    if is_hatched {
        for ends in hatching(rings, HATCHES_APART) {
            canvas.line(&ends, Stroke::new(color, 0.6));
        }
        return;
    }
    for ring in rings {
        canvas.polygon(ring, canvas.palette.tint(hue), 1.0);
        let closed: Vec<_> = ring.iter().chain(ring.first()).copied().collect();
        canvas.line(&closed, Stroke::new(color, 1.6));
    }
}

fn fill_contours(canvas: &mut Canvas, area: &PlotArea, field: &Field, regions: &[ContourRegion]) {
    let palette = canvas.palette;
    let shade = |i: usize| {
        // the colour midway between the ranks of this level and the next
        let next = regions.get(i + 1).map_or(1.0, |next| next.rank);
        palette.height(0.5 * (regions[i].rank + next))
    };
    for (i, region) in regions.iter().enumerate() {
        for outline in &region.outlines {
            canvas.polygon(&simplified(&area.all(outline)), shade(i), 1.0);
        }
    }
    let (columns, rows) = (field.columns, field.rows());
    // cover missing values with one rectangle for each run of missing nodes in a row; the
    // rectangles overlap a little, so that no seams are visible
    let corner = |column: f64, row: f64| {
        let end = |at: f64, count: usize| at.clamp(0.0, (count - 1) as f64);
        area.pixel(field.coordinates(end(column, columns), end(row, rows)))
    };
    for (row, values) in field.values.chunks(columns.max(1)).take(rows).enumerate() {
        let mut column = 0;
        for run in values.chunk_by(|a, b| a.is_none() == b.is_none()) {
            let (from, to) = (column as f64 - 0.5, (column + run.len()) as f64 - 0.5);
            column += run.len();
            let corners = [
                corner(from, row as f64 - 0.52),
                corner(to, row as f64 + 0.52),
            ];
            if let (true, [Some(low), Some(high)]) = (run[0].is_none(), corners) {
                let [top_left, bottom_right] = [[low[0], high[1]], [high[0], low[1]]];
                canvas.rectangle(top_left, bottom_right, palette.nothing, 1.0);
            }
        }
    }
}

/// Draws a line of a series, with cross bars at regular distances; a single point is a dot.
pub(super) fn series(canvas: &mut Canvas, points: &[[f64; 2]], hue: Hue, is_dashed: bool) {
    let color = canvas.palette.of(hue);
    let width = if hue == Hue::Faint { THIN } else { WIDE };
    let stroke = Stroke {
        color,
        width,
        is_dashed,
    };
    match points {
        [] => {}
        [at] => canvas.disc(*at, DOT, color),
        _ => canvas.line(points, stroke),
    }
    let (mut gone, mut next) = (0.0, FIRST_BARS);
    for pair in points.windows(2) {
        let [dx, dy] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let length = dx.hypot(dy);
        while length > 0.0 && gone + length >= next {
            let part = (next - gone) / length;
            let at = [pair[0][0] + part * dx, pair[0][1] + part * dy];
            cross_bars(
                canvas,
                at,
                [dx / length, dy / length],
                color,
                hue.cross_bars(),
            );
            next += BARS_APART;
        }
        gone += length;
    }
}

/// Draws a point of a series with oblique cross bars: vertical bars would look like error bars.
pub(super) fn point(canvas: &mut Canvas, at: [f64; 2], hue: Hue) {
    let color = canvas.palette.of(hue);
    canvas.disc(at, DOT, color);
    cross_bars(canvas, at, [0.5_f64.sqrt(); 2], color, hue.cross_bars());
}

/// Draws short parallel bars across a direction, centred on a point.
fn cross_bars(
    canvas: &mut Canvas,
    [x, y]: [f64; 2],
    [dx, dy]: [f64; 2],
    color: Color,
    count: usize,
) {
    for i in 0..count {
        let along = 3.5 * (i as f64 - 0.5 * (count - 1) as f64);
        let end = |side: f64| [x + along * dx - side * dy, y + along * dy + side * dx];
        canvas.line(&[end(-5.5), end(5.5)], Stroke::new(color, 1.5));
    }
}

pub(super) fn arrow(canvas: &mut Canvas, from: [f64; 2], to: [f64; 2], color: Color) {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length < 1.0 {
        return;
    }
    let [dx, dy] = [dx / length, dy / length];
    let head = 6.0_f64.min(0.6 * length);
    let wing = |side: f64| {
        [
            to[0] - head * (dx - side * 0.5 * dy),
            to[1] - head * (dy + side * 0.5 * dx),
        ]
    };
    let stroke = Stroke::new(color, 1.3);
    canvas.line(&[from, to], stroke);
    let tip = [wing(1.0), to, wing(-1.0)];
    canvas.line(&tip, stroke);
    canvas.polygon(&tip, color, 1.0);
}
