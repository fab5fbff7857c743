//! Contour lines of an interpolated field, from the marching squares of the `contour` crate. Lines
//! are smooth at any size and in print, which coloured cells are not.

use super::figure::Field;
use super::interpolation::Refined;
use super::ticks::round_step;
use crate::units::System;
use contour::ContourBuilder;

/// The region at and above a level.
pub(super) struct ContourRegion {
    /// The level, in the displayed unit.
    pub level: f64,
    /// The position of the level among all levels, in equal steps: 0 for the lowest region, 1 for
    /// the highest level.
    pub rank: f64,
    /// The outlines in the coordinates of the axes, SI. If an area has holes, its outline also
    /// contains their rings, joined by straight lines.
    pub outlines: Vec<Vec<[f64; 2]>>,
    /// The contour lines: the outlines without their parts along the edge of the map.
    pub lines: Vec<Vec<[f64; 2]>>,
}

impl Field {
    /// The contour line of a value, SI. NaN points separate the pieces of the line.
    pub fn line_at(&self, level: f64) -> Vec<[f64; 2]> {
        let region = Refined::new(self).and_then(|fine| outlined(self, &fine, &[level]).pop());
        let pieces = region.map(|region| region.lines).unwrap_or_default();
        pieces.join(&[f64::NAN; 2])
    }

    /// Outlines of the region at or above a value, SI. If an area has holes, its outline also
    /// contains their rings, joined by straight lines.
    pub fn above(&self, level: f64) -> Vec<Vec<[f64; 2]>> {
        self.beyond(level, 1.0)
    }

    /// Outlines of the region at or below a value, SI.
    pub fn below(&self, level: f64) -> Vec<Vec<[f64; 2]>> {
        self.beyond(-level, -1.0)
    }

    fn beyond(&self, level: f64, sign: f64) -> Vec<Vec<[f64; 2]>> {
        Refined::new(self)
            .and_then(|fine| outlined(self, &fine.over(sign), &[level]).pop())
            .map(|region| region.outlines)
            .unwrap_or_default()
    }
}

/// The regions of a field, the lowest level first. Each region contains the next region.
pub(super) fn contour_regions(field: &Field, system: System) -> Vec<ContourRegion> {
    let unit = field.quantity.of.size_in(system);
    let (columns, rows) = (field.columns, field.rows());
    let Some(refined) = Refined::new(field).map(|fine| fine.over(unit)) else {
        return vec![];
    };
    let values = refined.values.iter().zip(&refined.is_known);
    let mut known: Vec<f64> = match &field.common_values[..] {
        [] => values
            .filter(|(_, is_known)| **is_known)
            .map(|(value, _)| *value)
            .collect(),
        all => all.iter().map(|value| value / unit).collect(),
    };
    known.retain(|value| value.is_finite());
    known.sort_by(f64::total_cmp);
    let Some(&low) = known.first() else {
        return vec![];
    };
    let levels = levels(&known);
    // the lowest region is the whole map
    let all = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
        .map(|[x, y]: [f64; 2]| field.coordinates(x * (columns - 1) as f64, y * (rows - 1) as f64));
    let base = ContourRegion {
        level: low,
        rank: 0.0,
        outlines: vec![all.to_vec()],
        lines: vec![],
    };
    std::iter::once(base)
        .chain(outlined(field, &refined, &levels))
        .collect()
}

