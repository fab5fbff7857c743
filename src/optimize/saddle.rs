//! The second-order test: a point where the gradient vanishes may be a saddle, or even a maximum.

use super::model::lagrangian_hessian;
use super::null_space::free_moves;
use super::scaling::{Point, Scaling, norm};
use super::state::{Evaluate, State};
use nalgebra::{DMatrix, DVector};

/// Curvature below zero by less than this, in units of φ over the scale squared, is rounding.
const LEAST: f64 = 1e-8;
/// Multipliers below this, in units of φ over the scale, hold nothing.
const IDLE: f64 = 1e-8;

/// Saddles left before a search gives up on finding anything else.
const MOST_SADDLES: u32 = 20;

/// What is to be made smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Goal {
    /// The merit, along what holds the point.
    Merit,
    /// The constraints' violation.
    Feasibility,
}

impl State {
    /// Where the point is a saddle of what is to be made smaller, goes down from it; whether it
    /// did.
    pub fn leave_saddle(
        &mut self,
        goal: Goal,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        let Some((direction, curvature)) = self
            .downward(goal)
            .filter(|_| self.counters.saddles < MOST_SADDLES)
        else {
            return Ok(false);
        };
        self.counters.saddles += 1;
        let measure = |search: &Self, at: &Point| match goal {
            // along the tangents of what is active it is the Lagrangian that falls, and the merit
            // only once the constraints are met again
            Goal::Merit => search.lagrangian(at),
            Goal::Feasibility => 0.5 * norm(search.scaling.violations(&at.f)).powi(2),
        };
        let before = measure(self, &self.point);
        let mut reach = self.radius.clamp(1e-3, 0.25);
        for _ in 0..6 {
            let expected = -0.5 * curvature * reach * reach;
            let mut best: Option<(f64, Point)> = None;
            for sign in [1.0, -1.0] {
                let coordinate = |i: usize| {
                    self.point.x[i] + sign * reach * direction[i] * self.scaling.scale[i]
                };
                let moved: Vec<f64> = (0..self.point.x.len()).map(coordinate).collect();
                let x = self.scaling.domain.variables.project(&moved);
                self.effort.evaluations += 1;
                if let Ok(f) = evaluate(&x)? {
                    let point = Point { x, f };
                    let value = measure(self, &point);
                    if value
                        < best
                            .as_ref()
                            .map_or(before - 0.1 * expected, |(least, _)| *least)
                    {
                        best = Some((value, point));
                    }
                }
            }
            if let Some((_, best)) = best {
                self.move_to(best);
                self.radius = reach;
                self.residual = self.scaling.residual(&self.point, &self.multipliers);
                return Ok(true);
            }
            reach *= 0.1;
        }
        Ok(false)
    }

    /// The direction of most negative curvature, with that curvature, in scaled variables; `None`
    /// where there is none.
    fn downward(&self, goal: Goal) -> Option<(DVector<f64>, f64)> {
        let Self {
            scaling,
            point: at,
            multipliers,
            ..
        } = self;
        let (hessian, free, size) = match goal {
            Goal::Merit => {
                let hessian = lagrangian_hessian(scaling, at, multipliers)?;
                (
                    hessian,
                    tangents(scaling, at, multipliers),
                    scaling.size(at),
                )
            }
            Goal::Feasibility => {
                let bounds = &scaling.domain.variables;
                let free: Vec<usize> = (0..at.x.len()).filter(|&i| !bounds.is_fixed(i)).collect();
                let basis =
                    DMatrix::from_fn(at.x.len(), free.len(), |i, k| f64::from(free[k] == i));
                (violation_hessian(scaling, at)?, basis, 1.0)
            }
        };
        if free.ncols() == 0 {
            return None;
        }
        let reduced = (free.transpose() * hessian * &free).symmetric_eigen();
        let (least, curvature) = reduced.eigenvalues.argmin();
        (curvature < -LEAST * size).then(|| (free * reduced.eigenvectors.column(least), curvature))
    }
}

/// The Hessian of ½‖v‖² in scaled variables, if every constraint gives its own.
fn violation_hessian(scaling: &Scaling, at: &Point) -> Option<DMatrix<f64>> {
    let n = at.x.len();
    let mut sum = DMatrix::zeros(n, n);
    for (j, violation) in scaling
        .violations(&at.f)
        .enumerate()
        .filter(|(_, violation)| *violation != 0.0)
    {
        let (constraint, gamma) = (&at.f.constraints[j], scaling.gamma[j]);
        if constraint.hessian.is_empty() {
            return None;
        }
        sum += DMatrix::from_fn(n, n, |i, k| {
            let slopes = constraint.gradient[i] * constraint.gradient[k] / (gamma * gamma);
            let bend = violation * constraint.hessian[i][k] / gamma;
            (slopes + bend) * scaling.scale[i] * scaling.scale[k]
        });
    }
    Some(sum)
}

/// An orthonormal basis, in scaled variables, of the moves that keep every active bound and
/// constraint active.
pub(super) fn tangents(scaling: &Scaling, at: &Point, multipliers: &[f64]) -> DMatrix<f64> {
    let n = at.x.len();
    let (is_held, tight) = held(scaling, at, multipliers);
    let free: Vec<usize> = (0..n).filter(|&i| !is_held[i]).collect();
    let rows = DMatrix::from_fn(tight.len(), free.len(), |r, c| {
        at.f.constraints[tight[r]].gradient[free[c]] * scaling.scale[free[c]]
            / scaling.gamma[tight[r]]
    });
    free_moves(n, &free, &rows)
}

/// Whether a bound holds each variable, and which constraints are active: where a multiplier
/// presses, or there is no choice.
fn held(scaling: &Scaling, at: &Point, multipliers: &[f64]) -> (Vec<bool>, Vec<usize>) {
    let (size, slopes) = (scaling.size(at), at.lagrangian_gradient(multipliers));
    let is_held = |i: usize| {
        let presses = (slopes[i] * scaling.scale[i]).abs() > IDLE * size;
        scaling.domain.variables.is_fixed(i) || scaling.is_at_a_bound(at, i) && presses
    };
    let is_tight = |j: &usize| {
        let presses = (multipliers[*j] * scaling.gamma[*j]).abs() > IDLE * size;
        presses || scaling.domain.constraints.is_fixed(*j)
    };
    (
        (0..at.x.len()).map(is_held).collect(),
        (0..at.f.constraints.len()).filter(is_tight).collect(),
    )
}
