//! The state of a search between two iterations: point, multipliers, trust region, penalty, and the
//! steps from one to the next.

use super::bundle::Bundle;
use super::model::{Model, Workspace, write_lagrangian_hessian};
use super::problem::Evaluation;
use super::qp::{QpSolver, StepSource};
use super::quasi_newton::QuasiNewton;
use super::reduction::{NOISE, Reduction};
use super::scaling::{Point, Residual, Scaling, norm};
use super::trial_step::TrialStep;
use serde::{Deserialize, Serialize};

/// A step that fails is corrected at most so often, while that improves it and it is not yet good.
const MOST_CORRECTIONS: u32 = 3;
/// Largest trust region, in units of the variables' scale.
const LARGEST_RADIUS: f64 = 1e16;
/// The trust region shrinks to this part of the step after a poor reduction …
const SHRINK: f64 = 0.25;
/// … and grows by this factor after a good one of a step that it limited (Conn, Gould & Toint 2000,
/// §17.1).
const GROW: f64 = 2.0;
/// Least part of its size to which negative curvature is reflected.
const LEAST_REFLECTION: f64 = 1e-12;
/// Predicted reductions below this, relative to φ, are negligible.
const NEGLIGIBLE: f64 = 1e-13;
/// The predicted reduction of the merit is at least this part of ν times that of the violation
/// (Nocedal & Wright 2006, eq. 18.36: ρ).
const MERIT_SHARE: f64 = 0.1;
/// Margin of a raised penalty, so that the next step does not raise it again.
const PENALTY_MARGIN: f64 = 1.5;

/// The work of a search, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Effort {
    /// Evaluations of the functions with their derivatives.
    pub evaluations: u64,
    /// Quadratic programs solved by the active set of the one before: one linear system.
    pub warm_starts: u64,
    /// Quadratic programs solved by Clarabel, its active set polished to an exact KKT point.
    pub clarabel: u64,
    /// Quadratic programs whose step is Clarabel's own solution: no active set near it was exact.
    pub unpolished: u64,
    /// Steps whose linearised constraints contradicted each other and were relaxed.
    pub relaxed: u64,
    /// Second-order corrections tried.
    pub corrections: u64,
}

/// The state of a search.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct State {
    pub scaling: Scaling,
    /// x, with f, c and their derivatives.
    pub point: Point,
    /// λ.
    pub multipliers: Vec<f64>,
    /// Δ, in units of the scale.
    pub radius: f64,
    /// The part of its size to which negative curvature is reflected.
    pub reflection: f64,
    /// ν of the merit f + ν ‖v‖₂.
    pub penalty: f64,
    /// The KKT residual at the point.
    pub residual: Residual,
    /// Points on the other sides of corners of f.
    pub corners: Bundle,
    /// The Hessian of the Lagrangian for a problem that gives none.
    quasi_newton: Option<QuasiNewton>,
    /// Solves the quadratic programs, each from the active set of the one before.
    solver: QpSolver,
    pub counters: Counters,
    pub effort: Effort,
    /// Why the functions were undefined at the end of a trial step, the last time that they were.
    pub undefined_reason: Option<String>,
    #[serde(skip)]
    workspace: Workspace,
}

/// How often a search has done what it may do a few times only.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct Counters {
    /// Iterations in a row without progress.
    pub stalled: u32,
    /// Saddles left.
    pub saddles: u32,
    /// Restarts from another point that meets the constraints better.
    pub restorations: u32,
    /// Redundant bounds crossed.
    pub redundant_bounds: u32,
}

/// Evaluates the functions of a problem at a point; the outer error is argmin's and ends the
/// search.
pub(super) type Evaluate<'a> =
    dyn FnMut(&[f64]) -> Result<Result<Evaluation, String>, argmin::core::Error> + 'a;

/// A trial step with the point at its end, where the functions are defined there, and the reduction
/// of the merit.
pub(super) struct Trial {
    pub step: TrialStep,
    pub point: Option<Point>,
    pub reduction: Reduction,
}

