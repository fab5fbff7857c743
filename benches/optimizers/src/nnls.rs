//! Nonnegative least squares (Lawson & Hanson 1974); some unknowns may have any sign.

use nalgebra::{DMatrix, DVector};

/// Minimizes |A z − b| with zⱼ ≥ 0 for each j that is not `free`. It normalizes the columns of A
/// internally.
pub fn solve(a: &DMatrix<f64>, b: &DVector<f64>, free: &[bool]) -> DVector<f64> {
    let columns = a.ncols();
    let sizes: Vec<f64> = (0..columns).map(|j| a.column(j).norm()).collect();
    let size = |j: usize| if sizes[j] > 0.0 { sizes[j] } else { 1.0 };
    let unit = DMatrix::from_fn(a.nrows(), columns, |i, j| a[(i, j)] / size(j));
    let mut z = DVector::zeros(columns);
    let mut passive = free.to_vec();
    let mut refused = vec![false; columns];
    solve_passive(&unit, b, free, &mut passive, &mut z);
    for _ in 0..10 * (columns + 1) {
        let pull = unit.transpose() * (b - &unit * &z);
        let floor = 1e-14 * b.norm();
        let next = (0..columns)
            .filter(|&j| !passive[j] && !refused[j] && pull[j] > floor)
            .max_by(|&j, &k| pull[j].total_cmp(&pull[k]));
        let Some(next) = next else { break };
        let before = (b - &unit * &z).norm();
        let (kept, kept_passive) = (z.clone(), passive.clone());
        passive[next] = true;
        solve_passive(&unit, b, free, &mut passive, &mut z);
        if (b - &unit * &z).norm() < before {
            refused.fill(false);
        } else {
            // rounding: the column does not reduce the residual, although its gradient says so
            (z, passive) = (kept, kept_passive);
            refused[next] = true;
        }
    }
    DVector::from_fn(columns, |j, _| z[j] / size(j))
}

/// Solves least squares over the passive columns; the unknowns of the other columns are 0. If an
/// unknown that is not `free` would become negative, its column leaves the passive set.
fn solve_passive(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    free: &[bool],
    passive: &mut [bool],
    z: &mut DVector<f64>,
) {
    loop {
        let chosen: Vec<usize> = (0..passive.len()).filter(|&j| passive[j]).collect();
        if chosen.is_empty() {
            z.fill(0.0);
            return;
        }
        let svd = a.select_columns(&chosen).svd(true, true);
        let Ok(target) = svd.solve(b, 1e-13) else {
            return;
        };
        let turning = |k: usize| !free[chosen[k]] && target[k] < 0.0;
        let part = |k: usize| z[chosen[k]] / (z[chosen[k]] - target[k]);
        let first = (0..chosen.len())
            .filter(|&k| turning(k))
            .min_by(|&k, &l| part(k).total_cmp(&part(l)));
        let step = first.map_or(1.0, |k| part(k).clamp(0.0, 1.0));
        for (k, &j) in chosen.iter().enumerate() {
            z[j] += step * (target[k] - z[j]);
        }
        let Some(first) = first else { return };
        z[chosen[first]] = 0.0;
        passive[chosen[first]] = false;
    }
}
