//! Quadratic model of the Lagrangian at a point, and the trial step that minimizes it.

use super::bundle::Bundle;
use super::convex::{Convexified, convexify};
use super::qp::{
    Activity, LinearConstraint, MaxTerm, QpSolver, QpStep, QuadraticProgram, StepSource,
    quadratic_form,
};
use super::scaling::{EvaluatedPoint, Scaling, norm};
use super::trial_step::{NORMAL_PART, TrialStep};
use crate::number::Taylor;
use nalgebra::{DMatrix, DVector};

/// Quadratic model in scaled variables: minimize ½ dᵀB d + ∇f·d over steps d. The limits hold for c
/// + ∇c·d, the bounds for x + d, and ‖d‖∞ ≤ Δ.
pub(super) struct LagrangianModel<'a> {
    pub scaling: &'a Scaling,
    pub kink_sides: &'a Bundle,
    pub point: &'a EvaluatedPoint,
    pub multipliers: &'a [f64],
    /// Hessian of the Lagrangian in scaled variables, exact or quasi-Newton.
    pub hessian: &'a DMatrix<f64>,
    /// Trust-region radius Δ.
    pub radius: f64,
    /// Factor of a reflection: a negative eigenvalue λ of the Hessian is replaced by this factor
    /// times |λ|.
    pub reflection: f64,
}

/// Memory reused by all iterations, and the solver of the elastic programs.
#[derive(Clone, Debug, Default)]
pub(super) struct Workspace {
    /// Hessian of the Lagrangian in scaled variables.
    pub hessian: DMatrix<f64>,
    program: QuadraticProgram,
    feasibility: QpSolver,
}

/// Weight of the term ½‖d‖² in the elastic program. The term makes the step of least violation
/// unique and short.
const STEP_WEIGHT: f64 = 1e-8;
/// Distance by which the limits of relaxed inequality rows are widened further, to cover rounding.
const ROUNDING: f64 = 1e-12;