impl State {
    pub fn new(scaling: Scaling, point: Point, radius: f64) -> Self {
        let multipliers = vec![0.0; point.f.constraints.len()];
        Self {
            residual: scaling.residual(&point, &multipliers),
            multipliers,
            radius,
            reflection: 1.0,
            penalty: 0.0,
            corners: Bundle::default(),
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

    /// Whether all that it holds is of `n` variables and `m` constraints.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        let Self {
            scaling: Scaling { scale, gamma, .. },
            point,
            multipliers,
            corners,
            quasi_newton,
            solver,
            ..
        } = self;
        [scale.len(), gamma.len(), multipliers.len()] == [n, m, m]
            && point.is_of(n, m)
            && corners.is_of(n, m)
            && quasi_newton.as_ref().is_none_or(|hessian| hessian.is_of(n))
            && solver
                .active_set
                .as_ref()
                .is_none_or(|active| active.is_of(n, m))
    }

    /// The trial step of the model. Where a point on another side of a corner, too far away, leaves
    /// nothing to gain, that side is forgotten and met again nearer.
    pub fn trial_step(&mut self) -> TrialStep {
        loop {
            let step = self.solve_model(None);
            let is_hopeless =
                self.predicted_reduction(&step) <= NEGLIGIBLE * self.scaling.size(&self.point);
            if !(is_hopeless && self.corners.forget_one_too_far(&self.scaling, &self.point)) {
                return step;
            }
        }
    }