/// The region at and above each level. `refined` has the values of the field on a finer grid.
fn outlined(field: &Field, refined: &Refined, levels: &[f64]) -> Vec<ContourRegion> {
    let (columns, rows) = (refined.columns, refined.rows);
    let builder = ContourBuilder::new(columns, rows, true);
    let found = builder
        .contours(&refined.values, levels)
        .unwrap_or_default();
    let above = found
        .iter()
        .zip(levels)
        .enumerate()
        .map(|(i, (contour, level))| {
            let polygons = contour.geometry().0.iter();
            // in the coordinates of the crate, the first node is at ½; a ring at the edge lies half
            // a cell outside of the grid and is clamped to it
            let node = |at: f64, count: usize| (at - 0.5).clamp(0.0, (count - 1) as f64);
            let node = |x: f64, y: f64| [node(x, columns), node(y, rows)];
            let rank = (i + 1) as f64 / levels.len() as f64;
            let mut region = ContourRegion {
                level: *level,
                rank,
                outlines: vec![],
                lines: vec![],
            };
            for polygon in polygons {
                let outer: Vec<[f64; 2]> = polygon
                    .exterior()
                    .0
                    .iter()
                    .map(|at| node(at.x, at.y))
                    .collect();
                let holes = polygon
                    .interiors()
                    .iter()
                    .map(|hole| hole.0.iter().map(|at| node(at.x, at.y)).collect());
                let holes: Vec<Vec<[f64; 2]>> = holes.collect();
                for one in holes.iter().chain([&outer]) {
                    region.lines.extend(inner(one, columns, rows));
                }
                let start = outer.first().copied();
                let joined = outer.into_iter().chain(
                    holes
                        .into_iter()
                        .flat_map(|hole| hole.into_iter().chain(start)),
                );
                region.outlines.push(joined.collect());
            }
            let place = |at: &mut [f64; 2]| {
                let [column, row] = at.map(|node| node / refined.times as f64);
                *at = field.coordinates(column, row);
            };
            region
                .outlines
                .iter_mut()
                .chain(&mut region.lines)
                .flatten()
                .for_each(place);
            region
        });
    above.collect()
}

/// Contour levels at round numbers. Their distance is 1, 2, 2.5 or 5 times a power of ten. A part
/// of the range that covers much of the map gets a smaller distance, perhaps repeatedly: otherwise
/// the flat top of a map with steep sides would have no line. The distance is constant within a
/// part, so that the spacing of the lines shows the slope.
fn levels(sorted: &[f64]) -> Vec<f64> {
    let (low, high) = (sorted[0], sorted[sorted.len() - 1]);
    let Some(mut step) = round_step((high - low) / FIRST_LINES, &STEPS) else {
        return vec![];
    };
    let mut levels = multiples(step, low, high);
    let mut stretch = [low, high];
    let below = |level: f64| sorted.partition_point(|value| *value < level);
    loop {
        step = finer(step);
        let within = levels
            .iter()
            .copied()
            .filter(|level| stretch[0] < *level && *level < stretch[1]);
        let ends: Vec<f64> = std::iter::once(stretch[0])
            .chain(within)
            .chain([stretch[1]])
            .collect();
        let intervals: Vec<LevelInterval> = ends
            .windows(2)
            .map(|ends| LevelInterval {
                ends: [ends[0], ends[1]],
                share: (below(ends[1]) - below(ends[0])) as f64 / sorted.len() as f64,
                is_outermost: ends[0] == low || ends[1] == high,
            })
            .collect();
        let refined = |[from, to]: [f64; 2]| -> Vec<f64> {
            let outside = |is_kept: &dyn Fn(f64) -> bool| {
                levels.iter().copied().filter(|at| is_kept(*at)).collect()
            };
            [
                outside(&|at| at <= from),
                multiples(step, from, to),
                outside(&|at| at >= to),
            ]
            .concat()
        };
        let dense = LARGE.max(DENSE / (levels.len() + 1) as f64);
        let fits = |ends: [f64; 2]| refined(ends).len() <= LINES;
        match dense_stretch(&intervals, dense, fits) {
            Some(ends) if step >= FINEST * (high - low) => {
                (levels, stretch) = (refined(ends), ends)
            }
            _ => return levels,
        }
    }
}

/// The range between two adjacent levels.
struct LevelInterval {
    ends: [f64; 2],
    /// Fraction of the map with values between the two levels.
    share: f64,
    /// True for the first and the last interval.
    is_outermost: bool,
}

