//! State of an SQP search between two iterations (iterate, multipliers, trust region, penalty), and
//! the operations of one iteration.

use super::bundle::Bundle;
use super::model::{LagrangianModel, Workspace, write_lagrangian_hessian};
use super::problem::Evaluation;
use super::qp::{QpSolver, StepSource};
use super::quasi_newton::QuasiNewton;
use super::scaling::{EvaluatedPoint, KktResidual, Scaling, norm};
use super::trial_step::{NOISE, Reduction, Trial, TrialStep};
use serde::{Deserialize, Serialize};
use std::ops::AddAssign;

/// Maximum number of second-order corrections of one step.
const MAX_CORRECTIONS: u32 = 3;
/// Largest trust-region radius, in units of the variables' scale.
const MAX_RADIUS: f64 = 1e16;
/// Radius of the trust region after a poor step, as a fraction of the step length.
const SHRINK: f64 = 0.25;
/// Growth factor of the trust-region radius after a good step that ends on the boundary of the
/// trust region (Conn, Gould & Toint 2000, §17.1).
const GROW: f64 = 2.0;
/// Smallest factor of a reflection (see [`SearchState::reflection`]).
const MIN_REFLECTION: f64 = 1e-12;
/// Threshold for predicted reductions, relative to the objective's size. Smaller reductions are
/// negligible.
const NEGLIGIBLE: f64 = 1e-13;
/// The constant ρ of Nocedal & Wright (2006), eq. 18.36: the predicted reduction of the merit
/// function is at least ρ ν times the predicted reduction of the violation.
const PENALTY_RHO: f64 = 0.1;
/// Ratio of a raised penalty to the penalty that the step needs, so that the next step does not
/// raise it again.
const PENALTY_MARGIN: f64 = 1.5;

/// Work counters of a search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Effort {
    /// Number of evaluations of the functions with their derivatives.
    pub evaluations: u64,
    /// Quadratic programs solved from the previous active set: one linear system each.
    pub warm_starts: u64,
    /// Number of quadratic programs solved by Clarabel, then polished to an exact KKT point of the
    /// active set.
    pub clarabel: u64,
    /// Number of quadratic programs for which polishing failed. The step is then the exact point of
    /// Clarabel's active set with Clarabel's multipliers, or Clarabel's own solution.
    pub unpolished: u64,
    /// Quadratic programs with inconsistent linearized constraints, which were relaxed.
    pub relaxed: u64,
    /// Second-order corrections computed.
    pub corrections: u64,
}

impl AddAssign for Effort {
    fn add_assign(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.warm_starts += other.warm_starts;
        self.clarabel += other.clarabel;
        self.unpolished += other.unpolished;
        self.relaxed += other.relaxed;
        self.corrections += other.corrections;
    }
}

/// State of a search.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct SearchState {
    pub scaling: Scaling,
    /// Iterate x with f, c and their derivatives.
    pub point: EvaluatedPoint,
    /// Multipliers λ of the constraints.
    pub multipliers: Vec<f64>,
    /// Trust-region radius Δ, in units of the variables' scale.
    pub radius: f64,
    /// Factor of a reflection: a negative eigenvalue λ of the Hessian is replaced by this factor
    /// times |λ|.
    pub reflection: f64,
    /// Penalty ν of the merit function f + ν‖v‖₂.
    pub penalty: f64,
    /// KKT residual at the iterate.
    pub residual: KktResidual,
    /// Points on the other sides of nearby kinks of f.
    pub kink_sides: Bundle,
    /// Quasi-Newton Hessian of the Lagrangian, for problems without Hessians.
    quasi_newton: Option<QuasiNewton>,
    /// Solver of the quadratic programs, warm-started from the previous active set.
    solver: QpSolver,
    pub counters: Counters,
    pub effort: Effort,
    /// Last reason why the functions were undefined at a trial point; `None` if they never were.
    pub undefined_reason: Option<String>,
    #[serde(skip)]
    workspace: Workspace,
}

