//! The direction of most negative curvature, found by the signs of LDLᵀ's pivots, without eigenvalues of a dense matrix.

use super::kkt::Kkt;
use super::model::{lagrangian_hessian, violation_bend};
use super::symmetric::Symmetric;
use crate::optimize::known::SparseDerivatives;
use crate::optimize::scaling::{Point, Scaling};
use nalgebra::DVector;

/// Halvings of the interval that the most negative curvature lies in.
const HALVINGS: u32 = 12;
/// Steps of inverse iteration: each multiplies the error by less than about 2⁻¹², the width of that interval.
const STEPS: u32 = 8;

/// The direction of most negative curvature of the Lagrangian along what is active, with that curvature, in scaled variables; `None` where
/// none is below −least.
pub(in crate::optimize) fn of_lagrangian(
    scaling: &Scaling,
    at: &Point,
    derivatives: &SparseDerivatives,
    multipliers: &[f64],
    is_held: impl Fn(usize) -> bool,
    tight: &[usize],
    least: f64,
) -> Option<(DVector<f64>, f64)> {
    let hessian = lagrangian_hessian(scaling, derivatives, multipliers);
    let free: Vec<usize> = (0..at.x.len()).filter(|&i| !is_held(i)).collect();
    downward(scaling, derivatives, &hessian, &free, tight, 0.0, least)
}

/// As [`of_lagrangian`], of ½‖v‖².
pub(in crate::optimize) fn of_violation(
    scaling: &Scaling,
    at: &Point,
    derivatives: &SparseDerivatives,
    least: f64,
) -> Option<(DVector<f64>, f64)> {
    let violations: Vec<f64> = scaling.violations(&at.f).collect();
    let violated: Vec<usize> = (0..violations.len()).filter(|&j| violations[j] != 0.0).collect();
    let bend = violation_bend(scaling, derivatives, &violations);
    let free: Vec<usize> = (0..at.x.len()).filter(|&i| !scaling.domain.variables.is_fixed(i)).collect();
    downward(scaling, derivatives, &bend, &free, &violated, 1.0, least)
}

/// Of the free variables' block of H, in the directions that the rows N leave free (compliance 0) or of H + NᵀN (compliance 1).
fn downward(
    scaling: &Scaling,
    derivatives: &SparseDerivatives,
    hessian: &Symmetric,
    free: &[usize],
    rows: &[usize],
    compliance: f64,
    least: f64,
) -> Option<(DVector<f64>, f64)> {
    let (n, f) = (hessian.size(), free.len());
    let mut place = vec![None; n];
    free.iter().enumerate().for_each(|(at, &i)| place[i] = Some(at));
    let mut entries: Vec<_> = hessian.entries().filter_map(|(i, j, bend)| Some((place[i]?, place[j]?, bend))).collect();
    for (at, &j) in rows.iter().enumerate() {
        let slopes = derivatives.constraints[j].gradient.iter();
        let normal = slopes.map(|(i, slope)| (*i, slope * scaling.scale[*i] / scaling.gamma[j]));
        entries.extend(normal.filter_map(|(i, a)| Some((place[i]?, f + at, a))));
        entries.push((f + at, f + at, -compliance));
    }
    let shifted = |by: f64| {
        let all = entries.iter().copied().chain((0..f).map(|i| (i, i, by)));
        Kkt::new(f, &Symmetric::sum(f + rows.len(), all))
    };
    let is_convex = |by: f64| shifted(by).is_none_or(|kkt| kkt.is_convex());
    if f == 0 || is_convex(least) {
        return None;
    }
    // the most negative curvature lies between −below and −above
    let (mut above, mut below) = (least, (2.0 * least).max(1e-3 * hessian.largest()));
    while !is_convex(below) {
        (above, below) = (below, 2.0 * below);
        if !below.is_finite() {
            return None;
        }
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (above + below);
        if is_convex(middle) { below = middle } else { above = middle }
    }
    let mut kkt = shifted(below)?;
    // no pattern of the problem is likely to be normal to multiples of the golden ratio
    let mut direction: Vec<f64> = (0..f).map(|i| (i as f64 * 0.618_033_988_749_894_9).fract() - 0.5).collect();
    for _ in 0..STEPS {
        let mut right = direction;
        right.resize(f + rows.len(), 0.0);
        // the matrix is nearly singular: its solution is long, and only the direction counts
        direction = kkt.refined(&right).0;
        direction.truncate(f);
        let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        if length == 0.0 {
            return None;
        }
        direction.iter_mut().for_each(|d| *d /= length);
    }
    let mut whole = DVector::zeros(n);
    free.iter().zip(&direction).for_each(|(&i, d)| whole[i] = *d);
    // (H + NᵀN) where the rows comply
    let pulls = rows.iter().map(|&j| {
        let slopes = derivatives.constraints[j].gradient.iter();
        slopes.map(|(i, slope)| slope * scaling.scale[*i] / scaling.gamma[j] * whole[*i]).sum::<f64>().powi(2)
    });
    let curvature = hessian.quadratic_form(&whole) + compliance * pulls.sum::<f64>();
    (curvature < -least).then_some((whole, curvature))
}