/// The range that gets finer levels. It begins as the interval with the largest share of the map.
/// As long as `fits` accepts the new ends, the neighbouring interval with the larger share is
/// added. From the second neighbour on, an added interval is outermost or has a share above
/// `LARGE`.
///
/// `None` in three cases: no share reaches `dense`; `fits` rejects the first interval; or the first
/// interval is not outermost and no neighbour can be added.
fn dense_stretch(
    intervals: &[LevelInterval],
    dense: f64,
    fits: impl Fn([f64; 2]) -> bool,
) -> Option<[f64; 2]> {
    let by_share = |a: &usize, b: &usize| intervals[*a].share.total_cmp(&intervals[*b].share);
    let densest = (0..intervals.len()).max_by(by_share)?;
    let ends = |from: usize, to: usize| [intervals[from].ends[0], intervals[to].ends[1]];
    if intervals[densest].share < dense || !fits(ends(densest, densest)) {
        return None;
    }
    let (mut from, mut to) = (densest, densest);
    loop {
        let is_wanted =
            |i: &usize| from == to || intervals[*i].share > LARGE || intervals[*i].is_outermost;
        let sides = [
            from.checked_sub(1),
            Some(to + 1).filter(|i| *i < intervals.len()),
        ]
        .into_iter()
        .flatten();
        let sides = sides.filter(|i| is_wanted(i) && fits(ends(from.min(*i), to.max(*i))));
        let Some(side) = sides.max_by(by_share) else {
            break;
        };
        (from, to) = (from.min(side), to.max(side));
    }
    (from < to || intervals[from].is_outermost).then(|| ends(from, to))
}

/// Leading digits of the distance between levels.
const STEPS: [f64; 5] = [1.0, 2.0, 2.5, 5.0, 10.0];
/// Maximum number of lines before refinement, approximately.
const FIRST_LINES: f64 = 8.0;
/// An interval next to the refined range also gets finer levels if its share of the map is above
/// this value. The first refined interval has at least this share.
const LARGE: f64 = 0.12;
/// Minimum share of the first refined interval, as a multiple of the average share of all
/// intervals.
const DENSE: f64 = 1.5;
/// Maximum number of lines after refinement.
const LINES: usize = 14;

/// The multiples of a step between two numbers, without the ends.
fn multiples(step: f64, low: f64, high: f64) -> Vec<f64> {
    let rounding = 1e-9;
    let (from, to) = (
        (low / step + rounding).floor() as i64 + 1,
        (high / step - rounding).ceil() as i64 - 1,
    );
    (from..=to).map(|i| i as f64 * step).collect()
}

/// A finer step that divides `step`: 0.5 instead of 1, 1 instead of 2, 0.5 instead of 2.5, and 1
/// instead of 5, times a power of ten.
fn finer(step: f64) -> f64 {
    let power = 10.0_f64.powf((step * (1.0 + 1e-9)).log10().floor());
    match (step / power * 10.0).round() as i64 {
        10 | 25 => 0.5 * power,
        _ => power,
    }
}

/// Minimum step relative to the range of a map.
const FINEST: f64 = 1e-3;

