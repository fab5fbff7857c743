//! Interpolation between the nodes of a field. Without interpolation, contours would have corners
//! if the nodes are far apart.

use super::figure::Field;

/// Minimum number of intervals along the longer side of a refined grid.
const INTERVALS: usize = 120;

/// A field on a fine grid, so that its contours are smooth.
pub(super) struct Refined {
    /// Number of fine intervals between two adjacent nodes of the field.
    pub times: usize,
    pub columns: usize,
    pub rows: usize,
    /// The values row by row, without gaps: missing values are extrapolated.
    pub values: Vec<f64>,
    /// True where the nearest node of the field has a value.
    pub is_known: Vec<bool>,
}

impl Refined {
    /// The field on a fine grid, by cubic Hermite interpolation. A field without gradients keeps
    /// its own grid. `None` for a field with fewer than 2 columns or 2 rows, or without values.
    pub fn new(field: &Field) -> Option<Self> {
        let (columns, rows) = (field.columns, field.rows());
        if columns < 2 || rows < 2 || field.values.iter().all(Option::is_none) {
            return None;
        }
        let values = continued(field);
        if field.gradients.is_empty() {
            return Some(Self {
                times: 1,
                columns,
                rows,
                values,
                is_known: field.values.iter().map(Option::is_some).collect(),
            });
        }
        let times = INTERVALS.div_ceil(columns.max(rows) - 1);
        let [across, up] = slopes(field, &values);
        // first interpolate along the rows: the values, and the derivatives by y; then interpolate
        // the values along the columns
        let by_row = |nodes: &[f64], slopes: &[f64]| -> Vec<f64> {
            let rows = nodes.chunks(columns).zip(slopes.chunks(columns));
            rows.flat_map(|(nodes, slopes)| hermite(nodes, slopes, times))
                .collect()
        };
        let twist = differences(&up, columns, 1);
        let (nodes, slopes) = (by_row(&values, &across), by_row(&up, &twist));
        let fine = [(columns - 1) * times + 1, (rows - 1) * times + 1];
        let column = |of: &[f64], i: usize| of.iter().skip(i).step_by(fine[0]).copied().collect();
        let by_column: Vec<Vec<f64>> = (0..fine[0])
            .map(|i| {
                let (nodes, slopes): (Vec<_>, Vec<_>) = (column(&nodes, i), column(&slopes, i));
                hermite(&nodes, &slopes, times)
            })
            .collect();
        let nearest = |at: usize| (at + times / 2) / times;
        let points = (0..fine[1]).flat_map(|row| (0..fine[0]).map(move |column| (column, row)));
        let is_known = points
            .clone()
            .map(|(column, row)| field.values[nearest(row) * columns + nearest(column)].is_some());
        Some(Self {
            times,
            columns: fine[0],
            rows: fine[1],
            is_known: is_known.collect(),
            values: points.map(|(column, row)| by_column[column][row]).collect(),
        })
    }

    /// Divides the values by a unit.
    pub fn over(mut self, unit: f64) -> Self {
        self.values.iter_mut().for_each(|value| *value /= unit);
        self
    }
}

/// The derivatives by x and y at each node, times the distance between nodes. A node without a
/// gradient has the central difference instead.
fn slopes(field: &Field, values: &[f64]) -> [Vec<f64>; 2] {
    let (columns, rows) = (field.columns, field.rows());
    [(0, field.x, columns, 1), (1, field.y, rows, columns)].map(
        |(axis, [low, high], count, step)| {
            let apart = (high - low) / (count - 1) as f64;
            let exact = field
                .gradients
                .iter()
                .map(|of| Some(of.as_ref()?[axis] * apart));
            let between = differences(values, columns, step);
            exact
                .zip(between)
                .map(|(exact, between)| exact.unwrap_or(between))
                .collect()
        },
    )
}

/// The central difference along an axis at each node; the first and the last node have one-sided
/// differences. `step` is the difference between the indices of neighbours: 1 along a row,
/// `columns` along a column.
fn differences(values: &[f64], columns: usize, step: usize) -> Vec<f64> {
    let count = if step == 1 {
        columns
    } else {
        values.len() / columns
    };
    let of = |i: usize| {
        let at = i / step % count;
        let (before, after) = (at.min(1), (count - 1 - at).min(1));
        let rise = values[i + after * step] - values[i - before * step];
        rise / (before + after) as f64
    };
    (0..values.len()).map(of).collect()
}

/// The cubic Hermite interpolation of equidistant nodes, with `times` points for each interval.
fn hermite(nodes: &[f64], slopes: &[f64], times: usize) -> Vec<f64> {
    let interval = |i: usize| {
        let rise = nodes[i + 1] - nodes[i];
        (0..times).map(move |k| {
            let t = k as f64 / times as f64;
            let bend = (1.0 - t) * (slopes[i] - rise) - t * (slopes[i + 1] - rise);
            nodes[i] + t * (rise + (1.0 - t) * bend)
        })
    };
    let last = nodes.last().copied();
    (0..nodes.len() - 1)
        .flat_map(interval)
        .chain(last)
        .collect()
}

