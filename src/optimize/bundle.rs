//! Bundle: nearby points on the other sides of kinks of f. At a kink the quadratic model of one
//! side does not describe the other sides: steps fail, and the trust region shrinks to zero before
//! the search reaches the minimum along the kink. A trial point on another side therefore adds a
//! term to a piecewise model: the second-order expansion about this point. Each side adds at most
//! one term.

use super::qp::MaxTerm;
use super::scaling::{EvaluatedPoint, Scaling, largest_scaled, scaled_hessian};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Largest distance from the iterate to a point on another side, in units of the variables' scale.
/// Farther points are dropped.
const NEARBY: f64 = 0.05;
/// Largest distance from the iterate, in units of the variables' scale, at which the expansion of
/// another side is accurate. If the piecewise model predicts no reduction of f, farther sides are
/// dropped.
const CLOSE: f64 = 1e-4;

/// Points on the other sides of kinks near the iterate: the nearest known point of each side.
/// Sorted by distance, nearest first.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Bundle(Vec<EvaluatedPoint>);

impl Bundle {
    /// True if the dimensions fit `n` variables and `m` constraints.
    pub fn has_dimensions(&self, n: usize, m: usize) -> bool {
        self.0.iter().all(|point| point.has_dimensions(n, m))
    }

    /// Adds `candidate` if it lies on another side of a kink near `at`. Keeps only the nearest
    /// point of each side.
    pub fn update(
        &mut self,
        scaling: &Scaling,
        at: &EvaluatedPoint,
        candidate: Option<EvaluatedPoint>,
    ) {
        let is_side = |point: &EvaluatedPoint| {
            scaling.distance(point, at) <= NEARBY && are_sides_of_a_kink(scaling, at, point)
        };
        let mut points = std::mem::take(&mut self.0);
        points.retain(is_side);
        points.extend(candidate.filter(is_side));
        points.sort_by(|a, b| scaling.distance(a, at).total_cmp(&scaling.distance(b, at)));
        for point in points {
            if self
                .0
                .iter()
                .all(|side| are_sides_of_a_kink(scaling, side, &point))
            {
                self.0.push(point);
            }
        }
    }

    /// Removes the farthest side if it is not [close](CLOSE). Returns true if a side was removed.
    pub fn drop_farthest(&mut self, scaling: &Scaling, at: &EvaluatedPoint) -> bool {
        let too_far = self
            .0
            .last()
            .is_some_and(|farthest| scaling.distance(farthest, at) > CLOSE);
        if too_far {
            self.0.pop();
        }
        too_far
    }

    /// Terms of the piecewise model, in scaled variables. Each term is the second-order expansion
    /// of another side, expressed about the point `at`. Its value at `at` is at most f(at): where a
    /// kink stalls a search, f is the maximum of the sides, so a larger value would be an error of
    /// the expansion.
    pub fn max_terms(
        &self,
        scaling: &Scaling,
        at: &EvaluatedPoint,
        hessian: &DMatrix<f64>,
    ) -> Vec<MaxTerm> {
        if self.0.is_empty() {
            return vec![];
        }
        // use the smallest known curvature for all sides, because the rounded tip of a smoothed
        // kink has a large curvature that belongs to no side
        let mildest = |least: DMatrix<f64>, other: &EvaluatedPoint| {
            let other = scaled_hessian(&other.f.objective.hessian, &scaling.scale);
            if other.amax() < least.amax() {
                other
            } else {
                least
            }
        };
        let curvature = self.0.iter().fold(hessian.clone(), mildest);
        let max_term = |other: &EvaluatedPoint| {
            let displacement =
                DVector::from_fn(at.x.len(), |i, _| (at.x[i] - other.x[i]) / scaling.scale[i]);
            let slope = DVector::from_fn(at.x.len(), |i, _| {
                other.f.objective.gradient[i] * scaling.scale[i]
            });
            let change = &curvature * &displacement;
            let offset = other.f.objective.value - at.f.objective.value
                + slope.dot(&displacement)
                + 0.5 * change.dot(&displacement);
            MaxTerm {
                offset: offset.min(0.0),
                gradient: slope + change,
            }
        };
        self.0.iter().map(max_term).collect()
    }
}

/// True if two points lie on different sides of a kink: neither Hessian, nor their mean, explains
/// the change of the gradient between the points.
fn are_sides_of_a_kink(scaling: &Scaling, a: &EvaluatedPoint, b: &EvaluatedPoint) -> bool {
    let has_no_hessian = |p: &EvaluatedPoint| p.f.objective.hessian.is_empty();
    if has_no_hessian(a) || has_no_hessian(b) {
        // without Hessians a kink cannot be distinguished from curvature
        return false;
    }
    let jump = |i: usize| b.f.objective.gradient[i] - a.f.objective.gradient[i];
    let curvature = |at: &EvaluatedPoint, i: usize| -> f64 {
        let displacement = b.x.iter().zip(&a.x).map(|(to, from)| to - from);
        at.f.objective.hessian[i]
            .iter()
            .zip(displacement)
            .map(|(curvature, displacement)| curvature * displacement)
            .sum()
    };
    let n = a.x.len();
    let change = largest_scaled((0..n).map(jump), &scaling.scale);
    let is_unexplained = |here_part: f64, there_part: f64| {
        let rest = |i: usize| jump(i) - here_part * curvature(a, i) - there_part * curvature(b, i);
        largest_scaled((0..n).map(rest), &scaling.scale) > 0.5 * change
    };
    change > 1e-6 * scaling.size(a)
        && is_unexplained(1.0, 0.0)
        && is_unexplained(0.0, 1.0)
        && is_unexplained(0.5, 0.5)
}
