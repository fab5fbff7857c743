use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::parameters::{NumberTable, TableFault};
use crate::table::{Text, unreadable_text};
use crate::units::Quantity;
use csv::StringRecord;
use std::io::Read;
use std::path::Path;

/// Expected strokes to hole out as a function of the distance to the hole: a natural cubic spline
/// through a table. It is C², and linear beyond the ends of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Strokes {
    /// Distances, m, ascending.
    distance: Vec<f64>,
    /// Expected strokes at the distances.
    strokes: Vec<f64>,
    /// Second derivatives of the spline at the distances.
    second_derivatives: Vec<f64>,
    /// Outcomes that give the ball's final position: downrange and to the right.
    pub(in crate::study) outcomes: [Outcome; 2],
}

impl Strokes {
    /// A table of distances (m, ascending) with the expected strokes from each distance. The ball's
    /// final position is its position at rest if `runs`, otherwise the landing point. Errors show
    /// distances in `unit`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for fewer than two rows, distances that are not ascending, or negative
    /// numbers.
    pub fn new(rows: &[(f64, f64)], unit: &str, runs: bool) -> Result<Self> {
        let refuse = |source: String| Err(Error::unreadable("the table of strokes", source));
        if rows.len() < 2 {
            return refuse(format!("it has {} rows; it needs at least 2", rows.len()));
        }
        for (i, (distance, strokes)) in rows.iter().enumerate() {
            let is_sound =
                distance.is_finite() && *distance >= 0.0 && strokes.is_finite() && *strokes >= 0.0;
            if !is_sound || i > 0 && *distance <= rows[i - 1].0 {
                let reason = "distances must be 0 or more and rise from row to row, and strokes be \
                              0 or more";
                return refuse(format!(
                    "row {}: {}, {strokes} strokes; {reason}",
                    i + 1,
                    Quantity::LENGTH.show(*distance, unit)
                ));
            }
        }
        let (distance, strokes): (Vec<f64>, Vec<f64>) = rows.iter().copied().unzip();
        let second_derivatives = natural(&distance, &strokes);
        let outcomes = if runs {
            [Outcome::Total, Outcome::LateralTotal]
        } else {
            [Outcome::Carry, Outcome::Lateral]
        };
        Ok(Self {
            distance,
            strokes,
            second_derivatives,
            outcomes,
        })
    }

    /// True if the ball's final position is its position at rest, false for the landing point.
    pub fn runs(&self) -> bool {
        self.outcomes.iter().any(|outcome| outcome.needs_run())
    }

    /// Reads a CSV file with the columns `distance` (with its unit: `distance [yd]`) and `strokes`.
    ///
    /// # Errors
    /// [`Error::Table`] for a file that cannot be read or lacks one of these columns; the errors of
    /// [`Strokes::new`].
    pub fn open(path: &Path, runs: bool) -> Result<Self> {
        let Text {
            name, mut source, ..
        } = Text::of_file(path)?;
        let mut text = String::new();
        let read = source.read_to_string(&mut text);
        read.map_err(|error| unreadable_text(&name, &error))?;
        let refused = |fault: TableFault| Error::table(&name, fault.place, fault.reason);
        let mut table = NumberTable::new(&text, "distance [yd]").map_err(refused)?;
        let of_file = |reason: String| refused(TableFault::of_file(reason));
        let distances = column(&table.heads, "distance").map_err(of_file)?;
        let strokes = column(&table.heads, "strokes").map_err(of_file)?;
        let head = table.heads[distances].to_owned();
        let written = head
            .split_once('[')
            .and_then(|(_, rest)| rest.strip_suffix(']'));
        let unit = written.unwrap_or_default().trim();
        let Some(unit_size) = Quantity::LENGTH.size_of(unit) else {
            let reason = format!("the column head '{head}' names no unit of length; {COLUMNS}");
            return Err(of_file(reason));
        };
        let mut rows = vec![];
        while let Some(row) = table.next_row().map_err(refused)? {
            let distance = table.number(&row, distances).map_err(refused)?;
            let strokes = table.number(&row, strokes).map_err(refused)?;
            rows.push((distance * unit_size, strokes));
        }
        Self::new(&rows, unit, runs)
    }

