//! Marks with labels in free positions, and names of lines written on the lines.

use super::canvas::{Canvas, LINE, Stroke};
use super::figure::{Figure, LineNames, Shape};
use super::layers::{PlotArea, has_room, place_on};
use super::palette::Color;

/// Half the size of a mark, pixels.
const SIZE: f64 = 6.5;
/// Distance between a mark and a label beside it, pixels.
const LABEL_GAP: f64 = 9.0;

/// Vertical distance between a mark and the middle of its label, pixels. The label is then entirely
/// above or below a horizontal line through the mark.
const HALF_LINE: f64 = 0.65 * LINE;

/// Larger distances between a label and its mark, pixels. They are used if nearer positions are
/// occupied or cover lines.
const FAR_GAPS: [f64; 2] = [36.0, 64.0];
/// Additional cost of a label at each of the distances `FAR_GAPS`. In comparison, a label costs 2
/// for each point of a line that it covers.
const FAR_COSTS: [usize; 2] = [5, 6];

/// Cost of a label above or below its mark instead of beside it. In comparison, a label costs 2 for
/// each point of a line that it covers.
const OVER_COST: usize = 6;

/// Maximum distance of marks that are drawn as one mark, pixels.
const MERGE_DISTANCE: f64 = 4.0;

/// A label must be nearer to its own mark than to any other mark, by this distance, pixels. A label
/// with a line to its mark is exempt.
const CLEAR: f64 = 2.0;

/// Distance of a label from its mark above which a line connects the two, pixels.
const CONNECT_DISTANCE: f64 = 1.5 * LINE;

/// Draws the marks, then their labels.
pub(super) fn write_marks(canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
    let marks = figure.layers.iter().filter_map(|layer| match layer.shape {
        Shape::Mark(at) => Some(Mark {
            name: layer.name.clone(),
            color: canvas.palette.of(layer.hue),
            at: area.pixel(at)?,
        }),
        _ => None,
    });
    let marks = merged(marks.collect());
    for mark in &marks {
        let background = canvas.palette.background;
        for (radius, color) in [(6.5, background), (5.0, mark.color), (2.0, background)] {
            canvas.disc(mark.at, radius, color);
        }
        let corner = |by: f64| mark.at.map(|coordinate| coordinate + by);
        canvas.labelled.push([corner(-SIZE), corner(SIZE)]);
    }
    let lines = lines(area, figure);
    for (i, mark) in marks.iter().enumerate() {
        if mark.name.is_empty() {
            continue;
        }
        let others = [&marks[..i], &marks[i + 1..]].concat();
        match beside(canvas, area, mark, &others, &lines) {
            Some(middle) => write_connected(canvas, mark, middle),
            None => write_near(
                canvas,
                area,
                &mark.name,
                mark.at,
                mark.color,
                CONNECT_DISTANCE,
            ),
        }
    }
}

/// Writes the label of a mark, with a line to the mark if the label is farther away than
/// `CONNECT_DISTANCE`.
fn write_connected(canvas: &mut Canvas, mark: &Mark, middle: [f64; 2]) {
    let [low, high] = Canvas::label_extent(&mark.name, middle);
    let end = [0, 1].map(|axis| mark.at[axis].clamp(low[axis], high[axis]));
    let [dx, dy] = [0, 1].map(|axis| end[axis] - mark.at[axis]);
    let length = dx.hypot(dy);
    if length > CONNECT_DISTANCE {
        let start = [
            mark.at[0] + SIZE / length * dx,
            mark.at[1] + SIZE / length * dy,
        ];
        canvas.line(&[start, end], Stroke::new(mark.color, 0.8));
    }
    canvas.label(&mark.name, middle, mark.color, true);
}

/// A mark in pixels.
#[derive(Clone)]
struct Mark {
    name: String,
    color: Color,
    at: [f64; 2],
}

