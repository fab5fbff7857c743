//! Lines of equal value. Plotters has none: the rings come from the `contour` crate's marching squares, chosen over
//! coloured cells for a map that is smooth at any size and in print.

use super::figure::Field;
use super::ticks::nice_step;
use crate::units::System;
use contour::ContourBuilder;

/// About how many lines a map has.
const LINES: f64 = 14.0;

/// The ground at and above a level.
pub(super) struct Ground {
    /// The level, in the unit read.
    pub level: f64,
    /// Where it stands between the lowest and the highest value, 0 to 1.
    pub part: f64,
    /// Its outlines, in the plane of the axes, SI; a hole is reached along a line without width.
    pub outlines: Vec<Vec<[f64; 2]>>,
    /// Its edge within the map.
    pub lines: Vec<Vec<[f64; 2]>>,
}

/// The grounds of a field, the lowest first: each covers a part of the one before.
pub(super) fn grounds(field: &Field, system: System) -> Vec<Ground> {
    let known = field.values.iter().flatten().map(|value| field.measure.in_units(*value, system));
    let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    let (columns, rows) = (field.columns, field.rows());
    if !(low.is_finite() && high.is_finite()) || columns < 2 || rows < 2 {
        return vec![];
    }
    let step = nice_step(((high - low) / LINES).max(1e-9 * high.abs().max(1e-300)));
    let first = (low / step).ceil() as i64;
    let levels: Vec<f64> = (first..).map(|i| i as f64 * step).take_while(|level| *level <= high).collect();
    let values: Vec<f64> = continued(field).iter().map(|value| field.measure.in_units(*value, system)).collect();
    // the lowest ground is everything
    let all = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
        .map(|[x, y]: [f64; 2]| field.place(x * (columns - 1) as f64, y * (rows - 1) as f64));
    let base = Ground { level: low, part: 0.0, outlines: vec![all.to_vec()], lines: vec![] };
    let builder = ContourBuilder::new(columns, rows, true);
    let found = builder.contours(&values, &levels).unwrap_or_default();
    let above = found.iter().zip(&levels).map(|(contour, level)| {
        let polygons = contour.geometry().0.iter();
        // the crate puts the first node at ½ and closes rings half a cell outside
        let node = |at: f64, count: usize| (at - 0.5).clamp(0.0, (count - 1) as f64);
        let node = |x: f64, y: f64| [node(x, columns), node(y, rows)];
        let mut ground = Ground { level: *level, part: (level - low) / (high - low), outlines: vec![], lines: vec![] };
        for polygon in polygons {
            let outer: Vec<[f64; 2]> = polygon.exterior().0.iter().map(|at| node(at.x, at.y)).collect();
            let holes = polygon.interiors().iter().map(|hole| hole.0.iter().map(|at| node(at.x, at.y)).collect());
            let holes: Vec<Vec<[f64; 2]>> = holes.collect();
            for one in holes.iter().chain([&outer]) {
                ground.lines.extend(inner(one, columns, rows));
            }
            let start = outer.first().copied();
            let joined = outer.into_iter().chain(holes.into_iter().flat_map(|hole| hole.into_iter().chain(start)));
            ground.outlines.push(joined.collect());
        }
        let place = |[column, row]: &mut [f64; 2]| [*column, *row] = field.place(*column, *row);
        ground.outlines.iter_mut().chain(&mut ground.lines).flatten().for_each(place);
        ground
    });
    std::iter::once(base).chain(above).collect()
}

/// The pieces of a ring that do not run along the border of the map.
fn inner(ring: &[[f64; 2]], columns: usize, rows: usize) -> Vec<Vec<[f64; 2]>> {
    let ends = [(columns - 1) as f64, (rows - 1) as f64];
    let along =
        |a: &[f64; 2], b: &[f64; 2]| (0..2).any(|axis| a[axis] == b[axis] && (a[axis] == 0.0 || a[axis] == ends[axis]));
    let mut pieces: Vec<Vec<[f64; 2]>> = vec![];
    let mut is_open = false;
    for pair in ring.windows(2) {
        if along(&pair[0], &pair[1]) {
            is_open = false;
            continue;
        }
        if !is_open {
            pieces.push(vec![pair[0]]);
            is_open = true;
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(pair[1]);
        }
    }
    // a ring that begins in the middle of a piece
    if let (Some(first), Some(last)) = (pieces.first(), pieces.last())
        && pieces.len() > 1
        && first.first() == last.last()
    {
        let head = pieces.remove(0);
        if let Some(last) = pieces.last_mut() {
            last.extend(head.into_iter().skip(1));
        }
    }
    pieces
}

/// The field without gaps: lines run on beneath what hides them, and do not bend where values end.
fn continued(field: &Field) -> Vec<f64> {
    let (columns, rows) = (field.columns, field.rows());
    let mut values = field.values.clone();
    while values.iter().any(Option::is_none) && values.iter().any(Option::is_some) {
        let before = values.clone();
        for i in (0..values.len()).filter(|i| before[*i].is_none()) {
            let (column, row) = (i % columns, i / columns);
            let sides = [
                (column > 0).then(|| i - 1),
                (column + 1 < columns).then_some(i + 1),
                (row > 0).then(|| i - columns),
                (row + 1 < rows).then_some(i + columns),
            ];
            let known: Vec<f64> = sides.into_iter().flatten().filter_map(|side| before[side]).collect();
            if !known.is_empty() {
                values[i] = Some(known.iter().sum::<f64>() / known.len() as f64);
            }
        }
    }
    values.into_iter().map(Option::unwrap_or_default).collect()
}
