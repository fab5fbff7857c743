use super::bundle::Bundle;
use super::convex::convexify;
use super::plan::{Around, NORMAL_PART, Plan, Program};
use super::qp::{Piece, QuadraticProgram, Row, Step, quadratic_form};
use super::scaling::{Point, Scaling, norm};
use nalgebra::{DMatrix, DVector};

/// The quadratic model around a point: what a search knows there.
pub(super) struct Model<'a> {
    pub scaling: &'a Scaling,
    pub bundle: &'a Bundle,
    pub at: &'a Point,
    pub multipliers: &'a [f64],
    /// The Hessian of the Lagrangian in scaled variables, exact or the search's own.
    pub hessian: &'a DMatrix<f64>,
    pub radius: f64,
}

/// Weight that keeps the step of least violation short, against the squared violations.
const SHORT: f64 = 1e-8;

impl Model<'_> {
    /// Minimises the model within the bounds, the linearised constraints and the trust region. Where the constraints
    /// contradict each other there, they are relaxed by the least violation that can be reached.
    pub fn plan(&self, program: &mut QuadraticProgram) -> Plan {
        self.plan_from(|j| self.at.f.constraints[j].value, program)
    }

    /// The second-order correction: the plan with the constraints as they turned out at its end, so that their
    /// curvature along the way is made up for (Fletcher 1982).
    pub fn corrected(&self, tried: &Point, program: &mut QuadraticProgram) -> Plan {
        let d = self.around().steps_to(&tried.x);
        let value = |j: usize| {
            let slope = self.normal(j).dot(&d) * self.scaling.gamma[j];
            tried.f.constraints[j].value - slope
        };
        self.plan_from(value, program)
    }

    /// The plan with the constraints linearised around these values; `program` is written over.
    fn plan_from(&self, value: impl Fn(usize) -> f64, program: &mut QuadraticProgram) -> Plan {
        let raise = self.pose(value, program);
        let program = &*program;
        let mut plan = self.around().plan(program, || self.least_violation(program), |d| self.descent(program, d));
        if raise > 0.0 {
            self.correct_multipliers(raise, program, &mut plan);
        }
        plan
    }

    /// Corrects the multipliers for the Hessian that was raised along normals of length 1: that pulls a step back along each of them, in proportion
    /// to the step's part along it, and the multipliers of the rows that hold the step are too small by this.
    fn correct_multipliers(&self, raise: f64, program: &QuadraticProgram, plan: &mut Plan) {
        let d = self.around().steps_to(&plan.x);
        for j in self.scaling.held_rows(self.multipliers) {
            let (normal, is_equation) = (&program.rows[j].normal, self.scaling.domain.constraints.is_fixed(j));
            let (square, before) = (normal.norm_squared(), plan.multipliers[j]);
            if square > 0.0 && (is_equation || before != 0.0) {
                let own = before + raise * normal.dot(&d) / (square * self.scaling.gamma[j]);
                // that of an inequality keeps its sign
                plan.multipliers[j] = if is_equation || own * before > 0.0 { own } else { before };
            }
        }
    }

    fn around(&self) -> Around<'_> {
        Around { scaling: self.scaling, at: self.at, radius: self.radius }
    }

    /// Poses the program in scaled variables: the point's own piece, those of other sides of corners nearby, and the
    /// constraints linearised around these values. Returns what was added to the Hessian along the normals of what holds the point
    /// before its eigenvalues were reflected.
    fn pose(&self, value: impl Fn(usize) -> f64, program: &mut QuadraticProgram) -> f64 {
        let around = self.around();
        let Self { scaling, at, .. } = *self;
        program.resize(at.x.len(), at.f.constraints.len());
        let raise = convexify(self.hessian, || self.held(), &mut program.curvature);

        let own = &mut program.pieces[0].gradient;
        own.iter_mut().enumerate().for_each(|(i, slope)| *slope = at.f.objective.gradient[i] * scaling.scale[i]);
        program.pieces.extend(self.bundle.pieces(scaling, at, self.hessian));

        for i in 0..at.x.len() {
            (program.low[i], program.high[i]) = around.ends(i);
        }
        for (j, row) in program.rows.iter_mut().enumerate() {
            let gamma = scaling.gamma[j];
            row.normal.resize_vertically_mut(at.x.len(), 0.0);
            let slopes = at.f.constraints[j].gradient.iter().zip(&scaling.scale);
            row.normal.iter_mut().zip(slopes).for_each(|(normal, (slope, scale))| *normal = slope * scale / gamma);
            (row.low, row.high) = around.row_limits(j, value(j));
        }
        raise
    }

    /// The step of least squared violation in the normal part of the trust region, and what it leaves of each row: what
    /// is missing > 0, what is too much < 0. Where to second order that step would raise the violation (from wall to wall of a
    /// narrow valley, say), the constraints' curvature is taken in.
    fn least_violation(&self, program: &QuadraticProgram) -> (Step, Vec<f64>) {
        let (n, m) = (program.low.len(), program.rows.len());
        let reach = NORMAL_PART * self.radius;
        let wide = |j: usize| {
            let row = &program.rows[j];
            let mut normal = row.normal.clone().resize_vertically(n + m, 0.0);
            normal[n + j] = 1.0;
            Row { normal, ..*row }
        };
        let far = |row: &Row| row.low.max(0.0).max(-row.high.min(0.0)) + row.normal.abs().sum() * reach + 1.0;
        let farthest = program.rows.iter().map(far).fold(1.0, f64::max);
        let mut elastic = QuadraticProgram {
            curvature: DMatrix::from_fn(n + m, n + m, |i, j| match i {
                _ if i != j => 0.0,
                i if i < n => SHORT,
                _ => 1.0,
            }),
            pieces: vec![Piece { offset: 0.0, gradient: DVector::zeros(n + m) }],
            low: DVector::from_fn(n + m, |i, _| if i < n { program.low[i].max(-reach) } else { -farthest }),
            high: DVector::from_fn(n + m, |i, _| if i < n { program.high[i].min(reach) } else { farthest }),
            rows: (0..m).map(wide).collect(),
        };
        let mut step = elastic.solve().unwrap_or_else(|| Step::none(n + m, m));
        let squares = |d: &DVector<f64>| 0.5 * d.rows(n, m).norm_squared();
        let before = 0.5 * norm(self.scaling.violations(&self.at.f)).powi(2);
        if let Some(bend) = self.violation_bend()
            && squares(&step.d) + 0.5 * quadratic_form(&bend, &step.d.rows(0, n).into_owned()) > before
        {
            let mut corner = elastic.curvature.view_mut((0, 0), (n, n));
            corner += bend;
            step = elastic.solve().unwrap_or_else(|| Step::none(n + m, m));
        }
        step.d = step.d.rows(0, n).into_owned();
        step.ends.truncate(n);
        let left = program.rows.iter().map(|row| {
            let value = row.normal.dot(&step.d);
            value.clamp(row.low, row.high) - value
        });
        let left = left.collect();
        (step, left)
    }

    /// What the curvature of violated constraints adds to the Hessian of ½‖v‖² (in scaled variables), as far as it is positive;
    /// `None` where a constraint gives no Hessian, and where nothing is added.
    fn violation_bend(&self) -> Option<DMatrix<f64>> {
        let Self { scaling, at, .. } = *self;
        let n = at.x.len();
        let mut sum = DMatrix::zeros(n, n);
        for (j, violation) in scaling.violations(&at.f).enumerate().filter(|(_, violation)| *violation != 0.0) {
            let hessian = &at.f.constraints[j].hessian;
            if hessian.is_empty() {
                return None;
            }
            let weight = violation / scaling.gamma[j];
            sum += DMatrix::from_fn(n, n, |i, k| weight * hessian[i][k] * scaling.scale[i] * scaling.scale[k]);
        }
        if sum.iter().all(|entry| *entry == 0.0) {
            return None;
        }
        let eigen = sum.symmetric_eigen();
        let raised = DMatrix::from_diagonal(&eigen.eigenvalues.map(|value| value.max(0.0)));
        Some(&eigen.eigenvectors * raised * eigen.eigenvectors.transpose())
    }

    /// The gradient of a constraint, in scaled variables and units of γ.
    fn normal(&self, j: usize) -> DVector<f64> {
        let gradient = &self.at.f.constraints[j].gradient;
        DVector::from_fn(gradient.len(), |i, _| gradient[i] * self.scaling.scale[i] / self.scaling.gamma[j])
    }

    /// The normals of what holds the point: of bounds that f falls towards the outside of, of equations, and of constraints with
    /// multipliers.
    fn held(&self) -> Vec<DVector<f64>> {
        let Self { scaling, at, multipliers, .. } = *self;
        let n = at.x.len();
        let unit = |i: usize| DVector::from_fn(n, |k, _| f64::from(k == i));
        let rows = scaling.held_rows(multipliers).map(|j| {
            let normal = self.normal(j);
            let length = normal.norm();
            if length > 0.0 { normal / length } else { normal }
        });
        scaling.held_variables(at, multipliers).map(unit).chain(rows).collect()
    }

    /// What the model says f falls by. With the true Hessian where there is one piece: it promises at least as much as
    /// the convex stand-in, whose raised curvature along the constraints' normals is none of f's.
    fn descent(&self, program: &QuadraticProgram, d: &DVector<f64>) -> f64 {
        if program.pieces.len() > 1 {
            return -program.value(d);
        }
        -(program.pieces[0].gradient.dot(d) + 0.5 * quadratic_form(self.hessian, d))
    }
}

