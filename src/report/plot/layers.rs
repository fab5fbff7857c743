//! Draws each kind of layer, in pixels of the plot.

use super::canvas::{Area, FINE, Labels, SIGN, block, failed, fine, path, stroke};
use super::contour::Ground;
use super::figure::{Field, Figure, Hue, Layer};
use super::hatching::hatching;
use super::palette::Palette;
use super::simplify::simplified;
use super::ticks::Drawn;
use crate::error::Result;
use crate::units::{System, significant, with_unit};
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon};
use plotters::style::{Color, RGBColor};

/// Distance of the first cross bar of a series along its line (the middle of the legend's symbol),
/// and distance between cross bars, pixels.
const FIRST_BARS: f64 = 0.5 * SIGN;
const BARS_APART: f64 = 32.0;

/// Widths of lines: of background elements, and of the others, pixels.
const THIN: f64 = 1.2;
pub(super) const WIDE: f64 = 2.0;

/// Distance between hatching lines, pixels.
const HATCHES_APART: f64 = 11.0;

/// The rectangle of the axes in the drawing area.
pub(super) struct Plane<'a> {
    pub x: &'a Drawn,
    pub y: &'a Drawn,
    /// Left, top, right and bottom, pixels.
    pub frame: [f64; 4],
}

impl Plane<'_> {
    /// The pixel of SI coordinates; `None` outside of the axes.
    pub fn pixel(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [left, top, right, bottom] = self.frame;
        let along = |drawn: &Drawn, value: f64, from: f64, to: f64| {
            let part = (drawn.place(value)? - drawn.low) / (drawn.high - drawn.low);
            (-1e-6..=1.0 + 1e-6)
                .contains(&part)
                .then_some(from + part * (to - from))
        };
        Some([
            along(self.x, x, left, right)?,
            along(self.y, y, bottom, top)?,
        ])
    }

    /// The horizontal pixel of an SI value; `None` outside of the axis.
    pub fn pixel_across(&self, x: f64) -> Option<f64> {
        let [left, _, right, _] = self.frame;
        let part = (self.x.place(x)? - self.x.low) / (self.x.high - self.x.low);
        (-1e-6..=1.0 + 1e-6)
            .contains(&part)
            .then_some(left + part * (right - left))
    }

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

/// True for layers that cover an area. They are drawn below the contour lines and the others.
pub(super) fn is_area(layer: &Layer) -> bool {
    matches!(
        layer,
        Layer::Contours(_) | Layer::Region { .. } | Layer::Band { .. }
    )
}

/// Draws one layer; `grounds` are its contour regions, without their lines. Labels are drawn later.
pub(super) fn draw(
    area: &Area<'_>,
    plane: &Plane<'_>,
    palette: &Palette,
    layer: &Layer,
    grounds: &[Ground],
) -> Result<()> {
    let hue = layer.named().1.unwrap_or(Hue::Ink);
    let color = palette.of(hue);
    match layer {
        Layer::Line {
            is_dashed, points, ..
        } => plane
            .pieces(points)
            .iter()
            .try_for_each(|piece| series(area, piece, palette, hue, *is_dashed)),
        Layer::Dots { points, .. } => plane
            .all(points)
            .into_iter()
            .try_for_each(|at| point(area, at, palette, hue)),
        Layer::Band { points, .. } => {
            let low = points.iter().map(|[x, low, _]| [*x, *low]);
            let high = points.iter().rev().map(|[x, _, high]| [*x, *high]);
            polygon(
                area,
                &plane.all(&low.chain(high).collect::<Vec<_>>()),
                color,
                0.22,
            )
        }
        // bars are drawn with the names of the rows
        Layer::Bars { .. } => Ok(()),
        Layer::Contours(field) => ground(area, plane, palette, field, grounds),
        // a mark is drawn with its label: neither appears alone
        Layer::Mark { .. } | Layer::Text { .. } => Ok(()),
        // arrows are drawn after the labels, which have precedence
        Layer::Arrows { name, .. } if !name.is_empty() => Ok(()),
        Layer::Arrows { arrows, .. } => {
            pixels(plane, arrows).try_for_each(|[from, to]| arrow(area, from, to, color))
        }
        Layer::Region {
            is_hatched, rings, ..
        } => {
            let rings: Vec<_> = rings.iter().map(|ring| plane.all(ring)).collect();
            region(area, &rings, palette, hue, *is_hatched)
        }
        Layer::Frame { low, high, .. } => {
            let [Some(low), Some(high)] = [plane.pixel(*low), plane.pixel(*high)] else {
                return Ok(());
            };
            let corners = [low, [high[0], low[1]], high, [low[0], high[1]], low];
            line(area, &corners, color, WIDE, true)
        }
    }
}

