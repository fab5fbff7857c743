use super::domain::{Bounds, Domain};
use super::kink::Kink;
use super::quadratic_model::unscaled_hessian;
use super::scaling::{
    EvaluatedPoint, KktResidual, ZERO_MULTIPLIER, largest_scaled, objective_size,
};
use super::sqp::SearchProgress;
use super::state::{Effort, SearchState};
use super::status::{SearchVerdict, Status};
use serde::{Deserialize, Serialize};

/// Result of a search. If the functions were never defined, `value` is `None`, and the KKT
/// residuals are `f64::MAX`; the derivatives, `constraints` and `initial_point` are empty.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solution {
    /// Outcome of the search.
    pub status: Status,
    /// Outcome in a sentence, with the numbers of the stopping test.
    pub message: String,
    /// Final point. A variable with an active bound equals the bound exactly.
    pub x: Vec<f64>,
    /// Objective f at the point; `None` if the functions were never defined.
    pub value: Option<f64>,
    /// Gradient of f at the point.
    pub gradient: Vec<f64>,
    /// Hessian of the Lagrangian at the point (of f if there are no constraints); empty if the
    /// problem has no Hessians.
    pub hessian: Vec<Vec<f64>>,
    /// Multiplier of each lower bound, ≥ 0. If the bound falls by δ, f falls by the multiplier
    /// times δ, to first order. A multiplier within rounding is 0.
    pub lower_multipliers: Vec<f64>,
    /// Multiplier of each upper bound, ≥ 0. If the bound rises by δ, f falls by the multiplier
    /// times δ, to first order. A multiplier within rounding is 0.
    pub upper_multipliers: Vec<f64>,
    /// The constraints, in order.
    pub constraints: Vec<ConstraintValue>,
    /// Jacobian ∂cⱼ/∂xᵢ, a row for each constraint.
    pub jacobian: Vec<Vec<f64>>,
    /// Components of the KKT residual (see [`status`](super::status)).
    pub residual: KktResidual,
    /// Kink of f at the point, if the search ended at a kink.
    pub kink: Option<Kink>,
    /// Iterations taken.
    pub iterations: u64,
    /// Work counters.
    pub effort: Effort,
    /// First iterate: the start, or the best of several other points if f is undefined at the
    /// start.
    pub initial_point: Vec<f64>,
    /// Reason why the functions are undefined at the start; `None` if they are defined.
    pub undefined_at_start: Option<String>,
}

/// A constraint at a solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConstraintValue {
    /// Value cⱼ.
    pub value: f64,
    /// Signed violation: > 0 above the upper limit, < 0 below the lower limit.
    pub violation: f64,
    /// Multiplier λⱼ in ∇f + Σ λⱼ ∇cⱼ + … = 0: > 0 at the upper limit, < 0 at the lower limit, 0
    /// between the limits. If the limit rises by δ, f falls by λⱼ δ, to first order. The multiplier
    /// of an inequality is 0 if it is within rounding.
    pub multiplier: f64,
}

impl Solution {
    /// True if the dimensions fit this domain.
    pub(super) fn fits(&self, domain: &Domain) -> bool {
        let (n, m) = (domain.variables.dimension(), domain.constraints.dimension());
        let is_matrix = |rows: &[Vec<f64>], count: usize| {
            rows.is_empty() || rows.len() == count && rows.iter().all(|row| row.len() == n)
        };
        let has_value = self.value.is_some();
        let per_variable = [
            self.x.len(),
            self.lower_multipliers.len(),
            self.upper_multipliers.len(),
        ];
        let of_value = self.gradient.len() == n && self.constraints.len() == m;
        per_variable == [n; 3]
            && (!has_value || of_value)
            && is_matrix(&self.hessian, n)
            && is_matrix(&self.jacobian, m)
    }

