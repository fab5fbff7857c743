//! The quadratic model of the Lagrangian around a point, and the trial step that it leads to.

use super::bundle::Bundle;
use super::convex::{Convexified, convexify};
use super::qp::{MaxTerm, QpSolver, QuadraticProgram, Row, Side, Step, StepSource, quadratic_form};
use super::scaling::{Point, Scaling, norm};
use super::trial_step::{NORMAL_PART, TrialStep};
use nalgebra::{DMatrix, DVector};

/// The model ½ dᵀB d + ∇f·d subject to c + ∇c·d within its limits, x + d within its bounds and ‖d‖∞
/// ≤ Δ, in scaled variables.
pub(super) struct Model<'a> {
    pub scaling: &'a Scaling,
    pub corners: &'a Bundle,
    pub point: &'a Point,
    pub multipliers: &'a [f64],
    /// The Hessian of the Lagrangian in scaled variables, exact or quasi-Newton.
    pub hessian: &'a DMatrix<f64>,
    /// Δ.
    pub radius: f64,
    /// The part of its size to which negative curvature is reflected.
    pub reflection: f64,
}

/// Memory that every iteration writes anew, and the solvers of its programs.
#[derive(Clone, Debug, Default)]
pub(super) struct Workspace {
    /// The Hessian of the Lagrangian in scaled variables.
    pub hessian: DMatrix<f64>,
    program: QuadraticProgram,
    feasibility: QpSolver,
}

/// The step of least violation, and the violation that it leaves of each row: too small a value >
/// 0, too large a value < 0.
struct LeastViolation {
    step: Step,
    remaining: Vec<f64>,
}

/// Weight of ½‖d‖² against the squared violations: it keeps the step of least violation short.
const SHORT: f64 = 1e-8;
/// Slack for rounding in a relaxed row, which is met with nothing to spare.
const ROUNDING: f64 = 1e-12;