    /// The step of the model; after a tried point, its second-order correction.
    fn solve_model(&mut self, tried: Option<&Point>) -> TrialStep {
        let mut workspace = std::mem::take(&mut self.workspace);
        let mut hessian = std::mem::take(&mut workspace.hessian);
        if !write_lagrangian_hessian(&self.scaling, &self.point, &self.multipliers, &mut hessian) {
            hessian = self.quasi_newton().matrix();
        }
        let model = Model {
            scaling: &self.scaling,
            corners: &self.corners,
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

    /// Updates the penalty, so that the step lowers the model of the merit.
    pub fn update_penalty(&mut self, step: &TrialStep) {
        if !step.is_relaxed {
            // an exact penalty is at least the multipliers' norm; one that was too large sinks
            // towards it
            let exact = self.multiplier_norm(&step.multipliers);
            self.penalty = exact.max(0.5 * (self.penalty + exact));
        }
        let gained = step.violation - step.linear_violation;
        if gained > NOISE {
            let needed = -step.objective_reduction / ((1.0 - MERIT_SHARE) * gained);
            if needed > self.penalty {
                self.penalty = PENALTY_MARGIN * needed;
            }
        }
    }

    /// Limits the multipliers of a relaxed step to the penalty. The merit's own, ν v/‖v‖, are no
    /// larger, and those of contradicting rows may be anything: they would rise without end, and
    /// the Hessian of the Lagrangian with them.
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

    /// ‖λ‖₂, in units of 1/γ.
    fn multiplier_norm(&self, multipliers: &[f64]) -> f64 {
        norm(
            multipliers
                .iter()
                .zip(&self.scaling.gamma)
                .map(|(m, gamma)| m * gamma),
        )
    }

    /// Evaluates the end of a trial step.
    pub fn tried(
        &mut self,
        mut step: TrialStep,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Trial, argmin::core::Error> {
        let point = self.evaluated(std::mem::take(&mut step.x), evaluate)?;
        let reduction = self.reduction(&step, point.as_ref());
        Ok(Trial {
            step,
            point,
            reduction,
        })
    }

    /// The point at x; where the functions are undefined there, the reason is kept.
    pub fn evaluated(
        &mut self,
        x: Vec<f64>,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Option<Point>, argmin::core::Error> {
        self.effort.evaluations += 1;
        match evaluate(&x)? {
            Ok(f) => Ok(Some(Point { x, f })),
            Err(why) => {
                self.undefined_reason = Some(why);
                Ok(None)
            }
        }
    }

    /// Second-order corrections of a step that failed, while they reduce the merit further and not
    /// yet well.
    pub fn corrected(
        &mut self,
        mut trial: Trial,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Trial, argmin::core::Error> {
        for _ in 0..MOST_CORRECTIONS {
            if trial.reduction.is_good() {
                break;
            }
            let Some(corrected) = self.second_order_correction(&trial) else {
                break;
            };
            let point = self.evaluated(corrected.x, evaluate)?;
            let reduction = self.reduction(&trial.step, point.as_ref());
            if reduction.actual <= trial.reduction.actual {
                break;
            }
            trial.step.multipliers = corrected.multipliers;
            (trial.point, trial.reduction) = (point, reduction);
        }
        Ok(trial)
    }

    /// The second-order correction of a step, where it violates the constraints by more than their
    /// linear model.
    fn second_order_correction(&mut self, trial: &Trial) -> Option<TrialStep> {
        let tried = trial.point.as_ref()?;
        let missed = norm(self.scaling.violations(&tried.f)) - trial.step.linear_violation;
        if tried.f.constraints.is_empty() || missed <= NOISE {
            return None;
        }
        self.effort.corrections += 1;
        Some(self.solve_model(Some(tried)))
    }

    /// Predicted and actual reduction of the merit.
    fn reduction(&self, step: &TrialStep, point: Option<&Point>) -> Reduction {
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

    /// Whether a step that changes the merit by little more than rounding halves the KKT residual:
    /// near a solution the gradient has more correct digits than the merit (Hager & Zhang 2005,
    /// SIAM J. Optim. 16, section 2).
    pub fn halves_the_residual(&self, trial: &Trial) -> bool {
        let Some(point) = &trial.point else {
            return false;
        };
        let residual = self.scaling.residual(point, &trial.step.multipliers);
        trial.reduction.is_nearly_rounding() && residual.largest() <= 0.5 * self.residual.largest()
    }

    /// The trust region for the next step.
    pub fn update_radius(&mut self, step: &TrialStep, reduction: &Reduction) {
        if reduction.is_poor() {
            self.radius = SHRINK * step.length.min(self.radius);
        } else if reduction.is_good() && step.is_limited_by(self.radius) {
            self.radius = (GROW * self.radius).min(LARGEST_RADIUS);
        }
        // a reflected curvature, which is none of f's, limits steps as a trust region does, and is
        // relaxed as one
        let is_exact = step.is_reflected && reduction.is_exact();
        self.reflection = if is_exact {
            (SHRINK * self.reflection).max(LEAST_REFLECTION)
        } else {
            1.0
        };
    }

    /// Moves to a point; returns the point before.
    pub fn move_to(&mut self, to: Point) -> Point {
        self.scaling.floor_size(&to);
        if to.f.objective.hessian.is_empty() {
            let mut hessian = self.quasi_newton();
            hessian.update(&self.scaling, &self.point, &to, &self.multipliers);
            self.quasi_newton = Some(hessian);
        }
        std::mem::replace(&mut self.point, to)
    }

    /// Restarts at a point, with nothing kept of what was known elsewhere.
    pub fn restart_at(&mut self, point: Point, radius: f64) {
        self.multipliers.fill(0.0);
        self.scaling.floor_size(&point);
        (self.penalty, self.radius, self.counters.stalled) = (0.0, radius, 0);
        (self.corners, self.quasi_newton) = (Bundle::default(), None);
        self.residual = self.scaling.residual(&point, &self.multipliers);
        self.point = point;
    }

    /// What the model says the merit falls by.
    pub fn predicted_reduction(&self, step: &TrialStep) -> f64 {
        step.objective_reduction + self.penalty * (step.violation - step.linear_violation)
    }

    /// The size of the merit, by which its rounding is measured: that of f, and a constraint's in
    /// units of γ.
    pub fn merit_size(&self) -> f64 {
        self.scaling.size(&self.point) + self.penalty
    }

    /// ‖v‖₂, in units of γ.
    pub fn violation(&self) -> f64 {
        norm(self.scaling.violations(&self.point.f))
    }

    /// The Lagrangian at a point, with the multipliers of this one.
    pub fn lagrangian(&self, at: &Point) -> f64 {
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