    pub(in crate::study) fn reaches(&self, distance: f64) -> bool {
        self.distance[0] <= distance && distance <= self.distance[self.distance.len() - 1]
    }

    /// Expected strokes from a distance, with two derivatives.
    pub(super) fn at(&self, x: f64) -> [f64; 3] {
        let n = self.distance.len();
        let i = self.distance.partition_point(|d| *d <= x).clamp(1, n - 1) - 1;
        let (low, high) = (self.distance[i], self.distance[i + 1]);
        let width = high - low;
        let slope = (self.strokes[i + 1] - self.strokes[i]) / width;
        // linear beyond the ends, where the second derivative is 0
        let inside = x.clamp(low, high);
        let (a, b) = ((high - inside) / width, (inside - low) / width);
        let (p, q) = (self.second_derivatives[i], self.second_derivatives[i + 1]);
        let value = a * self.strokes[i]
            + b * self.strokes[i + 1]
            + ((a * a * a - a) * p + (b * b * b - b) * q) * width * width / 6.0;
        let first = slope + ((1.0 - 3.0 * a * a) * p + (3.0 * b * b - 1.0) * q) * width / 6.0;
        let second = if inside == x { a * p + b * q } else { 0.0 };
        [value + first * (x - inside), first, second]
    }

    /// Expected strokes from the final position of a drive, on a straight hole of length `hole`.
    /// The result has a Hessian if `is_second`. A missing Hessian of the position counts as 0.
    pub(super) fn from(
        &self,
        downrange: &Taylor,
        right: &Taylor,
        hole: f64,
        is_second: bool,
    ) -> Taylor {
        /// Distance, m, whose square is added to the squared distance to the hole. The square root
        /// of the sum is differentiable at the hole.
        const LEAST: f64 = 0.1;
        let (x, y) = (hole - downrange.value, right.value);
        let left = (x * x + y * y + LEAST * LEAST).sqrt();
        // derivatives of the distance by downrange and right
        let (by_x, by_y) = (-x / left, y / left);
        let [xx, xy, yy] = [
            (1.0 - by_x * by_x) / left,
            -by_x * by_y / left,
            (1.0 - by_y * by_y) / left,
        ];
        let (f, g) = (downrange, right);
        let second = |of: &Taylor, i: usize, j: usize| of.hessian.get(i).map_or(0.0, |row| row[j]);
        let n = if is_second { f.gradient.len() } else { 0 };
        let row = |i: usize| {
            let entry = |j: usize| {
                by_x * second(f, i, j)
                    + by_y * second(g, i, j)
                    + xx * f.gradient[i] * f.gradient[j]
                    + xy * (f.gradient[i] * g.gradient[j] + g.gradient[i] * f.gradient[j])
                    + yy * g.gradient[i] * g.gradient[j]
            };
            (0..n).map(entry).collect()
        };
        let distance = Taylor {
            value: left,
            gradient: f
                .gradient
                .iter()
                .zip(&g.gradient)
                .map(|(f, g)| by_x * f + by_y * g)
                .collect(),
            hessian: (0..n).map(row).collect(),
        };
        distance.chained(self.at(left))
    }
}

/// Columns that a table of strokes must have, for messages.
const COLUMNS: &str = "the table of strokes has the columns 'distance [yd]' (or another unit of \
                       length) and 'strokes'";