impl Model<'_> {
    /// Minimises the model. Where the constraints contradict each other within bounds and trust
    /// region, they are relaxed by the least violation that can be reached.
    pub fn trial_step(&self, solver: &mut QpSolver, workspace: &mut Workspace) -> TrialStep {
        self.trial_step_for(|j| self.point.f.constraints[j].value, solver, workspace)
    }

    /// The second-order correction: the step for the constraint values found at the end of a trial
    /// step, so that their curvature along it is taken into account (Fletcher 1982).
    pub fn second_order_correction(
        &self,
        tried: &Point,
        solver: &mut QpSolver,
        workspace: &mut Workspace,
    ) -> TrialStep {
        let d = self.step_to(&tried.x);
        let value = |j: usize| {
            let linear = self.normal(j).dot(&d) * self.scaling.gamma[j];
            tried.f.constraints[j].value - linear
        };
        self.trial_step_for(value, solver, workspace)
    }

    /// The step for constraints of these values at d = 0.
    fn trial_step_for(
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
                let relaxed = relaxed(program, &least.remaining);
                (
                    solver
                        .solve(&relaxed)
                        .unwrap_or_else(|| self.with_multipliers_before(least.step)),
                    true,
                )
            }
        };
        let x = self.end_of(&step);
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
        if convexified.raise > 0.0 {
            self.correct_multipliers(convexified.raise, program, &d, &mut trial);
        }
        trial
    }

    /// A step that has no multipliers of its own, with those of the step before.
    fn with_multipliers_before(&self, step: Step) -> Step {
        let multipliers = self
            .multipliers
            .iter()
            .zip(&self.scaling.gamma)
            .map(|(m, gamma)| m * gamma)
            .collect();
        Step {
            multipliers,
            weights: vec![1.0],
            ..step
        }
    }

    /// Writes the program in scaled variables: the term of the point itself, those of other sides
    /// of corners nearby, and the linearised constraints.
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
            .extend(self.corners.max_terms(scaling, point, self.hessian));

        for i in 0..n {
            (program.low[i], program.high[i]) = self.step_bounds(i);
        }
        for (j, row) in program.rows.iter_mut().enumerate() {
            let gamma = scaling.gamma[j];
            row.normal.resize_vertically_mut(n, 0.0);
            let slopes = point.f.constraints[j].gradient.iter().zip(&scaling.scale);
            row.normal
                .iter_mut()
                .zip(slopes)
                .for_each(|(normal, (slope, scale))| *normal = slope * scale / gamma);
            (row.low, row.high) = self.row_limits(j, value(j));
        }
        convexified
    }

    /// The limits of a step of a variable: its bounds and the trust region.
    fn step_bounds(&self, i: usize) -> (f64, f64) {
        let bounds = &self.scaling.domain.variables;
        let limit = |bound: f64| {
            let step = (bound - self.point.x[i]) / self.scaling.scale[i];
            step.clamp(-self.radius, self.radius)
        };
        (limit(bounds.low[i]), limit(bounds.high[i]))
    }

    /// The limits of a linearised constraint whose value at d = 0 is this.
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

    /// The step of least squared violation in the normal part of the trust region. Where to second
    /// order that step would raise the violation (from wall to wall of a narrow valley, say), the
    /// curvature of the constraints is added.
    fn least_violation(&self, program: &QuadraticProgram, solver: &mut QpSolver) -> LeastViolation {
        let (n, m) = (program.low.len(), program.rows.len());
        let mut elastic = elastic(program, NORMAL_PART * self.radius);
        let mut solve = |elastic: &QuadraticProgram| {
            solver.active_set = None;
            solver.solve(elastic).unwrap_or_else(|| none(n + m, m))
        };
        let mut step = solve(&elastic);
        let squares = |d: &DVector<f64>| 0.5 * d.rows(n, m).norm_squared();
        let before = 0.5 * norm(self.scaling.violations(&self.point.f)).powi(2);
        if let Some(bend) = self.violation_curvature()
            && squares(&step.d) + 0.5 * quadratic_form(&bend, &step.d.rows(0, n).into_owned())
                > before
        {
            let mut corner = elastic.hessian.view_mut((0, 0), (n, n));
            corner += bend;
            step = solve(&elastic);
        }
        step.d = step.d.rows(0, n).into_owned();
        step.sides.truncate(n);
        let remaining = program
            .rows
            .iter()
            .map(|row| -row.excess(&step.d))
            .collect();
        LeastViolation { step, remaining }
    }

    /// Σ vⱼ ∇²cⱼ, the part of the Hessian of ½‖v‖² that comes from curvature (in scaled variables),
    /// as far as it is positive; `None` where a constraint gives no Hessian, and where the sum
    /// vanishes.
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

    /// Corrects the multipliers of active rows for the raised Hessian. The raise pulls a step back
    /// along each normal in proportion to the step's part along it, and the multipliers are too
    /// small by this pull.
    fn correct_multipliers(
        &self,
        raise: f64,
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
            let own = before + raise * normal.dot(d) / (square * self.scaling.gamma[j]);
            // that of an inequality keeps its sign
            trial.multipliers[j] = if is_equation || own * before > 0.0 {
                own
            } else {
                before
            };
        }
    }

    /// The gradient of a constraint, in scaled variables and units of γ.
    fn normal(&self, j: usize) -> DVector<f64> {
        let gradient = &self.point.f.constraints[j].gradient;
        DVector::from_fn(gradient.len(), |i, _| {
            gradient[i] * self.scaling.scale[i] / self.scaling.gamma[j]
        })
    }

    /// Unit normals of the active bounds, of equations, and of constraints with multipliers.
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
            let normal = self.normal(j);
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

    /// What the model says f falls by. Where there is one term, with the true Hessian: the raised
    /// curvature of the convex stand-in along the normals of constraints is not that of f.
    fn objective_reduction(&self, program: &QuadraticProgram, d: &DVector<f64>) -> f64 {
        if program.max_terms.len() > 1 {
            return -program.value(d);
        }
        -(program.max_terms[0].gradient.dot(d) + 0.5 * quadratic_form(self.hessian, d))
    }

    /// The point at the end of a step.
    fn end_of(&self, step: &Step) -> Vec<f64> {
        (0..self.point.x.len())
            .map(|i| self.end_of_variable(step, i))
            .collect()
    }

    fn end_of_variable(&self, step: &Step, i: usize) -> f64 {
        let (bounds, scale) = (&self.scaling.domain.variables, self.scaling.scale[i]);
        let (x, d, low, high) = (self.point.x[i], step.d[i], bounds.low[i], bounds.high[i]);
        // a bound over the scale, times the scale, may fall short of the bound by rounding
        let nearly = 1.0 - 4.0 * f64::EPSILON;
        let to = x + d * scale;
        match step.sides[i] {
            Side::Lower if d > -self.radius && d * scale <= nearly * (low - x) => low,
            Side::Upper if d < self.radius && d * scale >= nearly * (high - x) => high,
            _ => self.scaling.on_bound(i, to.clamp(low, high)),
        }
    }

    /// d of the way to a point, in scaled variables.
    fn step_to(&self, x: &[f64]) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| {
            (x[i] - self.point.x[i]) / self.scaling.scale[i]
        })
    }
}