impl LagrangianModel<'_> {
    /// Minimizes the model. If the linearized constraints are inconsistent within bounds and trust
    /// region, they are relaxed by the smallest violation that a step can reach.
    pub fn trial_step(&self, solver: &mut QpSolver, workspace: &mut Workspace) -> TrialStep {
        self.trial_step_with_values(|j| self.point.f.constraints[j].value, solver, workspace)
    }

    /// Second-order correction (Fletcher 1982): the step computed with the constraint values at the
    /// end of a trial step. These values include the constraints' curvature.
    pub fn second_order_correction(
        &self,
        tried: &EvaluatedPoint,
        solver: &mut QpSolver,
        workspace: &mut Workspace,
    ) -> TrialStep {
        let d = self.step_to(&tried.x);
        let value = |j: usize| {
            let normal = DVector::from_iterator(d.len(), self.scaling.normal(self.point, j));
            let linear = normal.dot(&d) * self.scaling.gamma[j];
            tried.f.constraints[j].value - linear
        };
        self.trial_step_with_values(value, solver, workspace)
    }

    /// Trial step for given constraint values at d = 0.
    fn trial_step_with_values(
        &self,
        value: impl Fn(usize) -> f64,
        solver: &mut QpSolver,
        workspace: &mut Workspace,
    ) -> TrialStep {
        let program = &mut workspace.program;
        let convexified = self.write_program(value, program);
        let program = &*program;
        let (step, is_relaxed) = match solver.solve(program) {
            Some(step) => (step, false),
            None => {
                let least = self.least_violation(program, &mut workspace.feasibility);
                let relaxed = relaxed(program, &least.d);
                (
                    solver
                        .solve(&relaxed)
                        .unwrap_or_else(|| self.with_previous_multipliers(least)),
                    true,
                )
            }
        };
        let x: Vec<f64> = (0..self.point.x.len())
            .map(|i| self.trial_coordinate(&step, i))
            .collect();
        let d = self.step_to(&x);
        let mut trial = TrialStep {
            length: step.d.amax(),
            objective_reduction: self.objective_reduction(program, &d),
            violation: norm(self.scaling.violations(&self.point.f)),
            linear_violation: norm(program.rows.iter().map(|row| row.excess(&d))),
            multipliers: step
                .multipliers
                .iter()
                .zip(&self.scaling.gamma)
                .map(|(m, gamma)| m / gamma)
                .collect(),
            active_terms: step.weights.iter().filter(|weight| **weight > 1e-6).count(),
            is_relaxed,
            is_reflected: convexified.is_reflected,
            source: step.source,
            x,
        };
        if convexified.added_curvature > 0.0 {
            self.correct_multipliers(convexified.added_curvature, program, &d, &mut trial);
        }
        trial
    }

    /// Gives a step of least violation the multipliers of the previous iteration. The multipliers
    /// of `step` belong to the elastic program, which does not contain f.
    fn with_previous_multipliers(&self, step: QpStep) -> QpStep {
        let multipliers = self
            .multipliers
            .iter()
            .zip(&self.scaling.gamma)
            .map(|(m, gamma)| m * gamma)
            .collect();
        QpStep {
            multipliers,
            weights: vec![1.0],
            ..step
        }
    }

    /// Writes the quadratic program in scaled variables: the model at the iterate, a term for each
    /// other side of a nearby kink, and the linearized constraints.
    fn write_program(
        &self,
        value: impl Fn(usize) -> f64,
        program: &mut QuadraticProgram,
    ) -> Convexified {
        let Self { scaling, point, .. } = *self;
        let n = point.x.len();
        program.resize(n, point.f.constraints.len());
        let convexified = convexify(
            self.hessian,
            || self.active_normals(),
            self.reflection,
            &mut program.hessian,
        );

        let own = &mut program.max_terms[0].gradient;
        own.iter_mut()
            .enumerate()
            .for_each(|(i, slope)| *slope = point.f.objective.gradient[i] * scaling.scale[i]);
        program
            .max_terms
            .extend(self.kink_sides.max_terms(scaling, point, self.hessian));

        // limits of the step: bounds and trust region
        let bounds = &scaling.domain.variables;
        for i in 0..n {
            let limit = |bound: f64| {
                let step = (bound - point.x[i]) / scaling.scale[i];
                step.clamp(-self.radius, self.radius)
            };
            program.low[i] = limit(bounds.low[i]);
            program.high[i] = limit(bounds.high[i]);
        }
        for (j, row) in program.rows.iter_mut().enumerate() {
            row.normal.resize_vertically_mut(n, 0.0);
            row.normal
                .iter_mut()
                .zip(scaling.normal(point, j))
                .for_each(|(normal, slope)| *normal = slope);
            (row.low, row.high) = self.row_limits(j, value(j));
        }
        convexified
    }

    /// Limits of row j, in units of γⱼ, if constraint j has this value at d = 0.
    fn row_limits(&self, j: usize, value: f64) -> (f64, f64) {
        let (limits, gamma) = (&self.scaling.domain.constraints, self.scaling.gamma[j]);
        let low = (limits.low[j] - value) / gamma;
        let high = if limits.is_fixed(j) {
            low
        } else {
            (limits.high[j] - value) / gamma
        };
        (low, high)
    }

    /// Computes the step with the least sum of squared violations of the linearized constraints,
    /// within the fraction [`NORMAL_PART`] of the trust region. If the constraints' curvature makes
    /// the violation rise along this step, for example across a narrow valley, computes the step
    /// again with this curvature.
    fn least_violation(&self, program: &QuadraticProgram, solver: &mut QpSolver) -> QpStep {
        let (n, m) = (program.low.len(), program.rows.len());
        let mut elastic = elastic(program, NORMAL_PART * self.radius);
        let mut solve = |elastic: &QuadraticProgram| {
            solver.active_set = None;
            // no step if the program has no solution
            solver.solve(elastic).unwrap_or_else(|| QpStep {
                d: DVector::zeros(n + m),
                activities: vec![Activity::Inactive; n + m],
                weights: vec![1.0],
                multipliers: vec![0.0; m],
                source: StepSource::Unpolished,
            })
        };
        let mut step = solve(&elastic);
        let squares = |d: &DVector<f64>| 0.5 * d.rows(n, m).norm_squared();
        let before = 0.5 * norm(self.scaling.violations(&self.point.f)).powi(2);
        if let Some(curvature) = self.violation_curvature()
            && squares(&step.d) + 0.5 * quadratic_form(&curvature, &step.d.rows(0, n).into_owned())
                > before
        {
            let mut block = elastic.hessian.view_mut((0, 0), (n, n));
            block += curvature;
            step = solve(&elastic);
        }
        step.d = step.d.rows(0, n).into_owned();
        step.activities.truncate(n);
        step
    }

    /// Curvature term of the Hessian of ½‖v‖²: the positive semidefinite part of Σ vⱼ ∇²cⱼ in
    /// scaled variables, with the violation vⱼ of constraint j. `None` if this sum is zero, or if a
    /// violated constraint has no Hessian.
    fn violation_curvature(&self) -> Option<DMatrix<f64>> {
        let Self { scaling, point, .. } = *self;
        let n = point.x.len();
        let mut sum = DMatrix::zeros(n, n);
        for (j, violation) in scaling
            .violations(&point.f)
            .enumerate()
            .filter(|(_, violation)| *violation != 0.0)
        {
            let hessian = &point.f.constraints[j].hessian;
            if hessian.is_empty() {
                return None;
            }
            let weight = violation / scaling.gamma[j];
            sum += DMatrix::from_fn(n, n, |i, k| {
                weight * hessian[i][k] * scaling.scale[i] * scaling.scale[k]
            });
        }
        if sum.iter().all(|entry| *entry == 0.0) {
            return None;
        }
        let eigen = sum.symmetric_eigen();
        let raised = DMatrix::from_diagonal(&eigen.eigenvalues.map(|value| value.max(0.0)));
        Some(&eigen.eigenvectors * raised * eigen.eigenvectors.transpose())
    }

    /// Corrects the multipliers of active rows for the curvature that convexification adds along
    /// the active normals. The added curvature contributes to the multipliers of the quadratic
    /// program, in proportion to the step's component along each normal. The correction removes
    /// this contribution.
    fn correct_multipliers(
        &self,
        added_curvature: f64,
        program: &QuadraticProgram,
        d: &DVector<f64>,
        trial: &mut TrialStep,
    ) {
        for j in self.scaling.active_rows(self.multipliers) {
            let (normal, is_equation) = (
                &program.rows[j].normal,
                self.scaling.domain.constraints.is_fixed(j),
            );
            let (square, before) = (normal.norm_squared(), trial.multipliers[j]);
            if square == 0.0 || !is_equation && before == 0.0 {
                continue;
            }
            let own = before + added_curvature * normal.dot(d) / (square * self.scaling.gamma[j]);
            // the correction must not change the sign of an inequality's multiplier
            trial.multipliers[j] = if is_equation || own * before > 0.0 {
                own
            } else {
                before
            };
        }
    }

    /// Unit normals of the active bounds, of equality constraints, and of constraints with nonzero
    /// multipliers.
    fn active_normals(&self) -> Vec<DVector<f64>> {
        let Self {
            scaling,
            point,
            multipliers,
            ..
        } = *self;
        let n = point.x.len();
        let unit = |i: usize| DVector::from_fn(n, |k, _| f64::from(k == i));
        let rows = scaling.active_rows(multipliers).map(|j| {
            let normal = DVector::from_iterator(n, scaling.normal(point, j));
            let length = normal.norm();
            if length > 0.0 {
                normal / length
            } else {
                normal
            }
        });
        scaling
            .active_bounds(point, multipliers)
            .map(unit)
            .chain(rows)
            .collect()
    }

    /// Predicted reduction of f. If the piecewise model has a single term, the Hessian before
    /// convexification is used, because convexification adds curvature along the normals of
    /// constraints.
    fn objective_reduction(&self, program: &QuadraticProgram, d: &DVector<f64>) -> f64 {
        if program.max_terms.len() > 1 {
            return -program.value(d);
        }
        -(program.max_terms[0].gradient.dot(d) + 0.5 * quadratic_form(self.hessian, d))
    }

    /// Coordinate i of the trial point x + d. A coordinate within rounding of a bound is set to the
    /// bound.
    fn trial_coordinate(&self, step: &QpStep, i: usize) -> f64 {
        let (bounds, scale) = (&self.scaling.domain.variables, self.scaling.scale[i]);
        let (x, d, low, high) = (self.point.x[i], step.d[i], bounds.low[i], bounds.high[i]);
        // bound / scale × scale may round to a value short of the bound
        let nearly = 1.0 - 4.0 * f64::EPSILON;
        let to = x + d * scale;
        match step.activities[i] {
            Activity::Lower if d > -self.radius && d * scale <= nearly * (low - x) => low,
            Activity::Upper if d < self.radius && d * scale >= nearly * (high - x) => high,
            _ => self.scaling.on_bound(i, to.clamp(low, high)),
        }
    }

    /// Step from the iterate to a point, in scaled variables.
    fn step_to(&self, x: &[f64]) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| {
            (x[i] - self.point.x[i]) / self.scaling.scale[i]
        })
    }
}