/// Index of the column with a name; its head may also have a unit.
///
/// # Errors
/// The reason: the column is missing or repeated.
fn column(heads: &StringRecord, wanted: &str) -> std::result::Result<usize, String> {
    let name = |head: &str| head.split('[').next().map(str::trim) == Some(wanted);
    let places: Vec<usize> = (0..heads.len()).filter(|at| name(&heads[*at])).collect();
    match places[..] {
        [at] => Ok(at),
        [] => {
            let heads: Vec<&str> = heads.iter().collect();
            Err(format!("its columns are {}; {COLUMNS}", heads.join(", ")))
        }
        _ => Err(format!("the column '{wanted}' is there twice; keep one")),
    }
}

/// The second derivatives of the natural cubic spline.
fn natural(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let (mut second_derivatives, mut left) = (vec![0.0; n], vec![0.0; n]);
    for i in 1..n - 1 {
        let part = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
        let pivot = part * second_derivatives[i - 1] + 2.0;
        second_derivatives[i] = (part - 1.0) / pivot;
        let change = (y[i + 1] - y[i]) / (x[i + 1] - x[i]) - (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
        left[i] = (6.0 * change / (x[i + 1] - x[i - 1]) - part * left[i - 1]) / pivot;
    }
    second_derivatives[n - 1] = 0.0;
    for i in (0..n - 1).rev() {
        second_derivatives[i] = second_derivatives[i] * second_derivatives[i + 1] + left[i];
    }
    second_derivatives
}

#[cfg(test)]
mod tests {
    use super::Strokes;
    use crate::number::Taylor;

    fn table() -> Strokes {
        // invented numbers, with the shape of published tables
        Strokes::new(
            &[
                (0.0, 1.0),
                (20.0, 2.4),
                (100.0, 2.8),
                (200.0, 3.19),
                (300.0, 3.71),
                (450.0, 4.4),
            ],
            "m",
            false,
        )
        .unwrap()
    }

    #[test]
    fn exact_c2_spline_through_its_table_and_linear_beyond() {
        let strokes = table();
        for (x, y) in [(0.0, 1.0), (100.0, 2.8), (450.0, 4.4)] {
            assert!((strokes.at(x)[0] - y).abs() < 1e-14);
        }
        for x in [20.0, 100.0, 200.0, 300.0, 450.0] {
            let (a, b) = (strokes.at(x - 1e-9), strokes.at(x + 1e-9));
            for k in 0..3 {
                assert!((a[k] - b[k]).abs() < 1e-8, "{x} {k}: {a:?} {b:?}");
            }
        }
        let [value, slope, curvature] = strokes.at(470.0);
        assert!(curvature == 0.0 && (value - (4.4 + 20.0 * slope)).abs() < 1e-12);
    }

    #[test]
    fn differences_certify_strokes_from_where_a_drive_ends() {
        let strokes = table();
        let at = |x: [f64; 2]| {
            // carry 250 + 30 x − x y, lateral 5 + 8 y + x²
            let f = Taylor {
                value: 250.0 + 30.0 * x[0] - x[0] * x[1],
                gradient: vec![30.0 - x[1], -x[0]],
                hessian: vec![vec![0.0, -1.0], vec![-1.0, 0.0]],
            };
            let g = Taylor {
                value: 5.0 + 8.0 * x[1] + x[0] * x[0],
                gradient: vec![2.0 * x[0], 8.0],
                hessian: vec![vec![2.0, 0.0], vec![0.0, 0.0]],
            };
            strokes.from(&f, &g, 400.0, true)
        };
        let here = at([0.3, -0.7]);
        let h = 1e-4;
        for i in 0..2 {
            let moved = |side: f64| {
                let mut x = [0.3, -0.7];
                x[i] += side * h;
                at(x)
            };
            let (a, b) = (moved(-1.0), moved(1.0));
            assert!(((b.value - a.value) / (2.0 * h) - here.gradient[i]).abs() < 1e-8);
            for j in 0..2 {
                assert!(
                    ((b.gradient[j] - a.gradient[j]) / (2.0 * h) - here.hessian[i][j]).abs() < 1e-7
                );
            }
        }
    }
}