/// The step that stays where it is.
fn none(variables: usize, rows: usize) -> Step {
    Step {
        d: DVector::zeros(variables),
        sides: vec![Side::Inactive; variables],
        weights: vec![1.0],
        multipliers: vec![0.0; rows],
        source: StepSource::Unpolished,
    }
}

/// The program of least squared violation ½‖e‖² + ½ SHORT ‖d‖² with a variable eⱼ for the violation
/// of each row, for steps up to this reach.
fn elastic(program: &QuadraticProgram, reach: f64) -> QuadraticProgram {
    let (n, m) = (program.low.len(), program.rows.len());
    let wide = |j: usize| {
        let row = &program.rows[j];
        let mut normal = row.normal.clone().resize_vertically(n + m, 0.0);
        normal[n + j] = 1.0;
        Row { normal, ..*row }
    };
    let far =
        |row: &Row| row.low.max(0.0).max(-row.high.min(0.0)) + row.normal.abs().sum() * reach + 1.0;
    let farthest = program.rows.iter().map(far).fold(1.0, f64::max);
    QuadraticProgram {
        hessian: DMatrix::from_diagonal(&DVector::from_fn(
            n + m,
            |i, _| if i < n { SHORT } else { 1.0 },
        )),
        max_terms: vec![MaxTerm {
            offset: 0.0,
            gradient: DVector::zeros(n + m),
        }],
        low: DVector::from_fn(n + m, |i, _| {
            if i < n {
                program.low[i].max(-reach)
            } else {
                -farthest
            }
        }),
        high: DVector::from_fn(n + m, |i, _| {
            if i < n {
                program.high[i].min(reach)
            } else {
                farthest
            }
        }),
        rows: (0..m).map(wide).collect(),
    }
}

/// The program with its rows relaxed by the violations that remain.
fn relaxed(program: &QuadraticProgram, remaining: &[f64]) -> QuadraticProgram {
    let mut relaxed = program.clone();
    for (row, remaining) in relaxed.rows.iter_mut().zip(remaining) {
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

/// The Hessian of the Lagrangian in scaled variables, if every function gives its own.
pub(super) fn lagrangian_hessian(
    scaling: &Scaling,
    at: &Point,
    multipliers: &[f64],
) -> Option<DMatrix<f64>> {
    let mut sum = DMatrix::default();
    write_lagrangian_hessian(scaling, at, multipliers, &mut sum).then_some(sum)
}

/// As [`lagrangian_hessian`], written over a matrix; whether there is one.
pub(super) fn write_lagrangian_hessian(
    scaling: &Scaling,
    at: &Point,
    multipliers: &[f64],
    sum: &mut DMatrix<f64>,
) -> bool {
    let n = at.x.len();
    if sum.nrows() != n {
        *sum = DMatrix::zeros(n, n);
    }
    sum.fill(0.0);
    let constraints = at.f.constraints.iter().zip(multipliers.iter().copied());
    for (function, weight) in std::iter::once((&at.f.objective, 1.0)).chain(constraints) {
        if function.hessian.is_empty() {
            return false;
        }
        if weight == 0.0 {
            continue;
        }
        // the matrix is symmetric: its columns are the rows
        for (column, row) in sum
            .as_mut_slice()
            .chunks_exact_mut(n)
            .zip(&function.hessian)
        {
            column
                .iter_mut()
                .zip(row)
                .for_each(|(sum, bend)| *sum += weight * bend);
        }
    }
    for (column, own) in sum.as_mut_slice().chunks_exact_mut(n).zip(&scaling.scale) {
        column
            .iter_mut()
            .zip(&scaling.scale)
            .for_each(|(entry, scale)| *entry *= scale * own);
    }
    true
}