impl Program for QuadraticProgram {
    fn solve(&self) -> Option<Step> {
        Self::solve(self)
    }

    fn limits(&mut self) -> impl Iterator<Item = (&mut f64, &mut f64)> {
        self.rows.iter_mut().map(|row| (&mut row.low, &mut row.high))
    }

    fn left_over(&self, d: &DVector<f64>) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| {
            let value = row.normal.dot(d);
            value - value.clamp(row.low, row.high)
        })
    }
}

/// The Hessian of the Lagrangian in scaled variables, if every function gives its own.
pub(super) fn lagrangian_hessian(scaling: &Scaling, at: &Point, multipliers: &[f64]) -> Option<DMatrix<f64>> {
    let mut sum = DMatrix::default();
    sum_hessians(scaling, at, multipliers, &mut sum).then_some(sum)
}

/// As [`lagrangian_hessian`], written over a matrix; whether there is one.
pub(super) fn sum_hessians(scaling: &Scaling, at: &Point, multipliers: &[f64], sum: &mut DMatrix<f64>) -> bool {
    let n = at.x.len();
    if sum.nrows() != n {
        *sum = DMatrix::zeros(n, n);
    }
    sum.fill(0.0);
    let functions =
        std::iter::once((&at.f.objective, 1.0)).chain(at.f.constraints.iter().zip(multipliers.iter().copied()));
    for (function, weight) in functions {
        if function.hessian.is_empty() {
            return false;
        }
        if weight == 0.0 {
            continue;
        }
        // the matrix is symmetric: its columns are the rows
        for (column, row) in sum.as_mut_slice().chunks_exact_mut(n).zip(&function.hessian) {
            column.iter_mut().zip(row).for_each(|(sum, bend)| *sum += weight * bend);
        }
    }
    for (column, own) in sum.as_mut_slice().chunks_exact_mut(n).zip(&scaling.scale) {
        column.iter_mut().zip(&scaling.scale).for_each(|(entry, scale)| *entry *= scale * own);
    }
    true
}