/// Elastic program: minimizes ½‖e‖² + ½ STEP_WEIGHT ‖d‖² with |dᵢ| ≤ `radius`. The variable eⱼ is
/// the violation of row j.
fn elastic(program: &QuadraticProgram, radius: f64) -> QuadraticProgram {
    let (n, m) = (program.low.len(), program.rows.len());
    let wide = |j: usize| {
        let row = &program.rows[j];
        let mut normal = row.normal.clone().resize_vertically(n + m, 0.0);
        normal[n + j] = 1.0;
        LinearConstraint { normal, ..*row }
    };
    let far = |row: &LinearConstraint| {
        row.low.max(0.0).max(-row.high.min(0.0)) + row.normal.abs().sum() * radius + 1.0
    };
    let farthest = program.rows.iter().map(far).fold(1.0, f64::max);
    QuadraticProgram {
        hessian: DMatrix::from_diagonal(&DVector::from_fn(n + m, |i, _| {
            if i < n { STEP_WEIGHT } else { 1.0 }
        })),
        max_terms: vec![MaxTerm {
            offset: 0.0,
            gradient: DVector::zeros(n + m),
        }],
        low: DVector::from_fn(n + m, |i, _| {
            if i < n {
                program.low[i].max(-radius)
            } else {
                -farthest
            }
        }),
        high: DVector::from_fn(n + m, |i, _| {
            if i < n {
                program.high[i].min(radius)
            } else {
                farthest
            }
        }),
        rows: (0..m).map(wide).collect(),
    }
}

