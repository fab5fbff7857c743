//! Cubic splines through a grid of numbers, natural at its edges: the surface has two continuous derivatives in both directions.

use super::grid::{DRAG, LIFT, SPEEDS, SPINS};
use std::sync::LazyLock;

const COLUMNS: usize = SPEEDS.len();
const ROWS: usize = DRAG.len();

/// rpm from one row to the next.
const ROW: f64 = (SPINS[1] - SPINS[0]) / (ROWS - 1) as f64;

/// A cell of the grid: its corner and its sizes (speed, 1/width, spin, 1/height), then the coefficients of C_D and of C_L by the powers of
/// the place in it, 0 to 1 in both directions, four of the spin for each of the speed.
pub(super) type Cell = [f64; 36];

static CELLS: LazyLock<[[Cell; COLUMNS - 1]; ROWS - 1]> = LazyLock::new(cells);

/// The cell where a speed, m/s, and a spin, rpm, lie; outside of the grid the next one.
pub(super) fn cell(speed: f64, spin: f64) -> &'static Cell {
    let column = SPEEDS.partition_point(|knot| *knot <= speed).clamp(1, COLUMNS - 1) - 1;
    let row = ((spin - SPINS[0]) / ROW).clamp(0.0, (ROWS - 2) as f64) as usize;
    &CELLS[row][column]
}

fn cells() -> [[Cell; COLUMNS - 1]; ROWS - 1] {
    let coefficients = [surface(&DRAG), surface(&LIFT)];
    let mut cells = [[[0.0; 36]; COLUMNS - 1]; ROWS - 1];
    for (row, cells) in cells.iter_mut().enumerate() {
        for (column, cell) in cells.iter_mut().enumerate() {
            let (corner, end) = (SPEEDS[column], SPEEDS[column + 1]);
            let place = [corner, 1.0 / (end - corner), SPINS[0] + ROW * row as f64, 1.0 / ROW];
            let [drag, lift] = [0, 1].map(|which: usize| coefficients[which][row][column]);
            let parts = place.iter().chain(drag.iter().flatten()).chain(lift.iter().flatten());
            for (number, part) in cell.iter_mut().zip(parts) {
                *number = *part;
            }
        }
    }
    cells
}

/// The coefficients of the surface through a table, cell by cell, by powers of speed and spin.
fn surface(table: &[[f64; COLUMNS]; ROWS]) -> [[[[f64; 4]; 4]; COLUMNS - 1]; ROWS - 1] {
    let spins: [f64; ROWS] = std::array::from_fn(|row| SPINS[0] + ROW * row as f64);
    // slopes by the speed, by the spin, and by both
    let by_speed: [[f64; COLUMNS]; ROWS] = table.map(|row| slopes(&SPEEDS, &row));
    let by_spin = |table: &[[f64; COLUMNS]; ROWS]| -> [[f64; COLUMNS]; ROWS] {
        let columns: [[f64; ROWS]; COLUMNS] =
            std::array::from_fn(|column| slopes(&spins, &std::array::from_fn(|row| table[row][column])));
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
    };
    let (up, twisted) = (by_spin(table), by_spin(&by_speed));
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let width = SPEEDS[column + 1] - SPEEDS[column];
            // along the speed at both spins: the values, and their slopes by the spin
            let along = |values: &[[f64; COLUMNS]; ROWS], slopes: &[[f64; COLUMNS]; ROWS], row: usize| {
                let ends = [column, column + 1];
                cubic(ends.map(|c| values[row][c]), ends.map(|c| slopes[row][c] * width))
            };
            let values = [row, row + 1].map(|row| along(table, &by_speed, row));
            let slopes = [row, row + 1].map(|row| along(&up, &twisted, row));
            std::array::from_fn(|power| cubic(values.map(|v| v[power]), slopes.map(|s| s[power] * ROW)))
        })
    })
}

/// The coefficients, by powers from 0 on, of the cubic between 0 and 1 that has these values and slopes there.
fn cubic([here, there]: [f64; 2], [slope, end]: [f64; 2]) -> [f64; 4] {
    let rise = there - here;
    [here, slope, 3.0 * rise - 2.0 * slope - end, slope + end - 2.0 * rise]
}

/// The slopes at the knots of the cubic spline through some values, without curvature at both ends.
fn slopes<const N: usize>(knots: &[f64; N], values: &[f64; N]) -> [f64; N] {
    let per = |i: usize| 1.0 / (knots[i + 1] - knots[i]);
    let pull = |i: usize| 3.0 * (values[i + 1] - values[i]) * per(i) * per(i);
    // row i: per(i−1) m(i−1) + 2 (per(i−1) + per(i)) m(i) + per(i) m(i+1) = pull(i−1) + pull(i), where there are such neighbours
    let [mut diagonal, mut right] = [[0.0; N]; 2];
    for i in 0..N - 1 {
        for at in [i, i + 1] {
            diagonal[at] += 2.0 * per(i);
            right[at] += pull(i);
        }
    }
    for i in 1..N {
        let part = per(i - 1) / diagonal[i - 1];
        diagonal[i] -= part * per(i - 1);
        right[i] -= part * right[i - 1];
    }
    let mut slopes = [0.0; N];
    for i in (0..N).rev() {
        let next = if i + 1 < N { per(i) * slopes[i + 1] } else { 0.0 };
        slopes[i] = (right[i] - next) / diagonal[i];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::slopes;

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
}