/// The arrows of a field, except those that a label or mark would partly cover.
pub(super) fn field_arrows(
    labels: &Labels<'_, '_>,
    plane: &Plane<'_>,
    figure: &Figure,
) -> Result<()> {
    figure.layers.iter().try_for_each(|layer| match layer {
        Layer::Arrows { name, hue, arrows } if !name.is_empty() => pixels(plane, arrows)
            .filter(|[from, to]| {
                let end = |pick: fn(f64, f64) -> f64| [pick(from[0], to[0]), pick(from[1], to[1])];
                labels.is_free([end(f64::min), end(f64::max)])
            })
            .try_for_each(|[from, to]| arrow(labels.area, from, to, labels.palette.of(*hue))),
        _ => Ok(()),
    })
}

/// The arrows with both ends inside the axes, in pixels.
fn pixels(plane: &Plane<'_>, arrows: &[[[f64; 2]; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    arrows
        .iter()
        .filter_map(|[from, to]| Some([plane.pixel(*from)?, plane.pixel(*to)?]))
}

/// Writes the levels of contours where there is space.
pub(super) fn label(
    labels: &mut Labels<'_, '_>,
    plane: &Plane<'_>,
    system: System,
    figure: &Figure,
    grounds: &[Vec<Ground>],
) -> Result<()> {
    for (layer, grounds) in figure.layers.iter().zip(grounds) {
        if let Layer::Contours(field) = layer {
            let unit = system.unit(field.measure.unit);
            for ground in grounds {
                let text = with_unit(&significant(ground.level, 6), unit);
                let mut lines: Vec<_> = ground.lines.iter().map(|line| plane.all(line)).collect();
                lines.sort_by_key(|line| std::cmp::Reverse(line.len()));
                let at = lines
                    .iter()
                    .find_map(|line| place_on(labels, plane, line, &text, 0.0));
                at.map_or(Ok(()), |at| {
                    labels.write(&text, at, labels.palette.ink, false)
                })?;
            }
        }
    }
    Ok(())
}

/// A free position for a label on a line, at least `apart` pixels beside other labels, as near as possible to the middle: the ends of several
/// lines are often close together.
pub(super) fn place_on(
    labels: &Labels<'_, '_>,
    plane: &Plane<'_>,
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
    let [left, top, right, bottom] = plane.frame;
    let has_room = |at: &&[f64; 2]| {
        let [low, high] = Labels::extent(text, **at);
        let is_inside = low[0] >= left && high[0] <= right && low[1] >= top && high[1] <= bottom;
        is_inside && labels.is_free([[low[0] - apart, low[1]], [high[0] + apart, high[1]]])
    };
    outward
        .filter_map(|i| places.get(i))
        .find(has_room)
        .copied()
}

/// Draws a region: hatched, or tinted with an outline.
pub(super) fn region(
    area: &Area<'_>,
    rings: &[Vec<[f64; 2]>],
    palette: &Palette,
    hue: Hue,
    is_hatched: bool,
) -> Result<()> {
    let color = palette.of(hue);
    if is_hatched {
        return hatching(rings, HATCHES_APART)
            .iter()
            .try_for_each(|ends| path(area, ends, stroke(color, 0.6)));
    }
    rings.iter().try_for_each(|ring| {
        polygon(area, ring, palette.tint(hue), 1.0)?;
        let closed: Vec<_> = ring.iter().chain(ring.first()).copied().collect();
        path(area, &closed, stroke(color, 1.6))
    })
}

/// Draws the contour lines.
pub(super) fn contour_lines(
    area: &Area<'_>,
    plane: &Plane<'_>,
    palette: &Palette,
    grounds: &[Ground],
) -> Result<()> {
    let lines = grounds.iter().flat_map(|ground| &ground.lines);
    lines.into_iter().try_for_each(|line| {
        path(
            area,
            &simplified(&plane.all(line)),
            stroke(palette.faint, 0.7),
        )
    })
}

fn ground(
    area: &Area<'_>,
    plane: &Plane<'_>,
    palette: &Palette,
    field: &Field,
    grounds: &[Ground],
) -> Result<()> {
    let shade = |i: usize| {
        // the shade of the middle between this level and the next
        let next = grounds.get(i + 1).map_or(1.0, |next| next.part);
        palette.height(0.5 * (grounds[i].part + next))
    };
    for (i, ground) in grounds.iter().enumerate() {
        ground.outlines.iter().try_for_each(|outline| {
            polygon(area, &simplified(&plane.all(outline)), shade(i), 1.0)
        })?;
    }
    let (columns, rows) = (field.columns, field.rows());
    // cover missing values by one rectangle for each run in a row; the rectangles overlap a little,
    // so that no seams are visible
    let corner = |column: f64, row: f64| {
        let end = |at: f64, count: usize| at.clamp(0.0, (count - 1) as f64);
        plane.pixel(field.place(end(column, columns), end(row, rows)))
    };
    for (row, values) in field.values.chunks(columns).enumerate() {
        let mut column = 0;
        for run in values.chunk_by(|a, b| a.is_none() == b.is_none()) {
            let (from, to) = (column as f64 - 0.5, (column + run.len()) as f64 - 0.5);
            column += run.len();
            let corners = [
                corner(from, row as f64 - 0.52),
                corner(to, row as f64 + 0.52),
            ];
            if let (true, [Some(low), Some(high)]) = (run[0].is_none(), corners) {
                block(
                    area,
                    [low[0], high[1]],
                    [high[0], low[1]],
                    palette.nothing,
                    1.0,
                )?;
            }
        }
    }
    Ok(())
}