/// Moves the limits of the violated rows so that the step `d` meets them.
fn relaxed(program: &QuadraticProgram, d: &DVector<f64>) -> QuadraticProgram {
    let mut relaxed = program.clone();
    for row in &mut relaxed.rows {
        // > 0 if the row is below its lower limit, < 0 if it is above its upper limit
        let remaining = -row.excess(d);
        if row.low == row.high {
            row.low -= remaining;
            row.high = row.low;
        } else {
            row.low -= remaining.max(0.0) + ROUNDING;
            row.high += (-remaining).max(0.0) + ROUNDING;
        }
    }
    relaxed
}

/// Writes the Hessian of the Lagrangian to `sum`; `None` if a function has no Hessian.
pub(super) fn write_lagrangian_hessian(
    at: &EvaluatedPoint,
    multipliers: &[f64],
    sum: &mut DMatrix<f64>,
) -> Option<()> {
    let n = at.x.len();
    if sum.nrows() != n {
        *sum = DMatrix::zeros(n, n);
    }
    sum.fill(0.0);
    add_hessian(sum, &at.f.objective, 1.0)?;
    for (constraint, multiplier) in at.f.constraints.iter().zip(multipliers) {
        add_hessian(sum, constraint, *multiplier)?;
    }
    Some(())
}

/// Adds the Hessian of a function times `weight`; `None` if the function has no Hessian.
fn add_hessian(sum: &mut DMatrix<f64>, of: &Taylor, weight: f64) -> Option<()> {
    if of.hessian.is_empty() {
        return None;
    }
    if weight == 0.0 {
        return Some(());
    }
    // the Hessian is symmetric: add its rows to the columns of `sum`
    for (column, row) in sum
        .as_mut_slice()
        .chunks_exact_mut(of.hessian.len())
        .zip(&of.hessian)
    {
        column
            .iter_mut()
            .zip(row)
            .for_each(|(sum, curvature)| *sum += weight * curvature);
    }
    Some(())
}
