//! Natural bicubic splines through a grid of numbers. The surface is C² in both directions.

use crate::number::Numbers;

/// A cell of the grid: x, 1/width, y and 1/height, with the corner (x, y), then 16 coefficients for
/// each of the two surfaces. Coefficient 4i + j multiplies uⁱ wʲ, where u and w are the coordinates
/// in the cell along x and y, from 0 to 1.
pub(crate) type Cell = [f64; 36];

/// Index of the first coefficient of the first surface, C_D, in a cell.
pub(crate) const DRAG_START: usize = 4;
/// Index of the first coefficient of the second surface, C_L, in a cell.
pub(crate) const LIFT_START: usize = 20;

/// Two surfaces over one grid, such as drag and lift, with two numbers at each node. The numbers
/// are static: an evaluation allocates no memory.
#[derive(Debug)]
pub(crate) struct Surface {
    x: Knots,
    y: Knots,
    /// The cells, row by row: for each interval of y, the cells of all intervals of x.
    pub cells: &'static [Cell],
}

/// Coordinates of the lines of the grid, in ascending order.
#[derive(Debug)]
struct Knots {
    at: &'static [f64],
    /// Index of the last interval.
    last: usize,
    /// Reciprocal of the length of an interval, if all intervals are equal.
    per_unit: Option<f64>,
}

impl Surface {
    /// The surfaces with these [`cells`]. `x` and `y` are the coordinates of the grid lines, in
    /// ascending order.
    pub fn new(x: &'static [f64], y: &'static [f64], cells: &'static [Cell]) -> Self {
        Self {
            x: Knots::new(x),
            y: Knots::new(y),
            cells,
        }
    }

    /// The cell that contains a point, or the nearest cell for a point outside of the grid.
    pub fn cell(&self, x: f64, y: f64) -> &'static Cell {
        &self.cells[self.y.interval(y) * (self.x.last + 1) + self.x.interval(x)]
    }
}

/// Largest number of inner knots for a linear search, which has no branches. More inner knots are
/// searched by bisection.
const MOST_LINEAR: usize = 16;

impl Knots {
    fn new(at: &'static [f64]) -> Self {
        let (first, last) = (at[0], at[at.len() - 1]);
        let even = (last - first) / intervals(at.len()) as f64;
        let is_even = |(i, knot): (usize, &f64)| {
            (first + even * i as f64 - knot).abs() <= 1e-12 * (last - first)
        };
        let per_unit = (at.len() > 1 && at.iter().enumerate().all(is_even)).then_some(1.0 / even);
        Self {
            last: intervals(at.len()) - 1,
            at,
            per_unit,
        }
    }

    /// Index of the interval that contains a value; for a value outside of the grid, the nearest
    /// interval.
    #[inline]
    fn interval(&self, value: f64) -> usize {
        if let Some(per_unit) = self.per_unit {
            // NaN as usize is 0
            let place = ((value - self.at[0]) * per_unit) as usize;
            return if place < self.last { place } else { self.last };
        }
        // the number of inner knots at or below the value is the index of its interval
        if self.last <= MOST_LINEAR {
            return self.at[1..=self.last]
                .iter()
                .map(|knot| usize::from(*knot <= value))
                .sum();
        }
        self.at[1..=self.last].partition_point(|knot| *knot <= value)
    }
}

/// Number of intervals between this many knots; 1 for a single knot.
pub(super) fn intervals(knots: usize) -> usize {
    (knots - 1).max(1)
}

/// Start and width of an interval; infinite width for a single knot.
fn interval(knots: &[f64], i: usize) -> (f64, f64) {
    (
        knots[i],
        knots
            .get(i + 1)
            .map_or(f64::INFINITY, |next| next - knots[i]),
    )
}

/// The cells of the surfaces through the values of two tables. `x` and `y` are the coordinates of
/// the grid lines, in ascending order; `tables` lists the values row by row. If `x` or `y` has a
/// single coordinate, the surfaces are constant in that direction.
pub(crate) fn cells(x: &[f64], y: &[f64], tables: [&[f64]; 2]) -> Vec<Cell> {
    let mut cells = vec![[0.0; 36]; intervals(x.len()) * intervals(y.len())];
    let columns = x.len();
    // derivatives by x, by y, and by both; then working memory
    let [mut by_x, mut by_y, mut by_xy, mut diagonal] =
        [(); 4].map(|()| vec![0.0; tables[0].len()]);
    for (first, table) in [DRAG_START, LIFT_START].into_iter().zip(tables) {
        for row in 0..y.len() {
            slopes(x, table, &mut by_x, &mut diagonal, |i| row * columns + i);
        }
        for column in 0..columns {
            let place = |i: usize| i * columns + column;
            slopes(y, table, &mut by_y, &mut diagonal, place);
            slopes(y, &by_x, &mut by_xy, &mut diagonal, place);
        }
        for (place, cell) in cells.iter_mut().enumerate() {
            let (row, column) = (place / intervals(x.len()), place % intervals(x.len()));
            let ((corner, wide), (low, high)) = (interval(x, column), interval(y, row));
            // the indices of a cell's two grid lines; both are 0 if there is a single line
            let ends = |first: usize, count: usize| [first, (first + 1).min(count - 1)];
            let scaled = |slope: f64, width: f64| {
                if width.is_finite() {
                    slope * width
                } else {
                    0.0
                }
            };
            // the cubic along x on a row, through the values, or through their derivatives by y
            let along = |values: &[f64], slopes: &[f64], row: usize| {
                let places = ends(column, columns).map(|column| row * columns + column);
                cubic(
                    places.map(|at| values[at]),
                    places.map(|at| scaled(slopes[at], wide)),
                )
            };
            let rows = ends(row, y.len());
            let values = rows.map(|row| along(table, &by_x, row));
            let slopes = rows.map(|row| along(&by_y, &by_xy, row));
            [cell[0], cell[1], cell[2], cell[3]] = [corner, 1.0 / wide, low, 1.0 / high];
            for power in 0..4 {
                let start = first + 4 * power;
                let found = cubic(
                    values.map(|v| v[power]),
                    slopes.map(|s| scaled(s[power], high)),
                );
                cell[start..start + 4].copy_from_slice(&found);
            }
        }
    }
    cells
}