/// Merges marks at the same place into one mark, which has both names and the colour of the upper
/// mark.
fn merged(marks: Vec<Mark>) -> Vec<Mark> {
    let mut apart: Vec<Mark> = vec![];
    for mark in marks {
        let same = apart.iter_mut().find(|other| {
            let [dx, dy] = [0, 1].map(|axis| mark.at[axis] - other.at[axis]);
            dx.hypot(dy) < MERGE_DISTANCE
        });
        match same {
            Some(other) => {
                let names = [other.name.as_str(), &mark.name];
                let names = names.into_iter().filter(|name| !name.is_empty());
                other.name = names.collect::<Vec<_>>().join(", ");
                other.color = mark.color;
            }
            None => apart.push(mark),
        }
    }
    apart
}

/// Writes the labels of [`Shape::Text`], moved sideways into the frame. Omits a label that would
/// cover another label.
pub(super) fn write_texts(canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
    for layer in &figure.layers {
        let Shape::Text(at) = layer.shape else {
            continue;
        };
        let Some([x, y]) = area.pixel(at) else {
            continue;
        };
        let name = &layer.name;
        let [left, _, right, _] = area.frame;
        let half = Canvas::label_extent(name, [0.0, 0.0])[1][0];
        let middle = [x.min(right - half).max(left + half), y];
        if has_room(canvas, area, name, middle, 0.0) {
            canvas.label(name, middle, canvas.palette.of(layer.hue), false);
        }
    }
}

/// Writes a label as near as possible to a point. If its distance exceeds `far`, pixels, a line
/// connects label and point.
fn write_near(
    canvas: &mut Canvas,
    area: &PlotArea,
    name: &str,
    at: [f64; 2],
    color: Color,
    far: f64,
) {
    let middle = nearest(canvas, area, name, at);
    let [dx, dy] = [middle[0] - at[0], middle[1] - at[1]];
    let half = Canvas::label_extent(name, [0.0, 0.0])[1][0];
    if (dx.abs() - half).max(0.0).hypot(dy) > far {
        canvas.line(&[at, middle], Stroke::new(color, 0.8));
    }
    canvas.label(name, middle, color, true);
}

/// Equidistant points along the lines of a figure, in pixels. They are so dense that no label fits
/// between them.
fn lines(area: &PlotArea, figure: &Figure) -> Vec<[f64; 2]> {
    const STEP: f64 = 3.0;
    let lines = figure.layers.iter().filter_map(|layer| match &layer.shape {
        Shape::Line { points, .. } => Some(area.pieces(points)),
        _ => None,
    });
    let mut places = vec![];
    for piece in lines.flatten() {
        // the length of the line after the last point in `places`
        let mut gone = STEP;
        for ends in piece.windows(2) {
            let [dx, dy] = [0, 1].map(|axis| ends[1][axis] - ends[0][axis]);
            let length = dx.hypot(dy);
            if length == 0.0 {
                continue;
            }
            gone += length;
            while gone >= STEP {
                gone -= STEP;
                let part = 1.0 - gone / length;
                places.push([ends[0][0] + part * dx, ends[0][1] + part * dy]);
            }
        }
    }
    places
}

