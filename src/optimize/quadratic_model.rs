//! The quadratic model at an iterate, for observers of a search.

use super::model::write_lagrangian_hessian;
use super::state::SearchState;
use nalgebra::DMatrix;

/// Quadratic model of the Lagrangian at an iterate x, with the trial step of the next iteration.
/// The model is
///
/// ```text
///   m(d) = f + ∇f·d + ½ dᵀH d,   low ≤ x + d ≤ high
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuadraticModel {
    /// Gradient ∇f of the objective.
    pub gradient: Vec<f64>,
    /// Hessian H of the Lagrangian (of f if there are no constraints); empty if the problem has no
    /// Hessians.
    pub hessian: Vec<Vec<f64>>,
    /// Lower limits of x + d, from the trust region and the bounds.
    pub low: Vec<f64>,
    /// Upper limits of x + d, from the trust region and the bounds.
    pub high: Vec<f64>,
    /// Trial point x + d of the next iteration, before any second-order correction.
    pub trial: Vec<f64>,
    /// True if the negative eigenvalues of H were reflected for this step, because H is not
    /// positive definite on the tangents of the active constraints. The trial point then need not
    /// minimize m.
    pub is_reflected: bool,
}

impl QuadraticModel {
    /// The model with which the next iteration begins.
    pub(super) fn of(state: &SearchState) -> Self {
        let SearchState {
            scaling,
            point,
            radius,
            ..
        } = state;
        let bounds = &scaling.domain.variables;
        let end = |i: usize, sign: f64| {
            let end = point.x[i] + sign * radius * scaling.scale[i];
            end.clamp(bounds.low[i], bounds.high[i])
        };
        let n = point.x.len();
        let step = state.clone().trial_step();
        Self {
            gradient: point.f.objective.gradient.clone(),
            hessian: unscaled_hessian(state),
            low: (0..n).map(|i| end(i, -1.0)).collect(),
            high: (0..n).map(|i| end(i, 1.0)).collect(),
            trial: step.x,
            is_reflected: step.is_reflected,
        }
    }
}

/// Hessian of the Lagrangian in the problem's own units; empty if the problem has no Hessians.
pub(super) fn unscaled_hessian(state: &SearchState) -> Vec<Vec<f64>> {
    let mut sum = DMatrix::default();
    if write_lagrangian_hessian(&state.point, &state.multipliers, &mut sum).is_none() {
        return vec![];
    }
    let columns = sum.column_iter();
    columns
        .map(|column| column.iter().copied().collect())
        .collect()
}
