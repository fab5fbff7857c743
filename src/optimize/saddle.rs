//! The second-order test: a point where the gradient vanishes may be a saddle, or even a maximum.

use super::frame::{Frame, Point};
use super::model::lagrangian_hessian;
use nalgebra::{DMatrix, DVector};

/// Curvature below zero by less than this, in units of φ over the scale squared, is rounding.
const LEAST: f64 = 1e-8;
/// Multipliers below this, in units of φ over the scale, hold nothing.
const IDLE: f64 = 1e-8;

/// The direction of most negative curvature of the Lagrangian along what holds the point, with that curvature, in
/// scaled variables; `None` where there is none.
pub(super) fn downward(frame: &Frame, at: &Point, multipliers: &[f64]) -> Option<(DVector<f64>, f64)> {
    let hessian = lagrangian_hessian(frame, at, multipliers)?;
    let free = tangents(frame, at, multipliers);
    if free.ncols() == 0 {
        return None;
    }
    let reduced = (free.transpose() * hessian * &free).symmetric_eigen();
    let (least, curvature) = reduced.eigenvalues.argmin();
    (curvature < -LEAST * frame.size(at)).then(|| (free * reduced.eigenvectors.column(least), curvature))
}

/// An orthonormal basis, in scaled variables, of the moves that keep every active bound and constraint active.
pub(super) fn tangents(frame: &Frame, at: &Point, multipliers: &[f64]) -> DMatrix<f64> {
    let n = at.x.len();
    let size = frame.size(at);
    let slopes = frame.lagrangian_gradient(at, multipliers);
    let is_held = |i: usize| {
        let presses = (slopes[i] * frame.scale[i]).abs() > IDLE * size;
        frame.domain.variables.is_fixed(i) || frame.is_at_a_bound(at, i) && presses
    };
    let is_tight = |j: &usize| {
        let presses = (multipliers[*j] * frame.gamma[*j]).abs() > IDLE * size;
        presses || frame.domain.constraints.is_fixed(*j)
    };
    let free: Vec<usize> = (0..n).filter(|&i| !is_held(i)).collect();
    let tight: Vec<usize> = (0..at.f.constraints.len()).filter(is_tight).collect();
    let rows = DMatrix::from_fn(tight.len(), free.len(), |r, c| {
        at.f.constraints[tight[r]].gradient[free[c]] * frame.scale[free[c]] / frame.gamma[tight[r]]
    });
    // the null space of the rows: what is left of the whole after their span
    let gram = rows.transpose() * &rows;
    let across = gram.symmetric_eigen();
    let largest = across.eigenvalues.iter().fold(0.0_f64, |most, v| v.max(most));
    let kept: Vec<usize> =
        (0..free.len()).filter(|&k| across.eigenvalues[k] <= 1e-14 * largest.max(f64::MIN_POSITIVE)).collect();
    DMatrix::from_fn(n, kept.len(), |i, k| {
        free.iter().position(|&f| f == i).map_or(0.0, |row| across.eigenvectors[(row, kept[k])])
    })
}
