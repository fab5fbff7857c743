//! Cubic splines through a grid of numbers, natural at its edges: the surface has two continuous derivatives in both directions.

/// A cell of the grid: its corner and its sizes (x, 1/width, y, 1/height), then the coefficients of both numbers by the powers of the place
/// in it, 0 to 1 in both directions, four of y for each of x.
pub(crate) type Cell = [f64; 36];

/// The surfaces through two numbers at each node of a grid.
#[derive(Debug)]
pub(crate) struct Surface {
    x: Knots,
    y: Knots,
    /// Row by row: for each step of y, all of x.
    cells: Vec<Cell>,
}

/// Where the lines of the grid are, rising.
#[derive(Debug)]
struct Knots {
    at: Vec<f64>,
    /// The number of the last step.
    last: usize,
    /// Where they are evenly spaced: how many there are to a unit.
    per_unit: Option<f64>,
}

impl Surface {
    /// The surfaces over the lines `x` and `y`, each rising, through two tables of numbers, row by row. Along a direction with one line
    /// nothing changes.
    pub fn new(x: Vec<f64>, y: Vec<f64>, tables: [&[f64]; 2]) -> Self {
        let patches = tables.map(|table| patches(&x, &y, table));
        let columns = steps(&x);
        let mut cells = Vec::with_capacity(columns * steps(&y));
        for (place, (first, second)) in patches[0].iter().zip(&patches[1]).enumerate() {
            let ((corner, wide), (low, high)) = (step(&x, place % columns), step(&y, place / columns));
            let place = [corner, 1.0 / wide, low, 1.0 / high];
            let mut cell = [0.0; 36];
            for (number, part) in
                cell.iter_mut().zip(place.iter().chain(first.iter().flatten()).chain(second.iter().flatten()))
            {
                *number = *part;
            }
            cells.push(cell);
        }
        Self { x: Knots::new(x), y: Knots::new(y), cells }
    }

    /// The cell where a place lies; outside of the grid the next one.
    pub fn cell(&self, x: f64, y: f64) -> &Cell {
        &self.cells[self.y.step(y) * (self.x.last + 1) + self.x.step(x)]
    }

    /// All cells.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }
}

impl Knots {
    fn new(at: Vec<f64>) -> Self {
        let (first, last) = (at[0], at[at.len() - 1]);
        let even = (last - first) / steps(&at) as f64;
        let is_even = |(i, knot): (usize, &f64)| (first + even * i as f64 - knot).abs() <= 1e-12 * (last - first);
        let per_unit = (at.len() > 1 && at.iter().enumerate().all(is_even)).then_some(1.0 / even);
        Self { last: steps(&at) - 1, at, per_unit }
    }

    /// The number of the step that a value lies in, or next to.
    #[inline]
    fn step(&self, value: f64) -> usize {
        if let Some(per_unit) = self.per_unit {
            // what is no number lies in the first
            let place = ((value - self.at[0]) * per_unit) as usize;
            return if place < self.last { place } else { self.last };
        }
        // the inner knots that are not above the value, by halves
        let (mut first, mut count) = (0, self.last);
        while count > 0 {
            let half = count / 2;
            if self.at[first + half + 1] <= value {
                first += half + 1;
                count -= half + 1;
            } else {
                count = half;
            }
        }
        first
    }
}

/// How many steps there are along some lines: one along a single line.
fn steps(knots: &[f64]) -> usize {
    (knots.len() - 1).max(1)
}

/// Where a step begins, and its width; without end along a single line.
fn step(knots: &[f64], i: usize) -> (f64, f64) {
    (knots[i], knots.get(i + 1).map_or(f64::INFINITY, |next| next - knots[i]))
}

/// The coefficients of the surface through a table, cell by cell, by powers of x and y.
fn patches(x: &[f64], y: &[f64], table: &[f64]) -> Vec<[[f64; 4]; 4]> {
    let columns = x.len();
    // slopes by x, by y, and by both
    let by_x: Vec<f64> = table.chunks(columns).flat_map(|row| slopes(x, row)).collect();
    let by_y = |table: &[f64]| -> Vec<f64> {
        let mut all = vec![0.0; table.len()];
        for column in 0..columns {
            let values: Vec<f64> = table.iter().skip(column).step_by(columns).copied().collect();
            for (row, slope) in slopes(y, &values).into_iter().enumerate() {
                all[row * columns + column] = slope;
            }
        }
        all
    };
    let (up, twisted) = (by_y(table), by_y(&by_x));
    let mut patches = Vec::with_capacity(steps(x) * steps(y));
    for row in 0..steps(y) {
        for column in 0..steps(x) {
            // the same line twice where there is but one
            let ends = |first: usize, count: usize| [first, (first + 1).min(count - 1)];
            let part = |slope: f64, (_, width): (f64, f64)| if width.is_finite() { slope * width } else { 0.0 };
            // along x at both rows: the values, and their slopes by y
            let along = |values: &[f64], slopes: &[f64], row: usize| {
                let places = ends(column, columns).map(|column| row * columns + column);
                cubic(places.map(|at| values[at]), places.map(|at| part(slopes[at], step(x, column))))
            };
            let rows = ends(row, y.len());
            let values = rows.map(|row| along(table, &by_x, row));
            let slopes = rows.map(|row| along(&up, &twisted, row));
            patches.push(std::array::from_fn(|power| {
                cubic(values.map(|v| v[power]), slopes.map(|s| part(s[power], step(y, row))))
            }));
        }
    }
    patches
}

