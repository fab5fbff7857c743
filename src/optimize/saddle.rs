//! Second-order test of stationary points: saddle points and maxima, unlike minima, have directions
//! of negative curvature.

use super::model::write_lagrangian_hessian;
use super::null_space::tangent_basis;
use super::scaling::{EvaluatedPoint, Scaling, ZERO_MULTIPLIER, norm};
use super::state::{Evaluate, SearchState};
use nalgebra::{DMatrix, DVector};

/// Threshold for negative curvature in scaled variables, relative to the objective's size. Weaker
/// negative curvature counts as rounding.
const CURVATURE_ROUNDING: f64 = 1e-8;

/// Maximum number of attempts of a search to leave a saddle point.
const MOST_SADDLES: u32 = 20;

/// Function that a step along a direction of negative curvature must reduce.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReducedFunction {
    /// The merit function, along the tangents of the active constraints.
    Merit,
    /// The violation of the constraints.
    Feasibility,
}

impl SearchState {
    /// Leaves a saddle point along the direction of most negative curvature. Returns true if it
    /// found a lower point and moved there.
    pub fn leave_saddle(
        &mut self,
        reduced: ReducedFunction,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<bool, argmin::core::Error> {
        let Some((direction, curvature)) = self
            .negative_curvature(reduced)
            .filter(|_| self.counters.saddles < MOST_SADDLES)
        else {
            return Ok(false);
        };
        self.counters.saddles += 1;
        let measure = |search: &Self, at: &EvaluatedPoint| match reduced {
            // compare the Lagrangian, which falls along the tangents: the merit function falls only
            // after a further step back onto the constraints
            ReducedFunction::Merit => search.lagrangian(at),
            ReducedFunction::Feasibility => 0.5 * norm(search.scaling.violations(&at.f)).powi(2),
        };
        let before = measure(self, &self.point);
        let mut length = self.radius.clamp(1e-3, 0.25);
        for _ in 0..6 {
            let expected = -0.5 * curvature * length * length;
            let mut best: Option<(f64, EvaluatedPoint)> = None;
            for sign in [1.0, -1.0] {
                let coordinate = |i: usize| {
                    self.point.x[i] + sign * length * direction[i] * self.scaling.scale[i]
                };
                let moved: Vec<f64> = (0..self.point.x.len()).map(coordinate).collect();
                let x = self.scaling.domain.variables.project(&moved);
                self.effort.evaluations += 1;
                if let Ok(f) = evaluate(&x)? {
                    let point = EvaluatedPoint { x, f };
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
                self.radius = length;
                self.residual = self.scaling.residual(&self.point, &self.multipliers);
                return Ok(true);
            }
            length *= 0.1;
        }
        Ok(false)
    }

    /// Direction of most negative curvature, in scaled variables, with its curvature; `None` if no
    /// curvature is negative, or if a function has no Hessian.
    fn negative_curvature(&self, reduced: ReducedFunction) -> Option<(DVector<f64>, f64)> {
        let Self {
            scaling,
            point: at,
            multipliers,
            ..
        } = self;
        let (hessian, free, size) = match reduced {
            ReducedFunction::Merit => {
                let mut hessian = DMatrix::default();
                write_lagrangian_hessian(at, multipliers, &mut hessian)?;
                scaling.scale_hessian(&mut hessian);
                (
                    hessian,
                    tangents(scaling, at, multipliers),
                    scaling.size(at),
                )
            }
            ReducedFunction::Feasibility => {
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
        (curvature < -CURVATURE_ROUNDING * size)
            .then(|| (free * reduced.eigenvectors.column(least), curvature))
    }
}

/// Hessian of ½‖v‖² in scaled variables, with the constraint violations v; `None` if a violated
/// constraint has no Hessian.
fn violation_hessian(scaling: &Scaling, at: &EvaluatedPoint) -> Option<DMatrix<f64>> {
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
            let gauss_newton = constraint.gradient[i] * constraint.gradient[k] / (gamma * gamma);
            let curvature = violation * constraint.hessian[i][k] / gamma;
            (gauss_newton + curvature) * scaling.scale[i] * scaling.scale[k]
        });
    }
    Some(sum)
}

/// Orthonormal basis, in scaled variables, of the tangents of the active bounds and constraints.
/// Fixed variables and equality constraints are active, and so are bounds and limits with a
/// multiplier above rounding.
fn tangents(scaling: &Scaling, at: &EvaluatedPoint, multipliers: &[f64]) -> DMatrix<f64> {
    let least_multiplier = ZERO_MULTIPLIER * scaling.size(at);
    let gradient = at.lagrangian_gradient(multipliers);
    let is_free = |i: &usize| {
        let has_multiplier = (gradient[*i] * scaling.scale[*i]).abs() > least_multiplier;
        let is_active = scaling.is_at_a_bound(at, *i) && has_multiplier;
        !(scaling.domain.variables.is_fixed(*i) || is_active)
    };
    let is_active_row = |j: &usize| {
        let has_multiplier = (multipliers[*j] * scaling.gamma[*j]).abs() > least_multiplier;
        has_multiplier || scaling.domain.constraints.is_fixed(*j)
    };
    let n = at.x.len();
    let free: Vec<usize> = (0..n).filter(is_free).collect();
    let normals: Vec<DVector<f64>> = (0..at.f.constraints.len())
        .filter(is_active_row)
        .map(|j| DVector::from_iterator(n, scaling.normal(at, j)))
        .collect();
    let rows = DMatrix::from_fn(normals.len(), free.len(), |r, c| normals[r][free[c]]);
    tangent_basis(n, &free, rows)
}
