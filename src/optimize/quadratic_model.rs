//! The quadratic model at an iterate, for observers of a search.

use super::model::lagrangian_hessian;
use super::state::SearchState;

/// Quadratic model of the Lagrangian at an iterate x, and the trial step that follows from it:
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
    /// Lower ends of the trust region, within the bounds.
    pub low: Vec<f64>,
    /// Upper ends of the trust region, within the bounds.
    pub high: Vec<f64>,
    /// Trial point x + d of the next iteration, before any second-order correction.
    pub trial: Vec<f64>,
    /// True if the step uses H with its negative eigenvalues reflected, since H is not positive
    /// definite on the active set. The trial point then need not minimise m.
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
    let SearchState {
        scaling,
        point,
        multipliers,
        ..
    } = state;
    // return the objective's Hessian itself: scaling and unscaling would round it
    if multipliers.iter().all(|multiplier| *multiplier == 0.0) {
        return point.f.objective.hessian.clone();
    }
    let Some(scaled) = lagrangian_hessian(scaling, point, multipliers) else {
        return vec![];
    };
    let n = point.x.len();
    let entry = |i: usize, j: usize| scaled[(i, j)] / (scaling.scale[i] * scaling.scale[j]);
    (0..n)
        .map(|i| (0..n).map(|j| entry(i, j)).collect())
        .collect()
}