/// The pieces of a ring, except the pieces along the border of the map.
fn inner(ring: &[[f64; 2]], columns: usize, rows: usize) -> Vec<Vec<[f64; 2]>> {
    let ends = [(columns - 1) as f64, (rows - 1) as f64];
    let along = |a: &[f64; 2], b: &[f64; 2]| {
        (0..2).any(|axis| a[axis] == b[axis] && (a[axis] == 0.0 || a[axis] == ends[axis]))
    };
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
    // if the first point of a ring lies inside the map, the piece through this point is in two
    // parts: join the first and the last part
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

#[cfg(test)]
mod tests {
    use super::super::axis::NamedQuantity;
    use super::{Field, contour_regions, levels};
    use crate::units::System;

    fn field(f: impl Fn(f64, f64) -> Option<f64>) -> Field {
        let mut field = Field {
            quantity: NamedQuantity::plain("f"),
            x: [0.0, 3.0],
            y: [1.0, 2.0],
            columns: 13,
            values: vec![None; 13 * 9],
            gradients: vec![],
            common_values: vec![],
        };
        let place = |i: usize| field.coordinates((i % 13) as f64, (i / 13) as f64);
        field.values = (0..13 * 9).map(|i| f(place(i)[0], place(i)[1])).collect();
        field
    }

    /// The area within an outline, by the shoelace formula.
    fn area(outline: &[[f64; 2]]) -> f64 {
        let next = outline.iter().cycle().skip(1);
        0.5 * outline
            .iter()
            .zip(next)
            .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
            .sum::<f64>()
            .abs()
    }

    #[test]
    fn exact_contour_lines_of_a_plane() {
        let regions = contour_regions(&field(|x, y| Some(2.0 * x - y)), System::Us);
        assert!(regions.len() > 5, "{}", regions.len());
        for region in &regions[1..] {
            assert!(!region.lines.is_empty());
            for [x, y] in region.lines.iter().flatten() {
                assert!(
                    (2.0 * x - y - region.level).abs() < 1e-12,
                    "({x}, {y}) is not on {}",
                    region.level
                );
            }
        }
        // each region contains the next one, and the lowest is the whole map
        let areas: Vec<f64> = regions
            .iter()
            .map(|region| region.outlines.iter().map(|o| area(o)).sum())
            .collect();
        assert!(
            (areas[0] - 3.0).abs() < 1e-12 && areas.windows(2).all(|pair| pair[1] < pair[0]),
            "{areas:?}"
        );
    }

    /// Adjacent levels at the distance d are multiples of ½ · 10^⌊log₁₀ d⌋.
    #[test]
    fn levels_are_round_numbers_and_a_flat_top_has_some() {
        let carry = |x: f64, y: f64| 279.2 - 130.0 * (x - 1.5).powi(2) - 20.0 * (y - 1.7).powi(2);
        for scale in [1.0, 0.9144, 0.013, 4200.0] {
            // the grid is fine enough to resolve the fraction of the map between two levels
            let mut values: Vec<f64> = (0..41 * 41)
                .map(|i| {
                    scale
                        * carry(
                            3.0 * f64::from(i % 41) / 40.0,
                            1.0 + f64::from(i / 41) / 40.0,
                        )
                })
                .collect();
            values.sort_by(f64::total_cmp);
            let levels = levels(&values);
            assert!((6..=18).contains(&levels.len()), "{levels:?}");
            for pair in levels.windows(2) {
                let apart = pair[1] - pair[0];
                let digits =
                    [pair[0], pair[1]].map(|level| level / 10.0_f64.powf(apart.log10().floor()));
                assert!(
                    digits
                        .iter()
                        .all(|digit| (digit * 2.0 - (digit * 2.0).round()).abs() < 1e-6),
                    "{levels:?}"
                );
            }
            // the distances between adjacent levels first decrease and then increase
            let apart: Vec<f64> = levels.windows(2).map(|pair| pair[1] - pair[0]).collect();
            let rises = apart
                .windows(2)
                .position(|pair| pair[1] > 1.01 * pair[0])
                .unwrap_or(apart.len());
            assert!(
                apart
                    .iter()
                    .skip(rises)
                    .is_sorted_by(|a, b| **b > 0.99 * **a),
                "{levels:?}"
            );
            let top = levels[levels.len() - 1];
            assert!(279.2 * scale - top < 0.03 * 279.2 * scale, "{levels:?}");
        }
    }

    #[test]
    fn contours_of_a_basin_have_a_hole_and_missing_nodes_bend_no_line() {
        let bowl = |x: f64, y: f64| (x - 1.5).powi(2) + 4.0 * (y - 1.5).powi(2);
        let rim = contour_regions(&field(|x, y| Some(bowl(x, y))), System::Us);
        // the hole reduces the area of the region around it
        let lowest = &rim[1];
        assert!(
            area(&lowest.outlines[0]) < 2.95,
            "{}",
            area(&lowest.outlines[0])
        );
        let plane = |x: f64, y: f64| (x < 2.0 || y < 1.5).then_some(x);
        for region in &contour_regions(&field(plane), System::Us)[1..] {
            for [x, _] in region.lines.iter().flatten().filter(|[x, _]| *x < 1.9) {
                assert!((x - region.level).abs() < 1e-12);
            }
        }
        assert!(contour_regions(&field(|_, _| None), System::Us).is_empty());
        assert_eq!(
            contour_regions(&field(|_, _| Some(1.0)), System::Us).len(),
            1
        );
    }
}