/// The values of the field, extrapolated to the nodes without a value. Contour lines then continue
/// under the mask of missing values, and do not bend at its edge.
fn continued(field: &Field) -> Vec<f64> {
    let (columns, rows) = (field.columns, field.rows());
    let mut values = field.values.clone();
    while values.iter().any(Option::is_none) && values.iter().any(Option::is_some) {
        let before = values.clone();
        for i in (0..values.len()).filter(|i| before[*i].is_none()) {
            let (column, row) = (i % columns, i / columns);
            // the mean over the sides with a value: a linear extrapolation from the two nearest
            // nodes, or the nearest value if the second node has none
            let reach = [column, columns - 1 - column, row, rows - 1 - row];
            let node = |side: usize, n: usize| {
                [
                    i.checked_sub(n),
                    Some(i + n),
                    i.checked_sub(n * columns),
                    Some(i + n * columns),
                ][side]
            };
            let known = |side: usize, n: usize| {
                (reach[side] >= n).then(|| before[node(side, n)?]).flatten()
            };
            let ahead = |side: usize| {
                let near = known(side, 1)?;
                Some(known(side, 2).map_or(near, |far| 2.0 * near - far))
            };
            let known: Vec<f64> = (0..4).filter_map(ahead).collect();
            if !known.is_empty() {
                values[i] = Some(known.iter().sum::<f64>() / known.len() as f64);
            }
        }
    }
    values.into_iter().map(Option::unwrap_or_default).collect()
}

#[cfg(test)]
mod tests {
    use super::super::axis::NamedQuantity;
    use super::{Field, INTERVALS, Refined};

    /// The field of the function `f` on the unit square. `f` returns the value and the gradient.
    fn field(nodes: usize, f: impl Fn(f64, f64) -> [f64; 3]) -> Field {
        let part = |i: usize| i as f64 / (nodes - 1) as f64;
        let at: Vec<[f64; 3]> = (0..nodes * nodes)
            .map(|i| f(part(i % nodes), part(i / nodes)))
            .collect();
        Field {
            quantity: NamedQuantity::plain("f"),
            x: [0.0, 1.0],
            y: [0.0, 1.0],
            columns: nodes,
            values: at.iter().map(|[value, ..]| Some(*value)).collect(),
            gradients: at.iter().map(|[_, x, y]| Some([*x, *y])).collect(),
            common_values: vec![],
        }
    }

    /// The largest difference between the interpolation and the function.
    fn error(nodes: usize, f: impl Fn(f64, f64) -> [f64; 3] + Copy) -> f64 {
        let fine = Refined::new(&field(nodes, f)).unwrap();
        let at = |i: usize, count: usize| i as f64 / (count - 1) as f64;
        let off = |(i, value): (usize, &f64)| {
            let x = at(i % fine.columns, fine.columns);
            (value - f(x, at(i / fine.columns, fine.rows))[0]).abs()
        };
        fine.values.iter().enumerate().map(off).fold(0.0, f64::max)
    }

    #[test]
    fn exact_values_of_cubics_between_coarse_nodes() {
        let cubic = |x: f64, y: f64| {
            let value = x.powi(3) - 2.0 * x * y + 4.0 * y.powi(3) - y;
            [value, 3.0 * x * x - 2.0 * y, -2.0 * x + 12.0 * y * y - 1.0]
        };
        assert!(error(4, cubic) < 1e-14, "{}", error(4, cubic));
        assert!(Refined::new(&field(4, cubic)).unwrap().columns > INTERVALS);
    }

    /// If the distance between nodes is halved, the error decreases by a factor of 16 inside. At
    /// the edges, where differences are one-sided, the factor is 8.
    #[test]
    fn order_of_the_interpolation_is_three_or_more() {
        let wave = |x: f64, y: f64| {
            let (sin, cos) = (2.0 * x + y).sin_cos();
            [sin * y, 2.0 * cos * y, cos * y + sin]
        };
        let [coarse, fine] = [11, 21].map(|nodes| error(nodes, wave));
        assert!(fine > 0.0 && coarse / fine > 7.0, "{coarse} {fine}");
    }

    #[test]
    fn a_node_without_a_gradient_has_the_slope_between_its_neighbours() {
        let plane = |x: f64, y: f64| [3.0 * x - y, 3.0, -1.0];
        let mut field = field(5, plane);
        field.gradients[12] = None;
        (field.values[24], field.gradients[24]) = (None, None);
        let fine = Refined::new(&field).unwrap();
        for (i, value) in fine.values.iter().enumerate() {
            let x = (i % fine.columns) as f64 / (fine.columns - 1) as f64;
            let y = (i / fine.columns) as f64 / (fine.rows - 1) as f64;
            assert!((value - plane(x, y)[0]).abs() < 1e-13, "{x} {y}: {value}");
        }
        // only points whose nearest node is the missing corner are unknown
        let unknown = fine.is_known.iter().filter(|is_known| !**is_known).count();
        let reach = fine.times.div_ceil(2);
        assert!(
            unknown > 0 && unknown <= (reach + 1) * (reach + 1),
            "{unknown}"
        );
    }
}
