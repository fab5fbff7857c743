//! Marks with labels in free positions.

use super::canvas::{LINE, Labels, path, stroke};
use super::figure::{Figure, Layer};
use super::layers::{Plane, star};
use super::legend;
use crate::error::Result;
use plotters::style::RGBColor;

/// Half the size of a mark, and the distance between a mark and its label, pixels.
const SIZE: f64 = 6.5;
const GAP: f64 = 9.0;

/// Distance from which a line connects a label with its mark, pixels.
const FAR: f64 = 2.0 * LINE;

/// Draws the marks, then their labels. Marks whose label is also in the legend are drawn only if
/// all of them have space for their labels.
pub(super) fn write_marks(
    labels: &mut Labels<'_, '_>,
    plane: &Plane<'_>,
    figure: &Figure,
) -> Result<()> {
    let marks = figure.layers.iter().filter_map(|layer| match layer {
        Layer::Mark { name, hue, at } => {
            Some((name.as_str(), labels.palette.of(*hue), plane.pixel(*at)?))
        }
        _ => None,
    });
    let (doubled, needed): (Vec<_>, Vec<_>) =
        marks.partition(|(name, ..)| !name.is_empty() && legend::has(figure, name));
    let around = |at: &[f64; 2]| [[at[0] - SIZE, at[1] - SIZE], [at[0] + SIZE, at[1] + SIZE]];
    for (_, color, at) in &needed {
        star(labels.area, labels.palette, *at, *color)?;
        labels.taken.push(around(at));
    }
    let lines = lines(plane, figure);
    for (name, color, at) in needed.iter().filter(|(name, ..)| !name.is_empty()) {
        match beside(labels, plane, name, *at, &lines) {
            Some(middle) => labels.write(name, middle, *color, true)?,
            None => write_near(labels, plane, name, *at, *color)?,
        }
    }
    let before = labels.taken.len();
    labels
        .taken
        .extend(doubled.iter().map(|(.., at)| around(at)));
    let mut middles = vec![];
    for (name, _, at) in &doubled {
        let Some(middle) = beside(labels, plane, name, *at, &lines) else {
            labels.taken.truncate(before);
            return Ok(());
        };
        labels.taken.push(Labels::extent(name, middle));
        middles.push(middle);
    }
    for ((name, color, at), middle) in doubled.iter().zip(middles) {
        star(labels.area, labels.palette, *at, *color)?;
        labels.write(name, middle, *color, true)?;
    }
    Ok(())
}

/// Writes a label as near as possible to a point. If it is far away, a line connects the two.
pub(super) fn write_near(
    labels: &mut Labels<'_, '_>,
    plane: &Plane<'_>,
    name: &str,
    at: [f64; 2],
    color: RGBColor,
) -> Result<()> {
    let middle = nearest(labels, plane, name, at);
    let [dx, dy] = [middle[0] - at[0], middle[1] - at[1]];
    let half = Labels::extent(name, [0.0, 0.0])[1][0];
    if (dx.abs() - half).max(0.0).hypot(dy) > FAR {
        path(labels.area, &[at, middle], stroke(color, 0.8))?;
    }
    labels.write(name, middle, color, true)
}

/// Points along the lines of a figure, so dense that no label fits between them, pixels.
fn lines(plane: &Plane<'_>, figure: &Figure) -> Vec<[f64; 2]> {
    const STEP: f64 = 6.0;
    let lines = figure.layers.iter().filter_map(|layer| match layer {
        Layer::Line { points, .. } => Some(plane.pieces(points)),
        _ => None,
    });
    let mut places = vec![];
    for piece in lines.flatten() {
        for ends in piece.windows(2) {
            let [dx, dy] = [0, 1].map(|axis| ends[1][axis] - ends[0][axis]);
            let steps = (dx.hypot(dy) / STEP).ceil().max(1.0);
            places.extend(
                (0..steps as u32)
                    .map(|i| [dx, dy].map(|d| d * f64::from(i) / steps))
                    .map(|[x, y]| [ends[0][0] + x, ends[0][1] + y]),
            );
        }
    }
    places
}

/// True if a label centred on a point is inside the frame and covers nothing.
fn is_free(labels: &Labels<'_, '_>, plane: &Plane<'_>, name: &str, middle: &[f64; 2]) -> bool {
    let [left, top, right, bottom] = plane.frame;
    let [low, high] = Labels::extent(name, *middle);
    low[0] >= left
        && high[0] <= right
        && low[1] >= top
        && high[1] <= bottom
        && labels.is_free([low, high])
}

/// The middle of a label next to its mark, or above or below it, in a free position that covers the
/// least of the lines.
fn beside(
    labels: &Labels<'_, '_>,
    plane: &Plane<'_>,
    name: &str,
    at: [f64; 2],
    lines: &[[f64; 2]],
) -> Option<[f64; 2]> {
    let [left, _, right, _] = plane.frame;
    let [wide, tall] = Labels::extent(name, [0.0, 0.0])[1];
    let sides = [wide + GAP, -wide - GAP].map(|dx| at[0] + dx);
    let heights = [0.0, -LINE, LINE].map(|dy| at[1] + dy);
    let over = at[0].min(right - wide).max(left + wide);
    let over = [-1.0, 1.0].map(|side| [over, at[1] + side * (tall + GAP)]);
    let all = sides
        .into_iter()
        .flat_map(|x| heights.map(|y| [x, y]))
        .chain(over);
    let hidden = |middle: &[f64; 2]| {
        let [low, high] = Labels::extent(name, *middle);
        let is_under =
            |place: &&[f64; 2]| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]));
        lines.iter().filter(is_under).count()
    };
    // the first of the positions that cover least
    all.into_iter()
        .filter(|middle| is_free(labels, plane, name, middle))
        .min_by_key(hidden)
}

/// The nearest free middle of a label in the frame. In a full frame, the label covers something.
fn nearest(labels: &Labels<'_, '_>, plane: &Plane<'_>, name: &str, at: [f64; 2]) -> [f64; 2] {
    const STEP: f64 = 8.0;
    let [left, top, right, bottom] = plane.frame;
    let [wide, tall] = Labels::extent(name, [0.0, 0.0])[1];
    let (across, up) = (
        ((right - left) / STEP) as usize,
        ((bottom - top) / STEP) as usize,
    );
    let nodes = (0..across)
        .flat_map(|i| (0..up).map(move |j| [left + STEP * i as f64, top + STEP * j as f64]));
    let distance = |node: &[f64; 2]| (node[0] - at[0]).hypot(node[1] - at[1]);
    let free = nodes.filter(|node| is_free(labels, plane, name, node));
    free.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or([
            at[0].min(right - wide).max(left + wide),
            at[1].min(bottom - tall).max(top + tall),
        ])
}