/// Counters of operations that a search repeats only a limited number of times.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct Counters {
    /// Consecutive iterations without progress.
    pub stalled: u32,
    /// Attempts to leave a saddle point along negative curvature.
    pub saddles: u32,
    /// Feasibility restorations, successful or not.
    pub restorations: u32,
    /// Attempts to step across a redundant bound.
    pub redundant_bounds: u32,
}

/// Evaluates the functions at a point. The inner error is the reason why they are undefined there;
/// the outer error is argmin's and ends the search.
pub(super) type Evaluate<'a> =
    dyn FnMut(&[f64]) -> Result<Result<Evaluation, String>, argmin::core::Error> + 'a;

impl SearchState {
    pub fn new(scaling: Scaling, point: EvaluatedPoint, radius: f64) -> Self {
        let multipliers = vec![0.0; point.f.constraints.len()];
        Self {
            residual: scaling.residual(&point, &multipliers),
            multipliers,
            radius,
            reflection: 1.0,
            penalty: 0.0,
            kink_sides: Bundle::default(),
            quasi_newton: None,
            solver: QpSolver::default(),
            counters: Counters::default(),
            effort: Effort::default(),
            undefined_reason: None,
            workspace: Workspace::default(),
            scaling,
            point,
        }
    }

    /// True if all dimensions fit a problem of `n` variables and `m` constraints.
    pub fn has_dimensions(&self, n: usize, m: usize) -> bool {
        let Self {
            scaling: Scaling { scale, gamma, .. },
            point,
            multipliers,
            kink_sides,
            quasi_newton,
            solver,
            ..
        } = self;
        [scale.len(), gamma.len(), multipliers.len()] == [n, m, m]
            && point.has_dimensions(n, m)
            && kink_sides.has_dimensions(n, m)
            && quasi_newton
                .as_ref()
                .is_none_or(|hessian| hessian.has_dimensions(n))
            && solver
                .active_set
                .as_ref()
                .is_none_or(|active| active.has_dimensions(n, m))
    }

    /// Trial step of the quadratic model. If the model predicts no reduction, drops the farthest
    /// point of `kink_sides`, because its expansion may be inaccurate, and computes the step again.
    pub fn trial_step(&mut self) -> TrialStep {
        loop {
            let step = self.solve_model(None);
            let has_no_gain =
                self.predicted_reduction(&step) <= NEGLIGIBLE * self.scaling.size(&self.point);
            if !(has_no_gain && self.kink_sides.drop_farthest(&self.scaling, &self.point)) {
                return step;
            }
        }
    }

    /// Computes the step that minimizes the quadratic model. If `tried` is given, computes the
    /// second-order correction of the step that ended at `tried`.
    fn solve_model(&mut self, tried: Option<&EvaluatedPoint>) -> TrialStep {
        let mut workspace = std::mem::take(&mut self.workspace);
        let mut hessian = std::mem::take(&mut workspace.hessian);
        match write_lagrangian_hessian(&self.point, &self.multipliers, &mut hessian) {
            Some(()) => self.scaling.scale_hessian(&mut hessian),
            None => hessian = self.quasi_newton().matrix(),
        }
        let model = LagrangianModel {
            scaling: &self.scaling,
            kink_sides: &self.kink_sides,
            point: &self.point,
            multipliers: &self.multipliers,
            hessian: &hessian,
            radius: self.radius,
            reflection: self.reflection,
        };
        let step = match tried {
            None => model.trial_step(&mut self.solver, &mut workspace),
            Some(tried) => model.second_order_correction(tried, &mut self.solver, &mut workspace),
        };
        workspace.hessian = hessian;
        self.workspace = workspace;
        self.count(&step);
        step
    }

