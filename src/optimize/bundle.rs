//! The other sides of corners. Where a function has a corner, the quadratic model of one side
//! promises what the other does not keep: steps fail, and the trust region shrinks to nothing far
//! from the lowest point of the corner's edge. So a point met on another side is remembered, and
//! its side becomes a piece of the model (a bundle of at most one piece for each side, carried by
//! second-order expansions).

use super::qp::MaxTerm;
use super::scaling::{Point, Scaling};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Points farther than this, in units of the scale, tell nothing of a side here.
const NEARBY: f64 = 0.05;
/// Points of another side are trusted to rule out further progress only within this distance.
const CLOSE: f64 = 1e-4;

/// What a search knows of the other sides of corners: the nearest known point of each, nearest
/// first.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Bundle(Vec<Point>);

impl Bundle {
    /// Whether its points are of `n` variables, with `m` constraints.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        self.0.iter().all(|point| point.is_of(n, m))
    }

    /// Keeps, of the points known around `at`, the nearest of each other side of a corner nearby.
    pub fn update(&mut self, scaling: &Scaling, at: &Point, candidate: Option<Point>) {
        let is_side = |point: &Point| {
            scaling.distance(point, at) <= NEARBY && are_sides_of_a_corner(scaling, at, point)
        };
        let mut known = std::mem::take(&mut self.0);
        known.retain(is_side);
        known.extend(candidate.filter(is_side));
        known.sort_by(|a, b| scaling.distance(a, at).total_cmp(&scaling.distance(b, at)));
        for point in known {
            if self
                .0
                .iter()
                .all(|side| are_sides_of_a_corner(scaling, side, &point))
            {
                self.0.push(point);
            }
        }
    }

    /// Forgets the farthest side, if it is too far to be trusted.
    pub fn forget_one_too_far(&mut self, scaling: &Scaling, at: &Point) -> bool {
        let too_far = self
            .0
            .last()
            .is_some_and(|farthest| scaling.distance(farthest, at) > CLOSE);
        if too_far {
            self.0.pop();
        }
        too_far
    }

    /// Each other side's function around `at`, in scaled variables: carried here by its
    /// second-order expansion, and at most f, for at a corner that holds a search f is the largest
    /// of its sides.
    pub fn max_terms(&self, scaling: &Scaling, at: &Point, hessian: &DMatrix<f64>) -> Vec<MaxTerm> {
        if self.0.is_empty() {
            return vec![];
        }
        // the sides' curvature is the mildest known: in the rounded tip of a smoothed corner it is
        // that of no side
        let mildest = |least: DMatrix<f64>, other: &Point| {
            let other = scaled_hessian(scaling, other);
            if other.amax() < least.amax() {
                other
            } else {
                least
            }
        };
        let curvature = self.0.iter().fold(hessian.clone(), mildest);
        let max_term = |other: &Point| {
            let way =
                DVector::from_fn(at.x.len(), |i, _| (at.x[i] - other.x[i]) / scaling.scale[i]);
            let (slope, bend) = (scaled_gradient(scaling, other), &curvature * &way);
            let offset = other.f.objective.value - at.f.objective.value
                + slope.dot(&way)
                + 0.5 * bend.dot(&way);
            MaxTerm {
                offset: offset.min(0.0),
                gradient: slope + bend,
            }
        };
        self.0.iter().map(max_term).collect()
    }
}

/// Whether two points lie on different sides of a corner: the gradient changes between them, and
/// neither Hessian accounts for it.
fn are_sides_of_a_corner(scaling: &Scaling, a: &Point, b: &Point) -> bool {
    let is_plain = |p: &Point| p.f.objective.hessian.is_empty();
    if is_plain(a) || is_plain(b) {
        // without second derivatives a corner cannot be told from a bend
        return false;
    }
    let jump = |i: usize| b.f.objective.gradient[i] - a.f.objective.gradient[i];
    let bend = |at: &Point, i: usize| -> f64 {
        let way = b.x.iter().zip(&a.x).map(|(to, from)| to - from);
        at.f.objective.hessian[i]
            .iter()
            .zip(way)
            .map(|(bend, way)| bend * way)
            .sum()
    };
    let n = a.x.len();
    let change = scaling.largest((0..n).map(jump));
    let is_unexplained = |here_part: f64, there_part: f64| {
        let rest = |i: usize| jump(i) - here_part * bend(a, i) - there_part * bend(b, i);
        scaling.largest((0..n).map(rest)) > 0.5 * change
    };
    change > 1e-6 * scaling.size(a)
        && is_unexplained(1.0, 0.0)
        && is_unexplained(0.0, 1.0)
        && is_unexplained(0.5, 0.5)
}

pub(super) fn scaled_gradient(scaling: &Scaling, at: &Point) -> DVector<f64> {
    DVector::from_fn(at.x.len(), |i, _| {
        at.f.objective.gradient[i] * scaling.scale[i]
    })
}

pub(super) fn scaled_hessian(scaling: &Scaling, at: &Point) -> DMatrix<f64> {
    let n = at.x.len();
    DMatrix::from_fn(n, n, |i, j| {
        at.f.objective.hessian[i][j] * scaling.scale[i] * scaling.scale[j]
    })
}
