use super::bundle::Bundle;
use super::convex::convexify;
use super::qp::{End, Method, Piece, QuadraticProgram, Row, Step, quadratic_form};
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

/// A step that the model leads to.
#[derive(Clone)]
pub(super) struct Plan {
    /// Where it ends; a variable that ends at a bound is there exactly.
    pub x: Vec<f64>,
    /// Its largest component, in units of the scale.
    pub length: f64,
    /// What the model says f falls by; it may rise where constraints ask for it.
    pub descent: f64,
    /// The norm of the constraints' violations before it, in units of γ.
    pub violation: f64,
    /// What the linearised constraints leave of it.
    pub violation_left: f64,
    /// The multipliers that go with the step.
    pub multipliers: Vec<f64>,
    /// How many sides of a corner hold it; 1 away from corners.
    pub sides: usize,
    /// Whether the linearised constraints could not all be met.
    pub is_relaxed: bool,
    /// Who found its active set.
    pub by: Method,
}

impl Plan {
    /// Whether the trust region kept it from going further.
    pub fn is_limited_by(&self, radius: f64) -> bool {
        let part = if self.is_relaxed { NORMAL_PART } else { 1.0 };
        self.length >= 0.99 * part * radius
    }
}

/// Of the trust region, the part that serves to meet the constraints where they cannot all be met; the rest is left
/// to the objective (Omojokun 1989: 0.8).
const NORMAL_PART: f64 = 0.8;
/// Room for the rounding of what is left, where a relaxed row is met with nothing to spare.
const ROUNDING: f64 = 1e-12;
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
        let d = self.steps_to(&tried.x);
        let value = |j: usize| {
            let slope = self.normal(j).dot(&d) * self.scaling.gamma[j];
            tried.f.constraints[j].value - slope
        };
        self.plan_from(value, program)
    }

    /// The plan with the constraints linearised around these values; `program` is written over.
    fn plan_from(&self, value: impl Fn(usize) -> f64, program: &mut QuadraticProgram) -> Plan {
        self.pose(value, program);
        let (step, is_relaxed) = match program.solve() {
            Some(step) => (step, false),
            None => {
                let (nearest, left) = self.least_violation(program);
                let mut relaxed = program.clone();
                for (row, left) in relaxed.rows.iter_mut().zip(&left) {
                    if row.low == row.high {
                        row.low -= left;
                        row.high = row.low;
                    } else {
                        row.low -= left.max(0.0) + ROUNDING;
                        row.high += (-left).max(0.0) + ROUNDING;
                    }
                }
                (relaxed.solve().unwrap_or(nearest), true)
            }
        };
        let x = self.end_of(&step);
        let d = self.steps_to(&x);
        let left = program.rows.iter().map(|row| {
            let value = row.normal.dot(&d);
            value - value.clamp(row.low, row.high)
        });
        Plan {
            length: step.d.amax(),
            descent: self.descent(program, &d),
            violation: norm(self.scaling.violations(&self.at.f)),
            violation_left: norm(left),
            multipliers: step.multipliers.iter().zip(&self.scaling.gamma).map(|(m, gamma)| m / gamma).collect(),
            sides: step.weights.iter().filter(|weight| **weight > 1e-6).count(),
            by: step.by,
            is_relaxed,
            x,
        }
    }

    /// Poses the program in scaled variables: the point's own piece, those of other sides of corners nearby, and the
    /// constraints linearised around these values.
    fn pose(&self, value: impl Fn(usize) -> f64, program: &mut QuadraticProgram) {
        let Self { scaling, at, radius, .. } = *self;
        program.resize(at.x.len(), at.f.constraints.len());
        convexify(self.hessian, || self.held(), &mut program.curvature);

        let own = &mut program.pieces[0].gradient;
        own.iter_mut().enumerate().for_each(|(i, slope)| *slope = at.f.objective.gradient[i] * scaling.scale[i]);
        program.pieces.extend(self.bundle.pieces(scaling, at, self.hessian));

        let bounds = &scaling.domain.variables;
        let limit = |i: usize, bound: f64| ((bound - at.x[i]) / scaling.scale[i]).clamp(-radius, radius);
        for i in 0..at.x.len() {
            program.low[i] = limit(i, bounds.low[i]);
            program.high[i] = limit(i, bounds.high[i]);
        }
        for (j, row) in program.rows.iter_mut().enumerate() {
            let (limits, gamma) = (&scaling.domain.constraints, scaling.gamma[j]);
            let low = (limits.low[j] - value(j)) / gamma;
            let high = if limits.is_fixed(j) { low } else { (limits.high[j] - value(j)) / gamma };
            row.normal.resize_vertically_mut(at.x.len(), 0.0);
            let slopes = at.f.constraints[j].gradient.iter().zip(&scaling.scale);
            row.normal.iter_mut().zip(slopes).for_each(|(normal, (slope, scale))| *normal = slope * scale / gamma);
            (row.low, row.high) = (low, high);
        }
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
        let stay = || Step {
            d: DVector::zeros(n + m),
            ends: vec![End::Free; n + m],
            weights: vec![1.0],
            multipliers: vec![0.0; m],
            by: Method::Descent,
        };
        let mut step = elastic.solve().unwrap_or_else(stay);
        let squares = |d: &DVector<f64>| 0.5 * d.rows(n, m).norm_squared();
        let before = 0.5 * norm(self.scaling.violations(&self.at.f)).powi(2);
        if let Some(bend) = self.violation_bend()
            && squares(&step.d) + 0.5 * quadratic_form(&bend, &step.d.rows(0, n).into_owned()) > before
        {
            let mut corner = elastic.curvature.view_mut((0, 0), (n, n));
            corner += bend;
            step = elastic.solve().unwrap_or_else(stay);
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

    /// Variables held by a bound that f falls towards the outside of.
    fn held_variables(&self) -> impl Iterator<Item = usize> {
        let Self { scaling, at, multipliers, .. } = *self;
        let is_held =
            move |i: &usize| scaling.is_at_a_bound(at, *i) && scaling.projected_slope(at, multipliers, *i) == 0.0;
        (0..at.x.len()).filter(is_held)
    }

    /// Equations, and constraints with multipliers.
    fn held_rows(&self) -> impl Iterator<Item = usize> {
        let Self { scaling, multipliers, .. } = *self;
        let is_held = move |j: &usize| multipliers[*j] != 0.0 || scaling.domain.constraints.is_fixed(*j);
        (0..multipliers.len()).filter(is_held)
    }

    /// The normals of what holds the point.
    fn held(&self) -> Vec<DVector<f64>> {
        let n = self.at.x.len();
        let unit = |i: usize| DVector::from_fn(n, |k, _| f64::from(k == i));
        let rows = self.held_rows().map(|j| {
            let normal = self.normal(j);
            let length = normal.norm();
            if length > 0.0 { normal / length } else { normal }
        });
        self.held_variables().map(unit).chain(rows).collect()
    }

    /// The point a step ends at.
    fn end_of(&self, step: &Step) -> Vec<f64> {
        let Self { scaling, at, radius, .. } = *self;
        // a bound over the scale, times the scale, may fall short of it by rounding
        let nearly = 1.0 - 4.0 * f64::EPSILON;
        let coordinate = |i: usize| {
            let (low, high) = (scaling.domain.variables.low[i], scaling.domain.variables.high[i]);
            match step.ends[i] {
                End::Low if step.d[i] > -radius && step.d[i] * scaling.scale[i] <= nearly * (low - at.x[i]) => low,
                End::High if step.d[i] < radius && step.d[i] * scaling.scale[i] >= nearly * (high - at.x[i]) => high,
                _ => (at.x[i] + step.d[i] * scaling.scale[i]).clamp(low, high),
            }
        };
        (0..at.x.len()).map(coordinate).collect()
    }

    /// The way to a point, in scaled variables.
    fn steps_to(&self, x: &[f64]) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| (x[i] - self.at.x[i]) / self.scaling.scale[i])
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
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|_| weight != 0.0) {
            sum[(i, j)] += weight * function.hessian[i][j] * scaling.scale[i] * scaling.scale[j];
        }
    }
    true
}