    /// Updates the penalty ν so that the step reduces the model of the merit function.
    pub fn update_penalty(&mut self, step: &TrialStep) {
        if !step.is_relaxed {
            // the merit function is exact for ν ≥ ‖λ‖₂: bring a larger ν halfway to this value
            let exact = self.multiplier_norm(&step.multipliers);
            self.penalty = exact.max(0.5 * (self.penalty + exact));
        }
        let violation_reduction = step.violation - step.linear_violation;
        if violation_reduction > NOISE {
            let needed = -step.objective_reduction / ((1.0 - PENALTY_RHO) * violation_reduction);
            if needed > self.penalty {
                self.penalty = PENALTY_MARGIN * needed;
            }
        }
    }

    /// Limits the norm of a relaxed step's multipliers to ν. Inconsistent rows have unbounded
    /// multipliers, which would let the Hessian of the Lagrangian grow without limit; the
    /// multipliers of the merit function, ν v/‖v‖, never exceed ν.
    pub fn limit_multipliers(&self, step: &mut TrialStep) {
        if !step.is_relaxed {
            return;
        }
        let norm = self.multiplier_norm(&step.multipliers);
        let part = if norm > self.penalty {
            self.penalty / norm
        } else {
            1.0
        };
        step.multipliers
            .iter_mut()
            .for_each(|multiplier| *multiplier *= part);
    }

    /// Norm ‖λ‖₂, in units of 1/γ.
    fn multiplier_norm(&self, multipliers: &[f64]) -> f64 {
        norm(
            multipliers
                .iter()
                .zip(&self.scaling.gamma)
                .map(|(m, gamma)| m * gamma),
        )
    }