/// The middle of a label at the free position with the lowest cost: beside, above or below its
/// mark. The cost grows with the covered points of lines, and with the distance from the mark.
/// `None` if every free position is as near to another mark.
fn beside(
    canvas: &Canvas,
    area: &PlotArea,
    Mark { name, at, .. }: &Mark,
    others: &[Mark],
    lines: &[[f64; 2]],
) -> Option<[f64; 2]> {
    let [left, _, right, _] = area.frame;
    let [wide, tall] = Canvas::label_extent(name, [0.0, 0.0])[1];
    let beside = |gap: f64| {
        let sides = [wide + gap, -wide - gap].map(|dx| at[0] + dx);
        let heights = [0.0, -LINE, LINE, -HALF_LINE, HALF_LINE].map(|dy| at[1] + dy);
        sides.into_iter().flat_map(move |x| heights.map(|y| [x, y]))
    };
    let inside = at[0].min(right - wide).max(left + wide);
    let over = |gap: f64| [-1.0, 1.0].map(|side| [inside, at[1] + side * (tall + gap)]);
    // a position above, below or far from the mark costs more, because the label belongs less
    // clearly to the mark
    let all = beside(LABEL_GAP).map(|middle| (middle, 0));
    let all = all.chain(over(LABEL_GAP).map(|middle| (middle, OVER_COST)));
    let far = FAR_GAPS.into_iter().zip(FAR_COSTS);
    let all = all.chain(far.flat_map(|(gap, cost)| {
        let over = over(gap).map(|middle| (middle, OVER_COST + cost));
        beside(gap).map(move |middle| (middle, cost)).chain(over)
    }));
    let hidden = |middle: &[f64; 2]| {
        let [low, high] = Canvas::label_extent(name, *middle);
        let is_under =
            |place: &&[f64; 2]| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]));
        lines.iter().filter(is_under).count()
    };
    let is_clear = |middle: &[f64; 2]| {
        let extent = Canvas::label_extent(name, *middle);
        let own = distance(*at, extent);
        // a label farther away than `CONNECT_DISTANCE` has a line to its mark: other marks may be
        // nearer
        let least = CLEAR + if own > CONNECT_DISTANCE { SIZE } else { own };
        let mut others = others.iter();
        others.all(|other| distance(other.at, extent) > least)
    };
    // the position with the lowest cost that is free and clear of other marks
    all.filter(|(middle, _)| has_room(canvas, area, name, *middle, 0.0) && is_clear(middle))
        .min_by_key(|(middle, cost)| 2 * hidden(middle) + cost)
        .map(|(middle, _)| middle)
}

/// The distance of a point from a rectangle, pixels.
fn distance(at: [f64; 2], [low, high]: [[f64; 2]; 2]) -> f64 {
    let [dx, dy] = [0, 1].map(|axis| (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0));
    dx.hypot(dy)
}

/// The middle of a label in the free position of the frame that is nearest to a point. If no
/// position is free, the label is at the point and may cover other labels.
fn nearest(canvas: &Canvas, area: &PlotArea, name: &str, at: [f64; 2]) -> [f64; 2] {
    const STEP: f64 = 8.0;
    let [left, top, right, bottom] = area.frame;
    let [wide, tall] = Canvas::label_extent(name, [0.0, 0.0])[1];
    let (across, up) = (
        ((right - left) / STEP) as usize,
        ((bottom - top) / STEP) as usize,
    );
    let nodes = (0..across)
        .flat_map(|i| (0..up).map(move |j| [left + STEP * i as f64, top + STEP * j as f64]));
    let distance = |node: &[f64; 2]| (node[0] - at[0]).hypot(node[1] - at[1]);
    let free = nodes.filter(|node| has_room(canvas, area, name, *node, 0.0));
    free.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or([
            at[0].min(right - wide).max(left + wide),
            at[1].min(bottom - tall).max(top + tall),
        ])
}

/// Minimum distance between the name of a line and a label beside it, pixels. Nearer texts would
/// look like one label.
const NAME_GAP: f64 = 8.0;

/// Writes the names of lines on the lines if the figure has [`LineNames::OnLines`]. A name without
/// space on its line is written next to the line.
pub(super) fn write_line_names(canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
    let is_on_lines = figure.line_names == LineNames::OnLines;
    for layer in figure.layers.iter().filter(|_| is_on_lines) {
        let Shape::Line { points, .. } = &layer.shape else {
            continue;
        };
        let name = &layer.name;
        if name.is_empty() {
            continue;
        }
        let places = area.all(points);
        let color = canvas.palette.of(layer.hue);
        match place_on(canvas, area, &places, name, NAME_GAP) {
            Some(middle) => canvas.label(name, middle, color, true),
            // no space on the line: write the name beside it, because the legend does not have the
            // name
            None => {
                if let Some(at) = places.get(places.len() / 2) {
                    write_near(canvas, area, name, *at, color, LINE);
                }
            }
        }
    }
}