pub(super) fn line(
    area: &Area<'_>,
    points: &[[f64; 2]],
    color: RGBColor,
    width: f64,
    is_dashed: bool,
) -> Result<()> {
    if points.len() < 2 {
        return points.iter().try_for_each(|at| dot(area, *at, color));
    }
    let style = stroke(color, width);
    if !is_dashed {
        return path(area, points, style);
    }
    let points: Vec<_> = points.iter().map(|[x, y]| (fine(*x), fine(*y))).collect();
    area.draw(&DashedPathElement::new(points, 6 * FINE, 4 * FINE, style))
        .map_err(failed)
}

/// Draws a line of a series, with cross bars at regular distances.
pub(super) fn series(
    area: &Area<'_>,
    points: &[[f64; 2]],
    palette: &Palette,
    hue: Hue,
    is_dashed: bool,
) -> Result<()> {
    let color = palette.of(hue);
    let width = if hue == Hue::Faint { THIN } else { WIDE };
    line(area, points, color, width, is_dashed)?;
    let (mut gone, mut next) = (0.0, FIRST_BARS);
    for pair in points.windows(2) {
        let [dx, dy] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let length = dx.hypot(dy);
        while length > 0.0 && gone + length >= next {
            let part = (next - gone) / length;
            bars(
                area,
                [pair[0][0] + part * dx, pair[0][1] + part * dy],
                [dx / length, dy / length],
                color,
                hue.bars(),
            )?;
            next += BARS_APART;
        }
        gone += length;
    }
    Ok(())
}

/// Draws a point of a series with oblique cross bars: vertical bars would look like error bars.
pub(super) fn point(area: &Area<'_>, at: [f64; 2], palette: &Palette, hue: Hue) -> Result<()> {
    dot(area, at, palette.of(hue))?;
    bars(area, at, [0.5_f64.sqrt(); 2], palette.of(hue), hue.bars())
}

/// Draws short parallel bars across a direction, centred on a point.
fn bars(
    area: &Area<'_>,
    [x, y]: [f64; 2],
    [dx, dy]: [f64; 2],
    color: RGBColor,
    count: usize,
) -> Result<()> {
    (0..count).try_for_each(|i| {
        let along = 3.5 * (i as f64 - 0.5 * (count - 1) as f64);
        let end = |side: f64| [x + along * dx - side * dy, y + along * dy + side * dx];
        path(area, &[end(-5.5), end(5.5)], stroke(color, 1.5))
    })
}

fn dot(area: &Area<'_>, [x, y]: [f64; 2], color: RGBColor) -> Result<()> {
    area.draw(&Circle::new((fine(x), fine(y)), 3 * FINE, color.filled()))
        .map_err(failed)
}

pub(super) fn star(
    area: &Area<'_>,
    palette: &Palette,
    [x, y]: [f64; 2],
    color: RGBColor,
) -> Result<()> {
    for (radius, color) in [(6.5, palette.ground), (5.0, color), (2.0, palette.ground)] {
        area.draw(&Circle::new(
            (fine(x), fine(y)),
            fine(radius),
            color.filled(),
        ))
        .map_err(failed)?;
    }
    Ok(())
}

fn polygon(area: &Area<'_>, points: &[[f64; 2]], color: RGBColor, alpha: f64) -> Result<()> {
    let points: Vec<_> = points.iter().map(|[x, y]| (fine(*x), fine(*y))).collect();
    area.draw(&Polygon::new(points, color.mix(alpha).filled()))
        .map_err(failed)
}

pub(super) fn arrow(area: &Area<'_>, from: [f64; 2], to: [f64; 2], color: RGBColor) -> Result<()> {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length < 1.0 {
        return Ok(());
    }
    let [dx, dy] = [dx / length, dy / length];
    let head = 6.0_f64.min(0.6 * length);
    let wing = |side: f64| {
        [
            to[0] - head * (dx - side * 0.5 * dy),
            to[1] - head * (dy + side * 0.5 * dx),
        ]
    };
    path(area, &[from, to], stroke(color, 1.3))?;
    let points: Vec<_> = [wing(1.0), to, wing(-1.0)]
        .iter()
        .map(|[x, y]| (fine(*x), fine(*y)))
        .collect();
    area.draw(&PathElement::new(points.clone(), stroke(color, 1.3)))
        .map_err(failed)?;
    area.draw(&Polygon::new(points, color.filled()))
        .map_err(failed)
}