/// The bicubic polynomial at (u, w), by Horner's scheme. Its coefficients begin at index `first` of
/// a cell: [`DRAG_START`] or [`LIFT_START`].
#[inline(always)]
pub(crate) fn bicubic<T: Numbers>(cell: &[T; 36], first: usize, u: T, w: T) -> T {
    let mut sum = T::zero();
    let mut power = 4;
    while power > 0 {
        power -= 1;
        let i = first + 4 * power;
        let along = w.mul_add(
            w.mul_add(w.mul_add(cell[i + 3], cell[i + 2]), cell[i + 1]),
            cell[i],
        );
        sum = sum.mul_add(u, along);
    }
    sum
}

/// Coefficients, by ascending powers, of the cubic that has these values and slopes at 0 and 1.
fn cubic([here, there]: [f64; 2], [slope, end]: [f64; 2]) -> [f64; 4] {
    let rise = there - here;
    [
        here,
        slope,
        3.0 * rise - 2.0 * slope - end,
        slope + end - 2.0 * rise,
    ]
}

/// Writes the slopes at the knots of the natural cubic spline through `values` (zero curvature at
/// both ends). `place` maps a knot to the index of its value and slope in a table; `diagonal` is
/// working memory.
fn slopes(
    knots: &[f64],
    values: &[f64],
    slopes: &mut [f64],
    diagonal: &mut [f64],
    place: impl Fn(usize) -> usize,
) {
    let count = knots.len();
    for i in 0..count {
        (diagonal[i], slopes[place(i)]) = (0.0, 0.0);
    }
    if count < 2 {
        return;
    }
    let per = |i: usize| 1.0 / (knots[i + 1] - knots[i]);
    let right_side = |i: usize| 3.0 * (values[place(i + 1)] - values[place(i)]) * per(i) * per(i);
    // tridiagonal system for the slopes m, row i: per(i−1) m(i−1) + 2 (per(i−1) + per(i)) m(i) +
    // per(i) m(i+1) = right_side(i−1) + right_side(i), without the terms of missing neighbours
    for i in 0..count - 1 {
        for at in [i, i + 1] {
            diagonal[at] += 2.0 * per(i);
            slopes[place(at)] += right_side(i);
        }
    }
    for i in 1..count {
        let multiplier = per(i - 1) / diagonal[i - 1];
        diagonal[i] -= multiplier * per(i - 1);
        slopes[place(i)] -= multiplier * slopes[place(i - 1)];
    }
    for i in (0..count).rev() {
        let next = if i + 1 < count {
            per(i) * slopes[place(i + 1)]
        } else {
            0.0
        };
        slopes[place(i)] = (slopes[place(i)] - next) / diagonal[i];
    }
}

#[cfg(test)]
mod tests {
    use super::{DRAG_START, Surface, bicubic, cells, slopes};

    #[test]
    fn exact_slopes_of_a_line_and_of_a_spline_by_hand() {
        let slopes = |knots: &[f64], values: &[f64]| {
            let (mut found, mut room) = (vec![0.0; knots.len()], vec![0.0; knots.len()]);
            slopes(knots, values, &mut found, &mut room, |i| i);
            found
        };
        let line = slopes(&[0.0, 1.0, 3.0, 4.5], &[1.0, 3.0, 7.0, 10.0]);
        assert!(
            line.iter().all(|slope| (slope - 2.0).abs() < 1e-14),
            "{line:?}"
        );
        // the spline through (−1, 0), (0, 1) and (1, 0) is 1 − 3/2 x² + |x|³/2
        let hill = slopes(&[-1.0, 0.0, 1.0], &[0.0, 1.0, 0.0]);
        for (found, by_hand) in hill.iter().zip([1.5, 0.0, -1.5]) {
            assert!((found - by_hand).abs() < 1e-14, "{hill:?}");
        }
    }

    #[test]
    fn exact_surface_of_a_plane_and_along_a_single_line() {
        let plane = |x: f64, y: f64| 1.0 + 2.0 * x + 3.0 * y + 4.0 * x * y;
        for y in [vec![0.0, 0.5, 2.0, 2.5], vec![0.5]] {
            let x = vec![0.0, 1.0, 2.0, 3.0, 4.0];
            let table: Vec<f64> = y
                .iter()
                .flat_map(|y| x.iter().map(|x| plane(*x, *y)).collect::<Vec<_>>())
                .collect();
            let cells = cells(&x, &y, [&table, &table]);
            let surface = Surface::new(x.leak(), y.clone().leak(), cells.leak());
            for (x, at) in [(0.25, 0.4), (3.9, 2.2), (2.0, 0.5)] {
                let cell = surface.cell(x, at);
                let (u, w) = ((x - cell[0]) * cell[1], (at - cell[2]) * cell[3]);
                let found = bicubic(cell, DRAG_START, u, w);
                let expected = plane(x, if y.len() > 1 { at } else { 0.5 });
                assert!(
                    (found - expected).abs() < 1e-13,
                    "{x}, {at}: {found} {expected}"
                );
            }
        }
    }
}