/// The coefficients, by powers from 0 on, of the cubic between 0 and 1 that has these values and slopes there.
fn cubic([here, there]: [f64; 2], [slope, end]: [f64; 2]) -> [f64; 4] {
    let rise = there - here;
    [here, slope, 3.0 * rise - 2.0 * slope - end, slope + end - 2.0 * rise]
}

/// The slopes at the knots of the cubic spline through some values, without curvature at both ends.
fn slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let count = knots.len();
    if count < 2 {
        return vec![0.0; count];
    }
    let per = |i: usize| 1.0 / (knots[i + 1] - knots[i]);
    let pull = |i: usize| 3.0 * (values[i + 1] - values[i]) * per(i) * per(i);
    // row i: per(i−1) m(i−1) + 2 (per(i−1) + per(i)) m(i) + per(i) m(i+1) = pull(i−1) + pull(i), where there are such neighbours
    let (mut diagonal, mut right) = (vec![0.0; count], vec![0.0; count]);
    for i in 0..count - 1 {
        for at in [i, i + 1] {
            diagonal[at] += 2.0 * per(i);
            right[at] += pull(i);
        }
    }
    for i in 1..count {
        let part = per(i - 1) / diagonal[i - 1];
        diagonal[i] -= part * per(i - 1);
        right[i] -= part * right[i - 1];
    }
    let mut slopes = vec![0.0; count];
    for i in (0..count).rev() {
        let next = if i + 1 < count { per(i) * slopes[i + 1] } else { 0.0 };
        slopes[i] = (right[i] - next) / diagonal[i];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::{Surface, slopes};

    #[test]
    fn exact_slopes_of_a_line_and_of_a_spline_by_hand() {
        let line = slopes(&[0.0, 1.0, 3.0, 4.5], &[1.0, 3.0, 7.0, 10.0]);
        assert!(line.iter().all(|slope| (slope - 2.0).abs() < 1e-14), "{line:?}");
        // through (−1, 0), (0, 1), (1, 0): 1 − 3/2 x² ± x³/2, with slope 3/2, 0, −3/2
        let hill = slopes(&[-1.0, 0.0, 1.0], &[0.0, 1.0, 0.0]);
        for (found, by_hand) in hill.iter().zip([1.5, 0.0, -1.5]) {
            assert!((found - by_hand).abs() < 1e-14, "{hill:?}");
        }
    }

    /// A plane 1 + 2 x + 3 y + 4 x y over uneven lines, and over a single one.
    #[test]
    fn exact_surface_of_a_plane_and_along_a_single_line() {
        let plane = |x: f64, y: f64| 1.0 + 2.0 * x + 3.0 * y + 4.0 * x * y;
        for y in [vec![0.0, 0.5, 2.0, 2.5], vec![0.5]] {
            let x = vec![0.0, 1.0, 2.0, 3.0, 4.0];
            let table: Vec<f64> = y.iter().flat_map(|y| x.iter().map(|x| plane(*x, *y)).collect::<Vec<_>>()).collect();
            let surface = Surface::new(x, y.clone(), [&table, &table]);
            for (x, at) in [(0.25, 0.4), (3.9, 2.2), (2.0, 0.5)] {
                let cell = surface.cell(x, at);
                let (u, w) = ((x - cell[0]) * cell[1], (at - cell[2]) * cell[3]);
                let along = |power: usize| (0..4).rev().fold(0.0, |sum, k| sum * w + cell[4 + 4 * power + k]);
                let found = (0..4).rev().fold(0.0, |sum, power| sum * u + along(power));
                let expected = plane(x, if y.len() > 1 { at } else { 0.5 });
                assert!((found - expected).abs() < 1e-13, "{x}, {at}: {found} {expected}");
            }
        }
    }
}
