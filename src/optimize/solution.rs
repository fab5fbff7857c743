use super::domain::Domain;
use super::kink::Kink;
use super::model::lagrangian_hessian;
use super::scaling::{Point, Residual};
use super::sqp::Progress;
use super::state::{Effort, State};
use super::status::{Status, Verdict};
use serde::{Deserialize, Serialize};

/// What a search found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solution {
    /// How it ended.
    pub status: Status,
    /// The same in a sentence, with the numbers of the test that ended it.
    pub message: String,
    /// The point; a variable whose bound is active lies on it exactly.
    pub x: Vec<f64>,
    /// f there; `None` where the functions were never defined.
    pub value: Option<f64>,
    /// Gradient of f there.
    pub gradient: Vec<f64>,
    /// Hessian of the Lagrangian there; of f alone where there are no constraints. Empty for a
    /// problem that gives none.
    pub hessian: Vec<Vec<f64>>,
    /// Multipliers of the lower bounds, ≥ 0: what f would fall by per unit that the bound is
    /// lowered.
    pub lower_multipliers: Vec<f64>,
    /// Multipliers of the upper bounds, ≥ 0: what f would fall by per unit that the bound is
    /// raised.
    pub upper_multipliers: Vec<f64>,
    /// The constraints, in order.
    pub constraints: Vec<Constrained>,
    /// ∂cⱼ/∂xᵢ, a row for each constraint.
    pub jacobian: Vec<Vec<f64>>,
    /// The KKT residual, relative (see [`status`](super::status)): the largest of its parts.
    pub kkt_residual: f64,
    /// Its parts.
    pub residual: Residual,
    /// The corner that the search ended at, if it did.
    pub kink: Option<Kink>,
    /// Iterations taken.
    pub iterations: u64,
    /// Evaluations of the functions with their derivatives.
    pub evaluations: u64,
    /// What the iterations were made of.
    pub effort: Effort,
    /// Where the search began: the start, or, where f was not defined there, the best of some other
    /// points.
    pub begun_at: Vec<f64>,
    /// Why the functions were not defined at the start, if so.
    pub undefined_at_start: Option<String>,
}

/// A constraint at a solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Constrained {
    /// cⱼ.
    pub value: f64,
    /// What it is beyond its limits: above the upper > 0, below the lower < 0.
    pub violation: f64,
    /// λⱼ in ∇f + Σ λⱼ ∇cⱼ + … = 0: > 0 where the upper limit holds it, < 0 where the lower does, 0
    /// where none. What f would fall by per unit that the limit is raised.
    pub multiplier: f64,
}

impl Solution {
    /// Whether it has the shape of one over this domain.
    pub(super) fn is_of(&self, domain: &Domain) -> bool {
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

    /// What a search has found when it ends.
    pub(super) fn new(
        domain: &Domain,
        progress: Progress,
        start: Vec<f64>,
        iterations: u64,
    ) -> Self {
        let Progress {
            state: search,
            verdict,
            undefined_at_start,
            begun_at,
            kink,
            ..
        } = progress;
        let largest = search.as_ref().map(|search| search.residual.largest());
        let Verdict { status, message } =
            verdict.unwrap_or_else(|| Verdict::iteration_limit(iterations, largest));
        let Some(search) = search else {
            return Self::nowhere(domain, status, message, start, undefined_at_start);
        };
        let State {
            scaling,
            point: at,
            multipliers,
            residual,
            effort,
            ..
        } = search;
        let slopes = at.lagrangian_gradient(&multipliers).into_owned();
        let bounds = &domain.variables;
        let price = |i: usize, is_held: bool, outward: f64| {
            if is_held {
                (slopes[i] * outward).max(0.0)
            } else {
                0.0
            }
        };
        let n = at.x.len();
        let hessian = lagrangian_hessian(&scaling, &at, &multipliers).map_or(vec![], |scaled| {
            let entry = |i: usize, j: usize| scaled[(i, j)] / (scaling.scale[i] * scaling.scale[j]);
            (0..n)
                .map(|i| (0..n).map(|j| entry(i, j)).collect())
                .collect()
        });
        let constrained = |(j, multiplier): (usize, &f64)| {
            let value = at.f.constraints[j].value;
            Constrained {
                value,
                violation: domain.constraints.excess(j, value),
                multiplier: *multiplier,
            }
        };
        let constraints = multipliers.iter().enumerate().map(constrained).collect();
        let Point { x, f } = at;
        Self {
            status,
            message,
            value: Some(f.objective.value),
            lower_multipliers: (0..n)
                .map(|i| price(i, x[i] <= bounds.low[i], 1.0))
                .collect(),
            upper_multipliers: (0..n)
                .map(|i| price(i, x[i] >= bounds.high[i], -1.0))
                .collect(),
            // exact where it was not scaled there and back
            hessian: if constraints_are_idle(&multipliers) {
                f.objective.hessian
            } else {
                hessian
            },
            gradient: f.objective.gradient,
            constraints,
            jacobian: f
                .constraints
                .into_iter()
                .map(|constraint| constraint.gradient)
                .collect(),
            x,
            kkt_residual: residual.largest(),
            residual,
            kink,
            iterations,
            evaluations: effort.evaluations,
            effort,
            begun_at,
            undefined_at_start,
        }
    }

    /// The end of a search that was stopped before it began.
    pub(super) fn not_begun(domain: &Domain, start: Vec<f64>) -> Self {
        Self::nowhere(
            domain,
            Status::Interrupted,
            "stopped before it began".into(),
            start,
            None,
        )
    }

    fn nowhere(
        domain: &Domain,
        status: Status,
        message: String,
        x: Vec<f64>,
        why: Option<String>,
    ) -> Self {
        let n = domain.variables.dimension();
        let none = Residual {
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
            kkt_residual: f64::MAX,
            residual: none,
            kink: None,
            iterations: 0,
            evaluations: 0,
            effort: Effort::default(),
            begun_at: vec![],
            undefined_at_start: why,
            x,
        }
    }
}

fn constraints_are_idle(multipliers: &[f64]) -> bool {
    multipliers.iter().all(|multiplier| *multiplier == 0.0)
}

/// One iteration, as an observer sees it.
#[derive(Clone, Debug, Default)]
pub struct Iteration {
    /// 0 for the start.
    pub number: u64,
    /// f.
    pub value: f64,
    /// The point.
    pub x: Vec<f64>,
    /// The KKT residual, relative.
    pub kkt_residual: f64,
    /// The largest violation of a constraint, relative.
    pub violation: f64,
    /// The trust region's size for the next step, in units of the variables' scale.
    pub radius: f64,
    /// Whether the step was kept.
    pub kept: bool,
}