    /// Result of a search that has ended.
    pub(super) fn new(
        domain: &Domain,
        progress: SearchProgress,
        start: Vec<f64>,
        iterations: u64,
    ) -> Self {
        let SearchProgress {
            state: search,
            verdict,
            undefined_at_start,
            initial_point,
            kink,
            undefined_evaluations,
            ..
        } = progress;
        let largest = search.as_ref().map(|search| search.residual.largest());
        let SearchVerdict { status, message } =
            verdict.unwrap_or_else(|| SearchVerdict::iteration_limit(iterations, largest));
        let Some(mut search) = search else {
            return Self {
                effort: Effort {
                    evaluations: undefined_evaluations,
                    ..Effort::default()
                },
                undefined_at_start,
                ..Self::without_point(domain, status, message, start)
            };
        };
        let bounds = &domain.variables;
        let scale = bounds.scale(&search.point.x);
        drop_rounding_multipliers(&mut search, &domain.constraints, &scale);
        let lower_multipliers = bound_multipliers(&search, &scale, 1.0, |i, x| x <= bounds.low[i]);
        let upper_multipliers =
            bound_multipliers(&search, &scale, -1.0, |i, x| x >= bounds.high[i]);
        let constraints = constraint_values(&search, &domain.constraints);
        let hessian = unscaled_hessian(&search);
        let SearchState {
            point,
            residual,
            effort,
            ..
        } = search;
        let EvaluatedPoint { x, f } = point;
        Self {
            status,
            message,
            value: Some(f.objective.value),
            lower_multipliers,
            upper_multipliers,
            hessian,
            gradient: f.objective.gradient,
            constraints,
            jacobian: f
                .constraints
                .into_iter()
                .map(|constraint| constraint.gradient)
                .collect(),
            x,
            residual,
            kink,
            iterations,
            effort,
            initial_point,
            undefined_at_start,
        }
    }

    /// Result of a search that found no point at which the functions are defined.
    pub(super) fn without_point(
        domain: &Domain,
        status: Status,
        message: String,
        x: Vec<f64>,
    ) -> Self {
        let n = domain.variables.dimension();
        let none = KktResidual {
            stationarity: f64::MAX,
            feasibility: f64::MAX,
            complementarity: f64::MAX,
        };
        Self {
            status,
            message,
            value: None,
            gradient: vec![],
            hessian: vec![],
            lower_multipliers: vec![0.0; n],
            upper_multipliers: vec![0.0; n],
            constraints: vec![],
            jacobian: vec![],
            residual: none,
            kink: None,
            iterations: 0,
            effort: Effort::default(),
            initial_point: vec![],
            undefined_at_start: None,
            x,
        }
    }
}

/// The largest scaled multiplier that counts as rounding.
fn rounding_of_multipliers(search: &SearchState, scale: &[f64]) -> f64 {
    let objective = &search.point.f.objective;
    ZERO_MULTIPLIER * objective_size(objective.value, &objective.gradient, scale)
}

/// Sets multipliers of inequalities within rounding to 0. A nonzero multiplier would make the
/// constraint active, and would add its curvature to the Hessian of the Lagrangian.
fn drop_rounding_multipliers(search: &mut SearchState, limits: &Bounds, scale: &[f64]) {
    let rounding = rounding_of_multipliers(search, scale);
    let constraints = search.point.f.constraints.iter().enumerate();
    for ((j, constraint), multiplier) in constraints.zip(&mut search.multipliers) {
        let scaled = multiplier.abs() * largest_scaled(&constraint.gradient, scale);
        if scaled <= rounding && !limits.is_fixed(j) {
            *multiplier = 0.0;
        }
    }
}

/// Multipliers of the active bounds on one side, from the components of the Lagrangian's gradient.
/// `inward` is 1 for lower bounds and −1 for upper bounds. Multipliers within rounding are 0.
fn bound_multipliers(
    search: &SearchState,
    scale: &[f64],
    inward: f64,
    is_active: impl Fn(usize, f64) -> bool,
) -> Vec<f64> {
    let rounding = rounding_of_multipliers(search, scale);
    let gradient = search.point.lagrangian_gradient(&search.multipliers);
    let x = search.point.x.iter().copied().enumerate();
    x.map(|(i, x)| {
        let multiplier = inward * gradient[i];
        if is_active(i, x) && multiplier * scale[i] > rounding {
            multiplier
        } else {
            0.0
        }
    })
    .collect()
}

fn constraint_values(search: &SearchState, limits: &Bounds) -> Vec<ConstraintValue> {
    let constraint_value = |(j, multiplier): (usize, &f64)| {
        let value = search.point.f.constraints[j].value;
        ConstraintValue {
            value,
            violation: limits.excess(j, value),
            multiplier: *multiplier,
        }
    };
    search
        .multipliers
        .iter()
        .enumerate()
        .map(constraint_value)
        .collect()
}