    /// Evaluates the functions at the end of a trial step, and computes the reduction of the merit
    /// function.
    pub fn evaluate_step(
        &mut self,
        mut step: TrialStep,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Trial, argmin::core::Error> {
        let point = self.evaluate_at(std::mem::take(&mut step.x), evaluate)?;
        let reduction = self.reduction(&step, point.as_ref());
        Ok(Trial {
            step,
            point,
            reduction,
        })
    }

    /// Evaluates the functions at x. If they are undefined, returns `None` and records the reason.
    pub fn evaluate_at(
        &mut self,
        x: Vec<f64>,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Option<EvaluatedPoint>, argmin::core::Error> {
        self.effort.evaluations += 1;
        match evaluate(&x)? {
            Ok(f) => Ok(Some(EvaluatedPoint { x, f })),
            Err(why) => {
                self.undefined_reason = Some(why);
                Ok(None)
            }
        }
    }

    /// Applies second-order corrections to a rejected step. Stops when a correction does not lower
    /// the merit function further, or when the reduction is good.
    pub fn correct_step(
        &mut self,
        mut trial: Trial,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Trial, argmin::core::Error> {
        for _ in 0..MAX_CORRECTIONS {
            if trial.reduction.is_good() {
                break;
            }
            let Some(corrected) = self.second_order_correction(&trial) else {
                break;
            };
            let point = self.evaluate_at(corrected.x, evaluate)?;
            let reduction = self.reduction(&trial.step, point.as_ref());
            if reduction.actual <= trial.reduction.actual {
                break;
            }
            trial.step.multipliers = corrected.multipliers;
            (trial.point, trial.reduction) = (point, reduction);
        }
        Ok(trial)
    }

    /// Second-order correction of a step whose end violates the constraints by more than their
    /// linear model predicts.
    fn second_order_correction(&mut self, trial: &Trial) -> Option<TrialStep> {
        let tried = trial.point.as_ref()?;
        let unpredicted_violation =
            norm(self.scaling.violations(&tried.f)) - trial.step.linear_violation;
        if tried.f.constraints.is_empty() || unpredicted_violation <= NOISE {
            return None;
        }
        self.effort.corrections += 1;
        Some(self.solve_model(Some(tried)))
    }

    /// Predicted and actual reduction of the merit function.
    fn reduction(&self, step: &TrialStep, point: Option<&EvaluatedPoint>) -> Reduction {
        let actual = point.map_or(f64::NEG_INFINITY, |point| {
            let violation = norm(self.scaling.violations(&point.f));
            self.point.f.objective.value - point.f.objective.value
                + self.penalty * (self.violation() - violation)
        });
        Reduction {
            actual,
            predicted: self.predicted_reduction(step),
            size: self.merit_size(),
        }
    }

    /// True if the merit function changes by little more than rounding, but the KKT residual falls
    /// by half or more. Near a solution the gradient has more correct digits than the merit
    /// function (Hager & Zhang 2005, SIAM J. Optim. 16, section 2).
    pub fn halves_the_residual(&self, trial: &Trial) -> bool {
        let Some(point) = &trial.point else {
            return false;
        };
        let residual = self.scaling.residual(point, &trial.step.multipliers);
        trial.reduction.is_nearly_rounding() && residual.largest() <= 0.5 * self.residual.largest()
    }

    /// Updates the trust-region radius, and the factor that scales reflected eigenvalues.
    pub fn update_radius(&mut self, step: &TrialStep, reduction: &Reduction) {
        if reduction.is_poor() {
            self.radius = SHRINK * step.length.min(self.radius);
        } else if reduction.is_good() && step.is_limited_by(self.radius) {
            self.radius = (GROW * self.radius).min(MAX_RADIUS);
        }
        // a reflected eigenvalue is not a curvature of f, but limits the step like a trust region:
        // make it smaller while the model predicts the reduction of the merit function exactly
        let is_exact = step.is_reflected && reduction.is_exact();
        self.reflection = if is_exact {
            (SHRINK * self.reflection).max(MIN_REFLECTION)
        } else {
            1.0
        };
    }

    /// Moves the iterate to a point and returns the previous iterate.
    pub fn move_to(&mut self, to: EvaluatedPoint) -> EvaluatedPoint {
        self.scaling.floor_size(&to);
        if to.f.objective.hessian.is_empty() {
            let mut hessian = self.quasi_newton();
            hessian.update(&self.scaling, &self.point, &to, &self.multipliers);
            self.quasi_newton = Some(hessian);
        }
        std::mem::replace(&mut self.point, to)
    }

    /// Restarts at a point: multipliers, penalty, kinks and quasi-Newton Hessian are reset.
    pub fn restart_at(&mut self, point: EvaluatedPoint, radius: f64) {
        self.multipliers.fill(0.0);
        self.scaling.floor_size(&point);
        (self.penalty, self.radius, self.counters.stalled) = (0.0, radius, 0);
        (self.kink_sides, self.quasi_newton) = (Bundle::default(), None);
        self.residual = self.scaling.residual(&point, &self.multipliers);
        self.point = point;
    }

    /// Predicted reduction of the merit function.
    pub fn predicted_reduction(&self, step: &TrialStep) -> f64 {
        step.objective_reduction + self.penalty * (step.violation - step.linear_violation)
    }

    /// Size of the merit function: the size of f plus ν. Its rounding error is proportional to this
    /// size.
    pub fn merit_size(&self) -> f64 {
        self.scaling.size(&self.point) + self.penalty
    }

    /// Norm ‖v‖₂ of the constraint violations, in units of γ.
    pub fn violation(&self) -> f64 {
        norm(self.scaling.violations(&self.point.f))
    }

    /// Lagrangian at another point, with the multipliers of the iterate.
    pub fn lagrangian(&self, at: &EvaluatedPoint) -> f64 {
        let terms =
            at.f.constraints
                .iter()
                .zip(&self.multipliers)
                .map(|(constraint, m)| m * constraint.value);
        at.f.objective.value + terms.sum::<f64>()
    }

    fn quasi_newton(&self) -> QuasiNewton {
        self.quasi_newton
            .clone()
            .unwrap_or_else(|| QuasiNewton::initial(&self.scaling, &self.point))
    }

    fn count(&mut self, step: &TrialStep) {
        match step.source {
            StepSource::WarmStart => self.effort.warm_starts += 1,
            StepSource::Clarabel => self.effort.clarabel += 1,
            StepSource::Unpolished => self.effort.unpolished += 1,
        }
        self.effort.relaxed += u64::from(step.is_relaxed);
    }
}
